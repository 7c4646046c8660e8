//! What the model finds for a checked request: its numbers and what is to be said of them. Here everything is computed; an
//! answer is then only another form of what was found.

mod compare;
mod coupled;
mod curves;
mod forces;
mod identify;
mod profile;
mod resistances;
mod sweep;
mod towed;
mod track;
mod validation;

pub(crate) use compare::{FoundComparison, FoundVariant, compare};
pub(crate) use coupled::{FoundCoupled, coupled};
pub(crate) use curves::{FoundPlates, FoundShear, plates, shear};
pub(crate) use forces::{FoundForces, forces};
pub(crate) use identify::{FoundFit, FoundLine, FoundParameters, identify};
pub(crate) use profile::{FoundProfile, profile};
pub(crate) use resistances::{FoundResistances, resistances};
pub(crate) use sweep::{FoundSweep, sweep};
pub(crate) use towed::{FoundTowed, towed};
pub(crate) use track::FoundTrack;
pub(crate) use validation::{FoundSet, validation};

use terramechanics::{Caution, Heading, WheelOnSoil};

use crate::warning::{Finding, Warning, system_warnings};

/// What is to be said of one operating point: the cautions, what is far from the catalogue, and that the wheel moves backwards.
fn of_point(cautions: impl Iterator<Item = Caution>, system: &WheelOnSoil, heading: Heading) -> Vec<Warning> {
    let mirrored = (heading == Heading::Backward).then(|| Warning::from(Finding::Mirrored {}));
    cautions.map(Warning::from).chain(of_system(system)).chain(mirrored).collect()
}

/// What is to be said of a wheel on a soil, wherever it is.
fn of_system(system: &WheelOnSoil) -> impl Iterator<Item = Warning> + use<> {
    system_warnings(&system.wheel, system.soil.params())
}
