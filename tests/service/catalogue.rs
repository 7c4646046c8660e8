//! `GET /v1/wheels`, `/v1/soils`, `/v1/model`.

use serde_json::{Value, json};

use crate::asking::{get, letter, post, with};

fn entries(path: &str, name: &str) -> Vec<Value> {
    get(path).ok()[name].as_array().expect("entries").clone()
}

#[test]
fn every_value_has_its_source() {
    for (path, name) in [("/v1/wheels", "wheels"), ("/v1/soils", "soils")] {
        let entries = entries(path, name);
        assert!(entries.len() >= 12);
        for entry in &entries {
            for (field, value) in entry["values"].as_object().expect("values") {
                for member in ["published", "source", "grade"] {
                    assert!(
                        value[member].as_str().is_some_and(|text| !text.is_empty()),
                        "{member} of {field} of {}",
                        entry["id"]
                    );
                }
                assert!(value["value"].is_number());
            }
            let id = entry["id"].as_str().expect("an id");
            assert_eq!(&get(&format!("{path}/{id}")).ok(), entry);
        }
    }
}

#[test]
fn the_letters_entries_are_there() {
    let soil = get("/v1/soils/letter-sand").ok();
    let strength = json!({"cohesion_pa": 0.0, "friction_angle_rad": 0.478, "shear_modulus_m": 0.005});
    let law = json!({"law": "bekker", "k_c": -660.0, "k_phi": 754_130.0, "n0": 0.91});
    assert_eq!(soil["soil"], with(&strength, json!({"pressure_sinkage": law})));
    assert_eq!(soil["missing"], json!([]));
    let wheel = get("/v1/wheels/letter").ok();
    assert_eq!((&wheel["wheel"]["radius_m"], &wheel["wheel"]["width_m"]), (&json!(0.2), &json!(0.1)));
}

#[test]
fn every_entry_computes_as_a_preset_or_says_which_fields_are_missing() {
    let mut incomplete = 0;
    for soil in entries("/v1/soils", "soils") {
        let body = with(&with(&letter(), json!({"soil": null})), json!({"soil": {"preset": soil["id"]}}));
        let missing = soil["missing"].as_array().expect("missing");
        let answer = post("/v1/forces", &body);
        if missing.is_empty() {
            let spelled =
                with(&with(&letter(), json!({"soil": null})), json!({"soil": soil["soil"], "contact": soil["contact"]}));
            assert_eq!(answer.ok(), post("/v1/forces", &spelled).ok(), "{}", soil["id"]);
        } else {
            incomplete += 1;
            let expected: Vec<String> = missing.iter().map(|name| format!("/soil/{}", name.as_str().expect("a name"))).collect();
            assert_eq!(answer.pointers(), expected);
            let completed = post("/v1/forces", &with(&body, json!({"soil": {"shear_modulus_m": 0.01}})));
            assert!(completed.ok()["normal_force_n"].as_f64().expect("a force") > 0.0);
        }
    }
    assert!(incomplete > 0, "the catalogue has entries that lack a value");
    for wheel in entries("/v1/wheels", "wheels") {
        let body = with(&with(&letter(), json!({"wheel": null})), json!({"wheel": {"preset": wheel["id"]}}));
        let spelled = with(&with(&letter(), json!({"wheel": null})), json!({"wheel": wheel["wheel"]}));
        assert_eq!(post("/v1/forces", &body).ok(), post("/v1/forces", &spelled).ok(), "{}", wheel["id"]);
    }
}

#[test]
fn an_unknown_entry_is_a_404_with_the_nearest_name() {
    for (path, near) in [("/v1/soils/letter_sand", "letter-sand"), ("/v1/wheels/leter", "letter")] {
        let detail = get(path).problem(404)["detail"].to_string();
        assert!(detail.contains(near), "{detail}");
    }
}

#[test]
fn the_model_lists_all_errata() {
    let model = get("/v1/model").ok();
    assert_eq!(model["errata"].as_array().expect("errata").len(), 12);
    assert!(model["equations"].as_array().expect("equations").len() >= 18);
}
