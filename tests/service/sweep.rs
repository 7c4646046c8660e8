//! `POST /v1/sweep`.

use std::time::Duration;

use serde_json::{Value, json};
use terramechanics_server::{Limits, Service};

use crate::asking::{letter, post, post_for_csv, request, same_but_for_rounding, send, send_to, with};

/// A sweep of the letter's wheel.
fn sweep(changes: Value, axes: Value) -> Value {
    json!({"of": "forces", "request": with(&letter(), changes), "axes": axes})
}

/// The columns of an answer.
fn columns(body: &Value) -> Value {
    post("/v1/sweep", body).ok()["columns"].clone()
}

/// What the answer to a body says of a pointer.
fn fault(body: &Value, pointer: &str) -> String {
    post("/v1/sweep", body).fault(pointer)
}

fn with_axes(axes: Value) -> Value {
    sweep(json!({}), axes)
}

#[test]
fn every_row_is_what_forces_gives_for_its_values() {
    let axes = json!([
        {"field": "/wheel/radius_m", "values": [0.1, 0.3]},
        {"field": "/soil/pressure_sinkage/n0", "values": [0.8, 1.0]},
        {"field": "/soil/unit_weight_n_m3", "from": 1e4, "to": 2e4, "points": 2}
    ]);
    let found = columns(&sweep(json!({}), axes));
    let mut row = 0;
    for radius in [0.1, 0.3] {
        for exponent in [0.8, 1.0] {
            for weight in [1e4, 2e4] {
                let changes = json!({
                    "wheel": {"radius_m": radius},
                    "soil": {"pressure_sinkage": {"n0": exponent}, "unit_weight_n_m3": weight}
                });
                let single = post("/v1/forces", &with(&letter(), changes)).ok();
                let at = |name: &str| found[name][row].clone();
                assert_eq!(at("wheel.radius_m"), radius);
                assert_eq!(at("soil.pressure_sinkage.n0"), exponent);
                assert_eq!(at("soil.unit_weight_n_m3"), weight);
                for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m", "drawbar_coefficient", "sinkage_m"] {
                    assert_eq!(at(name), single[name], "{name} of row {row}");
                }
                assert_eq!(at("traction_n"), single["components"]["traction_n"]);
                assert_eq!(at("status"), "ok");
                row += 1;
            }
        }
    }
    assert_eq!(found["slip"].as_array().map(Vec::len), Some(8));
}

#[test]
fn an_axis_over_slip_is_the_slip_sweep() {
    for changes in [
        json!({}),
        json!({"method": "explicit", "sinkage_m": null, "static_sinkage_m": 0.01}),
        json!({"normal_load_n": 80}),
        json!({"slip_angle_rad": 0.1}),
    ] {
        let range = json!({"from": -0.5, "to": 1, "points": 16});
        let slips = post("/v1/slip-sweep", &with(&with(&letter(), changes.clone()), json!({"slip": range}))).ok();
        let axes = json!([with(&json!({"field": "/slip"}), range)]);
        let found = columns(&sweep(with(&changes, json!({"slip": null})), axes));
        let names: Vec<&String> = slips["columns"].as_object().expect("columns").keys().collect();
        assert!(names.len() >= 11);
        for name in names {
            let (found, slips) = (&found[name], &slips["columns"][name]);
            if changes["method"] == "explicit" {
                // The slip sweep takes eight rows of a closed form at a time.
                let rows = found.as_array().expect("rows").iter().zip(slips.as_array().expect("rows"));
                assert!(
                    rows.clone().count() == 16 && rows.clone().all(|(one, other)| same_but_for_rounding(one, other)),
                    "{name}"
                );
            } else {
                assert_eq!(found, slips, "{name} of {changes}");
            }
        }
    }
}

#[test]
fn a_solved_sinkage_over_slip_is_that_of_the_slip_sweep_to_rounding() {
    let changes = json!({"sinkage_m": null, "normal_load_n": 80});
    let range = json!({"from": 0, "to": 1, "points": 11});
    let slips = post("/v1/slip-sweep", &with(&with(&letter(), changes.clone()), json!({"slip": range}))).ok();
    let found = columns(&sweep(changes, json!([with(&json!({"field": "/slip"}), range)])));
    for name in ["sinkage_m", "longitudinal_force_n", "torque_n_m"] {
        for row in 0..11 {
            let [one, other] = [&found, &slips["columns"]].map(|columns| &columns[name][row]);
            assert!(one.is_number() && same_but_for_rounding(one, other), "{name} at {row}: {one} {other}");
        }
    }
}

