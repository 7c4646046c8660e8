//! Which slope does a rover climb, and at what slip, torque and energy?
//!
//! A rigid body on n wheels drives straight up a slope α, its wheels at one slip s, and pulls D at its hitch:
//!
//! | sum | here |
//! |---|---|
//! | Σ F_z,i = m g cos α, each F_z,i by statics | [`Vehicle::loads`] |
//! | Σ F_x,i(s) = m g sin α + D, solved for s | [`Vehicle::on_slope`] |
//! | the largest α at which a slip up to a limit gives the second sum | [`Vehicle::largest_slope`] |
//!
//! Each wheel stands on its own soil, carries its own load, and is computed like a single one: the sinkage that carries the load, then
//! the forces. Where the rover has stations, a wheel may run in the rut of the one before (`rut.rs`). Wheels may also turn at equal
//! torques, or some of them at a slip or under a torque of their own (`turning.rs`).
//!
//! The soils lie in the gravity of the rover: their weights change with it, their moduli do not (`gravity.rs`).
//!
//! Left out: the reaction of the torques on the body, the change of its pitch with the sinkages, suspension that evens out loads, and
//! all motion across the slope.

mod command;
mod consent;
mod drive;
mod error;
mod loads;
mod rut;
mod slope;
mod turning;

pub use command::{Drive, Turning};
pub use drive::{Driven, VehicleWheel};
pub use error::VehicleError;
pub use rut::{UnlikeRut, Unloading};
pub use slope::{LargestSlope, OnSlope, SlopeLimit};

use consent::Consent;

use crate::braking::Braking;
use crate::fault::InvalidInput;
use crate::forces::{ForceModel, Method};
use crate::parameter::{Parameter, Presence, Requirement};
use crate::rolling::WheelOnSoil;

/// Wheels of stations that turn as they are told whatever the others do, and whether the caller still wants the result.
struct Told<'a> {
    wheels: Vec<Option<VehicleWheel>>,
    consent: &'a Consent<'a>,
}

/// Wheels that stand side by side under equal loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Place x (m) along the rover, positive to the front; none where it is not known.
    pub position: Option<f64>,
    /// Number of wheels.
    pub count: u32,
    /// One of the wheels on its soil.
    pub system: WheelOnSoil,
    /// How they turn.
    pub turning: Turning,
}

/// The centre of mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CentreOfMass {
    /// Place x (m) along the rover, counted like the stations.
    pub position: f64,
    /// Height (m) above the ground.
    pub height: f64,
}

/// What a rover is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct VehicleParams {
    /// Mass m (kg).
    pub mass: f64,
    /// Gravity g (m/s²).
    pub gravity: f64,
    /// Its stations.
    pub stations: Vec<Station>,
    /// Its centre of mass; without one, all wheels carry the same.
    pub centre_of_mass: Option<CentreOfMass>,
    /// Height (m) of the hitch above the ground.
    pub hitch_height: f64,
    /// What the wheels that turn together have in common.
    pub drive: Drive,
    /// How the forces are found.
    pub model: ForceModel,
    /// How the soil comes back behind a wheel, where wheels run in the ruts of those before.
    pub unloading: Option<Unloading>,
}

/// A rover whose parts fit together.
#[derive(Debug, Clone, PartialEq)]
pub struct Vehicle {
    params: VehicleParams,
    /// Number of wheels.
    wheels: f64,
    /// Indices of the stations from front to rear, each with the station in whose rut it runs.
    order: Vec<(usize, Option<usize>)>,
}

impl Vehicle {
    /// m.
    pub const MASS: Parameter = Parameter {
        name: "mass_kg",
        symbol: "m",
        unit: "kg",
        meaning: "Mass of the rover.",
        requirement: Requirement::Positive,
        least: 1e-6,
        most: 1e9,
        presence: Presence::Required,
    };

    /// g.
    pub const GRAVITY: Parameter = Parameter {
        name: "gravity_m_s2",
        symbol: "g",
        unit: "m/s2",
        meaning: "Gravity where the rover drives.",
        requirement: Requirement::Positive,
        least: 1e-6,
        most: 1e3,
        presence: Presence::Required,
    };

    /// α.
    pub const SLOPE: Parameter = Parameter {
        name: "slope_rad",
        symbol: "α",
        unit: "rad",
        meaning: "Slope of the ground, positive uphill.",
        requirement: Requirement::Within { min: -1.5, max: 1.5 },
        least: -1.5,
        most: 1.5,
        presence: Presence::Default(0.0),
    };

    /// D.
    pub const HITCH_PULL: Parameter = Parameter {
        name: "hitch_pull_n",
        symbol: "D",
        unit: "N",
        meaning: "Pull that the rover gives at its hitch, along the slope.",
        requirement: Requirement::Finite,
        least: -1e12,
        most: 1e12,
        presence: Presence::Default(0.0),
    };

    /// Height of the hitch.
    pub const HITCH_HEIGHT: Parameter = Parameter {
        name: "hitch_height_m",
        symbol: "h_D",
        unit: "m",
        meaning: "Height of the hitch above the ground.",
        requirement: Requirement::NotNegative,
        least: 0.0,
        most: 1e3,
        presence: Presence::Default(0.0),
    };

    /// Largest slip at which a rover still counts as climbing.
    pub const SLIP_LIMIT: Parameter = Parameter {
        name: "slip_limit",
        symbol: "s_max",
        unit: "1",
        meaning: "Largest slip at which the rover counts as climbing.",
        requirement: Requirement::Within { min: 0.0, max: 1.0 },
        least: 1e-3,
        most: 1.0,
        presence: Presence::Default(0.6),
    };

