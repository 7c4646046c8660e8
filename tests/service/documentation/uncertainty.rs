//! `docs/uncertainty.md`: what is said of its example is what the service answers.

use serde_json::Value;

use super::readme::command;
use super::{blocks, joined, quoted, table};
use crate::asking::post;

const TEXT: &str = include_str!("../../../docs/uncertainty.md");

fn first(columns: &Value, name: &str) -> f64 {
    columns[name][0].as_f64().unwrap_or_else(|| panic!("no {name} in {columns}"))
}

#[test]
fn the_figures_of_the_example_are_those_of_the_service() {
    let (path, body) = command(blocks(TEXT, "sh")[0]);
    let answer = post(&path, &body).ok();
    let band = answer["bands"].as_array().expect("bands").iter().find(|band| band["quantity"] == "longitudinal_force_n");
    let band = &band.expect("a band of the pull")["columns"];
    let probability = first(&answer["conditions"][0]["columns"], "probability");
    let shares: Vec<String> = answer["sensitivities"]
        .as_array()
        .expect("sensitivities")
        .iter()
        .map(|one| format!("`{}` {:.0} %", one["fields"][0].as_str().expect("a field"), 100.0 * first(&one["columns"], "total")))
        .collect();
    let said = [
        format!(
            "The pull is {:.1} N in the median, and from {:.1} to {:.1} N in nine cases of ten.",
            first(band, "q50"),
            first(band, "q05"),
            first(band, "q95")
        ),
        format!("It is below 15 N with a probability of {:.0} %.", 100.0 * probability),
        format!("Of its variance the fields decide, each with its share in what they do together: {}.", shares.join(", ")),
    ];
    for sentence in said {
        assert!(joined(TEXT).replace("  ", " ").contains(&sentence), "docs/uncertainty.md has to say: {sentence}");
    }
}

#[test]
fn the_table_of_distributions_is_that_of_the_contract() {
    let schemas = &crate::asking::get("/openapi.json").ok()["components"]["schemas"];
    let words = &schemas["UncertainInput"]["properties"];
    let known: Vec<&str> =
        words["distribution"]["enum"].as_array().expect("words").iter().map(|word| word.as_str().expect("a word")).collect();
    let rows = table(TEXT, "## Distributions");
    let told: Vec<&str> = rows.iter().flat_map(|row| quoted(row[0])).collect();
    assert_eq!(told, known);
    for parameter in rows.iter().flat_map(|row| quoted(row[1])) {
        assert!(words.get(parameter).is_some(), "{parameter}");
    }
}
