//! The example of `/v1/sweep` for the contract.

use axum::body::Bytes;
use serde_json::json;
use terramechanics_reading::Node;

use super::GridCase;
use super::found::Running;
use super::stream_of_rows::Stream;
use crate::compute::Pace;
use crate::contract::{Example, replies_of_texts};
use crate::reply::RowFormat;
use crate::request::checked;
use crate::stream::{Progress, Work};

pub(crate) fn example() -> Example {
    let request = json!({
        "of": "forces",
        "request": {
            "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "normal_load_n": 80,
            "method": "linearised"
        },
        "axes": [
            {"field": "/wheel/radius_m", "from": 0.1, "to": 0.3, "points": 3},
            {"field": "/soil/pressure_sinkage/n0", "values": [0.8, 0.9]}
        ]
    });
    let case = checked::<GridCase>(&Node::from(&request)).ok();
    let reply = case.as_ref().and_then(|case| case.reply(&Pace::at_once()).ok());
    let json = reply.and_then(|reply| serde_json::to_value(reply).ok());
    let text = |format: RowFormat| match &case {
        Some(GridCase::Forces(sweep)) => text_of(Stream::of(Running::of(sweep), format)),
        Some(GridCase::Vehicle(sweep)) => text_of(Stream::of(Running::of(sweep), format)),
        None => String::new(),
    };
    Example { replies: replies_of_texts(json, &text(RowFormat::Csv), &text(RowFormat::Ndjson)), request: Some(request) }
}

/// All that a stream writes.
fn text_of(mut work: impl Work) -> String {
    let mut output = Vec::new();
    while work.slice(&mut Bytes::new(), true, &mut output).is_ok_and(|progress| progress != Progress::Complete) {}
    String::from_utf8(output).unwrap_or_default()
}
