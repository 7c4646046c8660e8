//! How much deeper does a slipping wheel sink than one at rest? Lyasko's relation (letter, Eq. 18).
//!
//! Fitted to driving wheels; at s < 0 it is applied as written and [`crate::cautions`] says that it extrapolates.

use crate::slip::Slip;

/// Sinkage z = z0 (1 + s)/(1 − s/2) (m) from the static sinkage `static_sinkage` z0 (m). Eq. (18), letter; Lyasko 2010.
///
/// It grows from 0 at s = −1 over z0 at rest to 4 z0 at s = 1.
///
/// ```
/// # use terramechanics::{lyasko_sinkage, Slip};
/// let z = lyasko_sinkage(1.0, Slip::new(0.6)?);
/// assert!((z - 16.0 / 7.0).abs() < 1e-15); // 1.6/0.7
/// # Ok::<(), terramechanics::Error>(())
/// ```
#[must_use]
pub fn lyasko_sinkage(static_sinkage: f64, slip: Slip) -> f64 {
    let s = slip.ratio();
    static_sinkage * (1.0 + s) / (1.0 - 0.5 * s) // Eq. (18)
}
