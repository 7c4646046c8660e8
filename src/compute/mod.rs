//! Where computations run: what costs next to nothing at once, the rest on a bounded pool apart from the threads that serve
//! connections.

mod cost;
mod pace;
mod pool;
mod tally;
mod turns;

pub(crate) use cost::{Cost, Point, allowance};
pub(crate) use pace::{Pace, SLICE, Stop};
pub(crate) use pool::{OVERDRAFT, Place, Pool, PoolBounds};
