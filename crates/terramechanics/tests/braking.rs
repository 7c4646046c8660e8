//! Braking with two zones, and towed wheels by either law: reference values, limits by hand, properties.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, cases, contact, letter, model_of, slip, system, system_of};
use proptest::prelude::*;
use serde_json::Value;
use std::f64::consts::FRAC_PI_4;
use terramechanics::{
    Braking, Circles, Contact, Direct, Error, ForceModel, Forces, JanosiHanamoto, Method, Outcome, PeakDepth, PeakRule,
    PressureSinkage, ShearLaw, SinkageExponent, SoilParams, StressProfile, WheelOnSoil, WheelParams, WongPeak, WongResidual,
    cautions,
};

/// Some tens of roundings.
const ROUNDING: f64 = 1e-12;
/// What the quadrature promises.
const QUADRATURE: f64 = 1e-10;
/// A solved skid, sinkage and resistance: the quadrature's error and what is left of the balances.
const SOLVED: f64 = 1e-9;

const REFERENCE: &str = include_str!("reference/two_zones.json");
const QUADRATURE_AT_RIM: fn() -> ForceModel = || ForceModel::at_rim(Method::Quadrature);

fn two_zones(system: WheelOnSoil) -> WheelOnSoil {
    WheelOnSoil { contact: system.contact.with_braking(Braking::TwoZone), ..system }
}

fn forces(system: &WheelOnSoil, ratio: f64, sinkage: f64) -> Result<Forces, Error> {
    QUADRATURE_AT_RIM().forces(&system.rolling(slip(ratio))?.contact(sinkage)?)
}

fn number(object: &Value, name: &str) -> f64 {
    object[name].as_f64().expect("a number")
}

#[test]
fn two_zones_agree_with_sixty_digits() {
    let mut compared = 0;
    for case in cases(REFERENCE).iter().filter(|case| case.get("expected").is_some()) {
        let (name, input, expected) = (&case["name"], &case["input"], &case["expected"]["quadrature"]);
        let system = two_zones(system_of(input));
        let rolling = system.rolling(slip(number(input, "slip"))).expect("a rolling wheel");
        let patch = rolling.contact(number(input, "sinkage_m")).expect("a contact");
        let angles = &case["expected"]["angles"];
        for (angle, field) in
            [(patch.angles.entry, "entry_rad"), (patch.angles.peak, "maximum_stress_rad"), (patch.angles.exit, "exit_rad")]
        {
            let reference = number(angles, field);
            assert!((angle - reference).abs() <= ROUNDING * reference.abs(), "{name}: {field} {angle}, not {reference}");
        }
        let forces = model_of(input, "quadrature").forces(&patch).expect("forces");
        let along = number(expected, "traction_n").abs() + number(expected, "resistance_n");
        let up = number(expected, "normal_support_n") + number(expected, "shear_support_n").abs();
        // The torque is a difference of the zones, so its scale is that of all the shear there could be.
        let soil = system.soil;
        let turning = system.wheel.shearing_radius() * (up * soil.tan_friction() + along);
        // A front zone of 1e-5 rad is a difference of angles near 0.6 rad: it has five digits less than they.
        let tolerance = if name.as_str().is_some_and(|name| name.starts_with("front zone")) { 1e-9 } else { QUADRATURE };
        for (computed, field, scale) in [
            (forces.longitudinal, "longitudinal_force_n", along),
            (forces.components.traction, "traction_n", along),
            (forces.components.resistance, "resistance_n", along),
            (forces.normal, "normal_force_n", up),
            (forces.components.normal_support, "normal_support_n", up),
            (forces.components.shear_support, "shear_support_n", up),
            (forces.torque, "torque_n_m", turning),
        ] {
            let off = (computed - number(expected, field)).abs() / scale;
            assert!(off <= tolerance, "{name}: {field} off by {off:e}, estimated {:e}", forces.integration_error);
        }
        compared += 1;
    }
    assert!(compared >= 20, "only {compared} cases");
}

