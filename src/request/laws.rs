//! The laws and rules that a request may name, each declared once: its word, its parameters, and what is made of them.
//!
//! From a row come the fields of the request with their checks, the form in the contract, and the law of a catalogue's record.

use std::borrow::Cow;
use std::sync::LazyLock;

use terramechanics::{
    Bekker, ContactParams, Diameter, Direct, LinearSlipSinkage, PeakRule, PressureSinkage, Reece, ShearLaw, SinkageExponent,
    SlipSinkage, WongPeak, WongResidual,
};
use terramechanics_reading::{Chosen, Field, Number, Tagged, Variant};

/// A law of the family `F`, before it has values.
pub(crate) struct Law<F: 'static> {
    pub(crate) name: &'static str,
    /// What it says.
    doc: &'static str,
    /// Its parameters.
    pub(crate) parameters: &'static [Field<Number>],
    make: fn(&[Option<f64>]) -> Option<F>,
}

impl<F> Law<F> {
    /// The law of that name.
    pub(crate) fn named(laws: &'static [Self], name: &str) -> Option<&'static Self> {
        laws.iter().find(|law| law.name == name)
    }

    /// The names of its parameters.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'static str> + use<F> {
        self.parameters.iter().map(|parameter| parameter.name)
    }

    /// The law with values that are found by the name of their parameter; none where one that is required has none.
    pub(crate) fn from_named(&self, value: impl Fn(&str) -> Option<f64>) -> Option<F> {
        let value = |field: &Field<Number>| value(field.name).or(field.kind.default_value());
        (self.make)(&self.parameters.iter().map(value).collect::<Vec<_>>())
    }

    /// The law that a request chose.
    pub(super) fn chosen(laws: &'static [Self], Chosen { index, values }: &Chosen) -> Option<F> {
        laws.get(*index).and_then(|law| (law.make)(values))
    }

    fn variants(laws: &'static [Self]) -> Vec<Variant> {
        let variant = |law: &'static Self| Variant { name: law.name, doc: law.doc, fields: Cow::Borrowed(law.parameters) };
        laws.iter().map(variant).collect()
    }
}

// UCUM has no powers that vary. Such a unit stands in braces, where UCUM allows any text, which counts as 1.
pub(super) const K_S: Field<Number> =
    Field::required("k_s", "Sinkage modulus K_s (Pa/m^N).", Number::new("{Pa/m^N}", 1e-6, 1e15));
const K_C: Number = Number::new("{N/m^(n+1)}", -1e9, 1e9);
const K_PHI: Number = Number::new("{N/m^(n+2)}", -1e9, 1e12);
pub(super) const BEKKERS_K_C: Field<Number> =
    Field::required("k_c", "Bekker's cohesive modulus k_c (N/m^(n+1)), may be negative.", K_C);
pub(super) const BEKKERS_K_PHI: Field<Number> = Field::required("k_phi", "Bekker's frictional modulus k_phi (N/m^(n+2)).", K_PHI);
const REECES_K_C: Field<Number> = Field::required("k_c", "Reece's cohesive modulus k_c' (–).", Number::new("1", -1e9, 1e9));
const REECES_K_PHI: Field<Number> =
    Field::required("k_phi", "Reece's frictional modulus k_phi' (–).", Number::new("1", -1e9, 1e12));
const UNIT_WEIGHT: Field<Number> = Field::required("unit_weight_n_m3", "Unit weight γ (N/m³).", Number::new("N/m3", 0.0, 1e6));
const K: Field<Number> =
    Field::required("k", "Coefficient k of Meirion-Griffith & Spenko (N/m^(n+m+2)).", Number::new("{N/m^(n+m+2)}", 1e-6, 1e15));
const M: Field<Number> = Field::required("m", "Exponent m of the wheel's diameter (–).", Number::new("1", -10.0, 10.0));
pub(super) const N0: Field<Number> = Field::required("n0", "Sinkage exponent without slip (–).", Number::new("1", 1e-3, 10.0));
pub(super) const N1: Field<Number> =
    Field::new("n1", "Gain of the exponent with slip (–).", Number::new("1", -10.0, 10.0).or(0.0));
const N2: Field<Number> = Field::new(
    "n2",
    "Gain of the exponent with skid (–): N = n0 − n2 s at s < 0; n1 holds there too unless given.",
    Number::new("1", -10.0, 10.0),
);

