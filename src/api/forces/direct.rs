//! An operating point with other numbers, without reading its request anew.
//!
//! Only numbers that stand for themselves are set: what follows from several fields of a request, such as the slip from velocities,
//! is left to the reading of the request, and so is whatever is refused, which the reading puts into words.

use terramechanics::{
    AngleRatio, Contact, ContactParams, ExitRule, KnownSinkage, Method, Motion, Operation, Parametrised, ShearLaw, Sinkage, Slip,
    Soil, SoilParams, Wheel, WheelOnSoil, WheelParams,
};
use terramechanics_reading::Path;

use super::request::ForcesCase;
use crate::request::pull::SlipFrom;
use crate::varied::{IsSent, Part, Setter, names};

/// Fields of a soil that stand for themselves; a gravity takes other values along, and so may a density.
const OF_SOIL: [&str; 3] = ["cohesion_pa", "friction_angle_rad", "lateral_shear_modulus_m"];

/// Fields that make others follow from several.
const MIXING: [&[&str]; 5] = [
    &["forward_velocity_m_s"],
    &["angular_velocity_rad_s"],
    &["soil", "gravity_m_s2"],
    &["soil", "bulk_density_kg_m3"],
    &["soil", "granular_stiffness_n_m3"],
];

/// The setters of the fields under `paths` in a case of a request; none where one of them does not stand for itself.
pub(super) fn setters(case: &ForcesCase, paths: &[Path], is_sent: IsSent<'_>) -> Option<Vec<Setter>> {
    if case.operation.model.method == Method::ResistiveForce || MIXING.iter().any(|path| is_sent(path)) {
        return None;
    }
    paths.iter().map(|path| setter(case, &names(path))).collect()
}

fn setter(case: &ForcesCase, names: &[&str]) -> Option<Setter> {
    let Operation { system, sinkage, .. } = &case.operation;
    let (soil, contact) = (&system.soil, system.contact.params());
    let operating = |part: Part, name: &str| Setter::of(part, name, WheelOnSoil::PARAMETERS);
    match *names {
        ["wheel", name] => Setter::of(Part::Wheel, name, WheelParams::PARAMETERS),
        ["soil", "shear_modulus_m"] => match soil.shear()? {
            law @ ShearLaw::JanosiHanamoto(_) => Setter::of(Part::Shear, "shear_modulus_m", law.law().parameters),
            ShearLaw::WongResidual(_) | ShearLaw::WongPeak(_) => None,
        },
        ["soil", name] => Setter::of(Part::Soil, name, Soil::PARAMETERS).filter(|_| OF_SOIL.contains(&name)),
        ["soil", "pressure_sinkage", name] => Setter::of(Part::PressureSinkage, name, soil.pressure_sinkage()?.law().parameters),
        ["soil", "shear", name] => Setter::of(Part::Shear, name, soil.shear()?.law().parameters),
        ["contact", name] => match contact.exit {
            ExitRule::AngleRatio(_) if name == AngleRatio::C3.name => Setter::of(Part::Exit, name, AngleRatio::PARAMETERS),
            _ => Setter::of(Part::Rule, name, contact.rule.law().parameters),
        },
        ["slip"] => matches!(case.slip, SlipFrom::Motion(_)).then(|| Setter::of(Part::Slip, "slip", &[Slip::RATIO]))?,
        [name @ "sinkage_m"] => operating(Part::Sinkage, name),
        [name @ "static_sinkage_m"] => operating(Part::StaticSinkage, name),
        [name @ "normal_load_n"] => sinkage.load().and_then(|_| operating(Part::NormalLoad, name)),
        _ => None,
    }
}

/// The values of a law with one in place of its own.
fn with(mut values: Vec<Option<f64>>, place: usize, value: f64) -> Option<Vec<Option<f64>>> {
    *values.get_mut(place)? = Some(value);
    Some(values)
}

