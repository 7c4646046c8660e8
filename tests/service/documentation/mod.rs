//! What the README and the files in `docs/` say is what the service and the repository have.

mod accuracy;
mod clients;
mod dependencies;
mod evidence;
mod links;
mod methods;
mod operations;
mod optimum;
mod readme;
mod uncertain_inputs;
mod uncertainty;
mod validation;

use std::path::Path;

const README: &str = include_str!("../../../README.md");

/// The root of the repository.
fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The contents of a text's code blocks in a language.
fn blocks<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let opening = format!("```{language}\n");
    text.split(opening.as_str()).skip(1).map(|rest| rest.split("```").next().expect("a block ends")).collect()
}

/// The cells of the rows of the first table below a heading, without its head.
fn table<'a>(text: &'a str, heading: &str) -> Vec<Vec<&'a str>> {
    let (_, below) = text.split_once(&format!("{heading}\n")).unwrap_or_else(|| panic!("no heading {heading}"));
    let lines = below.lines().skip_while(|line| !line.starts_with('|')).take_while(|line| line.starts_with('|'));
    let rows = lines.skip(2).map(|line| line.trim_matches('|').split('|').map(str::trim).collect());
    rows.collect()
}

/// What stands in backticks.
fn quoted(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2)
}

/// The text with its lines joined.
fn joined(text: &str) -> String {
    text.replace('\n', " ")
}
