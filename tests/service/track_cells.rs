//! `/v1/track`: what is missing, unreadable, out of range or unknown in a series.

use serde_json::{Value, json};

use crate::asking::{Answer, post, request, send, with};
use crate::track::{path, settings};

fn ask(settings: &Value, media_type: &str, body: &str) -> Answer {
    send(request("POST", &path(settings), &[("content-type", media_type)], body.to_owned()))
}

fn table(settings: &Value, text: &str) -> String {
    let answer = ask(settings, "text/csv", text);
    assert_eq!(answer.status, 200, "{}", answer.text);
    answer.text
}

/// The cells of the row at that index, and the cell in the column of that name.
fn cell<'a>(text: &'a str, row: usize, name: &str) -> &'a str {
    let at = text.lines().next().and_then(|head| head.split(',').position(|of| of == name)).expect("the column");
    text.lines().nth(row + 1).and_then(|line| line.split(',').nth(at)).expect("the row")
}

/// The detail of the warning with that code.
fn warning<'a>(text: &'a str, code: &str) -> Option<&'a str> {
    let start = format!("#warning,{code},");
    text.lines().find_map(|line| line.strip_prefix(&start))
}

fn loaded() -> Value {
    with(&settings(), json!({"static_sinkage_m": null, "normal_load_n": 80}))
}

#[test]
fn a_missing_torque_takes_only_what_is_computed_from_it() {
    let without = table(&loaded(), "time_s,slip\n0,0.1\n1,0.2\n2,0.3\n");
    for gap in ["", "NaN", "nan", "#N/A"] {
        let text = table(&loaded(), &format!("time_s,slip,torque_n_m\n0,0.1,2\n1,0.2,{gap}\n2,0.3,{gap}\n"));
        for (row, line) in without.lines().skip(1).take(3).enumerate() {
            assert!(text.lines().nth(row + 1).is_some_and(|with| with.starts_with(line)), "{line} {text}");
            assert_eq!(cell(&text, row, "status"), "ok");
            assert_eq!(cell(&text, row, "longitudinal_force_coupled_n").is_empty(), row > 0);
        }
        let told = "At 2 rows, the first of them 1: no pull by the coupled form, because `torque_n_m` is missing.";
        assert!(warning(&text, "missing_torque").is_some_and(|detail| detail.starts_with(told)), "{text}");
        assert_eq!(warning(&text, "missing_value"), None);
        assert_eq!(warning(&text, "unreadable").is_some(), gap == "#N/A", "{text}");
    }
    let measured = table(
        &with(&settings(), json!({"static_sinkage_m": null})),
        "time_s,slip,sinkage_m,torque_n_m,normal_load_n\n0,0.1,0.02,2,\n1,0.1,,2,80\n",
    );
    // Beside a sinkage the load is what the forces themselves follow from.
    assert_eq!((cell(&measured, 0, "status"), cell(&measured, 1, "status")), ("missing_value", "missing_value"));
    let told = warning(&measured, "missing_value").expect("a warning");
    assert!(told.contains("`normal_load_n` in 1 sample") && told.contains("`sinkage_m` in 1 sample"), "{told}");
}

#[test]
fn a_cell_that_is_no_number_is_a_null_row_and_told_with_its_place() {
    for word in ["#N/A", "--", "#VALUE!", "ERR", "1.2.3", "0x10", "\"a, b\""] {
        let text = table(&settings(), &format!("time_s,slip\n0,0.1\n1,{word}\nlater,0.1\n3,0.1\n"));
        let statuses: Vec<&str> = (0..4).map(|row| cell(&text, row, "status")).collect();
        assert_eq!(statuses, ["ok", "unreadable", "unreadable", "ok"], "{text}");
        assert!(text.contains("\n1.0,,,,,,,,,,unreadable\n"), "{text}");
        let expected = format!(
            "At 2 rows, the first of them 1: 2 values are not numbers, the first at line 3, column 2: `{}` is not a number (column `slip`).",
            word.trim_matches('"')
        );
        assert!(warning(&text, "unreadable").is_some_and(|detail| detail.starts_with(&expected)), "{text}");
        assert!(text.ends_with("#end,4\n"));
    }
    // Two such cells in a row, one of them in a quote over two lines.
    let text = table(&loaded(), "time_s,slip,torque_n_m\n0,0.1,2\n\n1,x,\"y\nz\"\n");
    assert!(
        warning(&text, "unreadable")
            .is_some_and(|detail| detail.contains("2 values are not numbers, the first at line 4, column 2: `x`"))
    );
}

#[test]
fn lines_of_objects_may_have_the_words_of_python_and_strings() {
    let lines = "{\"time_s\": 0, \"slip\": 0.1}\n{\"time_s\": 1, \"slip\": NaN}\n{\"time_s\": -Infinity, \"slip\": Infinity}\n{\"time_s\": 3, \"slip\": \"ERR\"}\n{\"time_s\": 4, \"slip\": 0.1}\n";
    let answer = ask(&settings(), "application/x-ndjson", lines);
    assert_eq!(answer.status, 200, "{}", answer.text);
    let lines: Vec<Value> = answer.text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let statuses: Vec<&str> = lines[..5].iter().map(|line| line["status"].as_str().expect("a status")).collect();
    assert_eq!(statuses, ["ok", "missing_value", "missing_value", "unreadable", "ok"]);
    let finding = "1 value is not a number, at line 4: `slip` must be a number or null, not a string.";
    let advice = "Write numbers, and leave a cell empty where there is none.";
    let told = format!("At row 3: {finding} {advice}");
    let warning =
        json!({"code": "unreadable", "detail": told, "finding": finding, "advice": advice, "rows": [[3, 3]], "count": 1});
    assert_eq!(lines[5]["warnings"][0], warning);
}

