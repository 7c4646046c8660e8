//! Results say when they leave the range in which their model was tested.

use serde_json::{Value, json};

use crate::asking::{get, letter, post, with};

/// The letter's case on a wheel that is large enough for Bekker's law: nothing to warn of.
fn tested() -> Value {
    with(&letter(), json!({"wheel": {"radius_m": 0.25}}))
}

fn warned_of(changes: Value) -> Vec<String> {
    post("/v1/forces", &with(&tested(), changes)).warned_of()
}

#[test]
fn a_result_within_all_ranges_carries_no_warning() {
    assert!(warned_of(json!({})).is_empty());
}

#[test]
fn a_small_wheel_is_warned_of_with_bekkers_law_only() {
    assert_eq!(warned_of(json!({"wheel": {"radius_m": 0.2499}})), ["small_wheel"]);
    let direct = json!({"law": "direct", "k_s": 747_530.0, "n0": 0.91});
    let soil = json!({"cohesion_pa": 0, "friction_angle_rad": 0.478, "shear_modulus_m": 0.005, "pressure_sinkage": direct});
    let body = json!({"wheel": {"preset": "letter"}, "soil": soil, "slip": 0.2, "sinkage_m": 0.02});
    assert!(post("/v1/forces", &body).warned_of().is_empty());
}

#[test]
fn a_deep_sinkage_is_warned_of() {
    // 30 mm of 90 mm, of a radius of 250 mm.
    assert!(warned_of(json!({"sinkage_m": 0.0833})).is_empty());
    assert_eq!(warned_of(json!({"sinkage_m": 0.0834})), ["deep_sinkage"]);
}

#[test]
fn slip_beyond_the_fit_is_warned_of_where_a_slip_gain_is_used() {
    let gain = json!({"pressure_sinkage": {"n1": 0.3}});
    assert!(warned_of(json!({"slip": 0.6, "soil": gain})).is_empty());
    assert_eq!(warned_of(json!({"slip": 0.61, "soil": gain})), ["slip_beyond_fit"]);
    assert!(warned_of(json!({"slip": 0.61})).is_empty());
    let from_static = json!({"slip": 0.7, "sinkage_m": null, "static_sinkage_m": 0.01});
    assert_eq!(warned_of(from_static), ["slip_beyond_fit", "normal_force_drifts"]);
}

/// Which tests stand behind a range depends on the law that is left.
#[test]
fn the_source_of_a_range_is_that_of_the_law_at_hand() {
    let said = |code: &str, changes: Value| {
        let reply = post("/v1/forces", &with(&tested(), changes)).ok();
        let warnings = reply["warnings"].as_array().expect("warnings").clone();
        warnings.into_iter().find(|warning| warning["code"] == code).unwrap_or_else(|| panic!("{code} in {reply}"))
    };
    let from_static =
        |slip: f64, law: Value| json!({"slip": slip, "sinkage_m": null, "static_sinkage_m": 0.01, "slip_sinkage": law});
    let (lyasko, linear) = (json!({"law": "lyasko"}), json!({"law": "linear", "gain": 1}));
    for (code, slip) in [("slip_beyond_fit", 0.7), ("slip_sinkage_extrapolated", -0.2)] {
        let of =
            |law: &Value| said(code, from_static(slip, law.clone()))["range"]["source"].as_str().expect("a source").to_owned();
        assert!(of(&lyasko).contains("Lyasko 2010"), "{code}");
        assert!(of(&linear).contains("Lines 2021") && !of(&linear).contains("Lyasko"), "{code}");
    }
    let gain = said("slip_beyond_fit", json!({"slip": 0.7, "soil": {"pressure_sinkage": {"n1": 0.3}}}));
    assert_eq!(gain["range"]["source"], "Ding et al. 2010, 2011");
    // A soil whose gain was tuned to tests up to a slip of 0.9 is not held to those of others.
    let tuned = |slip: f64| json!({"slip": slip, "sinkage_m": 0.02, "wheel": {"preset": "letter"}, "soil": {"preset": "soil-direct-90-smooth"}});
    assert!(post("/v1/forces", &tuned(0.9)).warned_of().is_empty());
    assert_eq!(post("/v1/forces", &tuned(0.91)).warned_of(), ["slip_beyond_fit"]);
}

#[test]
fn gains_applied_to_a_braking_wheel_are_warned_of() {
    let gain = json!({"pressure_sinkage": {"n1": 0.3}});
    assert_eq!(warned_of(json!({"slip": -0.2, "soil": gain})), ["slip_gain_extrapolated"]);
    let with_skid_gain = json!({"pressure_sinkage": {"n1": 0.3, "n2": 0.2}});
    assert!(warned_of(json!({"slip": -0.2, "soil": with_skid_gain})).is_empty());
    let from_static = json!({"slip": -0.2, "sinkage_m": null, "static_sinkage_m": 0.01});
    assert_eq!(warned_of(from_static), ["slip_sinkage_extrapolated", "normal_force_drifts"]);
    assert!(warned_of(json!({"slip": 0.2, "soil": gain})).is_empty());
}

