//! `POST /v1/batch`: rows in, rows out.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::asking::{Answer, letter, post, query_of, request, send, with};

pub(crate) const CSV: &str = "text/csv";
pub(crate) const NDJSON: &str = "application/x-ndjson";

/// Sends rows in a form and asks for the answer in the same.
pub(crate) fn batch(query: &str, form: &str, rows: impl Into<axum::body::Body>) -> Answer {
    send(request("POST", &format!("/v1/batch?{query}"), &[("content-type", form)], rows))
}

/// The fields of a request by their dotted names.
pub(crate) fn dotted(body: &Value) -> BTreeMap<String, String> {
    let pair = |pair: &str| pair.split_once('=').map(|(name, value)| (name.to_owned(), value.to_owned()));
    query_of(body).split('&').filter_map(pair).collect()
}

/// Requests as a table.
pub(crate) fn table_of(bodies: &[Value]) -> String {
    let rows: Vec<_> = bodies.iter().map(dotted).collect();
    let names: Vec<&String> =
        rows.iter().flat_map(BTreeMap::keys).collect::<std::collections::BTreeSet<_>>().into_iter().collect();
    let mut text = names.iter().map(|name| name.as_str()).collect::<Vec<_>>().join(",") + "\n";
    for row in &rows {
        let cells: Vec<&str> = names.iter().map(|name| row.get(*name).map_or("", String::as_str)).collect();
        text += &(cells.join(",") + "\n");
    }
    text
}

/// The rows of a whole table by the names of their columns, and the comments behind them. No cell has a comma.
pub(crate) fn rows_of(text: &str) -> (Vec<BTreeMap<String, String>>, Vec<String>) {
    let (comments, lines): (Vec<&str>, Vec<&str>) = text.lines().partition(|line| line.starts_with('#'));
    let names: Vec<&str> = lines[0].split(',').collect();
    let row = |line: &&str| {
        // The status stands last and may have commas of its own, within quotes.
        let cells: Vec<&str> = line.splitn(names.len(), ',').collect();
        assert_eq!(cells.len(), names.len(), "{line}");
        names.iter().map(|name| (*name).to_owned()).zip(cells.iter().map(|cell| cell.trim_matches('"').to_owned())).collect()
    };
    (lines[1..].iter().map(row).collect(), comments.into_iter().map(str::to_owned).collect())
}

/// What a single request gives in a column.
pub(crate) fn single(answer: &Value, name: &str) -> Option<u64> {
    let value = if answer["components"][name].is_null() { &answer[name] } else { &answer["components"][name] };
    value.as_f64().map(f64::to_bits)
}

/// Operating points of every kind.
pub(crate) fn points() -> Vec<Value> {
    let spelt = letter();
    let preset = |id: &str| {
        with(&spelt, json!({"soil": null, "wheel": null})).as_object().map_or(Value::Null, |rest| {
            let mut body = rest.clone();
            body.insert("wheel".into(), json!({"preset": "letter"}));
            body.insert("soil".into(), json!({"preset": id}));
            body.into()
        })
    };
    let load = json!({"sinkage_m": null, "normal_load_n": 80});
    let mut points = Vec::new();
    for method in ["quadrature", "linearised", "explicit"] {
        for body in [&spelt, &preset("letter-sand"), &preset("wong-dry-sand")] {
            points.push(with(body, json!({"method": method})));
            points.push(with(&with(body, load.clone()), json!({"method": method, "slip": -0.1})));
        }
    }
    points.push(with(&spelt, json!({"sinkage_m": null, "static_sinkage_m": 0.01})));
    points.push(with(&spelt, json!({"normal_load_n": 90})));
    points.push(with(&spelt, json!({"slip": null, "forward_velocity_m_s": -0.1, "angular_velocity_rad_s": -1})));
    points.push(with(&with(&spelt, load), json!({"slip": null, "drawbar_coefficient": 0.1})));
    points.push(with(&spelt, json!({"slip_angle_rad": 0.1})));
    let grains = json!({"friction_angle_rad": 0.5, "bulk_density_kg_m3": 1500});
    points.push(json!({"wheel": spelt["wheel"], "soil": grains, "slip": 0.1, "sinkage_m": 0.02, "method": "resistive_force"}));
    points
}

