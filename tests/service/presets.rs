//! The catalogue's entries in requests: every one computes, or says what it lacks or assumes.

use serde_json::{Value, json};

use crate::asking::{Answer, letter, post, with};
use crate::catalogue::entries;

/// What a request adds where an entry does not know a field.
fn stand_in(field: &str) -> Value {
    match field {
        "cohesion_pa" => json!(500),
        "friction_angle_rad" => json!(0.5),
        "shear_modulus_m" => json!(0.01),
        "pressure_sinkage" => json!({"law": "direct", "k_s": 1e6, "n0": 1}),
        "width_m" => json!(0.1),
        other => panic!("no stand-in for {other}"),
    }
}

fn names(list: &Value) -> Vec<&str> {
    list.as_array().expect("an array").iter().map(|name| name.as_str().expect("a name")).collect()
}

/// The letter's request with the wheel or the soil replaced.
fn request_with(part: &str, object: &Value) -> Value {
    with(&with(&letter(), json!({part: null, "sinkage_m": 0.005})), json!({part: object}))
}

fn without_warnings(answer: &Answer) -> Value {
    with(&answer.ok(), json!({"warnings": null}))
}

#[test]
fn every_soil_computes_as_a_preset_or_says_which_fields_are_missing() {
    let mut incomplete = 0;
    for soil in entries("/v1/soils", "soils") {
        let preset = request_with("soil", &json!({"preset": soil["id"]}));
        let missing = names(&soil["missing"]);
        let answer = post("/v1/forces", &preset);
        if missing.is_empty() {
            let spelled = with(&request_with("soil", &soil["soil"]), json!({"contact": soil["contact"]}));
            let warned_of_gravity = answer.warned_of().contains(&"low_gravity".into());
            assert_eq!(warned_of_gravity, soil["kind"] == "lunar" || soil["kind"] == "martian", "{}", soil["id"]);
            // The numbers alone do not say where the soil lies.
            assert_eq!(without_warnings(&answer), without_warnings(&post("/v1/forces", &spelled)), "{}", soil["id"]);
            continue;
        }
        incomplete += 1;
        let pointers: Vec<String> = missing.iter().map(|name| format!("/soil/{name}")).collect();
        assert_eq!(answer.pointers(), pointers);
        for pointer in &pointers {
            let detail = answer.fault(pointer);
            assert!(detail.contains(soil["id"].as_str().expect("an id")), "{detail}");
        }
        let added: Value = missing.iter().map(|name| ((*name).to_owned(), stand_in(name))).collect();
        let completed = post("/v1/forces", &with(&preset, json!({"soil": added})));
        assert!(completed.ok()["normal_force_n"].as_f64().expect("a force") > 0.0, "{}", soil["id"]);
    }
    assert!(incomplete > 30, "only {incomplete} soils lack a value");
}

#[test]
fn every_wheel_computes_as_a_preset_or_says_which_fields_are_missing() {
    let mut incomplete = 0;
    for wheel in entries("/v1/wheels", "wheels") {
        let preset = request_with("wheel", &json!({"preset": wheel["id"]}));
        let missing = names(&wheel["missing"]);
        let answer = post("/v1/forces", &preset);
        if missing.is_empty() {
            let spelled = request_with("wheel", &wheel["wheel"]);
            assert_eq!(without_warnings(&answer), without_warnings(&post("/v1/forces", &spelled)), "{}", wheel["id"]);
            continue;
        }
        incomplete += 1;
        assert_eq!(answer.pointers(), missing.iter().map(|name| format!("/wheel/{name}")).collect::<Vec<_>>());
        let added: Value = missing.iter().map(|name| ((*name).to_owned(), stand_in(name))).collect();
        assert!(post("/v1/forces", &with(&preset, json!({"wheel": added}))).ok()["torque_n_m"].is_number());
    }
    assert_eq!(incomplete, 3, "the widths of three flight wheels are not published");
}

#[test]
fn a_law_that_is_only_partly_published_names_the_rest() {
    let body = request_with("soil", &json!({"preset": "wong-reece-compact-sand"}));
    let detail = post("/v1/forces", &body).fault("/soil/pressure_sinkage");
    assert!(detail.contains("`reece` it lacks k_c, k_phi, unit_weight_n_m3"), "{detail}");
}

