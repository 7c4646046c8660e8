//! What lies between rim and soil, and where a contact ends.

use serde_json::{Value, json};

use crate::asking::{get, letter, post, query_of, with};

/// Some tens of roundings.
const ROUNDING: f64 = 1e-12;

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} in {value}"))
}

fn sand(changes: Value) -> Value {
    with(&with(&letter(), json!({"soil": {"cohesion_pa": 500}, "contact": {"rule": "midpoint"}})), changes)
}

fn of_interface(interface: Value) -> Value {
    sand(json!({"contact": {"interface": interface}}))
}

#[test]
fn an_interface_that_is_the_soils_changes_nothing() {
    for method in ["quadrature", "linearised", "explicit"] {
        let by = |body: Value| post("/v1/forces", &with(&body, json!({"method": method}))).ok();
        let soils = json!({"friction_angle_rad": 0.478, "adhesion_pa": 500, "shear_modulus_m": 0.005});
        for interface in [soils, json!({}), json!({"adhesion_pa": 500})] {
            assert_eq!(by(of_interface(interface)), by(sand(json!({}))), "{method}");
        }
    }
}

/// τ takes the interface's numbers, σ does not: the forces are those of a soil that has them for its own.
#[test]
fn an_interface_takes_the_place_of_the_soils_strength() {
    let own = json!({"cohesion_pa": 0, "friction_angle_rad": 0.36, "shear_modulus_m": 0.002});
    let interface = json!({"friction_angle_rad": 0.36, "adhesion_pa": 0, "shear_modulus_m": 0.002});
    for (method, slip) in [("quadrature", 0.2), ("linearised", 0.1), ("explicit", 0.5), ("quadrature", -0.3)] {
        let case = json!({"method": method, "slip": slip});
        let as_soil = post("/v1/forces", &sand(with(&case, json!({"soil": own})))).ok();
        let as_interface = post("/v1/forces", &with(&of_interface(interface.clone()), case)).ok();
        for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m"] {
            assert!((number(&as_interface, name) / number(&as_soil, name) - 1.0).abs() < ROUNDING, "{method} {slip} {name}");
        }
    }
    let body = of_interface(interface);
    assert_eq!(get(&format!("/v1/forces?{}", query_of(&body))).ok(), post("/v1/forces", &body).ok());
}

#[test]
fn an_interface_stronger_than_its_soil_or_out_of_bounds_is_refused() {
    for (interface, pointer) in [
        (json!({"friction_angle_rad": 0.5}), "/contact/interface"),
        (json!({"adhesion_pa": 501}), "/contact/interface"),
        (json!({"shear_modulus_m": 0}), "/contact/interface/shear_modulus_m"),
        (json!({"friction_angle": 0.3}), "/contact/interface/friction_angle"),
    ] {
        assert_eq!(post("/v1/forces", &of_interface(interface)).pointers(), [pointer]);
    }
    let misplaced = post("/v1/forces", &sand(json!({"contact": {"adhesion_pa": 3}})));
    assert!(misplaced.fault("/contact/adhesion_pa").contains("`interface`"));
}

/// θ2 = −arccos(1 − η z/r): at η = 1 both sides are alike, at 0 the contact ends at the lowest point.
#[test]
fn an_exit_is_set_by_the_ratio_of_the_sinkages() {
    for (ratio, z) in [(0.0, 0.02), (0.5, 0.02), (1.0, 0.03), (1.2, 0.01)] {
        let reply = post("/v1/forces", &sand(json!({"sinkage_m": z, "contact": {"exit": {"ratio": ratio}}}))).ok();
        let expected = -(1.0_f64 - ratio * z / 0.2).acos();
        assert!((number(&reply["angles"], "exit_rad") - expected).abs() < 1e-14, "{ratio}");
    }
    let alike = post("/v1/forces", &sand(json!({"contact": {"exit": {"ratio": 1}}}))).ok();
    assert!((number(&alike["angles"], "exit_rad") + number(&alike["angles"], "entry_rad")).abs() < 1e-14);
    let both = post("/v1/forces", &sand(json!({"contact": {"c3": 0, "exit": {"ratio": 1}}})));
    assert_eq!(both.pointers(), ["/contact/exit"]);
    assert_eq!(post("/v1/forces", &sand(json!({"contact": {"exit": {"ratio": 1.3}}}))).pointers(), ["/contact/exit/ratio"]);
    assert_eq!(post("/v1/forces", &sand(json!({"contact": {"exit": {}}}))).pointers(), ["/contact/exit/ratio"]);
}

