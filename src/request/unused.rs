//! Fields that were sent and that the methods of a request do not read.
//!
//! They are told in the answer, for whoever sent one may take the number to depend on it; they are refused only where the method cannot
//! do what they ask for. What holds without being sent is not told: a default, or what the catalogue has of a preset.

use terramechanics::{
    Braking, Contact, ExitRule, Lambda, Method, Parameter, PeakRule, PressureSinkage, ShearLaw, Soil, WheelOnSoil,
};
use terramechanics_reading::{Defaulting, Either, Faults, Field, OneOf, Reader, Scope, Word};

use super::circles::SHEAR_DISPLACEMENT;
use super::contact::{C3, EXIT};
use super::method::{BRAKING_FIELD, LAMBDA_A, LAMBDA_B, NORMAL_STRESS_RADIUS, PEAK_SINKAGE};
use super::side_slip::{BULLDOZING, SHEAR_COUPLING};
use super::soil;
use super::system::{CONTACT, SOIL};
use super::weights::{BULK_DENSITY, GRANULAR_STIFFNESS, UNIT_WEIGHT};
use crate::warning::{Finding, Warning};
use crate::words::HINTS;

/// What of a request has an influence on its answer, beside the wheel, the slip and the sinkage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Reads {
    /// The rules of the contact, and the radius of the normal stress.
    contact: bool,
    /// The exit by itself, not only as far as the peak follows from it.
    exit: bool,
    /// The laws and the strength of the soil, and how far it was sheared.
    laws: bool,
    /// The depth under the peak of linear stresses.
    peak_depth: bool,
    /// λ_A and λ_B.
    lambdas: bool,
    /// What pushes the wheel sideways.
    side: bool,
    /// The granular stiffness, or what it follows from.
    granular_stiffness: bool,
}

impl Reads {
    const NOTHING: Self = Self {
        contact: false,
        exit: false,
        laws: false,
        peak_depth: false,
        lambdas: false,
        side: false,
        granular_stiffness: false,
    };
    /// Stresses by the laws of the soil, integrated.
    pub(crate) const STRESSES: Self = Self { contact: true, exit: true, laws: true, ..Self::NOTHING };
    /// Linear stresses beside those.
    pub(crate) const LINEAR_STRESSES: Self = Self { peak_depth: true, ..Self::STRESSES };
    /// What follows from a measured torque.
    pub(crate) const FROM_TORQUE: Self = Self { contact: true, exit: true, ..Self::NOTHING };

    /// What a method reads; under a load that is known it finds the stiffness of grains by itself.
    pub(crate) fn by(method: &Method, is_under_load: bool) -> Self {
        match method {
            Method::Quadrature => Self::STRESSES,
            Method::SideSlipping(_) => Self { side: true, ..Self::STRESSES },
            Method::Linearised { .. } => Self::LINEAR_STRESSES,
            Method::Explicit { lambda_a, lambda_b, .. } => {
                // Its formulas end the contact at the lowest point; exact λ are those of the contact as it is.
                let exit = [lambda_a, lambda_b].contains(&&Lambda::Exact);
                Self { exit, lambdas: true, ..Self::LINEAR_STRESSES }
            }
            Method::ResistiveForce => Self { granular_stiffness: !is_under_load, ..Self::NOTHING },
        }
    }

    /// What one or the other reads.
    pub(crate) fn and(self, other: Self) -> Self {
        Self {
            contact: self.contact || other.contact,
            exit: self.exit || other.exit,
            laws: self.laws || other.laws,
            peak_depth: self.peak_depth || other.peak_depth,
            lambdas: self.lambdas || other.lambdas,
            side: self.side || other.side,
            granular_stiffness: self.granular_stiffness || other.granular_stiffness,
        }
    }
}

/// Fields that were sent and are not read, by their pointers.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Unused(Vec<String>);

impl Unused {
    /// Those of a request for a wheel on a soil.
    pub(crate) fn of(object: &Reader<'_>, reads: Reads, system: &WheelOnSoil) -> Self {
        let mut found = Self::beside_soil(object, reads, &system.contact);
        if let Some(sent) = object.within(&SOIL) {
            found.add_soil(&sent, reads, &system.soil);
        }
        found
    }

