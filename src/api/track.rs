//! `POST /v1/track`.

use axum::body::Body;
use axum::extract::{FromRequest, Request, State};
use axum::response::Response;

use super::responses::{InvalidSeries, Limits};
use crate::app::{self, Service};
use crate::compute::Place;
use crate::extract::{Input, SeriesForm, read_query};
use crate::problem::Problem;
use crate::reply::TrackReply;
use crate::request::{TrackDto, checked_settings};
use crate::series::Run;
use crate::stream;

/// A wheel followed over time
///
/// Slip, sinkage, forces, power and energy of each sample, and when the wheel was stuck. A sample that is bad (a value is
/// missing, the velocities have opposite signs, the slip is out of range, …) does not end the run: its row is null, `status` has
/// the reason, `warnings` the count.
///
/// The samples are columns of a JSON body, or the body is the series, as a table (`text/csv`) or an object a line
/// (`application/x-ndjson`); the rest then stands in the query, with dotted names. A table has a header with the names of the
/// columns, is separated by commas, semicolons or tabs, and may have decimal commas, a byte order mark, carriage returns,
/// comments after `#` and a row of units below the header. The answer comes in the form of the body unless the header Accept
/// prefers another. In CSV and NDJSON it comes while the body is still being sent, in constant memory, however long that is.
///
/// The last line of a whole answer is `#end,<rows>` in CSV, after `#warning,…` and `#event,…`, and an object with `end`, `rows`,
/// `warnings` and `events` in NDJSON; an answer without it was cut. Where the reason is known the last line is `#error,…`, or an
/// object with `error`. Readers of CSV can be told to leave lines with `#` out.
#[utoipa::path(
    post,
    path = "/v1/track",
    tag = "forces",
    params(TrackDto),
    request_body(content((TrackDto = "application/json"), (String = "text/csv"), (String = "application/x-ndjson"))),
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
    limits: app::Limits,
}

async fn asked(service: &Service, request: Request) -> Result<Asked, Problem> {
    let form = SeriesForm::of_body(request.headers())?;
    let wanted = form.of_answer(request.headers());
    let limits = *service.limits();
    if form == SeriesForm::Json {
        let Input(query) = Input::<TrackDto>::from_request(request, service).await?;
        // All is there already, so that it is a computation like any other.
        let limits = app::Limits { stream_deadline: limits.compute_deadline, ..limits };
        let place = service.pool().place()?;
        return Ok(Asked { run: Run::over_samples(query, wanted), body: Body::empty(), place, limits });
    }
    let settings = checked_settings(&read_query(request.uri())?).map_err(Problem::Invalid)?;
    let place = service.pool().stream_place()?;
    Ok(Asked { run: Run::over_stream(settings, form, wanted), body: request.into_body(), place, limits })
}
