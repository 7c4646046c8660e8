//! The laws and rules that a request may name: the model's own tables, as fields of a request and forms of the contract.

use std::borrow::Cow;
use std::sync::LazyLock;

use terramechanics::{Declared, JanosiHanamoto, Law, Parameter, PressureSinkage, Reece, ShearLaw, SlipSinkage};
use terramechanics_reading::{Chosen, Field, Number, Tagged, Variant};

/// What may be sent for a parameter of the model, if something is.
pub(crate) const fn number(parameter: &Parameter) -> Number {
    let number = Number::new(parameter.unit, parameter.least, parameter.most);
    if parameter.is_open_above() { number.open_above() } else { number }
}

/// The same, with the parameter's default.
pub(crate) const fn number_or_default(parameter: &Parameter) -> Number {
    match parameter.default() {
        Some(default) => number(parameter).or(default),
        None => number(parameter),
    }
}

/// The field of a parameter that may be absent from a request.
pub(crate) const fn field(parameter: &Parameter, meaning: &'static str) -> Field<Number> {
    Field::new(parameter.name, meaning, number(parameter))
}

/// The same, which means what the model says of it.
pub(super) const fn own_field(parameter: &Parameter) -> Field<Number> {
    Field::new(parameter.name, parameter.meaning, number(parameter).symbol(parameter.symbol))
}

/// The same, with the parameter's default.
pub(crate) const fn field_or_default(parameter: &Parameter, meaning: &'static str) -> Field<Number> {
    Field::new(parameter.name, meaning, number_or_default(parameter))
}

/// A text that is made once and kept for good.
fn kept(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

/// Whether a parameter of a law follows from fields of the soil where the law has none of its own: its weight does.
pub(crate) fn follows(parameter: &Parameter) -> bool {
    *parameter == Reece::UNIT_WEIGHT
}

/// The field of a parameter as the model declares it.
fn declared(parameter: &'static Parameter) -> Field<Number> {
    let kind = number_or_default(parameter).symbol(parameter.symbol);
    let kind = if follows(parameter) { kind.may_follow() } else { kind };
    Field { kind, required: parameter.is_required(), ..own_field(parameter) }
}

/// The forms of a family, whose laws have these parameters in a request.
pub(super) fn variants<F>(laws: &'static [Law<F>], parameters: impl Fn(&Law<F>) -> Vec<&'static Parameter>) -> Vec<Variant> {
    let variant = |law: &'static Law<F>| Variant {
        name: law.name,
        doc: kept(format!("{} {}.", law.doc, law.formula)),
        fields: Cow::Owned(parameters(law).into_iter().map(declared).collect()),
    };
    laws.iter().map(variant).collect()
}

/// The law that a request chose.
pub(super) fn chosen<F>(laws: &'static [Law<F>], index: usize, values: &[Option<f64>]) -> Option<F> {
    laws.get(index)?.from_values(values).ok()
}

/// The pressure–sinkage law of a request.
pub(crate) const PRESSURE_SINKAGE: Tagged = Tagged {
    name: "PressureSinkage",
    doc: "A pressure–sinkage law σ = K_s z^N with N = n0 + n1 s, or n0 − n2 s at negative slip where n2 is given.",
    tag: "law",
    meaning: "Name of the law.",
    suffix: "Law",
    variants: || {
        static VARIANTS: LazyLock<Vec<Variant>> =
            LazyLock::new(|| variants(PressureSinkage::LAWS, |law| law.parameters.iter().collect()));
        &VARIANTS
    },
    also: &[],
    without_word: Some(
        "Single values of the preset's law, in place of its own; the law and its other values stay. Without a preset that has a law, `law` is required, save for the exponent (`n0`, `n1`, `n2`) alone under a load that is known beside the sinkage: the load takes the place of the moduli.",
    ),
};

pub(crate) fn pressure_sinkage(Chosen { index, values }: &Chosen) -> Option<PressureSinkage> {
    chosen(PressureSinkage::LAWS, *index, values)
}

/// The shear law of a request. The parameter of Janosi–Hanamoto's is a field of the soil.
pub(crate) const SHEAR: Tagged = Tagged {
    name: "Shear",
    doc: "How shear strength builds up with displacement: to the full strength and no further (Janosi–Hanamoto, with the soil's shear_modulus_m), over a hump to a residual, or over a peak to nothing (Wong).",
    tag: "law",
    meaning: "Name of the law.",
    suffix: "Shear",
    variants: || {
        static VARIANTS: LazyLock<Vec<Variant>> = LazyLock::new(|| {
            variants(ShearLaw::LAWS, |law| if is_of_soil(law) { Vec::new() } else { law.parameters.iter().collect() })
        });
        &VARIANTS
    },
    also: &[],
    without_word: Some(
        "Single values of the preset's law, in place of its own; the law and its other values stay. Without a preset, `law` is required.",
    ),
};

/// Whether the parameter of the law is a field of the soil.
fn is_of_soil(law: &Law<ShearLaw>) -> bool {
    law.name == JanosiHanamoto::NAME
}

/// The shear law, or none for the one whose parameter is a field of the soil; nothing where there is no such law.
pub(crate) fn shear(Chosen { index, values }: &Chosen) -> Option<Option<ShearLaw>> {
    if ShearLaw::LAWS.get(*index).is_some_and(is_of_soil) {
        return Some(None);
    }
    chosen(ShearLaw::LAWS, *index, values).map(Some)
}

/// The slip–sinkage law of a request.
pub(crate) const SLIP_SINKAGE: Tagged = Tagged {
    name: "SlipSinkage",
    doc: "How the sinkage follows from the static one: lyasko, z = z0 (1 + s)/(1 − s/2); linear, z = z0 (1 + S s), and z0 (1 − S_b s) at negative slip where S_b is given.",
    tag: "law",
    meaning: "Name of the law.",
    suffix: "SlipSinkage",
    variants: || {
        static VARIANTS: LazyLock<Vec<Variant>> =
            LazyLock::new(|| variants(SlipSinkage::LAWS, |law| law.parameters.iter().collect()));
        &VARIANTS
    },
    also: &[],
    without_word: None,
};

pub(crate) fn slip_sinkage(Chosen { index, values }: &Chosen) -> Option<SlipSinkage> {
    chosen(SlipSinkage::LAWS, *index, values)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every row of the model's tables can be chosen, and what is chosen is that law.
    #[test]
    fn every_law_of_the_model_can_be_chosen() {
        let values = |variant: &Variant| variant.fields.iter().map(|field| field.kind.default_value().or(Some(0.5))).collect();
        let all = |tagged: &Tagged, made: &dyn Fn(&Chosen) -> Option<&'static str>| {
            for (index, variant) in (tagged.variants)().iter().enumerate() {
                assert_eq!(made(&Chosen { index, values: values(variant) }), Some(variant.name));
            }
        };
        all(&PRESSURE_SINKAGE, &|chosen| Some(pressure_sinkage(chosen)?.law().name));
        all(&SHEAR, &|chosen| Some(shear(chosen)?.map_or(JanosiHanamoto::NAME, |law| law.law().name)));
        all(&SLIP_SINKAGE, &|chosen| Some(slip_sinkage(chosen)?.law().name));
    }
}
