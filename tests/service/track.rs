//! `/v1/track`: samples over time, in every form.

use axum::body::Body;
use axum::http::StatusCode;
use serde_json::{Value, json};

use crate::asking::{Answer, letter, post, query_of, request, send, with};

/// The settings of a run, without samples.
pub(crate) fn settings() -> Value {
    with(&letter(), json!({"slip": null, "sinkage_m": null, "static_sinkage_m": 0.015, "method": "explicit"}))
}

fn columns(columns: Value) -> Value {
    with(&settings(), json!({ "columns": columns }))
}

pub(crate) fn path(settings: &Value) -> String {
    format!("/v1/track?{}", query_of(settings))
}

pub(crate) fn stream_to(settings: &Value, media_type: &str, accept: &str, body: impl Into<Body>) -> Answer {
    send(request("POST", &path(settings), &[("content-type", media_type), ("accept", accept)], body))
}

fn csv(body: impl Into<Body>) -> Answer {
    stream_to(&settings(), "text/csv", "*/*", body)
}

fn ok(answer: &Answer) -> &str {
    assert_eq!(answer.status, StatusCode::OK, "{}", answer.text);
    &answer.text
}

/// What two searches of one sinkage may differ by.
const SOLVED: f64 = 1e-12;

#[test]
fn a_row_is_what_forces_gives_at_its_sample() {
    let (forward, angular) = ([0.0, 0.15, 0.2, -0.1, 0.3], [0.0, 1.0, 1.0, -1.0, 1.0]);
    for method in ["quadrature", "linearised", "explicit"] {
        for way in [json!({"static_sinkage_m": 0.015}), json!({"static_sinkage_m": null, "normal_load_n": 80})] {
            let base = with(&with(&settings(), json!({"method": method})), way.clone());
            let series = json!({"time_s": [0, 1, 2, 3, 4], "forward_velocity_m_s": forward, "angular_velocity_rad_s": angular});
            let reply = post("/v1/track", &with(&base, json!({ "columns": series }))).ok();
            for i in 0..5 {
                let point = with(&base, json!({"forward_velocity_m_s": forward[i], "angular_velocity_rad_s": angular[i]}));
                let forces = post("/v1/forces", &point).ok();
                // The search of a solved row starts from the rows before it.
                let allowed = if way["normal_load_n"].is_number() { SOLVED } else { 0.0 };
                let is_same = |name: &str, single: &Value| {
                    let found = &reply["columns"][name][i];
                    let [found, single] = [found, single].map(|value| value.as_f64().expect("a number"));
                    assert!((found - single).abs() <= allowed * single.abs().max(1.0), "{method} {name} {i}: {found} {single}");
                };
                for name in ["slip", "sinkage_m", "longitudinal_force_n", "normal_force_n", "torque_n_m", "drawbar_coefficient"] {
                    is_same(name, &forces[name]);
                }
                is_same("power_w", &json!(forces["torque_n_m"].as_f64().expect("a torque") * angular[i]));
            }
            assert_eq!(reply["columns"]["status"], json!(["static", "ok", "ok", "ok", "ok"]));
            let warnings = reply["warnings"].as_array().expect("warnings");
            let told = |code: &str| warnings.iter().any(|warning| warning["code"] == code);
            assert!(told("mirrored") && told("slip_sinkage_extrapolated") == base.get("static_sinkage_m").is_some(), "{reply}");
        }
    }
}

pub(crate) const TABLE: &str = "time_s,forward_velocity_m_s,angular_velocity_rad_s\n0,0.16,1\n1,,1\n2,0.1,-1\n3,0.1,1\n";
const LINES: &str = r#"{"time_s":0,"forward_velocity_m_s":0.16,"angular_velocity_rad_s":1}
{"time_s":1,"forward_velocity_m_s":null,"angular_velocity_rad_s":1}
{"angular_velocity_rad_s":-1,"time_s":2.0,"forward_velocity_m_s":1e-1}

{"time_s":3,"forward_velocity_m_s":0.1,"angular_velocity_rad_s":1}"#;

fn in_columns() -> Value {
    columns(
        json!({"time_s": [0, 1, 2, 3], "forward_velocity_m_s": [0.16, null, 0.1, 0.1], "angular_velocity_rad_s": [1, 1, -1, 1]}),
    )
}

