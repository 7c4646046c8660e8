//! What the soils of the catalogue have of a parameter of a law, for comparisons of size.

use terramechanics::{Bekker, Declared, Direct, Law, Parameter, Parametrised, PressureSinkage, SinkageExponent};

use super::SoilRecord;

/// Whether a parameter is of the exponent, which every law has.
pub(crate) fn is_of_exponent(name: &str) -> bool {
    SinkageExponent::PARAMETERS.iter().any(|parameter| parameter.name == name)
}

/// The size of the value that a soil of that law has. Few soils have a modulus K_s as it is; Bekker's K_s = k_c/b + k_phi, of which
/// k_phi is the larger part, is the same in the same unit.
pub(crate) fn size(record: &SoilRecord, law: &Law<PressureSinkage>, of: &Parameter) -> Option<f64> {
    let own = record.law.as_deref()?;
    let name = match of.name {
        name if own == law.name => name,
        name if law.name == Direct::NAME && own == Bekker::NAME => {
            if name == Direct::K_S.name {
                Bekker::K_PHI.name
            } else {
                name
            }
        }
        _ => return None,
    };
    record.number(name).map(f64::abs)
}