#[test]
fn a_negative_cohesive_modulus_near_its_limit_is_warned_of() {
    // b = 0.1 m: the modulus vanishes at k_c = −b k_φ = −75 413 and is half of k_φ at −37 706.5.
    let k_c = |k_c: f64| json!({"soil": {"pressure_sinkage": {"k_c": k_c}}});
    assert!(warned_of(k_c(-37_700.0)).is_empty());
    assert_eq!(warned_of(k_c(-37_710.0)), ["negative_cohesive_modulus"]);
    assert_eq!(post("/v1/forces", &with(&tested(), k_c(-75_413.0))).pointers(), ["/soil/pressure_sinkage"]);
}

#[test]
fn a_soil_of_the_moon_or_mars_is_warned_of_by_its_gravity() {
    for (soil, gravity) in [("lunar-apollo-nominal", 1.62), ("zhurong-sand-marssim", 3.71)] {
        let body = with(&tested(), json!({"soil": null}));
        let reply = post("/v1/forces", &with(&body, json!({"soil": {"preset": soil}}))).ok();
        let warnings = reply["warnings"].as_array().expect("warnings");
        let warning = warnings.iter().find(|warning| warning["code"] == "low_gravity").expect("a warning");
        assert_eq!(warning["range"]["value"], gravity, "{soil}");
    }
}

#[test]
fn a_warning_names_value_range_and_source() {
    let reply = post("/v1/forces", &letter()).ok();
    let warning = &reply["warnings"][0];
    assert_eq!(warning["code"], "small_wheel");
    assert_eq!(warning["range"]["value"], 0.4);
    assert_eq!(warning["range"]["lower"], 0.5);
    assert!(warning["range"]["upper"].is_null());
    assert_eq!(warning["range"]["source"], "Meirion-Griffith & Spenko 2011");
    assert_eq!(warning["range"]["quantity"], "diameter (m)");
    for (name, value) in
        [("quantity", json!("diameter")), ("value", json!(0.4)), ("unit", json!("m")), ("pointer", json!("/wheel/radius_m"))]
    {
        assert_eq!(warning[name], value, "{name}");
    }
    let detail = warning["detail"].as_str().expect("a detail");
    assert!(detail.starts_with("Diameter is 0.4 m, below 0.5 m (Meirion-Griffith & Spenko 2011). Bekker's law"), "{detail}");
}

#[test]
fn every_code_is_listed_with_its_range_and_source() {
    let model = get("/v1/model").ok();
    let listed = model["warnings"].as_array().expect("warnings");
    let of = |code: &str| listed.iter().find(|warning| warning["code"] == code).unwrap_or_else(|| panic!("{code} is not listed"));
    for code in [
        "small_wheel",
        "deep_sinkage",
        "slip_beyond_fit",
        "slip_gain_extrapolated",
        "slip_sinkage_extrapolated",
        "negative_cohesive_modulus",
        "low_gravity",
        "bulldozing_not_mobilised",
    ] {
        let warning = of(code);
        assert!(warning["source"].is_string() && (warning["lower"].is_number() || warning["upper"].is_number()), "{code}");
    }
    for code in [
        "lug_height_assumed",
        "integration_error",
        "load_residual",
        "mirrored",
        "no_solution",
        "points_raised",
        "bulldozing_left_out",
    ] {
        assert!(of(code)["meaning"].is_string());
    }
}

/// Whoever reads the list learns what is meant, and of the model's own warnings what to do.
#[test]
fn every_warning_is_explained_in_sentences() {
    let model = get("/v1/model").ok();
    let listed = model["warnings"].as_array().expect("warnings");
    let is_told = |text: &Value| text.as_str().is_some_and(|text| text.ends_with('.') && !text.starts_with(char::is_lowercase));
    for warning in listed {
        assert!(is_told(&warning["meaning"]), "{warning}");
        assert!(warning["advice"].is_null() || is_told(&warning["advice"]), "{warning}");
        assert!(warning["quantity"].is_null() || warning["advice"].is_string(), "{warning}");
    }
    assert!(listed.len() > 50, "{} warnings", listed.len());
}

#[test]
fn a_backward_wheel_keeps_the_rovers_axes_and_says_so() {
    let forward = post("/v1/forces", &with(&letter(), velocities(0.16, 1.0))).ok();
    let answer = post("/v1/forces", &with(&letter(), velocities(-0.16, -1.0)));
    assert!(answer.warned_of().contains(&"mirrored".into()));
    let back = answer.ok();
    let number = |reply: &Value, name: &str| reply[name].as_f64().expect("a number");
    for (name, sign) in [("longitudinal_force_n", -1.0), ("torque_n_m", -1.0), ("normal_force_n", 1.0), ("slip", 1.0)] {
        assert_eq!(number(&back, name), sign * number(&forward, name), "{name}");
    }
}

