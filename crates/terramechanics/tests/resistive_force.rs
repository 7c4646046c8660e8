//! The resistive force method against published formulas at 30 and 40 digits, values by hand, and what has to hold of it.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, cases, slip, system};
use proptest::prelude::*;
use serde_json::Value;
use terramechanics::{
    Braking, Caution, CautionKind, Circles, Contact, Error, ForceModel, Forces, Heading, KnownSinkage, Method, NormalStressFrom,
    OperatingPoint, Operation, Outcome, PeakDepth, Sample, SampleMotion, Sinkage, Slip, SlipRadius, SlipSinkage, SlipSweep,
    SoilLaw, SoilParams, Thresholds, Tracker, Velocities, WheelOnSoil, WheelParams, cautions,
};

const RANDOM_CASES: &str = include_str!("reference/resistive_force_cases.json");
const EDGE_CASES: &str = include_str!("reference/resistive_force.json");

/// What an integral promises, on the scale of the parts.
const INTEGRAL: f64 = 1e-10;
/// A solved sinkage: the integral's error and what is left of the balance.
const SOLVED_SINKAGE: f64 = 1e-9;
/// Some tens of roundings.
const ROUNDING: f64 = 1e-13;
/// A polynomial: a few roundings, and those of the tangent.
const STIFFNESS: f64 = 1e-14;

const METHOD: ForceModel =
    ForceModel { method: Method::ResistiveForce, normal_stress_radius: terramechanics::NormalStressRadius::Rim };

/// Grains that have no law of the letter's.
const GRAINS: SoilParams = SoilParams { friction_angle: 0.6, granular_stiffness: Some(2e6), ..SoilParams::BARE };

fn on(wheel: WheelParams, soil: SoilParams) -> WheelOnSoil {
    system(wheel, soil, Contact::MIDPOINT)
}

fn grains() -> WheelOnSoil {
    on(LETTER_WHEEL, GRAINS)
}

fn point(system: WheelOnSoil, sinkage: Sinkage, ratio: f64) -> Result<OperatingPoint, Error> {
    Operation { system, model: METHOD, sinkage }.at(slip(ratio))
}

fn forces(system: WheelOnSoil, ratio: f64, sinkage: f64) -> Forces {
    point(system, Sinkage::Given(sinkage), ratio).expect("forces").forces
}

fn number(object: &Value, name: &str) -> Option<f64> {
    object.get(name).and_then(Value::as_f64)
}

fn system_of(input: &Value) -> WheelOnSoil {
    let required = |object: &Value, name: &str| number(object, name).expect("a number");
    let (wheel, soil) = (&input["wheel"], &input["soil"]);
    let (radius, width) = (required(wheel, "radius_m"), required(wheel, "width_m"));
    let soil = SoilParams {
        friction_angle: required(soil, "friction_angle_rad"),
        bulk_density: number(soil, "bulk_density_kg_m3"),
        gravity: number(soil, "gravity_m_s2"),
        granular_stiffness: number(soil, "granular_stiffness_n_m3"),
        ..SoilParams::BARE
    };
    on(WheelParams { radius, width, ..LETTER_WHEEL }, soil)
}

/// Compares the forces of a case, on the scale of their parts, and its load; gives the number of loads.
fn compare(case: &Value) -> usize {
    let (input, expected) = (&case["input"], &case["expected"]);
    let name = case["name"].as_str().unwrap_or("a random case");
    let (system, ratio) = (system_of(input), number(input, "slip").expect("a slip"));
    let mut loads = vec![];
    if let Some(sinkage) = number(input, "sinkage_m") {
        let at = point(system, Sinkage::Given(sinkage), ratio).expect("forces");
        let stiffness = number(expected, "granular_stiffness_n_m3").expect("a stiffness");
        let found = at.granular_stiffness.expect("a stiffness");
        assert!((found / stiffness - 1.0).abs() <= STIFFNESS, "{name}: {found}, not {stiffness}");
        let (along, up) = (at.forces.longitudinal_scale(), at.forces.normal_scale());
        let parts = &at.forces.components;
        for (field, value, scale) in [
            ("longitudinal_force_n", at.forces.longitudinal, along),
            ("traction_n", parts.traction, along),
            ("resistance_n", parts.resistance, along),
            ("normal_force_n", at.forces.normal, up),
            ("normal_support_n", parts.normal_support, up),
            ("shear_support_n", parts.shear_support, up),
            ("torque_n_m", at.forces.torque, at.forces.torque.abs()),
        ] {
            let Some(reference) = number(expected, field) else { continue };
            let off = (value - reference).abs() / scale;
            assert!(off <= INTEGRAL, "{name}: {field} {value}, not {reference}: off by {off:e}");
        }
    }
    if let Some(load) = expected.get("sinkage_for_load") {
        loads.push((number(load, "normal_load_n").expect("a load"), number(load, "sinkage_m").expect("a sinkage")));
    }
    if let Some(load) = number(input, "normal_load_n") {
        loads.push((load, number(expected, "sinkage_m").expect("a sinkage")));
    }
    for (load, sinkage) in &loads {
        let solved = point(system, Sinkage::CarryingLoad(*load), ratio).expect("a balance").sinkage;
        assert!((solved / sinkage - 1.0).abs() <= SOLVED_SINKAGE, "{name}: {solved} m, not {sinkage} m");
    }
    loads.len()
}