#[test]
fn equal_ratios_have_both_ends() {
    let axes = json!([{"field": "/soil/cohesion_pa", "from": 1, "to": 10_000, "points": 5, "spacing": "log"}]);
    let found = columns(&with_axes(axes));
    let values: Vec<f64> =
        found["soil.cohesion_pa"].as_array().expect("values").iter().map(|value| value.as_f64().expect("a number")).collect();
    assert_eq!((values[0], values[4]), (1.0, 10_000.0));
    for (i, value) in values.iter().enumerate() {
        assert!((value / 10f64.powi(i as i32) - 1.0).abs() < 1e-12, "{value}");
    }
}

#[test]
fn a_row_without_an_answer_is_null_and_says_why() {
    let axes = json!([{"field": "/sinkage_m", "values": [0.02, 0.5, 0.03]}, {"field": "/wheel/radius_m", "values": [0.2, 0.6]}]);
    let answer = post("/v1/sweep", &with_axes(axes));
    let reply = answer.ok();
    let columns = &reply["columns"];
    assert_eq!(columns["status"], json!(["ok", "ok", "invalid", "ok", "ok", "ok"]));
    assert_eq!(columns["sinkage_m"], json!([0.02, 0.02, 0.5, 0.5, 0.03, 0.03]));
    assert!(columns["torque_n_m"][2].is_null() && columns["torque_n_m"][3].is_f64());
    let warning = reply["warnings"].as_array().expect("warnings").iter().find(|warning| warning["code"] == "invalid_row");
    let warning = warning.expect("a warning of the row");
    assert_eq!((&warning["rows"], &warning["pointer"]), (&json!([[2, 2]]), &json!("/sinkage_m")));
    let said = post("/v1/forces", &with(&letter(), json!({"sinkage_m": 0.5}))).fault("/sinkage_m");
    assert!(warning["detail"].as_str().expect("a detail").contains(&said), "{warning} {said}");

    let rule = json!({"contact": {"rule": "wong_reece", "c1": 0.5, "c2": 1.0}});
    let reply = post("/v1/sweep", &sweep(rule, json!([{"field": "/slip", "values": [0.2, 0.8]}]))).ok();
    assert_eq!(reply["columns"]["status"], json!(["ok", "no_solution"]));
    assert_eq!(reply["columns"]["slip"], json!([0.2, 0.8]));
    assert!(reply["columns"]["sinkage_m"][1].is_null());
    let codes: Vec<&Value> = reply["warnings"].as_array().expect("warnings").iter().map(|warning| &warning["code"]).collect();
    assert!(codes.contains(&&json!("no_solution")), "{codes:?}");
}

#[test]
fn a_table_has_the_same_rows() {
    let body = with_axes(json!([{"field": "/sinkage_m", "values": [0.02, 0.5]}]));
    let text = post_for_csv("/v1/sweep", &body).text;
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with('#')).collect();
    assert!(lines[0].starts_with("sinkage_m,slip,longitudinal_force_n,") && lines[0].ends_with(",status"), "{}", lines[0]);
    assert_eq!(lines.len(), 3);
    assert!(lines[1].starts_with("0.02,0.2,") && lines[1].ends_with(",ok"), "{}", lines[1]);
    assert!(lines[2].starts_with("0.5,,") && lines[2].ends_with(",invalid"), "{}", lines[2]);
}

#[test]
fn a_field_that_cannot_vary_is_told_why() {
    let of = |field: &str| fault(&with_axes(json!([{"field": field, "values": [0.1, 0.2]}])), "/axes/0/field");
    assert_eq!(of("/wheel/raduis_m"), "the request has no field `/wheel/raduis_m`; did you mean `/wheel/radius_m`?");
    assert!(of("/soil/k_c").ends_with("did you mean `/soil/pressure_sinkage/k_c`?"), "{}", of("/soil/k_c"));
    assert_eq!(of("/method"), "must name a number, not a word");
    assert!(of("/wheel").starts_with("must name a number, not an object; its fields are preset, radius_m"));
    assert_eq!(of("/slip/x"), "`/slip` is a number, which has no fields");
    assert!(of("wheel.radius_m").ends_with("did you mean `/wheel/radius_m`?"), "{}", of("wheel.radius_m"));
    assert!(of("wheel.radius").ends_with("; did you mean `/wheel/radius_m`?"), "{}", of("wheel.radius"));
    assert!(of("radius").starts_with("must be the JSON pointer of a field"));
    let body = sweep(json!({"wheel": 5}), json!([{"field": "/wheel/radius_m", "values": [0.1]}]));
    assert_eq!(fault(&body, "/axes/0/field"), "leads nowhere: `/wheel` of the request is a number");
}

