//! What `/v1/optimum` says of a point that is not what was sought, and which questions it refuses.

use serde_json::{Value, json};

use crate::asking::{post, post_for_csv, table, with};
use crate::optimum::{MASS, number, optimum, rover, sought, wheels};

/// The codes of the warnings of an answer.
fn codes(found: &Value) -> Vec<&str> {
    found["warnings"].as_array().expect("warnings").iter().filter_map(|warning| warning["code"].as_str()).collect()
}

/// The column of that name in an answer as a table, and the codes beside it.
fn of_table(body: &Value, names: [&str; 2]) -> ([Vec<Option<f64>>; 2], String) {
    let answer = post_for_csv("/v1/optimum", body);
    let columns = table(&answer.text);
    let column = |name: &str| columns.iter().find(|(known, _)| known == name).unwrap_or_else(|| panic!("no {name}")).1.clone();
    let told = answer.headers.get("x-warnings").map(|codes| codes.to_str().expect("codes").to_owned());
    (names.map(column), told.unwrap_or_default())
}

fn pull_of(least: f64) -> Value {
    json!({"minimise": MASS, "constraints": [{"quantity": "longitudinal_force_n", "at_least": least}]})
}

#[test]
fn a_table_tells_a_point_that_misses_a_constraint_from_one_that_keeps_it() {
    for (least, feasible) in [(40.0, 0.0), (6.0, 1.0)] {
        let body = sought(wheels(), pull_of(least));
        let ([of, converged], told) = of_table(&body, ["feasible", "converged"]);
        assert_eq!((of, converged), (vec![Some(feasible)], vec![Some(1.0)]), "at least {least} N");
        assert_eq!(told.split(", ").any(|code| code == "infeasible"), feasible == 0.0, "{told}");
        let found = optimum(&body);
        assert_eq!((&found["feasible"], codes(&found).contains(&"infeasible")), (&json!(feasible == 1.0), feasible == 0.0));
    }
    let missed = optimum(&sought(wheels(), pull_of(40.0)));
    let by = 40.0 - number(&missed["quantities"]["longitudinal_force_n"]);
    let detail = missed["warnings"][0]["detail"].as_str().expect("a detail");
    assert!(detail.contains(&format!("misses `longitudinal_force_n` at least 40 by {by:.2}")), "{detail} {by}");
}

#[test]
fn a_table_tells_a_search_that_was_not_ended() {
    let body = |evaluations: u32| sought(wheels(), json!({"minimise": "torque_n_m", "evaluations": evaluations}));
    for (evaluations, expected) in [(20, 0.0), (3000, 1.0)] {
        let ([feasible, converged], told) = of_table(&body(evaluations), ["feasible", "converged"]);
        assert_eq!((feasible, converged), (vec![Some(1.0)], vec![Some(expected)]), "{evaluations} evaluations");
        assert_eq!(told.contains("not_converged"), expected == 0.0, "{told}");
        let found = optimum(&body(evaluations));
        assert_eq!((&found["converged"], codes(&found).contains(&"not_converged")), (&json!(expected == 1.0), expected == 0.0));
    }
}

#[test]
fn every_point_of_a_trade_off_says_whether_its_search_ended() {
    let against = json!({"maximise": "longitudinal_force_n", "points": 6});
    let body = sought(wheels(), json!({"minimise": MASS, "against": against, "evaluations": 400}));
    let found = optimum(&body);
    let stops = found["columns"]["stop_reason"].as_array().expect("reasons");
    let ended: Vec<Option<f64>> = stops.iter().map(|stop| Some(if stop == "evaluations" { 0.0 } else { 1.0 })).collect();
    assert!(ended.contains(&Some(0.0)), "{found}");
    let ([feasible, converged], told) = of_table(&body, ["feasible", "converged"]);
    assert_eq!(converged, ended);
    assert!(feasible.iter().all(|mark| *mark == Some(1.0)) && found["feasible"] == true);
    assert!(told.contains("not_converged"), "{told}");
    let unfinished = ended.iter().filter(|mark| **mark == Some(0.0)).count();
    let warning = found["warnings"].as_array().expect("warnings").iter().find(|warning| warning["code"] == "not_converged");
    assert_eq!(warning.expect("a warning")["count"], unfinished);

    // No wheel sinks so little: one point, which misses the constraint.
    let constraints = json!([{"quantity": "sinkage_m", "at_most": 0.0005}]);
    let ([feasible, _], told) = of_table(&with(&body, json!({"constraints": constraints})), ["feasible", "converged"]);
    assert!(feasible == [Some(0.0)] && told.contains("infeasible"), "{feasible:?} {told}");
}

