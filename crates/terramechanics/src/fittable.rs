//! Which parameters may a fit find, and where does it look for them?
//!
//! Each is listed beside the thing that has it, as its [`Parameter`] is: a law's in the file of the law. A parameter that several
//! laws share is the same unknown in all of them.

use crate::parameter::Parameter;

/// A parameter that a fit may find.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fittable {
    /// What is declared of it.
    pub parameter: Parameter,
    /// The lower and the upper bound where none are given: what a soil can have, wide enough that no measured one lies outside.
    pub bounds: [f64; 2],
    /// Range of further starts: the values of sands, regoliths and their simulants.
    pub usual: [f64; 2],
    /// A start where neither the soil nor the caller has one.
    pub typical: f64,
    /// How far off an estimate may be and still be of use.
    pub tolerance: Tolerance,
    /// How a fit moves it.
    pub step: Step,
}

/// How far off an estimate may be and still be of use; one that is less certain counts as not determined.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// By this much: a share of what soils span.
    Fixed(f64),
    /// By its own size, as moduli and lengths.
    Size,
    /// By its own size or this much, whichever is more.
    SizeOr(f64),
    /// By its own size or by a share of the parameter of that name times the wheel's width, whichever is more: a modulus over the
    /// width counts beside another modulus.
    SizeOrShare {
        /// The share (–).
        share: f64,
        /// The name of the other parameter.
        of: &'static str,
    },
}

/// How a fit moves a parameter: as a number of about one.
///
/// Moduli span decades and K_s z^N is a straight line in ln K_s and N, so they move on a logarithmic scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// In this unit.
    Linear(f64),
    /// In the size of its start, but no less than this.
    OfStart(f64),
    /// By its logarithm where its bounds are positive; else as given.
    Logarithmic(&'static Step),
}

impl Step {
    /// For a number of about one.
    pub const ONE: Self = Self::Linear(1.0);
}
