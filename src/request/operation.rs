//! What all requests for forces have in common: wheel, soil, contact, method and sinkage.

use terramechanics::{
    Braking, Contact, Error, ForceModel, LinearSlipSinkage, Method, Motion, NormalStressRadius, Operation, Parameter, PeakDepth,
    Sinkage, Slip, SlipSinkage, Velocities, Wheel, WheelOnSoil,
};

use utoipa::openapi::{RefOr, Schema};

use super::side_slip::SideSlipEntries;
use super::soil::numbers_of;
use super::{ContactDto, SoilDto, WheelDto};
use crate::wire::{
    Choice, Entry, FieldFault, Lambda, LambdaSpec, Nested, Number, Object, Scope, Spec, Variant, in_millimetres, tagged_schema,
    wire_object,
};

pub(super) const WHEEL: Nested<WheelDto> = Nested::required("The wheel.");
pub(super) const SOIL: Nested<SoilDto> = Nested::required("The soil.");
pub(super) const CONTACT: Nested<ContactDto> =
    Nested::optional("The contact; else what the catalogue measured with the soil, else midpoint with c3 = 0.");
pub(super) const FORWARD_VELOCITY: Number =
    Number::new("Forward velocity v of the axle (m/s); with angular_velocity_rad_s instead of slip.", -1e3, 1e3);
pub(super) const ANGULAR_VELOCITY: Number =
    Number::new("Angular velocity ω of the wheel (rad/s), positive when it rolls forward.", -1e4, 1e4);
pub(super) const SLIP: Number =
    Number::new("Slip ratio s [–]: −1 locked, 0 rolling, 1 spinning; driving 1 − v/(rω), braking rω/v − 1.", -1.0, 1.0).share();
pub(super) const SINKAGE: Number = Number::new("Sinkage z (m), at most the wheel's radius.", 1e-9, 100.0).length();
pub(super) const STATIC_SINKAGE: Number =
    Number::new("Static sinkage z0 (m); the sinkage follows from the slip by `slip_sinkage`.", 1e-9, 100.0).length();
pub(super) const SLIP_SINKAGE: Nested<SlipSinkageDto> =
    Nested::optional("Slip–sinkage law beside static_sinkage_m; lyasko unless given.");
pub(super) const NORMAL_LOAD: Number = Number::new("Vertical load W (N); the sinkage is solved so that F_z = W.", 1e-9, 1e12);
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
    LambdaSpec { number: Number::new("λ_A of A ≈ (1 − λ_A) √(z/2r) (–).", -1.0, 1.0).or(0.0), word: EXACT };
pub(super) const LAMBDA_B: LambdaSpec =
    LambdaSpec { number: Number::new("λ_B of B ≈ (1 + λ_B) z/(2r) (–).", -1.0, 1.0).or(0.0), word: EXACT };
const EXACT: Choice = Choice { doc: "The value at which the approximation is exact.", words: || vec!["exact"], default: None };

pub(super) const BRAKING: Choice = Choice {
    doc: "Law for a braking wheel, s < 0. one_zone: the displacement of a driving wheel continued; two_zone: Wong & Reece's towed wheel, whose shear reverses at the peak of the stresses; by quadrature alone, and it does not join the rolling wheel at s = 0.",
    words: braking_words,
    default: Some("one_zone"),
};

fn braking_words() -> Vec<&'static str> {
    vec!["one_zone", "two_zone"]
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

/// The slip–sinkage laws and their parameters.
const SLIP_SINKAGE_LAWS: &[Variant] =
    &[Variant { name: "lyasko", required: &[], optional: &[] }, Variant { name: "linear", required: &["gain"], optional: &[] }];

fn slip_sinkage_names() -> Vec<&'static str> {
    Variant::names(SLIP_SINKAGE_LAWS)
}