/// The rims of a rover, as light as possible.
fn light_rover(slope: f64, changes: Value) -> Value {
    let variables = json!([
        {"field": "/wheels/wheel/radius_m", "from": 0.05, "to": 0.2},
        {"field": "/wheels/wheel/width_m", "from": 0.03, "to": 0.15}
    ]);
    let request = with(&rover(), json!({"slope_rad": slope}));
    let body = json!({"of": "vehicle", "request": request, "variables": variables, "minimise": "radius_m * width_m"});
    with(&with(&body, json!({"evaluations": 300, "starts": 3})), changes)
}

#[test]
fn a_rover_has_to_climb_its_slope() {
    // The smallest wheels do not climb 0.2 rad, larger ones do.
    let found = optimum(&light_rover(0.2, json!({})));
    assert_eq!((&found["feasible"], number(&found["quantities"]["climbs"])), (&json!(true), 1.0), "{found}");
    assert!(number(&found["quantities"]["largest_slope_rad"]) >= 0.2);
    let constraint = &found["constraints"][0];
    assert_eq!((&constraint["quantity"], &constraint["at_least"]), (&json!("largest_slope_rad - slope_rad"), &json!(0.0)));
    assert!(number(&found["objective"]) > 1.1 * 0.05 * 0.03, "{found}");
    let free = optimum(&light_rover(0.2, json!({"must_climb": false})));
    assert_eq!((&free["feasible"], number(&free["quantities"]["climbs"])), (&json!(true), 0.0));
    assert!((number(&free["objective"]) - 0.05 * 0.03).abs() < 1e-9 && free["constraints"] == json!([]), "{free}");
    assert!(codes(&free).contains(&"not_climbed"), "{free}");
}

#[test]
fn a_slope_that_no_rover_climbs_makes_no_design() {
    let found = optimum(&light_rover(0.7, json!({})));
    assert_eq!((&found["feasible"], number(&found["quantities"]["climbs"])), (&json!(false), 0.0), "{found}");
    let short = number(&found["constraints"][0]["margin"]);
    assert!((number(&found["quantities"]["largest_slope_rad"]) - 0.7 - short).abs() < 1e-12 && short < 0.0);
    let ([feasible, climbs], told) = of_table(&light_rover(0.7, json!({})), ["feasible", "climbs"]);
    assert!(feasible == [Some(0.0)] && climbs == [Some(0.0)] && told.contains("infeasible"), "{told}");
    // What such a rover spends has no value.
    let said = post("/v1/optimum", &light_rover(0.7, json!({"minimise": "energy_per_metre_j_m"}))).fault("/minimise");
    assert!(said.ends_with("that have an answer, because the rover climbs its slope at none of them"), "{said}");
    let body = sought(wheels(), json!({"minimise": "torque_n_m", "must_climb": true}));
    assert_eq!(post("/v1/optimum", &body).fault("/must_climb"), "is for a rover alone, with `of` vehicle");
}

