//! `POST /v1/vehicle`.

use serde_json::{Value, json};

use crate::asking::{get, letter, post, post_for_csv, table, with};

/// Solved slips and loads.
const SOLVED: f64 = 1e-9;

/// The rover of a peer on JSC-1A, of 20 kg on the Moon, with `changes`.
fn peer(changes: Value) -> Value {
    let rover = json!({
        "mass_kg": 20, "gravity_m_s2": 1.625,
        "wheels": {"count": 4, "wheel": {"radius_m": 0.1, "width_m": 0.06}},
        "soil": {
            "cohesion_pa": 1000, "friction_angle_rad": 45f64.to_radians(), "shear_modulus_m": 0.018,
            "pressure_sinkage": {"law": "bekker", "k_c": 1400, "k_phi": 820e3, "n0": 1}
        },
        "contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.2}
    });
    with(&rover, changes)
}

/// The same on six stations with a centre of mass.
fn on_stations(changes: Value) -> Value {
    let wheel = json!({"radius_m": 0.1, "width_m": 0.06});
    let station = |x: f64| json!({"x_m": x, "wheel": wheel});
    let stations: Vec<Value> = [0.4, 0.4, 0.0, 0.0, -0.5, -0.5].map(station).to_vec();
    let statics = json!({"wheels": null, "stations": stations, "centre_of_mass": {"x_m": 0.05, "height_m": 0.2}});
    with(&with(&peer(json!({})), statics), changes)
}

fn number(of: &Value, name: &str) -> f64 {
    of[name].as_f64().unwrap_or_else(|| panic!("no {name} in {of}"))
}

fn numbers(of: &Value) -> Vec<Option<f64>> {
    of.as_array().expect("a column").iter().map(Value::as_f64).collect()
}

#[test]
fn a_peers_rovers_climb_and_slip_as_its_own_function_says() {
    for (mass, degrees) in [(10, 23.1400), (20, 21.4820), (40, 20.0097)] {
        let reply = post("/v1/vehicle", &peer(json!({"mass_kg": mass}))).ok();
        let largest = number(&reply, "largest_slope_rad").to_degrees();
        assert!((largest - degrees).abs() <= 5e-5, "{mass} kg: {largest}");
    }
    let slopes = [0f64, 5.0, 10.0, 15.0, 20.0].map(f64::to_radians);
    let reply = post("/v1/vehicle", &peer(json!({"slope_rad": slopes}))).ok();
    let slips = numbers(&reply["columns"]["slip"]);
    for (slip, expected) in slips.iter().zip([0.10106, 0.18191, 0.27747, 0.39478, 0.54583]) {
        assert!((slip.expect("a slip") - expected).abs() <= 5e-6, "{slip:?} against {expected}");
    }
    assert_eq!(numbers(&reply["columns"]["climbs"]), [Some(1.0); 5]);
}

#[test]
fn one_slope_has_every_wheel_and_all_sums_hold() {
    for (changes, count) in [(peer(json!({})), 4), (on_stations(json!({})), 6), (on_stations(json!({"rut": true})), 6)] {
        let body = with(&changes, json!({"slope_rad": 0.15, "hitch_pull_n": 0.5, "forward_velocity_m_s": 0.05}));
        let reply = post("/v1/vehicle", &body).ok();
        let wheels = reply["wheels"].as_array().expect("wheels");
        assert_eq!(wheels.len(), count);
        let sum = |name: &str| wheels.iter().map(|wheel| number(wheel, name)).sum::<f64>();
        let weight = 20.0 * 1.625;
        assert!((sum("normal_load_n") / (weight * 0.15f64.cos()) - 1.0).abs() < 1e-13);
        assert!((number(&reply, "needed_pull_n") - (weight * 0.15f64.sin() + 0.5)).abs() < 1e-13);
        assert!((sum("longitudinal_force_n") / number(&reply, "needed_pull_n") - 1.0).abs() < SOLVED);
        for name in ["longitudinal_force_n", "torque_n_m", "energy_per_metre_j_m", "power_w"] {
            assert!((sum(name) / number(&reply, name) - 1.0).abs() < 1e-13, "{name}");
        }
        // By hand: T ω/v with v/ω = 0.1 m (1 − s) for every wheel.
        let travel = 0.1 * (1.0 - number(&reply, "slip"));
        assert!((number(&reply, "energy_per_metre_j_m") / (number(&reply, "torque_n_m") / travel) - 1.0).abs() < 1e-13);
        assert!((number(&reply, "power_w") / (0.05 * number(&reply, "energy_per_metre_j_m")) - 1.0).abs() < 1e-13);
        assert!((number(&reply, "specific_resistance") / (number(&reply, "energy_per_metre_j_m") / weight) - 1.0).abs() < 1e-13);
        assert_eq!(reply["climbs"], true);
        let moment: f64 = wheels.iter().filter_map(|wheel| Some(wheel["x_m"].as_f64()? * number(wheel, "normal_load_n"))).sum();
        if reply["loads_from"] == "statics" {
            assert!((moment - weight * (0.15f64.cos() * 0.05 - 0.15f64.sin() * 0.2)).abs() < 1e-12 * weight);
        }
    }
}

