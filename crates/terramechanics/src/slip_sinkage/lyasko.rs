//! How much deeper does a slipping wheel sink? Lyasko (2010), after Vasil'ev (1969); letter, Eq. (18).

use crate::slip::Slip;

/// z = z0 (1 + s)/(1 − s/2): from 0 at s = −1 over z0 at rest to 4 z0 at s = 1. Eq. (18).
pub(super) fn sinkage(static_sinkage: f64, slip: Slip) -> f64 {
    let s = slip.ratio();
    static_sinkage * (1.0 + s) / (1.0 - 0.5 * s) // Eq. (18)
}
