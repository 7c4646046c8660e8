//! Rows of `/v1/batch` that are odd, and what is repeated of them: no row is lost, and none spoils the others.

use serde_json::{Value, json};

use crate::asking::{post, request, send};
use crate::batch::{CSV, NDJSON, batch, rows_of};

const COMMON: &str = "wheel.preset=letter&soil.preset=letter-sand&normal_load_n=80&method=explicit";

/// The whole answer as text, of rows that are no text.
fn of_bytes(query: &str, rows: &[u8]) -> String {
    batch(query, CSV, rows.to_vec()).text
}

fn statuses(text: &str) -> Vec<String> {
    rows_of(text).0.into_iter().map(|row| row["status"].clone()).collect()
}

#[test]
fn a_row_that_begins_with_a_hash_is_a_row() {
    let table = "# a comment\n#another\nid,slip\n#7,0.1\n#N/A,0.2\n# left out?\n8,0.3\n";
    let text = batch(&format!("{COMMON}&echo=id"), CSV, table).text;
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines[1].starts_with("\"#7\",0.1,") && lines[2].starts_with("\"#N/A\",0.2,"), "{text}");
    assert!(lines[3].contains("invalid: line 6: the number of cells is 1, the header has 2; comments stand above it"), "{text}");
    assert!(lines[4].starts_with("8,0.3,") && text.ends_with("#end,4\n"), "{text}");
}

/// The rows of an answer are read again, with the same texts in them.
#[test]
fn what_is_repeated_can_be_read_again() {
    let texts = ["#7", "#end,2", "a;b", "say \"hi\"", "two\nlines", "1,5", "\t|", "#"];
    let object = |text: &&str| json!({"i;d": text, "slip": 0.1}).to_string() + "\n";
    let rows: String = texts.iter().map(object).collect();
    let asked = |body: String, form: &str, accept: &str| {
        let headers = [("content-type", form), ("accept", accept)];
        let path = format!("/v1/batch?{COMMON}&echo=all&extra_columns=ignore");
        send(request("POST", &path, &headers, body)).text
    };
    let table = asked(rows, NDJSON, CSV);
    // Without the comments behind the rows, and with names that are those of no field.
    let (heading, rows) = table.split_once('\n').expect("a heading");
    let rows = rows.split("\n#warning,").next().and_then(|rows| rows.split("\n#end,8").next()).expect("rows");
    let own = heading.strip_prefix("\"i;d\",echo.slip,").expect("what is repeated").replace(',', ",was.");
    let again = asked(format!("\"i;d\",slip,was.{own}\n{rows}\n"), CSV, NDJSON);
    let lines: Vec<Value> = again.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let found: Vec<&str> = lines.iter().filter_map(|line| line["i;d"].as_str()).collect();
    let blanks = |text: &&str| text.trim().to_owned();
    assert_eq!(found, texts.iter().map(blanks).collect::<Vec<_>>(), "{again}");
    assert_eq!(lines.last().expect("an end")["rows"], texts.len());
}

#[test]
fn a_bad_row_is_null_wherever_it_stands() {
    let first = batch(COMMON, CSV, "slip\n0.1,0.2\n0.3\n").text;
    assert_eq!(statuses(&first), ["invalid: line 2: the number of cells is 2, the header has 1", "ok"]);
    let only = batch(COMMON, CSV, "slip\nx\n").text;
    assert_eq!(statuses(&only), ["invalid: /slip must be a number, not `x`"]);
    let lines = "{\"slip\": }\n[1]\n{\"slip\": 0.3}\n";
    let lines: Vec<Value> =
        batch(COMMON, NDJSON, lines).text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let status = |row: usize| lines[row]["status"].as_str().unwrap_or_default();
    assert!(status(0).starts_with("invalid: line 1, column 10: the line is not JSON"), "{lines:?}");
    assert!(status(1).starts_with("invalid: line 2: must be an object") && status(2) == "ok", "{lines:?}");
    assert_eq!((&lines[0]["torque_n_m"], &lines[3]["rows"]), (&Value::Null, &json!(3)));
    // Lines of which none is an object are of another form.
    batch(COMMON, NDJSON, "[0.1]\n".repeat(5000)).problem(400);
}

/// What a row lacks because of its preset or its method is the fault of that row, though it comes first or alone.
#[test]
fn words_of_a_row_are_to_blame_for_what_they_need() {
    let query = "wheel.preset=letter&normal_load_n=80";
    let alone = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "jsc1a-proxy"}, "slip": 0.1, "normal_load_n": 80});
    let fault = post("/v1/forces", &alone).problem(422)["errors"][0].clone();
    let said = format!("invalid: {} {}", fault["pointer"].as_str().expect("text"), fault["detail"].as_str().expect("text"));
    let found = statuses(&batch(query, CSV, "soil.preset,slip\njsc1a-proxy,0.1\n").text);
    assert_eq!(found[0].replace("\"\"", "\""), said);
    // What no row can mend is still a problem of the whole.
    let rows = "method,soil.preset,slip\nexplicit,letter-sand,0.1\n";
    assert!(batch("normal_load_n=80", CSV, rows).fault("/wheel").contains("is required"));
    assert_eq!(batch(&format!("{query}&wheel.prest=letter"), CSV, rows).pointers()[0], "/wheel/prest");
}

