//! Parameters of soil and contact from measurements, with an honest account of what the measurements cannot tell.
//!
//! [`fit()`] finds any of the model's parameters from measured forces, torque and sinkage over slip, with any of the three
//! methods of the crate `terramechanics` as the forward model.
//!
//! [`fit_line`] and [`RunningStrength`] find cohesion and friction alone, in one pass, from torque, load, slip and
//! sinkage (Iagnemma et al. 2004).
//!
//! [`fit_plates`] and [`fit_shear_curves`] find Bekker's parameters and the strength from plate tests and shear tests.
//!
//! Each of them ends for any finite input, with finite numbers or a typed error. Each has a form that asks its caller, about
//! every millisecond of work, whether to go on: [`fit_while`], [`fit_line_while`], [`fit_plates_while`] and
//! [`fit_shear_curves_while`]. The first no ends the fit at once.
//!
//! SI units and radians throughout, slip as in the model.

mod consent;
mod derivatives;
mod design;
mod error;
mod estimate;
mod finding;
mod fit;
mod fitted_column;
mod linear;
mod loss;
mod observations;
mod obstacle;
mod options;
mod plates;
mod problem;
mod profile;
mod quantity;
mod range;
mod report;
mod search;
mod setup;
mod shear_curves;
mod student;
mod uncertainty;
mod unknown;
mod valley;

pub use design::DesignGap;
pub use error::FitError;
pub use estimate::{Bound, Estimate, Identifiability};
pub use fit::{fit, fit_while};
pub use fitted_column::FittedColumn;
pub use linear::{
    LEAST_MOBILISATION, LinearFit, RollingSample, RunningStrength, StrengthBound, StrengthEstimate, StrengthTally, StressPoint,
    fit_line, fit_line_while, linear_strength,
};
pub use loss::Loss;
pub use observations::{Column, MOST_SAMPLES, Observations};
pub use options::{FitOptions, MOST_STARTS};
pub use plates::{FittedPlate, MOST_PLATES, PlateCurve, PlatesError, PlatesFit, fit_plates, fit_plates_while};
pub use problem::Sought;
pub use quantity::Quantity;
pub use report::Fit;
pub use search::StopReason;
pub use setup::{Setup, SinkageSource};
pub use shear_curves::{MOST_CURVES, ShearCurve, ShearError, ShearFit, fit_shear_curves, fit_shear_curves_while};
pub use student::quantile_95;
pub use unknown::{Home, Range, Unknown};