/// A lugged wheel whose exit stands at 1.1 of its sinkage, integrated elsewhere: c3 = −1.049 is within the bounds, and the ratio gives
/// the same contact.
#[test]
fn a_published_exit_of_a_lugged_wheel_is_computed() {
    let body = |contact: Value| {
        json!({
            "wheel": {"radius_m": 0.15, "width_m": 0.1},
            "soil": {"cohesion_pa": 800, "friction_angle_rad": 0.649_262_482, "shear_modulus_m": 0.025,
                "pressure_sinkage": {"law": "bekker", "k_c": 1370, "k_phi": 814_000, "n0": 1.0}},
            "contact": with(&json!({"rule": "wong_reece", "c1": 0.4, "c2": 0.15}), contact),
            "slip": 0.4, "sinkage_m": 0.011
        })
    };
    for contact in [json!({"c3": -1.049_468_687}), json!({"exit": {"ratio": 1.1}})] {
        let reply = post("/v1/forces", &body(contact.clone())).ok();
        for (name, expected) in
            [("longitudinal_force_n", 22.019_002_0), ("normal_force_n", 45.972_296_2), ("torque_n_m", 3.687_509_81)]
        {
            assert!((number(&reply, name) / expected - 1.0).abs() < 1e-8, "{contact} {name}: {}", reply[name]);
        }
    }
    assert_eq!(post("/v1/forces", &body(json!({"c3": -1.21}))).pointers(), ["/contact/c3"]);
}

/// z = z0 (1 − S_b s) at s < 0: 1.6 z0 at half skid with S_b = 1.2.
#[test]
fn a_skid_gain_lets_a_braking_wheel_sink() {
    let linear = |law: Value| {
        sand(json!({"slip": -0.5, "sinkage_m": null, "static_sinkage_m": 0.01, "normal_load_n": 80, "slip_sinkage": law}))
    };
    let with_gain = post("/v1/forces", &linear(json!({"law": "linear", "gain": 1, "skid_gain": 1.2})));
    assert!((number(&with_gain.ok(), "sinkage_m") - 0.016).abs() < 1e-16);
    assert!(!with_gain.warned_of().contains(&"slip_sinkage_extrapolated".to_owned()));
    let without = post("/v1/forces", &linear(json!({"law": "linear", "gain": 1})));
    assert!((number(&without.ok(), "sinkage_m") - 0.005).abs() < 1e-16);
    assert!(without.warned_of().contains(&"slip_sinkage_extrapolated".to_owned()));
}

/// Torque and pull of a wheel whose interface is known, by the service's own forces: a fit leads back to it, and to a contact that can be
/// sent again.
#[test]
fn a_fit_finds_an_interface() {
    let truth = json!({"friction_angle_rad": 0.38, "shear_modulus_m": 0.0015});
    let (slips, loads) = ([0.03, 0.06, 0.1, 0.2, 0.4], [0.01, 0.02, 0.015, 0.02, 0.01]);
    let forces: Vec<Value> = slips
        .iter()
        .zip(loads)
        .map(|(slip, sinkage)| {
            post("/v1/forces", &with(&of_interface(truth.clone()), json!({"slip": slip, "sinkage_m": sinkage}))).ok()
        })
        .collect();
    let column = |name: &str| forces.iter().map(|forces| forces[name].clone()).collect::<Vec<_>>();
    let data = json!({"slip": slips, "sinkage_m": loads, "torque_n_m": column("torque_n_m"), "longitudinal_force_n": column("longitudinal_force_n")});
    let fit = json!(["interface_friction_angle_rad", "interface_shear_modulus_m"]);
    let body = sand(json!({"slip": null, "sinkage_m": null, "fit": fit, "data": data}));
    let answer = post("/v1/identify", &body);
    let found = answer.ok();
    assert_eq!((&found["converged"], &found["identifiable"]), (&json!(true), &json!(true)));
    for (name, value) in [("friction_angle_rad", 0.38), ("shear_modulus_m", 0.0015)] {
        assert!((number(&found["contact"]["interface"], name) / value - 1.0).abs() < 1e-4, "{}", found["contact"]);
    }
    assert!(!answer.warned_of().contains(&"may_be_the_interface".to_owned()));
    let again = post("/v1/forces", &sand(json!({"contact": {"interface": found["contact"]["interface"]}}))).ok();
    let known = post("/v1/forces", &of_interface(truth)).ok();
    assert!((number(&again, "torque_n_m") / number(&known, "torque_n_m") - 1.0).abs() < 1e-4);

    // The soil's own numbers, fitted to the same bare rim, are those of the interface, and the answer says so.
    let soils = json!({"fit": ["friction_angle_rad", "shear_modulus_m"], "soil": {"cohesion_pa": 500}});
    let fitted = post("/v1/identify", &with(&with(&body, json!({"fit": null})), soils));
    assert!(fitted.warned_of().contains(&"may_be_the_interface".to_owned()));
    let found_as = |answer: Value| {
        let names = answer["estimates"].as_array().expect("estimates").iter().map(|one| one["found"].clone());
        names.collect::<Vec<_>>()
    };
    assert_eq!(found_as(fitted.ok()), ["interface_friction_angle_rad", "interface_shear_modulus_m"]);
    assert_eq!(found_as(found), ["interface_friction_angle_rad", "interface_shear_modulus_m"]);
    let lugged = post("/v1/identify", &with(&body, json!({"fit": ["friction_angle_rad"], "wheel": {"lug_height_m": 0.01}})));
    assert!(!lugged.warned_of().contains(&"may_be_the_interface".to_owned()));
    assert_eq!(found_as(lugged.ok()), ["friction_angle_rad"]);
    let dry = with(&body, json!({"fit": ["interface_adhesion_pa"], "soil": {"cohesion_pa": 0}}));
    assert_eq!(post("/v1/identify", &dry).pointers(), ["/fit/0"]);
}

