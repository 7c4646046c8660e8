//! Cohesion and friction in one pass, for linear stresses.

use terramechanics::interface_caution;
use terramechanics_identification::{DesignGap, Estimate, FitError, LinearFit, Observations, Setup, Unknown, fit_line_while};

use crate::api::identify::request::{LinearCase, fit_fault, refusal_pointer};
use crate::compute::Pace;
use crate::problem::Problem;
use crate::warning::{Finding, Warning, system_warnings};
use terramechanics_reading::FieldFault;

/// What a line through the stresses shows.
pub(crate) struct FoundLine {
    pub(crate) setup: Setup,
    pub(crate) observations: Observations,
    pub(crate) line: LinearFit,
    /// How far linear stresses mislead each estimate, where that can be told.
    pub(crate) bias: Option<[f64; 2]>,
    pub(crate) warnings: Vec<Warning>,
}

pub(super) fn line(case: &LinearCase, pace: &Pace) -> Result<FoundLine, Problem> {
    let LinearCase { setup, observations, law_known, unused } = case;
    let fault = |error: FitError| {
        Problem::Invalid(vec![match error {
            FitError::Refused { row, error } => FieldFault::new(refusal_pointer(row, &error, &setup.sinkage), error),
            other => fit_fault(&other, &setup.sinkage),
        }])
    };
    let Some(line) = fit_line_while(setup, observations, &|| pace.goes_on()).map_err(fault)? else {
        let detail = "the normal stress under the wheel is the same in all samples: cohesion and friction angle need at least two \
                      different loads, sinkages or slips";
        return Err(Problem::Invalid(vec![FieldFault::new("/data", detail)]));
    };
    let bias = if *law_known { line.model_bias_while(&|| pace.goes_on()).map_err(fault)? } else { None };
    let mut warnings = warnings(&line, bias);
    if *law_known {
        warnings.extend(system_warnings(&setup.wheel, &line.setup.soil));
    }
    warnings.extend(unused.warning());
    warnings.extend(interface_caution(&setup.wheel, &setup.contact).map(Warning::from));
    let (setup, observations) = (*setup, observations.clone());
    Ok(FoundLine { setup, observations, line, bias, warnings })
}

/// What there is to say of a line as a whole.
fn warnings(found: &LinearFit, bias: Option<[f64; 2]>) -> Vec<Warning> {
    let mut findings = vec![Finding::LinearisedStresses {}];
    let samples = found.samples();
    let left_out = samples - found.used;
    if left_out > 0 {
        findings.push(Finding::SamplesLeftOut { left_out, samples });
    }
    if !found.converged {
        findings.push(Finding::LineNotSolved {});
    }
    if !found.is_identifiable() {
        findings.push(Finding::NotIdentifiable { parameters: found.estimates.iter().map(|of| of.unknown.name()).collect() });
    }
    findings.extend(found.gaps.iter().map(|&gap| match gap {
        DesignGap::OneSlip => Finding::SingleSlipOfLine {},
        _ => Finding::gap(gap, [Unknown::COHESION, Unknown::FRICTION_ANGLE].map(Unknown::name).to_vec()),
    }));
    for (i, Estimate { unknown, interval, at_bound, .. }) in found.estimates.iter().enumerate() {
        let parameter = unknown.name();
        if at_bound.is_some() {
            findings.push(Finding::AtBound { parameter, end: "lower", bound: 0.0 });
        }
        if let (Some(bias), Some([lower, upper])) = (bias.map(|bias| bias[i]), interval) {
            let half_width = 0.5 * (upper - lower);
            if bias.abs() > half_width {
                findings.push(Finding::ModelBias { parameter, bias, half_width });
            }
        }
    }
    findings.into_iter().map(Warning::from).collect()
}
