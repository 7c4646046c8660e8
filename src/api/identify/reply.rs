//! The answer of `/v1/identify`.

use std::collections::BTreeMap;

use serde::Serialize;
use terramechanics_identification::{Estimate, StopReason, Unknown};
use utoipa::ToSchema;

use super::columns::{IdentifyColumns, columns};
use super::found::{FoundFit, FoundLine, FoundParameters};
use super::request::column_name;
use crate::reply::soil::{self, Spelled};
use crate::reply::{EstimateReply, in_columns, method_name};
use crate::request::circles::{Counted, words};
use crate::request::soil::SoilObject;
use crate::request::system::ContactObject;
use crate::warning::Warning;

/// What measurements say about the parameters, and what they leave open.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Identification)]
pub(crate) struct IdentifyReply {
    /// nonlinear or linear.
    estimator: &'static str,
    /// The method of the forward model.
    method: &'static str,
    /// Circle on which the shear displacement was counted: shearing or rim; null where the method counts none.
    #[schema(required = true, example = "shearing")]
    shear_displacement_radius: Option<&'static str>,
    /// Circle on which the slip was counted: rim, shearing or lug_tip.
    #[schema(example = "rim")]
    slip_radius: &'static str,
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
    /// Correlation of the estimates, in their order; null for an estimate without a standard error.
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
    #[schema(value_type = SoilObject)]
    soil: Spelled,
    /// The contact, ready for a request.
    #[schema(value_type = ContactObject)]
    contact: Spelled,
    warnings: Vec<Warning>,
}

/// Why a search ended, for programs.
fn stop_reason(stop: StopReason) -> &'static str {
    match stop {
        StopReason::NoFurtherDecrease => "no_further_decrease",
        StopReason::SmallStep => "small_step",
        StopReason::Stationary => "stationary",
        StopReason::ExactFit => "exact_fit",
        StopReason::Budget => "budget_spent",
        StopReason::ModelRefuses => "model_refuses",
        StopReason::NotFinite => "not_finite",
    }
}

impl From<FoundParameters> for IdentifyReply {
    fn from(found: FoundParameters) -> Self {
        match found {
            FoundParameters::Fit(found) => (*found).into(),
            FoundParameters::Line(found) => (*found).into(),
        }
    }
}

impl From<FoundFit> for IdentifyReply {
    fn from(FoundFit { setup, observations, fit, warnings }: FoundFit) -> Self {
        let (shear_displacement_radius, slip_radius) = words(Counted::by(&setup.model.method, setup.contact.circles));
        let direction =
            |direction: &Vec<(Unknown, f64)>| direction.iter().map(|&(unknown, share)| (unknown.name(), share)).collect();
        Self {
            estimator: "nonlinear",
            method: method_name(&setup.model.method),
            shear_displacement_radius,
            slip_radius,
            converged: fit.converged(),
            identifiable: fit.is_identifiable(),
            stop_reason: stop_reason(fit.stop),
            iterations: fit.iterations,
            evaluations: fit.evaluations,
            estimates: fit.estimates.iter().map(|estimate| EstimateReply::of_wheel(estimate, &fit.setup)).collect(),
            correlation: fit.correlation.clone(),
            condition_number: Some(fit.condition_number).filter(|number| number.is_finite()),
            dead_directions: fit.dead_directions.iter().map(direction).collect(),
            degrees_of_freedom: fit.degrees_of_freedom,
            reduced_chi_square: fit.reduced_chi_square.filter(|value| value.is_finite()),
            rmse: fit.columns.iter().map(|column| (column_name(column.quantity), column.rmse)).collect(),
            columns: columns(&observations, fit.sinkage.clone(), &fit.columns),
            soil: soil::soil(&fit.setup.soil),
            contact: soil::contact(&fit.setup.contact),
            warnings,
        }
    }
}

impl From<FoundLine> for IdentifyReply {
    fn from(found: FoundLine) -> Self {
        let FoundLine { setup, observations, line, bias, warnings } = found;
        let (shear_displacement_radius, slip_radius) = words(setup.contact.circles.into());
        let biased =
            |(i, estimate): (usize, &Estimate)| EstimateReply::of_wheel(estimate, &setup).biased(bias.map(|bias| bias[i]));
        let sinkage = observations.sinkage.as_ref().map_or_else(Vec::new, |column| column.values.clone());
        Self {
            estimator: "linear",
            method: "linearised",
            shear_displacement_radius,
            slip_radius,
            converged: line.converged,
            identifiable: line.is_identifiable(),
            stop_reason: if line.converged { "linear" } else { "ill_conditioned" },
            iterations: 1,
            evaluations: line.samples() as u64,
            estimates: line.estimates.iter().enumerate().map(biased).collect(),
            correlation: vec![vec![Some(1.0), line.correlation], vec![line.correlation, Some(1.0)]],
            condition_number: Some(line.line.condition_number).filter(|number| number.is_finite()),
            dead_directions: Vec::new(),
            degrees_of_freedom: line.line.freedom,
            reduced_chi_square: None,
            rmse: BTreeMap::from([("torque_n_m", line.torque.rmse)]),
            columns: columns(&observations, sinkage, std::slice::from_ref(&line.torque)),
            soil: soil::soil(&line.setup.soil),
            contact: soil::contact(&setup.contact),
            warnings,
        }
    }
}

in_columns!(IdentifyReply);