    /// Those of a request without the soil.
    pub(crate) fn beside_soil(object: &Reader<'_>, reads: Reads, contact: &Contact) -> Self {
        let mut found = Self::default();
        found.add(object, &CONTACT, reads.contact);
        found.add_word(object, &SHEAR_DISPLACEMENT, reads.laws);
        found.add_word(object, &NORMAL_STRESS_RADIUS, reads.contact);
        found.add(object, &PEAK_SINKAGE, reads.peak_depth);
        // Two zones are refused where there are none.
        found.add_word(object, &BRAKING_FIELD, reads.laws || contact.braking() == Braking::TwoZone);
        found.add_number(object, &LAMBDA_A, &Lambda::A, reads.lambdas);
        found.add_number(object, &LAMBDA_B, &Lambda::B, reads.lambdas);
        found.add_word(object, &SHEAR_COUPLING, reads.side);
        found.add_word(object, &BULLDOZING, reads.side);
        if let Some(sent) = object.within(&CONTACT).filter(|_| reads.contact) {
            let has_exit = reads.exit || matches!(contact.params().rule, PeakRule::Midpoint);
            match contact.params().exit {
                ExitRule::AngleRatio(_) => found.add(&sent, &C3, has_exit),
                ExitRule::SinkageRatio(_) => found.add(&sent, &EXIT, has_exit),
            }
        }
        found
    }

    /// Adds those of a soil that was sent.
    pub(crate) fn add_soil(&mut self, sent: &Reader<'_>, reads: Reads, soil: &Soil) {
        // It was sent, or it is fitted.
        let is_given = soil.params().granular_stiffness.is_some();
        let follows = reads.granular_stiffness && !is_given;
        let takes_modulus = matches!(soil.shear(), Some(ShearLaw::JanosiHanamoto(_)));
        // Reece's law takes the weight of the soil where it has none of its own.
        let has_own_weight = sent.within(&soil::PRESSURE_SINKAGE).is_none_or(|law| law.has(&UNIT_WEIGHT));
        let in_law = reads.laws && !has_own_weight && matches!(soil.pressure_sinkage(), Some(PressureSinkage::Reece(_)));
        let weighs = reads.side || in_law;
        // No cohesion is what grains have.
        let has_cohesion = soil.cohesion() != 0.0;
        self.add(sent, &soil::COHESION, reads.laws || !has_cohesion);
        self.add(sent, &soil::FRICTION_ANGLE, reads.laws || follows);
        self.add(sent, &soil::SHEAR_MODULUS, reads.laws && (takes_modulus || reads.side));
        self.add(sent, &soil::PRESSURE_SINKAGE, reads.laws);
        self.add(sent, &soil::LATERAL_SHEAR_MODULUS, reads.side);
        self.add(sent, &UNIT_WEIGHT, weighs);
        self.add(sent, &BULK_DENSITY, follows || weighs && !sent.has(&UNIT_WEIGHT));
        self.add(sent, &GRANULAR_STIFFNESS, reads.granular_stiffness);
        self.add(sent, &soil::SHEAR, reads.laws);
    }

    /// Adds a field that was sent, unless it is read.
    pub(crate) fn add<K>(&mut self, object: &Reader<'_>, field: &Field<K>, is_read: bool) {
        if !is_read && object.has(field) {
            let pointer = object.place_of(field).pointer();
            if !self.0.contains(&pointer) {
                self.0.push(pointer);
            }
        }
    }

    /// The same of a word, unless it is what holds without.
    fn add_word<T: Copy + PartialEq + Sync>(&mut self, object: &Reader<'_>, field: &Field<Word<T>>, is_read: bool) {
        let is_default = object.optional(field).flatten() == field.kind.default();
        self.add(object, field, is_read || is_default);
    }

    /// The same of a number or a word, unless it is the number that holds without.
    fn add_number(&mut self, object: &Reader<'_>, field: &Field<OneOf>, of: &Parameter, is_read: bool) {
        // What is wrong with it was reported where it was read.
        let faults = Faults::new(&HINTS);
        let sent = object.at(Scope::root(&faults)).optional(field).flatten().map(|sent| match sent {
            Either::Number(sent) => Some(sent),
            Either::Word | Either::Numbers(_) | Either::Object(_) => None,
        });
        let is_default = sent == Some(of.default());
        self.add(object, field, is_read || is_default);
    }

    /// Adds those of another part of the request.
    pub(crate) fn extend(&mut self, other: Self) {
        other.0.into_iter().for_each(|pointer| {
            if !self.0.contains(&pointer) {
                self.0.push(pointer);
            }
        });
    }

    /// What is to be said of them.
    pub(crate) fn finding(&self) -> Option<Finding> {
        (!self.0.is_empty()).then(|| Finding::NotUsed { pointers: self.0.clone() })
    }

    /// The same as a warning.
    pub(crate) fn warning(&self) -> Option<Warning> {
        self.finding().map(Warning::from)
    }
}
