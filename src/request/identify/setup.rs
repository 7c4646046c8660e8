//! The forward model of a fit, from what is known and what stands in for the fitted fields.

use terramechanics::{Contact, ContactParams, Operation, PeakRule, WheelOnSoil, WongReece};
use terramechanics_identification::{Setup, SinkageSource, Unknown};

use super::{IdentifyDto, name_of};
use crate::request::SoilDto;
use crate::request::method::MethodEntries;
use crate::request::operation::{self, OperationEntries};
use crate::request::soil::Needs;
use crate::wire::{Entry, Field, Scope};

/// Where the pressure–sinkage law of a setup comes from.
#[derive(Debug, Clone, Copy)]
pub(super) struct LawOrigin {
    /// Whether the request or the catalogue has it.
    pub(super) known: bool,
    /// Whether the preset's law gave way to the direct one, whose modulus is fitted.
    pub(super) replaced: bool,
}

impl IdentifyDto {
    /// The forward model, with starts for what is fitted and known nowhere.
    pub(super) fn setup(
        &self,
        place: &Scope<'_>,
        fitted: &[Unknown],
        starts: &[(Unknown, f64)],
        needs_law: bool,
    ) -> Option<(Setup, LawOrigin)> {
        let start =
            |unknown: Unknown| starts.iter().find(|(known, _)| *known == unknown).map_or(unknown.typical(), |(_, value)| *value);
        let filling: Vec<(&'static str, f64)> = fitted.iter().map(|&unknown| (name_of(unknown), start(unknown))).collect();
        let (soil, law_replaced) = match self.soil().field {
            Field::Absent if !lacking(fitted).is_empty() => {
                let lacking = lacking(fitted).join(", ");
                place.field("soil").fault(format_args!("a soil is needed: neither given nor fitted are {lacking}"));
                return None;
            }
            Field::Absent => SoilDto::default().filled(&filling),
            Field::Given(dto) => dto.filled(&filling),
            Field::Wrong(_) => {
                self.soil().given(place);
                return None;
            }
        };
        let soil = Field::Given(soil);
        let contact = self.contact().given(place).map(|dto| dto.filled(&filling));
        let contact = contact.map_or(Field::Absent, Field::Given);
        // Any sinkage will do here; where each sample has its own, this one is not used.
        let sinkage = Field::Given(1e-6);
        let absent = Field::Absent;
        let (absent_law, absent_word) = (Field::Absent, Field::Absent);
        let checked = OperationEntries {
            wheel: self.wheel(),
            soil: Entry { field: &soil, name: self.soil().name, spec: self.soil().spec },
            needs: Needs { pressure_sinkage: needs_law, ..Needs::BOTH_LAWS },
            contact: Entry { field: &contact, name: self.contact().name, spec: self.contact().spec },
            sinkage: Entry { name: "data", field: &sinkage, spec: &operation::SINKAGE },
            static_sinkage: Entry { name: "data", field: &absent, spec: &operation::STATIC_SINKAGE },
            slip_sinkage: Entry { name: "slip_sinkage", field: &absent_law, spec: &operation::SLIP_SINKAGE },
            normal_load: Entry { name: "data", field: &absent, spec: &operation::NORMAL_LOAD },
            normal_stress_radius: self.normal_stress_radius(),
            peak_sinkage: self.peak_sinkage(),
            braking: Entry { name: "braking", field: &absent_word, spec: &operation::BRAKING },
            side_slip: None,
            method: Some(MethodEntries { method: self.method(), lambda_a: self.lambda_a(), lambda_b: self.lambda_b() }),
        }
        .check(place);
        let source = self.sinkage_source(place, fitted, start(Unknown::StaticSinkage));
        let Operation { system, model, .. } = checked?.operation;
        let WheelOnSoil { wheel, soil, contact } = system;
        let contact = self.contact_params(&contact, fitted, start(Unknown::PeakIntercept), start(Unknown::PeakSlipGain));
        Some((
            Setup { wheel, soil: *soil.params(), contact, model, sinkage: source? },
            LawOrigin { known: soil.pressure_sinkage().is_some(), replaced: law_replaced },
        ))
    }

    /// The contact; where c1 or c2 is fitted and nothing was said of the contact, it follows Wong & Reece's rule.
    fn contact_params(&self, contact: &Contact, fitted: &[Unknown], c1: f64, c2: f64) -> ContactParams {
        let params = *contact.params();
        let is_fitted = fitted.contains(&Unknown::PeakIntercept) || fitted.contains(&Unknown::PeakSlipGain);
        match params.rule {
            PeakRule::Midpoint | PeakRule::HalfSinkage if is_fitted && !self.contact().is_present() => {
                let c2 = if fitted.contains(&Unknown::PeakSlipGain) { c2 } else { 0.0 };
                let c1 = if fitted.contains(&Unknown::PeakIntercept) { c1 } else { 0.5 };
                ContactParams { rule: PeakRule::WongReece(WongReece { c1, c2 }), ..params }
            }
            _ => params,
        }
    }

    /// Where the sinkage of a sample comes from.
    fn sinkage_source(&self, place: &Scope<'_>, fitted: &[Unknown], static_sinkage: f64) -> Option<SinkageSource> {
        let is_static = fitted.contains(&Unknown::StaticSinkage);
        let law = match self.slip_sinkage().given(place) {
            Some(dto) => dto.check(&place.field("slip_sinkage")),
            None => Some(terramechanics::SlipSinkage::Lyasko),
        };
        if self.slip_sinkage().is_present() && !is_static {
            place.field("slip_sinkage").fault("needs `static_sinkage_m` among the parameters of `fit`");
            return None;
        }
        let data = self.data().given(place)?;
        if is_static {
            Some(SinkageSource::Static { static_sinkage, law: law? })
        } else if data.has_sinkage() {
            Some(SinkageSource::Measured)
        } else if data.has_normal_force() {
            Some(SinkageSource::Load)
        } else {
            place.field("data").fault("needs `sinkage_m`, or `normal_force_n` as the load");
            None
        }
    }
}

/// What a soil has besides the parameters.
fn lacking(fitted: &[Unknown]) -> Vec<&'static str> {
    use Unknown as U;
    let alone = [U::Cohesion, U::FrictionAngle, U::ShearModulus, U::BaseExponent];
    let mut lacking: Vec<&'static str> = alone.into_iter().filter(|unknown| !fitted.contains(unknown)).map(name_of).collect();
    let moduli = [U::SinkageModulus, U::CohesiveModulus, U::FrictionalModulus].map(|unknown| fitted.contains(&unknown));
    match moduli {
        [true, ..] | [_, true, true] => {}
        [false, true, false] => lacking.push("k_phi"),
        [false, false, true] => lacking.push("k_c"),
        [false, false, false] => lacking.push("k_s (or k_c and k_phi)"),
    }
    lacking
}
