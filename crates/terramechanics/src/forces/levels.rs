//! The integrals are the same on every machine, to the last bit.

use crate::contact::{AngleRates, Contact};
use crate::forces::quadrature::OneZone;
use crate::forces::shearing::Rim;
use crate::numerics::gauss_legendre::FINE;
use crate::pressure_sinkage::{Direct, PressureSinkage, SinkageExponent};
use crate::rolling::WheelOnSoil;
use crate::shear::{JanosiHanamoto, ShearLaw};
use crate::slip::Slip;
use crate::soil::{Soil, SoilParams};
use crate::wheel::{Wheel, WheelParams};
use fearless_simd::{Level, dispatch};

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

#[test]
fn every_level_of_lanes_gives_the_same_bits() {
    let exponent = SinkageExponent { base: 0.83, slip_gain: 0.2, skid_gain: None };
    let system = WheelOnSoil {
        wheel: Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.01, lug_coefficient: 0.5 }).expect("a wheel"),
        soil: Soil::new(SoilParams {
            cohesion: 300.0,
            friction_angle: 0.478,
            shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.011 })),
            pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 7e5, exponent })),
            ..SoilParams::BARE
        })
        .expect("a soil"),
        contact: Contact::MIDPOINT,
    };
    for i in 0..1000 {
        let (ratio, sinkage) = (-0.3 + 1.3 * f64::from(i) / 999.0, 1e-6 + 1.7e-4 * f64::from(i));
        let rolling = system.rolling(Slip::new(ratio).expect("a slip")).expect("a rolling wheel");
        let patch = rolling.contact(sinkage).expect("a contact");
        let rim = Rim::of(&patch.stresses().expect("stresses"));
        let of = |level: Level| {
            let rates = &AngleRates { peak: 0.5, exit: 0.0 };
            let (sums, changes) = dispatch!(level, simd => {
                rim.sums_and_changes::<_, _, _, true>(simd, &FINE, &OneZone(&patch), [0.0, 1.0], rates)
            });
            let all =
                [sums.integrals, changes].map(|of| [of.normal_cos, of.normal_sin, of.shear_cos, of.shear_sin, of.shear_plain]);
            all.map(|values| values.map(f64::to_bits))
        };
        let best = of(Level::new());
        assert!(levels().into_iter().all(|level| of(level) == best), "{ratio} {sinkage}");
    }
}
