//! `docs/optimum.md`: its example and its trade-off have the figures that it quotes.

use serde_json::{Value, json};

use super::readme::command;
use super::{blocks, joined, table};
use crate::asking::{post, with};

const TEXT: &str = include_str!("../../../docs/optimum.md");

fn example() -> (String, Value) {
    command(blocks(TEXT, "sh")[0])
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn the_lightest_wheel_is_the_one_described() {
    let (path, body) = example();
    let found = post(&path, &body).ok();
    let [radius, width] = [0, 1].map(|i| 1e3 * number(&found["variables"][i]["value"]));
    let said =
        format!("a radius of {radius:.1} mm, a width of {width:.1} mm and a mass of {:.3} kg", number(&found["objective"]));
    assert!(joined(TEXT).contains(&said), "{said}");
    let constraints = found["constraints"].as_array().expect("constraints");
    let active: Vec<bool> = constraints.iter().map(|constraint| constraint["active"] == true).collect();
    assert_eq!(active, [true, true, false]);
    let saved = |i: usize| 1e3 * (number(&found["objective"]) - number(&constraints[i]["objective_if_looser"]));
    let said = format!("a hundredth less pull saves {:.1} g and a hundredth more sinkage {:.1} g", saved(0), saved(1));
    assert!(joined(TEXT).contains(&said), "{said}");
    let margin = format!("a `margin` of {:.0} mm", 1e3 * number(&constraints[2]["margin"]));
    assert!(joined(TEXT).contains(&margin), "{margin}");
}

#[test]
fn the_pull_that_no_wheel_has_is_told_as_described() {
    let (path, body) = example();
    let mut body = body;
    body["constraints"][0]["at_least"] = json!(20);
    let found = post(&path, &body).ok();
    assert_eq!(found["feasible"], false);
    let pull = &found["constraints"][0];
    assert_eq!(pull["met_alone"], false);
    let said = format!("reaches {:.1} N as its `best`", number(&pull["best"]));
    assert!(joined(TEXT).contains(&said), "{said}");
}

#[test]
fn the_trade_off_is_the_table() {
    let (path, body) = example();
    let sinkage = body["constraints"][1].clone();
    let against = json!({"maximise": "longitudinal_force_n", "points": 8});
    let found = post(&path, &with(&body, json!({"constraints": [sinkage], "against": against}))).ok();
    let columns = &found["columns"];
    let cell = |name: &str, row: usize, factor: f64, digits: usize| format!("{:.digits$}", factor * number(&columns[name][row]));
    let rows = table(TEXT, "## A trade-off");
    assert_eq!(columns["objective"].as_array().map(Vec::len), Some(rows.len()));
    for (i, row) in rows.iter().enumerate() {
        let expected = [
            cell("objective", i, 1.0, 3),
            cell("against", i, 1.0, 1),
            cell("wheel.radius_m", i, 1e3, 0),
            cell("wheel.width_m", i, 1e3, 0),
        ];
        assert_eq!(row.as_slice(), expected.as_slice());
    }
}