#[test]
fn towed_wheels_agree_with_sixty_digits() {
    let mut compared = 0;
    for case in cases(REFERENCE).iter().filter(|case| case.get("towed").is_some()) {
        let (name, expected) = (&case["name"], &case["towed"]);
        let towed = two_zones(system_of(&case["input"])).solve_towed(number(expected, "normal_load_n")).expect("a towed wheel");
        for (computed, field) in
            [(towed.slip.ratio(), "slip"), (towed.sinkage, "sinkage_m"), (towed.resistance(), "towing_resistance_n")]
        {
            let off = (computed / number(expected, field) - 1.0).abs();
            assert!(off <= SOLVED, "{name}: {field} off by {off:e}");
        }
        compared += 1;
    }
    assert!(compared >= 5, "only {compared} cases");
}

#[test]
fn the_zones_part_at_the_angles_known_at_both_ends_of_the_skid() {
    let system = two_zones(letter());
    let phi = LETTER_SOIL.friction_angle;
    let peak = |ratio: f64| system.rolling(slip(ratio)).expect("a wheel").contact(0.19).expect("a contact").angles.peak;
    assert!((peak(-1.0) - (FRAC_PI_4 + 0.5 * phi)).abs() < 1e-15);
    assert!((peak(-1e-9) / (1e-9 / (FRAC_PI_4 - 0.5 * phi).tan()) - 1.0).abs() < 1e-8); // θ0 → −s/tan(π/4 − φ/2)
}

#[test]
fn a_locked_wheel_is_the_limit_of_ever_more_skid() {
    let residual = ShearLaw::WongResidual(WongResidual { residual_ratio: 0.66, peak_displacement: 0.01 });
    let vanishing = ShearLaw::WongPeak(WongPeak { peak_displacement: 0.01 });
    for shear in [LETTER_SOIL.shear, Some(residual), Some(vanishing)] {
        let system = two_zones(system(LETTER_WHEEL, SoilParams { shear, cohesion: 200.0, ..LETTER_SOIL }, Contact::MIDPOINT));
        let locked = forces(&system, -1.0, 0.15).expect("forces");
        let mut before = f64::INFINITY;
        for remaining in [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13] {
            let near = forces(&system, -1.0 + remaining, 0.15).expect("forces");
            // Where all shear dies out, its error relative to itself says little.
            assert!(
                near.integration_error < 1e-9 || shear == Some(vanishing),
                "{shear:?} {remaining}: {}",
                near.integration_error
            );
            let off = (near.longitudinal - locked.longitudinal).abs().max((near.normal - locked.normal).abs()) / locked.normal;
            // What is missing is a few layers of about K (1 + s)/r radians in a contact of 1.3 rad, and θ0 moves by about 1 + s.
            assert!(off <= 10.0 * remaining + 1e-12 && off <= before + 1e-12, "{shear:?} {remaining}: {off:e}");
            before = off;
        }
    }
}

#[test]
fn a_skid_that_vanishes_has_a_limit_with_all_shear_forward() {
    let system = two_zones(letter());
    let (a, b) = (forces(&system, -1e-9, 0.02).expect("forces"), forces(&system, -1e-12, 0.02).expect("forces"));
    assert!((a.longitudinal - b.longitudinal).abs() < 1e-7 * a.longitudinal_scale());
    assert!((a.normal - b.normal).abs() < 1e-7 * a.normal && (a.torque / b.torque - 1.0).abs() < 1e-6);
    assert!(b.torque > 0.0 && b.components.traction > 0.0 && b.components.shear_support > 0.0);
}

