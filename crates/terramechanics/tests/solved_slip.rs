//! The slip that gives a pull: the same point comes back, and where no slip gives it, the error has the largest.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, contact, letter, slip, system};
use proptest::prelude::*;
use terramechanics::{
    Braking, Contact, Error, ForceModel, KnownSinkage, Method, Nearest, Operation, PeakRule, Pull, Sinkage, SlipSinkage,
    SoilParams, WheelOnSoil,
};

/// The pull of a slip that was found by the pull: the slip has an error of 1e-13, and the pull of a solved load as much again.
const SOLVED: f64 = 1e-9;

/// An error of 1e-8 of the slip changes a maximum by less than its rounding.
const SUMMIT: f64 = 1e-9;

fn operation(sinkage: Sinkage) -> Operation {
    Operation { system: letter(), model: ForceModel::at_rim(Method::Quadrature), sinkage }
}

fn pull_at(operation: &Operation, ratio: f64) -> f64 {
    operation.at(slip(ratio)).expect("a point").forces.longitudinal
}

/// The ways to a sinkage with which the pull of the letter's wheel rises with slip throughout.
fn sinkages() -> [Sinkage; 3] {
    [Sinkage::Given(0.02), Sinkage::CarryingLoad(80.0), Sinkage::UnderLoad { sinkage: KnownSinkage::Given(0.02), load: 80.0 }]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    #[test]
    // Beyond these slips the shear strength is mobilised to rounding, and one pull belongs to a whole range of slips.
    fn a_pull_leads_back_to_its_slip(ratio in -0.35..0.6f64, cohesion in 0.0..2000.0f64) {
        for sinkage in sinkages() {
            for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
                let soil = SoilParams { cohesion, ..LETTER_SOIL };
                let operation = Operation {
                    system: system(LETTER_WHEEL, soil, Contact::MIDPOINT),
                    model: ForceModel::at_rim(method),
                    sinkage,
                };
                let Ok(point) = operation.at(slip(ratio)) else { continue };
                let solved = operation.solve_slip(Pull::Force(point.forces.longitudinal)).expect("a slip");
                let miss = solved.point.forces.longitudinal - point.forces.longitudinal;
                prop_assert!(miss.abs() <= SOLVED * point.forces.longitudinal_scale(), "{miss} N, {sinkage:?}, {method:?}");
                // Of several slips that give the pull, none is nearer to 0.
                prop_assert!(solved.point.slip.ratio().abs() <= ratio.abs() * (1.0 + 1e-6) + 1e-12, "{solved:?}");
            }
        }
    }
}

#[test]
fn a_pull_that_rises_with_slip_has_one_slip() {
    for sinkage in sinkages() {
        let operation = operation(sinkage);
        for ratio in [-0.7, -0.2, -0.01, 0.0, 1e-4, 0.05, 0.3, 0.8, 1.0] {
            let solved = operation.solve_slip(Pull::Force(pull_at(&operation, ratio))).expect("a slip");
            let off = solved.point.slip.ratio() - ratio;
            // Towards s = 1 the pull is nearly flat, and its rounding moves the slip.
            assert!(off.abs() < 1e-6, "{ratio}: off by {off:e}");
            assert!(solved.evaluations < 60, "{} evaluations", solved.evaluations);
        }
    }
}

#[test]
fn a_coefficient_is_that_of_the_point() {
    let operation = operation(Sinkage::CarryingLoad(80.0));
    let by_force = operation.solve_slip(Pull::Force(12.0)).expect("a slip").point.slip.ratio();
    let by_coefficient = operation.solve_slip(Pull::Coefficient(0.15)).expect("a slip").point.slip.ratio();
    assert!((by_force - by_coefficient).abs() < SOLVED, "{by_force} {by_coefficient}"); // 12 N of 80 N
}

/// With the sinkage of Lyasko's law under a known load the pull has a maximum between rolling and spinning.
fn humped() -> Operation {
    let sinkage = KnownSinkage::FromStatic { static_sinkage: 0.02, law: SlipSinkage::Lyasko };
    operation(Sinkage::UnderLoad { sinkage, load: 80.0 })
}

