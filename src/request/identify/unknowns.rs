//! The numbers that can be fitted, by name, with what may be sent for each: a start, and bounds.

use terramechanics::{Bekker, Direct, JanosiHanamoto, Lambda, SinkageExponent, Soil, WheelOnSoil, WongReece};
use terramechanics_identification::{Range, Unknown};

use crate::wire::{Entry, Number, Object, Pair, PairSpec, Scope, wire_object};

/// The name of every unknown.
const NAMES: [(&str, Unknown); 13] = [
    ("cohesion_pa", Unknown::Cohesion),
    ("friction_angle_rad", Unknown::FrictionAngle),
    ("shear_modulus_m", Unknown::ShearModulus),
    ("k_s", Unknown::SinkageModulus),
    ("k_c", Unknown::CohesiveModulus),
    ("k_phi", Unknown::FrictionalModulus),
    ("n0", Unknown::BaseExponent),
    ("n1", Unknown::SlipGain),
    ("c1", Unknown::PeakIntercept),
    ("c2", Unknown::PeakSlipGain),
    ("lambda_a", Unknown::LambdaA),
    ("lambda_b", Unknown::LambdaB),
    ("static_sinkage_m", Unknown::StaticSinkage),
];

/// The names of all unknowns.
pub(super) fn names() -> Vec<&'static str> {
    NAMES.iter().map(|(name, _)| *name).collect()
}

/// The unknown of that name.
pub(super) fn named(name: &str) -> Option<Unknown> {
    NAMES.iter().find(|(known, _)| *known == name).map(|(_, unknown)| *unknown)
}

/// The name of an unknown.
pub(crate) fn name_of(unknown: Unknown) -> &'static str {
    NAMES.iter().find(|(_, known)| *known == unknown).map_or("", |(name, _)| name)
}

// What a request may have for the same field elsewhere.
const COHESION: Number = Number::within(&Soil::COHESION, "Cohesion c (Pa).");
const FRICTION: Number = Number::within(&Soil::FRICTION_ANGLE, "Internal friction angle φ (rad).").angle();
const SHEAR_MODULUS: Number = Number::within(&JanosiHanamoto::MODULUS, "Shear deformation modulus K (m).").length();
const K_S: Number = Number::within(&Direct::K_S, "Sinkage modulus K_s of the direct law (Pa/m^N).");
const K_C: Number = Number::within(&Bekker::K_C, "Cohesive modulus of Bekker's or Reece's law.");
const K_PHI: Number = Number::within(&Bekker::K_PHI, "Frictional modulus of Bekker's or Reece's law.");
const N0: Number = Number::within(&SinkageExponent::BASE, "Sinkage exponent without slip (–).");
const N1: Number = Number::within(&SinkageExponent::SLIP_GAIN, "Gain of the exponent with slip (–).");
const C1: Number = Number::within(&WongReece::C1, "c1 of θm = (c1 + c2 s) θ1 (–).");
const C2: Number = Number::within(&WongReece::C2, "c2 of θm = (c1 + c2 s) θ1 (–).");
const LAMBDA: Number = Number::within(&Lambda::A, "λ of the explicit method (–).");
const STATIC_SINKAGE: Number = Number::within(&WheelOnSoil::STATIC_SINKAGE, "Static sinkage z0 (m).").length();

wire_object! {
    /// Where the search begins, by parameter; else at the soil's value if it has one, else at a usual one.
    StartDto as "FitStart" {
        cohesion_pa: f64 = COHESION,
        friction_angle_rad: f64 = FRICTION,
        shear_modulus_m: f64 = SHEAR_MODULUS,
        k_s: f64 = K_S,
        k_c: f64 = K_C,
        k_phi: f64 = K_PHI,
        n0: f64 = N0,
        n1: f64 = N1,
        c1: f64 = C1,
        c2: f64 = C2,
        lambda_a: f64 = LAMBDA,
        lambda_b: f64 = LAMBDA,
        static_sinkage_m: f64 = STATIC_SINKAGE,
    }
}

wire_object! {
    /// Bounds within which a parameter is sought, the lower and the upper one; else what any soil can have.
    BoundsDto as "FitBounds" {
        cohesion_pa: Pair = PairSpec(COHESION),
        friction_angle_rad: Pair = PairSpec(FRICTION),
        shear_modulus_m: Pair = PairSpec(SHEAR_MODULUS),
        k_s: Pair = PairSpec(K_S),
        k_c: Pair = PairSpec(K_C),
        k_phi: Pair = PairSpec(K_PHI),
        n0: Pair = PairSpec(N0),
        n1: Pair = PairSpec(N1),
        c1: Pair = PairSpec(C1),
        c2: Pair = PairSpec(C2),
        lambda_a: Pair = PairSpec(LAMBDA),
        lambda_b: Pair = PairSpec(LAMBDA),
        static_sinkage_m: Pair = PairSpec(STATIC_SINKAGE),
    }
}

