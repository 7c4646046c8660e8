//! What a result says about itself: as data, with a sentence that is made from the data as the last step.
//!
//! [`Finding`] is the table of everything that the service can report; the model's cautions come from the model crate. A
//! warning is a finding or a caution, with the rows and series for which it holds. Nothing else can be sent.

mod detail;
mod gather;
mod of_model;
mod pieces;
mod place;
mod plausible;
mod table;
mod words;

pub(crate) use gather::{RowCautions, gathered, shared_warnings};
pub(crate) use pieces::{BeyondRange, gap_code, gap_in_words};
pub(crate) use place::Rows;
pub(crate) use plausible::implausible;
pub(crate) use table::{Finding, NOTES, Note};
pub(crate) use words::{Reason, number};

use serde::{Serialize, Serializer};
use terramechanics::{Caution, Error, Heading, SoilParams, TestedRange, Wheel, WheelOnSoil};
use utoipa::openapi::{RefOr, Schema};
use utoipa::{PartialSchema, ToSchema};

use crate::catalogue::{self, Outside};
use crate::quantity::shown;

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

/// What is to be said of one operating point: the cautions, what is far from the catalogue, and that the wheel moves backwards.
pub(crate) fn of_point(cautions: impl Iterator<Item = Caution>, system: &WheelOnSoil, heading: Heading) -> Vec<Warning> {
    let mirrored = (heading == Heading::Backward).then(|| Warning::from(Finding::Mirrored {}));
    cautions.map(Warning::from).chain(of_system(system)).chain(mirrored).collect()
}

/// A warning as it stands on the wire.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Warning)]
struct WarningBody {
    /// Kind of the warning, for programs; /v1/model lists them all.
    #[schema(example = "small_wheel")]
    code: &'static str,
    /// The warning in words: the place for which it holds, if there is one, `finding` and `advice`.
    detail: String,
    /// What holds, in the units of the API: for whom shows it in other units, `quantity`, `value` and `range` have the figures.
    #[schema(example = "diameter is 0.4 m, below 0.5 m (Meirion-Griffith & Spenko 2011).")]
    finding: String,
    /// What that means and what to do. It has no figure that depends on the request.
    #[schema(example = "Check its unit.")]
    advice: String,
    /// The range that a quantity leaves, if the warning is about one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    range: Option<Range>,
    /// The quantity that the warning is about, if there is one. It has no value here where it is null in the answer.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "diameter")]
    quantity: Option<String>,
    /// Its value; of several rows, the one furthest out.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    value: Option<f64>,
    /// True where the values of several rows differ, and `value` is the one furthest out.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    #[schema(required = false)]
    varies: bool,
    /// The end of its bounds at which the value lies, where it lies at one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "lower")]
    end: Option<&'static str>,
    /// Its unit by UCUM, 1 for a ratio; some moduli have an exponent in it, such as Pa/m^N.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "m")]
    unit: Option<&'static str>,
    /// Further figures of the finding.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(required = false)]
    figures: Vec<Figure>,
    /// Fields of the request or the answer that the finding names, such as the parameters that data do not determine.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(required = false)]
    names: Vec<&'static str>,
    /// Field of the request to look at, as a JSON pointer.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "/wheel/radius_m")]
    pointer: Option<String>,
    /// Rows that the warning holds for, as pairs of the first and the last index from 0, ascending: the first 20 pairs. Absent
    /// where it holds for every row. A track, which keeps no list, names the first row alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    rows: Option<Vec<[u64; 2]>>,
    /// How many rows it holds for in all, where `rows` is there.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    count: Option<u64>,
    /// Series that the warning holds for; absent where it holds for all or there is but one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(required = false)]
    series: Vec<String>,
}

/// A further figure of a finding.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
#[schema(as = WarningFigure)]
pub(crate) struct Figure {
    /// What it is.
    #[schema(example = "sinkage")]
    quantity: &'static str,
    /// Its value.
    value: f64,
    /// Its unit by UCUM, 1 for a ratio, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "m")]
    unit: Option<&'static str>,
}

impl Figure {
    fn of(quantity: &'static str, value: f64, unit: &'static str) -> Self {
        Self { quantity, value, unit: Some(unit) }
    }

    /// In the unit of a parameter.
    fn of_parameter(quantity: &'static str, value: f64, parameter: &str) -> Self {
        Self { quantity, value, unit: crate::quantity::unit_of_name(parameter) }
    }
}

/// A quantity outside its range.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
struct Range {
    /// The quantity, with its unit in parentheses unless its name ends with it.
    quantity: String,
    /// Its value.
    value: f64,
    /// Lower end of the range, if it has one.
    lower: Option<f64>,
    /// Upper end of the range, if it has one.
    upper: Option<f64>,
    /// Where the range comes from.
    source: &'static str,
}

impl Range {
    fn of(measure: &Measure) -> Option<Self> {
        let Measure { quantity, value, unit, lower, upper, source } = measure;
        lower.or(*upper)?;
        let has_unit = crate::quantity::unit_of_name(quantity).is_some();
        let unit = unit.filter(|_| !has_unit);
        let quantity = unit.map_or_else(|| quantity.clone(), |unit| format!("{quantity} ({})", shown(unit)));
        Some(Self { quantity, value: *value, lower: *lower, upper: *upper, source: (*source)? })
    }
}

impl From<&Warning> for WarningBody {
    fn from(warning: &Warning) -> Self {
        let measure = warning.measure();
        let rows = warning.rows.as_ref();
        let sentences = warning.sentences();
        let finding = match &warning.subject {
            Subject::Finding(finding) => Some(finding),
            Subject::Caution(_) => None,
        };
        Self {
            code: warning.code(),
            detail: warning.placed(&sentences),
            finding: sentences.finding,
            advice: sentences.advice,
            varies: warning.varies,
            end: finding.and_then(Finding::end),
            figures: finding.and_then(Finding::figure).into_iter().filter(|figure| figure.value.is_finite()).collect(),
            names: finding.map(Finding::names).unwrap_or_default(),
            range: measure.as_ref().and_then(Range::of),
            value: measure.as_ref().map(|measure| measure.value).filter(|value| value.is_finite()),
            unit: measure.as_ref().and_then(|measure| measure.unit),
            quantity: measure.map(|measure| measure.quantity),
            pointer: warning.pointer().filter(|pointer| !pointer.is_empty()),
            rows: rows.map(|rows| rows.ranges().collect()),
            count: rows.map(Rows::count),
            series: warning.series.clone(),
        }
    }
}

impl Serialize for Warning {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        WarningBody::from(self).serialize(serializer)
    }
}

impl PartialSchema for Warning {
    fn schema() -> RefOr<Schema> {
        WarningBody::schema()
    }
}

impl ToSchema for Warning {
    fn name() -> std::borrow::Cow<'static, str> {
        WarningBody::name()
    }

    fn schemas(found: &mut Vec<(String, RefOr<Schema>)>) {
        WarningBody::schemas(found);
    }
}

/// The finding that rows have no solution, because of `error`, which belongs to the field at `pointer`.
pub(crate) fn no_solution(error: Error, pointer: &'static str) -> Finding {
    Finding::NoSolution { reason: Reason::Model(error), pointer }
}
