//! The laws that a fit can make whole: which moduli each takes, and which law has a modulus.

use terramechanics::{Declared, Direct, Law, Parameter, PeakRule, PressureSinkage, ShearLaw};
use terramechanics_identification::{Home, Setup, Unknown};

use crate::catalogue::is_of_exponent;

/// The pressure–sinkage laws, that with the modulus itself first: a soil has one sinkage modulus.
pub(crate) fn laws() -> impl Iterator<Item = &'static Law<PressureSinkage>> {
    let direct = PressureSinkage::named(Direct::NAME);
    let others = PressureSinkage::LAWS.iter().filter(move |law| direct.is_none_or(|direct| direct.name != law.name));
    direct.into_iter().chain(others)
}

/// The moduli that a law needs, where all of them can be fitted.
fn moduli(law: &'static Law<PressureSinkage>) -> Option<Vec<&'static str>> {
    let required = law.parameters.iter().filter(|parameter| parameter.is_required() && !is_of_exponent(parameter.name));
    let is_fittable = |parameter: &Parameter| law.fittable.iter().any(|fittable| fittable.parameter.name == parameter.name);
    required.map(|parameter| is_fittable(parameter).then_some(parameter.name)).collect()
}

/// The moduli that no law is whole without, in words; none where a law has all of its own among those that are fitted.
pub(crate) fn lacking(is_fitted: impl Fn(&str) -> bool) -> Option<String> {
    let all: Vec<Vec<&str>> = laws().filter_map(moduli).collect();
    if all.iter().any(|moduli| moduli.iter().all(|name| is_fitted(name))) {
        return None;
    }
    if let Some(begun) = all.iter().find(|moduli| moduli.iter().any(|name| is_fitted(name))) {
        return Some(begun.iter().copied().filter(|name| !is_fitted(name)).collect::<Vec<_>>().join(", "));
    }
    let all: Vec<String> = all.iter().map(|moduli| moduli.join(" and ")).collect();
    let (first, others) = all.split_first()?;
    Some(format!("{first} (or {})", others.join(", or ")))
}

/// The names of the laws of a family that have the unknown.
fn having<F>(laws: &'static [Law<F>], unknown: Unknown) -> Vec<String> {
    let has = |law: &&Law<F>| law.fittable.iter().any(|fittable| fittable.parameter.name == unknown.name());
    laws.iter().filter(has).map(|law| format!("`{}`", law.name)).collect()
}

/// Where an unknown belongs that the setup does not have, for a message.
pub(crate) fn home_of(unknown: Unknown, setup: &Setup) -> String {
    let has_it = |what: &str, laws: Vec<String>| format!("; the {what} {} has it", laws.join(" or "));
    match unknown.home() {
        Home::PressureSinkage => {
            let own = setup.soil.pressure_sinkage.iter().flat_map(|law| law.law().fittable);
            let own: Vec<String> =
                own.map(|own| own.parameter.name).filter(|name| !is_of_exponent(name)).map(|name| format!("`{name}`")).collect();
            let fit = if own.is_empty() { String::new() } else { format!("fit {}, or ", own.join(" and ")) };
            format!(": {fit}choose the law {}", having(PressureSinkage::LAWS, unknown).join(" or "))
        }
        Home::Shear => has_it("shear law", having(ShearLaw::LAWS, unknown)),
        Home::Rule => has_it("contact rule", having(PeakRule::LAWS, unknown)),
        Home::Method => "; the method `explicit` with a number for it has it".to_owned(),
        Home::Soil | Home::Interface | Home::Sinkage => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moduli_that_make_no_law_whole_are_named() {
        let of = |fitted: &'static [&'static str]| lacking(|name| fitted.contains(&name));
        assert!(of(&[]).is_some_and(|moduli| moduli.starts_with("k_s (or k_c and k_phi")));
        assert_eq!(of(&["k_c"]).as_deref(), Some("k_phi"));
        assert_eq!(of(&["k_phi"]).as_deref(), Some("k_c"));
        assert_eq!((of(&["k_s"]), of(&["k_c", "k_phi"]), of(&["k_s", "k_c"])), (None, None, None));
    }
}
