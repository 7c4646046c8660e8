use super::*;
use crate::braking::Braking;
use crate::circles::{Circles, SlipRadius};
use crate::contact::{Contact, ContactParams, PeakRule, WongReece};
use crate::forces::{Lambda, PeakDepth};
use crate::pressure_sinkage::{Direct, PressureCurve, PressureSinkage, SinkageExponent};
use crate::rolling::WheelOnSoil;
use crate::shear::{JanosiHanamoto, ShearLaw, WongPeak, WongResidual};
use crate::slip::Slip;
use crate::soil::{Soil, SoilParams};
use crate::wheel::{Wheel, WheelParams};

const EXACT: Method = Method::Explicit { peak_depth: PeakDepth::Geometric, lambda_a: Lambda::Exact, lambda_b: Lambda::Exact };
const METHODS: [Method; 4] = [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT, EXACT];

/// Wheels with and without lugs, soils by every shear law, contacts by every rule for the peak.
fn systems() -> Vec<WheelOnSoil> {
    let laws = [
        ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.012 }),
        ShearLaw::WongResidual(WongResidual { residual_ratio: 0.6, peak_displacement: 0.02 }),
        ShearLaw::WongPeak(WongPeak { peak_displacement: 0.03 }),
    ];
    let rules = [PeakRule::Midpoint, PeakRule::WongReece(WongReece { c1: 0.4, c2: 0.2 }), PeakRule::HalfSinkage];
    let mut systems = Vec::new();
    for (i, law) in laws.into_iter().enumerate() {
        for (k, rule) in rules.into_iter().enumerate() {
            let lug_height = if i == k { 0.0 } else { 0.015 };
            let exponent = SinkageExponent { base: 0.7 + 0.2 * k as f64, slip_gain: 0.1, skid_gain: None };
            systems.push(WheelOnSoil {
                wheel: Wheel::new(WheelParams { radius: 0.18, width: 0.12, lug_height, lug_coefficient: 0.5 }).expect("a wheel"),
                soil: Soil::new(SoilParams {
                    cohesion: 200.0 * i as f64,
                    friction_angle: 0.5,
                    shear: Some(law),
                    pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 6e5, exponent })),
                    ..SoilParams::BARE
                })
                .expect("a soil"),
                contact: Contact::new(ContactParams {
                    rule,
                    circles: Circles { slip: SlipRadius::Rim, ..Circles::SHEARING },
                    ..ContactParams::MIDPOINT
                })
                .expect("a contact"),
            });
        }
    }
    systems
}

/// The same, braking in one zone and in two.
fn braking_systems() -> Vec<WheelOnSoil> {
    let braking = |braking| move |system: WheelOnSoil| WheelOnSoil { contact: system.contact.with_braking(braking), ..system };
    let [one, two] = [Braking::OneZone, Braking::TwoZone].map(|law| systems().into_iter().map(braking(law)));
    one.chain(two).collect()
}

#[test]
fn the_slopes_are_those_of_the_forces() {
    const STEP: f64 = 1e-5;
    const DIFFERENCE: f64 = 1e-7; // a central difference of that step errs by about its square
    let mut compared = 0;
    for (system, method) in braking_systems().iter().flat_map(|system| METHODS.map(|method| (system, method))) {
        let model = ForceModel::at_rim(method);
        let driving = [(0.0, 1e-4), (0.1, 0.004), (0.4, 0.02), (1.0, 0.09)];
        let braking = [(-0.01, 0.004), (-0.05, 0.03), (-0.2, 0.09), (-0.9, 0.17)];
        for (ratio, sinkage) in driving.into_iter().chain(braking) {
            let rolling = system.rolling(Slip::new(ratio).expect("a slip")).expect("a rolling wheel");
            if !model.has_slopes(&rolling) || sinkage * (1.0 - STEP) <= rolling.sinkages().0 {
                continue;
            }
            compared += 1;
            let at = |z: f64| model.forces(&rolling.contact(z).expect("a contact")).expect("forces");
            let slopes = model.forces_and_slopes(&rolling, sinkage, false);
            let (_, slopes) = slopes.unwrap_or_else(|| panic!("{system:?} {ratio} {sinkage} {:?}", at(sinkage)));
            let (below, above) = (at(sinkage * (-STEP).exp()), at(sinkage * STEP.exp()));
            for (slope, part) in [
                (slopes.components.traction, (|f| f.components.traction) as fn(&Forces) -> f64),
                (slopes.components.resistance, |f| f.components.resistance),
                (slopes.components.normal_support, |f| f.components.normal_support),
                (slopes.components.shear_support, |f| f.components.shear_support),
                (slopes.torque, |f| f.torque),
            ] {
                let difference = (part(&above) - part(&below)) / (2.0 * STEP);
                let scale = part(&above).abs().max(difference.abs());
                assert!((slope - difference).abs() <= DIFFERENCE * scale, "{method:?} {ratio} {sinkage}: {slope} {difference}");
            }
        }
    }
    assert!(compared > 400, "{compared}");
}

