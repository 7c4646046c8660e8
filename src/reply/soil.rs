//! A soil and a contact as a request spells them out, so that what is answered can be sent back.

use serde::{Serialize, Serializer};
use terramechanics::{ContactParams, PeakRule, PressureSinkage, ShearLaw, SoilParams};

/// An object of a request: its fields by name, in order.
#[derive(Debug)]
pub(super) struct Spelled(Vec<(&'static str, Member)>);

#[derive(Debug)]
enum Member {
    Number(f64),
    Word(&'static str),
    Object(Spelled),
}

impl Serialize for Spelled {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, member)| (name, member)))
    }
}

impl Serialize for Member {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Number(value) => value.serialize(serializer),
            Self::Word(word) => word.serialize(serializer),
            Self::Object(object) => object.serialize(serializer),
        }
    }
}

/// A law or a rule under its tag, with those of its parameters that there are.
fn tagged<const N: usize>(tag: &'static str, name: &'static str, parameters: [(&'static str, Option<f64>); N]) -> Spelled {
    let parameters = parameters.into_iter().filter_map(|(name, value)| Some((name, Member::Number(value?))));
    Spelled([(tag, Member::Word(name))].into_iter().chain(parameters).collect())
}

/// A soil; without its pressure–sinkage law where that is not known.
pub(super) fn soil(soil: &SoilParams, law_known: bool) -> Spelled {
    let (modulus, shear) = match soil.shear {
        ShearLaw::JanosiHanamoto(law) => (Some(law.modulus), None),
        ShearLaw::WongResidual(law) => {
            let parameters = [("residual_ratio", Some(law.residual_ratio)), ("peak_displacement_m", Some(law.peak_displacement))];
            (None, Some(tagged("law", "wong_residual", parameters)))
        }
        ShearLaw::WongPeak(law) => {
            (None, Some(tagged("law", "wong_peak", [("peak_displacement_m", Some(law.peak_displacement))])))
        }
    };
    let members = [
        ("cohesion_pa", Some(Member::Number(soil.cohesion))),
        ("friction_angle_rad", Some(Member::Number(soil.friction_angle))),
        ("shear_modulus_m", modulus.map(Member::Number)),
        ("pressure_sinkage", law_known.then(|| Member::Object(pressure_sinkage(&soil.pressure_sinkage)))),
        ("shear", shear.map(Member::Object)),
        ("lateral_shear_modulus_m", soil.lateral_shear_modulus.map(Member::Number)),
        ("unit_weight_n_m3", soil.unit_weight.map(Member::Number)),
    ];
    Spelled(members.into_iter().filter_map(|(name, member)| Some((name, member?))).collect())
}

fn pressure_sinkage(law: &PressureSinkage) -> Spelled {
    let exponent = law.exponent();
    let (n0, n1, n2) = (("n0", Some(exponent.base)), ("n1", Some(exponent.slip_gain)), ("n2", exponent.skid_gain));
    match law {
        PressureSinkage::Bekker(law) => tagged("law", "bekker", [("k_c", Some(law.k_c)), ("k_phi", Some(law.k_phi)), n0, n1, n2]),
        PressureSinkage::Direct(law) => tagged("law", "direct", [("k_s", Some(law.k_s)), n0, n1, n2]),
        PressureSinkage::Reece(law) => {
            let moduli =
                [("k_c", Some(law.k_c)), ("k_phi", Some(law.k_phi)), ("unit_weight_n_m3", Some(law.unit_weight)), n0, n1, n2];
            tagged("law", "reece", moduli)
        }
        PressureSinkage::Diameter(law) => tagged("law", "diameter", [("k", Some(law.k)), ("m", Some(law.m)), n0, n1, n2]),
    }
}

/// Bekker's law with an exponent that does not change with slip.
pub(super) fn bekker(k_c: f64, k_phi: f64, n0: f64) -> Spelled {
    tagged("law", "bekker", [("k_c", Some(k_c)), ("k_phi", Some(k_phi)), ("n0", Some(n0))])
}

/// A contact.
pub(super) fn contact(contact: &ContactParams) -> Spelled {
    let c3 = ("c3", Some(contact.exit_ratio));
    match contact.rule {
        PeakRule::Midpoint => tagged("rule", "midpoint", [c3]),
        PeakRule::WongReece { c1, c2 } => tagged("rule", "wong_reece", [("c1", Some(c1)), ("c2", Some(c2)), c3]),
        PeakRule::HalfSinkage => tagged("rule", "half_sinkage", [c3]),
    }
}