#[test]
fn thirty_random_wheels_agree_with_thirty_digits() {
    let cases = cases(RANDOM_CASES);
    assert_eq!(cases.len(), 30);
    assert!(cases.iter().map(compare).sum::<usize>() >= 3);
}

#[test]
fn wheels_at_the_edges_agree_with_forty_digits() {
    let cases = cases(EDGE_CASES);
    assert!(cases.len() >= 25);
    assert!(cases.iter().map(compare).sum::<usize>() >= 4);
}

/// r .2, b .1 m, ξ 2e6, z 20 mm, worked out beside the crate with ten digits.
#[test]
fn two_wheels_worked_out_by_hand_are_met() {
    for (ratio, pull, normal, torque) in
        [(0.2, 10.672_807_42, 162.322_901, 8.214_884_483), (-0.5, -43.173_081_63, 120.788_373_6, -4.038_428_745)]
    {
        let found = forces(grains(), ratio, 0.02);
        for (value, expected) in [(found.longitudinal, pull), (found.normal, normal), (found.torque, torque)] {
            assert!((value / expected - 1.0).abs() < 1e-9, "slip {ratio}: {value}, not {expected}");
        }
    }
}

/// A thin contact of a locked wheel is a level plate dragged flat: constant α over a parabola of depth, ∫ d r dθ = (2/3) z r θ1.
#[test]
fn a_thin_locked_contact_is_a_plate_that_is_dragged() {
    let sinkage = 1e-9;
    let found = forces(grains(), -1.0, sinkage);
    let area = 0.1 * 2.0 / 3.0 * 0.2 * (2.0 * sinkage / 0.2_f64).sqrt();
    let (up, along) = (0.206 + 0.169, 0.124 - 0.253 - 0.007);
    assert!((found.normal / (2e6 * sinkage * area * up) - 1.0).abs() < 1e-3, "{}", found.normal);
    assert!((found.longitudinal / (2e6 * sinkage * area * along) - 1.0).abs() < 1e-3, "{}", found.longitudinal);
}

/// Neither strength nor laws nor rules of the contact have a part in it, but the braking law would part it in two zones.
#[test]
fn what_the_method_does_not_need_changes_nothing() {
    let bare = forces(grains(), -0.2, 0.03);
    let soil = SoilParams { granular_stiffness: Some(2e6), friction_angle: 0.4, cohesion: 900.0, ..LETTER_SOIL };
    let contact = Contact::MIDPOINT.with_braking(Braking::TwoZone);
    let full = WheelOnSoil { contact, ..on(LETTER_WHEEL, soil) };
    assert_eq!(forces(full, -0.2, 0.03), bare);
    // The same contact by the way that other methods go.
    let rolling = full.rolling(slip(-0.2)).expect("a rolling wheel");
    assert_eq!(METHOD.forces(&rolling.contact(0.03).expect("a contact")), Ok(bare));
}

#[test]
fn what_the_method_needs_is_named_where_it_is_missing() {
    let missing = Error::MissingLaw(SoilLaw::GranularStiffness);
    let smooth = SoilParams { bulk_density: Some(1500.0), ..SoilParams::BARE }; // without friction no grains hold
    for soil in [LETTER_SOIL, SoilParams::BARE, smooth] {
        let system = on(LETTER_WHEEL, soil);
        assert_eq!(point(system, Sinkage::Given(0.02), 0.2), Err(missing));
        assert_eq!(point(system, Sinkage::CarryingLoad(50.0), 0.2), Err(missing));
    }
    let deep = point(grains(), Sinkage::Given(0.2_f64.next_up()), 0.2);
    assert!(matches!(deep, Err(Error::SinkageOutsideWheel { .. })));
    let heavy = point(grains(), Sinkage::CarryingLoad(1e6), 0.2);
    assert!(matches!(heavy, Err(Error::LoadBeyondCapacity { .. })), "{heavy:?}");
}