fn exponent(base: Option<f64>, slip_gain: Option<f64>, skid_gain: Option<f64>) -> Option<SinkageExponent> {
    Some(SinkageExponent { base: base?, slip_gain: slip_gain?, skid_gain })
}

/// The pressure–sinkage laws.
pub(crate) const PRESSURE_SINKAGE: &[Law<PressureSinkage>] = &[
    Law {
        name: "bekker",
        doc: "K_s = k_c/b + k_phi (Bekker 1956, 1969).",
        parameters: &[BEKKERS_K_C, BEKKERS_K_PHI, N0, N1, N2],
        make: |values| {
            let &[k_c, k_phi, n0, n1, n2] = values else { return None };
            Some(PressureSinkage::Bekker(Bekker { k_c: k_c?, k_phi: k_phi?, exponent: exponent(n0, n1, n2)? }))
        },
    },
    Law {
        name: "direct",
        doc: "K_s as it is.",
        parameters: &[K_S, N0, N1, N2],
        make: |values| {
            let &[k_s, n0, n1, n2] = values else { return None };
            Some(PressureSinkage::Direct(Direct { k_s: k_s?, exponent: exponent(n0, n1, n2)? }))
        },
    },
    Law {
        name: "reece",
        doc: "K_s = (c k_c' + γ b k_phi')/b^N (Reece 1965).",
        parameters: &[REECES_K_C, REECES_K_PHI, UNIT_WEIGHT, N0, N1, N2],
        make: |values| {
            let &[k_c, k_phi, unit_weight, n0, n1, n2] = values else { return None };
            let exponent = exponent(n0, n1, n2)?;
            Some(PressureSinkage::Reece(Reece { k_c: k_c?, k_phi: k_phi?, unit_weight: unit_weight?, exponent }))
        },
    },
    Law {
        name: "diameter",
        doc: "K_s = k (2r)^m (Meirion-Griffith & Spenko 2011).",
        parameters: &[K, M, N0, N1, N2],
        make: |values| {
            let &[k, m, n0, n1, n2] = values else { return None };
            Some(PressureSinkage::Diameter(Diameter { k: k?, m: m?, exponent: exponent(n0, n1, n2)? }))
        },
    },
];

const RESIDUAL_RATIO: Field<Number> =
    Field::required("residual_ratio", "Residual over largest strength K_r (–).", Number::new("1", 1e-3, 1.0));
const PEAK_DISPLACEMENT: Field<Number> =
    Field::required("peak_displacement_m", "Shear displacement K_w at the largest strength (m).", Number::new("m", 1e-6, 10.0));

/// The shear laws; none stands for Janosi–Hanamoto's, whose parameter is the soil's `shear_modulus_m`.
pub(crate) const SHEAR: &[Law<Option<ShearLaw>>] = &[
    Law {
        name: "janosi_hanamoto",
        doc: "To the full strength and no further; takes the soil's shear_modulus_m.",
        parameters: &[],
        make: |_| Some(None),
    },
    Law {
        name: "wong_residual",
        doc: "Over a hump to a residual strength.",
        parameters: &[RESIDUAL_RATIO, PEAK_DISPLACEMENT],
        make: |values| {
            let &[residual_ratio, peak_displacement] = values else { return None };
            let law = WongResidual { residual_ratio: residual_ratio?, peak_displacement: peak_displacement? };
            Some(Some(ShearLaw::WongResidual(law)))
        },
    },
    Law {
        name: "wong_peak",
        doc: "Over a peak to nothing.",
        parameters: &[PEAK_DISPLACEMENT],
        make: |values| {
            let &[peak_displacement] = values else { return None };
            Some(Some(ShearLaw::WongPeak(WongPeak { peak_displacement: peak_displacement? })))
        },
    },
];

const GAIN: Field<Number> = Field::required("gain", "S of the linear law (–).", Number::new("1", 0.0, 100.0));

/// The slip–sinkage laws.
pub(super) const SLIP_SINKAGE: &[Law<SlipSinkage>] = &[
    Law { name: "lyasko", doc: "z = z0 (1 + s)/(1 − s/2).", parameters: &[], make: |_| Some(SlipSinkage::Lyasko) },
    Law {
        name: "linear",
        doc: "z = z0 (1 + S s).",
        parameters: &[GAIN],
        make: |values| {
            let &[gain] = values else { return None };
            Some(SlipSinkage::Linear(LinearSlipSinkage { gain: gain? }))
        },
    },
];

