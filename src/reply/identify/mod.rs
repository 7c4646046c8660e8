//! The answer of `/v1/identify`.

mod columns;
mod linear;
mod plausible;
pub(super) mod words;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use serde::Serialize;
use terramechanics_identification::{Bound, Estimate, Fit, FitOptions, fit};
use utoipa::ToSchema;

use self::columns::IdentifyColumns;
pub(super) use self::plausible::implausible;
use super::forces::method_name;
use super::soil::{ContactBody, SoilBody};
use super::warning::system_warnings;
use super::{Reply, Warning};
use crate::request::{FitCase, IdentifyCase, column_name, fit_fault, name_of};
use terramechanics_reading::FieldFault;

/// What measurements tell of the parameters, and what they do not.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Identification)]
pub(crate) struct IdentifyReply {
    /// nonlinear or linear.
    estimator: &'static str,
    /// The method of the forward model.
    method: &'static str,
    /// Whether the search ended at a minimum; that alone does not make it the only one, see `identifiable`.
    converged: bool,
    /// Whether the data determine every parameter, if need be up to a bound.
    identifiable: bool,
    /// Why the search ended.
    stop_reason: &'static str,
    /// Steps of the best search.
    iterations: u32,
    /// Evaluations of the forces, over all starts.
    evaluations: u64,
    /// One per parameter, in the order of `fit`.
    estimates: Vec<EstimateReply>,
    /// Correlation of the estimates, in their order; null with one that has no standard error.
    correlation: Vec<Vec<Option<f64>>>,
    /// Condition number of the derivatives, each scaled to length one; null where a direction is dead.
    condition_number: Option<f64>,
    /// Directions along which the data do not change: the share of every parameter, scaled by its effect on the data.
    dead_directions: Vec<BTreeMap<&'static str, f64>>,
    /// Measurements minus determined parameters.
    degrees_of_freedom: f64,
    /// Weighted sum of squares over the degrees of freedom; about 1 where model and standard deviations hold, null without them.
    reduced_chi_square: Option<f64>,
    /// Root of the mean squared residual, by fitted column, in its unit.
    rmse: BTreeMap<&'static str, f64>,
    columns: IdentifyColumns,
    /// The soil with the estimates, ready for a request.
    soil: SoilBody,
    /// The contact, ready for a request.
    contact: ContactBody,
    warnings: Vec<Warning>,
}

/// What was found of one parameter.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ParameterEstimate)]
pub(super) struct EstimateReply {
    /// Its name.
    #[schema(example = "cohesion_pa")]
    parameter: &'static str,
    value: f64,
    /// Standard error; null where the data leave the parameter open. At a bound it is what would hold without the bound.
    standard_error: Option<f64>,
    /// Interval of 95 %, not cut at the bounds; where the data bound the parameter from one side alone, the other end is its bound.
    interval_95: Option<[f64; 2]>,
    /// Whether it lies at a bound.
    at_bound: bool,
    /// Of the linear estimator on a soil with a pressure–sinkage law: how far linear stresses mislead it, by simulation: it minus the value with which the quadrature would have led to it; absent where the model has no answer for a sample.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    model_bias: Option<f64>,
    /// Whether the data determine it, in words.
    identifiability: String,
}

/// Share of the time for a computation that a search may take; the rest is for its report and for writing it.
const SEARCHING: f64 = 0.5;

impl IdentifyReply {
    /// The answer, with a search that ends within its share of `patience`.
    ///
    /// # Errors
    /// What of the request the model or the data do not allow.
    pub(crate) fn of(query: &IdentifyCase, patience: Duration) -> Result<Self, Vec<FieldFault>> {
        match query {
            IdentifyCase::Fit(query) => Self::of_fit(query, Instant::now() + patience.mul_f64(SEARCHING)),
            IdentifyCase::Linear(query) => Self::of_line(query).map_err(|fault| vec![fault]),
        }
    }

