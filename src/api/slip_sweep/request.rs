//! The request of `/v1/slip-sweep`.

use terramechanics::{Operation, Slip};
use terramechanics_reading::{Object, Reader};

use crate::request::axis::{self, SLIPS};
use crate::request::circles::CIRCLES;
use crate::request::method::{self, BRAKING, LAMBDAS, METHOD, STRESSES};
use crate::request::side_slip::{self, SIDE_SLIP};
use crate::request::sinkage::is_under_load;
use crate::request::sinkage::{self, SINKAGE};
use crate::request::system::SYSTEM;
use crate::request::unused::{Reads, Unused};
use crate::request::{Documented, Request, operation};

/// A sweep, checked.
pub(crate) struct SweepCase {
    pub(crate) operation: Operation,
    pub(crate) slips: Vec<Slip>,
    /// What was sent and is not read.
    pub(crate) unused: Unused,
}

pub(super) type SweepRequest = Documented<SweepCase>;

impl Request for SweepCase {
    const OBJECT: &'static Object = &Object {
        name: "SlipSweepRequest",
        doc: "The forces over a range or a list of slips, at a sinkage given in exactly one of three ways (`sinkage_m`, `static_sinkage_m`, `normal_load_n`).",
        groups: &[SYSTEM, CIRCLES, &[&SLIPS], SINKAGE, METHOD, STRESSES, BRAKING, LAMBDAS, SIDE_SLIP],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let method = |object: &Reader<'_>, peak| side_slip::read(object, method::read(object, peak));
        let operation = operation::read(object, sinkage::read, method).operation;
        let slips = axis::read(object, &SLIPS);
        let operation = operation?;
        let unused = Unused::of(object, Reads::by(&operation.model.method, is_under_load(object)), &operation.system);
        Some(Self { operation, slips: slips?, unused })
    }
}
