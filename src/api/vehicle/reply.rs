//! The answer of `/v1/vehicle`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics::{Driven, VehicleWheel};
use utoipa::ToSchema;

use super::found::{FoundSlope, FoundVehicle};
use crate::quantity::{About, Columns, Field, Shape, Values};
use crate::reply::{Reply, or_null};
use crate::request::circles::words;
use crate::warning::Warning;

/// A rover on one slope, with each of its wheels, or on several, in columns.
#[derive(Debug, Serialize, ToSchema)]
#[serde(untagged)]
#[schema(as = Vehicle)]
pub(crate) enum VehicleReply {
    One(Box<OnOneSlope>),
    Several(OverSlopes),
}

/// What holds on every slope.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = VehicleSummary)]
struct Summary {
    /// The largest slope (rad) that the rover climbs at slips up to the limit; null where there is none, and a warning says why.
    largest_slope_rad: Option<f64>,
    /// Gravity (m/s²).
    gravity_m_s2: f64,
    /// The method by which the forces were found.
    method: &'static str,
    /// The circle on which the shear displacement was counted; null where the method counts none.
    #[schema(required = true)]
    shear_displacement_radius: Option<&'static str>,
    /// The circle on which the slip was counted.
    slip_radius: &'static str,
    /// What the wheels that turn together have in common: `one_slip` or `equal_torque`.
    drive: &'static str,
    /// Where the loads come from: `statics` of the centre of mass, or `equal`.
    loads_from: &'static str,
}

/// A rover on one slope.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = VehicleOnSlope)]
pub(crate) struct OnOneSlope {
    /// Slope α (rad).
    slope_rad: f64,
    /// Slip ratio s (–) of the wheels that turn together, at equal torques the largest of theirs; null where no slip gives the pull.
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    slip: f64,
    /// Whether the rover climbs at a slip up to the limit.
    climbs: bool,
    #[serde(flatten)]
    summary: Summary,
    /// Pull m g sin α + D (N) that slope and hitch need.
    needed_pull_n: f64,
    /// Σ F_x (N); null where no slip gives the pull, like all that follows.
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    longitudinal_force_n: f64,
    /// Σ F_z (N).
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    normal_force_n: f64,
    /// Σ T (N·m).
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    torque_n_m: f64,
    /// Energy Σ T ω/v (J/m) at the axles for a metre of way; null on the spot.
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    energy_per_metre_j_m: f64,
    /// Specific resistance (–): that energy over the weight m g.
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    specific_resistance: f64,
    /// Power Σ T ω (W) at the axles; null unless a velocity is given.
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    power_w: f64,
    /// One for each wheel; none where no slip gives the pull.
    wheels: Vec<WheelReply>,
    warnings: Vec<Warning>,
    #[serde(skip)]
    columns: SlopeColumns,
}

/// One wheel of the rover.
#[derive(Debug, Clone, Serialize, ToSchema)]
#[schema(as = VehicleWheel)]
struct WheelReply {
    /// Place x (m) along the rover; null where it is not known.
    x_m: Option<f64>,
    /// Slip ratio s (–).
    slip: f64,
    /// Load (N).
    normal_load_n: f64,
    /// Sinkage z (m) below the undisturbed surface.
    sinkage_m: f64,
    /// Depth (m) of the floor of the rut in which it runs, below the undisturbed surface; 0 where it runs in none.
    rut_depth_m: f64,
    /// Longitudinal force F_x (N).
    longitudinal_force_n: f64,
    /// Torque T (N·m).
    torque_n_m: f64,
    /// Drawbar coefficient F_x/F_z (–).
    drawbar_coefficient: Option<f64>,
    /// Energy T ω/v (J/m) for a metre of way; null on the spot.
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    energy_per_metre_j_m: f64,
    /// Power T ω (W); null unless a velocity is given.
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    power_w: f64,
}

/// A rover on several slopes.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = VehicleOverSlopes)]
pub(crate) struct OverSlopes {
    #[serde(flatten)]
    summary: Summary,
    columns: SlopeColumns,
    warnings: Vec<Warning>,
}

/// Columns over slopes.
#[derive(Debug)]
pub(crate) struct OfSlopes;

type SlopeColumns = Columns<OfSlopes>;

pub(super) static COLUMNS: [About; 12] = [
    About::new("slope_rad", "α", "rad", "slope, positive uphill"),
    About::new(
        "slip",
        "s",
        "1",
        "slip ratio of the wheels that turn together, at equal torques the largest of theirs; null where no slip gives the pull, like all that follows from it",
    ),
    About::new("climbs", "", "1", "1 where the rover climbs at a slip up to the limit, else 0"),
    About::new("needed_pull_n", "m g sin α + D", "N", "pull that slope and hitch need"),
    About::new("longitudinal_force_n", "Σ F_x", "N", "longitudinal force of all wheels"),
    About::new("normal_force_n", "Σ F_z", "N", "normal force of all wheels"),
    About::new("torque_n_m", "Σ T", "N.m", "torque of all wheels"),
    About::new("energy_per_metre_j_m", "Σ T ω/v", "J/m", "energy at the axles for a metre of way; null on the spot"),
    About::new("specific_resistance", "", "1", "that energy over the weight m g"),
    About::new("power_w", "Σ T ω", "W", "power at the axles; null unless a velocity is given"),
    About::new("largest_sinkage_m", "z", "m", "sinkage of the wheel that sinks deepest"),
    About::new("least_load_n", "W", "N", "load of the wheel that carries least"),
];