/// The largest pull by trying a hundred thousand slips.
fn largest(operation: &Operation) -> (f64, f64) {
    let tried = (0..=100_000).map(|i| f64::from(i) / 1e5).map(|ratio| (pull_at(operation, ratio), ratio));
    tried.max_by(|a, b| a.0.total_cmp(&b.0)).expect("a pull")
}

#[test]
fn of_two_slips_the_nearer_to_zero_is_found() {
    let operation = humped();
    let (top, at_top) = largest(&operation);
    assert!(0.0 < at_top && at_top < 1.0, "the pull has a maximum at {at_top}");
    for share in [0.9, 0.99, 0.999_999] {
        let solved = operation.solve_slip(Pull::Force(share * top)).expect("a slip");
        assert!(solved.point.slip.ratio() < at_top, "{share}: {}", solved.point.slip.ratio());
        assert!((solved.point.forces.longitudinal / (share * top) - 1.0).abs() < SOLVED);
    }
}

#[test]
fn beyond_the_maximum_the_error_has_it_and_its_slip() {
    let operation = humped();
    let (top, at_top) = largest(&operation);
    for beyond in [1.000_001, 1.5, 100.0] {
        match operation.solve_slip(Pull::Force(beyond * top)) {
            Err(Error::PullOutOfReach { pull: Pull::Force(asked), reached, slip, nearest: Nearest::Largest }) => {
                assert_eq!(asked, beyond * top);
                assert!((reached / top - 1.0).abs() < SUMMIT, "{reached} against {top}");
                assert!((slip - at_top).abs() < 1e-4, "{slip} against {at_top}");
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn a_pull_below_that_of_the_locked_wheel_is_out_of_reach() {
    let operation = operation(Sinkage::CarryingLoad(80.0));
    let locked = pull_at(&operation, -1.0);
    match operation.solve_slip(Pull::Force(locked - 10.0)) {
        Err(Error::PullOutOfReach { reached, nearest: Nearest::Least, .. }) => assert!(reached <= locked * (1.0 - SOLVED)),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_pull_that_lies_in_a_jump_is_told() {
    // Two zones: at s = 0 the forces jump from one law to the other. Under a load the wheel digs in the more it skids, so no other
    // skid has a pull inside the jump.
    let plain = letter();
    let system = WheelOnSoil { contact: plain.contact.with_braking(Braking::TwoZone), ..plain };
    let operation = Operation { system, model: ForceModel::at_rim(Method::Quadrature), sinkage: Sinkage::CarryingLoad(80.0) };
    let (rolling, braking) = (pull_at(&operation, 0.0), pull_at(&operation, -1e-3));
    assert!(rolling - braking > 1.0, "a jump from {braking} N to {rolling} N");
    let inside = 0.5 * (rolling + braking);
    let refused = operation.solve_slip(Pull::Force(inside));
    assert!(matches!(refused, Err(Error::PullOutOfReach { nearest: Nearest::AtJump, .. })), "{refused:?}");
}

#[test]
fn the_search_goes_on_beside_slips_without_a_contact() {
    // θm = (0.5 + s) θ1 leaves the contact at s = 0.5.
    let rule = PeakRule::WongReece(terramechanics::WongReece { c1: 0.5, c2: 1.0 });
    let system = system(LETTER_WHEEL, LETTER_SOIL, contact(rule, 0.0));
    let operation = Operation { system, model: ForceModel::at_rim(Method::Quadrature), sinkage: Sinkage::Given(0.02) };
    assert!(matches!(operation.at(slip(0.5)), Err(Error::PeakOutsideContact { .. })));
    // 0.4950 lies between the last step of the walk that has a contact and the end of it.
    let pull = pull_at(&operation, 0.495);
    let solved = operation.solve_slip(Pull::Force(pull)).expect("a slip");
    assert!((solved.point.forces.longitudinal / pull - 1.0).abs() < SOLVED);
}

#[test]
fn what_the_model_refuses_at_every_slip_is_said() {
    let deep = operation(Sinkage::Given(0.3));
    assert!(matches!(deep.solve_slip(Pull::Force(1.0)), Err(Error::SinkageOutsideWheel { .. })));
    let operation = operation(Sinkage::Given(0.02));
    let invalid = operation.solve_slip(Pull::Force(f64::NAN));
    assert!(matches!(invalid, Err(Error::Invalid(fault)) if fault.parameter == &Pull::FORCE), "{invalid:?}");
}
