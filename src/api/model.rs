//! `GET /v1/model`: the equations as implemented, and where they depart from the letter as printed.

mod laws;
#[cfg(test)]
mod percentages;

use std::sync::LazyLock;

use axum::http::HeaderMap;
use axum::response::Response;
use serde::{Deserialize, Serialize};
use terramechanics::{Caution, CautionKind, ERRATA, SOURCES};
use utoipa::ToSchema;

use self::laws::{LawFamily, ParameterNote};
use super::responses::{InvalidQuery, Limits};
use crate::answer::JSON;
use crate::catalogue::{self, Gravity};
use crate::extract::NoQuery;
use crate::fixed::Fixed;
use crate::quantity::{self, About, Quantity, shown};
use crate::warning::{self, Note};

/// What the service computes.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Model {
    /// Where the model comes from.
    source: String,
    /// Conventions: units, angles, slip.
    conventions: Vec<String>,
    /// The symbols of the equations.
    symbols: Vec<Symbol>,
    /// The equations as they are computed.
    equations: Vec<Equation>,
    /// Which method to use: the first row whose condition holds.
    advice: Vec<Advice>,
    /// The methods for the forces, and what each costs in accuracy.
    methods: Vec<MethodNote>,
    /// Where the letter as printed is not what is computed.
    #[serde(default)]
    #[schema(required)]
    errata: Vec<Erratum>,
    /// What is refused.
    refusals: Vec<String>,
    /// The laws that a request may name, each with its parameters.
    #[serde(default)]
    #[schema(required)]
    laws: Vec<LawFamily>,
    /// The numbers of a wheel, and those of a soil that are no law's.
    #[serde(default)]
    #[schema(required)]
    parameters: Vec<ParameterNote>,
    /// The quantities of answers, in the order of their columns.
    #[serde(default)]
    quantities: Vec<QuantityNote>,
    /// The warnings that results may carry.
    #[serde(default)]
    warnings: Vec<WarningNote>,
    /// Gravity of the bodies where wheels roll, for loads and unit weights.
    #[serde(default)]
    gravity: Vec<Gravity>,
    /// The papers named.
    #[serde(default)]
    #[schema(required)]
    references: Vec<String>,
}

/// A symbol in the equations.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
struct Symbol {
    symbol: String,
    meaning: String,
    unit: String,
    /// Its name in requests and replies, where it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    field: Option<String>,
}

/// An equation as it is computed.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
struct Equation {
    name: String,
    /// Numbers in the letter; empty where the letter has none.
    letter: Vec<String>,
    formula: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    source: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
    /// Numbers of the errata that concern it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    errata: Vec<u8>,
}

/// What to use where something is known.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
struct Advice {
    /// What is known.
    when: String,
    /// The method to take, or the operation.
    take: String,
    /// Root mean square error of the pull over the load on public tests. Nothing was fitted unless it says so.
    pull_error: String,
}

/// A method for the forces.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
struct MethodNote {
    /// Its name in `method`.
    method: String,
    description: String,
    accuracy: String,
}

/// A place where the letter as printed is not what is computed.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
struct Erratum {
    number: u8,
    /// What is printed, and where.
    printed: String,
    /// Why that is an error.
    reason: String,
    /// What is computed instead.
    computed: String,
}

/// A quantity that answers have.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
struct QuantityNote {
    /// Its name in answers.
    name: String,
    /// Its symbol in the equations; empty where it has none.
    symbol: String,
    /// Its unit by UCUM, 1 for a ratio; empty for a word.
    unit: String,
    meaning: String,
    /// The operations whose answers have it.
    operations: Vec<String>,
}

impl From<&Quantity> for QuantityNote {
    fn from(quantity: &Quantity) -> Self {
        let About { name, symbol, unit, meaning } = quantity.about;
        let operations = quantity.operations().map(str::to_owned).collect();
        Self { name: name.into(), symbol: symbol.into(), unit: unit.into(), meaning: meaning.into(), operations }
    }
}

/// A warning that results may carry.
#[derive(Debug, Default, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
struct WarningNote {
    code: String,
    meaning: String,
    /// What to do about it, where that is the same each time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    advice: Option<String>,
    /// The quantity that leaves its range, with its unit, where the warning is about one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    quantity: Option<String>,
    /// Lower end of the range.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    lower: Option<f64>,
    /// Upper end of the range.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    upper: Option<f64>,
    /// Where the range comes from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    source: Option<String>,
}

impl From<&terramechanics::Erratum> for Erratum {
    fn from(erratum: &terramechanics::Erratum) -> Self {
        let terramechanics::Erratum { number, printed, reason, computed } = *erratum;
        Self { number, printed: printed.into(), reason: reason.into(), computed: computed.into() }
    }
}

