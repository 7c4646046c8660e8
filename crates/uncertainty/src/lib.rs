//! What does not knowing the inputs of a model do to its answers?
//!
//! [`Inputs`] are distributions of numbers, with correlation where there is any. A [`Design`] lists the rows of numbers at which a
//! model has to be evaluated, and knows nothing of the model. From what the model answers, [`Summary`] makes mean, deviation and
//! quantiles, [`Probability`] tells how often a condition holds, and [`sensitivities`] tell which inputs decide.
//!
//! Every figure comes as an [`Estimate`] with its own standard error. A row without an answer stays in the account: it is counted,
//! never dropped in silence.
//!
//! # Points
//!
//! The rows are points of Sobol's sequence with Owen's scrambling (Owen 1997, Burley 2020), which fill the space of the inputs more
//! evenly than random numbers. The samples come in [`SCRAMBLINGS`] independent scramblings of equal size. Within one the points
//! depend on one another, and the scatter among them tells the error of nothing; the scatter among the scramblings does (Owen
//! 1997). A resampling of single points would take them for independent and overstate the error.
//!
//! The same seed gives the same rows, bit by bit, on every machine: the points come of whole numbers, and logarithms and
//! exponentials of `libm`, not of the machine.

mod bounds;
mod correlation;
mod design;
mod distribution;
mod error;
mod estimate;
mod inputs;
mod joint;
mod marginal;
mod normal;
mod probability;
mod sensitivity;
mod summary;

pub use bounds::Bounds;
pub use correlation::{Correlation, has_size};
pub use design::{Design, LEAST_SAMPLES, MOST_SAMPLES, MOST_SEED, SCRAMBLINGS};
pub use distribution::Distribution;
pub use error::{CorrelationError, DesignError, InputError};
pub use estimate::Estimate;
pub use inputs::{Inputs, MOST_SOURCES, Source};
pub use joint::{Joint, MOST_COLUMNS, MOST_VALUES};
pub use marginal::{MOST_CUT, Marginal};
pub use probability::Probability;
pub use sensitivity::{Sensitivity, sensitivities};
pub use summary::{PROBABILITIES, Summary};