#[test]
fn every_form_of_question_gets_the_same_numbers_in_every_form_of_answer() {
    let ask = |form: &str, accept: &str| match form {
        "application/json" => {
            send(request("POST", "/v1/track", &[("content-type", form), ("accept", accept)], in_columns().to_string()))
        }
        "text/csv" => stream_to(&settings(), form, accept, TABLE),
        _ => stream_to(&settings(), form, accept, LINES),
    };
    let forms = ["application/json", "text/csv", "application/x-ndjson"];
    for accept in forms {
        let answers = forms.map(|form| ask(form, accept));
        for answer in &answers {
            assert!(answer.header("content-type").starts_with(accept));
            assert_eq!(ok(answer), answers[0].text);
        }
    }
    for form in forms {
        assert!(ask(form, "*/*").header("content-type").starts_with(form), "the same unless another is preferred");
    }
    // And across the forms of answer.
    let json = ask(forms[0], forms[0]).json();
    let table = ask(forms[0], forms[1]).text;
    let rows: Vec<&str> = table.lines().filter(|line| !line.starts_with('#')).collect();
    let lines: Vec<Value> = ask(forms[0], forms[2]).text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert_eq!((rows.len(), lines.len()), (5, 5), "a header, and an end");
    for (at, name) in rows[0].split(',').enumerate() {
        for i in 0..4 {
            let cell = rows[i + 1].split(',').nth(at).expect("a cell");
            let value = &json["columns"][name][i];
            assert_eq!(&lines[i][name], value, "{name}");
            match value {
                Value::Null => assert_eq!(cell, ""),
                Value::String(text) => assert_eq!(cell, text),
                number => assert_eq!(cell.parse::<f64>().ok(), number.as_f64()),
            }
        }
    }
    let end = json!({
        "end": true, "rows": 4, "warnings": json["warnings"], "events": json["events"],
        "shear_displacement_radius": json["shear_displacement_radius"], "slip_radius": json["slip_radius"],
        "normal_stress_from": json["normal_stress_from"]
    });
    assert_eq!(lines[4], end);
    assert!(table.ends_with("#end,4\n"));
}

#[test]
fn a_bad_sample_is_null_with_its_reason_and_counted() {
    let series = json!({
        "time_s": [0, 1, 2, 3, null, 2, 6, 7],
        "forward_velocity_m_s": [0.1, null, 0.1, -0.1, 0.1, 0.1, 0.1, 0.1],
        "angular_velocity_rad_s": [1, 1, -1, 1, 1, 1, 1, 1]
    });
    let reply = post("/v1/track", &columns(series)).ok();
    let expected =
        ["ok", "missing_value", "opposite_rotation", "opposite_rotation", "missing_value", "time_backwards", "ok", "ok"];
    assert_eq!(reply["columns"]["status"], json!(expected));
    for (i, status) in expected.iter().enumerate() {
        for name in ["sinkage_m", "longitudinal_force_n", "torque_n_m", "power_w", "energy_j"] {
            assert_eq!(reply["columns"][name][i].is_null(), *status != "ok", "{name} {i}");
        }
    }
    let warnings = reply["warnings"].as_array().expect("warnings");
    let codes: Vec<&str> = warnings.iter().map(|warning| warning["code"].as_str().expect("a code")).collect();
    assert_eq!(codes[..3], ["missing_value", "opposite_rotation", "time_backwards"]);
    let told = "At 2 rows, the first of them 1: no result, because a value is missing: `forward_velocity_m_s` in 1 sample and \
                `time_s` in 1 sample.";
    assert!(warnings[0]["detail"].as_str().is_some_and(|detail| detail.starts_with(told)), "{}", warnings[0]);
    assert_eq!((&warnings[0]["rows"], &warnings[0]["count"]), (&json!([[1, 1]]), &json!(2)));

    let slips = post("/v1/track", &columns(json!({"time_s": [0, 1, 2, 3], "slip": [0.5, 1.5, -2, 1]}))).ok();
    assert_eq!(slips["columns"]["status"], json!(["ok", "slip_out_of_range", "slip_out_of_range", "ok"]));
    assert_eq!(slips["columns"]["power_w"], json!([null, null, null, null]), "no power without velocities");
}

