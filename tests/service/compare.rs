//! `POST /v1/compare`.

use serde_json::{Value, json};

use crate::asking::{letter, post, post_for_csv, table, with};

fn comparison(changes: Value) -> Value {
    with(&with(&letter(), json!({"slip": [0.1, 0.3, 0.6]})), changes)
}

#[test]
fn each_series_is_what_the_sweep_gives() {
    for sinkage in [json!({}), json!({"sinkage_m": null, "normal_load_n": 80})] {
        let reply = post("/v1/compare", &comparison(sinkage.clone())).ok();
        assert_eq!(reply["slip"], json!([0.1, 0.3, 0.6]));
        let series = reply["series"].as_array().expect("series");
        assert_eq!(series.len(), 3);
        for (series, method) in series.iter().zip(["quadrature", "linearised", "explicit"]) {
            assert_eq!(series["method"], method);
            let sweep = post("/v1/slip-sweep", &with(&comparison(sinkage.clone()), json!({"method": method}))).ok();
            assert_eq!(series["columns"], sweep["columns"]);
        }
    }
}

#[test]
fn differences_are_those_from_the_first_method() {
    let reply = post("/v1/compare", &comparison(json!({"methods": ["linearised", "quadrature"]}))).ok();
    let column = |series: usize, name: &str| -> Vec<f64> {
        let column = reply["series"][series]["columns"][name].as_array().expect("a column");
        column.iter().map(|value| value.as_f64().expect("a number")).collect()
    };
    for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m", "drawbar_coefficient"] {
        let differences: Vec<f64> = column(1, name).iter().zip(column(0, name)).map(|(a, b)| (a - b).abs()).collect();
        let mean_square = differences.iter().map(|d| d * d).sum::<f64>() / 3.0;
        let stated = |member: &str| reply["series"][1]["difference"][name][member].as_f64().expect("a number");
        assert!((stated("rms") / mean_square.sqrt() - 1.0).abs() < 1e-12);
        assert_eq!(stated("max_abs"), differences.iter().copied().fold(0.0, f64::max));
        assert_eq!(reply["series"][0]["difference"][name]["max_abs"], 0.0);
    }
}

/// The gap that the letter's simplifications leave on its own example: 12 % and 36–45 % of F_z (see the README).
#[test]
fn the_gap_on_the_letters_example_is_the_known_one() {
    let reply = post("/v1/compare", &comparison(json!({}))).ok();
    let normal = reply["series"][0]["columns"]["normal_force_n"][1].as_f64().expect("a force");
    let gap = |series: usize| reply["series"][series]["difference"]["normal_force_n"]["rms"].as_f64().expect("a gap") / normal;
    assert!((0.11..0.13).contains(&gap(1)) && (0.36..0.45).contains(&gap(2)), "{} {}", gap(1), gap(2));
}

#[test]
fn points_without_a_solution_are_left_out_of_the_differences() {
    let changes = json!({"contact": {"rule": "wong_reece", "c1": 0.5, "c2": 1.0}, "slip": [0.1, 0.9]});
    let reply = post("/v1/compare", &comparison(changes)).ok();
    assert!(reply["series"][1]["difference"]["torque_n_m"]["rms"].is_number());
    let details: Vec<&str> =
        reply["warnings"].as_array().expect("warnings").iter().filter_map(|w| w["detail"].as_str()).collect();
    let gaps: Vec<&&str> = details.iter().filter(|detail| detail.contains("no solution")).collect();
    assert_eq!(gaps.len(), 3);
    assert!(gaps[0].starts_with("quadrature: no solution at indices 1"), "{details:?}");
}

#[test]
fn a_table_names_its_columns_by_method() {
    let columns = table(&post_for_csv("/v1/compare", &comparison(json!({"methods": ["explicit", "quadrature"]}))).text);
    let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(columns.len(), 21);
    assert_eq!((names[0], names[1], names[20]), ("slip", "explicit.sinkage_m", "quadrature.tractive_efficiency"));
}

#[test]
fn bad_names_of_methods_are_pointed_at() {
    let faults = |methods: Value| post("/v1/compare", &comparison(json!({"methods": methods}))).pointers();
    assert_eq!(faults(json!(["quadrature", "explict", 3, "quadrature"])), ["/methods"]);
    assert_eq!(faults(json!(["quadrature", "explict", 3])), ["/methods/1", "/methods/2"]);
    assert_eq!(faults(json!(["quadrature", "quadrature"])), ["/methods/1"]);
    assert_eq!(faults(json!([])), ["/methods"]);
    assert_eq!(faults(json!("quadrature")), ["/methods"]);
    let unknown = post("/v1/compare", &comparison(json!({"method": "explicit"}))).fault("/method");
    assert_eq!(unknown, "unknown field; did you mean `methods`?");
}