/// Columns that have a value on every slope.
const ALWAYS: [&str; 3] = ["slope_rad", "climbs", "needed_pull_n"];

impl Shape for OfSlopes {
    const NAME: &'static str = "SlopeColumns";
    const DOC: &'static str = "Columns of one length; null where the rover has no answer on a slope.";

    fn fields() -> Vec<Field> {
        let field =
            |about: &'static About| if ALWAYS.contains(&about.name) { Field::always(about) } else { Field::or_null(about) };
        COLUMNS.iter().map(field).collect()
    }
}

/// The values of a slope in the order of the columns; NaN where there is none.
pub(super) fn row(found: &FoundSlope, velocity: Option<f64>) -> [f64; COLUMNS.len()] {
    let of = |value: &dyn Fn(&Driven) -> f64| found.on.as_ref().map_or(f64::NAN, |on| value(&on.driven));
    let velocity = velocity.unwrap_or(f64::NAN);
    let over_wheels = |driven: &Driven, value: fn(&VehicleWheel) -> f64, choose: fn(f64, f64) -> f64| {
        driven.wheels.iter().map(value).reduce(choose).unwrap_or(f64::NAN)
    };
    [
        found.slope,
        of(&|driven| driven.slip.ratio()),
        f64::from(u8::from(found.climbs)),
        found.needed_pull,
        of(&|driven| driven.pull),
        of(&|driven| driven.normal),
        of(&|driven| driven.torque),
        of(&|driven| driven.energy_per_metre),
        found.on.as_ref().map_or(f64::NAN, |on| on.specific_resistance),
        of(&|driven| driven.power(velocity)),
        of(&|driven| over_wheels(driven, |wheel| wheel.sinkage, f64::max)),
        of(&|driven| over_wheels(driven, |wheel| wheel.load, f64::min)),
    ]
}

fn wheels(found: &FoundVehicle, driven: &Driven) -> Vec<WheelReply> {
    let velocity = found.velocity.unwrap_or(f64::NAN);
    let of_station = |(&(position, count), wheel): (&(Option<f64>, u32), &VehicleWheel)| {
        let reply = WheelReply {
            x_m: position,
            slip: wheel.slip.ratio(),
            normal_load_n: wheel.load,
            sinkage_m: wheel.sinkage,
            rut_depth_m: wheel.rut_depth,
            longitudinal_force_n: wheel.forces.longitudinal,
            torque_n_m: wheel.forces.torque,
            drawbar_coefficient: wheel.forces.drawbar_coefficient(),
            energy_per_metre_j_m: wheel.energy_per_metre(),
            power_w: wheel.power(velocity),
        };
        vec![reply; count as usize]
    };
    found.stations.iter().zip(&driven.wheels).flat_map(of_station).collect()
}

impl From<FoundVehicle> for VehicleReply {
    fn from(found: FoundVehicle) -> Self {
        let rows: Vec<_> = found.slopes.iter().map(|slope| row(slope, found.velocity)).collect();
        let column = |i: usize| Values::Numbers(rows.iter().map(|row| row[i]).collect());
        let columns = Columns::new(COLUMNS.iter().enumerate().map(|(i, about)| (about, column(i))).collect());
        let (shear_displacement_radius, slip_radius) = words(found.circles);
        let summary = Summary {
            largest_slope_rad: found.largest,
            gravity_m_s2: found.gravity,
            method: found.method,
            shear_displacement_radius,
            slip_radius,
            drive: found.drive,
            loads_from: if found.has_statics { "statics" } else { "equal" },
        };
        match (found.is_one, found.slopes.first(), rows.first()) {
            (true, Some(slope), Some(&row)) => {
                let wheels = slope.on.as_ref().map_or_else(|_| Vec::new(), |on| wheels(&found, &on.driven));
                let [slope_rad, slip, _, needed_pull_n, pull, normal, torque, energy, resistance, power, _, _] = row;
                Self::One(Box::new(OnOneSlope {
                    slope_rad,
                    slip,
                    climbs: slope.climbs,
                    summary,
                    needed_pull_n,
                    longitudinal_force_n: pull,
                    normal_force_n: normal,
                    torque_n_m: torque,
                    energy_per_metre_j_m: energy,
                    specific_resistance: resistance,
                    power_w: power,
                    wheels,
                    warnings: found.warnings,
                    columns,
                }))
            }
            _ => Self::Several(OverSlopes { summary, columns, warnings: found.warnings }),
        }
    }
}

impl Reply for VehicleReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        match self {
            Self::One(one) => one.columns.as_table(),
            Self::Several(several) => several.columns.as_table(),
        }
    }

    fn warnings(&self) -> &[Warning] {
        match self {
            Self::One(one) => &one.warnings,
            Self::Several(several) => &several.warnings,
        }
    }

    fn warn(&mut self, warning: Warning) {
        match self {
            Self::One(one) => one.warnings.push(warning),
            Self::Several(several) => several.warnings.push(warning),
        }
    }
}
