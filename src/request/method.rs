//! The method, and what it takes: constants of the closed forms, the stresses, laws of a braking wheel.

use terramechanics::{Braking, Contact, Error, Lambda, Method, NormalStressRadius, PeakDepth};
use terramechanics_reading::{Alternative, Either, Field, Group, Number, OneOf, Reader, Word};

use super::laws::number;

/// A method without its constants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MethodName {
    Quadrature,
    Linearised,
    Explicit,
}

pub(crate) const METHODS: Word<MethodName> = Word::new(&[
    ("quadrature", MethodName::Quadrature),
    ("linearised", MethodName::Linearised),
    ("explicit", MethodName::Explicit),
]);
pub(crate) const METHOD_FIELD: Field<Word<MethodName>> = Field::new(
    "method",
    "quadrature: the integral of the stresses; linearised: linear stresses, closed form; explicit: the letter's formulas.",
    METHODS.or(MethodName::Quadrature),
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
        }
    }
}

/// The method, of a request that has one.
pub(crate) fn read(object: &Reader<'_>, peak_depth: Option<PeakDepth>) -> Option<Method> {
    let closed_forms = ClosedForms::read(object, peak_depth);
    object.or_default(&METHOD_FIELD).map(|name| closed_forms.method(name))
}

/// Reports two zones with a closed form or a slip angle; false where it did.
pub(crate) fn takes_two_zones(object: &Reader<'_>, method: Method, contact: &Contact) -> bool {
    if contact.braking() != Braking::TwoZone {
        return true;
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
