//! The laws that a request may name, and the numbers that wheels, soils and laws have: the tables of the model as they are shown.

use serde::{Deserialize, Serialize};
use terramechanics::{
    AngleRatio, Braking, Declared, ExitRule, Fittable, Interface, JanosiHanamoto, Law, Parameter, Parametrised, PeakRule,
    PressureSinkage, ShearLaw, SlipSinkage, Soil, WheelParams,
};
use utoipa::ToSchema;

use crate::request::laws::follows;

/// Laws that can take each other's place.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct LawFamily {
    /// Their field in a request, as a JSON pointer.
    #[schema(example = "/soil/pressure_sinkage")]
    pointer: String,
    /// The field of a law that has its name; absent where the name alone is sent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "law")]
    tag: Option<String>,
    laws: Vec<LawNote>,
}

/// A law.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
struct LawNote {
    #[schema(example = "bekker")]
    name: String,
    meaning: String,
    formula: String,
    sources: Vec<String>,
    parameters: Vec<ParameterNote>,
}

/// A number of a request.
#[derive(Debug, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ParameterNote {
    #[schema(example = "k_phi")]
    name: String,
    /// Its field in a request, as a JSON pointer.
    #[schema(example = "/soil/pressure_sinkage/k_phi")]
    pointer: String,
    symbol: String,
    /// By UCUM, 1 for a ratio; some moduli have an exponent in it, such as N/m^(n+2).
    unit: String,
    meaning: String,
    /// The smallest value.
    minimum: f64,
    /// The largest value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    maximum: Option<f64>,
    /// The limit that a value stays below, in place of the largest one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    exclusive_maximum: Option<f64>,
    /// Whether it has to be there.
    required: bool,
    /// What holds where it is absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    default: Option<f64>,
    /// Whether /v1/identify can find it.
    fittable: bool,
}

impl ParameterNote {
    fn of(of: &Parameter, place: &str, fittable: &[Fittable]) -> Self {
        let bound = Some(of.most);
        // The modulus of the shear law that a request has without naming one stands in the soil itself.
        let place = if *of == JanosiHanamoto::MODULUS { "/soil" } else { place };
        Self {
            name: of.name.into(),
            pointer: format!("{place}/{}", of.name),
            symbol: of.symbol.into(),
            unit: of.unit.into(),
            meaning: of.meaning.into(),
            minimum: of.least,
            maximum: bound.filter(|_| !of.is_open_above()),
            exclusive_maximum: bound.filter(|_| of.is_open_above()),
            required: of.is_required() && !follows(of),
            default: of.default(),
            fittable: fittable.iter().any(|fittable| fittable.parameter.name == of.name),
        }
    }
}

fn family<F>(pointer: &str, tag: Option<&str>, laws: &[Law<F>], shared: &[Parameter]) -> LawFamily {
    let note = |law: &Law<F>| LawNote {
        name: law.name.into(),
        meaning: law.doc.into(),
        formula: law.formula.into(),
        sources: law.sources.iter().map(ToString::to_string).collect(),
        parameters: law.parameters.iter().chain(shared).map(|of| ParameterNote::of(of, pointer, law.fittable)).collect(),
    };
    LawFamily { pointer: pointer.into(), tag: tag.map(str::to_owned), laws: laws.iter().map(note).collect() }
}

/// All families of laws.
pub(super) fn families() -> Vec<LawFamily> {
    vec![
        family("/soil/pressure_sinkage", Some("law"), PressureSinkage::LAWS, &[]),
        family("/soil/shear", Some("law"), ShearLaw::LAWS, &[]),
        family("/contact", Some("rule"), PeakRule::LAWS, AngleRatio::PARAMETERS),
        exits(),
        family("/slip_sinkage", Some("law"), SlipSinkage::LAWS, &[]),
        family("/braking", None, Braking::LAWS, &[]),
    ]
}

/// The rules for the exit that stand in an object of their own.
fn exits() -> LawFamily {
    let of_ratio: Vec<&Law<ExitRule>> = ExitRule::LAWS.iter().filter(|law| law.name != AngleRatio::NAME).collect();
    let notes = of_ratio.into_iter().flat_map(|law| family("/contact/exit", None, std::slice::from_ref(law), &[]).laws);
    LawFamily { pointer: "/contact/exit".into(), tag: None, laws: notes.collect() }
}

/// The numbers of a wheel, those of a soil that are no law's, and those of an interface between the two.
pub(super) fn parameters() -> Vec<ParameterNote> {
    let wheel = WheelParams::PARAMETERS.iter().map(|of| ParameterNote::of(of, "/wheel", &[]));
    let soil = Soil::PARAMETERS.iter().map(|of| ParameterNote::of(of, "/soil", Soil::FITTABLE));
    // A fit finds them under names of their own.
    let interface = Interface::PARAMETERS.iter().map(|of| ParameterNote::of(of, "/contact/interface", &[]));
    wheel.chain(soil).chain(interface).collect()
}
