//! Bekker's resistances and thrust: worked example, reference values, identities, limits.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, cases, letter, slip, system, system_of};
use proptest::prelude::*;
use serde_json::Value;
use terramechanics::{
    Bekker, Contact, Direct, Error, JanosiHanamoto, Lacking, PressureSinkage, Resistances, ShearLaw, SinkageExponent, SoilParams,
    WheelOnSoil, WheelParams, WongPeak,
};

/// Some tens of roundings.
const ROUNDING: f64 = 1e-12;

const REFERENCE: &str = include_str!("reference/resistances.json");

/// The wheel of the lunar roving vehicle and its soil, as printed in course material (Akin, University of Maryland).
const LUNAR_WHEEL: WheelParams = WheelParams { radius: 0.4065, width: 0.229, lug_height: 0.0, lug_coefficient: 0.5 };
const LUNAR_SOIL: SoilParams = SoilParams {
    cohesion: 170.0,
    friction_angle: 0.576,
    shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.0178 })),
    pressure_sinkage: Some(PressureSinkage::Bekker(Bekker { k_c: 1400.0, k_phi: 820_000.0, exponent: exponent(1.0) })),
    unit_weight: Some(2472.0),
    ..SoilParams::BARE
};
const LUNAR_LOAD: f64 = 259.0;

const fn exponent(base: f64) -> SinkageExponent {
    SinkageExponent { base, slip_gain: 0.0, skid_gain: None }
}

fn lunar() -> WheelOnSoil {
    system(LUNAR_WHEEL, LUNAR_SOIL, Contact::MIDPOINT)
}

fn of_direct(wheel: WheelParams, k_s: f64, base: f64) -> WheelOnSoil {
    let pressure_sinkage = PressureSinkage::Direct(Direct { k_s, exponent: exponent(base) });
    system(wheel, SoilParams { pressure_sinkage: Some(pressure_sinkage), ..LUNAR_SOIL }, Contact::MIDPOINT)
}

fn estimates(system: &WheelOnSoil, load: f64, ratio: f64) -> Resistances {
    Resistances::of(system, load, Some(slip(ratio))).expect("estimates")
}

/// 17.31 mm and 28.34 N follow from the formulas; 28.3 N is printed too, and 95 N of bulldozing per leading wheel.
#[test]
fn the_lunar_roving_vehicle_is_the_worked_example() {
    let found = Resistances::of(&lunar(), LUNAR_LOAD, None).expect("estimates");
    assert!((found.rigid_wheel_sinkage.expect("a sinkage") - 0.01731).abs() < 5e-6);
    let compaction = found.compaction.expect("a resistance");
    assert!((compaction - 28.34).abs() < 5e-3 && (compaction - 28.3).abs() < 0.05);
    // The printed angle of approach, 0.2999 rad, is that of 18.14 mm, to which 277.9 N belong.
    let deeper = Resistances::of(&lunar(), LUNAR_LOAD * (0.018_144_f64 / 0.017_310_66).powf(1.5), None).expect("estimates");
    let approach = (1.0 - deeper.rigid_wheel_sinkage.expect("a sinkage") / 0.4065).acos();
    assert!((approach - 0.2999).abs() < 5e-5);
    let bulldozing = deeper.bulldozing.expect("a resistance");
    assert!((bulldozing - 95.0).abs() < 1.0, "{bulldozing}: what is printed was rounded on the way");
    assert!(found.bulldozing.expect("a resistance") < bulldozing);
}

