//! Warnings as they stand on the wire.

use std::borrow::Cow;

use serde::{Serialize, Serializer};
use utoipa::openapi::{RefOr, Schema};
use utoipa::{PartialSchema, ToSchema};

use super::figure::Figure;
use super::{Finding, Measure, Rows, Subject, Warning};
use crate::quantity::{shown, unit_of_name};

/// A warning as it stands on the wire.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Warning)]
struct WarningBody {
    /// Kind of the warning, for programs; /v1/model lists them all.
    #[schema(example = "small_wheel")]
    code: &'static str,
    /// The warning in words: the place for which it holds, if there is one, `finding` and `advice`.
    detail: String,
    /// What holds, in the units of the API. A program that shows other units makes its own sentence from the data.
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
    names: Vec<Cow<'static, str>>,
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
        let has_unit = unit_of_name(quantity).is_some();
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
