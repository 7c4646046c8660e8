//! `GET /v1/validation` and its single sets.

mod across_sets;
mod columns;
mod found;
mod inputs;
mod reply;

use std::sync::OnceLock;

use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::Response;
use serde::Serialize;
use serde_json::{Value, json};
use utoipa::ToSchema;

use super::catalogue::unknown;
use super::responses::{InvalidQuery, Limits, UnknownName};
use crate::answer::{JSON, written};
use crate::compute::{Cost, Pace};
use crate::contract::Example;
use crate::extract::{AskedFormat, FormatParameter, NoQuery};
use crate::fixed::Fixed;
use crate::name::Name;
use crate::problem::Problem;
use crate::state::Service;
use crate::validation::{self, Pooled};
use across_sets::{HeldOutReply, PooledReply, pooled};
use reply::ValidationSet;

/// Published measurements, with what the methods give for them.
#[derive(Serialize, ToSchema)]
#[schema(as = Validation)]
struct ValidationReply {
    sets: &'static [ValidationSet],
    /// What a fit is worth on measurements that it has not seen.
    held_out: Vec<HeldOutReply>,
    pooled: PooledReply,
}

/// The sets do not change, so they are computed once, by the first who asks.
static SETS: OnceLock<Vec<ValidationSet>> = OnceLock::new();

fn sets() -> &'static [ValidationSet] {
    SETS.get_or_init(|| validation::records().iter().map(|record| found::validation(record).into()).collect())
}

/// All of it, as it is sent. The fits are made for those alone who ask for everything.
static TEXT: OnceLock<Fixed> = OnceLock::new();

fn text() -> &'static Fixed {
    TEXT.get_or_init(|| {
        let held_out = validation::held_out().map(HeldOutReply::from).collect();
        let reply = ValidationReply { sets: sets(), held_out, pooled: pooled(sets()) };
        Fixed::tagged(serde_json::to_vec(&reply).unwrap_or_default().into(), JSON)
    })
}

/// The cost of what is not yet computed, with so many fits.
fn cost<T>(known: &OnceLock<T>, fits: usize) -> Cost {
    if known.get().is_some() { Cost::NONE } else { Cost::of_validation(validation::quadratures(), fits) }
}

/// Published measurements, with what the methods give for them
///
/// Each set has its source, the wheel and soil that stand for the measured ones, and the errors of every method under the
/// measured load. Where parameters were fitted to the very measurements, `fitted` is true: those errors are no predictions.
/// Braking wheels are run by both laws of braking, wheels at a slip angle by the quadrature with every `shear_coupling` and
/// `bulldozing`. The same comes as a table for one set. `held_out` has parameters that were fitted to one part of the
/// measurements and scored on another, `pooled` the errors over several sets beside those that other programs publish.
#[utoipa::path(get, path = "/v1/validation", tag = "catalogue", responses((status = 200, description = "The sets", body = ValidationReply), InvalidQuery, Limits))]
pub(crate) async fn validation(State(service): State<Service>, headers: HeaderMap, _: NoQuery) -> Result<Response, Problem> {
    service.pool().run(cost(&TEXT, validation::fits()), move |_| Ok(text().answer(&headers))).await
}

/// One set of published measurements
///
/// With `Accept: text/csv` the columns come as a table, named `measured.column` and `predicted.series.column`.
#[utoipa::path(
    get,
    path = "/v1/validation/{id}",
    tag = "catalogue",
    params(("id" = String, Path, description = "Name of the set", example = "ding-2011-smooth"), FormatParameter),
    responses((status = 200, description = "The set", content((ValidationSet = "application/json"), (String = "text/csv"))), InvalidQuery, UnknownName, Limits)
)]
pub(crate) async fn validation_set(
    State(service): State<Service>,
    AskedFormat(format): AskedFormat,
    Name(id): Name,
) -> Result<Response, Problem> {
    let work = move |_: &Pace| {
        let set = sets().iter().find(|set| set.id == id).ok_or_else(|| unknown("validation set", &id, &validation::ids()))?;
        written(set, format)
    };
    service.pool().run(cost(&SETS, 0), work).await
}

/// One of the sets, as JSON and as a table.
fn shown_set() -> Vec<(&'static str, Value)> {
    let record = validation::record("ding-2011-smooth");
    record.map(|record| Example::replies_of(&ValidationSet::from(found::validation(record)))).unwrap_or_default()
}

/// All of it with one set and one split, so that the contract does not have to compute the others.
pub(crate) fn example() -> Example {
    let of_others = Pooled::kept().sets.iter().filter_map(|id| validation::record(id));
    let pooled = pooled(&of_others.map(|record| found::validation(record).into()).collect::<Vec<_>>());
    let held_out: Vec<HeldOutReply> = validation::held_out().take(1).map(HeldOutReply::from).collect();
    let set = shown_set().into_iter().take(1);
    let replies = set.map(|(media_type, set)| (media_type, json!({"sets": [set], "held_out": held_out, "pooled": pooled})));
    Example { request: None, replies: replies.collect() }
}

pub(crate) fn example_of_set() -> Example {
    Example { request: None, replies: shown_set() }
}