#[test]
fn sixty_cases_of_another_program_come_back() {
    let cases = cases(REFERENCE);
    assert_eq!(cases.len(), 60);
    let mut compared = 0;
    for (i, case) in cases.iter().enumerate() {
        let input = &case["input"];
        let load = input["normal_load_n"].as_f64().expect("a load");
        let found = Resistances::of(&system_of(input), load, input["slip"].as_f64().map(slip)).expect("estimates");
        for (name, estimate) in [
            ("rigid_wheel_sinkage_m", found.rigid_wheel_sinkage),
            ("compaction_resistance_n", found.compaction),
            ("bulldozing_resistance_n", found.bulldozing),
            ("thrust_n", found.thrust),
        ] {
            match (&case["expected"][name], estimate) {
                (Value::Null, estimate) => assert!(estimate.is_err(), "case {i}: {name}"),
                (expected, estimate) => {
                    let off = estimate.expect("an estimate") / expected.as_f64().expect("a number") - 1.0;
                    assert!(off.abs() < ROUNDING, "case {i}: {name} off by {off:e}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 200, "only {compared} numbers were compared");
}

proptest! {
    /// The resistance is the work that presses a rut of the wheel's width: b K_s z^(n+1)/(n+1). It grows with the load, as
    /// the power (2n + 2)/(2n + 1).
    #[test]
    fn compaction_is_the_work_of_pressing_the_rut(base in 0.2..2.5, log_k_s in 4.5..7.0, load in 0.1..50.0, more in 1.01..3.0) {
        let k_s = 10f64.powf(log_k_s);
        let system = of_direct(LUNAR_WHEEL, k_s, base);
        let at = |load: f64| Resistances::of(&system, load, None).map(|found| {
            (found.rigid_wheel_sinkage.expect("a sinkage"), found.compaction.expect("a resistance"))
        });
        let (Ok((sinkage, compaction)), Ok((_, larger))) = (at(load), at(more * load)) else { return Ok(()) }; // too soft
        prop_assert!((compaction / (0.229 * k_s * sinkage.powf(base + 1.0) / (base + 1.0)) - 1.0).abs() < ROUNDING);
        prop_assert!((larger / compaction / f64::powf(more, (2.0 * base + 2.0) / (2.0 * base + 1.0)) - 1.0).abs() < ROUNDING);
    }

    /// Lugs only add, and no lugs is the limit of small ones; a thrust grows with slip and stays below the strength.
    #[test]
    fn thrust_grows_with_lugs_and_with_slip(height in 1e-4..0.1, ratio in 1e-6..0.99, load in 1.0..300.0) {
        let with_lugs = |lug_height| system(WheelParams { lug_height, ..LUNAR_WHEEL }, LUNAR_SOIL, Contact::MIDPOINT);
        let thrust = |lug_height, ratio| estimates(&with_lugs(lug_height), load, ratio).thrust.expect("a thrust");
        prop_assert!(thrust(height, ratio) > thrust(0.0, ratio));
        prop_assert!(thrust(height, ratio * 1.01) > thrust(height, ratio));
        prop_assert!((thrust(1e-12, ratio) / thrust(0.0, ratio) - 1.0).abs() < 1e-10);
    }

    /// Deeper, heavier and more cohesive soil is harder to push.
    #[test]
    fn bulldozing_grows_with_load_weight_and_cohesion(load in 1.0..500.0, unit_weight in 100.0..20_000.0, cohesion in 0.0..5_000.0) {
        let bulldozing = |load: f64, unit_weight: f64, cohesion: f64| {
            let soil = SoilParams { unit_weight: Some(unit_weight), cohesion, ..LUNAR_SOIL };
            let found = Resistances::of(&system(LUNAR_WHEEL, soil, Contact::MIDPOINT), load, None).expect("estimates");
            found.bulldozing.expect("a resistance")
        };
        let here = bulldozing(load, unit_weight, cohesion);
        prop_assert!(here > 0.0);
        prop_assert!(bulldozing(1.1 * load, unit_weight, cohesion) > here);
        prop_assert!(bulldozing(load, 1.1 * unit_weight, cohesion) > here);
        prop_assert!(bulldozing(load, unit_weight, cohesion + 10.0) > here);
        // Weight and cohesion act side by side: without either there is nothing left.
        let parts = bulldozing(load, unit_weight, 0.0) + bulldozing(load, 1e-300, cohesion);
        prop_assert!((parts / here - 1.0).abs() < ROUNDING);
    }
}

/// On the parabola x² = D (z − depth) the upright pressure K_s depth^n carries b K_s √D z^(n + 1/2) I(n) with
/// I = ∫(1 − u²)^n du over 0…1, known in closed form at halves: (3 − n)/3 is exact at 0 and 1 and otherwise as near as stated.
#[test]
fn the_load_of_the_rigid_wheel_is_that_of_plates_along_a_parabola() {
    use std::f64::consts::PI;
    for (base, integral, least, most) in [
        (1e-9, 1.0, 1.0 - 1e-8, 1.0 + 1e-8),
        (0.5, PI / 4.0, 1.055, 1.065),
        (1.0, 2.0 / 3.0, 1.0 - ROUNDING, 1.0 + ROUNDING),
        (1.5, 3.0 * PI / 16.0, 0.845, 0.855),
    ] {
        let (k_s, load) = (1e6, 1.0);
        let found = Resistances::of(&of_direct(LUNAR_WHEEL, k_s, base), load, None).expect("estimates");
        let sinkage = found.rigid_wheel_sinkage.expect("a sinkage");
        let carried = 0.229 * k_s * 0.813_f64.sqrt() * sinkage.powf(base + 0.5) * integral;
        assert!((least..=most).contains(&(load / carried)), "n = {base}: {}", load / carried);
    }
}

#[test]
fn thrust_has_the_strength_of_the_soil_as_its_limit_and_starts_at_nothing() {
    let stiff = SoilParams { shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 1e-12 })), ..LUNAR_SOIL };
    let stiff = system(LUNAR_WHEEL, stiff, Contact::MIDPOINT);
    let found = estimates(&stiff, LUNAR_LOAD, 1.0);
    let length = 0.4065 * (1.0 - found.rigid_wheel_sinkage.expect("a sinkage") / 0.4065).acos();
    let strength = 0.229 * length * 170.0 + LUNAR_LOAD * 0.576_f64.tan();
    assert!((found.thrust.expect("a thrust") / strength - 1.0).abs() < 1e-10);
    // At small slip half of s l/K of the strength is mobilised.
    let little = estimates(&lunar(), LUNAR_LOAD, 1e-9).thrust.expect("a thrust");
    assert!((little / (strength * 0.5e-9 * length / 0.0178) - 1.0).abs() < 1e-8);
}

#[test]
fn what_is_lacking_is_said_and_the_rest_is_found() {
    let nothing_said = Resistances::of(&letter(), 80.0, None).expect("estimates");
    assert!(nothing_said.rigid_wheel_sinkage.is_ok() && nothing_said.compaction.is_ok());
    assert_eq!((nothing_said.bulldozing, nothing_said.thrust), (Err(Lacking::UnitWeight), Err(Lacking::DrivingSlip)));
    for ratio in [0.0, -0.3, -1.0] {
        assert_eq!(estimates(&lunar(), LUNAR_LOAD, ratio).thrust, Err(Lacking::DrivingSlip));
    }
    let peak = SoilParams { shear: Some(ShearLaw::WongPeak(WongPeak { peak_displacement: 0.02 })), ..LUNAR_SOIL };
    let humped = estimates(&system(LUNAR_WHEEL, peak, Contact::MIDPOINT), LUNAR_LOAD, 0.2);
    assert_eq!(humped.thrust, Err(Lacking::JanosiHanamoto));
    assert!(humped.bulldozing.is_ok());
    let steep = Resistances::of(&of_direct(LUNAR_WHEEL, 1e6, 3.0), LUNAR_LOAD, Some(slip(0.2))).expect("estimates");
    let lacking = Err(Lacking::ExponentBelowThree { exponent: 3.0 });
    assert_eq!([steep.rigid_wheel_sinkage, steep.compaction, steep.bulldozing, steep.thrust], [lacking; 4]);
}

#[test]
fn deep_ruts_and_slip_gains_are_cautioned() {
    let codes = |system: &WheelOnSoil, load: f64, ratio: f64| -> Vec<&str> {
        let found = estimates(system, load, ratio);
        found.cautions(system, Some(slip(ratio))).map(|caution| caution.kind.code).collect()
    };
    assert!(codes(&lunar(), LUNAR_LOAD, 0.2).is_empty());
    assert_eq!(codes(&lunar(), 50.0 * LUNAR_LOAD, 0.2), ["sinkage_beyond_estimates"]);
    let law = PressureSinkage::Direct(Direct { k_s: 1e6, exponent: SinkageExponent { slip_gain: 0.4, ..exponent(1.0) } });
    let slipping = system(LUNAR_WHEEL, SoilParams { pressure_sinkage: Some(law), ..LUNAR_SOIL }, Contact::MIDPOINT);
    assert_eq!(codes(&slipping, LUNAR_LOAD, 0.2), ["slip_gain_unused"]);
    assert!(codes(&slipping, LUNAR_LOAD, 0.0).is_empty());
    let at_rest = Resistances::of(&slipping, LUNAR_LOAD, None).expect("estimates");
    assert_eq!(at_rest.rigid_wheel_sinkage, estimates(&slipping, LUNAR_LOAD, 0.9).rigid_wheel_sinkage);
}

#[test]
fn loads_that_are_none_or_too_large_are_refused() {
    for load in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Resistances::of(&lunar(), load, None);
        assert!(matches!(refused, Err(Error::Invalid(fault)) if *fault.parameter == WheelOnSoil::NORMAL_LOAD), "{load}");
    }
    let beyond = Resistances::of(&lunar(), 1e6, None);
    assert!(matches!(beyond, Err(Error::SinkageOutsideWheel { sinkage, radius: 0.4065 }) if sinkage > 0.4065));
    let all_friction = SoilParams { friction_angle: 1.57, ..LUNAR_SOIL };
    let refused = Resistances::of(&system(LUNAR_WHEEL, all_friction, Contact::MIDPOINT), LUNAR_LOAD, None);
    assert_eq!(refused, Err(Error::NotFinite));
    let narrow = PressureSinkage::Bekker(Bekker { k_c: -100_000.0, k_phi: 754_130.0, exponent: exponent(1.0) });
    let soil = SoilParams { pressure_sinkage: Some(narrow), ..LETTER_SOIL };
    let refused = Resistances::of(&system(LETTER_WHEEL, soil, Contact::MIDPOINT), 80.0, None);
    assert!(matches!(refused, Err(Error::ModulusNotPositive { .. })));
}