#[test]
fn fields_that_exclude_each_other_are_refused() {
    let twice = json!([{"field": "/slip", "values": [0.1]}, {"field": "/slip", "values": [0.2]}]);
    assert_eq!(fault(&with_axes(twice), "/axes/1/field"), "`/slip` is varied twice");
    let axes = json!([{"field": "/sinkage_m", "values": [0.01, 0.02]}, {"field": "/static_sinkage_m", "values": [0.01, 0.02]}]);
    for axis in [0, 1] {
        let said = fault(&with_axes(axes.clone()), &format!("/axes/{axis}/field"));
        assert_eq!(said, "only one of `sinkage_m` and `static_sinkage_m` may be given");
    }
    let body = with_axes(json!([{"field": "/longitudinal_force_n", "values": [1, 2]}]));
    assert!(fault(&body, "/axes/0/field").starts_with("only one of `slip`"));
    // Into an object that is not there: the rest of it is missing.
    let body = with_axes(json!([{"field": "/contact/c1", "values": [0.1, 0.2]}]));
    assert!(fault(&body, "/request/contact/rule").starts_with("is required"));
    let body = with_axes(json!([{"field": "/soil/pressure_sinkage/k_s", "values": [1e5, 2e5]}]));
    assert!(fault(&body, "/axes/0/field").starts_with("`bekker` has no such field"));
}

#[test]
fn what_is_wrong_with_the_request_itself_is_a_fault_of_it() {
    let axes = json!([{"field": "/slip", "values": [0.1, 0.2]}]);
    let body = sweep(json!({"wheel": {"width_m": null}, "methud": "explicit", "sinkage_m": 0.5}), axes.clone());
    let pointers = post("/v1/sweep", &body).pointers();
    assert_eq!(pointers, ["/request/methud", "/request/wheel/width_m"]);
    let body = sweep(json!({"sinkage_m": 0.5}), axes);
    assert!(fault(&body, "/request/sinkage_m").contains("0.2"));
    assert_eq!(post("/v1/sweep", &json!({"of": "forces", "request": [], "axes": []})).pointers(), ["/request", "/axes"]);
    assert_eq!(post("/v1/sweep", &json!({})).pointers(), ["/of", "/request"]);
}

#[test]
fn every_fault_of_an_axis_is_pointed_at() {
    let of = |axis: Value| post("/v1/sweep", &with_axes(json!([with(&json!({"field": "/slip"}), axis)])));
    assert_eq!(of(json!({"from": 0.2, "to": 0.2, "points": 3})).pointers(), ["/axes/0/to"]);
    assert_eq!(of(json!({"from": 0.0, "to": 0.2, "points": 3, "spacing": "log"})).pointers(), ["/axes/0/from"]);
    assert_eq!(of(json!({"from": -0.1, "to": 0.2, "points": 3, "spacing": "log"})).pointers(), ["/axes/0/to"]);
    assert_eq!(of(json!({"from": -2, "to": 3, "points": 1e9})).pointers(), ["/axes/0/points", "/axes/0/from", "/axes/0/to"]);
    assert_eq!(of(json!({"from": 0})).pointers(), ["/axes/0/to", "/axes/0/points"]);
    assert_eq!(of(json!({"from": 0, "to": 1, "points": 2.5})).pointers(), ["/axes/0/points"]);
    assert_eq!(of(json!({"from": "NaN", "to": 1, "points": 2})).pointers(), ["/axes/0/from"]);
    assert_eq!(of(json!({"values": [0.1, 2, "NaN", null]})).pointers(), ["/axes/0/values/2", "/axes/0/values/3"]);
    assert_eq!(of(json!({"values": [0.1, 2, -3]})).pointers(), ["/axes/0/values/1", "/axes/0/values/2"]);
    assert_eq!(of(json!({"values": []})).pointers(), ["/axes/0/values"]);
    assert_eq!(of(json!({"values": [0.1], "from": 0, "points": 3})).pointers(), ["/axes/0/from", "/axes/0/points"]);
    assert_eq!(of(json!({"steps": 3, "values": [0.1]})).pointers(), ["/axes/0/steps"]);
    let axis = |field: &str| json!({"field": field, "from": 0.01, "to": 0.02, "points": 1000});
    let fields = ["/sinkage_m", "/wheel/lug_height_m", "/slip", "/soil/cohesion_pa"];
    let many = json!(fields.map(axis));
    assert_eq!(post("/v1/sweep", &with_axes(many)).pointers(), ["/axes"]);
    let large = json!([axis("/sinkage_m"), axis("/slip"), axis("/soil/cohesion_pa")]);
    assert_eq!(fault(&with_axes(large), "/axes"), "make 1000000000 points; at most 1000000 are computed");
}

