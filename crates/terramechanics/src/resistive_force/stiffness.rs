//! How stiff is a bed of grains? The granular stiffness ξ that scales all stresses of the resistive force method.
//!
//! | equation | here |
//! |---|---|
//! | ξ = ρ g (894 μ³ − 386 μ² + 89 μ), μ = tan φ (Agarwal, Goldman & Kamrin 2023) | [`granular_stiffness`] |
//!
//! Units: SI; ξ is a stress per depth (N/m³). Validity: dry grains without cohesion; the polynomial was fitted to simulated and
//! measured beds. It is 0 without friction and grows with it throughout. Departure: none.

use crate::parameter::{Parameter, Presence, Requirement};
use crate::soil::Soil;

impl Soil {
    /// ρ.
    pub const BULK_DENSITY: Parameter = Parameter {
        name: "bulk_density_kg_m3",
        symbol: "ρ",
        unit: "kg/m3",
        meaning: "Bulk density, from which unit weight and granular stiffness follow where they are not given.",
        requirement: Requirement::Positive,
        least: 1.0,
        most: 1e5,
        presence: Presence::Optional,
    };

    /// ξ.
    pub const GRANULAR_STIFFNESS: Parameter = Parameter {
        name: "granular_stiffness_n_m3",
        symbol: "ξ",
        unit: "N/m3",
        meaning: "Granular stiffness, for the resistive force method; from density, gravity and friction unless given.",
        requirement: Requirement::Positive,
        least: 1e-3,
        most: 1e15,
        presence: Presence::Optional,
    };

    /// Granular stiffness ξ (N/m³): the soil's own, else from its bulk density, friction angle and gravity, the Earth's where it
    /// has none; none where it has no density either.
    ///
    /// ```
    /// use terramechanics::*;
    /// // By hand: μ = 1/2, so 894/8 − 386/4 + 89/2 = 59.75, times 1600 · 10 N/m³.
    /// let sand = SoilParams {
    ///     friction_angle: 0.5_f64.atan(),
    ///     bulk_density: Some(1600.0),
    ///     gravity: Some(10.0),
    ///     ..SoilParams::BARE
    /// };
    /// assert!((Soil::new(sand)?.granular_stiffness().expect("a density") - 956_000.0).abs() < 1e-6);
    /// # Ok::<(), InvalidInput>(())
    /// ```
    #[must_use]
    pub fn granular_stiffness(&self) -> Option<f64> {
        let params = self.params();
        let from_density = || Some(granular_stiffness(params.bulk_density? * self.gravity_or_standard(), self.tan_friction()));
        params.granular_stiffness.or_else(from_density)
    }
}

/// ξ (N/m³) of grains of `weight` ρ g (N/m³) and internal friction μ = tan φ (–). Agarwal, Goldman & Kamrin 2023.
fn granular_stiffness(weight: f64, friction: f64) -> f64 {
    weight * friction * (89.0 + friction * (-386.0 + friction * 894.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stiffness_grows_with_friction_from_nothing() {
        assert_eq!(granular_stiffness(16e3, 0.0), 0.0);
        let mut before = 0.0;
        for i in 1..=200 {
            let here = granular_stiffness(16e3, 0.02 * f64::from(i));
            assert!(here > before, "{i}");
            before = here;
        }
    }

    #[test]
    fn a_given_stiffness_comes_before_one_of_the_density() {
        use crate::soil::SoilParams;
        let of = |params| Soil::new(params).expect("a soil").granular_stiffness();
        let dense = SoilParams { friction_angle: 0.6, bulk_density: Some(1500.0), ..SoilParams::BARE };
        assert_eq!(of(SoilParams { granular_stiffness: Some(2e6), ..dense }), Some(2e6));
        assert!(of(dense).is_some_and(|stiffness| stiffness > 1e6));
        assert_eq!(of(SoilParams { bulk_density: None, ..dense }), None);
    }
}