const ASSUMED: &str = "lug_height_assumed";

/// Whether the catalogue says that the lugs of a wheel are not known.
fn has_unknown_lugs(wheel: &Value) -> bool {
    wheel["assumed"].as_array().expect("an array").iter().any(|one| one["field"] == "lug_height_m")
}

#[test]
fn a_wheel_whose_lug_height_is_not_published_says_that_it_is_computed_as_smooth() {
    let mut assumed = 0;
    for wheel in entries("/v1/wheels", "wheels") {
        let width = if names(&wheel["missing"]).is_empty() { json!({}) } else { json!({"width_m": 0.1}) };
        let preset = with(&width, json!({"preset": wheel["id"]}));
        let answer = post("/v1/forces", &request_with("wheel", &preset));
        let says_so = answer.warned_of().contains(&ASSUMED.into());
        assert_eq!(says_so, has_unknown_lugs(&wheel), "{}", wheel["id"]);
        if says_so {
            assumed += 1;
            assert!(wheel["wheel"]["lug_height_m"].is_null());
            let given = post("/v1/forces", &request_with("wheel", &with(&preset, json!({"lug_height_m": 0}))));
            assert_eq!(without_warnings(&given), without_warnings(&answer), "the same wheel, known to be smooth");
            assert!(!given.warned_of().contains(&ASSUMED.into()));
        }
    }
    assert_eq!(assumed, 15);
    // Every answer about such a wheel says so.
    let zhurong = request_with("wheel", &json!({"preset": "zhurong"}));
    let range = json!({"from": 0, "to": 0.4, "points": 3});
    for (path, changes) in [
        ("/v1/stress-profile", json!({})),
        ("/v1/slip-sweep", json!({"slip": range})),
        ("/v1/compare", json!({"slip": range, "methods": ["quadrature"]})),
    ] {
        assert!(post(path, &with(&zhurong, changes)).warned_of().contains(&ASSUMED.into()), "{path}");
    }
}

/// The authors of these wheels' models let the shear stress act at the tips of the grousers: r_s = r + h.
#[test]
fn the_shear_acts_where_the_authors_of_a_wheel_say() {
    for (id, expected) in [("archimede-units", 0.085 + 0.01), ("cmu-k10-mini-grouser", 0.058 + 0.005), ("cmu-jia-wheel", 0.092)] {
        let answer = post("/v1/forces", &request_with("wheel", &json!({"preset": id}))).ok();
        assert!((answer["shearing_radius_m"].as_f64().expect("a radius") - expected).abs() < 1e-15, "{id}");
    }
}

/// A soil and, beside it, a contact.
fn on(soil: &Value, contact: Value) -> Answer {
    post("/v1/forces", &with(&request_with("soil", soil), json!({"contact": contact})))
}

#[test]
fn a_value_of_a_law_is_overridden_alone() {
    let sand = |law: Value| on(&json!({"preset": "letter-sand", "pressure_sinkage": law}), Value::Null).ok();
    assert_eq!(sand(json!({"n0": 1.1})), sand(json!({"law": "bekker", "k_c": -660, "k_phi": 754_130, "n0": 1.1})));
    assert_ne!(sand(json!({"n0": 1.1}))["torque_n_m"], sand(json!({}))["torque_n_m"]);
    assert_eq!(sand(json!({})), on(&json!({"preset": "letter-sand"}), Value::Null).ok());

    // With its law named it is a whole one, with the defaults of the law: n1 is not the preset's 0.5.
    let zhurong = |law: Value| on(&json!({"preset": "zhurong-sand-marssim", "pressure_sinkage": law}), Value::Null).ok();
    let exponent = |reply: Value| reply["sinkage_exponent"].as_f64().expect("an exponent");
    assert!((exponent(zhurong(json!({"n0": 1.0}))) - 1.1).abs() < 1e-12, "n0 + n1 s at s = 0.2");
    assert_eq!(exponent(zhurong(json!({"law": "bekker", "k_c": 13_600, "k_phi": 2_259_100, "n0": 1.0}))), 1.0);

    let firn = |shear: Value| on(&json!({"preset": "greenland-firn-lines-2021", "shear": shear}), Value::Null);
    let published = firn(Value::Null).ok();
    assert_eq!(firn(json!({})).ok(), published);
    assert_ne!(firn(json!({"residual_ratio": 0.9})).ok()["torque_n_m"], published["torque_n_m"]);

    let tohoku = json!({"preset": "tohoku-regolith-simulant-2005"});
    let measured = on(&tohoku, Value::Null).ok();
    assert_eq!(on(&tohoku, json!({})).ok(), measured);
    assert_ne!(on(&tohoku, json!({"c3": -0.1})).ok()["torque_n_m"], measured["torque_n_m"]);

    // A word that is null was not sent.
    let [without, null] = [json!({"n0": 1.1}), json!({"law": null, "n0": 1.1})]
        .map(|law| on(&json!({"preset": "letter-sand", "pressure_sinkage": law}), Value::Null).text);
    assert_eq!(without, null);
}

