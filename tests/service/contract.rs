//! What the contract promises is what the service does: examples, shapes, bounds.

use serde_json::{Value, json};

use crate::asking::{get, letter, post, query_of, with};
use crate::documents::{document, operations, with_a_name};

/// Whether `value` has the shape that the document gives to a schema.
pub(crate) fn has_shape(document: &Value, schema: &Value, value: &Value) {
    let mut schema = schema.clone();
    schema["components"] = document["components"].clone();
    let validator = jsonschema::draft202012::new(&schema).expect("a schema");
    let faults: Vec<String> = validator.iter_errors(value).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(faults.is_empty(), "{faults:?}");
}

fn numbers_agree(example: &Value, reply: &Value, at: &str) {
    match (example, reply) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().expect("a number"), b.as_f64().expect("a number"));
            // Examples are rounded to six digits.
            assert!((a - b).abs() <= 1e-5 * b.abs().max(1e-12), "{at}: {a} in the document, {b} in the reply");
        }
        (Value::Object(a), Value::Object(b)) => {
            assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>(), "{at}");
            a.iter().for_each(|(name, value)| numbers_agree(value, &b[name], &format!("{at}/{name}")));
        }
        (Value::Array(a), Value::Array(b)) => {
            assert_eq!(a.len(), b.len(), "{at}");
            a.iter().zip(b).for_each(|(a, b)| numbers_agree(a, b, at));
        }
        _ => assert_eq!(example, reply, "{at}"),
    }
}

/// The query that the examples of an operation's parameters make, with its question mark.
fn example_query(operation: &Value) -> String {
    let parameters = operation["parameters"].as_array().into_iter().flatten();
    let given = parameters.filter(|parameter| parameter["in"] == "query" && parameter.get("example").is_some());
    let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    let pairs: Vec<String> = given
        .map(|parameter| format!("{}={}", parameter["name"].as_str().expect("a name"), text(&parameter["example"])))
        .collect();
    if pairs.is_empty() { String::new() } else { format!("?{}", pairs.join("&")) }
}

#[test]
fn every_example_is_answered_as_documented() {
    let document = document();
    let mut run = 0;
    for (path, method, operation) in operations(&document) {
        let documented = &operation["responses"]["200"]["content"]["application/json"];
        if path == "/v1/batch" {
            let example =
                |content: &Value| content["content"]["text/csv"]["example"].as_str().expect("an example table").to_owned();
            let (rows, expected) = (example(&operation["requestBody"]), example(&operation["responses"]["200"]));
            let answer = crate::batch::batch("", "text/csv", rows).text;
            assert_eq!(answer.lines().next(), expected.lines().next());
            let last = |text: &str| text.lines().map(|line| line.rsplit(',').next().map(str::to_owned)).collect::<Vec<_>>();
            assert_eq!(last(&answer), last(&expected), "statuses and comments");
            run += 1;
        } else if method == "post" {
            let request = &operation["requestBody"]["content"]["application/json"];
            assert!(request["example"].is_object(), "{path} has no example");
            has_shape(&document, &request["schema"], &request["example"]);
            let reply = post(&path, &request["example"]).ok();
            has_shape(&document, &documented["schema"], &reply);
            numbers_agree(&documented["example"], &reply, &path);
            let table = crate::asking::post_for_csv(&path, &request["example"]).text;
            let example = operation["responses"]["200"]["content"]["text/csv"]["example"].as_str().expect("an example table");
            assert_eq!(table.lines().next(), example.lines().next(), "{path}");
            assert_eq!(table.lines().count(), example.lines().count(), "{path}");
            run += 1;
        } else if documented.is_object() {
            let query = example_query(&operation);
            let path = with_a_name(&path);
            let reply = get(&format!("{path}{query}")).ok();
            has_shape(&document, &documented["schema"], &reply);
            if documented["example"].is_object() {
                has_shape(&document, &documented["schema"], &documented["example"]);
            }
            if !query.is_empty() {
                numbers_agree(&documented["example"], &reply, &path);
            }
            run += 1;
        }
    }
    assert!(run >= 10, "only {run} operations were asked");
}

