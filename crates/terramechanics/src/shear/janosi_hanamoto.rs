//! How does shear strength build up where it does not fall again? Janosi & Hanamoto (1961); letter, Eq. (6).
//!
//! Departure: Eq. (6) as printed divides r by an undefined V and, braking, would grow without bound; here r/K and an odd E
//! (errata 2 and 11).

use super::saturation;

/// Janosi–Hanamoto's law: E = 1 − exp(−j/K).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JanosiHanamoto {
    /// Shear deformation modulus K (m), greater than 0.
    pub modulus: f64,
}

impl JanosiHanamoto {
    /// E at x = |j|/K: in [0, 1]. Eq. (6).
    #[inline]
    pub(super) fn mobilisation(x: f64) -> f64 {
        saturation(x)
    }
}
