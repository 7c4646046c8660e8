//! Any parameters by any method, by a search.

use std::time::Instant;

use terramechanics::{Method, interface_caution};
use terramechanics_identification::{Bound, Fit, FitOptions, Observations, Setup, Unknown, fit_while};

use crate::api::identify::request::{FitCase, Measured, column_name, fit_fault};
use crate::compute::Pace;
use crate::problem::Problem;
use crate::warning::{Finding, Warning, implausible, system_warnings};

/// What a search found.
pub(crate) struct FoundFit {
    pub(crate) setup: Setup,
    pub(crate) observations: Observations,
    pub(crate) fit: Fit,
    pub(crate) warnings: Vec<Warning>,
}

/// Sums of squares over the degrees of freedom beyond which the residuals are more than twice, or less than half, of what the
/// standard deviations allow.
const TOO_LARGE: f64 = 4.0;
const TOO_SMALL: f64 = 0.25;

pub(super) fn search(case: &FitCase, until: Instant, pace: &Pace) -> Result<FoundFit, Problem> {
    let FitCase { setup, observations, sought, options, .. } = case;
    let options = FitOptions { until: Some(until), ..*options };
    let fit = fit_while(setup, observations, sought, &options, &|| pace.goes_on())
        .map_err(|error| Problem::Invalid(vec![fit_fault(&error, &setup.sinkage)]))?;
    let warnings = warnings(case, &fit);
    Ok(FoundFit { setup: *setup, observations: observations.clone(), fit, warnings })
}

/// What there is to say of a fit as a whole.
fn warnings(case: &FitCase, found: &Fit) -> Vec<Warning> {
    let mut findings = Vec::new();
    if !found.converged() {
        findings.push(Finding::NotConverged { stop: found.stop });
    }
    if !found.is_identifiable() {
        let open = found.estimates.iter().filter(|estimate| !estimate.identifiability.is_determined());
        findings.push(Finding::NotIdentifiable { parameters: open.map(|estimate| estimate.unknown.name()).collect() });
    }
    for (gap, together) in &found.gaps {
        findings.push(Finding::gap(*gap, together.iter().map(|&unknown| unknown.name()).collect()));
    }
    for estimate in &found.estimates {
        if let Some(bound) = estimate.at_bound {
            let end = if bound == Bound::Lower { "lower" } else { "upper" };
            findings.push(Finding::AtBound { parameter: estimate.unknown.name(), end, bound: estimate.value });
        }
    }
    for column in found.columns.iter().filter(|column| column.is_missed()) {
        let (rmse, share) = (column.rmse, column.rmse / column.size());
        findings.push(Finding::ColumnMissed { column: column_name(column.quantity), rmse, share });
    }
    match found.reduced_chi_square {
        Some(ratio) if ratio < TOO_SMALL => findings.push(Finding::DeviationsTooLarge {}),
        Some(ratio) if ratio > TOO_LARGE => findings.push(Finding::ModelMisfit { ratio: ratio.sqrt() }),
        _ => {}
    }
    let mut warnings: Vec<Warning> = system_warnings(&found.setup.wheel, &found.setup.soil).collect();
    warnings.extend(findings.into_iter().map(Warning::from));
    warnings.extend(implausible(&found.estimates, found.setup.soil.pressure_sinkage.map_or(0.0, |law| law.exponent().base)));
    warnings.extend(beyond_measured(case, found));
    warnings.extend(of_the_interface(case));
    if case.law_replaced {
        warnings.push(Finding::LawReplaced {}.into());
    }
    warnings.extend(case.unused.warning());
    let has_interface = found.setup.model.method != Method::ResistiveForce;
    let interface = interface_caution(&found.setup.wheel, &found.setup.contact).filter(|_| has_interface);
    warnings.extend(interface.map(Warning::from));
    warnings
}

/// The estimates that leave what was measured on the soil that the request names, and not by their errors alone.
fn beyond_measured(case: &FitCase, found: &Fit) -> impl Iterator<Item = Warning> {
    let leaving = |measured: &Measured| {
        let Measured { unknown, preset, range: [low, high] } = *measured;
        let estimate = found.estimates.iter().find(|estimate| estimate.unknown == unknown)?;
        let [least, most] = estimate.interval.unwrap_or([estimate.value; 2]);
        let leaves = least > high || most < low;
        leaves.then(|| Finding::BeyondMeasured { parameter: unknown.name(), value: estimate.value, low, high, preset }.into())
    };
    case.measured.iter().filter_map(leaving)
}

/// That what was fitted to a bare rim may be its interface with the soil, where the contact has none of its own.
fn of_the_interface(FitCase { setup, sought, .. }: &FitCase) -> Option<Warning> {
    let of_interface = |unknown: &Unknown| unknown.found_by(setup) != *unknown;
    let parameters: Vec<&'static str> =
        sought.iter().map(|sought| sought.unknown).filter(of_interface).map(Unknown::name).collect();
    (!parameters.is_empty()).then(|| Finding::MayBeTheInterface { parameters }.into())
}
