//! What was found of one parameter, with words for people who do not fit every day.

use serde::Serialize;
use terramechanics_identification::{Bound, Estimate, Identifiability, Unknown};
use utoipa::ToSchema;

use crate::warning::{gap_in_words, number};

/// The result for one parameter.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ParameterEstimate)]
pub(crate) struct EstimateReply {
    /// Its name.
    #[schema(example = "cohesion_pa")]
    parameter: &'static str,
    value: f64,
    /// Standard error; null where the data leave the parameter open. At a bound it is the error without the bound.
    standard_error: Option<f64>,
    /// 95 % interval, not cut at the bounds; where the data bound the parameter on one side alone, the other end is its bound.
    interval_95: Option<[f64; 2]>,
    /// Whether it lies at a bound.
    at_bound: bool,
    /// Bias of the linear estimator from its assumption of linear stresses, found by simulation with the quadrature: the estimate minus the true value that would have led to it. Absent without a pressure–sinkage law and where the model has no answer for a sample.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    model_bias: Option<f64>,
    /// Whether the data determine it, in words.
    identifiability: String,
}

impl EstimateReply {
    /// With how far linear stresses mislead it, where that can be told.
    pub(crate) fn biased(self, model_bias: Option<f64>) -> Self {
        Self { model_bias, ..self }
    }
}

impl From<&Estimate> for EstimateReply {
    fn from(estimate: &Estimate) -> Self {
        let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
        Self {
            parameter: estimate.unknown.name(),
            value: estimate.value,
            standard_error: finite(estimate.standard_error),
            interval_95: estimate.interval.filter(|interval| interval.iter().all(|end| end.is_finite())),
            at_bound: estimate.at_bound.is_some(),
            model_bias: None,
            identifiability: identifiability(estimate),
        }
    }
}

fn list(unknowns: &[Unknown]) -> String {
    unknowns.iter().map(|&unknown| unknown.name()).collect::<Vec<_>>().join(", ")
}

/// Whether the data determine a parameter, in words.
fn identifiability(estimate: &Estimate) -> String {
    let width = match (estimate.interval, estimate.standard_error) {
        (Some([lower, upper]), Some(_)) => Some(0.5 * (upper - lower)),
        _ => None,
    };
    match &estimate.identifiability {
        Identifiability::Determined => match width {
            Some(width) => format!("determined to ± {} (95 %)", number(width)),
            None => "determined".to_owned(),
        },
        Identifiability::AtBound => {
            let end = if estimate.at_bound == Some(Bound::Lower) { "lower" } else { "upper" };
            format!("at its {end} bound, which decides the value: the data may call for a value beyond it")
        }
        Identifiability::WithoutEffect => "not determined: the data do not change with it".to_owned(),
        Identifiability::Inseparable(others) if others.is_empty() => "not determined: the data do not change with it".to_owned(),
        Identifiability::Inseparable(others) => {
            format!("not determined: it can change together with {} and the data stay the same", list(others))
        }
        Identifiability::Unseparated(gap, others) if others.is_empty() => format!("not determined: {}", gap_in_words(*gap)),
        Identifiability::Unseparated(gap, others) => {
            format!("not determined by data of this kind: {}, so it cannot be told from {}", gap_in_words(*gap), list(others))
        }
        Identifiability::SeveralSolutions { other } => {
            format!("not determined: {} explains the data as well, found from another start", number(*other))
        }
        Identifiability::OneSided(bound) => {
            let end = estimate.interval.map(|[lower, upper]| if *bound == Bound::Upper { upper } else { lower });
            let side = if *bound == Bound::Upper { "above" } else { "below" };
            format!("not determined: the data bound it only from {side}, by {} (95 %)", end.map_or_else(String::new, number))
        }
        Identifiability::Uncertain => match width {
            Some(width) => format!("not determined: ± {} (95 %) is too wide to be of use", number(width)),
            None if estimate.standard_error.is_some() => {
                "not determined: its interval is too wide to be written as a number".to_owned()
            }
            None => "not determined: there are too few data to state an error".to_owned(),
        },
    }
}