#[test]
fn a_wheel_is_the_one_of_the_forces() {
    let reply = post("/v1/vehicle", &peer(json!({"slope_rad": 0.1}))).ok();
    let wheel = &reply["wheels"][0];
    let point = json!({
        "wheel": {"radius_m": 0.1, "width_m": 0.06}, "soil": peer(json!({}))["soil"], "contact": peer(json!({}))["contact"],
        "slip": reply["slip"], "normal_load_n": wheel["normal_load_n"]
    });
    let forces = post("/v1/forces", &point).ok();
    for name in ["sinkage_m", "longitudinal_force_n", "torque_n_m", "drawbar_coefficient"] {
        assert_eq!(forces[name], wheel[name], "{name}");
    }
}

#[test]
fn slopes_that_are_not_climbed_are_gaps() {
    let answer = post("/v1/vehicle", &peer(json!({"slope_rad": {"from": 0.2, "to": 0.8, "points": 4}})));
    let reply = answer.ok();
    let slips = numbers(&reply["columns"]["slip"]);
    assert!(slips[0].expect("a slip") < 0.6 && slips[1].expect("a slip") > 0.6 && slips[2..] == [None, None], "{slips:?}");
    assert_eq!(numbers(&reply["columns"]["climbs"]), [Some(1.0), Some(0.0), Some(0.0), Some(0.0)]);
    assert_eq!(numbers(&reply["columns"]["slope_rad"]), [Some(0.2), Some(0.4), Some(0.6), Some(0.8)]);
    let warning = |code: &str| reply["warnings"].as_array().expect("warnings").iter().find(|of| of["code"] == code).cloned();
    let gap = warning("not_climbed").expect("a warning");
    assert_eq!(gap["rows"], json!([[2, 3]]));
    assert!((number(&gap, "value") - 32.5 * 0.6f64.sin()).abs() < 1e-12, "{gap}");
    assert!(number(&gap["range"], "upper") < number(&gap, "value"), "{gap}");
    assert_eq!(warning("slip_beyond_limit").expect("a warning")["rows"], json!([[1, 1]]));

    let one = post("/v1/vehicle", &peer(json!({"slope_rad": 0.8})));
    assert_eq!(one.ok()["climbs"], false);
    assert!(one.ok()["slip"].is_null() && one.ok()["torque_n_m"].is_null());
    assert_eq!(one.ok()["wheels"], json!([]));
    assert!(one.warned_of().contains(&"not_climbed".to_owned()));
}

#[test]
fn a_table_has_the_same_columns() {
    let body = peer(json!({"slope_rad": [0, 0.1, 0.7]}));
    let reply = post("/v1/vehicle", &body).ok();
    let columns = table(&post_for_csv("/v1/vehicle", &body).text);
    assert_eq!(columns.len(), reply["columns"].as_object().expect("columns").len());
    for (name, values) in &columns {
        assert_eq!(values, &numbers(&reply["columns"][name]), "{name}");
    }
    let one = table(&post_for_csv("/v1/vehicle", &peer(json!({"slope_rad": 0.1}))).text);
    for (name, values) in &one {
        assert_eq!(values.first(), columns.iter().find(|(known, _)| known == name).expect("a column").1.get(1), "{name}");
    }
}

#[test]
fn level_ground_is_the_default_and_the_slip_limit_moves_the_largest_slope() {
    assert_eq!(
        post("/v1/vehicle", &peer(json!({}))).ok(),
        post("/v1/vehicle", &peer(json!({"slope_rad": 0, "slip_limit": 0.6}))).ok()
    );
    let largest = |limit: f64| number(&post("/v1/vehicle", &peer(json!({"slip_limit": limit}))).ok(), "largest_slope_rad");
    assert!(largest(0.3) < largest(0.6) && largest(0.6) < largest(0.9));
    let at_limit = post("/v1/vehicle", &peer(json!({"slip_limit": 0.3, "slope_rad": largest(0.3)}))).ok();
    assert!((number(&at_limit, "slip") - 0.3).abs() < 1e-8);
}