fn velocities(forward: f64, angular: f64) -> Value {
    json!({"slip": null, "forward_velocity_m_s": forward, "angular_velocity_rad_s": angular})
}

/// What a wheel or a soil in another unit says of itself, where no bound refuses it.
#[test]
fn a_value_far_beyond_the_catalogue_is_told() {
    let outside = |changes: Value| -> Vec<(String, f64)> {
        let reply = post("/v1/forces", &with(&tested(), changes)).ok();
        let warnings = reply["warnings"].as_array().expect("warnings").clone();
        let found = warnings.iter().filter(|warning| warning["code"] == "outside_catalogue").map(|warning| {
            let range = &warning["range"];
            assert_eq!(range["source"], "the catalogue of this service");
            let value = range["value"].as_f64().expect("a value");
            let above = range["upper"].as_f64().is_some_and(|upper| value > upper);
            assert!(above || range["lower"].as_f64().is_some_and(|lower| value < lower), "{warning}");
            (range["quantity"].as_str().expect("a quantity").to_owned(), value)
        });
        found.collect()
    };
    let soil = |changes: Value| json!({"soil": changes});
    let law = |changes: Value| json!({"soil": {"pressure_sinkage": changes}});
    for (changes, quantity, value) in [
        (json!({"wheel": {"radius_m": 90}}), "wheel radius (m)", 90.0),
        (json!({"wheel": {"width_m": 10}}), "wheel width (m)", 10.0),
        (json!({"wheel": {"lug_height_m": 0.2}}), "lug height (m)", 0.2),
        (json!({"wheel": {"lug_height_m": 0.07, "radius_m": 0.1}}), "lug height over radius (–)", 0.07 / 0.1),
        (soil(json!({"cohesion_pa": 1.04})), "cohesion (Pa)", 1.04),
        (soil(json!({"cohesion_pa": 1_040_000})), "cohesion (Pa)", 1.04e6),
        (soil(json!({"friction_angle_rad": 1.2})), "friction angle (rad)", 1.2),
        (soil(json!({"shear_modulus_m": 2.5})), "displacement by which the shear law scales (m)", 2.5),
        (soil(json!({"unit_weight_n_m3": 15.7})), "unit weight (N/m³)", 15.7),
        (law(json!({"k_phi": 1528, "k_c": 0})), "k_phi (N/m^(n+2))", 1528.0),
        (law(json!({"k_phi": 1e9, "k_c": -700_000})), "|k_c| (N/m^(n+1))", 700_000.0),
    ] {
        let found = outside(changes.clone());
        assert!(found.iter().any(|(name, found)| name == quantity && *found == value), "{changes}: {found:?}");
    }
    for changes in [json!({}), soil(json!({"cohesion_pa": 0, "friction_angle_rad": 0})), soil(json!({"cohesion_pa": 200_000}))] {
        assert_eq!(outside(changes.clone()), [], "{changes}");
    }
}

/// A catalogue cannot be outside itself, and what it has is told of everywhere alike.
#[test]
fn presets_lie_within_the_catalogue_and_every_answer_tells_of_what_does_not() {
    let codes = |path: &str, body: &Value| post(path, body).warned_of();
    for list in ["wheels", "soils"] {
        let listed = get(&format!("/v1/{list}")).ok();
        for entry in listed[list].as_array().expect("a list").iter().filter(|entry| entry["missing"] == json!([])) {
            let whole = if list == "wheels" { "wheel" } else { "soil" };
            let body = with(&letter(), json!({whole: null, "method": "explicit"}));
            let answer = post("/v1/forces", &with(&body, json!({whole: {"preset": entry["id"]}, "sinkage_m": 0.01})));
            assert!(!answer.warned_of().contains(&"outside_catalogue".to_owned()), "{}", entry["id"]);
        }
    }
    let body = with(&letter(), json!({"soil": {"cohesion_pa": 1.04}}));
    let loaded = with(&body, json!({"sinkage_m": null, "normal_load_n": 80}));
    let slips = json!({"slip": [0.1, 0.2]});
    for (path, body) in [
        ("/v1/forces", body.clone()),
        ("/v1/stress-profile", body.clone()),
        ("/v1/slip-sweep", with(&body, slips.clone())),
        ("/v1/compare", with(&with(&body, slips), json!({"methods": ["explicit"]}))),
        ("/v1/towed", with(&loaded, json!({"slip": null}))),
        ("/v1/coupled", with(&body, json!({"normal_load_n": 80}))),
        ("/v1/resistances", loaded.clone()),
        ("/v1/track", with(&loaded, json!({"slip": null, "columns": {"time_s": [0, 1], "slip": [0.1, 0.2]}}))),
    ] {
        assert!(codes(path, &body).contains(&"outside_catalogue".to_owned()), "{path}");
    }
}
