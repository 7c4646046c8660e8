//! What a fit found, in words for people who do not fit every day.

use terramechanics_identification::{Bound, DesignGap, Estimate, FittedColumn, Identifiability, StopReason, Unknown};

use crate::request::{column_name, name_of};

/// A number in four digits.
pub(in crate::reply) fn number(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e6).contains(&size) {
        return format!("{value:.3e}");
    }
    let decimals = if size == 0.0 { 0 } else { (3.0 - size.log10().floor()).max(0.0) as usize };
    format!("{value:.decimals$}")
}

fn list(unknowns: &[Unknown]) -> String {
    unknowns.iter().map(|&unknown| name_of(unknown)).collect::<Vec<_>>().join(", ")
}

pub(super) fn stop_reason(stop: StopReason) -> &'static str {
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

pub(super) fn not_converged(stop: StopReason) -> String {
    match stop {
        StopReason::Budget => {
            "the evaluations or the time were spent before the search ended: fit fewer parameters, send fewer samples or start nearer"
        }
        StopReason::ModelRefuses => {
            "the search ran into values for which the model has no answer: set `bounds`, another `start` or more `starts`"
        }
        StopReason::NotFinite => "numbers overflowed on the way",
        _ => "the search ended at a minimum",
    }
    .to_owned()
}

pub(super) fn gap_code(gap: DesignGap) -> &'static str {
    match gap {
        DesignGap::OneSlip => "single_slip",
        DesignGap::OneLoad => "single_load",
        DesignGap::FewPoints => "few_points",
        DesignGap::NormalForceOnly => "normal_force_only",
    }
}

fn reason(gap: DesignGap) -> &'static str {
    match gap {
        DesignGap::OneSlip => "all samples have one slip",
        DesignGap::OneLoad => "all samples have one load, as measured or as the model has it where it was not",
        DesignGap::FewPoints => "the samples repeat so few operating points that these give no more numbers than are sought",
        DesignGap::NormalForceOnly => "only the normal force is fitted, and the shear stress adds little to it",
    }
}

pub(super) fn gap(gap: DesignGap, together: &[Unknown]) -> String {
    format!("{}: nothing but the assumed shape of the stresses determines {}", reason(gap), list(together))
}

pub(super) fn column_missed(column: &FittedColumn) -> String {
    format!(
        "{} is off by {} (rms), {:.0} % of its size: the model with these values does not describe it; check the units, the wheel and the method",
        column_name(column.quantity),
        number(column.rmse),
        100.0 * column.rmse / column.size()
    )
}

pub(super) fn identifiability(estimate: &Estimate) -> String {
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
            format!("at its {end} bound: the bound decides the value, the data may ask for one beyond")
        }
        Identifiability::WithoutEffect => "not determined: the data do not change with it".to_owned(),
        Identifiability::Inseparable(others) if others.is_empty() => "not determined: the data do not change with it".to_owned(),
        Identifiability::Inseparable(others) => {
            format!("not determined: it can change together with {} and the data stay the same", list(others))
        }
        Identifiability::Unseparated(gap, others) if others.is_empty() => format!("not determined: {}", reason(*gap)),
        Identifiability::Unseparated(gap, others) => {
            format!("not determined by data of this kind: {}, which does not tell it from {}", reason(*gap), list(others))
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
            None if estimate.standard_error.is_some() => "not determined: its interval is wider than numbers go".to_owned(),
            None => "not determined: no error can be stated, there are too few data".to_owned(),
        },
    }
}