#[test]
fn replies_of_all_kinds_have_the_documented_shape() {
    let document = document();
    let schema_of =
        |path: &str| document["paths"][path]["post"]["responses"]["200"]["content"]["application/json"]["schema"].clone();
    for changes in [json!({"slip": -1}), json!({"slip": 1}), json!({"slip": -0.5, "soil": {"pressure_sinkage": {"n1": 0.2}}})] {
        for method in ["quadrature", "linearised", "explicit"] {
            let body = with(&with(&letter(), json!({"method": method})), changes.clone());
            has_shape(&document, &schema_of("/v1/forces"), &post("/v1/forces", &body).ok());
        }
    }
    let gaps = json!({"slip": {"from": -1, "to": 1, "points": 21}, "contact": {"rule": "wong_reece", "c1": 0.5, "c2": 1.0}});
    has_shape(&document, &schema_of("/v1/slip-sweep"), &post("/v1/slip-sweep", &with(&letter(), gaps)).ok());
    let problem = json!({"$ref": "#/components/schemas/Problem"});
    has_shape(&document, &problem, &post("/v1/forces", &json!({"slip": 3})).problem(422));
    has_shape(&document, &problem, &crate::asking::post_text("/v1/forces", "{").problem(400));
    has_shape(&document, &problem, &get("/nope").problem(404));
}

/// A number with bounds in a request schema: where it is, and the variants chosen on the way there.
struct Bounded {
    pointer: String,
    schema: Value,
    /// The tagged objects around it, with the tag's value: pointer, tag, value.
    variants: Vec<(String, String, String)>,
}

fn bounded_numbers(
    document: &Value,
    schema: &Value,
    pointer: &str,
    variants: &[(String, String, String)],
    found: &mut Vec<Bounded>,
) {
    if let Some(target) = schema["$ref"].as_str() {
        let target = document.pointer(&target[1..]).expect("a schema");
        return bounded_numbers(document, target, pointer, variants, found);
    }
    if let Some(options) = schema["oneOf"].as_array() {
        // Values without a word are those of the forms, once more; tests of the presets have them.
        let is_without_word = |option: &&Value| option["$ref"].as_str().is_some_and(|target| target.ends_with("Values"));
        for option in options.iter().filter(|option| !is_without_word(option)) {
            let target = option["$ref"].as_str().and_then(|target| document.pointer(&target[1..]));
            let option = target.unwrap_or(option);
            let mut variants = variants.to_vec();
            for (name, property) in option["properties"].as_object().into_iter().flatten() {
                if let (Some([tag]), None) = (property["enum"].as_array().map(Vec::as_slice), property.get("description")) {
                    variants.push((pointer.to_owned(), name.clone(), tag.as_str().expect("a tag").to_owned()));
                }
            }
            bounded_numbers(document, option, pointer, &variants, found);
        }
    }
    for (name, property) in schema["properties"].as_object().into_iter().flatten() {
        bounded_numbers(document, property, &format!("{pointer}/{name}"), variants, found);
    }
    if schema["type"] == "array" {
        bounded_numbers(document, &schema["items"], &format!("{pointer}/0"), variants, found);
    }
    if schema["type"] == "number" || schema["type"] == "integer" {
        found.push(Bounded { pointer: pointer.to_owned(), schema: schema.clone(), variants: variants.to_vec() });
    }
}

/// A comparison with a variant that has the law around the field, where the request itself has another.
fn variation(path: &str, field: &Bounded, value: f64) -> Value {
    let own = |pointer: &str| {
        let below = pointer.strip_prefix("/variants/0").expect("a field of a variant");
        let of_soil = ["/shear", "/pressure_sinkage"].iter().any(|law| below.starts_with(law));
        format!("{}{below}", if of_soil { "/soil" } else { "" })
    };
    let variants = field.variants.iter().map(|(pointer, tag, name)| (own(pointer), tag.clone(), name.clone())).collect();
    let same = Bounded { pointer: own(&field.pointer), schema: field.schema.clone(), variants };
    let body = surroundings(path, &same, value);
    let part = field.pointer.split('/').nth(3).expect("a part of a variant");
    let law = body.pointer(&own(&format!("/variants/0/{part}"))).expect("the law").clone();
    let without = with(&body, json!({part: null, "soil": {part: null}}));
    let base = match part {
        "pressure_sinkage" => with(&without, json!({"soil": {part: letter()["soil"][part]}})),
        _ => without,
    };
    with(&base, json!({"variants": [{"name": "other", part: law}]}))
}

