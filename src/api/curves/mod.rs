//! The rooms of curves that were measured one by one: plate tests and shear tests.

pub(crate) mod plates;
pub(crate) mod shear;

use terramechanics_identification::Estimate;
use terramechanics_reading::{Field, Number, Numbers, Reader};

use crate::warning::{Finding, Warning};

/// Numbers that a column has at most.
const MOST: usize = 10_001;

const fn column(name: &'static str, meaning: &'static str, number: Number) -> Field<Numbers> {
    Field::required(name, meaning, Numbers::new(number, 1, MOST))
}

/// Two columns of one length.
fn pair<'r>(columns: &'r Reader<'_>, first: &Field<Numbers>, second: &Field<Numbers>) -> Option<(&'r [f64], &'r [f64])> {
    let (values, others) = (columns.required(first), columns.required(second));
    let (values, others) = (values?, others?);
    if values.len() != others.len() {
        let (found, expected) = (others.len(), values.len());
        columns.place_of(second).fault(format_args!("has {found} values where `{}` has {expected}", first.name));
        return None;
    }
    Some((values, others))
}

/// Warns of parameters that the data leave open or that lie at a bound.
fn open(estimates: &[Estimate]) -> Vec<Warning> {
    let open = estimates.iter().filter(|estimate| !estimate.identifiability.is_determined());
    let parameters: Vec<&str> = open.map(|estimate| estimate.unknown.name()).collect();
    let open = (!parameters.is_empty()).then_some(Finding::NotIdentifiable { parameters });
    let at_bound = estimates.iter().filter(|estimate| estimate.at_bound.is_some());
    let at_bound = at_bound.map(|estimate| Finding::AtBound { parameter: estimate.unknown.name(), end: "lower", bound: 0.0 });
    open.into_iter().chain(at_bound).map(Warning::from).collect()
}

/// Columns of one curve: what was held, what was set, what was measured and what is predicted.
struct Curve<'a> {
    held: f64,
    set: &'a [f64],
    measured: &'a [f64],
    predicted: &'a [f64],
}

/// All curves, one after the other: held, set, measured, predicted, predicted minus measured.
fn one_after_the_other<'a>(curves: impl Iterator<Item = Curve<'a>>) -> [Vec<f64>; 5] {
    let mut columns = [const { Vec::new() }; 5];
    for Curve { held, set, measured, predicted } in curves {
        let [helds, sets, measureds, predicteds, residuals] = &mut columns;
        helds.extend(std::iter::repeat_n(held, set.len()));
        sets.extend(set);
        measureds.extend(measured);
        predicteds.extend(predicted);
        residuals.extend(predicted.iter().zip(measured).map(|(predicted, measured)| predicted - measured));
    }
    columns
}