#[test]
fn every_row_is_what_forces_gives_bit_for_bit() {
    let bodies = points();
    let (rows, comments) = rows_of(&batch("", CSV, table_of(&bodies)).text);
    assert_eq!(rows.len(), bodies.len());
    assert_eq!(comments.last(), Some(&format!("#end,{}", bodies.len())));
    let mut compared = 0;
    for (body, row) in bodies.iter().zip(&rows) {
        assert_eq!(row["status"], "ok", "{body}");
        let alone = post("/v1/forces", body).ok();
        for (name, cell) in row.iter().filter(|(name, _)| *name != "status") {
            let number = (!cell.is_empty()).then(|| cell.parse::<f64>().expect("a number").to_bits());
            assert_eq!(number, single(&alone, name), "{name} of {body}");
            compared += usize::from(number.is_some());
        }
    }
    assert!(compared > 10 * bodies.len(), "{compared}");
}

#[test]
fn lines_of_objects_give_the_same_with_dots_or_objects_within() {
    let first = points().remove(0);
    // The fields of the first line are the columns, so that all lines have the same here.
    let bodies: Vec<Value> =
        (1..4).map(|i| with(&first, json!({"slip": 0.1 * f64::from(i), "soil": {"cohesion_pa": 100 * i}}))).collect();
    let within = bodies.iter().map(|body| body.to_string() + "\n").collect::<String>();
    let answer = batch("", NDJSON, within).text;
    let flat = |body: &Value| {
        let fields = dotted(body).into_iter().map(|(name, text)| {
            let value = serde_json::from_str(&text).unwrap_or(Value::String(text));
            (name, value)
        });
        Value::Object(fields.collect()).to_string() + "\n"
    };
    let lines: Vec<Value> = answer.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert_eq!(lines.len(), 4, "{answer}");
    for (body, line) in bodies.iter().zip(&lines) {
        let alone = post("/v1/forces", body).ok();
        for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m", "traction_n", "sinkage_m"] {
            assert_eq!(line[name].as_f64().map(f64::to_bits), single(&alone, name), "{name}");
        }
        assert_eq!(line["status"], "ok");
    }
    assert_eq!((&lines[3]["end"], &lines[3]["rows"]), (&json!(true), &json!(3)));
    let rows = |text: &str| text.lines().take(3).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(rows(&batch("", NDJSON, bodies.iter().map(flat).collect::<String>()).text), rows(&answer));
}

