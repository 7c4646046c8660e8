//! What a handler takes from an HTTP request: a checked request, and the format of the answer.

mod format;
mod input;
mod media;
mod query;
mod rows_form;
mod series_form;

pub(crate) use format::Format;
pub(crate) use input::{Input, read};
pub(crate) use query::{Asked, AskedFormat, AskedOnly, FormatParameter, NoQuery, parsed, read_query, taken};
pub(crate) use rows_form::RowsForm;
pub(crate) use series_form::SeriesForm;