/// The laws that another method would miss are not asked for, and what they would give is not invented.
#[test]
fn a_method_of_laws_finds_nothing_where_there_are_none() {
    let system = grains();
    assert_eq!(system.rolling(slip(0.2)).map(|_| ()), Err(Error::MissingLaw(SoilLaw::Shear)));
    let rolling = METHOD.rolling(&system, slip(0.2)).expect("a rolling wheel");
    let patch = METHOD.contact(&rolling, 0.02).expect("a contact");
    let quadrature = ForceModel::at_rim(Method::Quadrature);
    assert_eq!(quadrature.forces(&patch), Err(Error::MissingLaw(SoilLaw::PressureSinkage)));
}

/// The rim's own motion counts, whichever circle the slip is told on: 20 % on lug tips of 0.25 m is no slip of a rim of 0.2 m.
#[test]
fn the_slip_may_be_counted_on_another_circle() {
    let lugged = WheelParams { lug_height: 0.05, ..LETTER_WHEEL };
    let contact = Contact::MIDPOINT.with_circles(Circles { slip: SlipRadius::LugTip, ..Circles::SHEARING });
    let on_tips = WheelOnSoil { contact, ..on(lugged, GRAINS) };
    let (tips, rim) = (forces(on_tips, 0.2, 0.02), forces(grains(), 0.0, 0.02));
    assert!((tips.normal / rim.normal - 1.0).abs() < INTEGRAL && (tips.torque / rim.torque - 1.0).abs() < INTEGRAL);
}

/// The four parts and the profile are those of the same stresses: the integrals again, by the trapezoidal rule.
#[test]
fn the_profile_has_the_forces_in_it() {
    for ratio in [-1.0, -0.3, 0.0, 0.05, 0.4, 1.0] {
        let system = grains();
        let rolling = METHOD.rolling(&system, slip(ratio)).expect("a rolling wheel");
        let patch = METHOD.contact(&rolling, 0.03).expect("a contact");
        let profile = METHOD.profile(&patch, 20_001, PeakDepth::Geometric).expect("a profile");
        assert_eq!(profile.len(), 20_001);
        assert_eq!((profile.theta[0], profile.theta[20_000]), (0.0, patch.angles.entry));
        assert!(profile.theta.contains(&patch.angles.peak), "slip {ratio}");
        assert!(profile.normal_linear.iter().all(|stress| stress.is_nan()));
        let integral = |of: &dyn Fn(usize) -> f64| -> f64 {
            let pairs = profile.theta.windows(2).enumerate();
            pairs.map(|(i, theta)| 0.5 * (theta[1] - theta[0]) * (of(i) + of(i + 1))).sum::<f64>() * 0.1 * 0.2
        };
        let found = forces(system, ratio, 0.03);
        let parts = found.components;
        let (theta, normal, shear) = (&profile.theta, &profile.normal, &profile.shear);
        for (part, by_profile, scale) in [
            (parts.traction, integral(&|i| shear[i] * theta[i].cos()), found.longitudinal_scale()),
            (parts.resistance, integral(&|i| normal[i] * theta[i].sin()), found.longitudinal_scale()),
            (parts.normal_support, integral(&|i| normal[i] * theta[i].cos()), found.normal_scale()),
            (parts.shear_support, integral(&|i| shear[i] * theta[i].sin()), found.normal_scale()),
        ] {
            assert!((part - by_profile).abs() < 1e-6 * scale, "slip {ratio}: {part}, not {by_profile}");
        }
        let highest = profile.normal.iter().fold(f64::MIN, |highest, &stress| highest.max(stress));
        let at_peak = METHOD.stresses_at(&patch, patch.angles.peak).expect("stresses").normal;
        assert!(at_peak >= highest * (1.0 - ROUNDING), "slip {ratio}: {at_peak} at the peak, {highest} beside it");
        let outside = METHOD.stresses_at(&patch, patch.angles.entry + 0.01).expect("stresses");
        assert_eq!((outside.normal, outside.shear), (0.0, 0.0));
    }
}

/// A solved sinkage, given with the load again, gives the same forces, and shows the stiffness of the soil.
#[test]
fn a_load_beside_the_sinkage_shows_the_stiffness() {
    for ratio in [-0.4, 0.0, 0.3] {
        let solved = point(grains(), Sinkage::CarryingLoad(90.0), ratio).expect("a balance");
        let known = Sinkage::UnderLoad { sinkage: KnownSinkage::Given(solved.sinkage), load: 90.0 };
        // Twice the stiffness in the soil, or none: the load tells.
        for granular_stiffness in [Some(4e6), None] {
            let soil = SoilParams { granular_stiffness, ..GRAINS };
            let under = point(on(LETTER_WHEEL, soil), known, ratio).expect("forces");
            assert!((under.granular_stiffness.expect("a stiffness") / 2e6 - 1.0).abs() < SOLVED_SINKAGE);
            assert!((under.forces.torque / solved.forces.torque - 1.0).abs() < SOLVED_SINKAGE);
            assert!((under.forces.normal / 90.0 - 1.0).abs() < ROUNDING);
            assert_eq!(under.normal_stress_from, NormalStressFrom::Load);
        }
    }
}