#[test]
fn measured_sinkage_load_and_torque_are_taken_where_they_are_given() {
    let series = json!({
        "time_s": [0, 1], "slip": [0.2, 0.3], "sinkage_m": [0.02, 0.025], "torque_n_m": [4, 5], "normal_load_n": [60, 70]
    });
    let reply = post("/v1/track", &with(&columns(series), json!({"static_sinkage_m": null, "method": "linearised"}))).ok();
    for i in 0..2 {
        let (slip, sinkage, load) = ([0.2, 0.3][i], [0.02, 0.025][i], [60, 70][i]);
        // Both known: the load takes the place of the sinkage modulus.
        let known = json!({"slip": slip, "sinkage_m": sinkage, "normal_load_n": load, "method": "linearised"});
        let forces = post("/v1/forces", &with(&letter(), known)).ok();
        assert_eq!(reply["columns"]["longitudinal_force_n"][i], forces["longitudinal_force_n"]);
        // F_x = (A/H + B²/(A H)) T/r_s − (B/A) W (Ding), with A, B, H of Eq. (12) at the midpoint rule: θm = θ1/2 gives
        // A = 2 (1 − cos(θ1/2))·2 sin(θ1/2)/θ1 …, here by plain quadrature of the triangle instead.
        let entry = forces["angles"]["entry_rad"].as_f64().expect("an angle");
        let (mut a, mut b, steps) = (0.0, 0.0, 200_000);
        for k in 0..steps {
            let theta = entry * (f64::from(k) + 0.5) / f64::from(steps);
            let height = if theta < entry / 2.0 { 2.0 * theta / entry } else { 2.0 - 2.0 * theta / entry };
            a += height * theta.cos() * entry / f64::from(steps);
            b += height * theta.sin() * entry / f64::from(steps);
        }
        let h = entry / 2.0;
        let (torque, load) = ([4.0, 5.0][i], [60.0, 70.0][i]);
        let expected = (a / h + b * b / (a * h)) * torque / 0.2 - b / a * load;
        let found = reply["columns"]["longitudinal_force_coupled_n"][i].as_f64().expect("a force");
        assert!((found - expected).abs() < 1e-7 * load, "{found} {expected}");
    }
    let no_load = post("/v1/track", &columns(json!({"time_s": [0], "slip": [0.2], "torque_n_m": [4]}))).ok();
    assert_eq!(no_load["columns"]["longitudinal_force_coupled_n"], json!([null]));
    assert_eq!(no_load["warnings"][0]["code"], "not_coupled");
}

#[test]
fn stall_and_entrapment_are_events() {
    let series = json!({"time_s": [0, 1, 2, 3, 4], "slip": [0.1, 0.7, 0.9, 0.7, 0.1]});
    let thresholds = json!({"stall_slip": 0.6, "stall_time_s": 2, "entrapment_sinkage_ratio": 0.2});
    let reply = post("/v1/track", &with(&columns(series), json!({ "thresholds": thresholds }))).ok();
    // z = 0.015 (1 + s)/(1 − s/2) is beyond 0.04 m from s = 0.714 on.
    let expected = json!([
        {"code": "entrapment", "row": 2, "from_s": 2.0, "to_s": 2.0}, {"code": "stall", "row": 1, "from_s": 1.0, "to_s": 3.0}
    ]);
    assert_eq!(reply["events"], expected);
    let with_thresholds = with(&settings(), json!({ "thresholds": thresholds }));
    let table = stream_to(&with_thresholds, "text/csv", "*/*", "time_s,slip\n0,0.1\n1,0.7\n2,0.9\n3,0.7\n4,0.1\n");
    assert!(ok(&table).contains("\n#event,entrapment,2,2.0,2.0\n#event,stall,1,1.0,3.0\n#end,5\n"), "{}", table.text);
}

#[test]
fn tables_of_every_country_are_read() {
    let plain = csv("time_s,slip\n0.5,0.25\n1.5,-0.125\n");
    assert!(ok(&plain).ends_with("#end,2\n"));
    for (what, text) in [
        ("semicolons and decimal commas", "time_s;slip\n0,5;0,25\n1,5;-0,125\n"),
        ("semicolons and decimal points", "time_s;slip\n0.5;0.25\n1.5;-0.125\n"),
        ("tabs", "time_s\tslip\n0,5\t.25\n1.5\t-0.125\n"),
        ("a byte order mark", "\u{feff}time_s,slip\n0.5,0.25\n1.5,-0.125\n"),
        ("carriage returns", "time_s,slip\r\n0.5,0.25\r\n1.5,-0.125\r\n"),
        ("no line end at the end", "time_s,slip\n0.5,0.25\n1.5,-0.125"),
        ("units", "time_s,slip\ns,-\n0.5,0.25\n1.5,-0.125\n"),
        ("units in brackets", "time_s;slip\n[s];[–]\n0,5;0,25\n1,5;-0,125\n"),
        ("quotes", "\"time_s\",\"slip\"\n\"0,5\",\"0.25\"\n\"1.5\",\"-0,125\"\n"),
        ("blanks and comments", "# rover\n\n time_s , slip\n# go\n 0.5 , 0.25 \n\n+1.5,-1.25e-1\n   \n"),
        ("another order", "slip,time_s\n0.25,0.5\n-0.125,1.5\n"),
        ("all at once", "\u{feff}# log\r\n\"slip\";\"time_s\"\r\n(-);(s)\r\n0,25;0,5\r\n\r\n-0,125;1,5"),
    ] {
        assert_eq!(ok(&csv(text)), plain.text, "{what}");
    }
    for word in ["", "NaN", "nan", "NA", "n/a", "null", "-"] {
        let answer = csv(format!("time_s,slip\n0,0.1\n1,{word}\n2,0.1\n"));
        assert!(ok(&answer).contains("\n1.0,,,,,,,,,,missing_value\n"), "{word}: {}", answer.text);
    }
}