#[test]
fn a_bad_row_is_null_and_says_why_in_the_words_of_forces() {
    let preset = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "method": "explicit"});
    let constants = query_of(&preset);
    let rows =
        "soil.cohesion_pa,slip,normal_load_n\n0,0.1,80\n-5,0.1,80\n0,20,80\n0,0.1,\nx,0.1,80\n0,0.1\n0,0.1,1e12\n0,0.2,80\n";
    let (found, comments) = rows_of(&batch(&constants, CSV, rows).text);
    let status = |row: usize| found[row]["status"].clone();
    for row in [0, 7] {
        assert_eq!(status(row), "ok");
        assert!(!found[row]["torque_n_m"].is_empty());
    }
    for (row, changes) in [
        (1, json!({"soil": {"cohesion_pa": -5}, "slip": 0.1, "normal_load_n": 80})),
        (2, json!({"soil": {"cohesion_pa": 0}, "slip": 20, "normal_load_n": 80})),
        (3, json!({"soil": {"cohesion_pa": 0}, "slip": 0.1})),
    ] {
        let problem = post("/v1/forces", &with(&preset, changes)).problem(422);
        let fault = &problem["errors"][0];
        let words = format!("invalid: {} {}", fault["pointer"].as_str().unwrap_or(""), fault["detail"].as_str().unwrap_or(""));
        assert_eq!(status(row), words);
        assert!(found[row]["torque_n_m"].is_empty());
    }
    assert!(status(4).starts_with("invalid: /soil/cohesion_pa must be a number, not `x`"), "{}", status(4));
    assert_eq!(status(5), "invalid: line 7: the number of cells is 2, the header has 3");
    let refused = post("/v1/forces", &with(&preset, json!({"soil": {"cohesion_pa": 0}, "slip": 0.1, "normal_load_n": 1e12})));
    let refused = refused.problem(422)["errors"][0]["detail"].as_str().expect("a detail").to_owned();
    assert!(status(6).starts_with("no_solution: ") && status(6).ends_with(&refused), "{} {refused}", status(6));
    assert!(comments.iter().any(|comment| comment.starts_with("#warning,invalid_row,At rows 1 and 4: ")), "{comments:?}");
    assert_eq!(comments.last().map(String::as_str), Some("#end,8"));
}

#[test]
fn what_all_rows_lack_is_a_problem_of_the_whole() {
    let table = "slip,normal_load_n\n0.1,80\n0.2,90\n";
    let lacking = batch("soil.preset=letter-sand", CSV, table);
    assert!(lacking.fault("/wheel").contains("is required"));
    let misspelt = batch("soil.preset=leter-sand&wheel.preset=letter", CSV, table);
    assert!(misspelt.fault("/soil/preset").contains("did you mean `letter-sand`?"));
    let unknown = batch("soil.preset=letter-sand&wheel.prest=letter", CSV, table);
    assert_eq!(unknown.pointers()[0], "/wheel/prest");
    // A number that one row has is the fault of that row, though it is the only one.
    let (rows, _) = rows_of(&batch("soil.preset=letter-sand&wheel.preset=letter", CSV, "slip,normal_load_n\n0.1,-80\n").text);
    assert!(rows[0]["status"].starts_with("invalid: /normal_load_n must be from "));
}

#[test]
fn a_column_that_no_field_has_is_a_fault_with_what_was_probably_meant() {
    let of = |header: &str, query: &str| {
        let query = format!("soil.preset=letter-sand&wheel.preset=letter{query}");
        batch(&query, CSV, format!("{header}\n0.1,80,7\n"))
    };
    assert!(
        of("slip,normal_load_n,soil.cohesoin_pa", "").fault("/soil/cohesoin_pa").contains("did you mean `soil.cohesion_pa`?")
    );
    assert!(of("slip,normal_load_n,cohesion_pa", "").fault("/cohesion_pa").contains("did you mean `soil.cohesion_pa`?"));
    assert!(of("slip,normal_load_n,id", "").fault("/id").contains("extra_columns=ignore"));
    assert!(of("slip,normal_load_n,soil", "").fault("/soil").contains("such as `soil."));
    assert!(of("slip,normal_load_n,slip", "").fault("/slip").contains("more than once"));
    assert_eq!(of("slip,normal_load_n,id", "&slip=0.2&echo=id").fault("/slip"), "is given in the query as well");
    assert!(of("slip,normal_load_n,id", "&echo=idd&extra_columns=ignore").fault("/echo").contains("did you mean `id`?"));
    assert!(of("slip,normal_load_n,id", "&extra_columns=drop").fault("/extra_columns").contains("unknown name"));
    assert!(of("slip,normal_load_n,id", "&extra_columns=ignore").text.starts_with("slip,sinkage_m,"));
}