#[test]
fn sweeps_tracks_and_towed_wheels_take_the_method() {
    let operation = Operation { system: grains(), model: METHOD, sinkage: Sinkage::Given(0.02) };
    let slips = [-1.0, -0.5, 0.0, 0.2, 1.0].map(slip);
    let sweep = SlipSweep::of(&operation, &slips);
    assert_eq!(sweep.points().count(), 5);
    assert_eq!(sweep.rows[3].point.expect("a point").forces, forces(grains(), 0.2, 0.02));

    let mut tracker = Tracker::new(operation, Thresholds::default()).expect("thresholds");
    let mut row = |forward, angular| {
        let motion = SampleMotion::Velocities(Velocities { forward, angular });
        tracker.push(&Sample { time: 0.0, motion, sinkage: Sinkage::Given(0.02), measured: None, unreadable: false })
    };
    let (ahead, back) = (row(0.16, 1.0), row(-0.16, -1.0));
    assert!((ahead.power / 8.214_884_483 - 1.0).abs() < 1e-9, "{} W", ahead.power); // the torque by hand at 1 rad/s
    assert_eq!((back.longitudinal, back.normal, back.torque), (-ahead.longitudinal, ahead.normal, -ahead.torque));
    assert_eq!(back.power, ahead.power);

    let towed = METHOD.solve_towed(&grains(), 80.0).expect("a towed wheel");
    assert!(towed.slip < Slip::ROLLING && towed.resistance() > 0.0);
    assert!((towed.forces.normal / 80.0 - 1.0).abs() < SOLVED_SINKAGE);
    assert!(towed.forces.torque.abs() < 1e-6 * forces(grains(), 0.0, towed.sinkage).torque);
}

fn codes(operation: &Operation, ratio: f64) -> Vec<&'static str> {
    let at = operation.at(slip(ratio)).expect("a point");
    cautions(operation, &Outcome::from(&at)).map(|Caution { kind: CautionKind { code, .. }, .. }| *code).collect()
}

#[test]
fn what_the_method_leaves_out_is_told() {
    let of = |wheel, soil| Operation { system: on(wheel, soil), model: METHOD, sinkage: Sinkage::Given(0.02) };
    assert!(codes(&of(LETTER_WHEEL, GRAINS), 0.2).is_empty());
    assert_eq!(codes(&of(LETTER_WHEEL, GRAINS), -0.2), ["driving_only"]);
    assert_eq!(codes(&of(LETTER_WHEEL, SoilParams { cohesion: 1000.0, ..GRAINS }), 0.2), ["cohesion_left_out"]);
    assert_eq!(codes(&of(WheelParams { lug_height: 0.01, ..LETTER_WHEEL }, GRAINS), 0.2), ["rough_cylinder"]);
    // Of laws that it does not use nothing is told: the letter's wheel is small for Bekker's.
    let soil = SoilParams { granular_stiffness: Some(2e6), ..LETTER_SOIL };
    assert!(codes(&of(LETTER_WHEEL, soil), 0.2).is_empty());
}

#[test]
fn a_low_gravity_and_moduli_of_another_one_are_told() {
    let earth = on(LETTER_WHEEL, SoilParams { gravity: Some(9.80665), granular_stiffness: Some(2e6), ..LETTER_SOIL });
    let moon = WheelOnSoil { soil: earth.soil.in_gravity(1.625).expect("a soil"), ..earth };
    let told = |system, method| {
        let operation = Operation { system, model: ForceModel::at_rim(method), sinkage: Sinkage::Given(0.02) };
        let codes = codes(&operation, 0.2);
        ["low_gravity", "moduli_of_other_gravity"].map(|code| codes.contains(&code))
    };
    assert_eq!(told(earth, Method::Quadrature), [false, false]);
    assert_eq!(told(moon, Method::Quadrature), [true, true]);
    assert_eq!(told(moon, Method::ResistiveForce), [true, false]);
    let ratio = forces(moon, 0.2, 0.02).normal / forces(earth, 0.2, 0.02).normal;
    assert!((ratio * 9.80665 / 1.625 - 1.0).abs() < ROUNDING);
}

