//! The example of `/v1/batch` for the contract.

use axum::body::Bytes;
use axum::http::Uri;
use serde_json::Value;

use super::request::wanted;
use super::run::Batch;
use crate::contract::{Example, replies_of_texts};
use crate::extract::RowsForm;
use crate::stream::{BlockWork, Job, Taken};

const ROWS: &str = "wheel.preset,soil.preset,soil.cohesion_pa,slip,normal_load_n\n\
                    letter,letter-sand,,0.1,80\n\
                    letter,letter-sand,500,0.2,80\n\
                    letter,letter-sand,-5,0.2,80\n";

pub(crate) fn example() -> Example {
    let (table, objects) = (answer(RowsForm::Csv), answer(RowsForm::Ndjson));
    let replies = replies_of_texts(None, &table, &objects).into_iter().filter(|(_, text)| *text != Value::Null);
    Example { request: Some(ROWS.into()), replies: replies.collect() }
}

/// The answer to the example.
fn answer(form: RowsForm) -> String {
    let query = Uri::from_static("/v1/batch");
    let Ok(wanted) = wanted(&query) else { return String::new() };
    let (mut batch, mut input, mut output) =
        (Batch::new(wanted, RowsForm::Csv, form), Bytes::from_static(ROWS.as_bytes()), Vec::new());
    if let Ok(Taken::End(Some(mut block))) = batch.take(&mut input, true) {
        while !block.slice() {}
        output.extend(batch.give(block).unwrap_or_default());
        output.extend(batch.end());
    }
    String::from_utf8(output).unwrap_or_default()
}