#[test]
fn what_is_wrong_with_a_table_is_told_with_line_and_column() {
    for (text, line, column, part) in [
        ("time_s,slip\n0,abc\n1,0.1\n", 2, 2, "`abc` is not a number (column `slip`)"),
        ("\u{feff}time_s;slip\r\ns;-\r\n\r\n1,2,3;0,1\r\n", 4, 1, "`1,2,3`"),
        ("time_s,slip\n0,0.1\n1\n", 3, 2, "the number of cells is 1, the header has 2"),
        ("time_s,slip\n0,0.1,7\n", 2, 3, "the number of cells is 3"),
        ("time_s,slipp\n0,0.1\n", 1, 2, "did you mean `slip`?"),
        ("# a\n\ntime_s,slip,slip\n", 3, 3, "more than once"),
        ("time_s,slip\nms,-\n0,0.1\n", 2, 1, "not the unit of `time_s`, s"),
        ("time_s,slip\ns,%\n0,0.1\n", 2, 2, "not the unit of `slip`"),
        ("time_s,slip\ns,-\nlater,0.1\n", 3, 1, "`later` is not a number"),
        ("time_s,slip\n0,0.1\n1,\"0.1\n2,0.1\n", 3, 2, "quote before this cell is not closed"),
        ("time_s,slip\n0,0.1\n1,\"0.1", 3, 2, "quote before this cell is not closed"),
        ("time_s,slip\n", 1, 0, "no samples"),
        ("time_s;slip\ns;-\n# nothing\n", 2, 0, "no samples"),
    ] {
        let problem = csv(text).problem(400);
        let place = (problem["line"].as_u64(), problem["column"].as_u64().unwrap_or(0));
        assert_eq!(place, (Some(line), column), "{text:?} {problem}");
        assert!(problem["detail"].as_str().is_some_and(|detail| detail.contains(part)), "{problem}");
        assert_eq!(problem["type"], "/problems/unreadable-series");
    }
    for empty in ["", "\n\n", "# nothing\n", "\u{feff}"] {
        assert!(csv(empty).problem(400)["detail"].as_str().is_some_and(|detail| detail.contains("no header")), "{empty:?}");
    }
    assert_eq!(csv("\u{fffd}").problem(400)["line"], 1);
    assert!(
        csv(&b"\xff\xfet\0i\0m\0e\0\n\0"[..]).problem(400)["detail"].as_str().is_some_and(|detail| detail.contains("UTF-16"))
    );
    let long = format!("time_s,slip\n0,0.1\n1,{}\n", "1".repeat(10_000));
    assert_eq!(csv(long).problem(400)["line"], 3);
    assert_eq!(csv("x".repeat(10_000)).problem(400)["line"], 1);
}

#[test]
fn what_is_wrong_with_a_line_is_told_with_its_number() {
    let ask = |text: &str| stream_to(&settings(), "application/x-ndjson", "*/*", text.to_owned());
    let first = "{\"time_s\":0,\"slip\":0.1}\n";
    for (second, part) in [
        ("{\"time_s\":1,\"slip\"}", "expected `:`"),
        ("{\"time_s\":1,\"slipp\":0.1}", "did you mean `slip`?"),
        ("{\"time_s\":1,\"time_s\":1}", "more than once"),
        ("[1,0.1]", "must be an object, not an array"),
        ("{\"time_s\":1,\"sinkage_m\":0.1}", "the first sample has no `sinkage_m`"),
    ] {
        let problem = ask(&format!("{first}\n{second}\n")).problem(400);
        assert_eq!(problem["line"], 3, "{problem}");
        assert!(problem["detail"].as_str().is_some_and(|detail| detail.contains(part)), "{problem}");
    }
    let wrong_at_first = ask("{\"time_s\":1,\"slip\":\"0.1\"}\n").problem(400);
    assert_eq!(wrong_at_first["detail"], "line 1: `slip` must be a number or null, not a string");
    // `x` is the 21st character; NaN before it, which is read as null, moves nothing.
    for (line, column) in [("{\"time_s\":1, \"slip\":x}", 21), ("{\"time_s\":NaN, \"slip\":x}", 23)] {
        let problem = ask(&format!("{first}{line}\n")).problem(400);
        assert_eq!((&problem["line"], &problem["column"]), (&json!(2), &json!(column)), "{problem}");
        let detail = problem["detail"].as_str().expect("a detail");
        assert_eq!(detail.matches("line 1").count() + detail.matches(" at line").count(), 0, "{detail}");
        assert!(detail.contains("not JSON, expected value; write one object a line"), "{detail}");
    }
    assert!(ask("").problem(400)["detail"].as_str().is_some_and(|detail| detail.contains("no samples")));
    let lacking = ask(&format!("{first}{{\"time_s\":1}}\n"));
    assert!(ok(&lacking).contains("\"status\":\"missing_value\""));
}

