//! The answer of the linear estimator, in the same form.

use std::collections::BTreeMap;

use terramechanics_identification::{DesignGap, Estimate, FitError, LinearFit, Unknown, fit_line};

use super::columns::IdentifyColumns;
use super::words::{self, number};
use super::{EstimateReply, IdentifyReply};
use crate::reply::Warning;
use crate::reply::soil::{ContactBody, SoilBody};
use crate::reply::warning::system_warnings;
use crate::request::{LinearCase, fit_fault, name_of, refusal_pointer};
use terramechanics_reading::FieldFault;

impl IdentifyReply {
    pub(super) fn of_line(query: &LinearCase) -> Result<Self, FieldFault> {
        let LinearCase { setup, observations, law_known } = query;
        let fault = |error: FitError| match error {
            FitError::Refused { row, error } => FieldFault::new(refusal_pointer(row, &error, &setup.sinkage), error),
            other => fit_fault(&other, &setup.sinkage),
        };
        let Some(found) = fit_line(setup, observations).map_err(fault)? else {
            let detail = "the normal stress under the wheel is the same in all samples: two different loads, sinkages or slips at \
                          least are needed to tell cohesion from friction";
            return Err(FieldFault::new("/data", detail));
        };
        let bias = if *law_known { found.model_bias() } else { None };
        let estimates = found
            .estimates
            .iter()
            .enumerate()
            .map(|(i, estimate)| EstimateReply { model_bias: bias.map(|bias| bias[i]), ..EstimateReply::from(estimate) });
        let soil = SoilBody::from(&found.setup.soil);
        let mut warnings = warnings(&found, bias);
        if *law_known {
            warnings.extend(system_warnings(&setup.wheel, &found.setup.soil));
        }
        Ok(Self {
            estimator: "linear",
            method: "linearised",
            converged: found.converged,
            identifiable: found.is_identifiable(),
            stop_reason: if found.converged { "linear" } else { "ill_conditioned" },
            iterations: 1,
            evaluations: found.samples() as u64,
            estimates: estimates.collect(),
            correlation: vec![vec![Some(1.0), found.correlation], vec![found.correlation, Some(1.0)]],
            condition_number: Some(found.line.condition_number).filter(|number| number.is_finite()),
            dead_directions: Vec::new(),
            degrees_of_freedom: found.line.freedom,
            reduced_chi_square: None,
            rmse: BTreeMap::from([("torque_n_m", found.torque.rmse)]),
            columns: IdentifyColumns::of(observations, sinkages(query), std::slice::from_ref(&found.torque)),
            soil,
            contact: ContactBody::from(&setup.contact),
            warnings,
        })
    }
}

fn sinkages(query: &LinearCase) -> Vec<f64> {
    query.observations.sinkage.as_ref().map_or_else(Vec::new, |column| column.values.clone())
}

/// What there is to say of a line as a whole.
fn warnings(found: &LinearFit, bias: Option<[f64; 2]>) -> Vec<Warning> {
    let mut warnings = vec![Warning::linearised_stresses()];
    let mut warn = |code: &'static str, detail: String| warnings.push(Warning::new(code, detail));
    let left_out = found.samples() - found.used;
    if left_out > 0 {
        let samples = found.samples();
        warn(
            "samples_left_out",
            format!("{left_out} of {samples} samples mobilise too little of the strength to show it and were left out"),
        );
    }
    if !found.converged {
        warn("not_converged", "the numbers are too far apart for the line to be solved".to_owned());
    }
    if !found.is_identifiable() {
        let detail = "the data do not determine both parameters; see each one's `identifiability`";
        warn("not_identifiable", detail.to_owned());
    }
    for &gap in &found.gaps {
        let detail = match gap {
            DesignGap::OneSlip => {
                "all samples have one slip: a wrong shear_modulus_m, which is taken as known, changes both parameters by one factor \
                 and does not show"
                    .to_owned()
            }
            _ => words::gap(gap, &[Unknown::Cohesion, Unknown::FrictionAngle]),
        };
        warn(words::gap_code(gap), detail);
    }
    for (i, Estimate { unknown, interval, at_bound, .. }) in found.estimates.iter().enumerate() {
        let name = name_of(*unknown);
        if at_bound.is_some() {
            warn("at_bound", format!("{name} lies at its lower bound 0"));
        }
        if let (Some(bias), Some([lower, upper])) = (bias.map(|bias| bias[i]), interval)
            && bias.abs() > 0.5 * (upper - lower)
        {
            let detail = format!(
                "by the soil's pressure–sinkage law, linear stresses put {name} off by {}, more than the half width {} of its \
                 interval: take \"estimator\": \"nonlinear\" with the quadrature",
                number(bias),
                number(0.5 * (upper - lower))
            );
            warn("model_bias", detail);
        }
    }
    warnings
}
