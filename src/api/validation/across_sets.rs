//! What is said of several sets together: what a fit is worth on points that it has not seen, and the errors over pooled points.

use std::collections::BTreeMap;

use serde::Serialize;
use utoipa::ToSchema;

use super::reply::ValidationSet;
use crate::validation::{self, FitScore, HeldOut, Part, Pooled, pooled_error};

/// Parameters fitted to the pulls of one part of the measurements and scored on another, by the quadrature.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ValidationHeldOut)]
pub(super) struct HeldOutReply {
    fitted_on: &'static Part,
    scored_on: &'static Part,
    /// By what was fitted, with nothing fitted first.
    results: Vec<FitScoreReply>,
}

/// What one fit is worth.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ValidationFit)]
struct FitScoreReply {
    /// The parameters that were fitted, as `/v1/identify` names them; empty for the soil as it stands.
    #[schema(example = json!(["shear_modulus_m"]))]
    fitted: &'static [String],
    /// The value found for each, in its unit; empty where the search found no minimum.
    values: BTreeMap<&'static str, f64>,
    /// Error of the drawbar pull, at each point over its load (–), on `scored_on`; null where a point has no solution or the
    /// search found no minimum.
    drawbar_rmse_over_load: Option<f64>,
    /// The same on `fitted_on`. It says little of what the fit is worth.
    on_fitted_part: Option<f64>,
}

impl From<HeldOut> for HeldOutReply {
    fn from(HeldOut { fitted_on, scored_on, scores }: HeldOut) -> Self {
        Self { fitted_on, scored_on, results: scores.into_iter().map(FitScoreReply::from).collect() }
    }
}

impl From<FitScore> for FitScoreReply {
    fn from(FitScore { parameters, values, unseen, seen }: FitScore) -> Self {
        Self { fitted: parameters, values: values.into_iter().collect(), drawbar_rmse_over_load: unseen, on_fitted_part: seen }
    }
}

/// Errors of the pull over the points of several sets with nothing fitted, beside those that other programs publish for them.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ValidationPooled)]
pub(super) struct PooledReply {
    /// Names of the sets.
    sets: &'static [String],
    /// Number of their points.
    points: usize,
    results: Vec<PooledResult>,
}

/// The errors of one program.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ValidationPooledResult)]
struct PooledResult {
    /// Name of the other program; absent for a series of this service.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    program: Option<&'static str>,
    /// Name of the series, or of a further way to run the sets by another convention, the same for all. Absent for another program.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "quadrature")]
    series: Option<&'static str>,
    /// Error of the drawbar pull, at each point over its load (–), over all points; null where one has no solution.
    drawbar_rmse_over_load: Option<f64>,
    /// The same by set, in the order of `sets`; as the other program publishes it.
    by_set: Vec<Option<f64>>,
}

/// The errors over the pooled points, from those of `sets`.
pub(super) fn pooled(sets: &[ValidationSet]) -> PooledReply {
    let Pooled { sets: ids, series, variants, published } = Pooled::kept();
    let of_ids: Vec<Option<&ValidationSet>> = ids.iter().map(|id| sets.iter().find(|set| set.id == *id)).collect();
    let points: Vec<usize> = of_ids.iter().map(|set| set.map_or(0, |set| set.points)).collect();
    let over_all = |by_set: &[Option<f64>]| pooled_error(by_set.iter().copied().zip(points.iter().copied()));
    let result = |program, series, by_set: Vec<Option<f64>>| PooledResult {
        program,
        series,
        drawbar_rmse_over_load: over_all(&by_set),
        by_set,
    };
    let ours = series.iter().map(|name| {
        let by_set = of_ids.iter().map(|set| set.and_then(|set| set.drawbar_error(name))).collect();
        result(None, Some(name.as_str()), by_set)
    });
    let varied = variants.iter().map(|variant| {
        let by_set = ids.iter().map(|id| validation::record(id).and_then(|record| variant.error(record))).collect();
        result(None, Some(variant.series.as_str()), by_set)
    });
    let others = published.iter().map(|of| {
        let by_set = of.drawbar_rmse_over_load.iter().copied().map(Some).collect();
        result(Some(of.program.as_str()), None, by_set)
    });
    PooledReply { sets: ids, points: points.iter().sum(), results: ours.chain(varied).chain(others).collect() }
}