pub(super) const C1: Field<Number> = Field::required("c1", "c1 of θm = (c1 + c2 s) θ1 (–).", Number::new("1", -1.0, 2.0));
pub(super) const C2: Field<Number> = Field::required("c2", "c2 of θm = (c1 + c2 s) θ1 (–).", Number::new("1", -2.0, 2.0));
const C3: Field<Number> = Field::new(
    "c3",
    "c3 of θ2 = c3 θ1 (–); negative where the contact reaches behind the lowest point.",
    Number::new("1", -1.0, 0.6).or(0.0),
);

/// The rules for the angle of maximum stress, each with the end of the contact.
pub(crate) const RULES: &[Law<ContactParams>] = &[
    Law { name: "midpoint", doc: "θm = (θ1 + θ2)/2.", parameters: &[C3], make: |values| contact(PeakRule::Midpoint, values) },
    Law {
        name: "wong_reece",
        doc: "θm = (c1 + c2 s) θ1 (Wong & Reece 1967).",
        parameters: &[C1, C2, C3],
        make: |values| {
            let (&[c1, c2], end) = values.split_first_chunk()?;
            contact(PeakRule::WongReece { c1: c1?, c2: c2? }, end)
        },
    },
    Law {
        name: "half_sinkage",
        doc: "θm = arccos(1 − z/(2r)).",
        parameters: &[C3],
        make: |values| contact(PeakRule::HalfSinkage, values),
    },
];

fn contact(rule: PeakRule, end: &[Option<f64>]) -> Option<ContactParams> {
    let &[exit_ratio] = end else { return None };
    Some(ContactParams { rule, exit_ratio: exit_ratio? })
}

/// The pressure–sinkage law of a request.
pub(super) const PRESSURE_SINKAGE_OBJECT: Tagged = Tagged {
    name: "PressureSinkage",
    doc: "A pressure–sinkage law σ = K_s z^N with N = n0 + n1 s, or n0 − n2 s at negative slip where n2 is given.",
    tag: "law",
    meaning: "Name of the law.",
    suffix: "Law",
    variants: || {
        static VARIANTS: LazyLock<Vec<Variant>> = LazyLock::new(|| Law::variants(PRESSURE_SINKAGE));
        &VARIANTS
    },
};

/// The shear law of a request.
pub(super) const SHEAR_OBJECT: Tagged = Tagged {
    name: "Shear",
    doc: "How shear strength builds up with displacement: to the full strength and no further (Janosi–Hanamoto), over a hump to a residual, or over a peak to nothing (Wong).",
    tag: "law",
    meaning: "Name of the law.",
    suffix: "Shear",
    variants: || {
        static VARIANTS: LazyLock<Vec<Variant>> = LazyLock::new(|| Law::variants(SHEAR));
        &VARIANTS
    },
};

/// The slip–sinkage law of a request.
pub(super) const SLIP_SINKAGE_OBJECT: Tagged = Tagged {
    name: "SlipSinkage",
    doc: "How the sinkage follows from the static one: lyasko, z = z0 (1 + s)/(1 − s/2); linear, z = z0 (1 + S s).",
    tag: "law",
    meaning: "Name of the law.",
    suffix: "SlipSinkage",
    variants: || {
        static VARIANTS: LazyLock<Vec<Variant>> = LazyLock::new(|| Law::variants(SLIP_SINKAGE));
        &VARIANTS
    },
};

/// The contact of a request.
pub(super) const CONTACT_OBJECT: Tagged = Tagged {
    name: "Contact",
    doc: "Where the stresses are largest and where the contact ends: θm by the rule, θ2 = c3 θ1.",
    tag: "rule",
    meaning: "midpoint: θm = (θ1 + θ2)/2; wong_reece: θm = (c1 + c2 s) θ1; half_sinkage: θm = arccos(1 − z/(2r)).",
    suffix: "Contact",
    variants: || {
        static VARIANTS: LazyLock<Vec<Variant>> = LazyLock::new(|| Law::variants(RULES));
        &VARIANTS
    },
};