fn slip_sinkage_schema(doc: &str, fields: &[(&'static str, &dyn Spec)]) -> RefOr<Schema> {
    tagged_schema(doc, fields, "law", SLIP_SINKAGE_LAWS)
}

wire_object! {
    /// How the sinkage follows from the static one: lyasko, z = z0 (1 + s)/(1 − s/2); linear, z = z0 (1 + S s).
    SlipSinkageDto as "SlipSinkage" with slip_sinkage_schema {
        law: String = Choice { doc: "Name of the law.", words: slip_sinkage_names, default: None },
        gain: f64 = Number::new("S of the linear law (–).", 0.0, 100.0),
    }
}

impl SlipSinkageDto {
    pub(super) fn check(&self, place: &Scope<'_>) -> Option<SlipSinkage> {
        self.report_oddities(place);
        self.law().required_word(place);
        let law = self.law().looked_up(place, |word| Variant::named(SLIP_SINKAGE_LAWS, word));
        let [gain] = numbers_of(law, &[self.gain()], place);
        Some(match law?.name {
            "lyasko" => SlipSinkage::Lyasko,
            _ => SlipSinkage::Linear(LinearSlipSinkage { gain: gain? }),
        })
    }
}

/// The fields of a request that make an operation; a request without a method is answered by the quadrature.
pub(super) struct OperationEntries<'a> {
    pub(super) wheel: Entry<'a, WheelDto>,
    pub(super) soil: Entry<'a, SoilDto>,
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

/// The fields that choose a method.
pub(super) struct MethodEntries<'a> {
    pub(super) method: Entry<'a, String>,
    pub(super) lambda_a: Entry<'a, Lambda>,
    pub(super) lambda_b: Entry<'a, Lambda>,
}

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
        let soil = self.soil.required(place).and_then(|dto| dto.check(&place.field(self.soil.name)));
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

/// What `lookup` makes of the word: `Some(None)` where none was sent, `None` where it is wrong, which is reported.
pub(super) fn or_none<T>(entry: &Entry<'_, String>, place: &Scope<'_>, lookup: impl Fn(&str) -> Option<T>) -> Option<Option<T>> {
    if entry.is_present() { entry.looked_up(place, lookup).map(Some) } else { Some(None) }
}

/// The fields that give the slip of one operating point.
pub(super) struct MotionEntries<'a> {
    pub(super) slip: Entry<'a, f64>,
    pub(super) forward_velocity: Entry<'a, f64>,
    pub(super) angular_velocity: Entry<'a, f64>,
}

impl MotionEntries<'_> {
    /// The motion: from the slip, or from both velocities and the wheel.
    pub(super) fn check(&self, place: &Scope<'_>, wheel: Option<&Wheel>) -> Option<Motion> {
        let slip = self.slip.checked(place);
        let (forward, angular) = (self.forward_velocity.checked(place), self.angular_velocity.checked(place));
        let velocities = [&self.forward_velocity, &self.angular_velocity].map(Entry::is_present);
        match (self.slip.is_present(), velocities) {
            (true, [false, false]) => {
                let slip = Slip::new(slip?).map_err(|error| place.field(self.slip.name).fault(error)).ok()?;
                Some(Motion::forward(slip))
            }
            (false, [true, true]) => {
                let velocities = Velocities { forward: forward?, angular: angular? };
                Motion::of(wheel?, velocities).map_err(|error| place.field(self.angular_velocity.name).fault(error)).ok()
            }
            (true, _) => {
                place.field(self.slip.name).fault("give either `slip` or both velocities, not both");
                None
            }
            (false, [false, false]) => {
                place.field(self.slip.name).fault("is required, or both `forward_velocity_m_s` and `angular_velocity_rad_s`");
                None
            }
            (false, [there, _]) => {
                let missing = if there { &self.angular_velocity } else { &self.forward_velocity };
                place.field(missing.name).fault("is required with the other velocity");
                None
            }
        }
    }
}

/// The field of a request to which a refusal of the model belongs.
pub(crate) fn error_pointer(error: &Error, sinkage: &Sinkage) -> &'static str {
    match error {
        Error::SinkageOutsideWheel { .. } => match sinkage {
            Sinkage::Given(_) => "/sinkage_m",
            Sinkage::FromStatic { .. } => "/static_sinkage_m",
            Sinkage::CarryingLoad(_) => "/normal_load_n",
        },
        Error::ModulusNotPositive { .. } => "/soil/pressure_sinkage",
        Error::ExponentNotPositive { .. } => "/soil/pressure_sinkage/n0",
        Error::PeakOutsideContact { .. } => "/contact",
        Error::ReversalOutsideContact { .. } | Error::ClosedFormOfTwoZones | Error::SlipAngleOfTwoZones => "/braking",
        Error::LoadNotCoupled { .. } => "/slip",
        Error::LoadBeyondCapacity { .. }
        | Error::LoadTooLight { .. }
        | Error::LoadNotBalanced { .. }
        | Error::NotFreeRolling { .. } => "/normal_load_n",
        Error::OppositeRotation { .. } => "/angular_velocity_rad_s",
        Error::NotFinite => "",
        Error::Invalid(fault) => match fault.parameter {
            Parameter::Slip => "/slip",
            Parameter::SlipAngle => "/slip_angle_rad",
            Parameter::NormalLoad => "/normal_load_n",
            Parameter::Torque => "/torque_n_m",
            Parameter::LambdaA => "/lambda_a",
            Parameter::LambdaB => "/lambda_b",
            _ => "",
        },
    }
}

/// A refusal of the model as a fault of the request.
pub(crate) fn error_fault(error: &Error, sinkage: &Sinkage) -> FieldFault {
    let pointer = error_pointer(error, sinkage).to_owned();
    let detail = match (error, sinkage) {
        (Error::SinkageOutsideWheel { .. }, Sinkage::FromStatic { .. }) => {
            format!("by the slip–sinkage law at this slip, {error}")
        }
        _ => error.to_string(),
    };
    FieldFault { pointer, detail }
}