proptest! {
    #[test]
    fn forces_are_proportional_to_stiffness_and_width(
        ratio in -1.0..=1.0f64, share in 1e-6..=1.0f64, factor in 1e-3..1e3f64,
    ) {
        let here = forces(grains(), ratio, 0.2 * share);
        let stiff = SoilParams { granular_stiffness: Some(2e6 * factor), ..GRAINS };
        let wide = WheelParams { width: 0.1 * factor, ..LETTER_WHEEL };
        for there in [forces(on(LETTER_WHEEL, stiff), ratio, 0.2 * share), forces(on(wide, GRAINS), ratio, 0.2 * share)] {
            prop_assert!((there.longitudinal - factor * here.longitudinal).abs() <= ROUNDING * factor * here.longitudinal_scale());
            prop_assert!((there.normal - factor * here.normal).abs() <= ROUNDING * factor * here.normal_scale());
            prop_assert!((there.torque - factor * here.torque).abs() <= ROUNDING * factor * 0.2 * here.longitudinal_scale());
        }
    }

    /// Twice the size at the same angles: eight times the forces, sixteen times the torque.
    #[test]
    fn forces_grow_as_the_cube_of_size(ratio in -1.0..=1.0f64, share in 1e-6..=1.0f64) {
        let (here, there) = (forces(grains(), ratio, 0.2 * share), {
            let large = WheelParams { radius: 0.4, width: 0.2, ..LETTER_WHEEL };
            forces(on(large, GRAINS), ratio, 0.4 * share)
        });
        prop_assert!((there.longitudinal - 8.0 * here.longitudinal).abs() <= ROUNDING * there.longitudinal_scale());
        prop_assert!((there.normal - 8.0 * here.normal).abs() <= ROUNDING * there.normal_scale());
        prop_assert!((there.torque - 16.0 * here.torque).abs() <= ROUNDING * 0.4 * there.longitudinal_scale());
    }

    /// A driving wheel carries more the deeper it is.
    #[test]
    fn the_normal_force_of_a_driving_wheel_grows_with_sinkage(ratio in 0.0..=1.0f64, share in 1e-6..0.9f64) {
        let deeper = forces(grains(), ratio, 0.2 * share * 1.05).normal;
        prop_assert!(deeper > forces(grains(), ratio, 0.2 * share).normal);
    }

    /// The stresses swing within a layer at the lowest point, and the forces do not jump.
    #[test]
    fn forces_are_continuous_at_no_slip(share in 1e-6..=1.0f64, log in -15.0..-4.0f64) {
        let entry = (2.0 * share).sqrt();
        let step = 10f64.powf(log);
        let (rolling, driving, braking) =
            (forces(grains(), 0.0, 0.2 * share), forces(grains(), step, 0.2 * share), forces(grains(), -step, 0.2 * share));
        for beside in [driving, braking] {
            // Beyond the layer the stresses change by s/w, whose integral is a logarithm.
            let share = 3.0 * step * (1.0 - step.ln()) / entry + INTEGRAL;
            prop_assert!((beside.normal - rolling.normal).abs() <= share * rolling.normal_scale());
            prop_assert!((beside.longitudinal - rolling.longitudinal).abs() <= share * rolling.normal_scale());
        }
    }

    #[test]
    fn a_load_that_is_answered_is_met(ratio in -1.0..=1.0f64, log in -9.0..4.0f64) {
        let load = 10f64.powf(log);
        if let Ok(at) = point(grains(), Sinkage::CarryingLoad(load), ratio) {
            prop_assert!((at.forces.normal / load - 1.0).abs() <= SOLVED_SINKAGE);
        } else {
            prop_assert!(forces(grains(), ratio, 0.2).normal < load);
        }
    }

    #[test]
    fn a_wheel_that_turns_backwards_is_the_mirror_image(ratio in -1.0..=1.0f64, share in 1e-3..=1.0f64) {
        let ahead = forces(grains(), ratio, 0.2 * share);
        let back = ahead.heading(Heading::Backward);
        prop_assert_eq!((back.longitudinal, back.normal, back.torque), (-ahead.longitudinal, ahead.normal, -ahead.torque));
    }
}

/// The sinkage may follow from a static one, as in every method.
#[test]
fn the_sinkage_may_follow_from_the_slip() {
    let law = SlipSinkage::Lyasko;
    let at = point(grains(), Sinkage::FromStatic { static_sinkage: 0.01, law }, 0.2).expect("forces");
    assert_eq!(at.forces, forces(grains(), 0.2, law.sinkage(0.01, slip(0.2))));
}