#[test]
fn a_wheel_that_lifts_off_is_told() {
    let top_heavy = json!({"centre_of_mass": {"x_m": 0.0, "height_m": 2}});
    let answer = post("/v1/vehicle", &on_stations(with(&top_heavy, json!({"slope_rad": 0.35}))));
    assert_eq!(answer.pointers(), ["/centre_of_mass"]);
    assert!(number(&answer.problem(422)["errors"][0], "value") < 0.0);
    let several = post("/v1/vehicle", &on_stations(with(&top_heavy, json!({"slope_rad": [0, 0.35]}))));
    let codes = several.warned_of();
    assert!(codes.contains(&"wheel_lifts".to_owned()) && codes.contains(&"climb_ends_by_wheel".to_owned()), "{codes:?}");
    assert_eq!(numbers(&several.ok()["columns"]["slip"])[1], None);
}

#[test]
fn stations_may_have_soils_of_their_own() {
    let soft = with(&peer(json!({}))["soil"], json!({"pressure_sinkage": {"k_phi": 200e3}}));
    let mut body = on_stations(json!({}));
    body["stations"][4]["soil"] = soft.clone();
    let wheels = post("/v1/vehicle", &body).ok()["wheels"].clone();
    assert!(number(&wheels[4], "sinkage_m") > 1.2 * number(&wheels[5], "sinkage_m"));
    for station in 0..6 {
        body["stations"][station]["soil"] = soft.clone();
    }
    let without = with(&body, json!({"soil": null}));
    let shared = post("/v1/vehicle", &body);
    assert!(shared.warned_of().contains(&"not_used".to_owned()), "no wheel stands on it");
    let but_told = |answer: Value| with(&answer, json!({"warnings": null}));
    assert_eq!(but_told(post("/v1/vehicle", &without).ok()), but_told(shared.ok()));
    body["stations"][3]["soil"] = Value::Null;
    assert_eq!(
        post("/v1/vehicle", &with(&body, json!({"soil": null}))).fault("/soil"),
        "is required, or a `soil` in every station"
    );
    // What the model refuses of a soil is told of that soil.
    let strange = with(&soft, json!({"pressure_sinkage": {"k_c": -1e6}}));
    body["stations"][3]["soil"] = strange;
    assert_eq!(post("/v1/vehicle", &body).pointers(), ["/stations/3/soil/pressure_sinkage"]);
}

#[test]
fn gravity_is_that_of_the_soil_unless_given() {
    let without = peer(json!({"gravity_m_s2": null}));
    assert_eq!(number(&post("/v1/vehicle", &without).ok(), "gravity_m_s2"), 9.80665);
    let moon = peer(json!({}));
    assert!(post("/v1/vehicle", &moon).warned_of().contains(&"low_gravity".to_owned()));
}

/// A rut is taken to be as wide as the wheel in it and of its soil; where that is not so it is told, and where.
#[test]
fn ruts_of_other_wheels_and_soils_are_told() {
    let told = |body: &Value, code: &str| {
        let answer = post("/v1/vehicle", body).ok();
        let warnings = answer["warnings"].as_array().expect("warnings").clone();
        warnings.into_iter().find(|warning| warning["code"] == code)
    };
    let mut body = on_stations(json!({"rut": true}));
    for code in ["rut_too_narrow", "rut_of_other_soil"] {
        assert_eq!(told(&body, code), None);
    }
    body["stations"][4]["wheel"]["width_m"] = json!(0.09);
    let narrow = told(&body, "rut_too_narrow").expect("a wider follower");
    assert_eq!((&narrow["names"], number(&narrow, "value")), (&json!(["/stations/4"]), 0.09 / 0.06));
    assert_eq!(number(&narrow["range"], "upper"), 1.0);
    assert_eq!(told(&body, "rut_of_other_soil"), None);
    let apart = with(&body, json!({"rut": false}));
    assert_eq!(told(&apart, "rut_too_narrow"), None);
    // A narrower follower fits, and so does one of another radius.
    body["stations"][4]["wheel"] = json!({"radius_m": 0.12, "width_m": 0.05});
    assert_eq!(told(&body, "rut_too_narrow"), None);
    body["stations"][3]["soil"] = with(&body["soil"], json!({"cohesion_pa": 900}));
    let other = told(&body, "rut_of_other_soil").expect("another soil");
    assert_eq!(other["names"], json!(["/stations/3", "/stations/5"]), "station 3 behind 1, and 5 behind 3");
    let grid = json!({"of": "vehicle", "request": body, "axes": [{"field": "/mass_kg", "values": [20, 21]}]});
    let swept = post("/v1/sweep", &grid).warned_of();
    assert!(swept.contains(&"rut_of_other_soil".to_owned()), "{swept:?}");
}