#[test]
fn a_column_with_the_name_of_one_of_the_answer_is_repeated_under_another() {
    let text =
        batch(&format!("{COMMON}&echo=all&extra_columns=ignore"), CSV, "id,slip,torque_n_m,status\na,0.1,7.5,new\nb,9,8,old\n")
            .text;
    assert!(text.starts_with("id,echo.slip,echo.torque_n_m,echo.status,slip,"), "{text}");
    let (rows, _) = rows_of(&text);
    assert_eq!((&*rows[0]["echo.torque_n_m"], &*rows[0]["echo.status"], &*rows[0]["status"]), ("7.5", "new", "ok"));
    assert_eq!((&*rows[1]["id"], &*rows[1]["echo.slip"], &*rows[1]["slip"]), ("b", "9", ""));
    let named = batch(&format!("{COMMON}&echo=status"), CSV, "slip,status\n0.1,new\n").text;
    assert!(named.starts_with("echo.status,slip,"), "{named}");
    let unasked = batch(&format!("{COMMON}&echo=all"), CSV, "id,slip\na,0.1\n");
    assert!(unasked.fault("/id").ends_with("with extra_columns=ignore it is repeated and not read"));
    let twice = batch(&format!("{COMMON}&echo=all&extra_columns=ignore"), CSV, "slip,echo.slip\n0.1,1\n");
    assert!(twice.fault("/echo").contains("`echo.slip`"));
}

#[test]
fn bytes_that_are_no_text_are_refused_with_their_row() {
    let query = format!("{COMMON}&echo=id,note");
    let text = of_bytes(&query, b"id,note,slip\n1,caf\xe9,0.1\n2,caf\xc3\xa9,0.2\n");
    assert!(!text.contains('\u{fffd}'), "{text}");
    let (rows, _) = rows_of(&text);
    assert_eq!((&*rows[0]["id"], &*rows[0]["note"]), ("1", ""));
    assert_eq!(rows[0]["status"], "invalid: line 2, column 2: the cell is not UTF-8");
    assert_eq!((&*rows[1]["note"], &*rows[1]["status"]), ("caf\u{e9}", "ok"));
    // A column that nobody reads may have any bytes.
    let unread = of_bytes(&format!("{COMMON}&extra_columns=ignore"), b"note,slip\ncaf\xe9,0.1\n");
    assert_eq!(statuses(&unread), ["ok"]);
    let heading = batch(COMMON, CSV, b"caf\xe9,slip\n1,0.1\n".to_vec()).problem(400);
    assert!(heading["detail"].as_str().is_some_and(|detail| detail.contains("line 1, column 1: ")), "{heading}");
}

#[test]
fn what_was_assumed_names_its_preset() {
    let of = |preset: &str| {
        let body =
            json!({"wheel": {"preset": "letter"}, "soil": {"preset": preset}, "slip": 0.1, "normal_load_n": 80, "assume": true});
        let answer = post("/v1/forces", &body).ok();
        let list = answer["assumed"].as_array().expect("a list").clone();
        assert!(!list.is_empty() && list.iter().all(|one| one["preset"] == preset), "{list:?}");
        list
    };
    let (first, second) = ("jsc1a-proxy", "kls1");
    let expected: Vec<Value> = of(first).into_iter().chain(of(second)).collect();
    let rows = format!("soil.preset,slip\n{first},0.1\n{second},0.1\n{first},0.2\nletter-sand,0.1\n");
    let headers = [("content-type", CSV), ("accept", NDJSON)];
    let path = "/v1/batch?wheel.preset=letter&normal_load_n=80&assume=true";
    let text = send(request("POST", path, &headers, rows)).text;
    let end: Value = serde_json::from_str(text.lines().last().expect("a line")).expect("JSON");
    assert_eq!(end["assumed"], Value::from(expected));
    let warned = end["warnings"].as_array().expect("a list").iter().find(|one| one["code"] == "assumed_values");
    let detail = warned.expect("a warning")["detail"].as_str().expect("text");
    assert!(detail.contains(first) && detail.contains(second), "{detail}");
}

/// No form that is there is asked for: the answer has that of the question.
#[test]
fn a_form_that_no_answer_has_leaves_that_of_the_body() {
    for (form, rows) in [(CSV, "slip\n0.1\n"), (NDJSON, "{\"slip\": 0.1}\n")] {
        let headers = [("content-type", form), ("accept", "application/json, text/html;q=0.9")];
        let answer = send(request("POST", &format!("/v1/batch?{COMMON}"), &headers, rows));
        assert!(answer.headers["content-type"].to_str().is_ok_and(|kind| kind.starts_with(form)), "{form}");
        assert!(answer.status.is_success());
    }
}
