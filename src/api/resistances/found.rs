//! The classical estimates.

use terramechanics::{Resistances, Sinkage};

use super::request::ResistancesCase;
use crate::problem::Problem;
use crate::warning::{Finding, Warning, of_system};

/// The estimates that there are.
pub(crate) struct FoundResistances {
    pub(crate) estimates: Resistances,
    pub(crate) warnings: Vec<Warning>,
}

/// Bekker's estimates for a wheel under its load.
///
/// # Errors
/// What the model refuses.
pub(crate) fn resistances(case: &ResistancesCase) -> Result<FoundResistances, Problem> {
    let ResistancesCase { system, normal_load, slip } = case;
    let sinkage = Sinkage::CarryingLoad(*normal_load);
    let estimates = Resistances::of(system, *normal_load, *slip).map_err(|error| Problem::refused(&error, &sinkage))?;
    let Resistances { rigid_wheel_sinkage, compaction, bulldozing, thrust } = estimates;
    let lacking = [
        ("rigid_wheel_sinkage_m", rigid_wheel_sinkage),
        ("compaction_resistance_n", compaction),
        ("bulldozing_resistance_n", bulldozing),
        ("thrust_n", thrust),
    ];
    let mut warnings: Vec<Warning> = estimates.cautions(system, *slip).map(Warning::from).collect();
    warnings.extend(of_system(system));
    warnings.extend(lacking.iter().filter_map(|(name, of)| Some(Finding::lacking(name, of.as_ref().err()?).into())));
    Ok(FoundResistances { estimates, warnings })
}
