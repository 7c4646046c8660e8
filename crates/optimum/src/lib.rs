//! The best values of a few bounded variables for a function that takes long, has no derivatives and here and there no answer.
//!
//! A [`Task`] names the variables with their bounds, the output to make small or large and the limits that others have to keep.
//! [`optimum()`] surveys the whole of the bounds, searches from the most promising places and tells what it found: the best
//! point, or the one that misses the limits least. [`front()`] gives the trade-off of two outputs.
//!
//! The function is called with values of the variables and returns its outputs, or a [`Refusal`]. A point without an answer is
//! like one outside the limits. No task takes more evaluations than it says.
//!
//! An [`Expression`] is a formula in words of a user, of bounded length, with named values.

mod aim;
mod archive;
mod descent;
mod expression;
mod front;
mod ledger;
mod optimum;
mod scale;
mod search;
mod sequence;
mod starts;
mod task;
mod variable;

pub use descent::StopReason;
pub use expression::{Expression, ExpressionFault, MOST_CHARACTERS, MOST_NESTING};
pub use front::{Front, FrontPoint, Trade, front};
pub use ledger::{Function, Refusal, Stopped};
pub use optimum::{Bound, BoundHit, Infeasible, Loosened, Missed, Optimum, Outcome, optimum};
pub use task::{Goal, InvalidTask, Limit, MOST_STARTS, MOST_VARIABLES, Sense, Side, Task, TaskParams};
pub use variable::{Spacing, Variable};
