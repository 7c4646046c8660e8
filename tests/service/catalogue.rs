//! `GET /v1/wheels`, `/v1/soils`, `/v1/model`.

use serde_json::{Value, json};

use crate::asking::{get, with};

/// The entries of a list of the catalogue.
pub(crate) fn entries(path: &str, name: &str) -> Vec<Value> {
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
    let model = get("/v1/model").ok();
    // The parameters of a family, each once, but those that every soil has.
    let of = |pointer: &str| {
        let family = model["laws"].as_array().expect("families").iter().find(|family| family["pointer"] == pointer).expect("it");
        let mut names: Vec<String> = Vec::new();
        for parameter in
            family["laws"].as_array().expect("laws").iter().flat_map(|law| law["parameters"].as_array().expect("them"))
        {
            let name = parameter["name"].as_str().expect("a name");
            if !["shear_modulus_m", "unit_weight_n_m3", "c3"].contains(&name) && !names.iter().any(|known| known == name) {
                names.push(name.to_owned());
            }
        }
        names.join(",")
    };
    let (laws, shear, rules) = (of("/soil/pressure_sinkage"), of("/soil/shear"), of("/contact"));
    assert!(laws.contains("k_c,k_phi,n0,n1,n2,k_s,k,m") && shear == "residual_ratio,peak_displacement_m" && rules == "c1,c2");
    let soils = format!(
        "id,name,kind,grade,cohesion_pa,friction_angle_rad,shear_modulus_m,lateral_shear_modulus_m,unit_weight_n_m3,\
         bulk_density_kg_m3,gravity_m_s2,granular_stiffness_n_m3,law,{laws},\
         shear_law,{shear},rule,c3,{rules}"
    );
    for (path, name, columns) in [
        ("/v1/wheels", "wheels", "id,name,kind,grade,radius_m,width_m,lug_height_m,lug_coefficient,lug_count,nominal_load_n"),
        ("/v1/soils", "soils", &*soils),
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

/// The contract and `/v1/model` say the same of a law.
#[test]
fn the_model_lists_the_laws_as_the_contract_has_them() {
    let (model, contract) = (get("/v1/model").ok(), get("/openapi.json").ok());
    let families = model["laws"].as_array().expect("families");
    for (pointer, tag, suffix) in
        [("/soil/pressure_sinkage", "law", "Law"), ("/contact", "rule", "Contact"), ("/slip_sinkage", "law", "SlipSinkage")]
    {
        let family = families.iter().find(|family| family["pointer"] == pointer).expect("the family");
        assert_eq!(family["tag"], tag);
        for law in family["laws"].as_array().expect("laws") {
            let name = law["name"].as_str().expect("a name");
            let capital = |word: &str| word[..1].to_uppercase() + &word[1..];
            let form = name.split('_').map(capital).collect::<String>() + suffix;
            let form = &contract["components"]["schemas"][&form];
            let properties = form["properties"].as_object().unwrap_or_else(|| panic!("the form of {name}"));
            let parameters = law["parameters"].as_array().expect("parameters");
            let own = properties.values().filter(|property| property.get("$ref").is_none()).count();
            assert_eq!(own, parameters.len() + 1, "{name} and its tag, beside objects of any form");
            for parameter in parameters {
                let own = parameter["name"].as_str().expect("a name");
                assert_eq!(parameter["pointer"], format!("{pointer}/{own}"));
                let property = &properties[own];
                for (ours, theirs) in [
                    ("minimum", "minimum"),
                    ("maximum", "maximum"),
                    ("exclusive_maximum", "exclusiveMaximum"),
                    ("default", "default"),
                ] {
                    assert_eq!(parameter[ours].as_f64(), property[theirs].as_f64(), "{ours} of {own} in {name}");
                }
                let meaning = parameter["meaning"].as_str().expect("a meaning");
                assert!(property["description"].as_str().is_some_and(|text| text.ends_with(meaning)), "{own} in {name}");
                let is_required = form["required"].as_array().is_some_and(|names| names.contains(&parameter["name"]));
                assert_eq!(parameter["required"], is_required, "{own} in {name}");
            }
        }
    }
    let fit = contract["components"]["schemas"]["FitStart"]["properties"].as_object().expect("starts");
    let laws = families.iter().flat_map(|family| family["laws"].as_array().expect("laws"));
    let of_laws = laws.flat_map(|law| law["parameters"].as_array().expect("parameters"));
    let all = of_laws.chain(model["parameters"].as_array().expect("parameters"));
    let fittable: std::collections::BTreeSet<&str> =
        all.filter(|parameter| parameter["fittable"] == true).filter_map(|parameter| parameter["name"].as_str()).collect();
    // The others are those of a method, of an operating point, and of an interface, which have names of their own in a fit.
    assert_eq!(fit.keys().filter(|name| !fittable.contains(name.as_str())).count(), 6, "{fittable:?}");
    assert!(fittable.iter().all(|name| fit.contains_key(*name)), "{fittable:?}");
}

#[test]
fn the_model_lists_all_errata() {
    let model = get("/v1/model").ok();
    assert_eq!(model["errata"].as_array().expect("errata").len(), 13);
    assert!(model["equations"].as_array().expect("equations").len() >= 18);
}
