//! The request of `/v1/forces`.

use terramechanics::Operation;
use terramechanics_reading::{Object, Reader};

use crate::request::circles::CIRCLES;
use crate::request::method::{self, BRAKING, LAMBDAS, METHOD, STRESSES};
use crate::request::motion::MOTION;
use crate::request::pull::{self, PULL, SlipFrom};
use crate::request::side_slip::{self, SIDE_SLIP};
use crate::request::sinkage::{self, SINKAGE, is_under_load};
use crate::request::system::SYSTEM;
use crate::request::unused::{Reads, Unused};
use crate::request::{Documented, Request, operation};

/// One operating point, checked.
pub(crate) struct ForcesCase {
    pub(crate) operation: Operation,
    pub(crate) slip: SlipFrom,
    /// What was sent and is not read.
    pub(crate) unused: Unused,
}

pub(super) type ForcesRequest = Documented<ForcesCase>;

impl Request for ForcesCase {
    const OBJECT: &'static Object = &Object {
        name: "ForcesRequest",
        doc: "One operating point: a wheel on a soil at one slip (`slip`, both velocities, or the pull that solves it) and one sinkage (exactly one of `sinkage_m`, `static_sinkage_m`, `normal_load_n`).",
        groups: &[SYSTEM, CIRCLES, MOTION, PULL, SINKAGE, METHOD, STRESSES, BRAKING, LAMBDAS, SIDE_SLIP],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let method = |object: &Reader<'_>, peak| side_slip::read(object, method::read(object, peak));
        let found = operation::read(object, sinkage::read, method);
        let slip = pull::read(object, found.wheel.as_ref(), found.circles);
        let operation = found.operation?;
        let unused = Unused::of(object, Reads::by(&operation.model.method, is_under_load(object)), &operation.system);
        Some(Self { operation, slip: slip?, unused })
    }
}
