//! The pull that torque and load show, without a soil.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, LUGS, REFERENCE_CASES, cases, contact, model_of, slip, system, system_of};
use proptest::prelude::*;
use terramechanics::{
    AngleRatio, Braking, Circles, Contact, ContactParams, Coupled, Error, ExitRule, ForceModel, Interface, JanosiHanamoto,
    Measured, Method, NormalStressRadius, Operation, PeakRule, Sample, SampleMotion, ShapeIntegrals, ShearDisplacementRadius,
    ShearLaw, Sinkage, SinkageRatio, SlipRadius, SoilParams, Thresholds, Tracker, WheelOnSoil, WheelParams, WongPeak,
    pull_from_torque, torque_against_slip,
};

/// Some tens of roundings, on the scale of the parts.
const ROUNDING: f64 = 1e-12;

/// Torque and load of the linear stresses lead to their pull, by thirty digits on a hundred wheels.
#[test]
fn the_linear_stresses_of_the_reference_give_their_pull_back() {
    let mut compared = 0;
    for case in cases(REFERENCE_CASES).iter().chain(&cases(LUGS)) {
        let (input, expected) = (&case["input"], &case["expected"]["linearised"]);
        let of = |name: &str| expected[name].as_f64().expect("a number");
        if of("normal_force_n") <= 0.0 {
            continue; // it carries no load
        }
        let system = system_of(input);
        let rolling = system.rolling(slip(input["slip"].as_f64().expect("a slip"))).expect("a rolling wheel");
        let patch = rolling.contact(input["sinkage_m"].as_f64().expect("a sinkage")).expect("a contact");
        let radius = model_of(input, "linearised").normal_stress_radius;
        let measured = Measured { torque: of("torque_n_m"), normal_load: of("normal_force_n") };
        let found = pull_from_torque(&system.wheel, &ShapeIntegrals::of(&patch.angles), measured, radius).expect("a pull");
        let scale = of("traction_n").abs() + of("resistance_n").abs();
        assert!((found.longitudinal - of("longitudinal_force_n")).abs() <= 10.0 * ROUNDING * scale, "{case}");
        assert!(torque_against_slip(&system.wheel, &system.contact, rolling.slip, patch.sinkage, measured.torque).is_none());
        compared += 1;
    }
    assert!(compared > 90, "{compared}");
}

/// The soil does not enter: any other gives the same.
#[test]
fn the_coupled_form_with_a_torque_is_the_pull_from_torque() {
    for cohesion in [0.0, 5e3] {
        let soil = SoilParams { cohesion, pressure_sinkage: None, ..LETTER_SOIL };
        let system = system(WheelParams { lug_height: 0.01, ..LETTER_WHEEL }, soil, Contact::MIDPOINT);
        let rolling = system.rolling(slip(0.3)).expect("a rolling wheel");
        let patch = rolling.contact(0.02).expect("a contact");
        for normal_stress_radius in [NormalStressRadius::Rim, NormalStressRadius::Shearing] {
            let coupled = Coupled { normal_load: 70.0, torque: Some(6.0), normal_stress_radius }.forces(&patch);
            let measured = Measured { torque: 6.0, normal_load: 70.0 };
            let shape = ShapeIntegrals::of(&Contact::MIDPOINT.angles(0.1, slip(0.3)).expect("angles"));
            assert_eq!(coupled, pull_from_torque(&system.wheel, &shape, measured, normal_stress_radius));
        }
    }
}

#[test]
fn a_torque_or_a_load_that_is_none_is_refused() {
    let wheel = system(LETTER_WHEEL, LETTER_SOIL, Contact::MIDPOINT).wheel;
    let shape = ShapeIntegrals::of(&Contact::MIDPOINT.angles(0.1, slip(0.3)).expect("angles"));
    let at_fault =
        |torque, normal_load| match pull_from_torque(&wheel, &shape, Measured { torque, normal_load }, NormalStressRadius::Rim) {
            Err(Error::Invalid(fault)) => fault.parameter.name,
            other => panic!("{other:?}"),
        };
    assert_eq!(at_fault(f64::NAN, 10.0), "torque_n_m");
    assert_eq!(at_fault(1.0, 0.0), "normal_load_n");
    assert_eq!(at_fault(1.0, f64::INFINITY), "normal_load_n");
}

