//! Values that were never published: proposed by the catalogue, taken where a request allows it, and always told.

use serde_json::{Value, json};

use crate::asking::{get, post, post_for_csv, query_of, request, send, with};
use crate::catalogue::entries;

fn at_slip(soil: &Value, wheel: &Value) -> Value {
    json!({
        "wheel": {"preset": wheel}, "soil": {"preset": soil}, "slip": 0.2, "normal_load_n": 80, "assume": true
    })
}

fn list<'a>(value: &'a Value, name: &str) -> &'a Vec<Value> {
    value[name].as_array().unwrap_or_else(|| panic!("no list {name} in {value}"))
}

fn text<'a>(value: &'a Value, name: &str) -> &'a str {
    value[name].as_str().unwrap_or_else(|| panic!("no text {name} in {value}"))
}

/// What an answer lists, without what the service takes unasked: that a wheel of unknown lugs is smooth.
fn assumed_of(answer: &Value) -> Vec<(String, f64)> {
    let told =
        list(answer, "assumed").iter().map(|one| (text(one, "field").to_owned(), one["value"].as_f64().expect("a number")));
    told.filter(|(field, _)| field != "wheel.lug_height_m").collect()
}

/// What the catalogue proposes for an entry, without the density, which only the method resistive_force takes.
fn proposed_of(entry: &Value, part: &str) -> Vec<(String, f64)> {
    let proposed = list(entry, "assumed").iter();
    let told = proposed.map(|one| (format!("{part}.{}", text(one, "field")), one["value"].as_f64().expect("a number")));
    told.filter(|(field, _)| field != "wheel.lug_height_m" && field != "soil.bulk_density_kg_m3").collect()
}

/// Every soil of grains with friction answers by `resistive_force`: with its own density, or with that of its kind and its reason.
#[test]
fn a_density_is_assumed_for_dry_grains() {
    let (mut own, mut assumed) = (0, 0);
    for soil in entries("/v1/soils", "soils") {
        let body = with(&at_slip(&soil["id"], &json!("letter")), json!({"method": "resistive_force", "sinkage_m": 0.01}));
        let body = with(&body, json!({"normal_load_n": null}));
        let proposed: Vec<&Value> = list(&soil, "assumed").iter().filter(|one| one["field"] == "bulk_density_kg_m3").collect();
        let answer = post("/v1/forces", &body);
        if text(&soil, "kind") == "snow" {
            assert!(proposed.is_empty());
            continue;
        }
        let told = |found: &Value| list(found, "assumed").iter().find(|one| one["field"] == "soil.bulk_density_kg_m3").cloned();
        match (proposed.first(), answer.status.as_u16()) {
            (Some(proposed), 200) => {
                let found = answer.ok();
                let told = told(&found).expect("a density");
                assert_eq!((&told["value"], &told["reason"]), (&proposed["value"], &proposed["reason"]));
                assert!(answer.warned_of().contains(&"assumed_values".into()));
                // Never silently: without the flag it is required, and the fault offers it.
                let fault = post("/v1/forces", &with(&body, json!({"assume": null})));
                assert!(fault.fault("/soil/bulk_density_kg_m3").contains("with \"assume\": true it is"));
                assumed += 1;
            }
            (None, 200) => {
                assert_eq!(told(&answer.ok()), None);
                own += 1;
            }
            // Soils without friction have no stiffness that would follow.
            _ => assert_eq!(answer.pointers(), ["/soil/friction_angle_rad"], "{}", soil["id"]),
        }
    }
    assert!(own > 8 && assumed > 30, "{own} {assumed}");
}

#[test]
fn every_missing_value_is_proposed_with_its_reason_and_range() {
    for (path, name) in [("/v1/soils", "soils"), ("/v1/wheels", "wheels")] {
        for entry in entries(path, name) {
            let proposed = list(&entry, "assumed");
            let names: Vec<&str> = proposed.iter().filter_map(|one| text(one, "field").split('.').next()).collect();
            assert!(list(&entry, "missing").iter().all(|missing| names.contains(&missing.as_str().expect("a name"))), "{entry}");
            for one in proposed {
                let [low, value, high] = ["low", "value", "high"].map(|name| one[name].as_f64().expect("a number"));
                assert!(
                    low <= value && value <= high && !text(one, "unit").is_empty() && text(one, "reason").len() > 20,
                    "{one}"
                );
            }
        }
    }
}

