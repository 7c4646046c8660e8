//! How hard can the soil under a wheel push it forward at a given slip? Thrust of a track, taken for a wheel (Bekker 1969;
//! shear law of Janosi & Hanamoto 1961).
//!
//! H = [A_c c (1 + 2h/b) + W tan φ (1 + 0.64 (h/b) arctan(b/h))] [1 − (K/(s l)) (1 − e^(−s l/K))], with the length of the
//! contact l = r θ1 and its area A_c = b l: [`thrust`].
//!
//! The last factor is the mean of E over a displacement that grows from 0 to s l along the contact. Without lugs (h = 0) both
//! factors in round brackets are 1.
//!
//! Validity: flat contacts. The formulas were read in course material (Akin, University of Maryland), not in Bekker's book.
//!
//! Departure: Bekker counts the lugs in the ground and their length. A wheel here has a lug height alone, so its lugs are
//! continuous along the contact, the most that lugs can do to the cohesive part.

use super::Lacking;
use crate::shear::ShearLaw;
use crate::slip::Slip;
use crate::soil::Soil;
use crate::wheel::Wheel;

/// Thrust H (N) under `load` W (N), on an arc of the entry angle (rad).
pub(super) fn thrust(wheel: &Wheel, soil: &Soil, load: f64, entry: f64, slip: Option<Slip>) -> Result<f64, Lacking> {
    let law = match soil.shear() {
        Some(ShearLaw::JanosiHanamoto(law)) => Some(law),
        Some(_) => return Err(Lacking::JanosiHanamoto),
        None => None, // not even asked for where there is no slip
    };
    let slip = slip.map(Slip::ratio).filter(|&ratio| ratio > 0.0).ok_or(Lacking::DrivingSlip)?;
    let law = law.ok_or(Lacking::JanosiHanamoto)?;
    let (width, lugs) = (wheel.width(), wheel.lug_height());
    let length = wheel.radius() * entry;
    let cohesive = width * length * soil.cohesion() * (1.0 + 2.0 * lugs / width);
    let frictional = load * soil.tan_friction() * (1.0 + 0.64 * (lugs / width) * width.atan2(lugs));
    Ok((cohesive + frictional) * mean_mobilisation(slip * length / law.modulus))
}

/// 1 − (1 − e^−x)/x for x > 0 (–): the mean of 1 − e^−y over y from 0 to x.
fn mean_mobilisation(x: f64) -> f64 {
    /// Below this the series is exact to rounding, and the difference would lose its digits.
    const SMALL: f64 = 0.02;
    if x < SMALL {
        // Σ (−1)^k x^(k + 1)/(k + 2)!
        x * (1.0 / 2.0 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x * (1.0 / 120.0 - x * (1.0 / 720.0 - x / 5040.0)))))
    } else {
        1.0 + (-x).exp_m1() / x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_mobilisation_keeps_its_digits_and_its_limits() {
        assert!((mean_mobilisation(1.0) - (-1.0_f64).exp()).abs() < 1e-15);
        assert!((mean_mobilisation(1e-12) / 0.5e-12 - 1.0).abs() < 1e-11);
        assert!((mean_mobilisation(1e12) - (1.0 - 1e-12)).abs() < 1e-15);
        let (below, above) = (mean_mobilisation(0.02_f64.next_down()), mean_mobilisation(0.02));
        assert!((above / below - 1.0).abs() < 1e-13);
    }
}
