//! Numbers, names and reasons in words, for the sentences of warnings.

use std::borrow::Cow;

use terramechanics::{
    Error, Fault, JanosiHanamoto, Nearest, Parameter, Parametrised, PressureSinkage, Soil, WheelOnSoil, WheelParams,
};

use super::Measure;
use super::figure::Figure;
use crate::quantity::number;

/// Names in a row: `a`, `a and b`, `a, b and c`.
pub(crate) fn listed<T: AsRef<str>>(names: &[T]) -> String {
    match names {
        [] => String::new(),
        [one] => one.as_ref().to_owned(),
        [others @ .., last] => {
            format!("{} and {}", others.iter().map(AsRef::as_ref).collect::<Vec<_>>().join(", "), last.as_ref())
        }
    }
}

/// Names of fields in a row, each in backticks.
pub(super) fn quoted(names: &[&str]) -> String {
    listed(&names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>())
}

/// The first of many names, each in backticks, and how many more there are.
pub(super) fn listed_in_short(names: &[String]) -> String {
    const MOST: usize = 12;
    let (first, rest) = names.split_at(names.len().min(MOST));
    let mut told: Vec<String> = first.iter().map(|name| format!("`{name}`")).collect();
    if !rest.is_empty() {
        told.push(format!("{} more", rest.len()));
    }
    listed(&told)
}

/// Which wheels are so to those in whose ruts they run: the verb for one and for several.
pub(super) fn in_ruts(stations: &[(usize, usize)], [one, several]: [&str; 2]) -> String {
    match stations {
        [(station, before)] => format!("the wheel of station {station} {one} that of station {before}, in whose rut it runs"),
        _ => {
            let own: Vec<String> = stations.iter().map(|(station, _)| station.to_string()).collect();
            let ahead: Vec<String> = stations.iter().map(|(_, before)| before.to_string()).collect();
            let (own, ahead) = (listed(&own), listed(&ahead));
            format!("the wheels of stations {own} {several} those of stations {ahead}, in whose ruts they run")
        }
    }
}

/// Names as a warning carries them.
pub(super) fn told_names<T: Into<Cow<'static, str>>>(names: Vec<T>) -> Vec<Cow<'static, str>> {
    names.into_iter().map(Into::into).collect()
}

/// A count with its noun: `1 row`, `2 rows`.
pub(crate) fn counted(count: u64, one: &str, several: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {several}") }
}

/// The text with a capital first letter, unless it begins with a symbol or the name of a field.
pub(super) fn capitalised(text: &str) -> String {
    let first = text.split(' ').next().unwrap_or_default();
    let is_word = first == "a" || (first.len() > 1 && first.bytes().all(|byte| byte.is_ascii_lowercase()));
    if !is_word {
        return text.to_owned();
    }
    text[..1].to_ascii_uppercase() + &text[1..]
}

/// The text as it continues after a colon.
pub(super) fn behind_colon(text: &str) -> String {
    let has_article = ["The ", "A "].iter().any(|article| text.starts_with(article));
    if has_article { text[..1].to_lowercase() + &text[1..] } else { text.to_owned() }
}

/// Why there is no solution.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Reason {
    /// The model has none.
    Model(Error),
    /// The request is none.
    Request(String),
}

