//! The results are the same on every machine that has the same library of elementary functions, to the last bit: whatever holds at
//! one level of lanes holds at all of them.

use crate::circles::{Circles, SlipRadius};
use crate::contact::Contact;
use crate::forces::{ForceModel, Method};
use crate::numerics::level::held;
use crate::operating_point::{KnownSinkage, Sinkage};
use crate::operation::Operation;
use crate::pressure_sinkage::{Direct, PressureSinkage, SinkageExponent};
use crate::rolling::WheelOnSoil;
use crate::shear::{JanosiHanamoto, ShearLaw, WongPeak, WongResidual};
use crate::slip::Slip;
use crate::soil::{Soil, SoilParams};
use crate::sweep::SlipSweep;
use crate::wheel::{Wheel, WheelParams};
use fearless_simd::Level;

/// The levels of lanes that this machine has.
fn levels() -> Vec<Level> {
    #[cfg_attr(not(target_arch = "x86_64"), expect(unused_mut, reason = "other machines have one level"))]
    let mut levels = vec![Level::new()];
    #[cfg(target_arch = "x86_64")]
    {
        let best = Level::new();
        levels.extend(best.as_sse2().map(Level::Sse2));
        levels.extend(best.as_sse4_2().map(Level::Sse4_2));
        levels.extend(best.as_avx2().map(Level::Avx2));
    }
    levels
}

/// A wheel with lugs on cohesive soil that shears by `law`, with a stiffness for its grains.
fn system(law: ShearLaw, slip_gain: f64) -> WheelOnSoil {
    let exponent = SinkageExponent { base: 0.83, slip_gain, skid_gain: None };
    let soil = SoilParams {
        cohesion: 300.0,
        friction_angle: 0.478,
        shear: Some(law),
        pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 7e5, exponent })),
        granular_stiffness: Some(2e6),
        ..SoilParams::BARE
    };
    WheelOnSoil {
        wheel: Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.01, lug_coefficient: 0.5 }).expect("a wheel"),
        soil: Soil::new(soil).expect("a soil"),
        contact: Contact::MIDPOINT.with_circles(Circles { slip: SlipRadius::LugTip, ..Circles::SHEARING }),
    }
}

#[test]
fn every_level_of_lanes_gives_the_same_bits() {
    let laws = [
        ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.011 }),
        ShearLaw::WongResidual(WongResidual { residual_ratio: 0.6, peak_displacement: 0.02 }),
        ShearLaw::WongPeak(WongPeak { peak_displacement: 0.03 }),
    ];
    let methods = [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT, Method::ResistiveForce];
    let sinkages = [
        Sinkage::Given(1e-6),
        Sinkage::Given(0.03),
        Sinkage::UnderLoad { sinkage: KnownSinkage::Given(0.03), load: 200.0 },
        Sinkage::CarryingLoad(90.0),
    ];
    let slips: Vec<Slip> = (0..=60).map(|i| Slip::new(-0.5 + 0.025 * f64::from(i)).expect("a slip")).collect();
    let mut points = 0;
    for (i, law) in laws.into_iter().enumerate() {
        let system = system(law, 0.1 * i as f64);
        for (method, sinkage) in methods.iter().flat_map(|&method| sinkages.map(|sinkage| (method, sinkage))) {
            let operation = Operation { system, model: ForceModel::at_rim(method), sinkage };
            // Written out, so that numbers are compared and not their values: 0 is not −0.
            let found = |level: Level| held::to(level, || format!("{:?}", SlipSweep::of(&operation, &slips).rows));
            let alone = |level: Level| held::to(level, || format!("{:?}", operation.at(slips[24])));
            let best = (found(Level::new()), alone(Level::new()));
            for level in levels() {
                assert!((found(level), alone(level)) == best, "{operation:?} at {level:?}");
            }
            points += best.0.matches("Ok(").count();
        }
    }
    assert!(points > 2000, "only {points} points");
}
