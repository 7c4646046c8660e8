//! A rover on its slopes.

use terramechanics::{Caution, Circles, LargestSlope, OnSlope, SlopeLimit, UnlikeRut, Vehicle, VehicleError};

use super::refusal;
use super::request::{Slopes, VehicleCase, word};
use crate::compute::Pace;
use crate::problem::Problem;
use crate::reply::method_name;
use crate::request::circles::Counted;
use crate::warning::{Finding, RowCautions, Rows, Warning, of_system};

/// A slope, and the rover on it unless it has no answer there.
pub(crate) struct FoundSlope {
    pub(crate) slope: f64,
    pub(crate) needed_pull: f64,
    pub(crate) climbs: bool,
    pub(crate) on: Result<OnSlope, VehicleError>,
}

/// A rover on its slopes.
pub(crate) struct FoundVehicle {
    pub(crate) is_one: bool,
    pub(crate) slopes: Vec<FoundSlope>,
    /// The largest slope (rad), if there is one.
    pub(crate) largest: Option<f64>,
    pub(crate) gravity: f64,
    pub(crate) method: &'static str,
    pub(crate) circles: Counted,
    pub(crate) drive: &'static str,
    pub(crate) has_statics: bool,
    pub(crate) velocity: Option<f64>,
    /// Place and number of the wheels of each station.
    pub(crate) stations: Vec<(Option<f64>, u32)>,
    pub(crate) warnings: Vec<Warning>,
}

/// The rover on each slope, and the largest slope.
///
/// # Errors
/// What the model refuses of a rover on one slope, unless it just does not climb that; or that the work is to end.
pub(crate) fn vehicle(case: &VehicleCase, pace: &Pace) -> Result<FoundVehicle, Problem> {
    let VehicleCase { vehicle, have_own_soil, unused, slopes, hitch_pull, slip_limit, velocity } = case;
    let is_one = matches!(slopes, Slopes::One(_));
    let mut found = Vec::with_capacity(slopes.len());
    for &slope in slopes.as_slice() {
        let on = vehicle.on_slope_while(slope, *hitch_pull, &|| pace.goes_on());
        pace.look()?;
        if let (true, Err(error)) = (is_one, &on)
            && !matches!(error, VehicleError::NotClimbed { .. })
        {
            return Err(Problem::Invalid(vec![refusal::fault(error, have_own_soil)]));
        }
        let climbs = on.as_ref().is_ok_and(|on| on.driven.slip.ratio() <= *slip_limit);
        found.push(FoundSlope { slope, needed_pull: vehicle.needed_pull(slope, *hitch_pull), climbs, on });
    }
    let largest = vehicle.largest_slope_while(*hitch_pull, *slip_limit, &|| pace.goes_on());
    pace.look()?;
    let mut warnings = of_slopes(&found, *slip_limit);
    warnings.extend(of_largest(&largest));
    warnings.extend(cautions(vehicle, &found));
    warnings.extend(of_systems(vehicle));
    warnings.extend(of_ruts(vehicle).map(Warning::from));
    warnings.extend(unused.warning());
    let params = vehicle.params();
    let circles = params.stations.first().map_or(Circles::SHEARING, |station| station.system.contact.circles());
    Ok(FoundVehicle {
        is_one,
        slopes: found,
        largest: largest.ok().map(|largest| largest.slope),
        gravity: params.gravity,
        method: method_name(&params.model.method),
        circles: Counted::by(&params.model.method, circles),
        drive: word(params.drive),
        has_statics: vehicle.has_statics(),
        velocity: *velocity,
        stations: params.stations.iter().map(|station| (station.position, station.count)).collect(),
        warnings,
    })
}

/// The warnings of the slopes without an answer or with more slip than the limit: of each kind one, with the reason of the first.
fn of_slopes(slopes: &[FoundSlope], slip_limit: f64) -> Vec<Warning> {
    let mut kinds: Vec<(Finding, Vec<usize>)> = Vec::new();
    for (row, FoundSlope { climbs, on, .. }) in slopes.iter().enumerate() {
        let finding = match on {
            Err(error) => refusal::finding(error),
            Ok(on) if !climbs => Finding::SlipBeyondLimit { slip: on.driven.slip.ratio(), limit: slip_limit },
            Ok(_) => continue,
        };
        match kinds.iter_mut().find(|(known, _)| known.code() == finding.code()) {
            Some((_, rows)) => rows.push(row),
            None => kinds.push((finding, vec![row])),
        }
    }
    let all = slopes.len();
    let warning = |(finding, rows): (Finding, Vec<usize>)| {
        let warning = Warning::from(finding);
        if all == 1 { warning } else { warning.at(Rows::of(&rows)) }
    };
    kinds.into_iter().map(warning).collect()
}

/// What is to be said of the largest slope.
fn of_largest(largest: &Result<LargestSlope, VehicleError>) -> Option<Warning> {
    let finding = match largest {
        Ok(LargestSlope { limit: SlopeLimit::Pull, .. }) => return None,
        Ok(LargestSlope { limit: SlopeLimit::Wheel(error), .. }) => Finding::ClimbEndsByWheel { reason: error.to_string() },
        Ok(LargestSlope { slope, limit: SlopeLimit::Nothing }) => Finding::ClimbsEverything { slope: *slope },
        Err(error) => Finding::NoLargestSlope { reason: error.to_string() },
    };
    Some(finding.into())
}

/// The cautions of all wheels: of each kind the one that is furthest out, with the rows in which a wheel has it.
fn cautions(vehicle: &Vehicle, slopes: &[FoundSlope]) -> impl Iterator<Item = Warning> + use<> {
    let mut rows = RowCautions::default();
    for (row, on) in slopes.iter().enumerate().filter_map(|(row, slope)| Some((row, slope.on.as_ref().ok()?))) {
        let mut of_row: Vec<Caution> = Vec::new();
        for (_, caution) in vehicle.cautions(&on.driven) {
            match of_row.iter_mut().find(|known| std::ptr::eq(known.kind, caution.kind)) {
                Some(known) if caution.excess() > known.excess() => *known = caution,
                Some(_) => {}
                None => of_row.push(caution),
            }
        }
        rows.add(row, of_row.into_iter());
    }
    rows.into_warnings(slopes.len())
}

/// What is to be said of ruts that are taken for others than they are.
pub(super) fn of_ruts(vehicle: &Vehicle) -> impl Iterator<Item = Finding> {
    let stations = |is_meant: fn(&UnlikeRut) -> bool| {
        let ruts = vehicle.unlike_ruts().filter(is_meant).map(|rut| (rut.station, rut.before));
        Some(ruts.collect::<Vec<_>>()).filter(|stations| !stations.is_empty())
    };
    let ratio = vehicle.unlike_ruts().map(|rut| rut.width_ratio).fold(1.0, f64::max);
    let narrow = stations(|rut| rut.width_ratio > 1.0).map(|stations| Finding::RutTooNarrow { stations, ratio });
    let other = stations(|rut| rut.of_other_soil).map(|stations| Finding::RutOfOtherSoil { stations });
    narrow.into_iter().chain(other)
}

/// What is to be said of the wheels and soils themselves, once.
pub(super) fn of_systems(vehicle: &Vehicle) -> Vec<Warning> {
    let mut warnings: Vec<Warning> = Vec::new();
    for warning in vehicle.params().stations.iter().flat_map(|station| of_system(&station.system)) {
        if !warnings.contains(&warning) {
            warnings.push(warning);
        }
    }
    warnings
}
