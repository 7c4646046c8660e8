//! A wheel at a slip angle, in `POST /v1/forces` and `POST /v1/slip-sweep`.

use serde_json::{Value, json};

use crate::asking::{Answer, letter, post, post_for_csv, table, with};
use crate::contract::has_shape;
use crate::documents::document;

/// Eighteen cases at sixty digits, by an implementation independent of this one: see the README of the crate's reference values.
const CASES: &str = include_str!("../../crates/terramechanics/tests/reference/side_force_cases.json");
/// What the quadrature promises.
const QUADRATURE: f64 = 1e-10;

const SIDE: [&str; 3] = ["lateral_force_n", "overturning_moment_n_m", "aligning_moment_n_m"];

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} in {value}"))
}

fn sand(changes: Value) -> Value {
    with(&with(&letter(), json!({"soil": {"unit_weight_n_m3": 15_000}, "slip_angle_rad": 0.1})), changes)
}

/// What a result says about the soil beside the wheel.
fn bulldozing_warnings(answer: &Answer) -> Vec<String> {
    answer.warned_of().into_iter().filter(|code| code.starts_with("bulldozing")).collect()
}

#[test]
fn reference_cases_come_back_over_http() {
    let cases: Vec<Value> = serde_json::from_str(CASES).expect("a fixture is JSON");
    assert_eq!(cases.len(), 18);
    for case in &cases {
        for coupling in ["independent", "coupled"] {
            for bulldozing in ["full", "mobilised"] {
                let changes = json!({"shear_coupling": coupling, "bulldozing": bulldozing, "shear_displacement_radius": "rim"});
                let reply = post("/v1/forces", &with(&case["input"], changes)).ok();
                let expected = &case["expected"][coupling];
                let across = &expected[bulldozing];
                let scale = number(across, "lateral_force_n").abs() * number(&reply, "shearing_radius_m").max(1.0);
                for name in SIDE {
                    let off = (number(&reply, name) - number(across, name)).abs();
                    assert!(off <= QUADRATURE * scale, "{}, {coupling}, {bulldozing}: {name} off by {off:e}", case["name"]);
                }
                let scale = number(expected, "traction_n").abs() + number(expected, "resistance_n").abs();
                let off = (number(&reply, "longitudinal_force_n") - number(expected, "longitudinal_force_n")).abs();
                assert!(off <= QUADRATURE * scale, "{}, {coupling}: F_x off by {off:e}", case["name"]);
            }
        }
    }
}

#[test]
fn the_force_across_is_there_only_where_a_slip_angle_was_sent() {
    let document = document();
    let schema =
        |path: &str| document["paths"][path]["post"]["responses"]["200"]["content"]["application/json"]["schema"].clone();
    let plain = post("/v1/forces", &letter()).ok();
    assert!(SIDE.iter().all(|name| plain.get(name).is_none()));
    let answer = post("/v1/forces", &with(&letter(), json!({"slip_angle_rad": 0})));
    assert!(bulldozing_warnings(&answer).is_empty());
    let straight = answer.ok();
    for name in SIDE {
        assert_eq!(number(&straight, name), 0.0);
    }
    assert_eq!(straight["longitudinal_force_n"], plain["longitudinal_force_n"]);
    for body in [letter(), sand(json!({})), sand(json!({"shear_coupling": "coupled", "slip": -0.3}))] {
        has_shape(&document, &schema("/v1/forces"), &post("/v1/forces", &body).ok());
    }
    let sweep = sand(json!({"slip": [0.1, 0.3]}));
    has_shape(&document, &schema("/v1/slip-sweep"), &post("/v1/slip-sweep", &sweep).ok());
}

#[test]
fn only_coupled_stresses_change_the_forces_along_the_wheel() {
    let plain = post("/v1/forces", &letter()).ok();
    for (coupling, same) in [("independent", true), ("coupled", false)] {
        let reply = post("/v1/forces", &sand(json!({"shear_coupling": coupling}))).ok();
        for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m"] {
            assert_eq!(reply[name] == plain[name], same, "{coupling}, {name}");
        }
    }
    let coupled = json!({"shear_coupling": "coupled", "sinkage_m": null, "normal_load_n": 80});
    let carried = post("/v1/forces", &sand(coupled.clone())).ok();
    assert!((number(&carried, "normal_force_n") - 80.0).abs() < 1e-9);
    assert_ne!(
        carried["sinkage_m"],
        post("/v1/forces", &sand(with(&coupled, json!({"shear_coupling": "independent"})))).ok()["sinkage_m"]
    );
}

