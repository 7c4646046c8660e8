//! The method, and what it takes: constants of the closed forms, the stresses, laws of a braking wheel.

use terramechanics::{Braking, Contact, Error, Lambda, Method, NormalStressRadius, PeakDepth};
use terramechanics_reading::{Alternative, Defaulting, Either, Faults, Field, Group, Number, OneOf, Reader, Scope, Word, Words};

use super::laws::number;
use super::soil::Needs;
use crate::words::HINTS;

/// A method without its constants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MethodName {
    Quadrature,
    Linearised,
    Explicit,
    ResistiveForce,
}

pub(crate) const METHODS: Word<MethodName> = Word::new(&[
    ("quadrature", MethodName::Quadrature),
    ("linearised", MethodName::Linearised),
    ("explicit", MethodName::Explicit),
    ("resistive_force", MethodName::ResistiveForce),
]);
/// How many of them, from the first, are the letter's own.
pub(crate) const LETTER_METHODS: usize = 3;
pub(crate) const METHOD_FIELD: Field<Word<MethodName>> = Field::new(
    "method",
    "quadrature: the integral of the stresses; linearised: linear stresses, closed form; explicit: the letter's formulas; resistive_force: the stresses of dry grains (Li et al. 2013), which need friction_angle_rad and bulk_density_kg_m3 (or granular_stiffness_n_m3) of the soil and nothing else.",
    METHODS.or(MethodName::Quadrature),
);
/// The method of a fit.
pub(crate) const METHOD_OF_FIT: Field<Word<MethodName>> = Field::new(
    METHOD_FIELD.name,
    "quadrature: the integral of the stresses; linearised: linear stresses, closed form; explicit: the letter's formulas; resistive_force: the stresses of dry grains, of which `granular_stiffness_n_m3` or, beside a density, `friction_angle_rad` can be fitted.",
    METHODS.or(MethodName::Quadrature),
);
/// The method of what is found by integrals alone.
pub(crate) const METHOD_OF_INTEGRALS: Field<Word<MethodName>> = Field::new(
    METHOD_FIELD.name,
    "quadrature: the stresses by the laws of the soil; resistive_force: the stresses of dry grains (Li et al. 2013), which need friction_angle_rad and bulk_density_kg_m3 (or granular_stiffness_n_m3) of the soil and nothing else.",
    Word::new(&[("quadrature", MethodName::Quadrature), ("resistive_force", MethodName::ResistiveForce)])
        .or(MethodName::Quadrature),
);
pub(crate) const NORMAL_STRESS_RADIUS: Field<Word<NormalStressRadius>> = Field::new(
    "normal_stress_radius",
    "Radius at which the normal stress acts: the rim r, or the shearing radius r_s.",
    Word::new(&[("rim", NormalStressRadius::Rim), ("shearing", NormalStressRadius::Shearing)]).or(NormalStressRadius::Rim),
);
pub(crate) const PEAK_SINKAGE: Field<Word<PeakDepth>> = Field::new(
    "peak_sinkage",
    "Depth under the peak in the closed forms: geometric (default when linearised) or half of the sinkage (default when explicit).",
    Word::new(&[("geometric", PeakDepth::Geometric), ("half", PeakDepth::Half)]),
);
pub(crate) const BRAKING_FIELD: Field<Word<Braking>> = Field::new(
    "braking",
    "Law for a braking wheel, s < 0. one_zone: the displacement of a driving wheel continued; two_zone: Wong & Reece's towed wheel, whose shear reverses at the peak of the stresses; quadrature only, with a jump in the forces at s = 0.",
    BRAKING_LAWS.or(Braking::OneZone),
);
pub(crate) const BRAKING_LAWS: Word<Braking> = Word::new(&[("one_zone", Braking::OneZone), ("two_zone", Braking::TwoZone)]);
/// λ of the explicit method.
pub(crate) const LAMBDA: Number = number(&Lambda::A);
const LAMBDA_OR_EXACT: OneOf = OneOf {
    default: Lambda::A.default(),
    ..OneOf::new(
        "a number or \"exact\"",
        &[Alternative::Number(LAMBDA), Alternative::Word("exact", "The value at which the approximation is exact.")],
    )
};
pub(crate) const LAMBDA_A: Field<OneOf> = Field::new(Lambda::A.name, "λ_A of A ≈ (1 − λ_A) √(z/2r) (–).", LAMBDA_OR_EXACT);
pub(crate) const LAMBDA_B: Field<OneOf> = Field::new(Lambda::B.name, "λ_B of B ≈ (1 + λ_B) z/(2r) (–).", LAMBDA_OR_EXACT);

pub(crate) const LAMBDAS: Group = &[&LAMBDA_A, &LAMBDA_B];
pub(crate) const METHOD: Group = &[&METHOD_FIELD];
pub(crate) const INTEGRALS: Group = &[&METHOD_OF_INTEGRALS];
pub(crate) const STRESSES: Group = &[&NORMAL_STRESS_RADIUS, &PEAK_SINKAGE];
pub(crate) const BRAKING: Group = &[&BRAKING_FIELD];

