//! `GET /v1/wheels`, `GET /v1/soils` and their single entries.

use std::sync::LazyLock;

use axum::body::Bytes;
use axum::extract::Path;
use axum::response::Response;
use serde::Serialize;
use utoipa::ToSchema;

use super::responses::{Limits, UnknownName};
use crate::catalogue::{self, SoilView, WheelView};
use crate::compute::{json, json_text};
use crate::problem::Problem;
use crate::wire::nearest;

/// The wheels of the catalogue.
#[derive(Serialize, ToSchema)]
#[schema(as = Wheels)]
struct WheelsReply {
    wheels: Vec<WheelView<'static>>,
}

/// The soils of the catalogue.
#[derive(Serialize, ToSchema)]
#[schema(as = Soils)]
struct SoilsReply {
    soils: Vec<SoilView<'static>>,
}

/// The wheels of the catalogue
///
/// Every value with its source; `id` is the name for `preset`.
#[utoipa::path(get, path = "/v1/wheels", tag = "catalogue", responses((status = 200, description = "The wheels", body = WheelsReply), Limits))]
pub(crate) async fn wheels() -> Response {
    static TEXT: LazyLock<Bytes> =
        LazyLock::new(|| text(&WheelsReply { wheels: catalogue::wheels().iter().map(|record| record.view()).collect() }));
    json_text(TEXT.clone())
}

/// The soils of the catalogue
///
/// Every value with its source; `id` is the name for `preset`; `missing` lists what a request has to add.
#[utoipa::path(get, path = "/v1/soils", tag = "catalogue", responses((status = 200, description = "The soils", body = SoilsReply), Limits))]
pub(crate) async fn soils() -> Response {
    static TEXT: LazyLock<Bytes> =
        LazyLock::new(|| text(&SoilsReply { soils: catalogue::soils().iter().map(|record| record.view()).collect() }));
    json_text(TEXT.clone())
}

/// A list that does not change is written once.
fn text<T: Serialize>(list: &T) -> Bytes {
    serde_json::to_vec(list).unwrap_or_default().into()
}

/// One wheel of the catalogue
///
/// Every value with its source.
#[utoipa::path(
    get,
    path = "/v1/wheels/{id}",
    tag = "catalogue",
    params(("id" = String, Path, description = "Name of the wheel", example = "letter")),
    responses((status = 200, description = "The wheel", body = WheelView<'static>), UnknownName, Limits)
)]
pub(crate) async fn wheel(Path(id): Path<String>) -> Result<Response, Problem> {
    let record = catalogue::wheel(&id).ok_or_else(|| unknown("wheel", &id, &catalogue::wheel_ids()))?;
    json(&record.view())
}

/// One soil of the catalogue
///
/// Every value with its source; `missing` lists what a request has to add.
#[utoipa::path(
    get,
    path = "/v1/soils/{id}",
    tag = "catalogue",
    params(("id" = String, Path, description = "Name of the soil", example = "letter-sand")),
    responses((status = 200, description = "The soil", body = SoilView<'static>), UnknownName, Limits)
)]
pub(crate) async fn soil(Path(id): Path<String>) -> Result<Response, Problem> {
    let record = catalogue::soil(&id).ok_or_else(|| unknown("soil", &id, &catalogue::soil_ids()))?;
    json(&record.view())
}

pub(super) fn unknown(kind: &str, id: &str, known: &[&str]) -> Problem {
    let hint =
        nearest(id, known).map_or_else(|| format!("known are {}", known.join(", ")), |near| format!("did you mean `{near}`?"));
    Problem::NotFound(format!("the catalogue has no {kind} of that name; {hint}"))
}
