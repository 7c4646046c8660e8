//! `POST /v1/uncertainty`: bands, probabilities and sensitivities.

use serde_json::{Value, json};
use terramechanics_uncertainty::{Bounds, Design, Distribution, Inputs, Marginal, Source};

use crate::asking::{letter, post, post_all, post_for_csv, with};

/// A soil whose pull at a known sinkage is linear in cohesion and k_phi: the stresses are, and the angles do not depend on them.
fn firm() -> Value {
    with(&letter(), json!({"soil": {"cohesion_pa": 2000}}))
}

pub(crate) const COHESION: &str = "/soil/cohesion_pa";
pub(crate) const MODULUS: &str = "/soil/pressure_sinkage/k_phi";

fn normal(field: &str, mean: f64, deviation: f64) -> Value {
    json!({"field": field, "distribution": "normal", "mean": mean, "standard_deviation": deviation})
}

/// Normal cohesion and modulus, far from the bounds of both.
pub(crate) fn of_two(changes: Value) -> Value {
    let inputs = [normal(COHESION, 2000.0, 150.0), normal(MODULUS, 754_130.0, 40_000.0)];
    with(&json!({"of": "forces", "request": firm(), "inputs": inputs, "samples": 4096}), changes)
}

pub(crate) fn found(body: &Value) -> Value {
    post("/v1/uncertainty", body).ok()
}

/// The columns of what an answer has of a quantity.
fn of<'a>(answer: &'a Value, list: &str, quantity: &str) -> &'a Value {
    let items = answer[list].as_array().expect("a list");
    &items.iter().find(|item| item["quantity"] == quantity).unwrap_or_else(|| panic!("no {quantity} in {list}"))["columns"]
}

/// The first number of a column.
fn first(columns: &Value, name: &str) -> f64 {
    columns[name][0].as_f64().unwrap_or_else(|| panic!("no {name} in {columns}"))
}

fn pull(changes: Value) -> f64 {
    post("/v1/forces", &with(&firm(), changes)).ok()["longitudinal_force_n"].as_f64().expect("a pull")
}

/// By how much a standard deviation of each input changes the pull.
fn steps() -> [f64; 2] {
    let base = pull(json!({}));
    let stronger = pull(json!({"soil": {"cohesion_pa": 2150}}));
    let stiffer = pull(json!({"soil": {"pressure_sinkage": {"k_phi": 794_130.0}}}));
    [stronger - base, stiffer - base]
}

/// Within five of the errors that are told, which are to be small themselves.
fn assert_close(columns: &Value, name: &str, exact: f64, largest_error: f64) {
    let (value, error) = (first(columns, name), first(columns, &format!("{name}_error")));
    assert!((value - exact).abs() <= 5.0 * error && error <= largest_error, "{name}: {value} ± {error} is not {exact}");
}

/// Random samples, 4096 of them, would have an error of 0.033 deviations for the quantiles at 5 and 95 %.
const QUANTILE_ERROR: f64 = 0.04;

#[test]
fn a_linear_pull_of_normal_inputs_is_normal() {
    let answer = found(&of_two(json!({})));
    let band = of(&answer, "bands", "longitudinal_force_n");
    let (mean, steps) = (pull(json!({})), steps());
    let deviation = steps[0].hypot(steps[1]);
    assert_close(band, "mean", mean, 1e-3 * deviation);
    assert_close(band, "standard_deviation", deviation, 3e-3 * deviation);
    for (name, score) in [("q05", -1.644_854), ("q25", -0.674_490), ("q50", 0.0), ("q75", 0.674_490), ("q95", 1.644_854)] {
        assert_close(band, name, mean + score * deviation, QUANTILE_ERROR * deviation);
    }
    assert_eq!((first(band, "answered"), &answer["status"]["ok"]), (4096.0, &json!([4096.0])));
    for (fields, step) in [(COHESION, steps[0]), (MODULUS, steps[1])] {
        let items = answer["sensitivities"].as_array().expect("sensitivities");
        let is_meant = |item: &&Value| item["quantity"] == "longitudinal_force_n" && item["fields"] == json!([fields]);
        let columns = &items.iter().find(is_meant).expect("a sensitivity")["columns"];
        for name in ["first_order", "total"] {
            assert_close(columns, name, (step / deviation).powi(2), 0.01);
        }
    }
}

