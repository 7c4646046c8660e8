//! How much deeper does a slipping wheel sink than one at rest? Sinkage from the static one and the slip.
//!
//! The laws were fitted to driving wheels; at s < 0 they are applied as written and [`crate::cautions`] says that they
//! extrapolate.

mod linear;
mod lyasko;

pub use linear::LinearSlipSinkage;
pub use lyasko::Lyasko;

use crate::caution::Caution;
use crate::law::family;
use crate::slip::Slip;

family! {
    /// A slip–sinkage law.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub enum SlipSinkage {
        /// Lyasko 2010; letter, Eq. (18).
        Lyasko,
        /// A linear gain.
        Linear(LinearSlipSinkage),
    }

    /// Sinkage z (m) from the static sinkage z0 (m). What leaves 0 < z ≤ r is refused by the contact, not here.
    ///
    /// ```
    /// # use terramechanics::{LinearSlipSinkage, Slip, SlipSinkage};
    /// let slip = Slip::new(0.6)?;
    /// assert!((SlipSinkage::Lyasko.sinkage(1.0, slip) - 16.0 / 7.0).abs() < 1e-15); // by hand: 1.6/0.7
    /// assert_eq!(SlipSinkage::Linear(LinearSlipSinkage { gain: 0.5, skid_gain: None }).sinkage(1.0, slip), 1.3);
    /// # Ok::<(), terramechanics::Error>(())
    /// ```
    #[must_use]
    pub fn sinkage(&self, static_sinkage: f64, slip: Slip) -> f64;

    /// What is to be taken with care at a slip.
    pub(crate) fn cautions(&self, slip: Slip) -> [Option<Caution>; 2];
}
