//! What soils weigh: density, gravity and the granular stiffness that follows from them.

use serde_json::{Value, json};

use crate::asking::{get, post, with};
use crate::resistive_force::{ROUNDING, SOLVED, forces, grains, number};

/// ξ = ρ g (894 μ³ − 386 μ² + 89 μ): with μ = 1/2 by hand 59.75 ρ g.
#[test]
fn the_stiffness_follows_density_friction_and_gravity() {
    let of = |soil: Value| {
        let soil = with(&json!({"granular_stiffness_n_m3": null, "friction_angle_rad": 0.5_f64.atan()}), soil);
        number(&forces(json!({"soil": soil})), "granular_stiffness_n_m3")
    };
    let dense = |changes: Value| of(with(&json!({"bulk_density_kg_m3": 1600}), changes));
    assert!((dense(json!({"gravity_m_s2": 10})) / 956_000.0 - 1.0).abs() < ROUNDING);
    assert!((dense(json!({})) / (59.75 * 1600.0 * 9.80665) - 1.0).abs() < ROUNDING, "the Earth's gravity unless given");
    assert!((dense(json!({"gravity_m_s2": 1.62})) / dense(json!({})) - 1.62 / 9.80665).abs() < ROUNDING);
}

/// A wheel of a sixth of the load on the Moon sinks as deep, because stiffness and load fall alike.
#[test]
fn on_the_moon_a_mass_sinks_as_deep_as_on_the_earth() {
    let preset = |gravity: f64| {
        let changes = json!({
            "soil": {"preset": "hit-lss1", "gravity_m_s2": gravity, "friction_angle_rad": null, "granular_stiffness_n_m3": null},
            "sinkage_m": null, "normal_load_n": 8.0 * gravity
        });
        post("/v1/forces", &grains(changes))
    };
    let (earth, moon) = (preset(9.80665), preset(1.62));
    let (here, there) = (earth.ok(), moon.ok());
    assert!((number(&there, "sinkage_m") / number(&here, "sinkage_m") - 1.0).abs() < SOLVED);
    assert!((number(&there, "torque_n_m") / number(&here, "torque_n_m") / (1.62 / 9.80665) - 1.0).abs() < SOLVED);
    assert!(!earth.warned_of().contains(&"low_gravity".to_owned()));
    assert!(moon.warned_of().contains(&"low_gravity".to_owned()));
    assert!(!moon.warned_of().contains(&"moduli_of_other_gravity".to_owned()), "the method uses none");
}

#[test]
fn moduli_of_a_preset_in_another_gravity_are_told_and_what_is_sent_holds_there() {
    let preset = |changes: Value| with(&json!({"preset": "hit-lss1", "shear_modulus_m": 0.011}), changes);
    let told = |soil: Value| {
        let body = json!({"wheel": {"preset": "letter"}, "soil": soil, "slip": 0.2, "sinkage_m": 0.02});
        post("/v1/forces", &body).warned_of().contains(&"moduli_of_other_gravity".to_owned())
    };
    assert!(!told(preset(json!({}))) && !told(preset(json!({"gravity_m_s2": 9.80665}))));
    assert!(told(preset(json!({"gravity_m_s2": 1.62}))));
    let own = json!({"law": "bekker", "k_c": 15_600, "k_phi": 2_407_400, "n0": 1.1, "n1": 0});
    assert!(!told(preset(json!({"gravity_m_s2": 1.62, "pressure_sinkage": own}))));
}

/// Bulldozing shows the unit weight: Ishigami's pressure on the side wall is linear in it.
#[test]
fn a_published_weight_follows_gravity_and_one_that_is_sent_does_not() {
    let lateral = |soil: Value| {
        let soil = with(&json!({"preset": "hit-lss1", "shear_modulus_m": 0.011, "cohesion_pa": 0}), soil);
        let body = json!({
            "wheel": {"radius_m": 0.2, "width_m": 0.1}, "soil": soil, "slip": 0.2, "sinkage_m": 0.02, "slip_angle_rad": 0.2
        });
        number(&post("/v1/forces", &body).ok(), "lateral_force_n")
    };
    let weightless = lateral(json!({"unit_weight_n_m3": 1}));
    let (earth, moon) = (lateral(json!({})), lateral(json!({"gravity_m_s2": 1.62})));
    // 1 N/m³ is left of the weight in `weightless`.
    let ratio = (moon - weightless) / (earth - weightless);
    assert!((ratio / (1.62 / 9.80665) - 1.0).abs() < 1e-3, "{ratio}");
    let sent = |gravity: Value| lateral(json!({"unit_weight_n_m3": 2600, "gravity_m_s2": gravity}));
    assert_eq!(sent(json!(1.62)), sent(Value::Null));
    // A density that is sent takes the place of the weight that goes with the published one.
    let twice = lateral(json!({"bulk_density_kg_m3": 3210}));
    assert!(((twice - weightless) / (earth - weightless) / 2.0 - 1.0).abs() < 1e-3);
}

