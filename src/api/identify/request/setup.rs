//! The forward model of a fit: what is known of it, and the starts of what is fitted.

use terramechanics::{
    Contact, ContactParams, ForceModel, Method, PeakRule, SlipSinkage, Soil, SoilParams, Wheel, WheelOnSoil, WongReece,
};
use terramechanics_identification::{Home, Setup, SinkageSource, Unknown};
use terramechanics_reading::Reader;

use super::data::{DATA, LOAD, NORMAL, SINKAGE};
use super::{PARTIAL_SOIL, SLIP_SINKAGE_OF_FIT};
use crate::request::circles;
use crate::request::fitted_law;
use crate::request::method::{self, NORMAL_STRESS_RADIUS, PEAK_SINKAGE};
use crate::request::sinkage;
use crate::request::soil::{self, FoundSoil, LawOrigin, Needs};
use crate::request::system::{self, CONTACT};
use crate::request::unknowns::{self, By};
use crate::request::unused::{Reads, Unused};

/// What is sought, and where from.
pub(super) struct Sought<'a> {
    pub(super) fitted: &'a [Unknown],
    pub(super) starts: &'a By<f64>,
    /// Whether the pressure–sinkage law has an influence.
    pub(super) needs_law: bool,
}

impl Sought<'_> {
    fn start(&self, unknown: Unknown) -> f64 {
        unknowns::of(self.starts, unknown).unwrap_or(unknown.typical())
    }

    fn has(&self, unknown: Unknown) -> bool {
        self.fitted.contains(&unknown)
    }
}

/// A range that was measured of what is fitted, on the soil that the request names.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Measured {
    pub(crate) unknown: Unknown,
    pub(crate) preset: &'static str,
    pub(crate) range: [f64; 2],
}

/// A forward model as far as it could be read.
pub(super) struct Found {
    pub(super) setup: Option<Setup>,
    pub(super) wheel: Option<Wheel>,
    pub(super) law: Option<LawOrigin>,
    pub(super) measured: Vec<Measured>,
    /// What was sent and is not read.
    pub(super) unused: Unused,
}

/// The forward model, with starts for what is fitted and known nowhere.
pub(super) fn read(object: &Reader<'_>, sought: &Sought<'_>, data: Option<&Reader<'_>>) -> Found {
    let start_of = |name: &str| {
        let unknown = sought.fitted.iter().copied().find(|&unknown| unknown.name() == name)?;
        Some(sought.start(unknown))
    };
    let peak_depth = object.optional(&PEAK_SINKAGE);
    let method = method::read_fitted(object, peak_depth.flatten());
    // Under a load that is known the closed forms take nothing of the law.
    let cancels = data.is_some_and(|data| data.has(&LOAD)) && method.is_some_and(|method| method.is_closed_form());
    let by_grains = method == Some(Method::ResistiveForce);
    let needs = if by_grains {
        Needs { fitted: &start_of, ..Needs::GRAINS }
    } else {
        Needs { pressure_sinkage: sought.needs_law && !cancels, fitted: &start_of, ..Needs::ALL }
    };
    let wheel = system::read_wheel(object);
    let lacking = if by_grains { lacking_of_grains(sought) } else { lacking(sought, cancels) };
    let soil = read_soil(object, &lacking, needs);
    let contact = system::read_contact(object, soil.as_ref(), circles::read(object), needs);
    let normal_stress_radius = object.or_default(&NORMAL_STRESS_RADIUS);
    let source = sinkage_source(object, sought, data);
    let setup = || {
        peak_depth?;
        Some(Setup {
            wheel: wheel?,
            soil: *soil?.soil.params(),
            contact: with_interface(contact_params(object, &contact?, sought), soil?.soil.params(), sought),
            model: ForceModel { method: method?, normal_stress_radius: normal_stress_radius? },
            sinkage: source?,
        })
    };
    let reads = |method: &Method| match sought.needs_law {
        true => Reads::by(method, source == Some(SinkageSource::UnderLoad)),
        // What the linear estimator has no use for, it refuses.
        false => Reads::STRESSES,
    };
    let unused = || {
        let system = WheelOnSoil { wheel: wheel?, soil: soil?.soil, contact: contact? };
        Some(Unused::of(object, reads(&method?), &system))
    };
    let measured = |&unknown: &Unknown| {
        let (preset, range) = soil?.measured(unknown.name())?;
        Some(Measured { unknown, preset, range })
    };
    Found {
        setup: setup(),
        wheel,
        law: soil.map(|soil| soil.law),
        measured: sought.fitted.iter().filter_map(measured).collect(),
        unused: unused().unwrap_or_default(),
    }
}

