//! Operations that answer one JSON body with another.

use serde::Serialize;

use super::Refused;
use crate::api::compare::CompareCase;
use crate::api::coupled::CoupledCase;
use crate::api::curves::plates::PlatesCase;
use crate::api::curves::shear::ShearTestsCase;
use crate::api::forces::ForcesCase;
use crate::api::identify::IdentifyCase;
use crate::api::optimum::OptimumCase;
use crate::api::resistances::ResistancesCase;
use crate::api::room::Room;
use crate::api::slip_sweep::SweepCase;
use crate::api::stress_profile::ProfileCase;
use crate::api::sweep::request::GridCase;
use crate::api::towed::TowedCase;
use crate::api::uncertainty::UncertaintyCase;
use crate::api::vehicle::VehicleCase;
use crate::compute::Pace;
use crate::extract::read;
use crate::problem::Problem;
use crate::reply::Assuming;
use crate::request::Accepted;

/// What an operation makes of a body.
type Answer = fn(&[u8]) -> Result<Vec<u8>, Problem>;

/// The operations, by their paths behind `/v1/`.
const OPERATIONS: [(&str, Answer); 14] = [
    ("forces", of_room::<ForcesCase>),
    ("stress-profile", of_room::<ProfileCase>),
    ("slip-sweep", of_room::<SweepCase>),
    ("sweep", of_grid),
    ("uncertainty", of_room::<UncertaintyCase>),
    ("optimum", of_room::<OptimumCase>),
    ("compare", of_room::<CompareCase>),
    ("coupled", of_room::<CoupledCase>),
    ("resistances", of_room::<ResistancesCase>),
    ("towed", of_room::<TowedCase>),
    ("vehicle", of_room::<VehicleCase>),
    ("identify", of_room::<IdentifyCase>),
    ("identify/plates", of_room::<PlatesCase>),
    ("identify/shear", of_room::<ShearTestsCase>),
];

/// The names of the operations, in the order of the contract.
pub fn operations() -> impl Iterator<Item = &'static str> {
    OPERATIONS.iter().map(|(name, _)| *name)
}

/// The answer of an operation to a JSON body, as JSON: byte for byte that of the service. It takes the time that it takes.
///
/// # Errors
/// The problem of the service; that there is no such operation is one, too.
pub fn answer(operation: &str, body: &[u8]) -> Result<Vec<u8>, Refused> {
    let found = OPERATIONS.iter().find(|(name, _)| *name == operation);
    let (_, answer) = found.ok_or_else(|| Problem::NotFound(format!("no such operation: {operation}")))?;
    Ok(answer(body)?)
}

fn of_room<R: Room>(body: &[u8]) -> Result<Vec<u8>, Problem> {
    let Accepted { case, assumed } = read::<R>(body)?;
    let reply = case.reply_or_hints(&Pace::at_once())?;
    Ok(match assumed {
        None => written(&reply),
        Some(assumed) => written(&Assuming::of(reply, assumed)),
    })
}

fn of_grid(body: &[u8]) -> Result<Vec<u8>, Problem> {
    let case = read::<GridCase>(body)?.case;
    case.fits_in_columns()?;
    Ok(written(&case.reply(&Pace::at_once())?))
}

fn written<T: Serialize>(reply: &T) -> Vec<u8> {
    serde_json::to_vec(reply).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::*;

    /// A track is followed sample by sample, and is no request with one answer.
    const OTHERS: [&str; 1] = ["track"];

    #[test]
    fn every_operation_that_answers_a_json_body_is_here() {
        let contract: Value = serde_json::from_str(&crate::contract().pretty_text()).expect("JSON");
        let paths = contract["paths"].as_object().expect("paths");
        let takes_json = |item: &Value| item["post"]["requestBody"]["content"]["application/json"].is_object();
        let of_contract = paths.iter().filter(|(_, item)| takes_json(item)).filter_map(|(path, _)| path.strip_prefix("/v1/"));
        let mut of_contract: Vec<&str> = of_contract.filter(|name| !OTHERS.contains(name)).collect();
        let mut here: Vec<&str> = operations().collect();
        of_contract.sort_unstable();
        here.sort_unstable();
        assert_eq!(here, of_contract);
    }
}