/// The soil between lugs shears against soil, so that an interface has no place there; nor has it a say in grains.
#[test]
fn an_interface_on_a_wheel_with_lugs_is_warned_of_wherever_it_acts() {
    const CODE: &str = "interface_of_lugged_wheel";
    let lugged = with(&of_interface(json!({"adhesion_pa": 0})), json!({"wheel": {"lug_height_m": 0.01}}));
    let says = |path: &str, body: &Value| post(path, body).warned_of().contains(&CODE.to_owned());
    let data = json!({"slip": [0.1, 0.2, 0.3], "sinkage_m": [0.02, 0.02, 0.02], "torque_n_m": [4, 5, 6]});
    let line = with(&data, json!({"normal_force_n": [60, 80, 100], "sinkage_m": [0.02, 0.022, 0.024]}));
    let bare = json!({"slip": null, "sinkage_m": null});
    let of = |changes: Value| with(&with(&lugged, bare.clone()), changes);
    let station = |x: f64| json!({"x_m": x, "wheel": lugged["wheel"]});
    let rover = json!({
        "mass_kg": 20, "stations": [station(0.5), station(-0.5)], "soil": lugged["soil"], "contact": lugged["contact"]
    });
    for (path, body) in [
        ("/v1/forces", lugged.clone()),
        ("/v1/stress-profile", lugged.clone()),
        ("/v1/slip-sweep", with(&lugged, json!({"slip": [0.1, 0.2]}))),
        ("/v1/compare", with(&lugged, json!({"slip": [0.1, 0.2]}))),
        ("/v1/coupled", with(&lugged, json!({"normal_load_n": 100}))),
        ("/v1/track", of(json!({"static_sinkage_m": 0.02, "columns": {"time_s": [0, 1], "slip": [0.1, 0.2]}}))),
        ("/v1/identify", of(json!({"fit": ["shear_modulus_m"], "data": data}))),
        ("/v1/identify", of(json!({"fit": ["cohesion_pa", "friction_angle_rad"], "estimator": "linear", "data": line}))),
        ("/v1/vehicle", rover),
    ] {
        assert!(says(path, &body), "{path} {body}");
    }
    assert!(!says("/v1/forces", &with(&lugged, json!({"wheel": {"lug_height_m": 0}}))));
    assert!(!says("/v1/forces", &with(&lugged, json!({"contact": {"interface": null}}))));
    let grains = json!({"method": "resistive_force", "soil": {"bulk_density_kg_m3": 1600}});
    assert!(!says("/v1/forces", &with(&lugged, grains)));
}

/// The published K of the soil is 9.7 to 13.1 mm; a fit to the smooth wheel of Ding et al. (2011) finds some 3 mm, the interface's.
#[test]
fn a_fit_that_leaves_what_was_measured_on_the_soil_says_so() {
    let set = get("/v1/validation/ding-2011-smooth").ok();
    let of = |name: &str| set["columns"]["measured"][name].clone();
    let slip = set["columns"]["slip"].clone();
    let slips = slip.as_array().expect("slips").len();
    let body = |pull: Value, torque: Value| {
        json!({
            "wheel": set["wheel"], "soil": {"preset": "hit-lss1"}, "slip_radius": "shearing",
            "fit": ["friction_angle_rad", "shear_modulus_m"],
            "data": {
                "slip": slip, "sinkage_m": of("sinkage_m"), "normal_load_n": vec![80; slips],
                "longitudinal_force_n": pull, "torque_n_m": torque
            }
        })
    };
    let measured = post("/v1/identify", &body(of("longitudinal_force_n"), of("torque_n_m"))).ok();
    let told = measured["warnings"].as_array().expect("warnings").iter().filter(|warning| warning["code"] == "beyond_measured");
    let told: Vec<&Value> = told.collect();
    let of_modulus = told.iter().find(|warning| warning["quantity"] == "shear_modulus_m").expect("K leaves its range");
    assert_eq!([&of_modulus["range"]["lower"], &of_modulus["range"]["upper"]], [&json!(0.0097), &json!(0.0131)]);
    assert_eq!(of_modulus["names"], json!(["hit-lss1"]));
    // Of an angle no range was published.
    assert_eq!(told.len(), 1, "{told:?}");
    // Forces of the soil itself do not leave it.
    let forces: Vec<Value> = (0..slips)
        .map(|i| {
            let point = json!({
                "wheel": set["wheel"], "soil": {"preset": "hit-lss1"}, "slip_radius": "shearing",
                "slip": slip[i], "sinkage_m": of("sinkage_m")[i], "normal_load_n": 80
            });
            post("/v1/forces", &point).ok()
        })
        .collect();
    let column = |name: &str| Value::from(forces.iter().map(|force| force[name].clone()).collect::<Vec<_>>());
    let own = post("/v1/identify", &body(column("longitudinal_force_n"), column("torque_n_m")));
    assert!(!own.warned_of().contains(&"beyond_measured".to_owned()));
}