impl StartDto {
    fn entries(&self) -> [Entry<'_, f64>; 13] {
        [
            self.cohesion_pa(),
            self.friction_angle_rad(),
            self.shear_modulus_m(),
            self.k_s(),
            self.k_c(),
            self.k_phi(),
            self.n0(),
            self.n1(),
            self.c1(),
            self.c2(),
            self.lambda_a(),
            self.lambda_b(),
            self.static_sinkage_m(),
        ]
    }

    /// The starts that were sent; one of a parameter that is not fitted is reported.
    pub(super) fn check(&self, place: &Scope<'_>, fitted: Option<&[Unknown]>) -> Vec<(Unknown, f64)> {
        self.report_oddities(place);
        let start = |(entry, (_, unknown)): (&Entry<'_, f64>, &(&str, Unknown))| {
            report_idle(place, entry.name, entry.is_present(), fitted, *unknown);
            entry.checked(place).map(|value| (*unknown, value))
        };
        self.entries().iter().zip(&NAMES).filter_map(start).collect()
    }
}

impl BoundsDto {
    fn entries(&self) -> [Entry<'_, Pair>; 13] {
        [
            self.cohesion_pa(),
            self.friction_angle_rad(),
            self.shear_modulus_m(),
            self.k_s(),
            self.k_c(),
            self.k_phi(),
            self.n0(),
            self.n1(),
            self.c1(),
            self.c2(),
            self.lambda_a(),
            self.lambda_b(),
            self.static_sinkage_m(),
        ]
    }

    /// The bounds that were sent; those of a parameter that is not fitted are reported.
    pub(super) fn check(&self, place: &Scope<'_>, fitted: Option<&[Unknown]>) -> Vec<(Unknown, Range)> {
        self.report_oddities(place);
        let range = |(entry, (_, unknown)): (&Entry<'_, Pair>, &(&str, Unknown))| {
            report_idle(place, entry.name, entry.is_present(), fitted, *unknown);
            entry.bounds(place).map(|[lower, upper]| (*unknown, Range::new(lower, upper)))
        };
        self.entries().iter().zip(&NAMES).filter_map(range).collect()
    }
}

/// Reports a start or bounds of a parameter that is not fitted: it would have no effect.
fn report_idle(place: &Scope<'_>, name: &'static str, is_present: bool, fitted: Option<&[Unknown]>, unknown: Unknown) {
    if is_present && fitted.is_some_and(|fitted| !fitted.contains(&unknown)) {
        place.field(name).fault("is not among the parameters of `fit`");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::Spec;

    #[test]
    fn names_stand_in_the_order_of_the_entries() {
        let names = names();
        assert_eq!(StartDto::default().entries().map(|entry| entry.name).as_slice(), names);
        assert_eq!(BoundsDto::default().entries().map(|entry| entry.name).as_slice(), names);
        assert!(Unknown::ALL.into_iter().all(|unknown| named(name_of(unknown)) == Some(unknown)));
    }

    /// A fitted value is sent back where it can be used, so it may be what the soil and the contact may be.
    #[test]
    fn bounds_are_those_of_the_soil_and_the_contact() {
        use crate::request::{ContactDto, SoilDto};
        let bounds = |number: &Number| {
            let text = serde_json::to_value(number.schema()).expect("JSON");
            ["minimum", "maximum", "exclusiveMaximum"].map(|name| text[name].as_f64())
        };
        let (soil, contact, start) = (SoilDto::default(), ContactDto::default(), StartDto::default());
        let law = crate::request::pressure_sinkage::PressureSinkageDto::default();
        for (here, there) in [
            (start.cohesion_pa(), soil.cohesion_pa()),
            (start.friction_angle_rad(), soil.friction_angle_rad()),
            (start.shear_modulus_m(), soil.shear_modulus_m()),
            (start.k_s(), law.k_s()),
            (start.k_c(), law.k_c()),
            (start.k_phi(), law.k_phi()),
            (start.n0(), law.n0()),
            (start.n1(), law.n1()),
            (start.c1(), contact.c1()),
            (start.c2(), contact.c2()),
        ] {
            assert_eq!((here.name, bounds(here.spec)), (there.name, bounds(there.spec)));
        }
    }
}
