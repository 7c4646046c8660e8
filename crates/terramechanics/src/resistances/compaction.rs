//! How deep does a rigid wheel sink under its load, and what does pressing its rut take? (Bekker 1956, 1969)
//!
//! | equation | here |
//! |---|---|
//! | z = [3 W/((3 − n) b K_s √D)]^(2/(2n + 1)) | [`sinkage`] |
//! | R_c = b K_s z^(n + 1)/(n + 1), the work of pressing the rut per length | [`resistance`] |
//!
//! The rim is a parabola, x² = D (z − depth), on which the plates' pressure K_s depth^n stands upright; its load is
//! b K_s √D z^(n + 1/2) ∫(1 − u²)^n du over 0…1, and (3 − n)/3 stands for the integral. That is exact at n = 0 and n = 1, 6 %
//! too much at n = 1/2, 15 % too little at n = 3/2, and nothing at n = 3, from where on there is no sinkage.
//!
//! Validity: as Wong (Theory of Ground Vehicles, ch. 2) reports of Bekker, sinkages up to a sixth of the diameter and wheels
//! larger than half a metre; shear stress and slip are left out. The formulas were read in course material (Akin,
//! University of Maryland), not in Bekker's books, and derived anew as above.

use super::Lacking;
use crate::rolling::Rolling;

/// Sinkage over diameter (–) up to which the formulas were found good.
pub(crate) const MODERATE_DEPTH: f64 = 1.0 / 6.0;

/// Sinkage z (m) of the wheel under `load` W (N).
pub(super) fn sinkage(wheel: &Rolling<'_>, load: f64) -> Result<f64, Lacking> {
    let exponent = wheel.sinkage_exponent();
    if exponent >= 3.0 {
        return Err(Lacking::ExponentBelowThree { exponent });
    }
    let diameter = 2.0 * wheel.system.wheel.radius();
    let scale = (3.0 - exponent) * wheel.system.wheel.width() * wheel.sinkage_modulus() * diameter.sqrt();
    Ok((3.0 * load / scale).powf(2.0 / (2.0 * exponent + 1.0)))
}

/// Compaction resistance R_c (N) of a rut of depth `sinkage` (m).
pub(super) fn resistance(wheel: &Rolling<'_>, sinkage: f64) -> f64 {
    let next = wheel.sinkage_exponent() + 1.0;
    wheel.system.wheel.width() * wheel.sinkage_modulus() * sinkage.powf(next) / next
}
