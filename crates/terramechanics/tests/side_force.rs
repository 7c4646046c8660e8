//! Forces on a wheel that moves at a slip angle: against 60 digits, at their limits, and as properties.

mod common;

use common::{CIRCLES, LETTER_SOIL, LETTER_WHEEL, SIDE_FORCE_CASES, cases, contact, model_of, slip, system, system_of};
use proptest::prelude::*;
use serde_json::Value;
use terramechanics::{
    Braking, Bulldozing, Contact, Error, ForceModel, Forces, Heading, Method, PeakRule, ShearCoupling, SideForce, SideSlip,
    SlipAngle, SoilParams, WheelOnSoil, WheelParams,
};

/// What the quadrature promises.
const QUADRATURE: f64 = 1e-10;
/// Some tens of roundings.
const ROUNDING: f64 = 1e-12;

const COUPLINGS: [ShearCoupling; 2] = [ShearCoupling::Independent, ShearCoupling::Coupled];
const BULLDOZING: [Bulldozing; 2] = [Bulldozing::Full, Bulldozing::Mobilised];

/// The letter's soil, with the weight of a dry sand.
const SAND: SoilParams = SoilParams { unit_weight: Some(15_000.0), ..LETTER_SOIL };
const WEIGHTLESS: SoilParams = LETTER_SOIL;

fn angle(beta: f64) -> SlipAngle {
    SlipAngle::new(beta).expect("a slip angle")
}

fn side_slip(beta: f64, coupling: ShearCoupling) -> SideSlip {
    SideSlip { coupling, ..SideSlip::independent(angle(beta)) }
}

fn forces(system: &WheelOnSoil, ratio: f64, sinkage: f64, side: SideSlip) -> (Forces, SideForce) {
    let forces = common::forces(system, ratio, sinkage, Method::SideSlipping(side));
    (forces, forces.side.expect("a force across"))
}

fn on(soil: SoilParams, ratio: f64, beta: f64, coupling: ShearCoupling) -> (Forces, SideForce) {
    forces(&system(LETTER_WHEEL, soil, Contact::MIDPOINT), ratio, 0.02, side_slip(beta, coupling))
}

