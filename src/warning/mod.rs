//! What a result says about itself: as data, with a sentence that is made from the data as the last step.
//!
//! [`Finding`] is the table of everything that the service can report; the model's cautions come from the model crate. A
//! warning is a finding or a caution, with the rows and series for which it holds. Nothing else can be sent.

mod detail;
mod figure;
mod gather;
mod of_model;
mod pieces;
mod place;
mod plausible;
mod table;
mod tally;
mod wire;
mod words;

pub(crate) use gather::{RowCautions, gathered, shared_warnings};
pub(crate) use of_model::gap_code;
pub(crate) use pieces::{BeyondRange, gap_in_words};
pub(crate) use place::Rows;
pub(crate) use plausible::implausible;
pub(crate) use table::{Finding, NOTES, Note};
pub(crate) use tally::Tally;
pub(crate) use words::{Reason, listed};

use terramechanics::{Caution, Error, Heading, Motion, SoilParams, TestedRange, Wheel, WheelOnSoil};
use terramechanics_reading::Assumption;

use crate::catalogue::{self, Outside};

/// What a warning is about.
#[derive(Debug, Clone, PartialEq)]
enum Subject {
    /// A caution of the model.
    Caution(Caution),
    /// A finding of the service.
    Finding(Finding),
}

/// A reason to take a result with care.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Warning {
    subject: Subject,
    /// Whether the value of a caution is the one furthest out of several.
    varies: bool,
    /// The rows that it holds for; none where it holds for all or knows no rows.
    rows: Option<Rows>,
    /// Names of the series that it holds for; none where it holds for all or there is but one.
    series: Vec<String>,
}

/// A value that a warning is about.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Measure {
    quantity: String,
    value: f64,
    unit: Option<&'static str>,
    lower: Option<f64>,
    upper: Option<f64>,
    source: Option<&'static str>,
}

impl Measure {
    /// The value of a quantity. The unit is not known where the name has no suffix of a unit.
    pub(crate) fn of(quantity: &str, value: f64) -> Self {
        let unit = crate::quantity::unit_of_name(quantity);
        Self { quantity: quantity.to_owned(), value, unit, lower: None, upper: None, source: None }
    }

    /// A quantity that has no value.
    fn without_value(quantity: &str) -> Self {
        Self::of(quantity, f64::NAN)
    }

    pub(crate) fn in_unit(self, unit: &'static str) -> Self {
        Self { unit: Some(unit), ..self }
    }

    /// With the range that the value leaves, and where that comes from.
    pub(crate) fn beyond(self, lower: Option<f64>, upper: Option<f64>, source: &'static str) -> Self {
        Self { lower, upper, source: Some(source), ..self }
    }
}

impl Warning {
    /// At the rows with these indices.
    pub(crate) fn at(self, rows: Rows) -> Self {
        Self { rows: Some(rows), ..self }
    }

    /// With the value furthest out of several that differ, or not.
    pub(crate) fn varying(self, varies: bool) -> Self {
        Self { varies, ..self }
    }

    /// The warning, holding for the series of these names.
    pub(crate) fn of_series(self, series: Vec<String>) -> Self {
        Self { series, ..self }
    }

    /// Whether it is about what was sent rather than about what came of it.
    pub(crate) fn is_hint(&self) -> bool {
        matches!(&self.subject, Subject::Finding(Finding::OutsideCatalogue { .. } | Finding::NotUsed { .. }))
    }

    /// Kind of the warning, for programs.
    pub(crate) fn code(&self) -> &'static str {
        match &self.subject {
            Subject::Caution(caution) => caution.kind.code,
            Subject::Finding(finding) => finding.code(),
        }
    }

    fn measure(&self) -> Option<Measure> {
        match &self.subject {
            Subject::Finding(finding) => finding.measure(),
            Subject::Caution(caution) => {
                let TestedRange { quantity, unit, lower, upper, source } = *caution.kind.range.as_ref()?;
                Some(Measure::of(quantity, caution.value).in_unit(unit).beyond(lower, upper, source))
            }
        }
    }

    fn pointer(&self) -> Option<String> {
        match &self.subject {
            Subject::Finding(finding) => finding.pointer().map(str::to_owned),
            Subject::Caution(caution) => words::pointer_of(caution.kind.parameter?),
        }
    }
}

impl From<Caution> for Warning {
    fn from(caution: Caution) -> Self {
        Self { subject: Subject::Caution(caution), varies: false, rows: None, series: Vec::new() }
    }
}

impl From<Finding> for Warning {
    fn from(finding: Finding) -> Self {
        Self { subject: Subject::Finding(finding), varies: false, rows: None, series: Vec::new() }
    }
}

impl From<Outside> for Warning {
    fn from(outside: Outside) -> Self {
        Finding::OutsideCatalogue { outside }.into()
    }
}

/// The warnings about a wheel and a soil in any request: values far beyond all of the catalogue.
pub(crate) fn system_warnings(wheel: &Wheel, soil: &SoilParams) -> impl Iterator<Item = Warning> + use<> {
    catalogue::outside(wheel, soil).map(Warning::from)
}

/// What is to be said of a wheel on a soil, wherever it is.
pub(crate) fn of_system(system: &WheelOnSoil) -> impl Iterator<Item = Warning> + use<> {
    system_warnings(&system.wheel, system.soil.params())
}

/// What is to be said of one operating point: the cautions, what is far from the catalogue, and how the wheel moves.
pub(crate) fn of_point(cautions: impl Iterator<Item = Caution>, system: &WheelOnSoil, motion: Motion) -> Vec<Warning> {
    cautions.map(Warning::from).chain(of_system(system)).chain(of_motion(motion).map(Warning::from)).collect()
}

/// What is to be said of a motion: that the wheel moves backwards, or not at all.
pub(crate) fn of_motion(motion: Motion) -> impl Iterator<Item = Finding> {
    let mirrored = (motion.heading == Heading::Backward).then_some(Finding::Mirrored {});
    mirrored.into_iter().chain(motion.at_rest.then_some(Finding::AtRest {}))
}

/// What is to be said where values were assumed.
pub(crate) fn of_assumptions(assumptions: &[Assumption]) -> Option<Warning> {
    let value = |one: &Assumption| (one.field.clone(), one.preset.clone(), one.value);
    (!assumptions.is_empty()).then(|| Finding::AssumedValues { values: assumptions.iter().map(value).collect() }.into())
}

/// The finding that rows have no solution, because of `error`, which belongs to the field at `pointer`.
pub(crate) fn no_solution(error: Error, pointer: &'static str) -> Finding {
    Finding::NoSolution { reason: Reason::Model(error), pointer }
}
