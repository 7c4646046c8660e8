//! Alternatives to a request: laws that take the place of its own.

use terramechanics::Operation;

use super::CompareDto;
use crate::request::pressure_sinkage::PressureSinkageDto;
use crate::request::shear::ShearDto;
use crate::request::{ContactDto, SlipSinkageDto, operation};
use crate::wire::{Choice, Field, FieldFault, Label, LabelSpec, ListSpec, Nested, Object, Scope, wire_object};

pub(super) const VARIANTS: ListSpec<VariantDto> =
    ListSpec::optional("Alternatives to the request as it stands, each with a series by every method.", 8);

wire_object! {
    /// The request with other laws: what stands here takes the place of the request's own.
    VariantDto as "CompareVariant" {
        name: Label = LabelSpec { doc: "What the variant is called in the answer; no other has the same name." },
        shear: ShearDto = Nested::optional("Shear law, for that of the soil."),
        pressure_sinkage: PressureSinkageDto = Nested::optional("Pressure–sinkage law, for that of the soil."),
        contact: ContactDto = Nested::optional("The contact."),
        slip_sinkage: SlipSinkageDto = Nested::optional("Slip–sinkage law; the request has a static_sinkage_m."),
        braking: String = Choice { doc: "Law for a braking wheel; two_zone with the quadrature as the only method.", default: None, ..operation::BRAKING },
        normal_stress_radius: String = Choice { default: None, ..operation::NORMAL_STRESS_RADIUS },
    }
}

impl VariantDto {
    /// The name, if none of the earlier variants has it.
    pub(super) fn checked_name(&self, place: &Scope<'_>, earlier: &[String]) -> Option<String> {
        self.report_oddities(place);
        let name = self.name().label(place)?;
        if earlier.contains(&name) {
            place.field("name").fault("is the name of an earlier variant");
            return None;
        }
        Some(name)
    }

    /// The operations of `request` with what this has in place of its own. `faults` are those of the request as it stands, which
    /// are not reported again.
    pub(super) fn operations(&self, request: &CompareDto, faults: &[FieldFault], place: &Scope<'_>) -> Option<Vec<Operation>> {
        let (operations, found) = self.in_place_of(request).operations();
        for FieldFault { pointer, detail } in found {
            match self.own(&pointer) {
                Some(pointer) => place.pass_on(FieldFault { pointer, detail }),
                None if faults.iter().any(|fault| fault.pointer == pointer && fault.detail == detail) => {}
                None => place.fault(format_args!("with this variant, {pointer} {detail}")),
            }
        }
        operations
    }

    fn in_place_of(&self, request: &CompareDto) -> CompareDto {
        let mut varied = request.clone();
        varied.contact = self.contact().or(&request.contact);
        varied.slip_sinkage = self.slip_sinkage().or(&request.slip_sinkage);
        varied.braking = self.braking().or(&request.braking);
        varied.normal_stress_radius = self.normal_stress_radius().or(&request.normal_stress_radius);
        if let Field::Given(soil) = &mut varied.soil {
            *soil = soil.with_laws(&self.shear(), &self.pressure_sinkage());
        }
        varied
    }

    /// The place in this variant for a pointer into the request that it stands in; none where the request's own is in place.
    fn own(&self, pointer: &str) -> Option<String> {
        let parts = [
            ("/soil", self.shear().name, self.shear().is_present()),
            ("/soil", self.pressure_sinkage().name, self.pressure_sinkage().is_present()),
            ("", self.contact().name, self.contact().is_present()),
            ("", self.slip_sinkage().name, self.slip_sinkage().is_present()),
            ("", self.braking().name, self.braking().is_present()),
            ("", self.normal_stress_radius().name, self.normal_stress_radius().is_present()),
        ];
        parts.into_iter().filter(|(.., is_present)| *is_present).find_map(|(around, name, _)| {
            let inside = pointer.strip_prefix(around)?;
            let below = inside.strip_prefix('/')?.strip_prefix(name)?;
            (below.is_empty() || below.starts_with('/')).then(|| inside.to_owned())
        })
    }
}