/// The depth under the peak, r (cos θ0 − cos θ1), goes to 0, and with it σ and, without cohesion, all forces.
#[test]
fn the_contact_dwindles_as_its_entry_nears_the_parting_angle_and_is_refused_beyond() {
    let system = two_zones(letter());
    let rolling = system.rolling(slip(-0.3)).expect("a wheel");
    let parting = rolling.contact(0.19).expect("a contact").angles.peak;
    let least = 0.2 * (1.0 - parting.cos());
    let normal = |beyond: f64| forces(&system, -0.3, least + beyond).expect("forces").normal;
    let falls = (normal(2e-8) / normal(1e-8)).log2();
    assert!((falls - 0.91).abs() < 1e-3, "{falls}"); // as the power n0, the rear zone being of a fixed length
    for sinkage in [least * (1.0 - 1e-12), 0.5 * least, 1e-6] {
        assert!(
            matches!(rolling.contact(sinkage), Err(Error::ReversalOutsideContact { reversal, .. }) if reversal == parting),
            "{sinkage}"
        );
    }
    let ahead = two_zones(common::system(LETTER_WHEEL, LETTER_SOIL, contact(PeakRule::Midpoint, 0.3)));
    assert!(matches!(forces(&ahead, -1e-3, 0.02), Err(Error::ReversalOutsideContact { reversal, exit, .. }) if reversal < exit));
}

#[test]
fn closed_forms_and_linear_profiles_have_no_two_zones() {
    let system = two_zones(letter());
    let rolling = system.rolling(slip(-0.1)).expect("a wheel");
    let patch = rolling.contact(0.02).expect("a contact");
    for method in [Method::LINEARISED, Method::EXPLICIT] {
        assert_eq!(ForceModel::at_rim(method).forces(&patch), Err(Error::ClosedFormOfTwoZones));
    }
    let profile = StressProfile::of(&patch.stresses().expect("a law"), 101, PeakDepth::Geometric);
    assert!(profile.normal_linear.iter().chain(&profile.shear_linear).all(|stress| stress.is_nan()));
    let peak = profile.theta.iter().position(|&theta| theta == patch.angles.peak).expect("the peak is a place");
    assert_eq!(profile.shear[peak], 0.0);
    assert!(
        profile.shear[1..peak].iter().all(|&shear| shear < 0.0) && profile.shear[peak + 1..100].iter().all(|&shear| shear > 0.0)
    );
    let largest = profile.normal.iter().copied().fold(0.0, f64::max);
    assert_eq!(profile.normal[peak], largest);
    for method in [Method::LINEARISED, Method::EXPLICIT] {
        let driving = system.rolling(slip(0.1)).expect("a wheel");
        assert!(ForceModel::at_rim(method).forces(&driving.contact(0.02).expect("a contact")).is_ok());
    }
}

#[test]
fn a_rule_for_the_peak_that_is_set_aside_is_said() {
    let operation = |rule, braking| terramechanics::Operation {
        system: system(LETTER_WHEEL, LETTER_SOIL, contact(rule, 0.0).with_braking(braking)),
        model: QUADRATURE_AT_RIM(),
        sinkage: terramechanics::Sinkage::Given(0.02),
    };
    let codes = |rule, braking, ratio: f64| {
        let outcome = Outcome {
            slip: slip(ratio),
            sinkage: 0.02,
            normal: None,
            standstill_normal: None,
            found_curve: None,
            integration_error: 0.0,
            mobilised_share: None,
        };
        let operation = operation(rule, braking);
        let codes = cautions(&operation, &outcome).map(|caution| caution.kind.code);
        codes.filter(|code| *code != "small_wheel").collect::<Vec<_>>()
    };
    let half = PeakRule::HalfSinkage;
    assert_eq!(codes(half, Braking::TwoZone, -0.1), ["peak_rule_set_aside"]);
    for (rule, braking, ratio) in
        [(half, Braking::TwoZone, 0.1), (half, Braking::OneZone, -0.1), (PeakRule::Midpoint, Braking::TwoZone, -0.1)]
    {
        assert!(codes(rule, braking, ratio).is_empty());
    }
}