#[test]
fn columns_are_repeated_as_they_came() {
    let constants = "soil.preset=letter-sand&method=explicit&normal_load_n=80";
    let table = "id,note,wheel.preset,slip\n007,\"a, b\",letter,0.1\n12,#c,letter,0.2\n,\"say \"\"hi\"\"\",,0.3\n";
    let asked = |query: &str, accept: &str| {
        let headers = [("content-type", CSV), ("accept", accept)];
        send(request("POST", &format!("/v1/batch?{constants}&{query}"), &headers, table)).text
    };
    let text = asked("echo=note,id", CSV);
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines[0].starts_with("id,note,slip,sinkage_m,"), "in the order of the body: {text}");
    assert!(lines[1].starts_with("007,\"a, b\",0.1,") && lines[2].starts_with("12,\"#c\",0.2,"), "{text}");
    assert!(lines[3].starts_with(",\"say \"\"hi\"\"\",,"), "{text}");
    let text = asked("echo=all&extra_columns=ignore", NDJSON);
    let rows: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert_eq!((&rows[0]["id"], &rows[0]["note"]), (&json!("007"), &json!("a, b")), "what JSON would not write is a text");
    assert_eq!((&rows[1]["id"], &rows[1]["wheel.preset"]), (&json!(12), &json!("letter")));
    assert_eq!((&rows[2]["id"], &rows[2]["note"], &rows[2]["torque_n_m"]), (&Value::Null, &json!("say \"hi\""), &Value::Null));
}

#[test]
fn many_rows_keep_their_order() {
    let count = 9_000;
    let slip = |i: usize| (i % 997) as f64 / 1000.0;
    let table = (0..count)
        .fold("id,slip\n".to_owned(), |text, i| text + &format!("{i},{}\n", if i % 1000 == 999 { 2.0 } else { slip(i) }));
    let answer = batch("soil.preset=letter-sand&wheel.preset=letter&sinkage_m=0.02&method=explicit&echo=id", CSV, table);
    let (rows, comments) = rows_of(&answer.text);
    assert_eq!(rows.len(), count);
    for (i, row) in rows.iter().enumerate() {
        assert_eq!(row["id"], i.to_string());
        if i % 1000 == 999 {
            assert!(row["status"].starts_with("invalid: /slip "));
        } else {
            assert_eq!(row["slip"].parse(), Ok(slip(i)));
        }
    }
    let told = comments.iter().find(|comment| comment.starts_with("#warning,invalid_row")).expect("a warning");
    assert!(told.contains("999, 1999, 2999") && told.contains("8999"), "{told}");
    assert_eq!(comments.last().map(String::as_str), Some("#end,9000"));
}

#[test]
fn what_was_assumed_is_told_at_the_end() {
    let body = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "jsc1a-proxy"}, "normal_load_n": 80, "slip": 0.1, "assume": true});
    let alone = post("/v1/forces", &body).ok();
    let rows = "{\"slip\": 0.1}\n{\"slip\": 0.2}\n";
    let constants = with(&body, json!({"slip": null}));
    let query =
        dotted(&constants).into_iter().filter(|(_, value)| value != "null").map(|(name, value)| format!("{name}={value}"));
    let answer = batch(&query.collect::<Vec<_>>().join("&"), NDJSON, rows).text;
    let last: Value = serde_json::from_str(answer.lines().last().expect("a line")).expect("JSON");
    assert_eq!(last["assumed"], alone["assumed"]);
    assert!(
        last["warnings"].as_array().is_some_and(|warnings| warnings.iter().any(|warning| warning["code"] == "assumed_values"))
    );
}

#[test]
fn other_bodies_are_refused() {
    batch("", "application/json", "{}").problem(415);
    batch("", "text/csv; charset=latin-1", "slip\n0.1\n").problem(415);
    batch("", CSV, "").problem(400);
    batch("", CSV, "slip\n").problem(400);
    batch("", NDJSON, "\n").problem(400);
    batch("", NDJSON, "[1]\n").problem(400);
    batch("", NDJSON, "{\"slip\": }\n").problem(400);
}
