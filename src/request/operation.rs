//! What all requests for forces have in common: wheel, soil, contact, method and sinkage.

use super::method::{MethodEntries, braking_law, takes_two_zones};
use super::side_slip::SideSlipEntries;
use super::soil::Needs;
use super::{ContactDto, SlipSinkageDto, SoilDto, WheelDto};
use crate::wire::{Choice, Entry, LambdaSpec, Nested, Number, Scope, in_millimetres};
use terramechanics::{
    Braking, Contact, Error, ForceModel, Method, NormalStressRadius, Operation, PeakDepth, Sinkage, Slip, SlipSinkage,
    Velocities, Wheel, WheelOnSoil,
};

pub(super) const WHEEL: Nested<WheelDto> = Nested::required("The wheel.");
pub(super) const SOIL: Nested<SoilDto> = Nested::required("The soil.");
pub(super) const CONTACT: Nested<ContactDto> =
    Nested::optional("The contact; else what the catalogue measured with the soil, else midpoint with c3 = 0.");
pub(super) const FORWARD_VELOCITY: Number =
    Number::within(&Velocities::FORWARD, "Forward velocity v of the axle (m/s); with angular_velocity_rad_s instead of slip.");
pub(super) const ANGULAR_VELOCITY: Number =
    Number::within(&Velocities::ANGULAR, "Angular velocity ω of the wheel (rad/s), positive when it rolls forward.");
pub(super) const SLIP: Number =
    Number::within(&Slip::RATIO, "Slip ratio s [–]: −1 locked, 0 rolling, 1 spinning; driving 1 − v/(rω), braking rω/v − 1.")
        .share();
pub(super) const SINKAGE: Number = Number::within(&WheelOnSoil::SINKAGE, "Sinkage z (m), at most the wheel's radius.").length();
pub(super) const STATIC_SINKAGE: Number =
    Number::within(&WheelOnSoil::STATIC_SINKAGE, "Static sinkage z0 (m); the sinkage follows from the slip by `slip_sinkage`.")
        .length();
pub(super) const SLIP_SINKAGE: Nested<SlipSinkageDto> =
    Nested::optional("Slip–sinkage law beside static_sinkage_m; lyasko unless given.");
pub(super) const NORMAL_LOAD: Number =
    Number::within(&WheelOnSoil::NORMAL_LOAD, "Vertical load W (N); the sinkage is solved so that F_z = W.");
pub(super) const METHOD: Choice = Choice {
    doc: "quadrature: the integral of the stresses; linearised: linear stresses, closed form; explicit: the letter's formulas.",
    words: || vec!["quadrature", "linearised", "explicit"],
    default: Some("quadrature"),
};
pub(super) const METHOD_OF_SEVERAL: Choice =
    Choice { doc: "quadrature, linearised or explicit.", words: METHOD.words, default: None };
pub(super) const NORMAL_STRESS_RADIUS: Choice = Choice {
    doc: "Radius at which the normal stress acts: the rim r, or the shearing radius r_s.",
    words: || vec!["rim", "shearing"],
    default: Some("rim"),
};
pub(super) const PEAK_SINKAGE: Choice = Choice {
    doc: "Depth under the peak in the closed forms: geometric (default when linearised) or half of the sinkage (default when explicit).",
    words: || vec!["geometric", "half"],
    default: None,
};
pub(super) const LAMBDA_A: LambdaSpec =
    LambdaSpec { number: Number::of(&terramechanics::Lambda::A, "λ_A of A ≈ (1 − λ_A) √(z/2r) (–)."), word: EXACT };
pub(super) const LAMBDA_B: LambdaSpec =
    LambdaSpec { number: Number::of(&terramechanics::Lambda::B, "λ_B of B ≈ (1 + λ_B) z/(2r) (–)."), word: EXACT };
const EXACT: Choice = Choice { doc: "The value at which the approximation is exact.", words: || vec!["exact"], default: None };

