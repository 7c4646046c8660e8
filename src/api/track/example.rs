//! The example of `/v1/track` for the contract.

use axum::body::Bytes;
use serde_json::{Value, json};
use terramechanics_reading::Node;

use super::request::TrackCase;
use super::run::Run;
use crate::contract::{Example, rounded, with_rounded_numbers};
use crate::extract::SeriesForm;
use crate::request::checked;
use crate::stream::{Progress, Work};

pub(crate) fn example() -> Example {
    let request = json!({
        "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "normal_load_n": 80, "method": "explicit",
        "columns": {
            "time_s": [0, 1, 2, 3], "forward_velocity_m_s": [0, 0.16, null, 0.1], "angular_velocity_rad_s": [0, 1, 1, 1]
        }
    });
    Example { replies: replies(&request), request: Some(request) }
}

/// What a run over samples gives, in every form.
fn replies(request: &Value) -> Vec<(&'static str, Value)> {
    let run = |form: SeriesForm| {
        let case = checked::<TrackCase>(&Node::from(request)).ok()?;
        let mut output = Vec::new();
        let mut run = Run::over_samples(case, form);
        while run.slice(&mut Bytes::new(), true, &mut output).ok()? != Progress::Complete {}
        String::from_utf8(output).ok()
    };
    let json: Option<Value> = run(SeriesForm::Json).and_then(|text| serde_json::from_str(&text).ok());
    let rounded_cell = |cell: &str| cell.parse().map_or_else(|_| cell.to_owned(), |value: f64| format!("{:?}", rounded(value)));
    let rounded_line = |line: &str| match line.strip_prefix('#') {
        Some(_) => line.to_owned(),
        None => line.split(',').map(rounded_cell).collect::<Vec<_>>().join(","),
    };
    let rounded_object = |line: &str| serde_json::from_str(line).map(with_rounded_numbers).unwrap_or_default().to_string();
    let lines = |text: Option<String>, rounded: &dyn Fn(&str) -> String| -> String {
        text.iter().flat_map(|text| text.lines()).map(|line| rounded(line) + "\n").collect()
    };
    vec![
        ("application/json", json.map(with_rounded_numbers).unwrap_or_default()),
        ("text/csv", lines(run(SeriesForm::Csv), &rounded_line).into()),
        ("application/x-ndjson", lines(run(SeriesForm::Ndjson), &rounded_object).into()),
    ]
}
