//! What resists shearing along the rim.

/// What shears along the rim: the soil, or its interface with the rim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Strength {
    /// c or c_a (Pa).
    pub(crate) cohesion: f64,
    /// tan φ or tan δ (–).
    pub(crate) tan_friction: f64,
    /// Displacement (m) by which the shear law scales, and its reciprocal; NaN without a law.
    pub(crate) shear_scale: f64,
    pub(crate) per_shear_scale: f64,
}
