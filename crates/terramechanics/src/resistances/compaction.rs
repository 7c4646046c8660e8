//! How deep does a rigid wheel sink under its load, and what resistance does its rut cause? (Bekker 1956, 1969)
//!
//! | equation | here |
//! |---|---|
//! | z = [3 W/((3 − n) b K_s √D)]^(2/(2n + 1)) | [`sinkage`] |
//! | R_c = b K_s z^(n + 1)/(n + 1), the work of pressing the rut per length | [`resistance`] |
//!
//! The rim is approximated by a parabola, x² = D (z − depth), and the plate pressure K_s depth^n acts vertically on it. The
//! load is b K_s √D z^(n + 1/2) ∫(1 − u²)^n du over 0…1, with (3 − n)/3 in place of the integral. That is exact at n = 0 and n
//! = 1, too large between them and too small beyond. At n = 3 it is zero, and from there on no sinkage exists. A test states
//! the error.
//!
//! Validity: as Wong (Theory of Ground Vehicles, ch. 2) reports of Bekker, sinkages up to a sixth of the diameter and wheels
//! larger than half a metre; shear stress and slip are left out. The formulas were read in course material (Akin,
//! University of Maryland), not in Bekker's books, and derived anew as above.

use super::Lacking;
use crate::pressure_sinkage::PressureCurve;
use crate::wheel::Wheel;

/// Sinkage z (m) of the wheel under `load` W (N).
pub(super) fn sinkage(wheel: &Wheel, curve: &PressureCurve, load: f64) -> Result<f64, Lacking> {
    let PressureCurve { modulus, exponent } = *curve;
    if exponent >= 3.0 {
        return Err(Lacking::ExponentBelowThree { exponent });
    }
    let scale = (3.0 - exponent) * wheel.width() * modulus * (2.0 * wheel.radius()).sqrt();
    Ok((3.0 * load / scale).powf(2.0 / (2.0 * exponent + 1.0)))
}

/// Compaction resistance R_c (N) of a rut of depth `sinkage` (m).
pub(super) fn resistance(wheel: &Wheel, curve: &PressureCurve, sinkage: f64) -> f64 {
    let next = curve.exponent + 1.0;
    wheel.width() * curve.modulus * sinkage.powf(next) / next
}

#[cfg(test)]
mod tests {
    /// ∫(1 − u²)^n du over 0…1, by the midpoint rule.
    fn integral(n: f64) -> f64 {
        let steps = 200_000;
        let height = |i: u32| (1.0 - ((f64::from(i) + 0.5) / f64::from(steps)).powi(2)).powf(n);
        (0..steps).map(height).sum::<f64>() / f64::from(steps)
    }

    #[test]
    fn the_share_that_stands_for_the_integral_is_as_good_as_the_service_says() {
        let error = |n: f64| (3.0 - n) / 3.0 / integral(n) - 1.0;
        assert!(error(0.0).abs() < 1e-12 && error(1.0).abs() < 1e-9);
        assert!((error(0.5) - 0.06).abs() < 5e-3, "{}", error(0.5));
        assert!((error(1.5) + 0.15).abs() < 5e-3, "{}", error(1.5));
    }
}
