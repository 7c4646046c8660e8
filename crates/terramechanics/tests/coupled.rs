//! Ding's coupled forms against the linearised method, with which they share the equations.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, contact, letter, slip, system};
use proptest::prelude::*;
use terramechanics::{
    Contact, ContactPatch, Coupled, CoupledForces, Direct, Error, ForceModel, Heading, JanosiHanamoto, Method,
    NormalStressRadius, PeakRule, PressureSinkage, ShearLaw, SinkageExponent, SoilParams, WheelOnSoil, WheelParams, WongPeak,
    WongReece,
};

/// Some tens of roundings, on the scale on which a result is accurate.
const ROUNDING: f64 = 1e-12;

const RADII: [NormalStressRadius; 2] = [NormalStressRadius::Rim, NormalStressRadius::Shearing];

fn coupled(patch: &ContactPatch<'_>, normal_load: f64, torque: Option<f64>) -> Result<CoupledForces, Error> {
    Coupled { normal_load, torque, normal_stress_radius: NormalStressRadius::Rim }.forces(patch)
}

/// Wong's law without a residual leaves torques near the least double, which have fewer digits (N·m).
const SUBNORMAL: f64 = 1e-300;

fn shear_laws() -> impl Strategy<Value = ShearLaw> {
    let displacement = || (-3.3..-1.0).prop_map(|log: f64| 10f64.powf(log));
    prop_oneof![
        displacement().prop_map(|modulus| ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus })),
        displacement().prop_map(|peak_displacement| ShearLaw::WongPeak(WongPeak { peak_displacement })),
    ]
}

fn rules() -> impl Strategy<Value = PeakRule> {
    prop_oneof![
        Just(PeakRule::Midpoint),
        Just(PeakRule::HalfSinkage),
        (0.35..0.55, -0.1..0.2).prop_map(|(c1, c2)| PeakRule::WongReece(WongReece { c1, c2 })),
    ]
}

proptest! {
    /// A load and a torque that come from linear stresses lead back to them: the load to the torque, both to the pull.
    #[test]
    fn a_load_of_the_linearised_method_gives_back_its_torque_and_its_pull(
        (radius, width, lugs, lug_coefficient) in (0.03..0.7, 0.03..0.6, prop_oneof![Just(0.0), 0.001..0.03], 0.0..=1.0),
        (cohesion, friction_angle, shear) in (prop_oneof![Just(0.0), 10.0..20_000.0], 0.0..1.0, shear_laws()),
        (rule, exit_ratio, log_depth, ratio) in (rules(), -0.4..=0.2, -5.0..0.0, -1.0..=1.0),
    ) {
        let exponent = SinkageExponent { base: 1.0, slip_gain: 0.0, skid_gain: None };
        let pressure_sinkage = PressureSinkage::Direct(Direct { k_s: 1e6, exponent });
        let wheel = WheelParams { radius, width, lug_height: lugs, lug_coefficient };
        let soil = SoilParams { cohesion, friction_angle, shear: Some(shear), pressure_sinkage: Some(pressure_sinkage), ..LETTER_SOIL };
        let system = system(wheel, soil, contact(rule, exit_ratio));
        let rolling = system.rolling(slip(ratio)).expect("a rolling wheel");
        let patch = rolling.contact(radius * 10f64.powf(log_depth)).expect("a contact");
        for normal_stress_radius in RADII {
            let linear = ForceModel { method: Method::LINEARISED, normal_stress_radius }.forces(&patch).expect("forces");
            if linear.normal <= 1e-3 * linear.normal_scale() {
                continue; // a braking wheel that carries next to nothing
            }
            // A load that is a difference has lost digits, and so has what follows from it.
            let tolerance = ROUNDING * linear.normal_scale() / linear.normal;
            let known = Coupled { normal_load: linear.normal, torque: None, normal_stress_radius };
            let from_load = known.forces(&patch).expect("it carries that load");
            prop_assert!((from_load.torque - linear.torque).abs() <= tolerance * linear.torque.abs() + SUBNORMAL);
            prop_assert!((from_load.longitudinal - linear.longitudinal).abs() <= tolerance * linear.longitudinal_scale());
            let measured = Coupled { torque: Some(linear.torque), ..known }.forces(&patch).expect("any torque will do");
            prop_assert_eq!(measured.torque, linear.torque);
            prop_assert!((measured.longitudinal - linear.longitudinal).abs() <= tolerance * linear.longitudinal_scale());
            let peak = patch.stresses().expect("a law").normal(patch.angles.peak);
            prop_assert!((measured.peak_normal_stress / peak - 1.0).abs() <= tolerance);
        }
    }

    /// F_x is linear in W and T, and without cohesion all forces scale with the load.
    #[test]
    fn without_cohesion_forces_scale_with_the_load(load in 1e-3..1e6, ratio in -0.3..1.0) {
        let system = letter();
        let rolling = system.rolling(slip(ratio)).expect("a rolling wheel");
        let patch = rolling.contact(0.02).expect("a contact");
        let (one, many) = (coupled(&patch, 1.0, None).expect("forces"), coupled(&patch, load, None).expect("forces"));
        prop_assert!((many.torque - load * one.torque).abs() <= ROUNDING * many.torque.abs());
        prop_assert!((many.longitudinal - load * one.longitudinal).abs() <= ROUNDING * load);
    }
}

