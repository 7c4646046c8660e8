//! What does dry granular soil do to a wheel that moves into it? The resistive force method (Li, Zhang & Goldman 2013, source 26).
//!
//! Each piece of a surface that moves into dry grains feels a stress proportional to its depth, with a factor that depends on how
//! the piece is inclined, β, and where it goes, γ. The soil has one number, the granular stiffness ξ.
//!
//! | equation | here |
//! |---|---|
//! | ξ = ρ g (894 μ³ − 386 μ² + 89 μ) (Agarwal, Goldman & Kamrin 2023, source 27) | [`Soil::granular_stiffness`] |
//! | α_x, α_z: Fourier series in β and γ with nine coefficients (2013) | `response.rs` |
//! | β = −θ, γ = atan2(sin θ, cos θ − v/(rω)), depth r (cos θ − cos θ1) on 0 < θ < θ1 | `edge.rs` |
//! | F_x = b r ξ ∫ α_x d dθ, F_z = b r ξ ∫ α_z d dθ, T = b r² ξ ∫ (α_x cos θ + α_z sin θ) d dθ | `forces/resistive.rs` |
//!
//! It is another pair of stresses on the rim, σ = ξ d (α_z cos θ − α_x sin θ) and τ = ξ d (α_x cos θ + α_z sin θ), so profiles and
//! the four parts of the forces mean what they mean in the other methods.
//!
//! Units: SI; ξ in N/m³, α without unit (the published 0.206 … N/cm³ are those of a bed of ξ = 1 N/cm³).
//!
//! Validity: dry grains without cohesion, driving wheels. It meets the sinkage with nothing fitted; its pull of a braking wheel is
//! far off. The wheel is a rough cylinder of the rim: lugs are not computed, because lug faces taken as free plates feel several
//! times what is measured.
//!
//! Departures: the wheel is plane, as in 2013; the three-dimensional form is left out, as public copies of its coefficients differ.
//! The coefficients (its table S2) were read in a public implementation.
//!
//! [`Soil::granular_stiffness`]: crate::Soil::granular_stiffness

mod contact;
mod edge;
mod peak;
mod profile;
mod response;
mod stiffness;

pub(crate) use edge::{LeadingEdge, equivalent_modulus};
