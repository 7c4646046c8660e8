//! `/v1/track` without a soil, what a known load shows of the soil in columns, and the head of every form.

use serde_json::{Value, json};

use crate::asking::{letter, post, query_of, request, send, with};

/// An independent evaluation of linear stresses: σm = 9000 Pa in a contact of θ1 = 0.7 rad at a slip of 0.3 gave this load, torque and
/// pull on a wheel of 0.2 m by 0.1 m.
const LOAD: f64 = 70.459026;
const TORQUE: f64 = 7.0004767;
const PULL: f64 = 11.1630643;

/// The digits to which they were printed.
const PRINTED: f64 = 1e-6;

fn sinkage() -> f64 {
    0.2 * (1.0 - 0.7_f64.cos())
}

fn track(changes: Value) -> Value {
    let body = json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1}, "normal_load_n": LOAD,
        "columns": {"time_s": [0, 1], "slip": [0.3, 0.3], "sinkage_m": [sinkage(), sinkage()], "torque_n_m": [TORQUE, TORQUE]}
    });
    with(&body, changes)
}

#[test]
fn torque_load_and_sinkage_need_no_soil() {
    let answer = post("/v1/track", &track(json!({})));
    let columns = &answer.ok()["columns"];
    let number = |name: &str| columns[name][1].as_f64().unwrap_or_else(|| panic!("no {name} in {columns}"));
    for name in ["longitudinal_force_n", "longitudinal_force_coupled_n"] {
        assert!((number(name) - PULL).abs() < PRINTED, "{name}: {}", number(name));
    }
    assert!((number("normal_force_n") / LOAD - 1.0).abs() < 1e-14 && (number("torque_n_m") / TORQUE - 1.0).abs() < 1e-14);
    assert!((number("drawbar_coefficient") - PULL / LOAD).abs() < PRINTED);
    // F_x v/(T ω) with v/ω = 0.7 · 0.2 m.
    assert!((number("tractive_efficiency") - PULL * 0.14 / TORQUE).abs() < PRINTED);
    assert_eq!(columns["status"], json!(["ok", "ok"]));
    assert!(columns.get("sinkage_modulus").is_none(), "{columns}");
    // On any soil the coupled pull is the same.
    let soil = with(&track(json!({})), json!({"soil": letter()["soil"]}));
    assert_eq!(post("/v1/track", &soil).ok()["columns"]["longitudinal_force_coupled_n"], columns["longitudinal_force_coupled_n"]);
}

#[test]
fn moving_backward_is_the_mirror_image() {
    let moved = |sign: f64| {
        let columns = json!({
            "time_s": [0, 1], "slip": null, "forward_velocity_m_s": [0.14 * sign, 0.14 * sign], "angular_velocity_rad_s": [sign, sign],
            "sinkage_m": [sinkage(), sinkage()], "torque_n_m": [TORQUE * sign, TORQUE * sign]
        });
        post("/v1/track", &track(json!({ "columns": columns }))).ok()["columns"].clone()
    };
    let (ahead, back) = (moved(1.0), moved(-1.0));
    let at = |of: &Value, name: &str| of[name][1].as_f64().expect("a number");
    assert!((at(&ahead, "longitudinal_force_n") - PULL).abs() < PRINTED);
    assert_eq!(at(&back, "longitudinal_force_n"), -at(&ahead, "longitudinal_force_n"));
    assert_eq!(at(&back, "torque_n_m"), -at(&ahead, "torque_n_m"));
    // T ω at 1 rad/s, for a second.
    for of in [&ahead, &back] {
        assert!((at(of, "power_w") - TORQUE).abs() < 1e-14 && (at(of, "energy_j") - TORQUE).abs() < 1e-14);
    }
}

#[test]
fn samples_without_a_torque_have_no_result_and_the_sign_is_told() {
    let columns = json!({"torque_n_m": [null, -TORQUE]});
    let answer = post("/v1/track", &track(json!({ "columns": columns })));
    assert_eq!(answer.ok()["columns"]["status"], json!(["missing_value", "ok"]));
    let codes = answer.warned_of();
    assert!(codes.contains(&"missing_value".to_owned()) && codes.contains(&"torque_against_slip".to_owned()), "{codes:?}");
}