/// Two contacts with triangular stresses, evaluated by an independent program: θ1, slip, K, c, φ, σm → W, T, F_x.
#[test]
fn triangular_stresses_of_another_program_come_back() {
    for (entry, ratio, cohesion, friction_angle, load, torque, pull) in
        [(0.7_f64, 0.3, 500.0, 0.6, 70.459026, 7.0004767, 11.1630643), (0.5, 0.1, 0.0, 0.478, 25.1728984, 0.8743675, -1.9390407)]
    {
        let shear = ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.02 });
        let soil = SoilParams { cohesion, friction_angle, shear: Some(shear), ..LETTER_SOIL };
        let system = system(LETTER_WHEEL, soil, Contact::MIDPOINT);
        let rolling = system.rolling(slip(ratio)).expect("a rolling wheel");
        let patch = rolling.contact(0.2 * (1.0 - entry.cos())).expect("a contact");
        let forces = coupled(&patch, load, None).expect("forces");
        // Half a unit of the last printed digit of load and result.
        assert!((forces.torque - torque).abs() < 2e-7 && (forces.longitudinal - pull).abs() < 2e-7, "{forces:?}");
    }
}

/// Without shear stress (a frictionless, cohesionless soil) the torque is 0 and the load meets the plain resistance W B/A.
#[test]
fn a_soil_without_strength_only_resists() {
    let system = system(LETTER_WHEEL, SoilParams { friction_angle: 0.0, ..LETTER_SOIL }, Contact::MIDPOINT);
    let rolling = system.rolling(slip(0.5)).expect("a rolling wheel");
    let patch = rolling.contact(0.02).expect("a contact");
    let forces = coupled(&patch, 50.0, None).expect("forces");
    let shape = terramechanics::ShapeIntegrals::of(&patch.angles);
    assert_eq!(forces.torque, 0.0);
    assert!((forces.longitudinal / (-50.0 * shape.b / shape.a) - 1.0).abs() < ROUNDING);
}

#[test]
fn a_wheel_that_moves_backwards_is_the_mirror_image() {
    let system = letter();
    let rolling = system.rolling(slip(0.2)).expect("a rolling wheel");
    let ahead = coupled(&rolling.contact(0.02).expect("a contact"), 50.0, None).expect("forces");
    let back = ahead.heading(Heading::Backward);
    assert_eq!((back.longitudinal, back.torque), (-ahead.longitudinal, -ahead.torque));
    assert_eq!(ahead.heading(Heading::Forward), ahead);
}

/// A locked wheel deep in a soil of much friction: r_s B tan φ/(r_n A) exceeds 1, so the shear stress outweighs the support.
#[test]
fn a_braking_wheel_that_carries_nothing_is_refused() {
    let soil = SoilParams { friction_angle: 1.2, ..LETTER_SOIL };
    let system = system(WheelParams { lug_height: 0.05, lug_coefficient: 1.0, ..LETTER_WHEEL }, soil, Contact::MIDPOINT);
    let rolling = system.rolling(slip(-1.0)).expect("a locked wheel");
    let patch = rolling.contact(0.2).expect("to the axle");
    assert!(matches!(coupled(&patch, 50.0, None), Err(Error::LoadNotCoupled { support }) if support < 0.0));
    assert!(coupled(&patch, 50.0, Some(-5.0)).is_ok(), "a torque that is measured needs no such balance");
}

#[test]
fn a_load_below_what_cohesion_supports_is_cautioned() {
    let system = system(LETTER_WHEEL, SoilParams { cohesion: 10_000.0, ..LETTER_SOIL }, Contact::MIDPOINT);
    let rolling = system.rolling(slip(0.8)).expect("a rolling wheel");
    let patch = rolling.contact(0.05).expect("a contact");
    let light = coupled(&patch, 1.0, None).expect("forces");
    assert!(light.caution().is_some_and(|caution| caution.kind.code == "negative_normal_stress" && caution.value < 0.0));
    assert_eq!(coupled(&patch, 200.0, None).expect("forces").caution(), None);
}

#[test]
fn loads_and_torques_that_are_none_are_refused() {
    let system = letter();
    let rolling = system.rolling(slip(0.2)).expect("a rolling wheel");
    let patch = rolling.contact(0.02).expect("a contact");
    for bad in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
        let refused = coupled(&patch, bad, None);
        assert!(matches!(refused, Err(Error::Invalid(fault)) if *fault.parameter == WheelOnSoil::NORMAL_LOAD));
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = coupled(&patch, 50.0, Some(bad));
        assert!(matches!(refused, Err(Error::Invalid(fault)) if *fault.parameter == WheelOnSoil::TORQUE));
    }
    assert_eq!(coupled(&patch, 50.0, Some(1e308)), Err(Error::NotFinite));
}
