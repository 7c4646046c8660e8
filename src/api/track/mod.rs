//! `POST /v1/track`, and all that a track does: `plan` makes samples of the cells of a series, `run` follows them in slices, `found`
//! says what came of it, `table` and `reply` write it down.

mod example;
mod found;
mod plan;
mod reply;
mod request;
mod run;
mod samples;
mod table;

use axum::body::Body;
use axum::extract::{FromRequest, Request, State};
use axum::response::Response;

use super::responses::{InvalidSeries, Limits};
use crate::compute::Place;
use crate::extract::{Input, SeriesForm, read_query};
use crate::limits;
use crate::problem::Problem;
use crate::request::Accepted;
use crate::state::Service;
use crate::stream;
pub(crate) use example::example;
use reply::TrackReply;
use request::{TrackCase, TrackRequest, checked_settings};
use run::Run;

/// A wheel followed over time
///
/// Slip, sinkage, forces, power and energy of each sample, and when the wheel was stuck. A sample that is bad (a value is
/// missing or no number, the velocities have opposite signs, the slip is out of range, …) does not end the run: its row is
/// null, `status` has the reason, `warnings` the count, and for a value that is no number its line and column. In the first
/// sample such a value is an error, for then the form is wrong rather than the value. A torque or a load that only the coupled
/// form or the estimate of the strength needs is missing there alone: `missing_torque` and `missing_load` warn of it.
///
/// The samples are columns of a JSON body, or the body is the series, as a table (`text/csv`) or an object a line
/// (`application/x-ndjson`), in UTF-8; the rest then stands in the query, with dotted names. A table has a header with the names
/// of the columns, is separated by commas, semicolons or tabs, and may have decimal commas, a byte order mark, carriage returns,
/// comments after `#` and a row of units below the header. In NDJSON the words NaN, Infinity and -Infinity, which Python
/// writes, are missing values. Columns with other names are refused unless `extra_columns=ignore` leaves them out. The answer
/// comes in the form of the body unless the header Accept prefers another of JSON, CSV and NDJSON. CSV and NDJSON are answered in constant memory: while
/// they arrive where the body is sent in chunks, and when the body has ended where its length is declared or a proxy passes it on.
///
/// Behind the rows of a CSV stand comments: `#warning,<code>,<detail>` for each warning, where the detail is the rest of the line
/// and may have commas and quotes; `#event,<code>,<row>,<from_s>,<to_s>` for each event, with the index of the first of its
/// samples, from 0, and the times of the first and the last; and `#end,<rows>` as the last line of a whole answer. There is no
/// header X-Warnings. In NDJSON the last line is an object with `end`, `rows`, `warnings` and `events`. An answer without that
/// line was cut; where the reason is known the last line is `#error,<detail>`, or an object with `error`. Readers of CSV can be
/// told to leave lines with `#` out.
#[utoipa::path(
    post,
    path = "/v1/track",
    tag = "forces",
    params(TrackRequest),
    request_body(content((TrackRequest = "application/json"), (String = "text/csv"), (String = "application/x-ndjson"))),
    responses((status = 200, description = "The wheel over time", content((TrackReply = "application/json"), (String = "text/csv"), (String = "application/x-ndjson"))), InvalidSeries, Limits)
)]
pub(crate) async fn track(State(service): State<Service>, request: Request) -> Result<Response, Problem> {
    let asked = asked(&service, request).await?;
    stream::answer(asked.run, asked.body, asked.place, &asked.limits).await
}

/// What a request asks for, what is left of its body, and the limits that hold for it.
struct Asked {
    run: Run,
    body: Body,
    place: Place,
    limits: limits::Limits,
}

async fn asked(service: &Service, request: Request) -> Result<Asked, Problem> {
    let form = SeriesForm::of_body(request.headers())?;
    let wanted = form.of_answer(request.headers());
    let limits = *service.limits();
    if form == SeriesForm::Json {
        let Input(Accepted { case, assumed }) = Input::<TrackCase>::from_request(request, service).await?;
        // All is there already, so that it is a computation like any other.
        let limits = limits::Limits { stream_deadline: limits.compute_deadline, ..limits };
        let place = service.pool().place()?;
        return Ok(Asked { run: Run::over_samples(case, wanted).assuming(assumed), body: Body::empty(), place, limits });
    }
    let Accepted { case: settings, assumed } = checked_settings(&read_query(request.uri())?).map_err(Problem::Invalid)?;
    let place = service.pool().stream_place()?;
    let (parts, body) = request.into_parts();
    let body = stream::ready(&parts, body, service.spool(), &limits).await?;
    Ok(Asked { run: Run::over_stream(settings, form, wanted).assuming(assumed), body, place, limits })
}