/// Values of a law that make a firm soil: a modulus has an exponent in its unit, the rest has none.
fn usual_values(law: &str) -> Value {
    let model = get("/v1/model").ok();
    let families = model["laws"].as_array().expect("families").clone();
    let laws = families.iter().flat_map(|family| family["laws"].as_array().expect("laws"));
    let law = laws.into_iter().find(|known| known["name"] == law).expect("the law");
    let required = law["parameters"].as_array().expect("parameters").iter().filter(|parameter| parameter["required"] == true);
    let is_modulus = |parameter: &Value| parameter["unit"].as_str().is_some_and(|unit| unit.contains('^'));
    let value = |parameter: &Value| if is_modulus(parameter) { 1e6 } else { 1.0 };
    required.map(|parameter| (parameter["name"].as_str().expect("a name").to_owned(), json!(value(parameter)))).collect()
}

/// A request around the field in which both its bounds are physically possible.
fn surroundings(path: &str, field: &Bounded, value: f64) -> Value {
    if field.pointer.starts_with("/variants/") {
        return variation(path, field, value);
    }
    if let Some(below) = field.pointer.strip_prefix("/stations/0").filter(|below| below.starts_with("/soil")) {
        // The soil of a station, as that of the rover.
        let variants =
            field.variants.iter().map(|(at, tag, value)| (at.replacen("/stations/0", "", 1), tag.clone(), value.clone()));
        let of_rover = Bounded { pointer: below.to_owned(), schema: field.schema.clone(), variants: variants.collect() };
        let body = surroundings(path, &of_rover, value);
        let stations = json!([{"x_m": 0, "wheel": letter()["wheel"], "soil": body["soil"]}]);
        return with(&body, json!({"wheels": null, "soil": null, "stations": stations}));
    }
    if let Some(mut body) = curves(path) {
        set(&mut body, &field.pointer, &field.schema, value);
        return body;
    }
    let sweep = path == "/v1/slip-sweep" || path == "/v1/compare";
    let slip = |slip: f64| if sweep { json!({"from": slip, "to": slip, "points": 2}) } else { json!(slip) };
    let mut body = with(&letter(), json!({"slip": slip(0.0)}));
    if path == "/v1/coupled" {
        body = with(&body, json!({"normal_load_n": 80}));
    }
    if path == "/v1/resistances" {
        body = with(&body, json!({"sinkage_m": null, "normal_load_n": 1e-9})); // light enough for the softest soil
    }
    let law_of = |object: &str| field.variants.iter().find(|(pointer, _, _)| pointer == object).map(|(_, _, law)| law.as_str());
    let law = law_of("/soil/pressure_sinkage").unwrap_or("bekker");
    let parameters = match (law, field.pointer.rsplit('/').next()) {
        ("bekker", Some("k_c")) => json!({"k_c": 0, "k_phi": 1e12, "n0": 1}),
        ("bekker", _) => json!({"k_c": 1e9, "k_phi": 1e6, "n0": 1}),
        ("direct", _) => json!({"k_s": 1e6, "n0": 1}),
        ("reece", Some("k_c")) => json!({"k_c": 0, "k_phi": 100, "unit_weight_n_m3": 1e4, "n0": 1}),
        ("reece", _) => json!({"k_c": 1e9, "k_phi": 1, "unit_weight_n_m3": 1e3, "n0": 1}),
        _ => usual_values(law),
    };
    let around_law = match (law, field.pointer.rsplit('/').next()) {
        ("reece", Some("k_c")) => json!({"cohesion_pa": 0}),
        _ => json!({"cohesion_pa": 1000}),
    };
    let around = match field.pointer.as_str() {
        "/wheel/radius_m" if path == "/v1/resistances" => json!({}),
        "/wheel/radius_m" => json!({"sinkage_m": 5e-4}),
        pointer if pointer.starts_with("/soil/pressure_sinkage") => {
            body = with(&body, json!({"soil": {"pressure_sinkage": null}}));
            json!({"soil": with(&around_law, json!({"pressure_sinkage": with(&parameters, json!({"law": law}))}))})
        }
        pointer if pointer.starts_with("/soil/shear/") => {
            let parameters = match law_of("/soil/shear") {
                Some("wong_residual") => json!({"law": "wong_residual", "residual_ratio": 0.66, "peak_displacement_m": 0.02}),
                law => json!({"law": law, "peak_displacement_m": 0.02}),
            };
            json!({"soil": {"shear": parameters}})
        }
        "/slip_sinkage/gain" => json!({"sinkage_m": null, "static_sinkage_m": 0.01, "slip_sinkage": {"law": "linear"}}),
        "/slip_sinkage/skid_gain" => {
            json!({"sinkage_m": null, "static_sinkage_m": 0.01, "slip_sinkage": {"law": "linear", "gain": 1}})
        }
        "/contact/c1" => {
            json!({"contact": {"rule": "wong_reece", "c2": if value > 0.5 { -1.5 } else { 1.5 }}, "slip": slip(1.0)})
        }
        "/contact/c2" => {
            json!({"contact": {"rule": "wong_reece", "c1": if value > 0.0 { 0.0 } else { 1.0 }}, "slip": slip(0.25)})
        }
        "/contact/c3" => json!({"contact": {"c1": 0.65, "c2": 0}}),
        "/longitudinal_force_n" | "/drawbar_coefficient" if path == "/v1/forces" => json!({"slip": null}),
        "/forward_velocity_m_s" if path == "/v1/vehicle" => json!({}),
        "/forward_velocity_m_s" => json!({"slip": null, "angular_velocity_rad_s": 5.0_f64.copysign(value)}),
        "/angular_velocity_rad_s" => json!({"slip": null, "forward_velocity_m_s": 1.0_f64.copysign(value)}),
        "/normal_load_n" if path == "/v1/coupled" => json!({}),
        "/sinkage_m" => json!({"wheel": {"radius_m": 100}}),
        "/static_sinkage_m" => json!({"sinkage_m": null, "wheel": {"radius_m": 100}}),
        "/normal_load_n" => {
            json!({"sinkage_m": null, "wheel": {"radius_m": 100, "width_m": 100}, "soil": {"pressure_sinkage": {"k_phi": 1e9}}})
        }
        "/slip/from" => json!({"slip": {"to": 0, "points": 3}}),
        "/slip/to" => json!({"slip": {"from": 0, "points": 3}}),
        "/slip/points" => json!({"slip": {"from": 0, "to": 1}}),
        "/slip/0" => json!({"slip": [0, 0.1]}),
        "/lambda_a" | "/lambda_b" if path == "/v1/compare" => json!({"methods": ["explicit"]}),
        "/lambda_a" | "/lambda_b" => json!({"method": "explicit"}),
        pointer if pointer.starts_with("/thresholds/") => json!({"thresholds": {}}),
        pointer if pointer.starts_with("/strength/") => json!({"strength": {}}),
        _ => json!({}),
    };
    let mut body = with(&body, around);
    if path == "/v1/track" {
        let columns = json!({"time_s": [0, 1], "slip": [0, 0.1]});
        let given = if field.pointer == "/normal_load_n" { "normal_load_n" } else { "static_sinkage_m" };
        body = with(&body, json!({"slip": null, "sinkage_m": null, given: 1e-4, "columns": columns}));
        if field.pointer.starts_with("/strength/") {
            body = with(
                &body,
                json!({"columns": {"sinkage_m": [0.001, 0.002], "torque_n_m": [0.1, 0.2], "normal_load_n": [10, 10]}}),
            );
        }
    }
    for (pointer, tag, name) in &field.variants {
        if tag == "rule" {
            body = with(&body, json!({"contact": {"rule": name}}));
            if name != "wong_reece" {
                body = with(&body, json!({"contact": {"c1": null, "c2": null}}));
            }
        }
        assert!(body.pointer(pointer).is_some() || path == "/v1/identify", "{pointer}");
    }
    for object in ["exit", "interface"].into_iter().filter(|object| field.pointer.starts_with(&format!("/contact/{object}/"))) {
        body = with(&body, json!({"contact": {"rule": "midpoint", "c1": null, "c2": null, "c3": null, object: {}}}));
    }
    // An interface is no stronger than its soil.
    if field.pointer == "/contact/interface/friction_angle_rad" {
        let friction = value.clamp(0.0, std::f64::consts::FRAC_PI_2.next_down());
        // Without friction it is the adhesion that turns a towed wheel.
        body = with(&body, json!({"soil": {"friction_angle_rad": friction, "cohesion_pa": 200}}));
    }
    if field.pointer == "/contact/interface/adhesion_pa" {
        body = with(&body, json!({"soil": {"cohesion_pa": value.clamp(0.0, 1e8)}}));
    }
    if path == "/v1/identify" {
        body = identification(&body, &field.pointer);
    }
    if path == "/v1/towed" {
        // So light that the smallest wheel and the weakest soil carry it, at a skid that the contact has room for.
        let light = field.pointer.starts_with("/wheel/") || field.pointer.starts_with("/soil/pressure_sinkage");
        let load = if light { 1e-3 } else { 10.0 };
        body = with(&body, json!({"slip": null, "sinkage_m": null, "normal_load_n": load}));
        if field.pointer == "/soil/friction_angle_rad" {
            body = with(&body, json!({"soil": {"cohesion_pa": 100}})); // something has to turn the wheel
        }
    }
    if path == "/v1/vehicle" {
        body = rover(&body, &field.pointer);
    }
    set(&mut body, &field.pointer, &field.schema, value);
    body
}

