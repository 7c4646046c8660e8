//! How much of its shear strength has the soil mobilised? τ = E(j) (c + σ tan φ) (letter, Eq. 5), with E from one of the
//! published laws.
//!
//! Every law is a function of j over a displacement of its own, so that one number scales it. Braking, j is negative and E is
//! continued as an odd function (erratum 11 of the letter).

mod janosi_hanamoto;
mod wong_peak;
mod wong_residual;

pub use janosi_hanamoto::JanosiHanamoto;
pub use wong_peak::WongPeak;
pub use wong_residual::WongResidual;

use crate::law::family;
use crate::numerics::elementary::Number;

family! {
    /// A shear law with its parameters.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub enum ShearLaw {
        /// Janosi & Hanamoto 1961: rises to the full strength and stays there.
        JanosiHanamoto(JanosiHanamoto),
        /// Wong: a hump, then a residual strength.
        WongResidual(WongResidual),
        /// Wong: a peak, then decay to nothing.
        WongPeak(WongPeak),
    }

    /// The displacement (m) by which the law scales.
    #[must_use]
    pub fn scale(&self) -> f64;

    /// E (–) after an endless displacement: what a locked wheel leaves, with the sign turned.
    #[must_use]
    pub fn residual(&self) -> f64;
}

impl ShearLaw {
    /// E (–), the mobilised share of the shear strength, at a shear displacement j (m); it has the sign of j. Eq. (6).
    ///
    /// ```
    /// use terramechanics::{JanosiHanamoto, ShearLaw, WongPeak};
    /// // By hand: 1 − 1/e at j = K.
    /// let sand = ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.01 });
    /// assert!((sand.mobilised_share(0.01) - 0.632_120_558_828_557_7).abs() < 1e-15);
    /// // By hand: 2/e at twice the displacement of the peak, against the motion.
    /// let mat = ShearLaw::WongPeak(WongPeak { peak_displacement: 0.02 });
    /// assert!((mat.mobilised_share(-0.04) + 0.735_758_882_342_884_6).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn mobilised_share(&self, displacement: f64) -> f64 {
        self.mobilisation(displacement / self.scale())
    }

    /// E (–) at a shear displacement given in units of [`ShearLaw::scale`]; odd.
    #[inline(always)]
    pub(crate) fn mobilisation<F: Number>(&self, displacement: F) -> F {
        let x = displacement.abs();
        let rise = match self {
            Self::JanosiHanamoto(law) => law.rise(x),
            Self::WongResidual(law) => law.rise(x),
            Self::WongPeak(law) => law.rise(x),
        };
        rise.copysign(displacement)
    }

    /// dE/dx (–) at x = |j| in units of [`ShearLaw::scale`], where E is `share`; even.
    #[inline(always)]
    pub(crate) fn steepness<F: Number>(&self, x: F, share: F) -> F {
        match self {
            Self::JanosiHanamoto(law) => law.steepness(share.abs()),
            Self::WongResidual(law) => law.steepness(x),
            Self::WongPeak(law) => law.steepness(x),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAWS: [ShearLaw; 4] = [
        ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.01 }),
        ShearLaw::WongResidual(WongResidual { residual_ratio: 0.66, peak_displacement: 0.022 }),
        ShearLaw::WongResidual(WongResidual { residual_ratio: 0.3, peak_displacement: 0.022 }),
        ShearLaw::WongPeak(WongPeak { peak_displacement: 0.02 }),
    ];

    #[test]
    fn every_law_is_odd_starts_at_zero_and_ends_at_its_residual() {
        for law in LAWS {
            assert_eq!(law.mobilisation(0.0), 0.0);
            for x in [1e-12, 0.1, 1.0, 7.0] {
                assert!(law.mobilisation(x) > 0.0);
                assert_eq!(law.mobilisation(-x), -law.mobilisation(x));
            }
            assert!((law.mobilisation(800.0) - law.residual()).abs() < 1e-15);
        }
    }

    #[test]
    fn wongs_laws_reach_the_full_strength_at_the_displacement_of_their_peak() {
        for law in &LAWS[1..] {
            assert!((law.mobilisation(1.0) - 1.0).abs() < 1e-15, "{law:?}");
        }
    }

    #[test]
    fn small_displacements_keep_their_digits() {
        // E → x for Janosi–Hanamoto, e x for the peak.
        assert!((LAWS[0].mobilisation(1e-12) / 1e-12 - 1.0).abs() < 1e-11);
        assert!((LAWS[3].mobilisation(1e-12) / (std::f64::consts::E * 1e-12) - 1.0).abs() < 1e-11);
        let joint = LAWS[0].mobilisation(0.1 * (1.0 + 1e-15)) - LAWS[0].mobilisation(0.1 * (1.0 - 1e-15));
        assert!(joint.abs() < 1e-15);
    }

    #[test]
    fn the_steepness_is_the_slope_of_the_share() {
        const STEP: f64 = 1e-6; // a central difference of it errs by about 1e-10
        for law in LAWS {
            for x in [0.01, 0.3, 1.0, 2.5, 9.0] {
                let slope = (law.mobilisation(x + STEP) - law.mobilisation(x - STEP)) / (2.0 * STEP);
                let steepness = law.steepness(x, law.mobilisation(x));
                assert!((steepness - slope).abs() < 1e-8, "{law:?} at {x}: {steepness} {slope}");
            }
        }
    }

    #[test]
    fn janosi_hanamoto_at_its_modulus_is_one_minus_one_over_e() {
        assert!((LAWS[0].mobilisation(1.0) - 0.632_120_558_828_557_7).abs() < 1e-15);
    }
}