#[test]
fn the_approach_ends_where_the_bracket_does() {
    const SOLVED: f64 = 1e-12;
    for (system, method) in systems().iter().flat_map(|system| METHODS.map(|method| (system, method))) {
        let model = ForceModel::at_rim(method);
        for (ratio, load) in [(0.0, 1.0), (0.0, 80.0), (0.3, 5.0), (0.3, 300.0), (0.95, 60.0)] {
            let rolling = system.rolling(Slip::new(ratio).expect("a slip")).expect("a rolling wheel");
            let bracketed = model.solve_sinkage_in_bracket(&rolling, load, rolling.curve().expect("a curve")).expect("a balance");
            for (factor, close) in [(0.4, false), (1.0, false), (2.5, false), (1.0 + 1e-4, true)] {
                let found = model.approach(&rolling, load, factor * bracketed.sinkage, close);
                let found = found.unwrap_or_else(|| panic!("{system:?} {ratio} {load} {factor} {bracketed:?}"));
                assert!((found.sinkage / bracketed.sinkage - 1.0).abs() <= SOLVED, "{method:?} {found:?} {bracketed:?}");
                let (forces, expected) = (&found.forces, &bracketed.forces);
                assert!((forces.longitudinal - expected.longitudinal).abs() <= SOLVED * expected.longitudinal_scale());
                assert!((forces.torque / expected.torque - 1.0).abs() <= SOLVED);
                assert!(found.residual.abs() <= SOLVED * load);
            }
        }
    }
}

#[test]
fn under_a_braking_wheel_the_approach_ends_where_the_bracket_does() {
    const SOLVED: f64 = 1e-11; // the bracket's own end, where F_z is flat
    let (mut found, mut balances) = (0, 0);
    for (system, method) in braking_systems().iter().flat_map(|system| METHODS.map(|method| (system, method))) {
        let model = ForceModel::at_rim(method);
        for ratio in [-1e-6, -1e-3, -0.01, -0.05, -0.2, -0.5, -0.95] {
            let rolling = system.rolling(Slip::new(ratio).expect("a slip")).expect("a rolling wheel");
            let curve = rolling.curve().expect("a curve");
            for load in [1.0, 20.0, 80.0, 300.0, 2000.0] {
                let Ok(bracketed) = model.solve_sinkage_in_bracket(&rolling, load, curve) else { continue };
                balances += 1;
                let estimate = bekker_estimate(&system.wheel, curve, load);
                for (guess, close) in [(estimate, false), (bracketed.sinkage * (1.0 + 1e-4), true)] {
                    let Some(approached) = model.approach(&rolling, load, guess, close) else { continue };
                    found += 1;
                    let same = (approached.sinkage / bracketed.sinkage - 1.0).abs() <= SOLVED;
                    assert!(same, "{method:?} {ratio} {load} {approached:?} {bracketed:?}");
                    let (forces, expected) = (&approached.forces, &bracketed.forces);
                    assert!((forces.longitudinal - expected.longitudinal).abs() <= SOLVED * expected.longitudinal_scale());
                    assert!((forces.normal - load).abs() <= SOLVED * expected.normal_scale());
                }
            }
        }
    }
    assert!(balances > 1000 && f64::from(found) > 1.8 * f64::from(balances), "{found} of {balances}");
}