proptest! {
    /// No torque that the stresses make is said to contradict its slip, whatever the circles, the exit and the law; where one sign
    /// alone is possible, the other is told.
    #[test]
    fn a_torque_that_the_stresses_make_never_contradicts_its_slip(
        (ratio, log_depth, lug_height) in (-1.0..=1.0, -4.0..=0.0, prop_oneof![Just(0.0), 0.001..0.03]),
        (by_ratio, exit, two_zones, circle, on_rim) in (any::<bool>(), -1.2..=0.0_f64, any::<bool>(), 0..3_usize, any::<bool>()),
        (cohesion, log_modulus, falls, bare) in (0.0..2000.0, -3.0..-1.0, any::<bool>(), any::<bool>()),
    ) {
        let exit = if by_ratio {
            ExitRule::SinkageRatio(SinkageRatio { ratio: -exit })
        } else {
            ExitRule::AngleRatio(AngleRatio { c3: exit })
        };
        let circles = Circles {
            slip: [SlipRadius::Rim, SlipRadius::Shearing, SlipRadius::LugTip][circle],
            shear_displacement: if on_rim { ShearDisplacementRadius::Rim } else { ShearDisplacementRadius::Shearing },
        };
        let slippery = Interface { friction_angle: Some(0.2), adhesion: Some(0.0), shear_modulus: Some(0.002) };
        let interface = bare.then_some(slippery);
        let rule = PeakRule::Midpoint;
        let contact = Contact::new(ContactParams { rule, exit, circles, interface }).expect("a contact");
        let contact = contact.with_braking(if two_zones { Braking::TwoZone } else { Braking::OneZone });
        let modulus = 10f64.powf(log_modulus);
        let shear = if falls {
            ShearLaw::WongPeak(WongPeak { peak_displacement: modulus })
        } else {
            ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus })
        };
        let soil = SoilParams { cohesion, shear: Some(shear), ..LETTER_SOIL };
        let system = system(WheelParams { lug_height, ..LETTER_WHEEL }, soil, contact);
        let sinkage = LETTER_WHEEL.radius * 10f64.powf(log_depth);
        let rolling = system.rolling(slip(ratio)).expect("a rolling wheel");
        let Ok(patch) = rolling.contact(sinkage) else { return Ok(()) };
        let torque = ForceModel::at_rim(Method::Quadrature).forces(&patch).expect("forces").torque;
        let told = |torque| torque_against_slip(&system.wheel, &system.contact, rolling.slip, sinkage, torque).is_some();
        prop_assert!(!told(torque), "{torque}");
        prop_assert!(!told(0.0));
        if ratio >= 0.0 && circles.slip == SlipRadius::Rim {
            prop_assert!(told(-1e-9));
        }
    }
}

/// In a track a torque of the wrong sign is told of a wheel that moves, in either heading, and not of one at rest.
#[test]
fn a_track_tells_of_torques_against_their_slip() {
    let system: WheelOnSoil = system(LETTER_WHEEL, LETTER_SOIL, contact(PeakRule::Midpoint, 0.0));
    let sinkage = Sinkage::Given(0.02);
    let operation = Operation { system, model: ForceModel::at_rim(Method::LINEARISED), sinkage };
    let told = |forward, torque| {
        let mut tracker = Tracker::new(operation, Thresholds::default()).expect("thresholds");
        let angular = if forward == 0.0 { 0.0 } else { 1.2 * forward / LETTER_WHEEL.radius };
        let motion = SampleMotion::Velocities(terramechanics::Velocities { forward, angular });
        let measured = Some(Measured { torque, normal_load: 80.0 });
        let row = tracker.push(&Sample { time: 0.0, motion, sinkage, measured, unreadable: false });
        assert!(row.longitudinal_coupled.is_finite());
        tracker.cautions().iter().any(|tally| tally.worst.kind.code == "torque_against_slip")
    };
    assert!(told(0.1, -5.0) && !told(0.1, 5.0));
    assert!(told(-0.1, 5.0) && !told(-0.1, -5.0));
    assert!(!told(0.0, -0.1) && !told(0.0, 0.1));
}
