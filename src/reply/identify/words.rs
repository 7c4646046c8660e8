//! What a fit found, in words for people who do not fit every day.

use terramechanics_identification::{Bound, Estimate, Identifiability, StopReason, Unknown};

use crate::warning::{gap_in_words, number};

fn list(unknowns: &[Unknown]) -> String {
    unknowns.iter().map(|&unknown| unknown.name()).collect::<Vec<_>>().join(", ")
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
        Identifiability::Unseparated(gap, others) if others.is_empty() => format!("not determined: {}", gap_in_words(*gap)),
        Identifiability::Unseparated(gap, others) => {
            format!("not determined by data of this kind: {}, which does not tell it from {}", gap_in_words(*gap), list(others))
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