/// As K → 0, E is ±1. Without cohesion and with Eq. (4), either side of the peak then has the torque of its arc: two zones balance
/// at θ0 = θ1/2, one zone where its shear turns there, (sin θ1 − sin θ1/2)/(θ1/2) = 1 + s.
#[test]
fn a_wheel_on_a_soil_that_yields_at_once_skids_as_a_calculator_says() {
    let soil = SoilParams { shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 1e-7 })), ..LETTER_SOIL };
    let one = system(LETTER_WHEEL, soil, Contact::MIDPOINT);
    for load in [5.0, 80.0, 400.0] {
        let towed = two_zones(one).solve_towed(load).expect("a towed wheel");
        let half = 0.5 * towed.angles.entry;
        let slope = (FRAC_PI_4 - 0.5 * soil.friction_angle).tan();
        assert!(((1.0 + towed.slip.ratio()) / (half.cos() - slope * half.sin()) - 1.0).abs() < 1e-4, "{towed:?}");
        let towed = one.solve_towed(load).expect("a towed wheel");
        let half = 0.5 * towed.angles.entry;
        let expected = ((2.0 * half).sin() - half.sin()) / half - 1.0;
        assert!((towed.slip.ratio() / expected - 1.0).abs() < 1e-2, "{towed:?}, not {expected}");
    }
}

#[test]
fn a_wheel_that_cannot_roll_freely_says_what_was_reached() {
    let slick = SoilParams { friction_angle: 0.0, ..LETTER_SOIL };
    for braking in [Braking::OneZone, Braking::TwoZone] {
        let system = system(LETTER_WHEEL, slick, Contact::MIDPOINT.with_braking(braking));
        assert!(matches!(system.solve_towed(80.0), Err(Error::NotFreeRolling { load: 80.0, torque: 0.0, .. })));
        let system = common::system(LETTER_WHEEL, LETTER_SOIL, Contact::MIDPOINT.with_braking(braking));
        assert!(matches!(system.solve_towed(1e6), Err(Error::LoadBeyondCapacity { load: 1e6, .. })));
        for load in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(system.solve_towed(load), Err(Error::Invalid(_))));
        }
    }
}

#[derive(Debug, Clone, Copy)]
struct Case {
    wheel: WheelParams,
    soil: SoilParams,
    contact: Contact,
    depth_ratio: f64,
}

impl Case {
    fn system(&self, braking: Braking) -> WheelOnSoil {
        system(self.wheel, self.soil, self.contact.with_braking(braking))
    }

    fn two_zones(&self) -> WheelOnSoil {
        self.system(Braking::TwoZone)
    }

    fn sinkage(&self) -> f64 {
        self.depth_ratio * self.wheel.radius
    }
}

prop_compose! {
    fn cases_of(exit: std::ops::RangeInclusive<f64>)(
        (radius, width) in (0.03..0.7, 0.03..0.6),
        lug_height in prop_oneof![Just(0.0), 0.001..0.03],
        cohesion in prop_oneof![Just(0.0), 10.0..5_000.0],
        friction_angle in 0.1..1.0,
        log_shear_modulus in -3.5..-1.0,
        log_modulus in 4.5..7.0,
        base in 0.5..1.5,
        log_depth in -4.0..-0.1,
        exit_ratio in exit,
    ) -> Case {
        let exponent = SinkageExponent { base, slip_gain: 0.0, skid_gain: None };
        Case {
            wheel: WheelParams { radius, width, lug_height, lug_coefficient: 0.5 },
            soil: SoilParams {
                cohesion,
                friction_angle,
                shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 10f64.powf(log_shear_modulus) })),
                pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 10f64.powf(log_modulus), exponent })),
                ..SoilParams::BARE
            },
            contact: contact(PeakRule::Midpoint, exit_ratio).with_circles(Circles::RIM), // as the paper has it
            depth_ratio: 10f64.powf(log_depth),
        }
    }
}