pub(super) const BRAKING: Choice = Choice {
    doc: "Law for a braking wheel, s < 0. one_zone: the displacement of a driving wheel continued; two_zone: Wong & Reece's towed wheel, whose shear reverses at the peak of the stresses; by quadrature alone, and it does not join the rolling wheel at s = 0.",
    words: braking_words,
    default: Some("one_zone"),
};

fn braking_words() -> Vec<&'static str> {
    vec!["one_zone", "two_zone"]
}

/// The fields of a request that make an operation; a request without a method is answered by the quadrature.
pub(super) struct OperationEntries<'a> {
    pub(super) wheel: Entry<'a, WheelDto>,
    pub(super) soil: Entry<'a, SoilDto>,
    pub(super) needs: Needs,
    pub(super) contact: Entry<'a, ContactDto>,
    pub(super) sinkage: Entry<'a, f64>,
    pub(super) static_sinkage: Entry<'a, f64>,
    pub(super) slip_sinkage: Entry<'a, SlipSinkageDto>,
    pub(super) normal_load: Entry<'a, f64>,
    pub(super) normal_stress_radius: Entry<'a, String>,
    pub(super) peak_sinkage: Entry<'a, String>,
    pub(super) braking: Entry<'a, String>,
    pub(super) method: Option<MethodEntries<'a>>,
    pub(super) side_slip: Option<SideSlipEntries<'a>>,
}

/// The entries of a request that has the fields of an operation by these names, without those of a method and a slip angle.
macro_rules! operation_entries {
    ($request:expr) => {
        OperationEntries {
            wheel: $request.wheel(),
            soil: $request.soil(),
            needs: $crate::request::soil::Needs::BOTH_LAWS,
            contact: $request.contact(),
            sinkage: $request.sinkage_m(),
            static_sinkage: $request.static_sinkage_m(),
            slip_sinkage: $request.slip_sinkage(),
            normal_load: $request.normal_load_n(),
            normal_stress_radius: $request.normal_stress_radius(),
            peak_sinkage: $request.peak_sinkage(),
            braking: $request.braking(),
            method: None,
            side_slip: None,
        }
    };
}
pub(super) use operation_entries;

/// An operation, and the depth under the peak that was asked for.
pub(super) struct Checked {
    pub(super) operation: Operation,
    pub(super) peak_depth: Option<PeakDepth>,
}

