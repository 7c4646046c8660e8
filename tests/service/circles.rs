//! The circles on which displacement and slip are counted.

use serde_json::{Value, json};

use crate::asking::{get, letter, post, query_of, with};
use crate::forces::comes_back;
use crate::validation::sets;

/// Forty wheels with lugs at thirty digits, by an implementation independent of this one, with the slip of all three circles.
const LUGS: &str = include_str!("../../crates/terramechanics/tests/reference/lugs.json");

const DISPLACEMENTS: [&str; 2] = ["shearing", "rim"];
const SLIPS: [&str; 3] = ["rim", "shearing", "lug_tip"];

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} in {value}"))
}

/// The letter's wheel with lugs of 10 mm: r = 0.2, r_s = 0.205 and r + h = 0.21 m.
fn lugged(changes: Value) -> Value {
    with(&with(&letter(), json!({"wheel": {"lug_height_m": 0.01}})), changes)
}

#[test]
fn forty_wheels_with_lugs_come_back_over_http() {
    let cases: Vec<Value> = serde_json::from_str(LUGS).expect("a fixture is JSON");
    assert_eq!(cases.len(), 40);
    for (i, case) in cases.iter().enumerate() {
        comes_back(case, i, json!({}));
        assert!(SLIPS.iter().any(|circle| case["input"]["slip_radius"] == *circle), "case {i}");
    }
}

/// By hand from the equations, in six digits and more: a test wheel of Ding et al. 2011 at a slip of 0.1 under 80 N.
#[test]
fn a_wheel_of_ding_has_its_known_answer_by_each_convention() {
    let friction = 31.9_f64.to_radians();
    let body = json!({
        "wheel": {"radius_m": 0.15735, "width_m": 0.165, "lug_height_m": 0.01, "lug_coefficient": 0.5},
        "soil": {"cohesion_pa": 250, "friction_angle_rad": friction, "shear_modulus_m": 0.0114,
            "pressure_sinkage": {"law": "bekker", "k_c": 15.6e3, "k_phi": 2_407.4e3, "n0": 1.1}},
        "slip": 0.1, "normal_load_n": 80
    });
    for (circles, sinkage, pull, torque) in [
        (json!({}), 12.129_498_7e-3, 9.311_172_87, 4.045_722_49),
        (json!({"slip_radius": "shearing"}), 12.175_412_6e-3, 6.701_562_95, 3.633_701_96),
        (json!({"shear_displacement_radius": "rim"}), 12.298_054_3e-3, 0.631_188_273, 2.676_896_41),
    ] {
        let reply = post("/v1/forces", &with(&body, circles.clone())).ok();
        for (name, expected) in [("sinkage_m", sinkage), ("longitudinal_force_n", pull), ("torque_n_m", torque)] {
            assert!((number(&reply, name) / expected - 1.0).abs() < 1e-8, "{circles} {name}: {}", reply[name]);
        }
    }
}

/// v/ω = 0.16 m is a slip of 1 − 0.16/r_slip on each circle, and the forces are those of that slip.
#[test]
fn velocities_become_the_slip_of_the_circle() {
    for (circle, radius) in SLIPS.into_iter().zip([0.2, 0.205, 0.21]) {
        let velocities =
            json!({"slip": null, "forward_velocity_m_s": 0.08, "angular_velocity_rad_s": 0.5, "slip_radius": circle});
        let moving = post("/v1/forces", &lugged(velocities.clone())).ok();
        assert!((number(&moving, "slip") - (1.0 - 0.16 / radius)).abs() < 1e-15, "{circle}");
        let at_slip = post("/v1/forces", &lugged(json!({"slip": moving["slip"], "slip_radius": circle}))).ok();
        assert_eq!(moving, at_slip, "{circle}");
        // The way that a slip stands for is the same on all of them, and so are pull and torque.
        let rim = post("/v1/forces", &lugged(json!({"slip": 0.2}))).ok();
        for name in ["longitudinal_force_n", "torque_n_m", "tractive_efficiency"] {
            assert!((number(&moving, name) / number(&rim, name) - 1.0).abs() < 1e-12, "{circle} {name}");
        }
        let known = with(&lugged(velocities), json!({"normal_load_n": 80}));
        assert_eq!(post("/v1/coupled", &known).ok()["slip"], moving["slip"]);
    }
}