#[test]
fn what_needs_a_soil_says_so() {
    let without_torque = json!({"columns": {"torque_n_m": null}});
    assert!(
        post("/v1/track", &track(without_torque)).fault("/soil").starts_with("is required, unless torque, load and a sinkage")
    );
    assert_eq!(post("/v1/track", &track(json!({"normal_load_n": null}))).pointers(), ["/soil"]);
    let unknown = json!({"columns": {"sinkage_m": null}});
    assert_eq!(post("/v1/track", &track(unknown.clone())).pointers(), ["/soil"]);
    let from_static = with(&unknown, json!({"static_sinkage_m": 0.03}));
    post("/v1/track", &track(from_static)).ok();
    assert_eq!(post("/v1/track", &track(json!({"method": "linearised"}))).pointers(), ["/method"]);
    assert_eq!(post("/v1/track", &track(json!({"braking": "two_zone"}))).pointers(), ["/braking"]);
    assert_eq!(post("/v1/track", &track(json!({"strength": {}}))).pointers(), ["/strength"]);
}

#[test]
fn a_stream_needs_no_soil_either_and_has_the_head() {
    let settings = json!({"wheel": {"radius_m": 0.2, "width_m": 0.1}, "normal_load_n": LOAD, "slip_radius": "lug_tip"});
    let path = format!("/v1/track?{}", query_of(&settings));
    let rows = format!("time_s,slip,sinkage_m,torque_n_m\n0,0.3,{},{TORQUE}\n", sinkage());
    let ask = |accept: &str| send(request("POST", &path, &[("content-type", "text/csv"), ("accept", accept)], rows.clone()));
    let csv = ask("text/csv");
    let mut lines = csv.text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let (names, row) = (lines.next().expect("names"), lines.next().expect("a row"));
    let place = names.iter().position(|name| *name == "longitudinal_force_n").expect("a column");
    assert!((row[place].parse::<f64>().expect("a pull") - PULL).abs() < PRINTED);
    let head = "#setting,shear_displacement_radius,shearing\n#setting,slip_radius,lug_tip\n#setting,normal_stress_from,load\n";
    assert!(csv.text.contains(head), "{}", csv.text);
    let ndjson = ask("application/x-ndjson");
    let last: Value = serde_json::from_str(ndjson.text.lines().last().expect("a line")).expect("JSON");
    assert_eq!(
        (&last["shear_displacement_radius"], &last["slip_radius"], &last["normal_stress_from"]),
        (&json!("shearing"), &json!("lug_tip"), &json!("load"))
    );
}

/// Solving the sinkage for a load and giving both shows the soil's own modulus: k_c/b + k_φ, or ξ as it was sent.
#[test]
fn columns_have_what_the_load_shows_of_the_soil() {
    let modulus = -660.0 / 0.1 + 754_130.0;
    let grains = json!({"soil": {"granular_stiffness_n_m3": 2e6}});
    for (method, changes, name, expected) in [
        ("quadrature", json!({}), "sinkage_modulus", modulus),
        ("linearised", json!({}), "sinkage_modulus", modulus),
        ("resistive_force", grains, "granular_stiffness_n_m3", 2e6),
    ] {
        let base =
            with(&with(&letter(), changes), json!({"method": method, "slip": 0.2, "sinkage_m": null, "normal_load_n": 60}));
        let sinkage = post("/v1/forces", &base).ok()["sinkage_m"].clone();
        let known = with(&base, json!({"sinkage_m": sinkage, "slip": [0.2, 0.2]}));
        let sweep = post("/v1/slip-sweep", &known).ok();
        let compared = post("/v1/compare", &with(&known, json!({"method": null, "methods": [method]}))).ok();
        let columns = json!({"time_s": [0, 1], "slip": [0.2, 0.2], "sinkage_m": [sinkage, sinkage]});
        let samples = json!({"slip": null, "sinkage_m": null, "columns": columns});
        let tracked = post("/v1/track", &with(&known, samples)).ok();
        for columns in [&sweep["columns"], &compared["series"][0]["columns"], &tracked["columns"]] {
            let found = columns[name][1].as_f64().unwrap_or_else(|| panic!("no {name} in {columns}"));
            assert!((found / expected - 1.0).abs() < 1e-9, "{method}: {found} against {expected}");
            let other = if name == "sinkage_modulus" { "granular_stiffness_n_m3" } else { "sinkage_modulus" };
            assert_eq!(columns[other], json!([null, null]), "{method}");
        }
        let solved = post("/v1/slip-sweep", &with(&base, json!({"slip": [0.1, 0.2]}))).ok();
        assert!(solved["columns"].get(name).is_none(), "{method}");
    }
}