/// Cohesion bears a load on the arc that a wheel with two zones touches at no depth: a little more than that takes little depth.
#[test]
fn a_load_a_little_above_what_cohesion_bears_is_balanced() {
    let shear = ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.08 });
    let soil = SoilParams { cohesion: 1300.0, friction_angle: 0.97, shear: Some(shear), ..LETTER_SOIL };
    let system = two_zones(system(LETTER_WHEEL, soil, contact(PeakRule::Midpoint, -0.67)));
    let rolling = system.rolling(slip(-0.3)).expect("a wheel");
    let Err(Error::LoadTooLight { least, .. }) = QUADRATURE_AT_RIM().solve_sinkage(&rolling, 1e-3) else {
        panic!("cohesion bears a load of its own")
    };
    for share in [1e-6, 1e-4, 1e-2, 1.0] {
        let load = least * (1.0 + share);
        let carried = QUADRATURE_AT_RIM().solve_sinkage(&rolling, load).expect("a balance");
        assert!((carried.forces.normal / load - 1.0).abs() <= SOLVED, "{share}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn the_parting_angle_meets_its_condition(case in cases_of(0.0..=0.0), log_skid in -12.0..0.0) {
        let ratio = -10f64.powf(log_skid);
        let system = case.two_zones();
        let peak = system.rolling(slip(ratio)).expect("a wheel").contact(case.wheel.radius).expect("a contact").angles.peak;
        let slope = (FRAC_PI_4 - 0.5 * case.soil.friction_angle).tan();
        // cos θ0 − 1 − s without cancellation: −s − 2 sin²(θ0/2).
        let condition = -ratio - 2.0 * (0.5 * peak).sin().powi(2) - slope * peak.sin();
        prop_assert!(condition.abs() <= 1e-14 * -ratio, "{condition:e}");
    }

    #[test]
    fn the_soil_is_sheared_forward_ahead_of_the_parting_angle_and_backward_behind(
        case in cases_of(-0.5..=0.0), ratio in -0.999..-1e-6, share in 0.0001..0.9999,
    ) {
        let system = case.two_zones();
        let rolling = system.rolling(slip(ratio)).expect("a wheel");
        let Ok(patch) = rolling.contact(case.sinkage()) else { return Ok(()) };
        let angles = patch.angles;
        let (front, rear) = (angles.peak + share * (angles.entry - angles.peak), angles.exit + share * (angles.peak - angles.exit));
        prop_assert!(patch.shear_displacement(front) > 0.0);
        prop_assert_eq!(patch.shear_displacement(angles.entry), 0.0);
        prop_assert_eq!(patch.shear_displacement(angles.peak), 0.0);
        if rear > -(1.0 + ratio).acos() {
            prop_assert!(patch.shear_displacement(rear) < 0.0);
        }
        // The height of the sine above its chord, as it stands.
        let (sin, chord) = (front.sin(), (angles.entry.sin() - angles.peak.sin()) / (angles.entry - angles.peak));
        let height = sin - angles.peak.sin() - chord * (front - angles.peak);
        let expected = case.wheel.radius / (1.0 + ratio) * height;
        let rounding = 4.0 * f64::EPSILON * case.wheel.radius / (1.0 + ratio) * angles.entry / (1.0 - angles.peak / angles.entry);
        prop_assert!((patch.shear_displacement(front) - expected).abs() <= rounding + ROUNDING * expected, "{expected}");
    }

    #[test]
    fn the_law_for_braking_does_not_touch_a_driving_wheel(case in cases_of(-0.5..=0.0), ratio in 0.0..=1.0) {
        let (one, two) = (case.system(Braking::OneZone), case.two_zones());
        prop_assert_eq!(forces(&one, ratio, case.sinkage()), forces(&two, ratio, case.sinkage()));
    }

    #[test]
    fn without_cohesion_everything_scales_with_the_modulus(case in cases_of(-0.5..=0.0), ratio in -1.0..-1e-6, factor in 0.1..10.0f64) {
        let soft = SoilParams { cohesion: 0.0, ..case.soil };
        let Some(PressureSinkage::Direct(law)) = soft.pressure_sinkage else { unreachable!("cases have a direct law") };
        let firm = SoilParams { pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: factor * law.k_s, ..law })), ..soft };
        let find = |soil| forces(&two_zones(system(case.wheel, soil, case.contact)), ratio, case.sinkage());
        let (Ok(a), Ok(b)) = (find(soft), find(firm)) else { return Ok(()) };
        prop_assert!((factor * a.longitudinal - b.longitudinal).abs() <= ROUNDING * b.longitudinal_scale());
        prop_assert!((factor * a.normal - b.normal).abs() <= ROUNDING * b.normal_scale());
        prop_assert!((factor * a.torque - b.torque).abs() <= ROUNDING * case.wheel.radius * (b.longitudinal_scale() + b.normal_scale()));
    }

    #[test]
    fn every_load_of_a_braking_wheel_has_an_answer_or_a_reason(case in cases_of(-1.0..=0.3), ratio in -1.0..-1e-9, log_load in -3.0..5.0) {
        let system = case.two_zones();
        let rolling = system.rolling(slip(ratio)).expect("a wheel");
        let load = 10f64.powf(log_load);
        match QUADRATURE_AT_RIM().solve_sinkage(&rolling, load) {
            Ok(carried) => {
                prop_assert!(carried.sinkage > 0.0 && carried.sinkage <= case.wheel.radius);
                prop_assert!((carried.forces.normal - load).abs() <= SOLVED * carried.forces.normal_scale().max(load));
                prop_assert_eq!(forces(&system, ratio, carried.sinkage), Ok(carried.forces));
            }
            Err(Error::LoadBeyondCapacity { largest, .. }) => prop_assert!(largest < load),
            Err(Error::LoadTooLight { least, .. }) => prop_assert!(least >= load),
            // So light that the depth under the peak cannot be told from none beside the sinkage it takes.
            Err(Error::LoadNotBalanced { sinkage, .. }) => {
                let beta = FRAC_PI_4 - 0.5 * case.soil.friction_angle;
                let least = case.wheel.radius * (1.0 - (((1.0 + ratio) * beta.cos()).acos() - beta).cos());
                prop_assert!((sinkage / least - 1.0).abs() < 1e-6, "{sinkage} of at least {least}");
            }
            Err(other) => prop_assert!(false, "{other}"),
        }
    }

    #[test]
    fn a_towed_wheel_carries_its_load_without_a_torque_and_resists(case in cases_of(-0.3..=0.0), two in any::<bool>()) {
        let system = case.system(if two { Braking::TwoZone } else { Braking::OneZone });
        let load = forces(&system, 0.0, 0.5 * case.sinkage()).expect("forces of a rolling wheel").normal;
        let towed = match system.solve_towed(load) {
            Ok(towed) => towed,
            Err(Error::LoadBeyondCapacity { .. }) if case.depth_ratio > 0.3 => return Ok(()),
            Err(Error::NotFreeRolling { .. }) if case.depth_ratio > 0.3 => return Ok(()),
            Err(other) => return Err(TestCaseError::fail(other.to_string())),
        };
        prop_assert!((-1.0..0.0).contains(&towed.slip.ratio()));
        prop_assert!((towed.forces.normal / load - 1.0).abs() <= SOLVED);
        prop_assert!(towed.resistance() > 0.0);
        let strength = case.soil.cohesion * case.wheel.width * case.wheel.radius + load;
        prop_assert!(towed.forces.torque.abs() <= SOLVED * system.wheel.shearing_radius() * strength, "{}", towed.forces.torque);
        // Whatever the torque's scale: a little less skid has one forward, a little more one backward.
        let torque = |factor: f64| {
            let rolling = system.rolling(slip((factor * towed.slip.ratio()).max(-1.0))).expect("a wheel");
            QUADRATURE_AT_RIM().solve_sinkage(&rolling, load).map(|carried| carried.forces.torque)
        };
        prop_assert!(torque(1.0 - 1e-5).expect("a balance") > 0.0);
        prop_assert!(torque(1.0 + 1e-5).is_ok_and(|torque| torque < 0.0));
        prop_assert!(towed.balances <= 60, "{}", towed.balances);
    }
}
