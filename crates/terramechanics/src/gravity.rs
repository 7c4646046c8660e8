//! What does gravity change in a soil? All that is a weight: its unit weight, Reece's γ, the granular stiffness.
//!
//! A soil may say in which gravity its values hold, and can be taken to another one. Weights per volume then change with gravity.
//! Strength and the moduli of Bekker's kind stay as they were measured: how they change is not known, and results say so by a
//! [`crate::Caution`].

use crate::fault::InvalidInput;
use crate::parameter::{Parameter, Presence, Requirement};
use crate::pressure_sinkage::{PressureSinkage, Reece};
use crate::soil::{Soil, SoilParams};

/// Standard acceleration of the Earth's gravity (m/s²), by the 3rd General Conference on Weights and Measures, 1901.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Share by which numbers for the gravity of one place differ: 9.78 to 9.83 on Earth, 1.62 and 1.625 on the Moon.
pub(crate) const ROUNDING: f64 = 0.01;

impl Soil {
    /// g.
    pub const GRAVITY: Parameter = Parameter {
        name: "gravity_m_s2",
        symbol: "g",
        unit: "m/s2",
        meaning: "Gravity, in which the values of the soil hold; the Earth's where a weight follows from a density and none is given.",
        requirement: Requirement::Positive,
        least: 1e-6,
        most: 1e3,
        presence: Presence::Optional,
    };

    /// The same soil in `gravity` (m/s²). Where it is known in which gravity the soil's own values hold, its unit weight, Reece's
    /// γ and a granular stiffness that was given change in proportion; else they stay, as nobody knows from what they would
    /// change.
    ///
    /// # Errors
    /// Unless the gravity is finite and greater than 0; where a weight overflows.
    ///
    /// ```
    /// use terramechanics::*;
    /// let earth = SoilParams { unit_weight: Some(15_000.0), gravity: Some(10.0), ..SoilParams::BARE };
    /// let moon = Soil::new(earth)?.in_gravity(1.6)?;
    /// assert!((moon.unit_weight().expect("a weight") - 2400.0).abs() < 1e-9); // 15 000 · 1.6/10
    /// assert_eq!((moon.gravity(), moon.measured_gravity()), (Some(1.6), Some(10.0)));
    /// # Ok::<(), InvalidInput>(())
    /// ```
    pub fn in_gravity(self, gravity: f64) -> Result<Self, InvalidInput> {
        let params = self.params();
        let ratio = params.gravity.map_or(1.0, |own| gravity / own);
        let pressure_sinkage = params.pressure_sinkage.map(|law| match law {
            PressureSinkage::Reece(law) => PressureSinkage::Reece(Reece { unit_weight: ratio * law.unit_weight, ..law }),
            PressureSinkage::Bekker(_) | PressureSinkage::Direct(_) | PressureSinkage::Diameter(_) => law,
        });
        let taken = Self::new(SoilParams {
            gravity: Some(gravity),
            unit_weight: params.unit_weight.map(|weight| ratio * weight),
            granular_stiffness: params.granular_stiffness.map(|stiffness| ratio * stiffness),
            pressure_sinkage,
            ..*params
        })?;
        Ok(taken.marked_as(&self))
    }

    /// Gravity in which the soil lies (m/s²), if it is known.
    #[must_use]
    pub fn gravity(&self) -> Option<f64> {
        self.params().gravity
    }

    /// Gravity (m/s²) to take where none is known: the soil's, else the Earth's.
    #[must_use]
    pub fn gravity_or_standard(&self) -> f64 {
        self.gravity().unwrap_or(STANDARD_GRAVITY)
    }

    /// Whether the soil was taken to a gravity other than that in which its values were measured.
    pub(crate) fn has_left_its_gravity(&self) -> bool {
        let differ = |measured: f64, here: f64| (here - measured).abs() > ROUNDING * measured;
        matches!((self.measured_gravity(), self.gravity()), (Some(measured), Some(here)) if differ(measured, here))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pressure_sinkage::{Bekker, SinkageExponent};

    const EXPONENT: SinkageExponent = SinkageExponent { base: 1.0, slip_gain: 0.0, skid_gain: None };

    fn soil(params: SoilParams) -> Soil {
        Soil::new(params).expect("a soil")
    }

    #[test]
    fn weights_change_with_gravity_and_measured_moduli_do_not() {
        let reece = Reece { k_c: 1.0, k_phi: 80.0, unit_weight: 12e3, exponent: EXPONENT };
        let params = SoilParams {
            pressure_sinkage: Some(PressureSinkage::Reece(reece)),
            granular_stiffness: Some(4e6),
            gravity: Some(8.0),
            ..SoilParams::BARE
        };
        let moon = soil(params).in_gravity(2.0).expect("a soil"); // a quarter
        assert_eq!((moon.unit_weight(), moon.granular_stiffness()), (Some(3e3), Some(1e6)));
        assert_eq!(moon.pressure_sinkage(), Some(&PressureSinkage::Reece(Reece { unit_weight: 3e3, ..reece })));
        assert_eq!(moon.in_gravity(8.0).expect("a soil").params(), &params);

        let bekker = PressureSinkage::Bekker(Bekker { k_c: 0.0, k_phi: 1e6, exponent: EXPONENT });
        let taken = soil(SoilParams { pressure_sinkage: Some(bekker), ..params }).in_gravity(2.0).expect("a soil");
        assert_eq!(taken.pressure_sinkage(), Some(&bekker));
    }

    #[test]
    fn weights_of_an_unknown_gravity_stay() {
        let moon = soil(SoilParams { unit_weight: Some(15e3), ..SoilParams::BARE }).in_gravity(1.6).expect("a soil");
        assert_eq!((moon.unit_weight(), moon.measured_gravity()), (Some(15e3), None));
        assert!(!moon.has_left_its_gravity());
    }

    #[test]
    fn the_gravity_of_the_measurement_is_remembered_over_many_steps() {
        let mars = soil(SoilParams { gravity: Some(9.8), ..SoilParams::BARE }).fitted_up_to(0.4);
        let mars = mars.in_gravity(1.6).and_then(|moon| moon.in_gravity(3.7)).expect("a soil");
        assert_eq!((mars.measured_gravity(), mars.gravity()), (Some(9.8), Some(3.7)));
        assert!(mars.has_left_its_gravity());
        assert_eq!(mars.largest_fitted_slip(), Some(0.4));
        assert!(!mars.in_gravity(9.8).expect("a soil").has_left_its_gravity());
    }

    #[test]
    fn a_gravity_that_is_none_is_refused() {
        for gravity in [0.0, -1.6, f64::NAN, f64::INFINITY] {
            let refused = soil(SoilParams::BARE).in_gravity(gravity).expect_err("no gravity");
            assert_eq!(refused.faults[0].parameter, &Soil::GRAVITY);
        }
    }

    #[test]
    fn a_density_has_its_weight_in_the_gravity_where_it_lies() {
        let dense = SoilParams { bulk_density: Some(1500.0), ..SoilParams::BARE };
        assert_eq!(soil(dense).unit_weight(), Some(1500.0 * STANDARD_GRAVITY));
        assert_eq!(soil(SoilParams { gravity: Some(1.6), ..dense }).unit_weight(), Some(2400.0));
        assert_eq!(soil(SoilParams { unit_weight: Some(20e3), ..dense }).unit_weight(), Some(20e3));
    }
}
