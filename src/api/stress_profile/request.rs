//! The request of `/v1/stress-profile`.

use terramechanics::{Method, Motion, Operation, PeakDepth};
use terramechanics_reading::{Field, Number, Object, Reader};

use crate::request::circles::CIRCLES;
use crate::request::method::{self, BRAKING, INTEGRALS, STRESSES};
use crate::request::motion::{self, MOTION};
use crate::request::sinkage::is_under_load;
use crate::request::sinkage::{self, SINKAGE};
use crate::request::system::SYSTEM;
use crate::request::unused::{Reads, Unused};
use crate::request::{Documented, Request, operation};

const POINTS: Field<Number> = Field::new(
    "points",
    "Number of places from exit to entry; the angle of maximum stress is always one of them, so 2 gives 3.",
    Number::new("1", 2.0, 10_001.0).whole().or(201.0),
);

/// A profile, checked.
pub(crate) struct ProfileCase {
    pub(crate) operation: Operation,
    pub(crate) motion: Motion,
    pub(crate) peak_depth: PeakDepth,
    pub(crate) points: usize,
    /// What was sent and is not read.
    pub(crate) unused: Unused,
}

pub(super) type ProfileRequest = Documented<ProfileCase>;

impl Request for ProfileCase {
    const OBJECT: &'static Object = &Object {
        name: "StressProfileRequest",
        doc: "The stresses along the rim at one operating point, exact and linearised. With `normal_load_n` the sinkage is solved by the method.",
        groups: &[SYSTEM, CIRCLES, MOTION, SINKAGE, INTEGRALS, STRESSES, BRAKING, &[&POINTS]],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let found = operation::read(object, sinkage::read, |object, _| method::read_integral(object));
        let motion = motion::read(object, found.wheel.as_ref(), found.circles);
        let points = object.or_default(&POINTS);
        let operation = found.operation?;
        let by_method = Reads::by(&operation.model.method, is_under_load(object));
        // The linear stresses stand beside those of the laws.
        let in_grains = operation.model.method == Method::ResistiveForce;
        let reads = if in_grains { by_method } else { by_method.and(Reads::LINEAR_STRESSES) };
        let unused = Unused::of(object, reads, &operation.system);
        Some(Self {
            operation,
            motion: motion?,
            peak_depth: found.peak_depth.unwrap_or(PeakDepth::Geometric),
            points: points? as usize,
            unused,
        })
    }
}