/// A sweep in a form that is written row by row.
fn lines(body: &Value, accept: &str) -> Vec<String> {
    let headers = [("content-type", "application/json"), ("accept", accept)];
    let answer = send(request("POST", "/v1/sweep", &headers, body.to_string()));
    assert_eq!(answer.status, 200, "{}", answer.text);
    assert!(answer.header("content-type").starts_with(accept));
    answer.text.lines().map(str::to_owned).collect()
}

#[test]
fn a_stream_has_the_rows_of_the_columns_and_an_end() {
    let body =
        with_axes(json!([{"field": "/slip", "from": 0, "to": 1, "points": 40}, {"field": "/sinkage_m", "values": [0.01, 0.5]}]));
    let reply = post("/v1/sweep", &body).ok();
    let lines = lines(&body, "application/x-ndjson");
    assert_eq!(lines.len(), 81);
    for (row, line) in lines[..80].iter().enumerate() {
        let line: Value = serde_json::from_str(line).expect("JSON");
        for (name, column) in reply["columns"].as_object().expect("columns") {
            assert_eq!(line[name], column[row], "{name} of {row}");
        }
    }
    let end: Value = serde_json::from_str(&lines[80]).expect("JSON");
    assert_eq!((&end["end"], &end["rows"], &end["warnings"]), (&json!(true), &json!(80), &reply["warnings"]));
}

#[test]
fn a_large_grid_is_streamed_and_refused_in_columns() {
    let axes = json!([{"field": "/slip", "from": 0, "to": 1, "points": 101}, {"field": "/sinkage_m", "from": 0.001, "to": 0.1, "points": 1000}]);
    let body = sweep(json!({"method": "explicit"}), axes);
    assert!(fault(&body, "/axes").starts_with("make 101000 points; an answer in JSON has at most 100000 rows"));
    let lines = lines(&body, "text/csv");
    let rows = lines.iter().filter(|line| !line.starts_with('#')).count();
    assert_eq!((rows, lines.last().map(String::as_str)), (101_001, Some("#end,101000")));
}

#[test]
fn a_sweep_beyond_its_price_is_refused_before_the_work() {
    let axes = json!([{"field": "/slip", "from": 0, "to": 1, "points": 100_000}]);
    let heavy = json!({"slip_angle_rad": 0.2, "sinkage_m": null, "normal_load_n": 80});
    let problem = post("/v1/sweep", &sweep(heavy, axes)).problem(422);
    assert_eq!(problem["type"], "/problems/too-costly");
    assert!(problem["detail"].as_str().expect("a detail").contains("60 s is the most"), "{problem}");
}