#[test]
fn without_lugs_all_circles_are_one() {
    let numbers = |path: &str, circles: &Value| {
        let mut reply = post(path, &with(&with(&letter(), json!({"normal_load_n": 80})), circles.clone())).ok();
        for name in ["shear_displacement_radius", "slip_radius"] {
            assert!(reply.as_object_mut().is_some_and(|reply| reply.remove(name).is_some()), "{path} {name}");
        }
        reply
    };
    for displacement in DISPLACEMENTS {
        for slip in SLIPS {
            let circles = json!({"shear_displacement_radius": displacement, "slip_radius": slip});
            for path in ["/v1/forces", "/v1/stress-profile", "/v1/coupled"] {
                assert_eq!(numbers(path, &circles), numbers(path, &json!({})), "{path} {circles}");
            }
        }
    }
}

#[test]
fn every_answer_names_its_circles() {
    let series = json!({"time_s": [0, 1], "slip": [0.1, 0.2]});
    let of_load = json!({"sinkage_m": null, "normal_load_n": 80});
    let fit = json!({"sinkage_m": null, "slip": null, "fit": ["friction_angle_rad"],
        "data": {"slip": [0.1, 0.3], "sinkage_m": [0.02, 0.02], "torque_n_m": [4, 6]}});
    let lugged_wheel = lugged(json!({}));
    let rover = json!({"mass_kg": 20, "wheels": {"count": 4, "wheel": lugged_wheel["wheel"]}, "soil": lugged_wheel["soil"]});
    let bodies = [
        ("/v1/forces", lugged(json!({}))),
        ("/v1/stress-profile", lugged(json!({}))),
        ("/v1/slip-sweep", with(&lugged(json!({"slip": null})), json!({"slip": [0.1, 0.2]}))),
        ("/v1/coupled", lugged(json!({"normal_load_n": 80}))),
        ("/v1/towed", with(&lugged(json!({"slip": null})), of_load.clone())),
        ("/v1/track", with(&with(&lugged(json!({"slip": null})), of_load), json!({"columns": series}))),
        ("/v1/identify", lugged(fit)),
        ("/v1/vehicle", rover),
    ];
    for (path, body) in &bodies {
        for (displacement, slip) in [("shearing", "rim"), ("rim", "lug_tip"), ("shearing", "shearing")] {
            let circles = json!({"shear_displacement_radius": displacement, "slip_radius": slip});
            let reply = post(path, &with(body, circles.clone())).ok();
            assert_eq!(
                (&reply["shear_displacement_radius"], &reply["slip_radius"]),
                (&json!(displacement), &json!(slip)),
                "{path}"
            );
            if (displacement, slip) == ("shearing", "rim") {
                assert_eq!(reply, post(path, body).ok(), "{path}: these are the defaults");
            }
        }
        let wrong = post(path, &with(body, json!({"slip_radius": "hub", "shear_displacement_radius": "lug_tip"})));
        assert_eq!(wrong.pointers(), ["/shear_displacement_radius", "/slip_radius"], "{path}");
    }
}

#[test]
fn a_variant_of_a_comparison_may_count_on_other_circles() {
    let variants = json!([{"name": "letter", "shear_displacement_radius": "rim"}, {"name": "tips", "slip_radius": "lug_tip"}]);
    let body = lugged(json!({"methods": ["quadrature"], "variants": variants}));
    let reply = post("/v1/compare", &body).ok();
    for (i, circles) in
        [json!({}), json!({"shear_displacement_radius": "rim"}), json!({"slip_radius": "lug_tip"})].iter().enumerate()
    {
        let forces = post("/v1/forces", &lugged(circles.clone())).ok();
        let series = &reply["series"][i];
        assert_eq!(series["columns"]["longitudinal_force_n"][0], forces["longitudinal_force_n"], "{circles}");
        for name in ["shear_displacement_radius", "slip_radius"] {
            assert_eq!(series[name], forces[name], "{circles} {name}");
        }
    }
}

#[test]
fn a_query_has_the_answer_of_the_body() {
    let body = lugged(json!({"shear_displacement_radius": "rim", "slip_radius": "shearing"}));
    for path in ["/v1/forces", "/v1/stress-profile"] {
        assert_eq!(get(&format!("{path}?{}", query_of(&body))).ok(), post(path, &body).ok(), "{path}");
    }
}

#[test]
fn every_measured_set_names_the_circle_of_its_slip() {
    for set in sets() {
        let (id, of_ding) =
            (set["id"].as_str().expect("an id"), set["id"].as_str().is_some_and(|id| id.starts_with("ding-2011")));
        let expected = if of_ding { (json!("shearing"), json!(true)) } else { (json!("rim"), json!(false)) };
        assert_eq!((set["slip_radius"].clone(), set["slip_radius_stated"].clone()), expected, "{id}");
    }
}