    /// x of a station.
    pub const POSITION: Parameter = Parameter {
        name: "x_m",
        symbol: "x",
        unit: "m",
        meaning: "Place along the rover, positive to the front.",
        requirement: Requirement::Finite,
        least: -1e3,
        most: 1e3,
        presence: Presence::Required,
    };

    /// Height of the centre of mass.
    pub const HEIGHT: Parameter = Parameter {
        name: "height_m",
        symbol: "h_c",
        unit: "m",
        meaning: "Height of the centre of mass above the ground.",
        requirement: Requirement::NotNegative,
        least: 0.0,
        most: 1e3,
        presence: Presence::Default(0.0),
    };

    /// What a rover and its drive are made of, besides its wheels.
    pub const PARAMETERS: &'static [Parameter] = &[
        Self::MASS,
        Self::GRAVITY,
        Self::SLOPE,
        Self::HITCH_PULL,
        Self::HITCH_HEIGHT,
        Self::SLIP_LIMIT,
        Self::POSITION,
        Self::HEIGHT,
    ];

    /// Checks the parts, and takes every soil to the gravity of the rover ([`crate::Soil::in_gravity`]).
    ///
    /// # Errors
    /// [`VehicleError::Invalid`] for a value outside its range; [`VehicleError::NoWheels`]; [`VehicleError::NoBase`] where a centre of
    /// mass is given but not two stations at different places; [`VehicleError::NoOrder`] where wheels are to follow in ruts but stand
    /// at unknown places; [`VehicleError::RutByOtherMethod`] where they are to do so by another method than the quadrature with one
    /// zone of braking, and [`VehicleError::RutAtEqualTorque`]; [`VehicleError::NothingTogether`];
    /// [`VehicleError::HitchWithoutStatics`] for a hitch above the ground without a centre of mass.
    pub fn new(mut params: VehicleParams) -> Result<Self, VehicleError> {
        let centre = params.centre_of_mass.iter().flat_map(|of| [(&Self::POSITION, of.position), (&Self::HEIGHT, of.height)]);
        let positions = params.stations.iter().filter_map(|station| Some((&Self::POSITION, station.position?)));
        let unloading = params.unloading.iter().flat_map(Unloading::named);
        let torques = params.stations.iter().filter_map(|station| match station.turning {
            Turning::UnderTorque(torque) => Some((&WheelOnSoil::TORQUE, torque)),
            Turning::Together | Turning::AtSlip(_) => None,
        });
        let own = [(&Self::MASS, params.mass), (&Self::GRAVITY, params.gravity), (&Self::HITCH_HEIGHT, params.hitch_height)];
        if let Err(InvalidInput { faults }) =
            InvalidInput::check(own.into_iter().chain(torques).chain(positions).chain(centre).chain(unloading))
            && let Some(fault) = faults.first()
        {
            return Err(VehicleError::Invalid(*fault));
        }
        if params.stations.is_empty() || params.stations.iter().any(|station| station.count == 0) {
            return Err(VehicleError::NoWheels);
        }
        if params.stations.iter().all(|station| station.turning != Turning::Together) {
            return Err(VehicleError::NothingTogether);
        }
        if params.hitch_height > 0.0 && params.centre_of_mass.is_none() {
            return Err(VehicleError::HitchWithoutStatics);
        }
        let places: Option<Vec<f64>> = params.stations.iter().map(|station| station.position).collect();
        if params.centre_of_mass.is_some()
            && !places.as_ref().is_some_and(|places| places.iter().any(|place| *place != places[0]))
        {
            return Err(VehicleError::NoBase);
        }
        let order = match (&params.unloading, places) {
            (None, _) => (0..params.stations.len()).map(|station| (station, None)).collect(),
            (Some(_), None) => return Err(VehicleError::NoOrder),
            (Some(_), Some(places)) => {
                let is_two_zoned = |station: &Station| station.system.contact.braking() == Braking::TwoZone;
                if params.model.method != Method::Quadrature || params.stations.iter().any(is_two_zoned) {
                    return Err(VehicleError::RutByOtherMethod);
                }
                if params.drive == Drive::EqualTorque {
                    return Err(VehicleError::RutAtEqualTorque);
                }
                rut::order(&places)
            }
        };
        for station in &mut params.stations {
            let soil = &mut station.system.soil;
            *soil = soil.in_gravity(params.gravity).map_err(|invalid| VehicleError::Invalid(invalid.faults[0]))?;
        }
        let wheels = params.stations.iter().map(|station| f64::from(station.count)).sum();
        Ok(Self { params, wheels, order })
    }

    /// The parts it was made of.
    #[must_use]
    pub fn params(&self) -> &VehicleParams {
        &self.params
    }

    /// Weight m g (N).
    #[must_use]
    pub fn weight(&self) -> f64 {
        self.params.mass * self.params.gravity
    }

    /// Pull m g sin α + D (N) that the wheels have to give together on `slope` (rad) with `hitch_pull` (N).
    #[must_use]
    pub fn needed_pull(&self, slope: f64, hitch_pull: f64) -> f64 {
        self.weight() * slope.sin() + hitch_pull
    }

    /// Whether the loads follow from statics rather than being equal.
    #[must_use]
    pub fn has_statics(&self) -> bool {
        self.params.centre_of_mass.is_some()
    }
}