#[test]
fn a_streamed_sweep_is_held_to_the_limit_that_is_published() {
    // A thousand points under a load cost more than the allowance for stiff contacts, a second.
    let axes = json!([{"field": "/slip", "from": 0, "to": 1, "points": 1000}]);
    let body = sweep(json!({"sinkage_m": null, "normal_load_n": 80}), axes).to_string();
    let limits = Limits { stream_deadline: Duration::from_secs(1), ..Limits::default() };
    let ask = |accept: &str| {
        let headers = [("content-type", "application/json"), ("accept", accept)];
        send_to(Service::new(limits), request("POST", "/v1/sweep", &headers, body.clone()))
    };
    let published = send_to(Service::new(limits), request("GET", "/v1/limits", &[], "")).ok()["price"].clone();
    assert_eq!((&published["stream_limit_s"], &published["limit_s"]), (&json!(1.0), &json!(60.0)));
    let problem = ask("text/csv").problem(422);
    assert_eq!(problem["type"], "/problems/too-costly");
    assert!(problem["detail"].as_str().expect("a detail").contains("1 s is the most"), "{problem}");
    assert!(ask("application/json").ok()["columns"]["status"].as_array().is_some_and(|rows| rows.len() == 1000));
}

fn rover(changes: Value) -> Value {
    let wheel = json!({"radius_m": 0.1, "width_m": 0.06});
    let rover = json!({"mass_kg": 20, "gravity_m_s2": 1.625, "wheels": {"count": 4, "wheel": wheel}, "soil": letter()["soil"]});
    with(&rover, changes)
}

#[test]
fn a_rover_over_a_grid_is_the_rover_at_each_point() {
    let axes =
        json!([{"field": "/wheels/wheel/radius_m", "values": [0.1, 0.15]}, {"field": "/slope_rad", "values": [0, 0.1, 1.2]}]);
    let found = columns(&json!({"of": "vehicle", "request": rover(json!({})), "axes": axes}));
    let mut row = 0;
    for radius in [0.1, 0.15] {
        for slope in [0.0, 0.1, 1.2] {
            let body = rover(json!({"wheels": {"wheel": {"radius_m": radius}}, "slope_rad": slope}));
            let single = post("/v1/vehicle", &body).ok();
            for name in ["slope_rad", "slip", "needed_pull_n", "torque_n_m", "energy_per_metre_j_m", "largest_slope_rad"] {
                assert_eq!(found[name][row], single[name], "{name} of row {row}");
            }
            assert_eq!(found["climbs"][row], if single["climbs"] == true { 1.0 } else { 0.0 });
            assert_eq!(found["status"][row], if slope > 1.0 { "not_climbed" } else { "ok" });
            row += 1;
        }
    }
}

#[test]
fn stations_of_a_rover_vary_by_their_number() {
    let station = |x: f64| json!({"x_m": x, "wheel": {"radius_m": 0.1, "width_m": 0.06}});
    let changes = json!({"wheels": null, "stations": [station(0.3), station(-0.3)], "centre_of_mass": {"x_m": 0}});
    let body = |field: &str| {
        let axes = json!([{"field": field, "values": [0.05, 0.06]}]);
        json!({"of": "vehicle", "request": rover(changes.clone()), "axes": axes})
    };
    let found = columns(&body("/stations/1/wheel/width_m"));
    assert_eq!(found["stations.1.wheel.width_m"], json!([0.05, 0.06]));
    let wide = post("/v1/vehicle", &rover(changes.clone())).ok();
    assert_eq!(found["slip"][1], wide["slip"]);
    assert_eq!(
        fault(&body("/stations/2/wheel/width_m"), "/axes/0/field"),
        "leads nowhere: `/stations` of the request is an array of 2 items"
    );
    let several = json!({"of": "vehicle", "request": rover(json!({"slope_rad": [0, 0.1]})), "axes": [{"field": "/mass_kg", "values": [10]}]});
    assert!(fault(&several, "/request/slope_rad").starts_with("must be one slope here"));
}

#[test]
fn a_value_of_a_preset_varies_by_its_name() {
    let request = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "sinkage_m": 0.02});
    let axes = json!([{"field": "/soil/pressure_sinkage/n0", "values": [0.91, 1.0]}, {"field": "/soil/cohesion_pa", "values": [0, 200]}]);
    let found = columns(&json!({"of": "forces", "request": request, "axes": axes}));
    for (row, (exponent, cohesion)) in [(0.91, 0.0), (0.91, 200.0), (1.0, 0.0), (1.0, 200.0)].into_iter().enumerate() {
        let soil = json!({"cohesion_pa": cohesion, "pressure_sinkage": {"n0": exponent}});
        let single = post("/v1/forces", &with(&letter(), json!({"soil": soil}))).ok();
        assert_eq!(found["torque_n_m"][row], single["torque_n_m"], "row {row}");
    }
}
