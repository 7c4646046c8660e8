//! By which method are the forces found, and with which options?

use crate::fittable::{Fittable, Step, Tolerance};
use crate::lateral::SideSlip;
use crate::parameter::{Parameter, Presence, Requirement};
use crate::patch::ContactPatch;
use crate::rim::RimPoint;
use crate::wheel::Wheel;

/// The depth that is taken under the peak of the stresses by the closed forms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PeakDepth {
    /// Where the rim is: r (cos θm − cos θ1), 3/4 of z at the midpoint of a shallow contact.
    Geometric,
    /// Half of the sinkage. Eq. (8).
    Half,
}

impl PeakDepth {
    /// The depth (m) at the place of the peak.
    #[inline]
    pub(crate) fn of(self, patch: &ContactPatch<'_>, peak: &RimPoint) -> f64 {
        match self {
            Self::Geometric => patch.geometric_depth(peak),
            Self::Half => 0.5 * patch.sinkage, // Eq. (8)
        }
    }
}

/// A fitting constant of Eq. (14).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lambda {
    /// A number.
    Given(f64),
    /// The value at which the approximation of Eq. (14) equals Eq. (12).
    Exact,
}

impl Lambda {
    /// λ_A.
    pub const A: Parameter = Parameter {
        name: "lambda_a",
        symbol: "λ_A",
        unit: "1",
        meaning: "λ_A of A ≈ (1 − λ_A) √(z/2r).",
        requirement: Requirement::Finite,
        least: -1.0,
        most: 1.0,
        presence: Presence::Default(0.0),
    };

    /// λ_B.
    pub const B: Parameter =
        Parameter { name: "lambda_b", symbol: "λ_B", meaning: "λ_B of B ≈ (1 + λ_B) z/(2r).", ..Self::A };

    /// λ_A and λ_B in a fit.
    pub const FITTABLE: &'static [Fittable] = {
        const A: Fittable = Fittable {
            parameter: Lambda::A,
            bounds: [-1.0, 1.0],
            usual: [-0.3, 0.3],
            typical: 0.0,
            tolerance: Tolerance::Fixed(0.3),
            step: Step::ONE,
        };
        &[A, Fittable { parameter: Self::B, ..A }]
    };
}

/// The radius at which the normal stress acts (erratum 3).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NormalStressRadius {
    /// The rim, r: what Eqs. (15), (16) and Ding et al. have.
    Rim,
    /// The shearing radius r_s: Eq. (10) to the letter.
    Shearing,
}

impl NormalStressRadius {
    /// The radius r_n (m) of `wheel`.
    #[must_use]
    pub fn of(self, wheel: &Wheel) -> f64 {
        match self {
            Self::Rim => wheel.radius(),
            Self::Shearing => wheel.shearing_radius(),
        }
    }
}

/// How the forces are found from the stresses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// Eq. (10), integrated numerically.
    Quadrature,
    /// The same for a wheel that moves at an angle to its plane, with the force across it.
    SideSlipping(SideSlip),
    /// Eqs. (11), (12): stresses linear from the exit to the peak and from there to the entry.
    Linearised {
        /// Depth under the peak.
        peak_depth: PeakDepth,
    },
    /// Eqs. (14)–(17).
    Explicit {
        /// Depth under the peak.
        peak_depth: PeakDepth,
        /// λ_A of Eq. (14a).
        lambda_a: Lambda,
        /// λ_B of Eq. (14b).
        lambda_b: Lambda,
    },
    /// The resistive force method of dry grains (Li, Zhang & Goldman 2013): neither the laws of the soil nor the rules of the contact
    /// have a part in it.
    ResistiveForce,
}

impl Method {
    /// The linearised method as published: the peak at its geometric depth.
    pub const LINEARISED: Self = Self::Linearised { peak_depth: PeakDepth::Geometric };
    /// The explicit method as published: half of the sinkage at the peak, λ_A = λ_B = 0.
    pub const EXPLICIT: Self =
        Self::Explicit { peak_depth: PeakDepth::Half, lambda_a: Lambda::Given(0.0), lambda_b: Lambda::Given(0.0) };

    /// Whether the forces are a closed form: a fraction of a microsecond, where an integral takes several.
    #[must_use]
    pub fn is_closed_form(&self) -> bool {
        match self {
            Self::Linearised { .. } | Self::Explicit { .. } => true,
            Self::Quadrature | Self::SideSlipping(_) | Self::ResistiveForce => false,
        }
    }
}