#[test]
fn columns_that_do_not_go_together_are_refused_in_every_form() {
    for (names, settings, pointer) in [
        (vec!["time_s"], settings(), "/columns/slip"),
        (vec!["slip"], settings(), "/columns/time_s"),
        (vec!["time_s", "slip", "forward_velocity_m_s"], settings(), "/columns/slip"),
        (vec!["time_s", "forward_velocity_m_s"], settings(), "/columns/angular_velocity_rad_s"),
        (vec!["time_s", "slip"], with(&settings(), json!({"static_sinkage_m": null})), "/static_sinkage_m"),
        (
            vec!["time_s", "slip", "normal_load_n"],
            with(&settings(), json!({"static_sinkage_m": null, "normal_load_n": 80})),
            "/columns/normal_load_n",
        ),
    ] {
        let series: Value = names.iter().map(|name| ((*name).to_owned(), json!([1]))).collect::<serde_json::Map<_, _>>().into();
        assert_eq!(post("/v1/track", &with(&settings, json!({ "columns": series }))).pointers(), [pointer]);
        let table = format!("{}\n{}\n", names.join(","), vec!["1"; names.len()].join(","));
        assert_eq!(stream_to(&settings, "text/csv", "*/*", table).pointers(), [pointer]);
    }
}

#[test]
fn faults_of_the_settings_are_those_of_a_body() {
    let wrong = with(&settings(), json!({"wheel": {"radus_m": 1}, "soil": {"cohesion_pa": -5}, "thresholds": {"stall_slip": 2}}));
    let json = post("/v1/track", &with(&wrong, json!({"columns": {"time_s": [0], "slip": [0]}}))).problem(422);
    assert_eq!(stream_to(&wrong, "text/csv", "*/*", TABLE).problem(422)["errors"], json["errors"]);
    assert_eq!(json["errors"].as_array().map(Vec::len), Some(3));
    let both = with(&settings(), json!({"columns": {"time_s": 1}}));
    assert_eq!(stream_to(&both, "text/csv", "*/*", TABLE).pointers(), ["/columns"]);
    let lists = columns(json!({"time_s": [0, 1], "slip": [0, "x"], "sinkage_m": []}));
    assert_eq!(post("/v1/track", &lists).pointers(), ["/columns/slip/1", "/columns/sinkage_m"]);
    let uneven = columns(json!({"time_s": [0, 1], "slip": [0]}));
    assert_eq!(post("/v1/track", &uneven).pointers(), ["/columns/slip"]);
    assert_eq!(post("/v1/track", &settings()).pointers(), ["/columns"]);
    for media_type in
        ["text/plain", "application/xml", "", "text/csv; charset=utf-16", "text/csv;header=present; Charset=\"latin1\""]
    {
        stream_to(&settings(), media_type, "*/*", TABLE).problem(415);
    }
    for media_type in ["text/csv; charset=UTF-8", "text/csv; charset=\"us-ascii\"", "text/csv; header=present"] {
        ok(&stream_to(&settings(), media_type, "*/*", TABLE));
    }
}

#[test]
fn many_samples_pass_and_are_counted() {
    let rows: String = (0..20_000).map(|i| format!("{},0.{:03}\n", f64::from(i) * 0.01, i % 1000)).collect();
    let text = csv(format!("time_s,slip\n{rows}"));
    assert!(ok(&text).ends_with("#end,20000\n"));
    assert_eq!(text.text.lines().filter(|line| line.ends_with(",ok")).count(), 20_000);
}

#[test]
fn an_answer_in_columns_is_bounded() {
    let rows = "1,0.1\n".repeat(100_001);
    let answer = stream_to(&settings(), "text/csv", "application/json", format!("time_s,slip\n{rows}"));
    assert_eq!(answer.pointers(), [""]);
}