#[test]
fn wheels_in_ruts_sink_less_into_the_floor() {
    let wheels = post("/v1/vehicle", &on_stations(json!({"rut": true}))).ok()["wheels"].clone();
    let apart = post("/v1/vehicle", &on_stations(json!({"rut": false}))).ok()["wheels"].clone();
    for station in 0..6 {
        assert_eq!(number(&apart[station], "rut_depth_m"), 0.0);
        let own = number(&wheels[station], "sinkage_m") - number(&wheels[station], "rut_depth_m");
        assert_eq!(number(&wheels[station], "rut_depth_m") > 0.0, station > 1);
        assert!(station < 2 || own < 0.6 * number(&apart[station], "sinkage_m"), "{wheels}");
    }
    let stiff = json!({"rut": true, "unloading": {"k_0_n_m3": 120e6, "a_u_n_m4": 3746e6}});
    let other = post("/v1/vehicle", &on_stations(stiff)).ok();
    assert!(number(&other["wheels"][2], "rut_depth_m") > number(&wheels[2], "rut_depth_m"));
}

#[test]
fn wheels_turn_as_an_independent_solution_says() {
    let reference = include_str!("../../crates/terramechanics/tests/reference/vehicle.json");
    let cases: Value = serde_json::from_str(reference).expect("a fixture");
    for case in cases.as_array().expect("cases").iter().filter(|case| case["input"]["slip_limit"].is_null()) {
        let reply = post("/v1/vehicle", &case["input"]).ok();
        assert_eq!(reply["drive"], case["input"]["drive"]);
        let (wheels, expected) = (reply["wheels"].as_array().expect("wheels"), case["expected"]["wheels"].as_array());
        for (wheel, expected) in wheels.iter().zip(expected.expect("wheels")) {
            for name in ["slip", "sinkage_m", "normal_load_n", "longitudinal_force_n", "torque_n_m"] {
                let (found, expected) = (number(wheel, name), number(expected, name));
                assert!((found - expected).abs() < SOLVED * expected.abs().max(1.0), "{}: {name} {found}", case["name"]);
            }
        }
        let together = wheels.iter().zip(case["input"]["stations"].as_array().expect("stations"));
        let together = together.filter(|(_, of)| of["slip"].is_null() && of["torque_n_m"].is_null());
        let largest = together.map(|(wheel, _)| number(wheel, "slip")).fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(number(&reply, "slip"), largest, "{}", case["name"]);
    }
}

#[test]
fn a_wheel_is_told_its_slip_or_its_torque() {
    let told = |changes: Value| {
        let mut body = on_stations(json!({"slope_rad": 0.05}));
        body["stations"][5] = with(&body["stations"][5], changes);
        body
    };
    assert_eq!(post("/v1/vehicle", &told(json!({"slip": 0, "torque_n_m": 0}))).pointers(), ["/stations/5/torque_n_m"]);
    let strong = post("/v1/vehicle", &told(json!({"torque_n_m": 1000})));
    assert!(strong.fault("/stations/5/torque_n_m").contains("no slip of the wheel of station 5"));
    let locked = post("/v1/vehicle", &told(json!({"slip": -1}))).ok();
    assert_eq!(number(&locked["wheels"][5], "energy_per_metre_j_m"), 0.0);
    assert!(number(&locked, "slip") > number(&post("/v1/vehicle", &told(json!({}))).ok(), "slip"));
    let mut all = told(json!({}));
    for station in 0..6 {
        all["stations"][station]["slip"] = json!(0.1);
    }
    assert_eq!(post("/v1/vehicle", &all).pointers(), ["/stations"]);
    let in_ruts = on_stations(json!({"rut": true, "drive": "equal_torque"}));
    assert_eq!(post("/v1/vehicle", &in_ruts).pointers(), ["/drive"]);
    assert_eq!(post("/v1/vehicle", &peer(json!({"hitch_height_m": 0.2}))).pointers(), ["/hitch_height_m"]);
}

