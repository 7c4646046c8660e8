//! `POST /v1/slip-sweep`.

use serde_json::{Value, json};

use crate::asking::{letter, post, post_for_csv, same_but_for_rounding, table, with};

const COLUMNS: [&str; 11] = [
    "slip",
    "sinkage_m",
    "longitudinal_force_n",
    "normal_force_n",
    "torque_n_m",
    "traction_n",
    "resistance_n",
    "normal_support_n",
    "shear_support_n",
    "drawbar_coefficient",
    "tractive_efficiency",
];

fn sweep(changes: Value) -> Value {
    with(&with(&letter(), json!({"slip": {"from": 0, "to": 1, "points": 11}})), changes)
}

#[test]
fn each_row_is_what_forces_gives_at_that_slip() {
    for method in ["quadrature", "linearised", "explicit"] {
        for sinkage in [json!({"sinkage_m": 0.02}), json!({"sinkage_m": null, "normal_load_n": 80})] {
            let changes = with(&sinkage, json!({"method": method, "slip": [-0.3, 0, 0.2, 1]}));
            let reply = post("/v1/slip-sweep", &sweep(changes.clone())).ok();
            assert_eq!(reply["method"], method);
            for (row, slip) in [-0.3, 0.0, 0.2, 1.0].into_iter().enumerate() {
                let forces = post("/v1/forces", &with(&letter(), with(&changes, json!({"slip": slip})))).ok();
                for name in COLUMNS {
                    let single = forces.get(name).unwrap_or(&forces["components"][name]);
                    let found = &reply["columns"][name][row];
                    // The search of a solved row starts from the rows before it, and closed forms take eight rows at a time.
                    let is_exact = method == "quadrature" && sinkage["normal_load_n"].is_null();
                    let same = if is_exact { found == single } else { same_but_for_rounding(found, single) };
                    assert!(same, "{method}, {name} at {slip}: {found} {single}");
                }
            }
        }
    }
}

#[test]
fn a_range_has_both_ends_and_even_steps() {
    let reply = post("/v1/slip-sweep", &sweep(json!({"slip": {"from": -0.5, "to": 0.7, "points": 13}}))).ok();
    let slips: Vec<f64> =
        reply["columns"]["slip"].as_array().expect("slips").iter().map(|slip| slip.as_f64().expect("a slip")).collect();
    assert_eq!((slips.len(), slips[0], slips[12]), (13, -0.5, 0.7));
    assert!(slips.windows(2).all(|pair| (pair[1] - pair[0] - 0.1).abs() < 1e-15));
    let back = post("/v1/slip-sweep", &sweep(json!({"slip": {"from": 1, "to": 0, "points": 3}}))).ok();
    assert_eq!(back["columns"]["slip"], json!([1.0, 0.5, 0.0]));
}

#[test]
fn points_without_a_solution_are_null_and_named() {
    let body =
        sweep(json!({"contact": {"rule": "wong_reece", "c1": 0.5, "c2": 1.0}, "slip": {"from": 0, "to": 1, "points": 11}}));
    let reply = post("/v1/slip-sweep", &body).ok();
    for name in COLUMNS {
        let column = reply["columns"][name].as_array().expect("a column");
        assert_eq!(column.len(), 11);
        for (row, value) in column.iter().enumerate() {
            // θm = (0.5 + s) θ1 leaves the contact at s = 0.5.
            assert_eq!(value.is_null(), row >= 5 && name != "slip", "{name} at {row}");
        }
    }
    let warning = &reply["warnings"][0];
    assert_eq!(warning["code"], "no_solution");
    let detail = warning["detail"].as_str().expect("a detail");
    assert!(detail.starts_with("At rows 5 to 10: no solution") && detail.contains("/contact"), "{detail}");
    assert_eq!((&warning["rows"], &warning["count"]), (&json!([[5, 10]]), &json!(6)));
    // θm = θ1 at s = 0.5: the value has reached the upper end.
    assert_eq!((&warning["pointer"], &warning["unit"]), (&json!("/contact"), &json!("rad")));
    assert_eq!(warning["value"], warning["range"]["upper"]);
    let answer = post_for_csv("/v1/slip-sweep", &body);
    assert_eq!(answer.header("x-warnings"), "no_solution, small_wheel");
    let columns = table(&answer.text);
    assert!(columns[1..].iter().all(|(_, column)| column[5..].iter().all(Option::is_none)));
}

#[test]
fn a_table_has_the_same_numbers() {
    let body = sweep(json!({"slip": {"from": -0.5, "to": 1, "points": 7}}));
    let reply = post("/v1/slip-sweep", &body).ok();
    let columns = table(&post_for_csv("/v1/slip-sweep", &body).text);
    assert_eq!(columns.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), COLUMNS);
    for (name, values) in columns {
        assert_eq!(json!(values), reply["columns"][&name], "{name}");
    }
}

#[test]
fn a_braking_range_is_warned_of_once() {
    let changes = json!({"sinkage_m": null, "static_sinkage_m": 0.01, "slip": {"from": -0.5, "to": 0.5, "points": 5}});
    let answer = post("/v1/slip-sweep", &sweep(changes));
    assert_eq!(answer.warned_of(), ["small_wheel", "slip_sinkage_extrapolated", "normal_force_drifts"]);
    let warning = &answer.ok()["warnings"][1];
    assert!(warning["detail"].as_str().expect("a detail").starts_with("At rows 0 to 1: slip is -0.5 at worst, below 0 "));
    assert_eq!((&warning["rows"], &warning["value"], &warning["unit"]), (&json!([[0, 1]]), &json!(-0.5), &json!("1")));
    assert_eq!((&warning["range"]["value"], &warning["range"]["lower"]), (&json!(-0.5), &json!(0.0)));
}

#[test]
fn every_bad_slip_is_pointed_at() {
    let faults = |slip: Value| post("/v1/slip-sweep", &sweep(json!({"slip": slip}))).pointers();
    assert_eq!(faults(json!([0, 2, "x", 0.5, -3])), ["/slip/1", "/slip/2", "/slip/4"]);
    assert_eq!(faults(json!([0.1])), ["/slip"]);
    assert_eq!(faults(json!(vec![0.1; 10_002])), ["/slip"]);
    assert_eq!(faults(json!({"from": 0, "to": 3, "points": 1, "step": 2})), ["/slip/step", "/slip/to", "/slip/points"]);
    assert_eq!(faults(json!({"from": 0, "to": 1, "points": 2.5})), ["/slip/points"]);
    assert_eq!(faults(json!(0.3)), ["/slip"]);
    assert_eq!(post("/v1/slip-sweep", &with(&letter(), json!({"slip": null}))).pointers(), ["/slip"]);
}