/// Gives the case other numbers in place; none where a request with them would be refused, or might be.
pub(super) fn set_numbers(case: &mut ForcesCase, setters: &[Setter], values: &[f64]) -> Option<()> {
    let ForcesCase { operation: Operation { system, sinkage, .. }, slip, unused: _ } = case;
    let (mut wheel, mut soil, mut contact) = (*system.wheel.params(), *system.soil.params(), *system.contact.params());
    let (mut new_wheel, mut new_soil, mut new_contact) = (false, false, false);
    for (setter, &value) in setters.iter().zip(values) {
        if !setter.allows(value) {
            return None;
        }
        match setter.part {
            Part::Wheel => {
                wheel = WheelParams::from_values(&with(wheel.values(), setter.place, value)?)?;
                new_wheel = true;
            }
            Part::Soil => {
                let mut values = soil.values();
                *values.get_mut(setter.place)? = Some(value);
                let SoilParams { shear, pressure_sinkage, exponent_alone, .. } = soil;
                soil = SoilParams { shear, pressure_sinkage, exponent_alone, ..SoilParams::from_values(values)? };
                new_soil = true;
            }
            Part::PressureSinkage => {
                let law = soil.pressure_sinkage?;
                soil.pressure_sinkage = Some(law.law().from_values(&with(law.values(), setter.place, value)?).ok()?);
                new_soil = true;
            }
            Part::Shear => {
                let law = soil.shear?;
                soil.shear = Some(law.law().from_values(&with(law.values(), setter.place, value)?).ok()?);
                new_soil = true;
            }
            Part::Rule => {
                let rule = contact.rule;
                let rule = rule.law().from_values(&with(rule.values(), setter.place, value)?).ok()?;
                contact = ContactParams { rule, ..contact };
                new_contact = true;
            }
            Part::Exit => {
                contact.exit = ExitRule::AngleRatio(AngleRatio { c3: value });
                new_contact = true;
            }
            Part::Slip => *slip = SlipFrom::Motion(Motion::forward(Slip::new(value).ok()?)),
            Part::Sinkage | Part::StaticSinkage | Part::NormalLoad => *sinkage = with_sinkage(*sinkage, setter.part, value)?,
        }
    }
    if new_wheel {
        system.wheel = with_dimensions(&system.wheel, wheel)?;
    }
    if new_soil {
        system.soil = with_params(&system.soil, soil)?;
    }
    if new_contact {
        system.contact = Contact::new(contact).ok()?.with_braking(system.contact.braking());
    }
    let given = match *sinkage {
        Sinkage::Given(given) | Sinkage::UnderLoad { sinkage: KnownSinkage::Given(given), .. } => Some(given),
        Sinkage::FromStatic { .. } | Sinkage::CarryingLoad(_) | Sinkage::UnderLoad { .. } => None,
    };
    given.is_none_or(|given| given <= system.wheel.radius()).then_some(())
}

/// The wheel with other dimensions; that its lug height is not known is remembered.
fn with_dimensions(own: &Wheel, params: WheelParams) -> Option<Wheel> {
    let wheel = Wheel::new(params).ok()?;
    Some(if own.lug_height_is_assumed() { wheel.with_unknown_lug_height() } else { wheel })
}

/// The soil with other parameters, and what is remembered of its measurement.
fn with_params(own: &Soil, params: SoilParams) -> Option<Soil> {
    let soil = Soil::new(params).ok()?;
    let soil = own.largest_fitted_slip().map_or(soil, |slip| soil.fitted_up_to(slip));
    Some(own.measured_gravity().map_or(soil, |gravity| soil.measured_in(gravity)))
}

/// The sinkage or the load in place of that of the same kind.
fn with_sinkage(sinkage: Sinkage, part: Part, value: f64) -> Option<Sinkage> {
    let known = |known: KnownSinkage| match (part, known) {
        (Part::Sinkage, KnownSinkage::Given(_)) => Some(KnownSinkage::Given(value)),
        (Part::StaticSinkage, KnownSinkage::FromStatic { law, .. }) => {
            Some(KnownSinkage::FromStatic { static_sinkage: value, law })
        }
        _ => None,
    };
    match (part, sinkage) {
        (Part::Sinkage, Sinkage::Given(_)) => Some(Sinkage::Given(value)),
        (Part::StaticSinkage, Sinkage::FromStatic { law, .. }) => Some(Sinkage::FromStatic { static_sinkage: value, law }),
        (Part::NormalLoad, Sinkage::CarryingLoad(_)) => Some(Sinkage::CarryingLoad(value)),
        (Part::NormalLoad, Sinkage::UnderLoad { sinkage, .. }) => Some(Sinkage::UnderLoad { sinkage, load: value }),
        (_, Sinkage::UnderLoad { sinkage, load }) => Some(Sinkage::UnderLoad { sinkage: known(sinkage)?, load }),
        _ => None,
    }
}