impl Reason {
    /// The value that the model refuses, with the range that it has to be in.
    pub(super) fn measure(&self) -> Option<Measure> {
        let Self::Model(error) = self else { return None };
        let of = |quantity: &str, value: f64, unit: &'static str, lower: Option<f64>, upper: Option<f64>| {
            Some(Measure::of(quantity, value).in_unit(unit).beyond(lower, upper, "the model at this point"))
        };
        match *error {
            Error::SinkageOutsideWheel { sinkage, radius } => of("sinkage", sinkage, "m", Some(0.0), Some(radius)),
            Error::PeakOutsideContact { entry, peak, exit } => {
                of("angle of maximum stress", peak, "rad", Some(exit), Some(entry))
            }
            Error::ReversalOutsideContact { entry, reversal, exit } => {
                of("angle at which the two zones meet", reversal, "rad", Some(exit), Some(entry))
            }
            Error::ModulusNotPositive { modulus } => of("sinkage modulus", modulus, "Pa/m^N", Some(0.0), None),
            Error::ExponentNotPositive { exponent } => of("sinkage exponent", exponent, "1", Some(0.0), None),
            Error::LoadBeyondCapacity { load, largest, .. } => of("load", load, "N", None, Some(largest)),
            Error::LoadTooLight { load, least, .. } => of("load", load, "N", Some(least), None),
            Error::InterfaceBeyondSoil { parameter, value, soil } => of(parameter.name, value, parameter.unit, None, Some(soil)),
            Error::PullOutOfReach { pull, reached, nearest, .. } => {
                let bound = |is_bound: bool| is_bound.then_some(reached);
                let (least, largest) = (bound(nearest == Nearest::Least), bound(nearest == Nearest::Largest));
                of(pull.parameter().name, pull.value(), pull.parameter().unit, least, largest)
            }
            Error::LoadBelowCohesion { load, carries } => of("load", load, "N", Some(carries), None),
            Error::Invalid(_)
            | Error::OppositeRotation { .. }
            | Error::ClosedFormOfTwoZones
            | Error::SlipAngleOfTwoZones
            | Error::NotFreeRolling { .. }
            | Error::LoadNotBalanced { .. }
            | Error::LoadNotCoupled { .. }
            | Error::MissingLaw(_)
            | Error::NotFinite => None,
        }
    }

    /// The sinkage that goes with a load that the model refuses.
    pub(super) fn figure(&self) -> Option<Figure> {
        match *self {
            Self::Model(Error::LoadBeyondCapacity { sinkage, .. } | Error::LoadTooLight { sinkage, .. }) => {
                Some(Figure::of("sinkage", sinkage, "m"))
            }
            _ => None,
        }
    }

    pub(super) fn in_words(&self) -> String {
        match self {
            Self::Model(Error::Invalid(Fault { parameter, value })) => {
                format!("`{}` {}, not {}", parameter.name, parameter.requirement, number(*value))
            }
            Self::Model(error) => error.to_string(),
            Self::Request(told) => told.clone(),
        }
    }
}

/// The field of a request that stands for an input of the model, where it is the same in all requests.
pub(super) fn pointer_of(parameter: &Parameter) -> Option<String> {
    let name = parameter.name;
    if *parameter == WheelOnSoil::STATIC_SINKAGE {
        return Some(format!("/{name}"));
    }
    let is_of_law = || PressureSinkage::LAWS.iter().any(|law| law.parameters.contains(parameter));
    let place = match parameter {
        of_wheel if WheelParams::PARAMETERS.contains(of_wheel) => "/wheel",
        of_soil if Soil::PARAMETERS.contains(of_soil) || *of_soil == JanosiHanamoto::MODULUS => "/soil",
        _ if is_of_law() => "/soil/pressure_sinkage",
        // The others are at different places in different requests, or are no fields.
        _ => return None,
    };
    Some(format!("{place}/{name}"))
}

#[cfg(test)]
mod tests {
    use terramechanics::Slip;

    use super::*;

    #[test]
    fn an_input_is_named_in_words() {
        let error = Slip::new(3.0).expect_err("no slip");
        assert_eq!(Reason::Model(error).in_words(), "`slip` must be from -1 to 1, not 3");
    }

    #[test]
    fn an_input_is_found_in_a_request() {
        for (parameter, pointer) in [
            (Soil::UNIT_WEIGHT, Some("/soil/unit_weight_n_m3")),
            (JanosiHanamoto::MODULUS, Some("/soil/shear_modulus_m")),
            (terramechanics::Bekker::K_C, Some("/soil/pressure_sinkage/k_c")),
            (terramechanics::SinkageExponent::SLIP_GAIN, Some("/soil/pressure_sinkage/n1")),
            (WheelOnSoil::STATIC_SINKAGE, Some("/static_sinkage_m")),
            (Slip::RATIO, None),
        ] {
            assert_eq!(pointer_of(&parameter).as_deref(), pointer);
        }
    }

    #[test]
    fn names_are_listed_as_in_english() {
        assert_eq!(listed(&["a", "b", "c"]), "a, b and c");
        assert_eq!((listed(&["a", "b"]), listed(&["a"]), listed::<&str>(&[])), ("a and b".into(), "a".into(), String::new()));
        assert_eq!((counted(1, "row", "rows"), counted(2, "row", "rows")), ("1 row".into(), "2 rows".into()));
    }

    #[test]
    fn a_sentence_goes_on_behind_a_colon() {
        assert_eq!(behind_colon("The soil is wet."), "the soil is wet.");
        assert_eq!(behind_colon("Bekker's law holds."), "Bekker's law holds.");
        assert_eq!(
            ["the soil", "a wheel", "k_s is", "k of", "`n0` is"].map(capitalised),
            ["The soil", "A wheel", "k_s is", "k of", "`n0` is"]
        );
    }
}
