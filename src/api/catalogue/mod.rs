//! `GET /v1/wheels`, `GET /v1/soils` and their single entries.

mod request;

use std::collections::BTreeMap;
use std::sync::LazyLock;

use axum::body::Bytes;
use axum::http::HeaderMap;
use axum::response::Response;
use serde::Serialize;
use utoipa::ToSchema;

use super::responses::{InvalidQuery, Limits, UnknownName};
use crate::answer::{CSV, JSON, json};
use crate::catalogue::{self, SoilRecord, SoilView, WheelRecord, WheelView};
use crate::contract::Example;
use crate::extract::{Asked, Format, FormatParameter, NoQuery};
use crate::fixed::Fixed;
use crate::name::Name;
use crate::problem::Problem;
use crate::request::Accepted;
use crate::words::nearest;
use request::{SoilsCase, SoilsQuery, WheelsCase, WheelsQuery};

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
/// Every value with its source; `id` is the name for `preset`; `missing` lists what a request has to add,
/// `assumed` what `"assume": true` takes in its place.
/// With `Accept: text/csv` the values come as a table, one row per wheel.
#[utoipa::path(
    get,
    path = "/v1/wheels",
    tag = "catalogue",
    params(WheelsQuery, FormatParameter),
    responses((status = 200, description = "The wheels", content((WheelsReply = "application/json"), (String = "text/csv"))), InvalidQuery, Limits)
)]
pub(crate) async fn wheels(
    headers: HeaderMap,
    Asked { case: Accepted { case: WheelsCase(kind), .. }, format }: Asked<WheelsCase>,
) -> Response {
    static LISTS: LazyLock<Lists> = LazyLock::new(|| {
        Lists::of(&catalogue::wheel_kinds(), |kind| {
            let records = || catalogue::wheels().iter().filter(move |record| kind.is_none_or(|kind| record.kind == kind));
            let json = text(&WheelsReply { wheels: records().map(|record| record.view()).collect() });
            Texts::of(json, catalogue::wheels_table(records()))
        })
    });
    LISTS.answer(kind, format, &headers)
}

/// The soils of the catalogue
///
/// Every value with its source; `id` is the name for `preset`; `missing` lists what a request has to add,
/// `assumed` what `"assume": true` takes in its place. With `Accept: text/csv` the values come as a table, one row per soil.
#[utoipa::path(
    get,
    path = "/v1/soils",
    tag = "catalogue",
    params(SoilsQuery, FormatParameter),
    responses((status = 200, description = "The soils", content((SoilsReply = "application/json"), (String = "text/csv"))), InvalidQuery, Limits)
)]
pub(crate) async fn soils(
    headers: HeaderMap,
    Asked { case: Accepted { case: SoilsCase(kind), .. }, format }: Asked<SoilsCase>,
) -> Response {
    static LISTS: LazyLock<Lists> = LazyLock::new(|| {
        Lists::of(&catalogue::soil_kinds(), |kind| {
            let records = || catalogue::soils().iter().filter(move |record| kind.is_none_or(|kind| record.kind == kind));
            let json = text(&SoilsReply { soils: records().map(|record| record.view()).collect() });
            Texts::of(json, catalogue::soils_table(records()))
        })
    });
    LISTS.answer(kind, format, &headers)
}

/// A list in both formats.
struct Texts {
    json: Fixed,
    csv: Fixed,
}

impl Texts {
    fn of(json: Bytes, csv: Vec<u8>) -> Self {
        Self { json: Fixed::negotiated(json, JSON), csv: Fixed::negotiated(csv.into(), CSV) }
    }
}

/// The list of all entries, and that of each kind: they do not change, so each is written once.
struct Lists {
    all: Texts,
    by_kind: BTreeMap<&'static str, Texts>,
}

impl Lists {
    fn of(kinds: &[&'static str], list: impl Fn(Option<&'static str>) -> Texts) -> Self {
        Self { all: list(None), by_kind: kinds.iter().map(|&kind| (kind, list(Some(kind)))).collect() }
    }

    fn answer(&self, kind: Option<&'static str>, format: Format, request: &HeaderMap) -> Response {
        let texts = kind.and_then(|kind| self.by_kind.get(kind)).unwrap_or(&self.all);
        match format {
            Format::Json => texts.json.answer(request),
            Format::Csv => texts.csv.answer(request),
        }
    }
}

fn text<T: Serialize>(list: &T) -> Bytes {
    serde_json::to_vec(list).unwrap_or_default().into()
}

/// One wheel of the catalogue
///
/// Every value with its source; `missing` lists what a request has to add,
/// `assumed` what `"assume": true` takes in its place.
#[utoipa::path(
    get,
    path = "/v1/wheels/{id}",
    tag = "catalogue",
    params(("id" = String, Path, description = "Name of the wheel", example = "letter")),
    responses((status = 200, description = "The wheel", body = WheelView<'static>), InvalidQuery, UnknownName, Limits)
)]
pub(crate) async fn wheel(Name(id): Name, _: NoQuery) -> Result<Response, Problem> {
    let record = catalogue::wheel(&id).ok_or_else(|| unknown("wheel", &id, &catalogue::wheel_ids()))?;
    json(&record.view())
}

/// One soil of the catalogue
///
/// Every value with its source; `missing` lists what a request has to add, `assumed` what `"assume": true` takes in its place.
#[utoipa::path(
    get,
    path = "/v1/soils/{id}",
    tag = "catalogue",
    params(("id" = String, Path, description = "Name of the soil", example = "letter-sand")),
    responses((status = 200, description = "The soil", body = SoilView<'static>), InvalidQuery, UnknownName, Limits)
)]
pub(crate) async fn soil(Name(id): Name, _: NoQuery) -> Result<Response, Problem> {
    let record = catalogue::soil(&id).ok_or_else(|| unknown("soil", &id, &catalogue::soil_ids()))?;
    json(&record.view())
}

pub(crate) fn example_of_wheels() -> Example {
    Example::of_json(&WheelsReply { wheels: catalogue::wheel("letter").map(WheelRecord::view).into_iter().collect() })
}

pub(crate) fn example_of_wheel() -> Example {
    Example::of_json(&catalogue::wheel("letter").map(WheelRecord::view))
}

pub(crate) fn example_of_soils() -> Example {
    Example::of_json(&SoilsReply { soils: catalogue::soil("letter-sand").map(SoilRecord::view).into_iter().collect() })
}

pub(crate) fn example_of_soil() -> Example {
    Example::of_json(&catalogue::soil("letter-sand").map(SoilRecord::view))
}

pub(super) fn unknown(kind: &str, id: &str, known: &[&str]) -> Problem {
    let hint =
        nearest(id, known).map_or_else(|| format!("known are {}", known.join(", ")), |near| format!("did you mean `{near}`?"));
    Problem::NotFound(format!("the catalogue has no {kind} of that name; {hint}"))
}
