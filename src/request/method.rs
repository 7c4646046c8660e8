//! The method and what it takes: constants of the closed forms, laws of a braking wheel.

use terramechanics::{Braking, Contact, Error, Method, PeakDepth};

use super::operation::or_none;
use crate::wire::{Entry, Lambda, Scope};

/// The fields that choose a method.
pub(super) struct MethodEntries<'a> {
    pub(super) method: Entry<'a, String>,
    pub(super) lambda_a: Entry<'a, Lambda>,
    pub(super) lambda_b: Entry<'a, Lambda>,
}

/// How the closed forms are made.
#[derive(Clone, Copy)]
pub(super) struct ClosedForms {
    /// The depth under the peak, where one was asked for.
    pub(super) peak_depth: Option<PeakDepth>,
    pub(super) lambda_a: terramechanics::Lambda,
    pub(super) lambda_b: terramechanics::Lambda,
}

impl ClosedForms {
    /// The method of that name.
    pub(super) fn method(&self, name: &str) -> Option<Method> {
        let Self { peak_depth, lambda_a, lambda_b } = *self;
        match name {
            "quadrature" => Some(Method::Quadrature),
            "linearised" => Some(Method::Linearised { peak_depth: peak_depth.unwrap_or(PeakDepth::Geometric) }),
            "explicit" => Some(Method::Explicit { peak_depth: peak_depth.unwrap_or(PeakDepth::Half), lambda_a, lambda_b }),
            _ => None,
        }
    }
}

/// A constant of the explicit formulas, 0 where none was sent; what cannot be one is reported and stands for 0 as well.
pub(super) fn checked_lambda(entry: &Entry<'_, Lambda>, place: &Scope<'_>) -> terramechanics::Lambda {
    let sent = match entry.given(place) {
        Some(Lambda::Number(value)) => {
            entry.spec.number.check(&place.field(entry.name), *value).map(terramechanics::Lambda::Given)
        }
        Some(Lambda::Word(word)) if word == "exact" => Some(terramechanics::Lambda::Exact),
        Some(Lambda::Word(_)) => {
            place.field(entry.name).fault("must be a number or \"exact\"");
            None
        }
        None => None,
    };
    sent.unwrap_or(terramechanics::Lambda::Given(0.0))
}

impl MethodEntries<'_> {
    pub(super) fn check(&self, place: &Scope<'_>, peak_depth: Option<PeakDepth>) -> Option<Method> {
        let (lambda_a, lambda_b) = (checked_lambda(&self.lambda_a, place), checked_lambda(&self.lambda_b, place));
        let closed_forms = ClosedForms { peak_depth, lambda_a, lambda_b };
        let method = or_none(&self.method, place, |name| closed_forms.method(name));
        Some(method?.unwrap_or(Method::Quadrature))
    }
}

/// The law for a braking wheel, `default` where none was sent; nothing where the word is wrong, which is reported.
pub(super) fn braking_law(entry: &Entry<'_, String>, place: &Scope<'_>, default: Braking) -> Option<Braking> {
    let law = or_none(entry, place, |word| match word {
        "one_zone" => Some(Braking::OneZone),
        "two_zone" => Some(Braking::TwoZone),
        _ => None,
    })?;
    Some(law.unwrap_or(default))
}

/// Reports two zones with a closed form or a slip angle; false where it did.
pub(super) fn takes_two_zones(method: Method, contact: &Contact, braking: &Entry<'_, String>, place: &Scope<'_>) -> bool {
    if contact.braking() != Braking::TwoZone {
        return true;
    }
    let refusal = match method {
        Method::Quadrature => None,
        Method::SideSlipping(side) => (side.angle.angle() != 0.0).then_some(Error::SlipAngleOfTwoZones),
        Method::Linearised { .. } | Method::Explicit { .. } => Some(Error::ClosedFormOfTwoZones),
    };
    if let Some(error) = refusal {
        place.field(braking.name).fault(error);
    }
    refusal.is_none()
}
