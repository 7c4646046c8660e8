//! `GET /v1/wheels`, `/v1/soils`, `/v1/model`, and the catalogue's entries in requests.

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

#[test]
fn every_soil_computes_as_a_preset_or_says_which_fields_are_missing() {
    let mut incomplete = 0;
    for soil in entries("/v1/soils", "soils") {
        let preset = request_with("soil", &json!({"preset": soil["id"]}));
        let missing = names(&soil["missing"]);
        let answer = post("/v1/forces", &preset);
        if missing.is_empty() {
            let spelled = with(&request_with("soil", &soil["soil"]), json!({"contact": soil["contact"]}));
            assert_eq!(answer.ok(), post("/v1/forces", &spelled).ok(), "{}", soil["id"]);
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
    let without_warnings = |answer: crate::asking::Answer| with(&answer.ok(), json!({"warnings": null}));
    let mut incomplete = 0;
    for wheel in entries("/v1/wheels", "wheels") {
        let preset = request_with("wheel", &json!({"preset": wheel["id"]}));
        let missing = names(&wheel["missing"]);
        let answer = post("/v1/forces", &preset);
        if missing.is_empty() {
            let spelled = request_with("wheel", &wheel["wheel"]);
            assert_eq!(without_warnings(answer), without_warnings(post("/v1/forces", &spelled)), "{}", wheel["id"]);
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

fn codes(answer: &Value) -> Vec<&str> {
    let warnings = answer["warnings"].as_array().expect("warnings");
    warnings.iter().map(|warning| warning["code"].as_str().expect("a code")).collect()
}

#[test]
fn a_wheel_whose_lug_height_is_not_published_says_that_it_is_computed_as_smooth() {
    let mut assumed = 0;
    for wheel in entries("/v1/wheels", "wheels") {
        let width = if names(&wheel["missing"]).is_empty() { json!({}) } else { json!({"width_m": 0.1}) };
        let preset = with(&width, json!({"preset": wheel["id"]}));
        let answer = post("/v1/forces", &request_with("wheel", &preset)).ok();
        let says_so = codes(&answer) == ["lug_height_assumed"];
        assert_eq!(says_so, names(&wheel["assumed"]) == ["lug_height_m"], "{}", wheel["id"]);
        if says_so {
            assumed += 1;
            assert!(wheel["wheel"]["lug_height_m"].is_null());
            let given = post("/v1/forces", &request_with("wheel", &with(&preset, json!({"lug_height_m": 0}))));
            assert_eq!(given.ok(), with(&answer, json!({"warnings": []})), "the same wheel, known to be smooth");
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
        assert_eq!(codes(&post(path, &with(&zhurong, changes)).ok()), ["lug_height_assumed"], "{path}");
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

#[test]
fn the_lists_can_be_had_by_kind() {
    for (path, name, kinds) in [
        ("/v1/wheels", "wheels", vec!["paper", "flight", "test", "terrestrial"]),
        (
            "/v1/soils",
            "soils",
            vec![
                "paper",
                "lunar",
                "lunar simulant",
                "test-bed sand",
                "martian",
                "terrestrial",
                "snow",
                "martian simulant",
                "synthetic",
            ],
        ),
    ] {
        let all = entries(path, name);
        let mut listed = 0;
        for kind in &kinds {
            let expected: Vec<&Value> = all.iter().filter(|entry| entry["kind"] == *kind).collect();
            let found = entries(&format!("{path}?kind={}", kind.replace(' ', "%20")), name);
            assert_eq!(found.iter().collect::<Vec<_>>(), expected, "{kind}");
            assert_eq!(entries(&format!("{path}?kind={}", kind.replace(' ', "+")), name).len(), expected.len());
            listed += found.len();
        }
        assert_eq!(listed, all.len());
        let detail = get(&format!("{path}?kind=venusian")).fault("/kind");
        assert!(kinds.iter().all(|kind| detail.contains(kind)), "{detail}");
        assert_eq!(get(&format!("{path}?knd=paper")).fault("/knd"), "unknown field; did you mean `kind`?");
        assert_eq!(get(&format!("{path}?kind=paper&kind=paper")).pointers(), ["/kind"]);
        assert_eq!(get(&format!("{path}?kind=")).pointers(), ["/kind"]);
        assert_eq!(get(&format!("{path}?kind=%ff&a/b~=1")).pointers(), ["/a~1b~0", "/kind"]);
        assert_eq!(entries(&format!("{path}?"), name).len(), all.len());
    }
}

/// The rows of a table whose cells may be in quotes.
fn rows(text: &str) -> Vec<Vec<String>> {
    let row = |line: &str| {
        let (mut cells, mut quoted) = (vec![String::new()], false);
        let mut characters = line.chars().peekable();
        while let Some(c) = characters.next() {
            match c {
                '"' if quoted && characters.next_if_eq(&'"').is_some() => cells.last_mut().expect("a cell").push('"'),
                '"' => quoted = !quoted,
                ',' if !quoted => cells.push(String::new()),
                _ => cells.last_mut().expect("a cell").push(c),
            }
        }
        cells
    };
    text.lines().map(row).collect()
}

#[test]
fn the_lists_come_as_tables_too() {
    for (path, name, columns) in [
        ("/v1/wheels", "wheels", "id,name,kind,grade,radius_m,width_m,lug_height_m,lug_coefficient,lug_count,nominal_load_n"),
        (
            "/v1/soils",
            "soils",
            "id,name,kind,grade,cohesion_pa,friction_angle_rad,shear_modulus_m,lateral_shear_modulus_m,unit_weight_n_m3,\
             law,k_c,k_phi,n0,n1,n2,k_s,k,m,shear_law,residual_ratio,peak_displacement_m,rule,c3,c1,c2",
        ),
    ] {
        let table = |path: &str| crate::asking::send(crate::asking::request("GET", path, &[("accept", "text/csv")], ""));
        let answer = table(path);
        assert_eq!(answer.header("content-type"), "text/csv; charset=utf-8; header=present");
        let rows = rows(&answer.text);
        assert_eq!(rows[0].join(","), columns);
        let entries = entries(path, name);
        assert_eq!(rows.len(), entries.len() + 1);
        for (row, entry) in rows[1..].iter().zip(&entries) {
            let mut values = 0;
            assert_eq!(row.len(), rows[0].len(), "{row:?}");
            for (column, cell) in rows[0].iter().zip(row) {
                let value = &entry["values"][column]["value"];
                match column.as_str() {
                    "id" | "name" | "kind" | "grade" => assert_eq!(entry[column], *cell),
                    "law" => assert_eq!(entry["soil"]["pressure_sinkage"]["law"].as_str().unwrap_or(""), cell),
                    "shear_law" => assert_eq!(entry["soil"]["shear"]["law"].as_str().unwrap_or(""), cell),
                    "rule" => assert_eq!(entry["contact"]["rule"].as_str().unwrap_or(""), cell),
                    _ => assert_eq!(value.as_f64(), cell.parse().ok(), "{column} of {}", entry["id"]),
                }
                values += usize::from(value.is_number());
            }
            assert_eq!(values, entry["values"].as_object().expect("values").len(), "every value of {} is there", entry["id"]);
        }
        let of_kind = table(&format!("{path}?kind=paper")).text;
        assert_eq!(of_kind.lines().count(), 1 + entries.iter().filter(|entry| entry["kind"] == "paper").count());
    }
}

#[test]
fn the_model_gives_gravity_with_its_source() {
    let model = get("/v1/model").ok();
    let bodies = model["gravity"].as_array().expect("bodies");
    let of = |id: &str| bodies.iter().find(|body| body["id"] == id).expect("a body");
    // Standard gravity is 9.80665 m/s² by definition; GM/R² of Moon and Mars (km³/s², km) give the others to two decimals.
    assert_eq!(of("earth")["acceleration_m_s2"], 9.80665);
    for (id, gm, radius) in [("moon", 4902.8, 1737.4), ("mars", 42_828.0, 3396.2)] {
        let expected = gm / f64::powi(radius, 2) * 1000.0;
        assert!((of(id)["acceleration_m_s2"].as_f64().expect("a number") - expected).abs() < 0.005, "{id}: {expected}");
    }
    assert!(bodies.iter().all(|body| body["source"].as_str().is_some_and(|source| source.len() > 20)));
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