#[test]
fn a_name_that_means_something_else_is_refused() {
    let fault = |name: &str| {
        let variables = json!([{"field": "/wheel/radius_m", "from": 0.05, "to": 0.2, "name": name}, wheels()[1]]);
        post("/v1/optimum", &sought(variables, json!({"minimise": "torque_n_m"}))).fault("/variables/0/name")
    };
    for (name, meaning) in [
        ("pi", "a constant of formulas"),
        ("sqrt", "a function of formulas"),
        ("min", "a function of formulas"),
        ("torque_n_m", "a quantity of the answer"),
        ("slip", "a quantity of the answer"),
    ] {
        assert_eq!(fault(name), format!("`{name}` is {meaning}; give the variable another `name`"));
    }
    // A slip that varies is the slip of the answer, and stands once in the list of names.
    let request = json!({"wheel": {"radius_m": 0.1, "width_m": 0.1}, "soil": {"preset": "letter-sand"}, "normal_load_n": 60});
    let body = |goal: &str| {
        let variables = json!([{"field": "/slip", "from": 0, "to": 0.9}]);
        json!({"of": "forces", "request": request, "variables": variables, "minimise": goal})
    };
    assert!((value_of_slip(&optimum(&body("(slip - 0.4)^2"))) - 0.4).abs() < 1e-3);
    let said = post("/v1/optimum", &body("colour")).fault("/minimise");
    assert_eq!(said.split([' ', ',']).filter(|name| *name == "slip").count(), 1, "{said}");
    assert!(said.ends_with(". A field that does not vary stands as its number"), "{said}");
}

fn value_of_slip(found: &Value) -> f64 {
    number(&found["variables"][0]["value"])
}

#[test]
fn a_formula_without_a_value_is_blamed_itself() {
    let fault = |changes: Value, pointer: &str| {
        let body = sought(wheels(), with(&json!({"minimise": "torque_n_m", "evaluations": 50}), changes));
        post("/v1/optimum", &body).fault(pointer)
    };
    let said = fault(json!({"minimise": "sqrt(-1 - radius_m)"}), "/minimise");
    assert!(said.starts_with("`sqrt(-1 - radius_m)` has no finite value at any of the "), "{said}");
    let said = fault(json!({"constraints": [{"quantity": "radius_m / 0", "at_most": 1}]}), "/constraints/0/quantity");
    assert!(said.starts_with("`radius_m / 0` has no finite value"), "{said}");
    let said = fault(json!({"against": {"maximise": "ln(-width_m)"}}), "/against/maximise");
    assert!(said.starts_with("`ln(-width_m)` has no finite value"), "{said}");
    // Each has values, but on different sides of a radius of 0.1 m.
    let constraints = json!([{"quantity": "sqrt(radius_m - 0.1)", "at_least": 0}]);
    let said = fault(json!({"minimise": "sqrt(0.1 - radius_m)", "constraints": constraints}), "/minimise");
    assert!(said.contains("but the other quantities have none there"), "{said}");
}

#[test]
fn limits_that_contradict_each_other_are_refused() {
    let fault = |constraints: Value, pointer: &str| {
        post("/v1/optimum", &sought(wheels(), json!({"minimise": MASS, "constraints": constraints}))).fault(pointer)
    };
    let one = json!([{"quantity": "sinkage_m", "at_least": 0.05, "at_most": 0.01}]);
    assert_eq!(fault(one, "/constraints/0/at_most"), "must not be below `at_least`, 0.05");
    let two = json!([{"quantity": "sinkage_m", "at_most": 0.01}, {"quantity": "sinkage_m", "at_least": 0.05}]);
    assert_eq!(fault(two, "/constraints/1/at_least"), "must not be above `at_most` of the same quantity, 0.01");
    // Equal limits ask for that value.
    let equal = json!([{"quantity": "sinkage_m", "at_least": 0.02, "at_most": 0.02}]);
    let found = optimum(&sought(wheels(), json!({"minimise": MASS, "constraints": equal})));
    assert!(found["feasible"] == false || (number(&found["quantities"]["sinkage_m"]) - 0.02).abs() < 1e-9, "{found}");
}

#[test]
fn a_whole_number_is_not_searched() {
    let body = json!({
        "of": "vehicle",
        "request": {
            "mass_kg": 20, "gravity_m_s2": 1.62, "soil": {"preset": "lunar-apollo-nominal"}, "slope_rad": 0.1,
            "wheels": {"count": 4, "wheel": {"radius_m": 0.1, "width_m": 0.06}}
        },
        "variables": [{"field": "/wheels/count", "from": 4, "to": 6}], "minimise": "energy_per_metre_j_m"
    });
    assert!(post("/v1/optimum", &body).fault("/variables/0/field").contains("whole number"));
}