/// What the catalogue shows is a soil of a request that gives what the preset gives.
#[test]
fn the_catalogue_shows_densities_and_gravity_and_its_soils_can_be_sent() {
    let soils = get("/v1/soils").ok();
    let soils = soils.as_array().or_else(|| soils["soils"].as_array()).expect("soils");
    let mut dense = 0;
    for soil in soils {
        let (id, shown) = (soil["id"].as_str().expect("a name"), &soil["soil"]);
        let gravity = shown["gravity_m_s2"].as_f64();
        assert_eq!(gravity.is_none(), ["paper", "synthetic"].contains(&soil["kind"].as_str().expect("a kind")), "{id}");
        if shown["bulk_density_kg_m3"].is_null() {
            continue;
        }
        let density = &soil["values"]["bulk_density_kg_m3"];
        assert!(
            density["source"].as_str().is_some_and(|source| !source.is_empty())
                && density["value"] == shown["bulk_density_kg_m3"]
        );
        let of = |soil: &Value| {
            let body = with(&grains(json!({"soil": null})), json!({"soil": soil}));
            post("/v1/forces", &body).ok()
        };
        let mut sent = shown.clone();
        sent.as_object_mut().expect("an object").retain(|name, _| name != "pressure_sinkage" && name != "shear");
        for name in ["longitudinal_force_n", "granular_stiffness_n_m3"] {
            assert_eq!(of(&json!({"preset": id}))[name], of(&sent)[name], "{id}");
        }
        dense += 1;
    }
    assert_eq!(dense, 14);
    let lunar = get("/v1/soils/lunar-apollo-nominal").ok();
    assert_eq!((&lunar["soil"]["gravity_m_s2"], &lunar["soil"]["bulk_density_kg_m3"]), (&json!(1.62), &json!(1500.0)));
}

/// Reece's law needs a unit weight: the soil's, which is density times gravity where only these are known.
#[test]
fn a_law_takes_its_unit_weight_from_the_soil() {
    let forces = |soil: Value, law: Value| {
        let law = with(&json!({"law": "reece", "k_c": 10, "k_phi": 80, "n0": 1}), law);
        let own = json!({"cohesion_pa": 200, "friction_angle_rad": 0.5, "shear_modulus_m": 0.01, "pressure_sinkage": law});
        post(
            "/v1/forces",
            &json!({
                "wheel": {"radius_m": 0.2, "width_m": 0.1}, "soil": with(&own, soil), "slip": 0.2, "sinkage_m": 0.02
            }),
        )
    };
    let modulus = |answer: crate::asking::Answer| number(&answer.ok(), "sinkage_modulus");
    let of = |weight: f64| modulus(forces(json!({}), json!({"unit_weight_n_m3": weight})));
    let is_same = |one: f64, other: f64| (one / other - 1.0).abs() < ROUNDING;
    let moon = json!({"bulk_density_kg_m3": 1500, "gravity_m_s2": 1.6});
    assert!(is_same(modulus(forces(moon.clone(), json!({}))), of(2400.0)));
    assert!(is_same(modulus(forces(json!({"bulk_density_kg_m3": 1500}), json!({}))), of(1500.0 * 9.80665)));
    assert!(is_same(modulus(forces(json!({"unit_weight_n_m3": 15e3}), json!({}))), of(15e3)));
    assert!(is_same(modulus(forces(moon.clone(), json!({"unit_weight_n_m3": 2500}))), of(2500.0)), "its own comes first");
    let lacking = forces(json!({}), json!({}));
    assert_eq!(lacking.pointers(), ["/soil/pressure_sinkage/unit_weight_n_m3"]);
    let null = json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1}, "slip": 0.2, "sinkage_m": 0.02,
        "soil": {
            "cohesion_pa": 200, "friction_angle_rad": 0.5, "shear_modulus_m": 0.01, "unit_weight_n_m3": 15e3,
            "pressure_sinkage": {"law": "reece", "k_c": 10, "k_phi": 80, "n0": 1, "unit_weight_n_m3": null}
        }
    });
    assert!(is_same(modulus(post("/v1/forces", &null)), of(15e3)), "null is as if it were not sent");

    let told = |soil: Value, law: Value| forces(soil, law).warned_of().contains(&"unit_weights_differ".to_owned());
    assert!(!told(moon.clone(), json!({})));
    assert!(!told(moon.clone(), json!({"unit_weight_n_m3": 2500})), "1 part in 24 may be rounding");
    assert!(told(moon.clone(), json!({"unit_weight_n_m3": 15e3})), "a weight of the Earth");
    assert!(told(with(&moon, json!({"unit_weight_n_m3": 15e3})), json!({})));
}
