//! The README: a first request, the endpoints, the commands.

use std::collections::BTreeSet;

use serde_json::Value;

use super::{README, blocks, quoted, table};
use crate::asking::{get, post};

/// More than this and nobody reads it; the rest belongs to `docs/`.
const MOST_LINES: usize = 150;

/// The path and the body of the first request.
pub(super) fn first_request() -> (String, Value) {
    command(blocks(README, "sh")[0])
}

/// The path and the body of a curl command.
pub(super) fn command(block: &str) -> (String, Value) {
    let path = block.split("127.0.0.1:8080").nth(1).and_then(|rest| rest.split(' ').next()).expect("a path");
    let body = block.split("-d '").nth(1).and_then(|rest| rest.split('\'').next()).expect("a body");
    (path.to_owned(), serde_json::from_str(body).expect("JSON"))
}

#[test]
fn the_readme_is_short() {
    assert!(README.lines().count() <= MOST_LINES);
}

#[test]
fn the_first_request_has_the_answer_shown() {
    let (path, body) = first_request();
    let shown: Value = serde_json::from_str(blocks(README, "json")[0]).expect("JSON");
    let answer = post(&path, &body).ok();
    // Every processor gives the same bits, so that the last digit counts.
    assert_eq!(shown, answer);
}

#[test]
fn the_explicit_figures_are_those_quoted() {
    let (path, mut body) = first_request();
    body["method"] = "explicit".into();
    let answer = post(&path, &body).ok();
    let rounded = |name: &str, digits: usize| format!("{:.digits$}", answer[name].as_f64().expect("a number"));
    let quoted = [rounded("longitudinal_force_n", 1), rounded("normal_force_n", 1), rounded("torque_n_m", 2)];
    assert_eq!(quoted, ["12.1", "55.8", "4.72"]);
    assert!(README.contains("12.1 N, 55.8 N and 4.72 N·m"));
}

#[test]
fn both_commands_are_named() {
    for command in ["cargo run --release", "cargo test --workspace"] {
        assert!(README.lines().any(|line| line == format!("    {command}")), "{command}");
    }
}

#[test]
fn the_size_of_the_catalogue_is_the_one_stated() {
    let size = |path: &str, name: &str| get(path).ok()[name].as_array().expect("a list").len();
    let stated = format!("{} wheels and {} soils", size("/v1/wheels", "wheels"), size("/v1/soils", "soils"));
    assert!(README.contains(&stated), "{stated}");
}

/// Every method and path, once; and nothing that is not in the contract.
#[test]
fn the_table_of_endpoints_is_the_contract() {
    let document = get("/openapi.json").ok();
    let paths = document["paths"].as_object().expect("paths");
    let in_contract: BTreeSet<(String, String)> = paths
        .iter()
        .flat_map(|(path, item)| {
            let methods = item.as_object().expect("methods").keys().filter(|key| ["get", "post"].contains(&key.as_str()));
            methods.map(|method| (method.to_uppercase(), path.clone()))
        })
        .collect();
    let stated: Vec<(String, String)> = table(README, "## Endpoints")
        .iter()
        .flat_map(|row| {
            let paths = quoted(row[1]).map(str::to_owned);
            paths.flat_map(|path| quoted(row[0]).map(move |method| (method.to_owned(), path.clone())))
        })
        .collect();
    assert_eq!(stated.iter().cloned().collect::<BTreeSet<_>>(), in_contract);
    assert_eq!(stated.len(), in_contract.len(), "an endpoint stands twice");
}

#[test]
fn the_pages_that_are_not_in_the_contract_are_there() {
    assert!(README.contains("`/` is the page and `/docs` the explorer"));
    for path in ["/", "/docs"] {
        let page = get(path);
        assert!(page.status.is_success() && page.header("content-type").starts_with("text/html"), "{path}");
    }
}
