//! What is the resultant of a triangular stress along the rim? The shape integrals A, B and H of linear stresses (letter, Eq. 12;
//! Shibly et al. 2005, source 16).
//!
//! | equation | here |
//! |---|---|
//! | (12a) A = (cos θm − cos θ2)/(θm − θ2) + (cos θm − cos θ1)/(θ1 − θm) | [`ShapeIntegrals::a`] |
//! | (12b) B = (sin θm − sin θ2)/(θm − θ2) + (sin θm − sin θ1)/(θ1 − θm) | [`ShapeIntegrals::b`] |
//! | (12c) H = (θ1 − θ2)/2 | [`ShapeIntegrals::h`] |
//!
//! Units: angles in rad; A, B and H have none. Validity: θ2 < θm < θ1, and exact for linear stresses. No departures.

use crate::contact::{AngleRates, Angles};
use crate::numerics::circular::{ArcMeans, HalfArc};
use crate::numerics::elementary::Number;

/// Integrals of the triangle that rises from 0 at θ2 to 1 at θm and falls to 0 at θ1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShapeIntegrals<F = f64> {
    /// A, the integral with cos θ (–). Eq. (12a).
    pub a: F,
    /// B, the integral with sin θ (–). Eq. (12b).
    pub b: F,
    /// H, the area (θ1 − θ2)/2 (–). Eq. (12c).
    pub h: F,
}

impl ShapeIntegrals {
    /// A, B and H of a contact.
    ///
    /// The quotients of Eq. (12) are means of circular functions over the rear and the front arc:
    /// A = ⟨sin⟩_front − ⟨sin⟩_rear and B = ⟨cos⟩_rear − ⟨cos⟩_front, the latter taken as 1 − ⟨cos⟩ to keep its digits.
    ///
    /// ```
    /// # use terramechanics::{Contact, ShapeIntegrals, Slip};
    /// // At z/r = 0.1: θ1 = 0.451027, A = 0.218873, B = 0.050213 (computed independently of this crate).
    /// let shape = ShapeIntegrals::of(&Contact::MIDPOINT.angles(0.1, Slip::ROLLING)?);
    /// assert!((shape.a - 0.218873).abs() < 5e-7 && (shape.b - 0.050213).abs() < 5e-7);
    /// assert!((shape.h - 0.451027 / 2.0).abs() < 5e-7);
    /// # Ok::<(), terramechanics::Error>(())
    /// ```
    #[must_use]
    pub fn of(angles: &Angles) -> Self {
        shape_within(angles)
    }
}

/// A, B and H of one contact or of several side by side.
#[inline(always)]
pub(super) fn shape_within<F: Number>(angles: &Angles<F>) -> ShapeIntegrals<F> {
    let Angles { entry, peak, exit } = *angles;
    let rear = ArcMeans::over((peak + exit) * 0.5, (peak - exit) * 0.5);
    let front = ArcMeans::over((entry + peak) * 0.5, (entry - peak) * 0.5);
    ShapeIntegrals { a: front.sin - rear.sin, b: front.one_minus_cos - rear.one_minus_cos, h: (entry - exit) * 0.5 } // Eq. (12)
}

/// dA/dθ1, dB/dθ1 and dH/dθ1 (1/rad) as the wheel sinks and its angles move at `rates`.
#[inline(always)]
pub(super) fn shape_changes<F: Number>(angles: &Angles<F>, rates: &AngleRates<F>) -> ShapeIntegrals<F> {
    let Angles { entry, peak, exit } = *angles;
    let rear = mean_changes([exit, peak], [rates.exit, rates.peak]);
    let front = mean_changes([peak, entry], [rates.peak, entry.like(1.0)]);
    ShapeIntegrals { a: front[0] - rear[0], b: front[1] - rear[1], h: (-rates.exit + 1.0) * 0.5 }
}

/// Changes of ⟨sin⟩ and of 1 − ⟨cos⟩ (1/rad) over an arc whose ends move.
///
/// The mean ⟨f⟩ over an arc from p to q changes by [(f(q) − ⟨f⟩) dq − (f(p) − ⟨f⟩) dp]/(q − p).
#[inline(always)]
fn mean_changes<F: Number>([p, q]: [F; 2], [p_rate, q_rate]: [F; 2]) -> [F; 2] {
    let means = ArcMeans::over((p + q) * 0.5, (q - p) * 0.5);
    let (from, to) = (HalfArc::of(p), HalfArc::of(q));
    let of_sin = (to.sin - means.sin) * q_rate - (from.sin - means.sin) * p_rate;
    let of_cos = (to.one_minus_cos - means.one_minus_cos) * q_rate - (from.one_minus_cos - means.one_minus_cos) * p_rate;
    [of_sin / (q - p), of_cos / (q - p)]
}
