//! All three methods against values computed with 30 digits by implementations independent of this crate.

mod common;

use common::{CIRCLES, EDGE_CASES, LUGS, REFERENCE_CASES, cases, model_of, slip, system_of};
use serde_json::Value;
use terramechanics::{Forces, ShearLaw};

const WONG_CASES: &str = include_str!("reference/wong_shear.json");

/// Closed forms: some tens of roundings.
const CLOSED_FORM: f64 = 1e-12;
/// What the quadrature promises, on the scale of the parts.
const QUADRATURE: f64 = 1e-10;
/// A solved sinkage: the quadrature's error and what is left of the balance.
const SOLVED_SINKAGE: f64 = 1e-9;

fn tolerance(method: &str) -> f64 {
    if method == "quadrature" { QUADRATURE } else { CLOSED_FORM }
}

/// Largest deviation relative to the scale on which each quantity is accurate.
///
/// The torque is compared on itself, except where it all but vanishes because E changes sign in the contact: a difference
/// like F_x, it is then only as good as r_s times the scale of F_x.
fn deviation(forces: &Forces, expected: &Value, shearing_radius: f64) -> f64 {
    let value = |name: &str| expected[name].as_f64().expect("a number");
    let parts = &forces.components;
    let longitudinal_scale = value("traction_n").abs() + value("resistance_n").abs();
    let normal_scale = value("normal_support_n").abs() + value("shear_support_n").abs();
    let floor = 1e-3 * shearing_radius * longitudinal_scale;
    let torque_scale = if value("torque_n_m").abs() < floor { 1e3 * floor } else { value("torque_n_m").abs() };
    [
        (forces.longitudinal, "longitudinal_force_n", longitudinal_scale),
        (parts.traction, "traction_n", longitudinal_scale),
        (parts.resistance, "resistance_n", longitudinal_scale),
        (forces.normal, "normal_force_n", normal_scale),
        (parts.normal_support, "normal_support_n", normal_scale),
        (parts.shear_support, "shear_support_n", normal_scale),
        (forces.torque, "torque_n_m", torque_scale),
    ]
    .into_iter()
    .map(|(computed, name, scale)| (computed - value(name)).abs() / scale.max(f64::MIN_POSITIVE))
    .fold(0.0, f64::max)
}

fn check(text: &str, at_least: usize) {
    let cases = cases(text);
    assert!(cases.len() >= at_least, "only {} cases", cases.len());
    let mut solved = 0;
    for (i, case) in cases.iter().enumerate() {
        let (input, expected) = (&case["input"], &case["expected"]);
        let name = format!("case {i} {}", case["name"].as_str().unwrap_or(""));
        let system = system_of(input);
        let rolling = system.rolling(slip(input["slip"].as_f64().expect("a slip"))).expect("a rolling wheel");
        let patch = rolling.contact(input["sinkage_m"].as_f64().expect("a sinkage")).expect("a contact");
        for (angle, field) in
            [(patch.angles.entry, "entry_rad"), (patch.angles.peak, "maximum_stress_rad"), (patch.angles.exit, "exit_rad")]
        {
            let reference = expected["angles"][field].as_f64().expect("an angle");
            assert!((angle - reference).abs() <= CLOSED_FORM * patch.angles.entry, "{name}: {field} {angle}, not {reference}");
        }
        for method in ["quadrature", "linearised", "explicit"] {
            let model = model_of(input, method);
            let forces = model.forces(&patch).expect("forces");
            let off = deviation(&forces, &expected[method], rolling.system.wheel.shearing_radius());
            assert!(off <= tolerance(method), "{name}, {method}: off by {off:e}, estimated {:e}", forces.integration_error);
            if let Some(solution) = expected.get("sinkage_for_load") {
                let load = solution["normal_load_n"].as_f64().expect("a load");
                let reference = solution[method].as_f64().expect("a sinkage");
                let carried = model.solve_sinkage(&rolling, load).expect("a balance");
                let off = (carried.sinkage / reference - 1.0).abs();
                assert!(off <= SOLVED_SINKAGE, "{name}, {method}: sinkage off by {off:e} after {}", carried.iterations);
                solved += 1;
            }
        }
    }
    assert!(solved >= 3 * 10, "only {solved} balances");
}

/// Wong's two shear laws, which the other cases do not have.
#[test]
fn wongs_shear_laws_agree_with_sixty_digits() {
    let mut compared = [0, 0];
    for case in cases(WONG_CASES) {
        let (name, input) = (&case["name"], &case["input"]);
        let system = system_of(input);
        let rolling = system.rolling(slip(input["slip"].as_f64().expect("a slip"))).expect("a rolling wheel");
        let patch = rolling.contact(input["sinkage_m"].as_f64().expect("a sinkage")).expect("a contact");
        let forces = model_of(input, "quadrature").forces(&patch).expect("forces");
        let off = deviation(&forces, &case["expected"]["quadrature"], rolling.system.wheel.shearing_radius());
        assert!(off <= QUADRATURE, "{name}: off by {off:e}, estimated {:e}", forces.integration_error);
        compared[usize::from(matches!(system.soil.shear(), Some(ShearLaw::WongPeak(_))))] += 1;
    }
    assert!(compared.iter().all(|count| *count >= 6), "{compared:?} cases");
}

#[test]
fn sixty_random_cases_agree_with_thirty_digits() {
    check(REFERENCE_CASES, 60);
}

#[test]
fn lugged_wheels_with_their_slip_on_three_circles_agree_with_thirty_digits() {
    check(LUGS, 40);
}

/// Circles, exits and interfaces where the other cases do not go: all three methods of one zone, the quadrature of two.
#[test]
fn wheels_on_other_circles_exits_and_interfaces_agree_with_sixty_digits() {
    let mut compared = 0;
    for case in cases(CIRCLES).iter().filter(|case| case["input"].get("slip_angle_rad").is_none()) {
        let (name, input, expected) = (&case["name"], &case["input"], &case["expected"]);
        let system = system_of(input);
        let rolling = system.rolling(slip(input["slip"].as_f64().expect("a slip"))).expect("a rolling wheel");
        let patch = rolling.contact(input["sinkage_m"].as_f64().expect("a sinkage")).expect("a contact");
        assert_eq!(patch.has_two_zones(), input.get("braking").is_some(), "{name}");
        for method in ["quadrature", "linearised", "explicit"] {
            let Some(expected) = expected.get(method) else { continue };
            let forces = model_of(input, method).forces(&patch).expect("forces");
            let off = deviation(&forces, expected, system.wheel.shearing_radius());
            assert!(off <= tolerance(method), "{name}, {method}: off by {off:e}, estimated {:e}", forces.integration_error);
            compared += 1;
        }
    }
    assert_eq!(compared, 20 * 3 + 4);
}

#[test]
fn cases_at_the_edges_of_the_model_agree_with_thirty_digits() {
    check(EDGE_CASES, 50);
}