#[test]
fn a_query_has_wheels_that_are_alike() {
    let query = "mass_kg=20&gravity_m_s2=1.625&wheels.count=4&wheels.wheel.radius_m=0.1&wheels.wheel.width_m=0.06\
        &soil.cohesion_pa=1000&soil.friction_angle_rad=0.7853981633974483&soil.shear_modulus_m=0.018\
        &soil.pressure_sinkage.law=bekker&soil.pressure_sinkage.k_c=1400&soil.pressure_sinkage.k_phi=820e3&soil.pressure_sinkage.n0=1\
        &contact.rule=wong_reece&contact.c1=0.4&contact.c2=0.2";
    let slope = get(&format!("/v1/vehicle?{query}&slope_rad=0.1")).ok();
    assert_eq!(slope, post("/v1/vehicle", &peer(json!({"slope_rad": 0.1}))).ok());
    let range = "slope_rad.from=0&slope_rad.to=0.2&slope_rad.points=3";
    let several = get(&format!("/v1/vehicle?{query}&{range}")).ok();
    assert_eq!(several, post("/v1/vehicle", &peer(json!({"slope_rad": [0, 0.1, 0.2]}))).ok());
    let table_of = table(&get(&format!("/v1/vehicle?{query}&{range}&format=csv")).text);
    assert_eq!(table_of, table(&post_for_csv("/v1/vehicle", &peer(json!({"slope_rad": [0, 0.1, 0.2]}))).text));
}

#[test]
fn faults_are_named_all_at_once() {
    let body = json!({"mass_kg": -1, "slope_rad": 2, "hitch_pull_n": "1", "slip_limit": 2, "rut": true, "speed": 1});
    let pointers = ["/speed", "/mass_kg", "/wheels", "/slope_rad", "/hitch_pull_n", "/slip_limit", "/rut"];
    assert_eq!(post("/v1/vehicle", &body).pointers(), pointers);
    let both = on_stations(json!({"wheels": {"count": 4, "wheel": {"radius_m": 0.1, "width_m": 0.06}}}));
    assert_eq!(post("/v1/vehicle", &both).pointers(), ["/wheels", "/stations"]);
    assert_eq!(post("/v1/vehicle", &peer(json!({"soil": null}))).pointers(), ["/soil"]);
    assert_eq!(post("/v1/vehicle", &peer(json!({"wheels": {"count": 65}}))).pointers(), ["/wheels/count"]);
    assert_eq!(post("/v1/vehicle", &peer(json!({"wheels": {"count": 2.5}}))).pointers(), ["/wheels/count"]);
    let centre = json!({"centre_of_mass": {"x_m": 0, "height_m": 0.1}});
    assert!(post("/v1/vehicle", &peer(centre)).fault("/centre_of_mass").contains("two places"));
    assert!(post("/v1/vehicle", &peer(json!({"rut": true}))).fault("/rut").starts_with("needs `stations`"));
    let closed = on_stations(json!({"rut": true, "method": "explicit"}));
    assert!(post("/v1/vehicle", &closed).fault("/method").contains("quadrature"));
    assert_eq!(post("/v1/vehicle", &on_stations(json!({"unloading": {}}))).pointers(), ["/unloading"]);
    let many: Vec<Value> = vec![json!({"x_m": 0, "wheel": {"preset": "letter"}}); 65];
    let many = on_stations(json!({"stations": many}));
    assert_eq!(post("/v1/vehicle", &many).pointers(), ["/stations"]);
    assert_eq!(
        post("/v1/vehicle", &peer(json!({"slope_rad": {"from": 0, "to": 1, "points": 10_002}}))).pointers(),
        ["/slope_rad/points"]
    );
    // The letter's own sand bears no such mass.
    let heavy = with(&peer(json!({"mass_kg": 1e6})), json!({"soil": letter()["soil"]}));
    assert_eq!(post("/v1/vehicle", &heavy).pointers(), ["/mass_kg"]);
}

#[test]
fn what_would_take_too_long_is_refused_before_it_begins() {
    let body = on_stations(json!({"drive": "equal_torque", "slope_rad": {"from": 0, "to": 0.3, "points": 10_001}}));
    let problem = post("/v1/vehicle", &body).problem(422);
    assert_eq!(problem["type"], "/problems/too-costly");
}
