//! The example of `/v1/sweep` for the contract.

use axum::body::Bytes;
use serde_json::json;
use terramechanics_reading::Node;

use super::GridCase;
use super::blocks::GridBlocks;
use super::found::Running;
use crate::compute::Pace;
use crate::contract::{Example, replies_of_texts};
use crate::extract::RowsForm;
use crate::request::checked;
use crate::stream::{BlockWork, Job, Taken};

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
    let text = |form: RowsForm| match &case {
        Some(GridCase::Forces(sweep)) => text_of(GridBlocks::of(Running::of(sweep), form)),
        Some(GridCase::Vehicle(sweep)) => text_of(GridBlocks::of(Running::of(sweep), form)),
        None => String::new(),
    };
    Example { replies: replies_of_texts(json, &text(RowsForm::Csv), &text(RowsForm::Ndjson)), request: Some(request) }
}

/// All that a sweep writes.
fn text_of(mut work: impl BlockWork) -> String {
    let mut output = Vec::new();
    while let Ok(Taken::Block(mut block)) = work.take(&mut Bytes::new(), true) {
        while !block.slice() {}
        output.extend(work.give(block).unwrap_or_default());
    }
    output.extend(work.end());
    String::from_utf8(output).unwrap_or_default()
}