/// A rover on the wheel and the soil of `body`. In a list of slopes, what the model refuses is a gap.
fn rover(body: &Value, pointer: &str) -> Value {
    let wheel = &letter()["wheel"];
    let stations = [0.3, -0.3].map(|x| json!({"x_m": x, "wheel": wheel}));
    let slope = match pointer {
        "/slope_rad/from" => json!({"to": 0, "points": 3}),
        "/slope_rad/to" => json!({"from": 0, "points": 3}),
        "/slope_rad/points" => json!({"from": 0, "to": 0.1}),
        _ => json!([0]),
    };
    let alone = ["slip", "sinkage_m", "static_sinkage_m", "normal_load_n", "wheel"].map(|name| (name.to_owned(), Value::Null));
    let body = with(&with(body, Value::Object(alone.into_iter().collect())), json!({"mass_kg": 20, "slope_rad": slope}));
    let wheels = match pointer.split('/').nth(1) {
        Some("stations") => json!({"stations": stations}),
        Some("hitch_height_m") => json!({"stations": stations, "centre_of_mass": {"x_m": 0}}),
        Some("centre_of_mass") => json!({"stations": stations, "centre_of_mass": {"x_m": 0}}),
        Some("unloading") => json!({"stations": stations, "rut": true, "unloading": {}}),
        _ => json!({"wheels": {"count": 4, "wheel": wheel}}),
    };
    with(&body, wheels)
}

