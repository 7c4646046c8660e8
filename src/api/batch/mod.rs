//! `POST /v1/batch`.

mod answers;
mod arrow;
mod evaluate;
mod example;
mod in_memory;
mod plan;
mod reply;
mod request;
mod run;

use axum::extract::{Request, State};
use axum::response::Response;

use super::responses::{InvalidRows, Limits};
use crate::extract::RowsForm;
use crate::problem::Problem;
use crate::state::Service;
use crate::stream;
pub(crate) use answers::{Answers, STATUS, in_words};
pub(crate) use example::example;
pub(crate) use in_memory::{ForcesPlan, ForcesRows};
use request::BatchParameters;
use run::Batch;
pub(crate) use run::shared_faults;

/// Forces for rows of their own wheel, soil and operating point
///
/// Each row is a request for forces: a column is one of its fields, with a dot between an object and its field
/// (`soil.cohesion_pa`, `wheel.radius_m`, `soil.pressure_sinkage.n0`, `slip`), and what all rows have in common stands in the query
/// under the same names. A field is in the body or in the query, not in both. Columns of words name presets and laws
/// (`soil.preset`). An empty cell, or a null, is a field that was not sent with this row. In NDJSON the fields of the first object
/// are the columns; a later line may leave some out. In a CSV comments after `#` stand above the heading; below it every line that is
/// not blank is a row.
///
/// The answer has a row for each row, in their order: the columns that `echo` repeats, those of a sweep, and `status`. That is `ok`;
/// else the numbers are empty or null and it says why: `invalid: /soil/cohesion_pa must be from 0 to 1e8, not -5` where the row
/// makes no request or is not UTF-8, `no_solution: …` where the model has no answer, in the words of /v1/forces. A bad row is that
/// wherever it stands; what no row can mend, such as an unknown column or a wheel that is nowhere, is a problem of the whole. The
/// numbers are those of /v1/forces: these rows are single wheels, and the rovers of /v1/vehicle have no batch.
///
/// The answer has the form of the body unless `Accept` prefers another of the three; a form that is none of them is not heeded.
///
/// Rows are answered in constant memory: while others still arrive where the body is sent in chunks, and when the body has ended
/// where its length is declared or a proxy passes it on. Behind the rows of a CSV stand comments:
/// `#warning,<code>,<detail>` for each warning, with the rows that it holds for, counted from 0; and `#end,<rows>` as the last line
/// of a whole answer. In NDJSON the last line is an object with `end`, `rows` and `warnings`. An answer without that line was cut;
/// where the reason is known the last line is `#error,<detail>`, or an object with `error`.
///
/// An Arrow stream (`application/vnd.apache.arrow.stream`) has columns of numbers, of texts or of dictionaries of texts, in record
/// batches of at most 16 MiB without compression of their own; the whole may be packed. A field that is a number takes integers,
/// Float32 and Float64. Its answer has columns of Float64 with nulls and of Utf8; the last record batch of a whole answer has
/// no rows, and its metadata have `rows`, `warnings` and `assumed`. An answer that cannot be completed breaks off, and the connection with it.
#[utoipa::path(
    post,
    path = "/v1/batch",
    tag = "forces",
    params(BatchParameters),
    request_body(content((String = "text/csv"), (String = "application/x-ndjson"), (String = "application/vnd.apache.arrow.stream"))),
    responses((status = 200, description = "Forces for each row", content((String = "text/csv"), (String = "application/x-ndjson"), (String = "application/vnd.apache.arrow.stream"))), InvalidRows, Limits)
)]
pub(crate) async fn batch(State(service): State<Service>, request: Request) -> Result<Response, Problem> {
    let form = RowsForm::of_body(request.headers())?;
    let answer = form.of_answer(request.headers());
    let wanted = request::wanted(request.uri())?;
    let place = service.pool().stream_place()?;
    let limits = *service.limits();
    let (parts, body) = request.into_parts();
    let body = stream::ready(&parts, body, service.spool(), &limits).await?;
    stream::answer_in_blocks(Batch::new(wanted, form, answer), body, place, &limits).await
}