#[test]
fn values_in_another_unit_are_refused_without_an_event_and_with_a_hint() {
    let base = with(&settings(), json!({"static_sinkage_m": null, "wheel": {"preset": null, "radius_m": 0.125, "width_m": 0.1}}));
    let text = table(&base, "time_s,slip,sinkage_m\n0,0.1,20\n1,0.1,15\n2,0.1,0.02\n");
    let statuses: Vec<&str> = (0..3).map(|row| cell(&text, row, "status")).collect();
    assert_eq!(statuses, ["out_of_range", "out_of_range", "ok"]);
    assert!(!text.contains("#event"), "{text}");
    let told = "At 2 rows, the first of them 0: no result. `sinkage_m` has to be greater than 0 and at most the radius 0.125 m; the first of 2 is 20. Send metres.";
    assert_eq!(warning(&text, "out_of_range"), Some(told));

    let slips = |text: &str| warning(&table(&settings(), text), "slip_out_of_range").expect("a warning").to_owned();
    let told = "the slip has to be from -1 to 1 and the first is 10. Divide by 100 if the column is in per cent.";
    assert!(slips("time_s,slip\n0,10\n1,-20\n2,100\n").ends_with(told));
    assert!(slips("time_s,slip\n0,10\n1,101\n").ends_with("the first is 10. Check the column."), "one is no percentage");

    let loads = table(
        &with(&settings(), json!({"static_sinkage_m": null})),
        "time_s,slip,normal_load_n\n0,0.1,80\n1,0.1,-3\n2,0.1,inf\n",
    );
    assert!(
        warning(&loads, "out_of_range")
            .is_some_and(|detail| detail.contains("`normal_load_n` has to be finite and greater than 0; the first of 2 is -3"))
    );
}

#[test]
fn columns_that_no_sample_has_are_all_named_or_left_out_on_request() {
    let extra = "time_s,battery_v,slip,slipp\ns,V,-,-\n0,12,0.1,x\n1,dead,0.2,\n";
    let problem = ask(&settings(), "text/csv", extra).problem(400);
    assert_eq!((&problem["line"], &problem["column"]), (&json!(1), &json!(2)));
    let detail = problem["detail"].as_str().expect("a detail");
    assert!(detail.contains("`battery_v`; `slipp`, did you mean `slip`?") && detail.contains("extra_columns=ignore"), "{detail}");
    let plain = table(&settings(), "time_s,slip\n0,0.1\n1,0.2\n");
    let ignoring = with(&settings(), json!({"extra_columns": "ignore"}));
    assert_eq!(table(&ignoring, extra), plain);
    assert_eq!(ask(&ignoring, "text/csv", "time_s,time_s,x,slip\n0,0,0,0\n").problem(400)["column"], 2);

    let line = "{\"time_s\":0,\"battery_v\":12,\"slip\":0.1,\"slipp\":[1]}\n";
    let detail = ask(&settings(), "application/x-ndjson", line).problem(400)["detail"].to_string();
    assert!(detail.contains("`battery_v`") && detail.contains("`slipp`: unknown field; did you mean `slip`?"), "{detail}");
    let lines = ask(&ignoring, "application/x-ndjson", line);
    assert!(lines.status == 200 && lines.text.contains("\"status\":\"ok\""), "{}", lines.text);

    let columns = json!({"columns": {"time_s": [0, 1], "battery_v": [12, null], "slip": [0.1, 0.2], "slipp": "x"}});
    let named = ["/columns/battery_v", "/columns/slipp"];
    assert_eq!(post("/v1/track", &with(&settings(), columns.clone())).pointers(), named);
    let known = post("/v1/track", &with(&settings(), json!({"columns": {"time_s": [0, 1], "slip": [0.1, 0.2]}}))).ok();
    assert_eq!(post("/v1/track", &with(&ignoring, columns.clone())).ok(), known);
    let wrong = with(&with(&settings(), columns), json!({"extra_columns": "ignored", "soil": {"cohesion_pa": -5}}));
    let pointers = post("/v1/track", &wrong).pointers();
    assert!(
        pointers.iter().any(|of| of == "/extra_columns") && pointers.iter().any(|of| of == "/soil/cohesion_pa"),
        "{pointers:?}"
    );
}

#[test]
fn a_series_without_samples_is_refused_in_every_form() {
    for (media_type, empty) in [("text/csv", "time_s,slip\n"), ("text/csv", ""), ("application/x-ndjson", "\n")] {
        ask(&settings(), media_type, empty).problem(400);
    }
    let none = post("/v1/track", &with(&settings(), json!({"columns": {"time_s": [], "slip": []}})));
    assert_eq!(none.pointers(), ["/columns/time_s", "/columns/slip"]);
}

#[test]
fn a_wheel_at_rest_has_no_tractive_efficiency() {
    let at_rest = json!({"forward_velocity_m_s": 0, "angular_velocity_rad_s": 0});
    assert_eq!(post("/v1/forces", &with(&settings(), at_rest)).ok()["tractive_efficiency"], Value::Null);
    let text = table(&settings(), "time_s,forward_velocity_m_s,angular_velocity_rad_s\n0,0,0\n1,0.1,1\n");
    assert_eq!((cell(&text, 0, "status"), cell(&text, 0, "tractive_efficiency")), ("static", ""));
    assert!(!cell(&text, 1, "tractive_efficiency").is_empty());
}
