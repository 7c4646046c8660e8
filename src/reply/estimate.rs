//! What was found of one parameter, with words for people who do not fit every day.

use serde::Serialize;
use terramechanics_identification::{Bound, Estimate, Identifiability, Setup, Unknown};
use utoipa::ToSchema;

use crate::quantity::number;
use crate::warning::{gap_code, gap_in_words};

/// The result for one parameter.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ParameterEstimate)]
pub(crate) struct EstimateReply {
    /// Its name.
    #[schema(example = "cohesion_pa")]
    parameter: &'static str,
    /// What was found: the parameter itself, or, by a fit to a wheel without lugs and without an interface, its counterpart between rim and soil.
    #[schema(example = "interface_adhesion_pa")]
    found: &'static str,
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
    /// The same as data.
    known: Known,
}

impl EstimateReply {
    /// With how far linear stresses mislead it, where that can be told.
    pub(crate) fn biased(self, model_bias: Option<f64>) -> Self {
        Self { model_bias, ..self }
    }
}

impl EstimateReply {
    /// The result of a fit to a wheel.
    pub(crate) fn of_wheel(estimate: &Estimate, setup: &Setup) -> Self {
        Self { found: estimate.unknown.found_by(setup).name(), ..Self::from(estimate) }
    }
}

impl From<&Estimate> for EstimateReply {
    fn from(estimate: &Estimate) -> Self {
        let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
        Self {
            parameter: estimate.unknown.name(),
            found: estimate.unknown.name(),
            value: estimate.value,
            standard_error: finite(estimate.standard_error),
            interval_95: estimate.interval.filter(|interval| interval.iter().all(|end| end.is_finite())),
            at_bound: estimate.at_bound.is_some(),
            model_bias: None,
            identifiability: identifiability(estimate),
            known: estimate.into(),
        }
    }
}

/// What the data tell of a parameter.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Identifiability)]
struct Known {
    /// Whether they determine it. They do where it is `determined`, and up to a bound where it is `at_bound`.
    code: IdentifiabilityCode,
    /// Half the width of the 95 % interval, where it has one of its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    half_width: Option<f64>,
    /// The bound at which the parameter lies, or the side from which alone the data bound it: `upper` is from above.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    end: Option<End>,
    /// Parameters that it cannot be told from.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(required = false)]
    tied_to: Vec<&'static str>,
    /// Where it is `unseparated`: code of the warning that says what the data do not vary.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "single_slip")]
    gap: Option<&'static str>,
    /// Another value that explains the data as well.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    other: Option<f64>,
}

/// Whether data determine a parameter.
#[derive(Debug, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
enum IdentifiabilityCode {
    Determined,
    AtBound,
    WithoutEffect,
    Inseparable,
    Unseparated,
    SeveralSolutions,
    OneSided,
    Uncertain,
}

/// An end of a range.
#[derive(Debug, Clone, Copy, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
#[schema(as = BoundEnd)]
enum End {
    Lower,
    Upper,
}

impl From<Bound> for End {
    fn from(bound: Bound) -> Self {
        match bound {
            Bound::Lower => Self::Lower,
            Bound::Upper => Self::Upper,
        }
    }
}

impl From<&Estimate> for Known {
    fn from(estimate: &Estimate) -> Self {
        let half_width = half_width(estimate);
        let known = |code| Self { code, half_width, end: None, tied_to: Vec::new(), gap: None, other: None };
        match &estimate.identifiability {
            Identifiability::Determined => known(IdentifiabilityCode::Determined),
            Identifiability::AtBound => Self { end: estimate.at_bound.map(End::from), ..known(IdentifiabilityCode::AtBound) },
            Identifiability::WithoutEffect => known(IdentifiabilityCode::WithoutEffect),
            Identifiability::Inseparable(others) if others.is_empty() => known(IdentifiabilityCode::WithoutEffect),
            Identifiability::Inseparable(others) => Self { tied_to: names(others), ..known(IdentifiabilityCode::Inseparable) },
            Identifiability::Unseparated(gap, others) => {
                Self { gap: Some(gap_code(*gap)), tied_to: names(others), ..known(IdentifiabilityCode::Unseparated) }
            }
            Identifiability::SeveralSolutions { other } => {
                Self { other: Some(*other), ..known(IdentifiabilityCode::SeveralSolutions) }
            }
            Identifiability::OneSided(bound) => {
                Self { end: Some(End::from(*bound)), half_width: None, ..known(IdentifiabilityCode::OneSided) }
            }
            Identifiability::Uncertain => known(IdentifiabilityCode::Uncertain),
        }
    }
}

fn names(unknowns: &[Unknown]) -> Vec<&'static str> {
    unknowns.iter().map(|unknown| unknown.name()).collect()
}

/// Half the width of the interval; none where an end is a bound or overflows.
fn half_width(estimate: &Estimate) -> Option<f64> {
    let [lower, upper] = estimate.interval?;
    estimate.standard_error.map(|_| 0.5 * (upper - lower)).filter(|width| width.is_finite())
}

fn list(unknowns: &[Unknown]) -> String {
    names(unknowns).join(", ")
}

/// Whether the data determine a parameter, in words.
fn identifiability(estimate: &Estimate) -> String {
    let width = half_width(estimate);
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
