//! The example of `/v1/track` for the contract.

use axum::body::Bytes;
use serde_json::{Value, json};
use terramechanics_reading::Node;

use super::request::TrackCase;
use super::run::Run;
use crate::contract::{Example, replies_of_texts};
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
    let text = |form: SeriesForm| run(form).unwrap_or_default();
    replies_of_texts(json, &text(SeriesForm::Csv), &text(SeriesForm::Ndjson))
}