impl From<&CautionKind> for WarningNote {
    fn from(kind: &CautionKind) -> Self {
        let range = kind.range.as_ref();
        Self {
            code: kind.code.into(),
            meaning: kind.meaning.into(),
            advice: Some(kind.advice.into()),
            quantity: range.map(|range| format!("{} ({})", range.quantity, shown(range.unit))),
            lower: range.and_then(|range| range.lower),
            upper: range.and_then(|range| range.upper),
            source: range.map(|range| range.source.into()),
        }
    }
}

impl From<&Note> for WarningNote {
    fn from(&Note { code, meaning }: &Note) -> Self {
        Self { code: code.into(), meaning: meaning.into(), ..Self::default() }
    }
}

static TEXT: LazyLock<String> = LazyLock::new(|| {
    let mut model: Model =
        serde_json::from_str(include_str!("model.json")).expect("the model is compiled in and its test reads it");
    model.laws = laws::families();
    model.parameters = laws::parameters();
    model.quantities = quantity::TABLE.iter().map(QuantityNote::from).collect();
    model.warnings = Caution::KINDS.iter().map(|kind| WarningNote::from(*kind)).collect();
    model.warnings.extend(warning::NOTES.iter().map(WarningNote::from));
    model.gravity = catalogue::gravity().to_vec();
    model.errata = ERRATA.iter().map(Erratum::from).collect();
    model.references = SOURCES.iter().map(|source| source.text.into()).collect();
    serde_json::to_string_pretty(&model).unwrap_or_default()
});

/// The equations as implemented, and the errata
///
/// For people and for programs: symbols, equations, methods, laws with their parameters, quantities of answers, what is refused, what is warned of,
/// gravity, and where the letter as printed is not what is computed.
#[utoipa::path(get, path = "/v1/model", tag = "catalogue", responses((status = 200, description = "The model", body = Model), InvalidQuery, Limits))]
pub(crate) async fn model(headers: HeaderMap, _: NoQuery) -> Response {
    static FIXED: LazyLock<Fixed> = LazyLock::new(|| Fixed::tagged(TEXT.as_str().into(), JSON));
    FIXED.answer(&headers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_description_is_complete() {
        let model: Model = serde_json::from_str(&TEXT).expect("the model is JSON");
        assert_eq!(model.errata.iter().map(|erratum| erratum.number).collect::<Vec<_>>(), (1..=13).collect::<Vec<_>>());
        let cited = model.equations.iter().flat_map(|equation| &equation.errata);
        assert!(cited.copied().all(|number| (1..=13).contains(&number)));
        for number in 1..=18 {
            // Every equation of the letter is among those computed, parts such as 10a under their number.
            let number = number.to_string();
            assert!(model.equations.iter().any(|equation| equation.letter.contains(&number)), "equation {number}");
        }
        let codes: Vec<&str> = model.warnings.iter().map(|warning| warning.code.as_str()).collect();
        let mut distinct: Vec<_> = model.warnings.iter().map(|warning| (&warning.code, &warning.meaning)).collect();
        distinct.sort_unstable();
        distinct.dedup();
        assert_eq!(distinct.len(), codes.len(), "each meaning of a code is listed once");
        let quantity = |name: &str| model.quantities.iter().find(|quantity| quantity.name == name);
        assert!(quantity("torque_n_m").is_some_and(|torque| torque.unit == "N.m" && torque.symbol == "T"));
        assert!(quantity("power_w").is_some_and(|power| power.operations == ["/v1/track"]));
    }

    /// The years that a text names, each with the name that stands last before it.
    fn cited(text: &str) -> Vec<(String, String)> {
        let (mut name, mut found) = (String::new(), Vec::new());
        for word in text.split(|c: char| !c.is_alphanumeric() && c != '-').filter(|word| !word.is_empty()) {
            let is_year = word.len() == 4 && (word.starts_with("19") || word.starts_with("20"));
            if is_year && word.bytes().all(|byte| byte.is_ascii_digit()) {
                found.push((name.clone(), word.to_owned()));
            } else if word.chars().next().is_some_and(char::is_uppercase) {
                word.clone_into(&mut name);
            }
        }
        found
    }

    #[test]
    fn every_paper_that_is_cited_is_among_the_references() {
        assert_eq!(cited("Bekker 1956, 1969; N_γ by Coduto 2001").len(), 3);
        let model: Model = serde_json::from_str(&TEXT).expect("the model is JSON");
        let of_equations = model.equations.iter().flat_map(|equation| [&equation.source, &equation.note]);
        let of_warnings = model.warnings.iter().map(|warning| &warning.source);
        let mut count = 0;
        for text in of_equations.chain(of_warnings).flatten() {
            for (name, year) in cited(text) {
                let listed = model.references.iter().any(|reference| reference.contains(&name) && reference.contains(&year));
                assert!(listed, "{name} {year} of `{text}`");
                count += 1;
            }
            for book in ["Theory of Ground Vehicles", "Terzaghi", "Akin"] {
                let listed = model.references.iter().any(|reference| reference.contains(book));
                assert!(!text.contains(book) || listed, "{book} of `{text}`");
            }
        }
        assert!(count > 30, "{count} citations");
    }
}
