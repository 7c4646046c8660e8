//! `POST /v1/identify`, `/v1/identify/plates` and `/v1/identify/shear`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, Limits};
use crate::answer::written;
use crate::compute::{Cost, Pace};
use crate::extract::{Format, Input};
use crate::found;
use crate::problem::Problem;
use crate::reply::{IdentifyReply, PlatesReply, ShearReply};
use crate::request::{IdentifyCase, IdentifyRequest, PlatesCase, PlatesRequest, ShearTestsCase, ShearTestsRequest};
use crate::state::Service;

/// Parameters of soil and contact from measured forces
///
/// The parameters named in `fit` that explain the measurements best by the chosen method, with standard errors, intervals,
/// correlation and residuals; and what the measurements do not tell: `identifiable` is false, with words at each parameter,
/// whenever they leave one open. With `Accept: text/csv` the columns come as a table.
#[utoipa::path(
    post,
    path = "/v1/identify",
    tag = "identification",
    request_body = IdentifyRequest,
    responses((status = 200, description = "Parameters of soil and contact from measured forces", content((IdentifyReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn identify(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<IdentifyCase>,
) -> Result<Response, Problem> {
    let cost = Cost::of_identification(&query);
    let patience = service.limits().compute_deadline;
    let work = move |pace: &Pace| written(&IdentifyReply::from(found::identify(&query, patience, pace)?), format);
    service.pool().run(cost, work).await
}

/// Bekker's parameters from plate tests
///
/// k_c, k_phi and n0 from curves of pressure over sinkage under plates of two or more widths, by Wong's weighted fit, with standard
/// errors and residuals. With `Accept: text/csv` the columns come as a table.
#[utoipa::path(
    post,
    path = "/v1/identify/plates",
    tag = "identification",
    request_body = PlatesRequest,
    responses((status = 200, description = "Bekker's parameters from plate tests", content((PlatesReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn plates(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<PlatesCase>,
) -> Result<Response, Problem> {
    let cost = Cost::of_curves(query.curves.iter().map(|curve| curve.sinkage.len()).sum());
    let work = move |pace: &Pace| written(&PlatesReply::from(found::plates(&query, pace)?), format);
    service.pool().run(cost, work).await
}

/// Strength and shear modulus from shear tests
///
/// Cohesion, friction angle and shear modulus from curves of shear stress over displacement under two or more normal stresses, all
/// fitted at once, with standard errors and residuals. With `Accept: text/csv` the columns come as a table.
#[utoipa::path(
    post,
    path = "/v1/identify/shear",
    tag = "identification",
    request_body = ShearTestsRequest,
    responses((status = 200, description = "Strength and shear modulus from shear tests", content((ShearReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn shear(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<ShearTestsCase>,
) -> Result<Response, Problem> {
    let cost = Cost::of_curves(query.0.iter().map(|curve| curve.shear.len()).sum());
    let work = move |pace: &Pace| written(&ShearReply::from(found::shear(&query, pace)?), format);
    service.pool().run(cost, work).await
}