/// How the closed forms are made.
#[derive(Clone, Copy)]
pub(crate) struct ClosedForms {
    /// The depth under the peak, where one was asked for.
    peak_depth: Option<PeakDepth>,
    lambda_a: Lambda,
    lambda_b: Lambda,
}

impl ClosedForms {
    /// With the constants that were sent; what cannot be one is reported and stands for 0.
    pub(crate) fn read(object: &Reader<'_>, peak_depth: Option<PeakDepth>) -> Self {
        let lambda = |field| match object.optional(field).flatten() {
            Some(Either::Number(value)) => Lambda::Given(value),
            Some(Either::Word) => Lambda::Exact,
            _ => Lambda::Given(0.0),
        };
        Self { peak_depth, lambda_a: lambda(&LAMBDA_A), lambda_b: lambda(&LAMBDA_B) }
    }

    /// The method of that name.
    pub(crate) fn method(&self, name: MethodName) -> Method {
        let Self { peak_depth, lambda_a, lambda_b } = *self;
        match name {
            MethodName::Quadrature => Method::Quadrature,
            MethodName::Linearised => Method::Linearised { peak_depth: peak_depth.unwrap_or(PeakDepth::Geometric) },
            MethodName::Explicit => Method::Explicit { peak_depth: peak_depth.unwrap_or(PeakDepth::Half), lambda_a, lambda_b },
            MethodName::ResistiveForce => Method::ResistiveForce,
        }
    }
}

impl MethodName {
    /// What it needs of a soil.
    fn needs(self) -> Needs<'static> {
        match self {
            Self::Quadrature | Self::Linearised | Self::Explicit => Needs::ALL,
            Self::ResistiveForce => Needs::GRAINS,
        }
    }
}

/// What is sent for a field or holds without; what is wrong with it is reported where it is read.
fn peek<'a, K: Defaulting>(
    object: &Reader<'a>,
    field: &Field<K>,
    then: impl FnOnce(Option<K::Value<'_>>) -> Needs<'static>,
) -> Needs<'static> {
    let faults = Faults::new(&HINTS);
    then(object.at(Scope::root(&faults)).or_default(field))
}

/// What the method of a request needs of the soil.
pub(crate) fn needs(object: &Reader<'_>) -> Needs<'static> {
    peek(object, &METHOD_FIELD, |method| method.unwrap_or(MethodName::Quadrature).needs())
}

/// What the methods of a list need of the soil together.
pub(crate) fn needs_of_all(object: &Reader<'_>, field: &Field<Words<MethodName>>) -> Needs<'static> {
    peek(object, field, |methods| methods.into_iter().flatten().map(MethodName::needs).reduce(Needs::and).unwrap_or(Needs::ALL))
}

/// The method, of a request that has one.
pub(crate) fn read(object: &Reader<'_>, peak_depth: Option<PeakDepth>) -> Option<Method> {
    let closed_forms = ClosedForms::read(object, peak_depth);
    let name = object.or_default(&METHOD_FIELD)?;
    Some(closed_forms.method(name))
}

/// The method of a request; what is wrong with it is reported where it is read.
pub(crate) fn peeked(object: &Reader<'_>) -> Option<Method> {
    let faults = Faults::new(&HINTS);
    read(&object.at(Scope::root(&faults)), None)
}

/// The method, of a request that has one of integrals.
pub(crate) fn read_integral(object: &Reader<'_>) -> Option<Method> {
    object.or_default(&METHOD_OF_INTEGRALS).map(|name| match name {
        MethodName::ResistiveForce => Method::ResistiveForce,
        MethodName::Quadrature | MethodName::Linearised | MethodName::Explicit => Method::Quadrature,
    })
}

/// The method of a fit.
pub(crate) fn read_fitted(object: &Reader<'_>, peak_depth: Option<PeakDepth>) -> Option<Method> {
    let closed_forms = ClosedForms::read(object, peak_depth);
    object.or_default(&METHOD_OF_FIT).map(|name| closed_forms.method(name))
}

/// Reports two zones with a method that has none, or with a slip angle; false where it did.
pub(crate) fn takes_two_zones(object: &Reader<'_>, method: Method, contact: &Contact) -> bool {
    if contact.braking() != Braking::TwoZone {
        return true;
    }
    if method == Method::ResistiveForce {
        let place = object.place_of(&BRAKING_FIELD);
        place.fault(
            "two zones are a law of the shear stress, which the method `resistive_force` does not use; use the quadrature",
        );
        return false;
    }
    let refusal = match method {
        Method::Quadrature | Method::ResistiveForce => None,
        Method::SideSlipping(side) => (side.angle.angle() != 0.0).then_some(Error::SlipAngleOfTwoZones),
        Method::Linearised { .. } | Method::Explicit { .. } => Some(Error::ClosedFormOfTwoZones),
    };
    if let Some(error) = refusal {
        object.place_of(&BRAKING_FIELD).fault(error);
    }
    refusal.is_none()
}