impl OperationEntries<'_> {
    pub(super) fn check(&self, place: &Scope<'_>) -> Option<Checked> {
        self.check_with(place, |wheel| self.sinkage(place, wheel))
    }

    /// The operation with a sinkage that is known in another way.
    pub(super) fn check_with(
        &self,
        place: &Scope<'_>,
        sinkage: impl FnOnce(Option<&Wheel>) -> Option<Sinkage>,
    ) -> Option<Checked> {
        let wheel = self.wheel.required(place).and_then(|dto| dto.check(&place.field(self.wheel.name)));
        let soil = self.soil.required(place).and_then(|dto| dto.check(&place.field(self.soil.name), self.needs));
        let contact = checked_contact(&self.contact, place, soil.and_then(|(_, measured)| measured));
        let braking = braking_law(&self.braking, place, Braking::OneZone);
        let sinkage = sinkage(wheel.as_ref());
        let peak_depth = or_none(&self.peak_sinkage, place, |word| match word {
            "geometric" => Some(PeakDepth::Geometric),
            "half" => Some(PeakDepth::Half),
            _ => None,
        });
        let normal_stress_radius = normal_stress_radius_of(&self.normal_stress_radius, place);
        let peak_depth = peak_depth?;
        let method = match &self.method {
            Some(entries) => entries.check(place, peak_depth),
            None => Some(Method::Quadrature),
        };
        let method = match &self.side_slip {
            Some(entries) => entries.check(place, method),
            None => method,
        };
        let model = ForceModel { method: method?, normal_stress_radius: normal_stress_radius? };
        let contact = contact?.with_braking(braking?);
        if !takes_two_zones(model.method, &contact, &self.braking, place) {
            return None;
        }
        let system = WheelOnSoil { wheel: wheel?, soil: soil?.0, contact };
        Some(Checked { operation: Operation { system, model, sinkage: sinkage? }, peak_depth })
    }

    /// The slip–sinkage law, which has a meaning only beside a static sinkage.
    pub(super) fn slip_sinkage(&self, place: &Scope<'_>) -> Option<SlipSinkage> {
        if !self.slip_sinkage.is_present() {
            return Some(SlipSinkage::Lyasko);
        }
        if !self.static_sinkage.is_present() {
            place.field(self.slip_sinkage.name).fault(format_args!("needs `{}` beside it", self.static_sinkage.name));
        }
        self.slip_sinkage.given(place)?.check(&place.field(self.slip_sinkage.name))
    }

    /// The sinkage, given in exactly one of three ways.
    fn sinkage(&self, place: &Scope<'_>, wheel: Option<&Wheel>) -> Option<Sinkage> {
        let law = self.slip_sinkage(place);
        let ways = [&self.sinkage, &self.static_sinkage, &self.normal_load];
        let values = ways.map(|entry| entry.checked(place));
        let given: Vec<&str> = ways.iter().filter(|entry| entry.is_present()).map(|entry| entry.name).collect();
        if given.len() != 1 {
            let [sinkage, static_sinkage, load] = ways.map(|entry| entry.name);
            if given.is_empty() {
                place.field(sinkage).fault(format_args!("is required, or `{static_sinkage}` or `{load}`"));
            }
            for entry in ways.iter().filter(|entry| entry.is_present()) {
                place
                    .field(entry.name)
                    .fault(format_args!("only one of `{sinkage}`, `{static_sinkage}` and `{load}` may be given"));
            }
            return None;
        }
        match values {
            [Some(sinkage), None, None] => within_wheel(sinkage, wheel, &place.field(self.sinkage.name)).map(Sinkage::Given),
            [None, Some(static_sinkage), None] => Some(Sinkage::FromStatic { static_sinkage, law: law? }),
            [None, None, Some(load)] => Some(Sinkage::CarryingLoad(load)),
            _ => None,
        }
    }
}

/// The contact sent, else the one measured with the soil, else the midpoint.
pub(super) fn checked_contact(entry: &Entry<'_, ContactDto>, place: &Scope<'_>, measured: Option<Contact>) -> Option<Contact> {
    if entry.is_present() {
        entry.given(place).and_then(|dto| dto.check(&place.field(entry.name)))
    } else {
        Some(measured.unwrap_or(Contact::MIDPOINT))
    }
}

/// The radius at which the normal stress acts; the rim where none was sent.
pub(super) fn normal_stress_radius_of(entry: &Entry<'_, String>, place: &Scope<'_>) -> Option<NormalStressRadius> {
    let radius = or_none(entry, place, |word| match word {
        "rim" => Some(NormalStressRadius::Rim),
        "shearing" => Some(NormalStressRadius::Shearing),
        _ => None,
    });
    Some(radius?.unwrap_or(NormalStressRadius::Rim))
}

/// The sinkage, if it does not exceed the radius of the wheel, where that is known; else the fault is reported.
pub(super) fn within_wheel(sinkage: f64, wheel: Option<&Wheel>, place: &Scope<'_>) -> Option<f64> {
    match wheel.map(Wheel::radius) {
        Some(radius) if sinkage > radius => {
            let meant = if sinkage >= 1.0 && sinkage / 1000.0 <= radius { in_millimetres(sinkage) } else { String::new() };
            place.fault(format_args!("{}{meant}", Error::SinkageOutsideWheel { sinkage, radius }));
            None
        }
        _ => Some(sinkage),
    }
}

/// What `lookup` makes of the word: `Some(None)` where none was sent, `None` where it is wrong, which is reported.
pub(super) fn or_none<T>(entry: &Entry<'_, String>, place: &Scope<'_>, lookup: impl Fn(&str) -> Option<T>) -> Option<Option<T>> {
    if entry.is_present() { entry.looked_up(place, lookup).map(Some) } else { Some(None) }
}