#[test]
fn values_that_a_preset_lacks_complete_its_law() {
    let soil = json!({
        "preset": "mit-mms-reece",
        "pressure_sinkage": {"k_c": 100, "k_phi": 80, "unit_weight_n_m3": 15e3}
    });
    let spelled = with(&soil, json!({"pressure_sinkage": {"law": "reece", "n0": 1.387}}));
    let number = |soil: &Value| on(soil, Value::Null).ok()["normal_force_n"].clone();
    assert_eq!(number(&soil), number(&spelled));
    let answer = on(&json!({"preset": "mit-mms-reece", "pressure_sinkage": {"n0": 1.2}}), Value::Null);
    assert_eq!(
        answer.pointers(),
        ["/soil/pressure_sinkage/k_c", "/soil/pressure_sinkage/k_phi", "/soil/pressure_sinkage/unit_weight_n_m3"]
    );
}

#[test]
fn another_law_needs_all_its_values() {
    let sand = |law: Value| on(&json!({"preset": "letter-sand", "pressure_sinkage": law}), Value::Null);
    assert_eq!(sand(json!({"law": "direct", "n0": 1.1})).fault("/soil/pressure_sinkage/k_s"), "is required");
    assert!(sand(json!({"k_s": 1e6})).fault("/soil/pressure_sinkage/k_s").starts_with("`bekker` has no such field"));
    assert!(sand(json!({"n": 1})).fault("/soil/pressure_sinkage/n").ends_with("did you mean `n0`?"));
    assert!(sand(json!({"n0": -1})).fault("/soil/pressure_sinkage/n0").starts_with("must be from"));
    let bare = post("/v1/forces", &with(&letter(), json!({"soil": {"pressure_sinkage": {"law": null}}})));
    assert!(bare.fault("/soil/pressure_sinkage/law").starts_with("is required: one of bekker"));
    let shear = on(&json!({"preset": "letter-sand", "shear": {"residual_ratio": 0.5}}), Value::Null);
    assert!(shear.fault("/soil/shear/residual_ratio").starts_with("`janosi_hanamoto` has no such field"));
    let contact = on(&json!({"preset": "letter-sand"}), json!({"c1": 0.4, "c3": -0.1}));
    assert!(contact.fault("/contact/rule").starts_with("is required: one of midpoint"));
}

/// A contact without a rule is that of the soil, else the midpoint, with what was sent in place of its own.
#[test]
fn a_contact_may_leave_its_rule_out() {
    let sand = json!({"preset": "letter-sand"});
    for beside in
        [json!({"c3": -0.1}), json!({"exit": {"ratio": 0.5}}), json!({"interface": {"friction_angle_rad": 0.3}}), json!({})]
    {
        let short = on(&sand, beside.clone()).ok();
        assert_eq!(short, on(&sand, with(&json!({"rule": "midpoint"}), beside)).ok());
    }
}

#[test]
fn a_weight_that_overrides_the_law_holds_where_the_soil_lies() {
    let law = |changes: Value| {
        let law = with(&json!({"k_c": 100, "k_phi": 80, "unit_weight_n_m3": 15e3}), changes);
        on(&json!({"preset": "mit-mms-reece", "gravity_m_s2": 1.62, "pressure_sinkage": law}), Value::Null).ok()
    };
    let modulus = |reply: Value| reply["sinkage_modulus"].as_f64().expect("a modulus");
    let spelled = json!({"law": "reece", "n0": 1.387});
    assert_eq!(modulus(law(json!({}))), modulus(law(spelled)));
}
