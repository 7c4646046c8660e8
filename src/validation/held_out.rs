//! What is a fit worth on measurements that it has not seen? Parameters of the soil are fitted to the pulls of one part of the
//! measurements and scored on another, by the quadrature. `validation/across-sets/held-out.json` says which.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use terramechanics_identification::{FitOptions, fit};
use terramechanics_reading::Node;
use utoipa::ToSchema;

use super::compared::PULL;
use super::{Prediction, Record, record, root_mean_square};
use crate::api::identify::IdentifyCase;
use crate::request::checked;

/// Points of a set.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
#[schema(as = ValidationPart)]
pub(crate) struct Part {
    /// Name of the set.
    #[schema(example = "ding-2011-smooth")]
    set: String,
    /// Its points, by their index in the columns.
    rows: Vec<usize>,
}

/// Where a fit is made and where it is scored.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Split {
    fitted_on: Part,
    scored_on: Part,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Plan {
    /// The parameters that are fitted together, as `/v1/identify` names them; none of them is the soil as it stands.
    fits: Vec<Vec<String>>,
    splits: Vec<Split>,
}

/// A split with what each fit is worth on it.
#[derive(Debug)]
pub(crate) struct HeldOut {
    pub(crate) fitted_on: &'static Part,
    pub(crate) scored_on: &'static Part,
    pub(crate) scores: Vec<FitScore>,
}

/// What one fit is worth.
#[derive(Debug)]
pub(crate) struct FitScore {
    pub(crate) parameters: &'static [String],
    /// What was found of each parameter; nothing where the search found no minimum.
    pub(crate) values: Vec<(&'static str, f64)>,
    /// Error of the pull over the load on the part that the fit has not seen.
    pub(crate) unseen: Option<f64>,
    /// The same on the part that it was fitted on.
    pub(crate) seen: Option<f64>,
}

/// Evaluations of the forces that a fit may take, some thirty times what those of the plan need.
const EVALUATIONS: u64 = 200_000;

static PLAN: LazyLock<Plan> = LazyLock::new(|| {
    serde_json::from_str(include_str!("../../validation/across-sets/held-out.json"))
        .expect("the plan is compiled in and its tests read it")
});

/// Number of fits.
pub(crate) fn fits() -> usize {
    PLAN.splits.len() * PLAN.fits.iter().filter(|parameters| !parameters.is_empty()).count()
}

/// Every split, computed as it is asked for.
pub(crate) fn held_out() -> impl Iterator<Item = HeldOut> {
    let Plan { fits, splits } = &*PLAN;
    splits.iter().map(|Split { fitted_on, scored_on }| HeldOut {
        fitted_on,
        scored_on,
        scores: fits.iter().map(|parameters| score(fitted_on, scored_on, parameters)).collect(),
    })
}

fn score(fitted_on: &Part, scored_on: &Part, parameters: &'static [String]) -> FitScore {
    let values = if parameters.is_empty() { Some(Vec::new()) } else { fitted_on.fitted(parameters) };
    let error = |part: &Part| values.as_deref().and_then(|values| part.error(values));
    FitScore { parameters, unseen: error(scored_on), seen: error(fitted_on), values: values.unwrap_or_default() }
}

impl Part {
    /// The values of these parameters that meet the pulls of the part best under its loads; none where the search found no minimum.
    fn fitted(&self, parameters: &[String]) -> Option<Vec<(&'static str, f64)>> {
        let body = self.request(record(&self.set)?, parameters)?;
        let IdentifyCase::Fit(case) = checked(&Node::from(&body)).ok()? else { return None };
        // No end by the clock: the result is the same on every machine.
        let options = FitOptions { evaluations: EVALUATIONS, until: None, ..case.options };
        let fit = fit(&case.setup, &case.observations, &case.sought, &options).ok()?;
        fit.converged().then(|| fit.estimates.iter().map(|of| (of.unknown.name(), of.value)).collect())
    }

    /// The request of that fit.
    fn request(&self, record: &Record, parameters: &[String]) -> Option<Value> {
        let load = record.points().load();
        let pull = PULL.measured(record.points(), &load);
        let [slip, load, pull] = [record.slip(), load, pull].map(|column| self.of_rows(&column));
        let mut body = json!({
            "wheel": record.wheel, "soil": record.soil, "slip_radius": record.slip_radius, "fit": parameters,
            "data": {"slip": slip?, "normal_force_n": load?, "longitudinal_force_n": pull?},
        });
        if let Some(contact) = &record.contact {
            body["contact"] = contact.clone();
        }
        Some(body)
    }

    /// The error of the pull over the load with these values of the soil; none where a point has no solution.
    fn error(&self, of_soil: &[(&str, f64)]) -> Option<f64> {
        let record = record(&self.set)?;
        let errors = self.of_rows(&Prediction::with(record, record.quadrature()?, of_soil).pull_errors(record))?;
        root_mean_square(errors.iter().copied()).filter(|_| errors.iter().all(|error| error.is_finite()))
    }

    fn of_rows(&self, column: &[f64]) -> Option<Vec<f64>> {
        self.rows.iter().map(|row| column.get(*row).copied()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A part that shares points with the other is not held out, and a soil of another kind has other values.
    #[test]
    fn the_parts_of_a_split_share_no_point_but_their_soil() {
        for Split { fitted_on, scored_on } in &PLAN.splits {
            let is_shared = |row: &usize| fitted_on.set == scored_on.set && fitted_on.rows.contains(row);
            assert!(!scored_on.rows.iter().any(is_shared), "{fitted_on:?} {scored_on:?}");
            let soil = |part: &Part| &record(&part.set).expect("a set").soil;
            assert_eq!(soil(fitted_on), soil(scored_on));
        }
    }

    /// What was fitted to a set beforehand has seen its points.
    #[test]
    fn no_set_of_a_split_was_fitted_before() {
        for part in PLAN.splits.iter().flat_map(|split| [&split.fitted_on, &split.scored_on]) {
            assert_eq!(record(&part.set).expect("a set").fitted_to, None, "{part:?}");
        }
    }

    #[test]
    fn every_fit_is_a_request_that_finds_its_parameters() {
        for HeldOut { fitted_on, scores, .. } in held_out() {
            for FitScore { parameters, values, unseen, seen } in scores {
                let found: Vec<&str> = values.iter().map(|(name, _)| *name).collect();
                assert_eq!(found, parameters, "{fitted_on:?}");
                assert!(unseen.is_some() && seen.is_some(), "{fitted_on:?} {parameters:?}");
            }
        }
    }
}