#[test]
fn the_probability_of_a_condition_is_that_of_the_distribution() {
    let (mean, steps) = (pull(json!({})), steps());
    // Φ(−1) = 0.158655.
    let limit = mean - steps[0].hypot(steps[1]);
    let conditions = json!([
        {"quantity": "longitudinal_force_n", "below": limit},
        {"quantity": "longitudinal_force_n", "above": limit},
        {"quantity": "slip", "above": 0.6}
    ]);
    let answer = found(&of_two(json!({"conditions": conditions, "sensitivity": false})));
    let columns = |i: usize| &answer["conditions"][i]["columns"];
    assert_close(columns(0), "probability", 0.158_655, 6e-3);
    assert_close(columns(1), "probability", 1.0 - 0.158_655, 6e-3);
    assert_eq!(first(columns(0), "least"), first(columns(0), "most"));
    assert_eq!((first(columns(2), "probability"), first(columns(2), "probability_error")), (0.0, 1.0 / 4096.0));
    assert_eq!((&answer["sensitivities"], &answer["evaluations"]), (&json!([]), &json!(4096)));
}

#[test]
fn correlated_inputs_add_their_covariance_and_have_one_sensitivity() {
    let correlation = json!([[1, 0.7], [0.7, 1]]);
    let answer = found(&of_two(json!({"correlation": correlation, "sensitivity_of": "longitudinal_force_n"})));
    let steps = steps();
    let deviation = (steps[0].powi(2) + steps[1].powi(2) + 2.0 * 0.7 * steps[0] * steps[1]).sqrt();
    assert_close(of(&answer, "bands", "longitudinal_force_n"), "standard_deviation", deviation, 3e-3 * deviation);
    let sensitivities = answer["sensitivities"].as_array().expect("sensitivities");
    assert_eq!(sensitivities.len(), 1);
    assert_eq!(sensitivities[0]["fields"], json!([COHESION, MODULUS]));
    assert_close(&sensitivities[0]["columns"], "first_order", 1.0, 0.02);
}

/// The samples of the same seed, asked one by one.
#[test]
fn bands_are_those_of_single_requests() {
    let bounds = Bounds { lower: 0.0, upper: 1e8 };
    let cohesion = Marginal::new(Distribution::Normal { mean: 300.0, deviation: 300.0 }, bounds).expect("a marginal");
    let slip = Distribution::Triangular { low: 0.1, mode: 0.2, high: 0.6 };
    let slip = Marginal::new(slip, Bounds::NONE).expect("a marginal");
    let inputs = Inputs::new(vec![Source::One(cohesion), Source::One(slip)]).expect("inputs");
    let design = Design::new(inputs, 256, 12).expect("a design");
    let rows: Vec<Vec<f64>> = (0..256).map(|row| design.row(row).expect("a row")).collect();
    let single = |row: &Vec<f64>| with(&firm(), json!({"soil": {"cohesion_pa": row[0]}, "slip": row[1]}));
    let mut pulls: Vec<f64> = post_all("/v1/forces", rows.iter().map(single))
        .iter()
        .map(|reply| reply["longitudinal_force_n"].as_f64().expect("a pull"))
        .collect();
    let answer = found(&json!({
        "of": "forces", "request": with(&letter(), json!({"slip": null})), "seed": 12, "samples": 256, "sensitivity": false,
        "inputs": [
            normal(COHESION, 300.0, 300.0),
            {"field": "/slip", "distribution": "triangular", "low": 0.1, "mode": 0.2, "high": 0.6}
        ]
    }));
    let band = of(&answer, "bands", "longitudinal_force_n");
    let mean = pulls.iter().sum::<f64>() / 256.0;
    let deviation = (pulls.iter().map(|pull| (pull - mean).powi(2)).sum::<f64>() / 256.0).sqrt();
    pulls.sort_by(f64::total_cmp);
    // The sample of rank i stands at (i − 1/2)/256: 5 % of 256 lies between the 13th and the 14th.
    let quantile = 0.7 * pulls[12] + 0.3 * pulls[13];
    for (name, expected) in [("mean", mean), ("standard_deviation", deviation), ("q05", quantile)] {
        assert!((first(band, name) - expected).abs() < 1e-9, "{name}: {} is not {expected}", first(band, name));
    }
}

#[test]
fn the_same_seed_gives_the_same_answer() {
    let answer = |seed: u32| post("/v1/uncertainty", &of_two(json!({"seed": seed, "samples": 256}))).text;
    assert_eq!(answer(3), answer(3));
    assert_ne!(answer(3), answer(4));
}