/// Wong's laws do not take `shear_modulus_m`, which is all the same the default across the wheel where it is there.
#[test]
fn the_modulus_across_is_that_along_unless_another_is_sent() {
    let lateral = |soil: Value| {
        let shear = json!({"shear": {"law": "wong_peak", "peak_displacement_m": 0.02}});
        let reply = post("/v1/forces", &with(&sand(json!({"soil": shear})), json!({"soil": soil}))).ok();
        number(&reply, "lateral_force_n")
    };
    let (along, across) = (json!({"shear_modulus_m": 0.005}), json!({"lateral_shear_modulus_m": 0.005, "shear_modulus_m": null}));
    assert_eq!(lateral(along), lateral(across));
    let own_length = json!({"lateral_shear_modulus_m": 0.02, "shear_modulus_m": null});
    assert_eq!(lateral(json!({"shear_modulus_m": null})), lateral(own_length.clone()));
    assert_ne!(lateral(json!({"shear_modulus_m": 0.005})), lateral(own_length));
}

#[test]
fn the_side_wall_needs_the_unit_weight_and_says_so() {
    let without = post("/v1/forces", &sand(json!({"soil": {"unit_weight_n_m3": null}})));
    assert_eq!(bulldozing_warnings(&without), ["bulldozing_left_out"]);
    let with_weight = post("/v1/forces", &sand(json!({})));
    assert!(bulldozing_warnings(&with_weight).is_empty());
    assert!(number(&with_weight.ok(), "lateral_force_n") > number(&without.ok(), "lateral_force_n"));
    // Reece's law brings a unit weight along.
    let reece = json!({"law": "reece", "k_c": 0, "k_phi": 80, "unit_weight_n_m3": 15_000, "n0": 1});
    let soil = json!({"unit_weight_n_m3": null, "pressure_sinkage": null});
    let body = with(&sand(json!({"soil": soil})), json!({"soil": {"pressure_sinkage": reece}}));
    assert!(bulldozing_warnings(&post("/v1/forces", &body)).is_empty());
}

#[test]
fn a_wall_that_has_hardly_moved_is_warned_of_unless_only_what_is_mobilised_counts() {
    for path in ["/v1/forces", "/v1/slip-sweep"] {
        let slip = if path == "/v1/forces" { json!(0.2) } else { json!([0.0, 0.2]) };
        let little = sand(json!({"slip_angle_rad": 0.001, "slip": slip}));
        let answer = post(path, &little);
        assert_eq!(bulldozing_warnings(&answer), ["bulldozing_not_mobilised"], "{path}");
        let reply = answer.ok();
        let warnings = reply["warnings"].as_array().expect("warnings");
        let warning = warnings.iter().find(|warning| warning["code"] == "bulldozing_not_mobilised").expect("a warning");
        let share = number(&warning["range"], "value");
        assert!(share > 0.0 && share < number(&warning["range"], "lower"), "{path}: {share}");
        let mobilised = post(path, &with(&little, json!({"bulldozing": "mobilised"})));
        assert!(bulldozing_warnings(&mobilised).is_empty(), "{path}");
    }
}

#[test]
fn only_the_rows_of_a_sweep_that_lack_the_motion_are_warned_of() {
    // A wheel that all but spins on the spot hardly moves sideways.
    let sweep = post("/v1/slip-sweep", &sand(json!({"slip_angle_rad": 0.3, "slip": [0.0, 0.1, 0.999]}))).ok();
    let warnings = sweep["warnings"].as_array().expect("warnings");
    let warning = warnings.iter().find(|warning| warning["code"] == "bulldozing_not_mobilised").expect("a warning");
    assert_eq!((&warning["rows"], &warning["count"]), (&json!([[2, 2]]), &json!(1)), "{warning}");
    assert!(warning["detail"].as_str().expect("a detail").starts_with("At row 2: "), "{warning}");
}

#[test]
fn a_slip_angle_with_two_zones_is_a_fault_of_braking() {
    for (path, slip) in [("/v1/forces", json!(-0.1)), ("/v1/forces", json!(0.1)), ("/v1/slip-sweep", json!([-0.1, 0.1]))] {
        let answer = post(path, &sand(json!({"braking": "two_zone", "slip": slip})));
        assert!(answer.fault("/braking").contains("slip angle"), "{path}");
        assert_eq!(answer.pointers(), ["/braking"]);
    }
    // Going straight, there is nothing that two zones would have to take.
    let straight = json!({"braking": "two_zone", "slip": -0.1, "slip_angle_rad": 0});
    let reply = post("/v1/forces", &sand(straight.clone())).ok();
    let plain = post("/v1/forces", &with(&letter(), with(&straight, json!({"slip_angle_rad": null})))).ok();
    assert_eq!(reply["longitudinal_force_n"], plain["longitudinal_force_n"]);
    assert_eq!(number(&reply, "lateral_force_n"), 0.0);
}