/// The soil; one of which nothing is said has to be fitted as a whole.
fn read_soil(object: &Reader<'_>, lacking: &[String], needs: Needs<'_>) -> Option<FoundSoil> {
    if !object.has(&PARTIAL_SOIL) && !lacking.is_empty() {
        let lacking = lacking.join(", ");
        let place = object.place_of(&PARTIAL_SOIL);
        place.fault(format_args!("a soil is needed: neither given nor fitted are {lacking}"));
        return None;
    }
    soil::read(&object.or_empty(&PARTIAL_SOIL)?, needs)
}

/// The contact; where c1 or c2 is fitted and nothing was said of the contact, it follows Wong & Reece's rule.
fn contact_params(object: &Reader<'_>, contact: &Contact, sought: &Sought<'_>) -> ContactParams {
    let params = *contact.params();
    let (c1, c2) = (Unknown::PEAK_INTERCEPT, Unknown::PEAK_SLIP_GAIN);
    match params.rule {
        PeakRule::Midpoint | PeakRule::HalfSinkage if (sought.has(c1) || sought.has(c2)) && !object.has(&CONTACT) => {
            let c2 = if sought.has(c2) { sought.start(c2) } else { 0.0 };
            let c1 = if sought.has(c1) { sought.start(c1) } else { 0.5 };
            ContactParams { rule: PeakRule::WongReece(WongReece { c1, c2 }), ..params }
        }
        _ => params,
    }
}

/// The contact with an interface that has what is fitted of one. It starts at what was sent, else at a usual value that the soil allows.
fn with_interface(params: ContactParams, soil: &SoilParams, sought: &Sought<'_>) -> ContactParams {
    let of_interface = sought.fitted.iter().copied().filter(|unknown| unknown.home() == Home::Interface);
    let interface = of_interface.fold(params.interface, |interface, unknown| {
        let most = match unknown {
            Unknown::INTERFACE_FRICTION_ANGLE => soil.friction_angle,
            Unknown::INTERFACE_ADHESION => soil.cohesion,
            _ => f64::INFINITY,
        };
        let known = interface.and_then(|interface| interface.fitted(unknown.name()));
        let start = unknowns::of(sought.starts, unknown).or(known).unwrap_or_else(|| unknown.typical().min(most));
        Some(interface.unwrap_or_default().with_fitted(unknown.name(), start))
    });
    ContactParams { interface, ..params }
}

/// Where the sinkage of a sample comes from.
fn sinkage_source(object: &Reader<'_>, sought: &Sought<'_>, data: Option<&Reader<'_>>) -> Option<SinkageSource> {
    let is_static = sought.has(Unknown::STATIC_SINKAGE);
    let law: Option<SlipSinkage> = sinkage::law(object);
    if object.has(&SLIP_SINKAGE_OF_FIT) && !is_static {
        object.place_of(&SLIP_SINKAGE_OF_FIT).fault("needs `static_sinkage_m` among the parameters of `fit`");
        return None;
    }
    let data = data?;
    if is_static {
        if data.has(&LOAD) {
            data.place_of(&LOAD).fault("is not taken beside a static sinkage that is fitted; give it as `normal_force_n`");
            return None;
        }
        Some(SinkageSource::Static { static_sinkage: sought.start(Unknown::STATIC_SINKAGE), law: law? })
    } else if data.has(&LOAD) {
        Some(SinkageSource::UnderLoad)
    } else if data.has(&SINKAGE) {
        Some(SinkageSource::Measured)
    } else if data.has(&NORMAL) {
        Some(SinkageSource::Load)
    } else {
        object.place_of(&DATA).fault("needs `sinkage_m`, or `normal_force_n` as the load");
        None
    }
}

/// What dry grains have besides the parameters.
fn lacking_of_grains(sought: &Sought<'_>) -> Vec<String> {
    if sought.has(Unknown::GRANULAR_STIFFNESS) {
        return Vec::new();
    }
    let friction = Some(Unknown::FRICTION_ANGLE.name()).filter(|_| !sought.has(Unknown::FRICTION_ANGLE));
    friction.into_iter().chain([Soil::BULK_DENSITY.name]).map(str::to_owned).collect()
}

/// What a soil has besides the parameters, of a law that `cancels` nothing.
fn lacking(sought: &Sought<'_>, cancels: bool) -> Vec<String> {
    use Unknown as U;
    let alone = [U::COHESION, U::FRICTION_ANGLE, U::SHEAR_MODULUS, U::BASE_EXPONENT];
    let alone = alone
        .into_iter()
        .filter(|&unknown| !(sought.has(unknown) || cancels && unknown == U::BASE_EXPONENT))
        .map(|unknown| unknown.name().to_owned());
    let is_fitted = |name: &str| sought.fitted.iter().any(|unknown| unknown.name() == name);
    alone.chain(fitted_law::lacking(is_fitted).filter(|_| !cancels)).collect()
}