/// With 80 N every soil carries a wheel of 0.2 m by 0.1 m, or the answer says why none has a solution.
#[test]
fn every_soil_answers_with_what_it_assumed() {
    let (mut answered, mut assumed) = (0, 0);
    for soil in entries("/v1/soils", "soils") {
        let answer = post("/v1/forces", &at_slip(&soil["id"], &json!("letter")));
        if answer.status != 200 {
            assert_eq!(answer.pointers(), ["/normal_load_n"], "{}", soil["id"]);
            continue;
        }
        answered += 1;
        let found = answer.ok();
        assert_eq!(assumed_of(&found), proposed_of(&soil, "soil"), "{}", soil["id"]);
        let is_told = answer.warned_of().contains(&"assumed_values".into());
        assert_eq!(is_told, !list(&found, "assumed").is_empty());
        assumed += usize::from(is_told);
    }
    assert!(answered >= 60 && assumed >= 40, "{answered} soils answered, {assumed} of them with assumed values");
}

#[test]
fn every_wheel_answers_with_what_it_assumed() {
    let mut assumed = 0;
    for wheel in entries("/v1/wheels", "wheels") {
        let found = post("/v1/forces", &at_slip(&json!("letter-sand"), &wheel["id"])).ok();
        assert_eq!(assumed_of(&found), proposed_of(&wheel, "wheel"), "{}", wheel["id"]);
        let lugs = list(&found, "assumed").iter().any(|one| one["field"] == "wheel.lug_height_m" && one["value"] == 0.0);
        assert_eq!(lugs, list(&wheel, "assumed").iter().any(|one| one["field"] == "lug_height_m"));
        assumed += assumed_of(&found).len();
    }
    assert_eq!(assumed, 3, "the widths of three flight wheels");
}

/// Two fits of one laboratory are no range for a kind: the median and the range are those of all dry, loose soils, with their sources
/// counted.
#[test]
fn a_kind_with_few_sources_says_so() {
    let soil = get("/v1/soils/exomars-es3-med").ok();
    let proposed = list(&soil, "assumed").iter().find(|one| one["field"] == "shear_modulus_m").expect("a modulus").clone();
    // By hand from `catalogue/soils.json`: 8 moduli of 6 sources from 0.515 to 18.5 mm, 11.4 and 13 mm in the middle.
    for (name, value) in [("low", json!(0.000515)), ("value", json!(0.0122)), ("high", json!(0.0185)), ("sources", json!(6))] {
        assert_eq!(proposed[name], value, "{name}");
    }
    assert!(text(&proposed, "reason").contains("the kind `martian simulant` has 1 independent source"), "{proposed}");
    let found = post("/v1/forces", &at_slip(&json!("exomars-es3-med"), &json!("letter"))).ok();
    assert!(assumed_of(&found).contains(&("soil.shear_modulus_m".to_owned(), 0.0122)), "{found}");
}

/// A load that is known makes the modulus needless, not the exponent that the quadrature takes of the law.
#[test]
fn under_a_known_load_the_quadrature_still_assumes_a_law() {
    let asked = with(
        &at_slip(&json!("lunar-sourcebook-shear-0-15cm"), &json!("letter")),
        json!({"sinkage_m": 0.02, "soil": {"shear_modulus_m": 0.018}}),
    );
    let found = post("/v1/forces", &asked).ok();
    assert_eq!(found["normal_stress_from"], "load");
    assert!(assumed_of(&found).iter().any(|(field, _)| field == "soil.pressure_sinkage.n0"), "{found}");
    let refused = post("/v1/forces", &with(&asked, json!({"assume": null})));
    assert_eq!(refused.pointers(), ["/soil/pressure_sinkage"]);
}

/// The answer is that of a request that sends the values it lists.
#[test]
fn what_is_assumed_is_what_a_request_could_send() {
    let asked = at_slip(&json!("mars-mer-trench-range"), &json!("pragyan"));
    let found = post("/v1/forces", &asked).ok();
    let mut spelled = with(&asked, json!({"assume": null, "soil": {"pressure_sinkage": {"law": "bekker"}}}));
    for one in list(&found, "assumed") {
        let pointer = format!("/{}", text(one, "field").replace('.', "/"));
        let (around, name) = pointer.rsplit_once('/').expect("a field");
        spelled.pointer_mut(around).expect("an object")[name] = one["value"].clone();
    }
    let sent = post("/v1/forces", &spelled).ok();
    assert!(sent.get("assumed").is_none());
    for force in ["longitudinal_force_n", "normal_force_n", "torque_n_m", "sinkage_m"] {
        assert_eq!(found[force], sent[force], "{force}");
    }
}