    fn of_fit(query: &FitCase, until: Instant) -> Result<Self, Vec<FieldFault>> {
        let FitCase { setup, observations, sought, options, .. } = query;
        let options = FitOptions { until: Some(until), ..*options };
        let found = fit(setup, observations, sought, &options).map_err(|error| vec![fit_fault(&error, &setup.sinkage)])?;
        let direction = |direction: &Vec<_>| direction.iter().map(|&(unknown, share)| (name_of(unknown), share)).collect();
        Ok(Self {
            estimator: "nonlinear",
            method: method_name(&setup.model.method),
            converged: found.converged(),
            identifiable: found.is_identifiable(),
            stop_reason: words::stop_reason(found.stop),
            iterations: found.iterations,
            evaluations: found.evaluations,
            estimates: found.estimates.iter().map(EstimateReply::from).collect(),
            correlation: found.correlation.clone(),
            condition_number: Some(found.condition_number).filter(|number| number.is_finite()),
            dead_directions: found.dead_directions.iter().map(direction).collect(),
            degrees_of_freedom: found.degrees_of_freedom,
            reduced_chi_square: found.reduced_chi_square.filter(|value| value.is_finite()),
            rmse: found.columns.iter().map(|column| (column_name(column.quantity), column.rmse)).collect(),
            columns: IdentifyColumns::of_fit(observations, &found),
            soil: SoilBody::from(&found.setup.soil),
            contact: ContactBody::from(&found.setup.contact),
            warnings: warnings(query, &found),
        })
    }
}

impl From<&Estimate> for EstimateReply {
    fn from(estimate: &Estimate) -> Self {
        let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
        Self {
            parameter: name_of(estimate.unknown),
            value: estimate.value,
            standard_error: finite(estimate.standard_error),
            interval_95: estimate.interval.filter(|interval| interval.iter().all(|end| end.is_finite())),
            at_bound: estimate.at_bound.is_some(),
            model_bias: None,
            identifiability: words::identifiability(estimate),
        }
    }
}

/// Sums of squares over the degrees of freedom beyond which the residuals are more than twice, or less than half, of what the standard deviations
/// allow.
const TOO_LARGE: f64 = 4.0;
const TOO_SMALL: f64 = 0.25;

/// What there is to say of a fit as a whole.
fn warnings(query: &FitCase, found: &Fit) -> Vec<Warning> {
    let mut warnings: Vec<Warning> = system_warnings(&found.setup.wheel, &found.setup.soil).collect();
    let mut warn = |code: &'static str, detail: String| warnings.push(Warning::new(code, detail));
    let names = |open: bool| -> Vec<&'static str> {
        let estimates = found.estimates.iter().filter(|estimate| estimate.identifiability.is_determined() != open);
        estimates.map(|estimate| name_of(estimate.unknown)).collect()
    };
    if !found.converged() {
        warn("not_converged", words::not_converged(found.stop));
    }
    if !found.is_identifiable() {
        warn(
            "not_identifiable",
            format!("the data do not determine {}; see each one's `identifiability`", names(true).join(", ")),
        );
    }
    for (gap, together) in &found.gaps {
        warn(words::gap_code(*gap), words::gap(*gap, together));
    }
    for estimate in &found.estimates {
        if let Some(bound) = estimate.at_bound {
            let end = if bound == Bound::Lower { "lower" } else { "upper" };
            warn("at_bound", format!("{} lies at its {end} bound {}", name_of(estimate.unknown), words::number(estimate.value)));
        }
    }
    for column in found.columns.iter().filter(|column| column.is_missed()) {
        warn("column_missed", words::column_missed(column));
    }
    if found.reduced_chi_square.is_some_and(|ratio| ratio < TOO_SMALL) {
        let detail = "the residuals are less than half of what the standard deviations allow: these look too large; the errors \
                      follow from the residuals, only the ratios of the standard deviations count";
        warn("deviations_too_large", detail.to_owned());
    }
    if let Some(ratio) = found.reduced_chi_square.filter(|ratio| *ratio > TOO_LARGE) {
        let detail =
            "the residuals are {} times what the standard deviations allow: the model does not describe the data that well, and \
                      the errors were widened by that factor"
                .replace("{}", &words::number(ratio.sqrt()));
        warn("model_misfit", detail);
    }
    warnings.extend(implausible(&found.estimates, found.setup.soil.pressure_sinkage.map_or(0.0, |law| law.exponent().base)));
    let mut warn = |code: &'static str, detail: String| warnings.push(Warning::new(code, detail));
    if query.law_replaced {
        let detail = "k_s is fitted: the direct law stands in place of the preset's, with its exponents".to_owned();
        warn("law_replaced", detail);
    }
    warnings
}

impl Reply for IdentifyReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        self.columns.named()
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