#[test]
fn eighteen_cases_and_five_with_lugs_on_other_circles_agree_with_sixty_digits() {
    let lugged = cases(CIRCLES).into_iter().filter(|case| case["input"].get("slip_angle_rad").is_some());
    let cases: Vec<Value> = cases(SIDE_FORCE_CASES).into_iter().chain(lugged).collect();
    assert_eq!(cases.len(), 18 + 5);
    for case in &cases {
        let (input, name) = (&case["input"], &case["name"]);
        let number = |value: &Value| value.as_f64().expect("a number");
        let system = system_of(input);
        let rolling = system.rolling(slip(number(&input["slip"]))).expect("a rolling wheel");
        let patch = rolling.contact(number(&input["sinkage_m"])).expect("a contact");
        for (coupling, word) in [(ShearCoupling::Independent, "independent"), (ShearCoupling::Coupled, "coupled")] {
            for (bulldozing, amount) in [(Bulldozing::Full, "full"), (Bulldozing::Mobilised, "mobilised")] {
                let side = SideSlip { angle: angle(number(&input["slip_angle_rad"])), coupling, bulldozing };
                let model = ForceModel { method: Method::SideSlipping(side), ..model_of(input, "quadrature") };
                let forces = model.forces(&patch).expect("forces");
                let side = forces.side.expect("a force across");
                let expected = &case["expected"][word];
                let across = &expected[amount];
                let x_scale = number(&expected["traction_n"]).abs() + number(&expected["resistance_n"]).abs();
                let z_scale = number(&expected["normal_support_n"]).abs() + number(&expected["shear_support_n"]).abs();
                let torque_scale = rolling.system.wheel.shearing_radius() * x_scale;
                let y_scale = number(&across["lateral_force_n"]).abs();
                let arm = rolling.system.wheel.shearing_radius() * y_scale;
                for (computed, reference, scale) in [
                    (forces.longitudinal, &expected["longitudinal_force_n"], x_scale),
                    (forces.components.traction, &expected["traction_n"], x_scale),
                    (forces.normal, &expected["normal_force_n"], z_scale),
                    (forces.torque, &expected["torque_n_m"], torque_scale),
                    (side.lateral, &across["lateral_force_n"], y_scale),
                    (side.overturning_moment, &across["overturning_moment_n_m"], arm),
                    (side.aligning_moment, &across["aligning_moment_n_m"], arm),
                ] {
                    let off = (computed - number(reference)).abs();
                    let estimate = forces.integration_error;
                    assert!(
                        off <= QUADRATURE * scale,
                        "{name}, {word}, {amount}: {computed}, not {reference}; estimated {estimate:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn stresses_that_are_not_coupled_leave_the_forces_along_the_wheel_as_they_are() {
    let system = system(LETTER_WHEEL, SAND, Contact::MIDPOINT);
    for ratio in [-1.0, -0.3, 0.0, 0.2, 1.0] {
        let plain = common::forces(&system, ratio, 0.02, Method::Quadrature);
        let (sideways, _) = forces(&system, ratio, 0.02, side_slip(0.3, ShearCoupling::Independent));
        let along = |forces: &Forces| (forces.longitudinal, forces.normal, forces.torque, forces.components);
        assert_eq!(along(&sideways), along(&plain), "slip {ratio}");
    }
}

#[test]
fn a_wheel_that_goes_straight_has_no_force_across_and_the_plain_forces_along() {
    for ratio in [-1.0, -0.3, 0.0, 0.2, 1.0] {
        let plain = common::forces(&system(LETTER_WHEEL, SAND, Contact::MIDPOINT), ratio, 0.02, Method::Quadrature);
        for coupling in COUPLINGS {
            let (straight, side) = on(SAND, ratio, 0.0, coupling);
            assert_eq!(
                (straight.longitudinal, straight.normal, straight.torque),
                (plain.longitudinal, plain.normal, plain.torque)
            );
            assert_eq!((side.lateral, side.overturning_moment, side.aligning_moment), (0.0, 0.0, 0.0));
        }
    }
}

/// The first change of F_x with β is of second order, or of first with a layer at the turning of the slip velocity.
#[test]
fn coupled_forces_tend_to_the_plain_ones_as_the_slip_angle_vanishes_also_braking() {
    for ratio in [-0.6, -0.3, -0.05, 0.02, 0.2, 0.9] {
        let plain = common::forces(&system(LETTER_WHEEL, SAND, Contact::MIDPOINT), ratio, 0.02, Method::Quadrature);
        let mut earlier = f64::INFINITY;
        for beta in [1e-2, 1e-4, 1e-6] {
            let (forces, side) = on(WEIGHTLESS, ratio, beta, ShearCoupling::Coupled);
            let off = (forces.longitudinal - plain.longitudinal).abs() / plain.longitudinal_scale();
            assert!(off < earlier && off < 30.0 * beta, "slip {ratio}, β {beta}: off by {off:e}");
            assert!(side.lateral > 0.0 && side.lateral < 2e4 * beta, "slip {ratio}, β {beta}: {}", side.lateral);
            earlier = off.max(QUADRATURE);
        }
    }
}

#[test]
fn the_lateral_force_vanishes_with_the_slip_angle_where_nothing_is_pushed_in_full() {
    for ratio in [-0.3, 0.0, 0.2, 0.9] {
        for beta in [1e-3, 1e-6, 1e-9] {
            let mobilised = SideSlip { bulldozing: Bulldozing::Mobilised, ..side_slip(beta, ShearCoupling::Independent) };
            let (_, side) = forces(&system(LETTER_WHEEL, SAND, Contact::MIDPOINT), ratio, 0.02, mobilised);
            assert!(side.lateral > 0.0 && side.lateral < 1e3 * beta, "{}", side.lateral);
            assert!(side.bulldozing.expect("a weight") > 0.0);
        }
    }
    // As published, the wall is pushed in full however small the angle.
    let pushed = |beta: f64| on(SAND, 0.2, beta, ShearCoupling::Independent).1.bulldozing.expect("a weight");
    assert!(pushed(1e-9) == pushed(0.3) && pushed(1e-9) > 1.0);
}

#[test]
fn a_wheel_that_spins_on_the_spot_does_not_shear_sideways() {
    for coupling in COUPLINGS {
        let (_, side) = on(WEIGHTLESS, 1.0, 0.3, coupling);
        assert_eq!((side.lateral, side.bulldozing), (0.0, None));
    }
}

/// A locked wheel is dragged along its velocity: with one stress along it, F_y/(−F_x) of the shear is tan β on flat ground.
#[test]
fn a_locked_wheel_is_held_against_its_velocity() {
    let flat = 1e-7; // an entry angle of 1e-3
    for beta in [0.1, 0.7, 1.4_f64] {
        let system = system(LETTER_WHEEL, WEIGHTLESS, Contact::MIDPOINT);
        let (forces, side) = forces(&system, -1.0, flat, side_slip(beta, ShearCoupling::Coupled));
        let ratio = -side.shear / forces.components.traction;
        assert!((ratio / beta.tan() - 1.0).abs() < 1e-5, "{ratio}");
    }
}

/// Without cohesion and friction all that is left is the wall: ∫ 2·γ h²/2 (r − h cos θ) dθ, here by Simpson's rule.
#[test]
fn without_friction_the_wall_is_pushed_by_the_weight_alone() {
    let soil = SoilParams { friction_angle: 0.0, ..SAND };
    let (_, side) = on(soil, 0.2, 0.1, ShearCoupling::Independent);
    let (radius, entry) = (0.2, (0.9_f64).acos());
    let wall = |theta: f64| {
        let h = radius * (theta.cos() - 0.9);
        2.0 * 15_000.0 * h * h / 2.0 * (radius - h * theta.cos())
    };
    let steps = 2000;
    let sum: f64 = (0..=steps)
        .map(|i| {
            let weight = if i == 0 || i == steps {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            };
            weight * wall(entry * f64::from(i) / f64::from(steps))
        })
        .sum();
    let expected = sum * entry / f64::from(steps) / 3.0;
    assert!((side.lateral / expected - 1.0).abs() < 1e-11, "{} not {expected}", side.lateral);
}

/// M_z = F_y r sin θm, the published form, takes all of the force at the peak of the stresses.
#[test]
fn the_aligning_moment_is_roughly_the_published_one() {
    for (ratio, beta) in [(0.0, 0.05), (0.2, 0.1), (0.5, 0.3)] {
        let (_, side) = on(WEIGHTLESS, ratio, beta, ShearCoupling::Independent);
        let published = side.lateral * 0.2 * (0.5 * 0.9_f64.acos()).sin();
        assert!((side.aligning_moment / published - 1.0).abs() < 0.3, "{} and {published}", side.aligning_moment);
        assert_eq!(side.overturning_moment, 0.2 * side.lateral);
    }
}

#[test]
fn a_load_is_carried_by_the_coupled_normal_force() {
    let system = system(LETTER_WHEEL, SAND, Contact::MIDPOINT);
    let rolling = system.rolling(slip(0.2)).expect("a rolling wheel");
    let model = ForceModel::at_rim(Method::SideSlipping(side_slip(0.6, ShearCoupling::Coupled)));
    let carried = model.solve_sinkage(&rolling, 80.0).expect("a balance");
    assert!((carried.forces.normal / 80.0 - 1.0).abs() < 1e-11);
    let plain = ForceModel::at_rim(Method::Quadrature).solve_sinkage(&rolling, 80.0).expect("a balance");
    // Less of the shear stress bears upwards, so the wheel sinks deeper.
    assert!(carried.sinkage > plain.sinkage * 1.001);
}

#[test]
fn the_mirror_image_turns_the_aligning_moment_only() {
    let (ahead, side) = on(SAND, 0.2, 0.1, ShearCoupling::Coupled);
    let back = ahead.heading(Heading::Backward).side.expect("a force across");
    assert_eq!((back.lateral, back.overturning_moment), (side.lateral, side.overturning_moment));
    assert_eq!(back.aligning_moment, -side.aligning_moment);
}

#[test]
fn two_zones_take_no_slip_angle_but_go_straight() {
    let contact = Contact::MIDPOINT.with_braking(Braking::TwoZone);
    let zoned = system(LETTER_WHEEL, SAND, contact);
    let forces_at = |ratio: f64, method: Method| {
        let rolling = zoned.rolling(slip(ratio)).expect("a rolling wheel");
        ForceModel::at_rim(method).forces(&rolling.contact(0.02).expect("a contact"))
    };
    for coupling in COUPLINGS {
        let at = |ratio: f64, beta: f64| forces_at(ratio, Method::SideSlipping(side_slip(beta, coupling)));
        assert_eq!(at(-0.1, 0.1), Err(Error::SlipAngleOfTwoZones));
        assert!(at(0.1, 0.1).is_ok(), "a driving wheel has one zone");
        let (straight, plain) = (at(-0.1, 0.0).expect("forces"), forces_at(-0.1, Method::Quadrature).expect("forces"));
        assert_eq!(straight.components, plain.components);
        assert_eq!(straight.side.expect("a force across").lateral, 0.0);
    }
}

#[test]
fn slip_angles_beyond_the_bound_are_refused() {
    for beta in [1.51, -1.51, f64::NAN, f64::INFINITY] {
        assert!(matches!(SlipAngle::new(beta), Err(Error::Invalid(fault)) if *fault.parameter == SlipAngle::ANGLE));
    }
    assert!(SlipAngle::new(SlipAngle::LARGEST).is_ok() && SlipAngle::new(-SlipAngle::LARGEST).is_ok());
}

prop_compose! {
    fn systems()(
        radius in 0.03..0.7, width in 0.03..0.6, lug_height in prop_oneof![Just(0.0), 0.001..0.03],
        cohesion in prop_oneof![Just(0.0), 10.0..5_000.0], friction_angle in 0.05..1.0, log_lateral in -3.0..-1.0,
        unit_weight in proptest::option::of(1e3..3e4), exit in -0.9..=0.1, log_depth in -4.0..0.0,
    ) -> (WheelParams, SoilParams, Contact, f64) {
        let wheel = WheelParams { radius, width, lug_height, lug_coefficient: 0.5 };
        let lateral_shear_modulus = Some(10f64.powf(log_lateral));
        let soil = SoilParams { cohesion, friction_angle, unit_weight, lateral_shear_modulus, ..LETTER_SOIL };
        let depth = radius * 10f64.powf(log_depth);
        (wheel, soil, contact(PeakRule::Midpoint, exit), depth)
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn the_force_across_is_odd_in_the_slip_angle_and_the_forces_along_are_even(
        (wheel, soil, contact, depth) in systems(), ratio in -1.0..=1.0, beta in 0.0..=1.5,
    ) {
        let system = system(wheel, soil, contact);
        for coupling in COUPLINGS {
            for bulldozing in BULLDOZING {
                let at = |beta| forces(&system, ratio, depth, SideSlip { bulldozing, ..side_slip(beta, coupling) });
                let ((along, right), (mirrored, left)) = (at(beta), at(-beta));
                prop_assert_eq!(right.lateral, -left.lateral);
                prop_assert_eq!(right.aligning_moment, -left.aligning_moment);
                prop_assert_eq!(right.overturning_moment, wheel.radius * right.lateral);
                prop_assert_eq!((along.longitudinal, along.torque), (mirrored.longitudinal, mirrored.torque));
                prop_assert!(right.lateral >= 0.0 && along.integration_error < 1e-6, "{:?}", along);
            }
        }
    }

    #[test]
    fn the_force_across_grows_with_the_slip_angle(
        (wheel, soil, contact, depth) in systems(), ratio in -0.9..=0.99, beta in 0.001..1.4,
    ) {
        let system = system(wheel, soil, contact);
        for bulldozing in BULLDOZING {
            let at = |beta| {
                let side = SideSlip { bulldozing, ..side_slip(beta, ShearCoupling::Independent) };
                forces(&system, ratio, depth, side).1.lateral
            };
            prop_assert!(at(beta * 1.05) >= at(beta) * (1.0 - ROUNDING));
        }
    }

    #[test]
    fn the_shear_across_scales_with_the_width_and_the_wall_does_not(
        (wheel, soil, contact, depth) in systems(), ratio in -0.9..=1.0, beta in 0.01..=1.5, factor in 1.1..5.0_f64,
    ) {
        let law = terramechanics::Direct { k_s: 5e5, exponent: common::LETTER_LAW.exponent };
        let soil = SoilParams { pressure_sinkage: Some(terramechanics::PressureSinkage::Direct(law)), ..soil };
        let wider = WheelParams { width: factor * wheel.width, ..wheel };
        for coupling in COUPLINGS {
            let of = |wheel: WheelParams| -> SideForce {
                forces(&system(wheel, soil, contact), ratio, depth, side_slip(beta, coupling)).1
            };
            let (narrow, wide) = (of(wheel), of(wider));
            prop_assert!((wide.shear - factor * narrow.shear).abs() <= ROUNDING * wide.shear);
            prop_assert_eq!(wide.bulldozing, narrow.bulldozing);
        }
    }

    /// |∫τ| ≤ ∫|τ| ≤ ∫ strength: the resultant of the coupled shear never exceeds the strength under the whole contact, which
    /// is what a locked wheel that is dragged without a slip angle mobilises.
    #[test]
    fn the_coupled_shear_never_exceeds_the_strength(
        (wheel, soil, contact, depth) in systems(), ratio in -1.0..=1.0, beta in 0.0..=1.5,
    ) {
        let system = system(wheel, SoilParams { unit_weight: None, ..soil }, contact);
        let (forces_at_angle, side) = forces(&system, ratio, depth, side_slip(beta, ShearCoupling::Coupled));
        let dragged = common::forces(&system, -1.0, depth, Method::Quadrature);
        let along = forces_at_angle.torque / system.wheel.shearing_radius();
        let strength = -dragged.torque / system.wheel.shearing_radius();
        prop_assert!(along.hypot(side.shear) <= strength * (1.0 + 1e-9), "{along} and {} of {strength}", side.shear);
    }
}