#[test]
fn a_band_over_an_axis_is_that_of_each_point() {
    let axis = json!({"field": "/slip", "values": [0.1, 0.4]});
    let over = found(&of_two(json!({"samples": 256, "axis": axis, "request": {"slip": null}})));
    assert_eq!(over["axis"], axis);
    for (i, slip) in [0.1, 0.4].into_iter().enumerate() {
        let at = found(&of_two(json!({"samples": 256, "request": {"slip": slip}})));
        for list in ["bands", "sensitivities"] {
            let (one, other) = (of(&over, list, "torque_n_m"), of(&at, list, "torque_n_m"));
            for (name, column) in other.as_object().expect("columns") {
                assert_eq!(one[name][i], column[0], "{name} of {list} at {slip}");
            }
        }
    }
    assert!(over["bands"].as_array().expect("bands").iter().all(|band| band["quantity"] != "slip"));
}

#[test]
fn an_engineer_gives_per_cent_of_a_preset() {
    let answer = found(&json!({
        "of": "forces",
        "request": {"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "normal_load_n": 80, "method": "linearised"},
        "inputs": [
            {"field": "/soil/friction_angle_rad", "distribution": "normal", "relative": 0.1},
            {"field": "/normal_load_n", "distribution": "uniform", "relative": 0.5},
            {"field": "/wheel/radius_m", "distribution": "triangular", "relative": 0.1}
        ],
        "samples": 4096, "sensitivity": false
    }));
    let inputs = answer["inputs"].as_array().expect("inputs");
    let number = |i: usize, name: &str| inputs[i][name].as_f64().expect("a number");
    assert_eq!((number(0, "mean"), number(0, "standard_deviation")), (0.478, 0.1 * 0.478));
    // Uniform from 40 to 120; the triangle from 0.18 to 0.22 has a deviation of 0.02/√6.
    assert!((number(1, "mean") - 80.0).abs() < 1e-12 && (number(1, "standard_deviation") - 80.0 / 12_f64.sqrt()).abs() < 1e-12);
    assert!((number(2, "mean") - 0.2).abs() < 1e-15 && (number(2, "standard_deviation") - 0.02 / 6_f64.sqrt()).abs() < 1e-15);
    let load = of(&answer, "bands", "normal_force_n");
    assert_close(load, "mean", 80.0, 0.1);
    assert_close(load, "q05", 44.0, 0.3);
    assert_close(load, "q95", 116.0, 0.3);
}

#[test]
fn a_tail_beyond_the_bounds_is_cut_off_and_told() {
    let body = json!({
        "of": "forces", "request": letter(), "samples": 4096, "sensitivity": false,
        "inputs": [normal(COHESION, 0.0, 300.0)]
    });
    let answer = found(&body);
    assert_eq!(answer["inputs"][0]["share_cut"], 0.5);
    let warning = answer["warnings"].as_array().expect("warnings").iter().find(|one| one["code"] == "truncated_distribution");
    assert_eq!(warning.expect("a warning")["pointer"], "/inputs/0");
    // Half normal: the mean cohesion is 300 √(2/π), and the pull is linear in it.
    let mean = pull(json!({"soil": {"cohesion_pa": 300.0 * std::f64::consts::FRAC_2_PI.sqrt()}}));
    assert_close(of(&answer, "bands", "longitudinal_force_n"), "mean", mean, 0.01 * mean.abs());
    let fault =
        |input: Value| post("/v1/uncertainty", &with(&body, json!({"inputs": [input]}))).problem(422)["errors"][0].clone();
    let refused = fault(normal(COHESION, -100.0, 50.0));
    assert_eq!(refused["pointer"], "/inputs/0/distribution");
    assert!(refused["detail"].as_str().expect("a detail").contains("too much to cut off"), "{refused}");
    let refused = fault(json!({"field": COHESION, "distribution": "uniform", "low": -1, "high": 1}));
    assert!(refused["detail"].as_str().expect("a detail").starts_with("reaches from -1 to 1"), "{refused}");
}

#[test]
fn samples_without_an_answer_are_counted_and_bound_a_probability() {
    // Sinkages beyond the radius of half the wheels.
    let answer = found(&json!({
        "of": "forces", "request": with(&letter(), json!({"sinkage_m": 0.1})), "samples": 1024,
        "inputs": [{"field": "/wheel/radius_m", "distribution": "uniform", "low": 0.06, "high": 0.14}],
        "conditions": [{"quantity": "longitudinal_force_n", "below": 1e6}]
    }));
    let count = |status: &str| answer["status"][status][0].as_f64().expect("a number");
    assert_eq!((count("ok"), count("invalid")), (512.0, 512.0));
    let condition = &answer["conditions"][0]["columns"];
    assert_eq!((first(condition, "probability"), first(condition, "least"), first(condition, "most")), (1.0, 0.5, 1.0));
    assert_eq!(first(of(&answer, "bands", "longitudinal_force_n"), "answered"), 512.0);
    let codes: Vec<&Value> = answer["warnings"].as_array().expect("warnings").iter().map(|one| &one["code"]).collect();
    assert!(codes.contains(&&json!("samples_unanswered")) && codes.contains(&&json!("invalid_row")), "{codes:?}");
}

#[test]
fn joint_samples_keep_what_holds_between_fields() {
    // The pull rises with both, and where one is large the other is small.
    let samples = |field: &str, values: [f64; 4]| json!({"field": field, "distribution": "samples", "values": values});
    let cohesion = [1000.0, 1500.0, 2000.0, 2500.0];
    let modulus = [800e3, 750e3, 700e3, 650e3];
    let answer = found(&json!({
        "of": "forces", "request": firm(), "samples": 256,
        "inputs": [samples(COHESION, cohesion), samples(MODULUS, modulus)]
    }));
    let of_row = |i: usize| pull(json!({"soil": {"cohesion_pa": cohesion[i], "pressure_sinkage": {"k_phi": modulus[i]}}}));
    let mean = (0..4).map(of_row).sum::<f64>() / 4.0;
    assert!((first(of(&answer, "bands", "longitudinal_force_n"), "mean") - mean).abs() < 1e-9);
    assert_eq!(answer["sensitivities"][0]["fields"], json!([COHESION, MODULUS]));
    assert_eq!(answer["inputs"][0]["mean"], 1750.0);
}

/// A rover whose wheels share its weight climbs while the slip that it needs is within the limit: from a heavier rover on a steeper
/// slope nothing else is asked.
#[test]
fn a_rover_climbs_with_a_probability() {
    let rover = json!({
        "mass_kg": 20, "gravity_m_s2": 1.625, "slope_rad": 0.1, "wheels": {"count": 4, "wheel": {"radius_m": 0.1, "width_m": 0.06}},
        "soil": {"preset": "lunar-apollo-nominal"}, "method": "linearised", "contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.2}
    });
    let largest = post("/v1/vehicle", &rover).ok()["largest_slope_rad"].as_f64().expect("a slope");
    // Of slopes alike within 0.1 rad on both sides of the largest one half is climbed.
    let answer = found(&json!({
        "of": "vehicle", "request": rover, "samples": 256, "sensitivity": false,
        "inputs": [{"field": "/slope_rad", "distribution": "uniform", "low": largest - 0.1, "high": largest + 0.1}],
        "conditions": [{"quantity": "climbs", "above": 0.5}, {"quantity": "slip", "below": 0.6}]
    }));
    let climbs = &answer["conditions"][0]["columns"];
    assert_eq!((first(climbs, "answered"), first(climbs, "probability")), (256.0, 0.5), "{climbs}");
    let slip = &answer["conditions"][1]["columns"];
    assert!(first(slip, "least") <= 0.5 && first(slip, "most") >= 0.5, "{slip}");
    assert_eq!(first(of(&answer, "bands", "largest_slope_rad"), "standard_deviation"), 0.0);
}

#[test]
fn a_table_has_a_row_for_each_value_of_the_axis() {
    let axis = json!({"field": "/slip", "from": 0.1, "to": 0.3, "points": 3});
    let conditions = json!([{"quantity": "longitudinal_force_n", "below": 5}]);
    let body = of_two(json!({"samples": 256, "axis": axis, "conditions": conditions, "request": {"slip": null}}));
    let text = post_for_csv("/v1/uncertainty", &body).text;
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 4);
    let names: Vec<&str> = lines[0].split(',').collect();
    assert_eq!(names[..2], ["slip", "status.ok"]);
    for name in [
        "longitudinal_force_n.q05",
        "longitudinal_force_n.below.5.probability",
        "torque_n_m.soil.pressure_sinkage.k_phi.total_error",
    ] {
        assert!(names.contains(&name), "{name}");
    }
    let json = found(&body);
    let at = names.iter().position(|name| *name == "longitudinal_force_n.q05").expect("a column");
    let cell: f64 = lines[2].split(',').nth(at).expect("a cell").parse().expect("a number");
    assert_eq!(json!(cell), of(&json, "bands", "longitudinal_force_n")["q05"][1]);
}

/// Work is priced before it runs.
#[test]
fn too_much_work_is_refused_by_its_price() {
    let request = json!({"sinkage_m": null, "normal_load_n": 80, "slip_angle_rad": 0.1});
    let problem = post("/v1/uncertainty", &of_two(json!({"request": request, "samples": 16_384}))).problem(422);
    assert!(problem["detail"].as_str().expect("a detail").contains("processor"), "{problem}");
}