#[test]
fn without_being_allowed_a_missing_value_is_a_fault_that_names_the_substitute() {
    let asked = at_slip(&json!("kls1"), &json!("letter"));
    for assume in [json!(null), json!(false)] {
        let answer = post("/v1/forces", &with(&asked, json!({"assume": assume})));
        assert_eq!(answer.pointers(), ["/soil/shear_modulus_m"]);
        let detail = answer.fault("/soil/shear_modulus_m");
        assert!(
            detail.contains("`kls1`") && detail.contains("\"assume\": true") && detail.contains("lunar simulant"),
            "{detail}"
        );
    }
    let law = post("/v1/forces", &with(&at_slip(&json!("mit-mms-reece"), &json!("letter")), json!({"assume": null})));
    assert!(law.fault("/soil/pressure_sinkage").contains("exomars-es3-low"));
    let wrong = post("/v1/forces", &with(&asked, json!({"assume": "yes"})));
    assert!(wrong.pointers().contains(&"/assume".to_owned()));
}

/// A value that was sent is not assumed, and a soil of its own has none to be assumed.
#[test]
fn only_what_a_preset_lacks_is_assumed() {
    let sent = with(&at_slip(&json!("kls1"), &json!("letter")), json!({"soil": {"shear_modulus_m": 0.02}}));
    assert_eq!(post("/v1/forces", &sent).ok()["assumed"], json!([]));
    let own = with(&sent, json!({"soil": null}));
    let own = with(&own, json!({"soil": {"cohesion_pa": 0, "friction_angle_rad": 0.5, "shear_modulus_m": 0.01}}));
    assert_eq!(post("/v1/forces", &own).pointers(), ["/soil/pressure_sinkage"]);
    let complete = at_slip(&json!("letter-sand"), &json!("letter"));
    let (with_list, without) =
        (post("/v1/forces", &complete).ok(), post("/v1/forces", &with(&complete, json!({"assume": null}))).ok());
    assert_eq!(with(&with_list, json!({"assumed": null})), without);
}

/// A request needs only some of a soil, and assumes no more than that.
#[test]
fn every_operation_with_presets_assumes_what_it_needs() {
    let system = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "lunar-sourcebook-shear-0-15cm"}, "assume": true});
    let law = ["k_c", "k_phi", "n0"].map(|name| format!("soil.pressure_sinkage.{name}"));
    let modulus = ["soil.shear_modulus_m".to_owned()];
    let all = [&modulus[..], &law].concat();
    let data = json!({"slip": [0.1, 0.2, 0.3], "sinkage_m": [0.01, 0.012, 0.014], "torque_n_m": [1.0, 1.5, 2.0]});
    for (path, fields, expected) in [
        ("/v1/stress-profile", json!({"slip": 0.2, "sinkage_m": 0.01}), &all[..]),
        ("/v1/slip-sweep", json!({"slip": [0.1, 0.2], "sinkage_m": 0.01}), &all),
        ("/v1/compare", json!({"slip": [0.1, 0.2], "sinkage_m": 0.01, "variants": [{"name": "a", "braking": "one_zone"}]}), &all),
        ("/v1/towed", json!({"normal_load_n": 80}), &all),
        ("/v1/coupled", json!({"slip": 0.2, "sinkage_m": 0.01, "normal_load_n": 80}), &modulus),
        ("/v1/resistances", json!({"normal_load_n": 80}), &law),
        ("/v1/resistances", json!({"normal_load_n": 80, "slip": 0.2}), &all),
        ("/v1/track", json!({"normal_load_n": 80, "columns": {"time_s": [0, 1], "slip": [0.1, 0.2]}}), &all),
        ("/v1/identify", json!({"fit": ["shear_modulus_m"], "data": data}), &law),
    ] {
        let body = with(&system, fields);
        let answer = post(path, &body);
        let found = answer.ok();
        let fields: Vec<&str> = list(&found, "assumed").iter().map(|one| text(one, "field")).collect();
        assert_eq!(fields, expected.iter().map(String::as_str).collect::<Vec<_>>(), "{path}");
        assert!(answer.warned_of().contains(&"assumed_values".into()), "{path}");
        let strict = post(path, &with(&body, json!({"assume": null})));
        assert!(!strict.pointers().is_empty(), "{path}");
    }
}

#[test]
fn queries_and_tables_tell_what_was_assumed() {
    let asked = at_slip(&json!("kls1"), &json!("letter"));
    let found = post("/v1/forces", &asked).ok();
    assert_eq!(get(&format!("/v1/forces?{}", query_of(&asked))).ok(), found);
    assert!(post_for_csv("/v1/forces", &asked).header("x-warnings").contains("assumed_values"));
    let query = query_of(&with(&asked, json!({"slip": null})));
    for (kind, body) in
        [("text/csv", "time_s,slip\n0,0.1\n1,0.2\n"), ("application/x-ndjson", "{\"time_s\": 0, \"slip\": 0.1}\n")]
    {
        let answer = send(request("POST", &format!("/v1/track?{query}"), &[("content-type", kind)], body));
        assert_eq!(answer.status, 200, "{}", answer.text);
        assert!(answer.text.contains("assumed_values") && answer.text.contains("soil.shear_modulus_m"), "{}", answer.text);
    }
}