#[test]
fn the_sign_is_that_of_the_slip_angle_and_a_wheel_that_rolls_back_is_the_mirror_image() {
    let (right, left) =
        (post("/v1/forces", &sand(json!({}))).ok(), post("/v1/forces", &sand(json!({"slip_angle_rad": -0.1}))).ok());
    assert!(number(&right, "lateral_force_n") > 0.0);
    for name in SIDE {
        assert_eq!(number(&right, name), -number(&left, name));
    }
    let moving = |v: f64, omega: f64| {
        let motion = json!({"slip": null, "forward_velocity_m_s": v, "angular_velocity_rad_s": omega});
        post("/v1/forces", &sand(motion)).ok()
    };
    let (ahead, back) = (moving(0.16, 1.0), moving(-0.16, -1.0));
    assert_eq!(ahead["lateral_force_n"], back["lateral_force_n"]);
    assert_eq!(ahead["overturning_moment_n_m"], back["overturning_moment_n_m"]);
    assert_eq!(number(&ahead, "aligning_moment_n_m"), -number(&back, "aligning_moment_n_m"));
}

#[test]
fn a_sweep_has_the_force_across_as_further_columns() {
    let slips = json!([-0.4, 0, 0.3]);
    for coupling in ["independent", "coupled"] {
        let body = sand(json!({"slip": slips, "shear_coupling": coupling}));
        let reply = post("/v1/slip-sweep", &body).ok();
        for (row, slip) in [-0.4, 0.0, 0.3].into_iter().enumerate() {
            let single = post("/v1/forces", &with(&body, json!({"slip": slip}))).ok();
            for name in SIDE {
                assert_eq!(reply["columns"][name][row], single[name], "{name} at {slip}");
            }
        }
        let columns = table(&post_for_csv("/v1/slip-sweep", &body).text);
        assert_eq!(columns.len(), 14);
        for (name, values) in &columns {
            assert_eq!(json!(values), reply["columns"][name], "{name}");
        }
    }
    let plain = post("/v1/slip-sweep", &with(&letter(), json!({"slip": slips}))).ok();
    assert!(SIDE.iter().all(|name| plain["columns"].get(name).is_none()));
    let row = table(&post_for_csv("/v1/forces", &sand(json!({}))).text);
    assert_eq!(row.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>()[11..], SIDE);
}

#[test]
fn rows_without_a_solution_are_null_across_too() {
    let body = sand(json!({"contact": {"rule": "wong_reece", "c1": 0.5, "c2": 1.0}, "slip": [0.2, 0.7]}));
    let reply = post("/v1/slip-sweep", &body).ok();
    for name in SIDE {
        assert!(reply["columns"][name][0].is_number() && reply["columns"][name][1].is_null());
    }
}

#[test]
fn what_has_no_lateral_force_or_no_meaning_is_pointed_at() {
    let faults = |changes: Value| post("/v1/forces", &sand(changes)).pointers();
    for method in ["linearised", "explicit"] {
        let fault = post("/v1/forces", &sand(json!({"method": method}))).fault("/slip_angle_rad");
        assert!(fault.contains("`quadrature` only"), "{fault}");
        let straight = post("/v1/forces", &sand(json!({"method": method, "slip_angle_rad": 0}))).ok();
        assert!(SIDE.iter().all(|name| straight.get(name).is_none()));
    }
    assert_eq!(faults(json!({"slip_angle_rad": 1.6})), ["/slip_angle_rad"]);
    assert_eq!(faults(json!({"slip_angle_rad": "0.1"})), ["/slip_angle_rad"]);
    assert_eq!(faults(json!({"shear_coupling": "couple", "bulldozing": "fool"})), ["/shear_coupling", "/bulldozing"]);
    for path in ["/v1/compare", "/v1/stress-profile"] {
        let slip = if path == "/v1/compare" { json!([0, 0.1]) } else { json!(0.1) };
        assert_eq!(post(path, &sand(json!({"slip": slip}))).pointers(), ["/slip_angle_rad"], "{path} has no slip angle");
    }
}