/// Over wheels and soils of all sizes, many of which have no balance or several.
#[test]
fn no_approach_ends_elsewhere() {
    const SOLVED: f64 = 1e-9; // next to where F_z is largest the bracket ends with half of its digits
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut unit = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut found, mut balances) = (0, 0);
    for _ in 0..4000 {
        let mut over = |least: f64, most: f64| least * (most / least).powf(unit());
        let radius = over(0.05, 1.0);
        let (modulus, width, k_s, base) = (over(1e-4, 0.1), over(0.02, 0.5), over(1e4, 1e7), over(0.3, 2.0));
        let (cohesion, load, skid, lug) = (over(1.0, 1e5), over(1.0, 1e4), over(1e-4, 0.99), over(1e-3, 0.3));
        let exponent = SinkageExponent { base, slip_gain: 0.0, skid_gain: None };
        let law = match (unit() * 3.0) as u32 {
            0 => ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus }),
            1 => ShearLaw::WongResidual(WongResidual { residual_ratio: 0.5, peak_displacement: modulus }),
            _ => ShearLaw::WongPeak(WongPeak { peak_displacement: modulus }),
        };
        let braking = if unit() < 0.5 { Braking::OneZone } else { Braking::TwoZone };
        let lug_height = if unit() < 0.5 { 0.0 } else { lug * radius };
        let system = WheelOnSoil {
            wheel: Wheel::new(WheelParams { radius, width, lug_height, lug_coefficient: 0.5 }).expect("a wheel"),
            soil: Soil::new(SoilParams {
                cohesion,
                friction_angle: 0.1 + 0.6 * unit(),
                shear: Some(law),
                pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s, exponent })),
                ..SoilParams::BARE
            })
            .expect("a soil"),
            contact: Contact::MIDPOINT.with_braking(braking),
        };
        let method = METHODS[(unit() * 4.0) as usize];
        let model = ForceModel::at_rim(method);
        let rolling = system.rolling(Slip::new(-skid).expect("a slip")).expect("a rolling wheel");
        let curve = rolling.curve().expect("a curve");
        let bracketed = model.solve_sinkage_in_bracket(&rolling, load, curve);
        let approached = model.approach(&rolling, load, bekker_estimate(&system.wheel, curve, load), false);
        balances += u32::from(bracketed.is_ok());
        if let Some(approached) = approached {
            found += 1;
            let bracketed = bracketed.unwrap_or_else(|error| panic!("{system:?} {method:?} {skid} {load} {error}"));
            let same = (approached.sinkage / bracketed.sinkage - 1.0).abs() <= SOLVED;
            assert!(same, "{system:?} {method:?} {skid} {load} {approached:?} {bracketed:?}");
        }
    }
    assert!(found > 1000 && balances > found, "{found} of {balances}");
}

#[test]
fn in_grains_the_approach_ends_where_the_bracket_does_at_any_slip() {
    const SOLVED: f64 = 1e-12;
    let wheel = WheelParams { radius: 0.18, width: 0.12, lug_height: 0.01, lug_coefficient: 0.5 };
    let system = WheelOnSoil {
        wheel: Wheel::new(wheel).expect("a wheel"),
        soil: Soil::new(SoilParams { granular_stiffness: Some(2e6), ..SoilParams::BARE }).expect("a soil"),
        contact: Contact::MIDPOINT.with_circles(Circles { slip: SlipRadius::LugTip, ..Circles::SHEARING }),
    };
    let model = ForceModel::at_rim(Method::ResistiveForce);
    for ratio in [-1.0, -0.6, -0.05, 0.0, 1e-9, 0.02, 0.3, 1.0] {
        let rolling = system.rolling_in_grains(Slip::new(ratio).expect("a slip"));
        for load in [1e-3, 1.0, 80.0, 900.0] {
            let curve = PressureCurve { modulus: 8e5, exponent: 1.0 };
            let bracketed = model.solve_sinkage_in_bracket(&rolling, load, &curve).expect("a balance");
            for (factor, close) in [(0.4, false), (2.5, false), (1.0 + 1e-4, true)] {
                let found = model.approach(&rolling, load, factor * bracketed.sinkage, close).expect("a way");
                assert!((found.sinkage / bracketed.sinkage - 1.0).abs() <= SOLVED, "{ratio} {found:?} {bracketed:?}");
                let (forces, expected) = (&found.forces, &bracketed.forces);
                assert!((forces.longitudinal - expected.longitudinal).abs() <= SOLVED * expected.longitudinal_scale());
                assert!((forces.torque - expected.torque).abs() <= SOLVED * expected.normal * wheel.radius);
            }
        }
    }
}
