//! The request of `/v1/vehicle`.

mod drive;
mod ruts;
mod slopes;
mod stations;

pub(crate) use drive::word;
pub(crate) use slopes::Slopes;

use terramechanics::{ForceModel, STANDARD_GRAVITY, Vehicle, VehicleError, VehicleParams, Velocities};
use terramechanics_reading::{Field, Number, Object, Reader};

use crate::request::assume::ASSUME;
use crate::request::circles::CIRCLES;
use crate::request::laws::{field, field_or_default, number, number_or_default};
use crate::request::method::{self, LAMBDAS, METHOD, METHOD_FIELD, NORMAL_STRESS_RADIUS, PEAK_SINKAGE, STRESSES};
use crate::request::system::CONTACT;
use crate::request::unused::Unused;
use crate::request::{Documented, Request};
use drive::DRIVE;
use ruts::{RUT, UNLOADING};
use slopes::SLOPE;
use stations::{CENTRE_OF_MASS, FoundStations, SOIL, STATIONS, WHEELS};

const MASS: Field<Number> = Field::required(Vehicle::MASS.name, "Mass m of the rover (kg).", number(&Vehicle::MASS));
const GRAVITY: Field<Number> = field(
    &Vehicle::GRAVITY,
    "Gravity g where the rover drives (m/s²); that of the soil unless given, else the Earth's. Weights of the soil follow it.",
);
const HITCH_PULL: Field<Number> =
    field_or_default(&Vehicle::HITCH_PULL, "Pull D (N) that the rover gives at its hitch, along the slope.");
const HITCH_HEIGHT: Field<Number> = Field::new(
    Vehicle::HITCH_HEIGHT.name,
    "Height (m) of the hitch above the ground, beside `centre_of_mass`; 0 unless given.",
    number_or_default(&Vehicle::HITCH_HEIGHT),
);
const SLIP_LIMIT: Field<Number> = Field::new(
    Vehicle::SLIP_LIMIT.name,
    "Largest slip at which the rover counts as climbing.",
    number(&Vehicle::SLIP_LIMIT).share().or(0.6),
);
const FORWARD_VELOCITY: Field<Number> = Field::new(
    Velocities::FORWARD.name,
    "Velocity v of the rover (m/s), for the power. It is not negative: a rover that backs down drives forward with its stations in the other order, on the slope with the other sign.",
    Number::new("m/s", 0.0, Velocities::FORWARD.most),
);

/// A rover and its slopes, checked.
pub(crate) struct VehicleCase {
    pub(crate) vehicle: Vehicle,
    /// Whether each station has a soil of its own.
    pub(crate) have_own_soil: Vec<bool>,
    /// What was sent and is not read.
    pub(crate) unused: Unused,
    pub(crate) slopes: Slopes,
    pub(crate) hitch_pull: f64,
    pub(crate) slip_limit: f64,
    pub(crate) velocity: Option<f64>,
}

pub(super) type VehicleRequest = Documented<VehicleCase>;

impl Request for VehicleCase {
    const OBJECT: &'static Object = &Object {
        name: "VehicleRequest",
        doc: "A rover that drives straight up a slope, its wheels at one slip or at equal torques. Its wheels are given in one of two ways, `wheels` or `stations`.",
        groups: &[
            &[
                &MASS,
                &GRAVITY,
                &WHEELS,
                &STATIONS,
                &SOIL,
                &CONTACT,
                &CENTRE_OF_MASS,
                &SLOPE,
                &HITCH_PULL,
                &HITCH_HEIGHT,
                &DRIVE,
                &SLIP_LIMIT,
                &FORWARD_VELOCITY,
                &RUT,
                &UNLOADING,
                &ASSUME,
            ],
            CIRCLES,
            METHOD,
            STRESSES,
            LAMBDAS,
        ],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let (mass, gravity) = (object.required(&MASS), object.optional(&GRAVITY));
        let stations = stations::read(object);
        let centre_of_mass = stations::centre_of_mass(object);
        let slopes = slopes::read(object);
        let (hitch_pull, slip_limit) = (object.or_default(&HITCH_PULL), object.or_default(&SLIP_LIMIT));
        let (hitch_height, drive) = (object.or_default(&HITCH_HEIGHT), object.or_default(&DRIVE));
        let velocity = object.optional(&FORWARD_VELOCITY);
        let unloading = ruts::read(object);
        let peak_depth = object.optional(&PEAK_SINKAGE);
        let normal_stress_radius = object.or_default(&NORMAL_STRESS_RADIUS);
        let method = method::read(object, peak_depth.flatten());
        peak_depth?;
        let model = ForceModel { method: method?, normal_stress_radius: normal_stress_radius? };
        let FoundStations { stations, have_own_soil, unused } = stations?;
        let of_soil = stations.first().and_then(|station| station.system.soil.gravity());
        let gravity = gravity?.or(of_soil).unwrap_or(STANDARD_GRAVITY);
        let (centre_of_mass, unloading) = (centre_of_mass?, unloading?);
        let (hitch_height, drive) = (hitch_height?, drive?);
        let params = VehicleParams { mass: mass?, gravity, stations, centre_of_mass, hitch_height, drive, model, unloading };
        let vehicle = Vehicle::new(params).map_err(|error| report(object, &error)).ok()?;
        let (hitch_pull, slip_limit) = (hitch_pull?, slip_limit?);
        Some(Self { vehicle, have_own_soil, unused, slopes: slopes?, hitch_pull, slip_limit, velocity: velocity? })
    }
}

/// Reports why parts that are each right make no rover.
fn report(object: &Reader<'_>, error: &VehicleError) {
    let place = match error {
        VehicleError::NoBase => object.place_of(&CENTRE_OF_MASS),
        VehicleError::NoOrder => object.place_of(&RUT),
        VehicleError::RutByOtherMethod => object.place_of(&METHOD_FIELD),
        VehicleError::NoWheels | VehicleError::NothingTogether => object.place_of(&STATIONS),
        VehicleError::RutAtEqualTorque => object.place_of(&DRIVE),
        VehicleError::HitchWithoutStatics => object.place_of(&HITCH_HEIGHT),
        VehicleError::Invalid(_) => object.place_of(&GRAVITY),
        VehicleError::Lifted { .. }
        | VehicleError::Stopped
        | VehicleError::NotClimbed { .. }
        | VehicleError::TorqueNotHeld { .. }
        | VehicleError::Wheel { .. } => {
            return object.place().fault(error);
        }
    };
    place.fault(error);
}