/// Curves of two tests, for the operations that take them.
fn curves(path: &str) -> Option<Value> {
    let plate =
        |width: f64| json!({"width_m": width, "columns": {"sinkage_m": [0.01, 0.02, 0.03], "pressure_pa": [8e3, 2e4, 3e4]}});
    let test = |normal: f64| json!({"normal_stress_pa": normal, "columns": {"displacement_m": [0.01, 0.02, 0.03], "shear_stress_pa": [0.4 * normal, 0.5 * normal, 0.6 * normal]}});
    match path {
        "/v1/identify/plates" => Some(json!({"plates": [plate(0.1), plate(0.2)]})),
        "/v1/identify/shear" => Some(json!({"curves": [test(1e3), test(5e3)]})),
        _ => None,
    }
}

/// The request for forces `body` as a fit to two samples in which the field at `pointer` may have its bounds.
fn identification(body: &Value, pointer: &str) -> Value {
    let name = pointer.trim_end_matches("/0").rsplit('/').next().expect("a name");
    let sinkage = body["sinkage_m"].as_f64().unwrap_or(0.01);
    let slip = body["slip"].clone();
    let column = if pointer.starts_with("/standard_deviation") && name != "sinkage_m" { name } else { "torque_n_m" };
    let data = json!({"slip": [slip.clone(), slip], "sinkage_m": [sinkage, 0.5 * sinkage], column: [4.0, 1.0]});
    let changes = json!({"slip": null, "sinkage_m": null, "static_sinkage_m": null, "method": "linearised", "data": data});
    let fit = if pointer.starts_with("/start/") { name } else { "friction_angle_rad" };
    let mut body = with(&with(body, changes), json!({"fit": [fit]}));
    let around = match pointer {
        "/lambda_a" | "/lambda_b" => json!({"method": "explicit"}),
        "/slip_sinkage/gain" | "/slip_sinkage/skid_gain" => json!({"fit": ["static_sinkage_m"]}),
        "/start/k_s" => {
            body = with(&body, json!({"soil": {"pressure_sinkage": null}}));
            json!({"soil": {"pressure_sinkage": {"law": "direct", "n0": 1}}, "start": {}})
        }
        "/start/c1" | "/start/c2" => json!({"contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.1}, "start": {}}),
        "/start/lambda_a" | "/start/lambda_b" => json!({"method": "explicit", "start": {}}),
        "/start/granular_stiffness_n_m3" => json!({"method": "resistive_force", "start": {}}),
        "/start/interface_adhesion_pa" => json!({"start": {}, "soil": {"cohesion_pa": 1e8}}),
        "/start/interface_friction_angle_rad" => {
            json!({"start": {}, "soil": {"friction_angle_rad": std::f64::consts::FRAC_PI_2.next_down()}})
        }
        _ if pointer.starts_with("/bounds/interface_adhesion_pa") => json!({"soil": {"cohesion_pa": 1e8}}),
        _ if pointer.starts_with("/start/") => json!({"start": {}}),
        "/standard_deviation/sinkage_m/0" => json!({"standard_deviation": {name: [1.0, 1.0]}}),
        _ if pointer.starts_with("/standard_deviation") && pointer.ends_with("/0") => {
            json!({"standard_deviation": {name: [1, 1]}})
        }
        _ if pointer.starts_with("/standard_deviation") => json!({"standard_deviation": {}}),
        "/data/sinkage_m/0" => json!({"wheel": {"radius_m": 100}}),
        _ if pointer.starts_with("/data/") && name != "slip" => json!({"data": {name: [1.0, 2.0]}}),
        _ => json!({}),
    };
    with(&body, around)
}

fn set(body: &mut Value, pointer: &str, schema: &Value, value: f64) {
    let value = if schema["type"] == "integer" { json!(value as i64) } else { json!(value) };
    let (parent, name) = pointer.rsplit_once('/').expect("a pointer");
    match body.pointer_mut(parent).expect("an object around the field") {
        Value::Object(fields) => {
            fields.insert(name.to_owned(), value);
        }
        Value::Array(items) => items[0] = value,
        other => panic!("{other}"),
    }
}

#[test]
fn every_numeric_bound_is_enforced_just_outside_and_accepted_on_the_edge() {
    let document = document();
    let mut checked = 0;
    for (path, method, operation) in operations(&document) {
        // These take the requests of other operations, and numbers whose bounds are those of the field that varies.
        if method != "post" || ["/v1/sweep", "/v1/uncertainty", "/v1/optimum", "/v1/batch"].contains(&path.as_str()) {
            continue;
        }
        let mut fields = Vec::new();
        bounded_numbers(&document, &operation["requestBody"]["content"]["application/json"]["schema"], "", &[], &mut fields);
        // The two bounds of a fitted parameter have to be in order as well; tests of the identification have them.
        for field in fields.iter().filter(|field| !field.pointer.starts_with("/bounds/")) {
            let bound = |name: &str| field.schema[name].as_f64();
            let whole = field.schema["type"] == "integer";
            let min = bound("minimum").unwrap_or_else(|| panic!("{path}{} has no lower bound", field.pointer));
            let (edge, outside) = match (bound("maximum"), bound("exclusiveMaximum")) {
                (Some(max), None) => (max, if whole { max + 1.0 } else { max.next_up() }),
                (None, Some(max)) => (max.next_down(), max),
                _ => panic!("{path}{} has no upper bound", field.pointer),
            };
            for (value, accepted) in
                [(min, true), (edge, true), (if whole { min - 1.0 } else { min.next_down() }, false), (outside, false)]
            {
                let body = surroundings(&path, field, value);
                let answer = post(&path, &body);
                // A query has no lists, such as the stations of a rover.
                let in_a_query =
                    !field.pointer.ends_with("/0") && body.get("stations").is_none() && !body["slope_rad"].is_array();
                if document["paths"][&path].get("get").is_some() && in_a_query {
                    let twin = get(&format!("{path}?{}", query_of(&body)));
                    assert_eq!((twin.status, &twin.text), (answer.status, &answer.text), "{path}?{}", query_of(&body));
                }
                let place = format!("{path} {} = {value:e} in {body}", field.pointer);
                let is_pull = ["/longitudinal_force_n", "/drawbar_coefficient"].contains(&field.pointer.as_str());
                if accepted && is_pull {
                    // Within the bounds, but beyond what any wheel pulls.
                    assert!(answer.fault(&field.pointer).starts_with("no slip gives"), "{place}: {}", answer.text);
                } else if accepted {
                    assert_eq!(answer.status, 200, "{place}: {}", answer.text);
                } else {
                    assert_eq!(answer.pointers(), [field.pointer.as_str()], "{place}");
                    assert!(answer.fault(&field.pointer).starts_with("must be"), "{place}");
                }
                checked += 1;
            }
        }
    }
    assert!(checked > 4 * 100, "only {checked} bounds were tried");
}
