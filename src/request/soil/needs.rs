//! What requests need of a soil, and where its law comes from.

/// What a request needs of a soil.
#[derive(Clone, Copy)]
pub(crate) struct Needs<'a> {
    /// Whether the pressure–sinkage law has an influence; else it may be absent.
    pub(crate) pressure_sinkage: bool,
    /// Whether it may turn out to have one: it may be absent, and is assumed where that is allowed.
    pub(crate) perhaps_pressure_sinkage: bool,
    /// Whether the shear law has one.
    pub(crate) shear: bool,
    /// Whether cohesion and friction have one of their own.
    pub(crate) strength: bool,
    /// Whether the granular stiffness has one; then it has to be given or to follow.
    pub(crate) granular_stiffness: bool,
    /// The starts of the parameters that are fitted, by name: they may be absent.
    pub(crate) fitted: &'a dyn Fn(&str) -> Option<f64>,
}

impl Needs<'static> {
    /// All that the letter's model takes of a soil.
    pub(crate) const ALL: Self = Self {
        pressure_sinkage: true,
        perhaps_pressure_sinkage: false,
        shear: true,
        strength: true,
        granular_stiffness: false,
        fitted: &|_| None,
    };

    /// What the resistive force method takes of it.
    pub(crate) const GRAINS: Self =
        Self { pressure_sinkage: false, shear: false, strength: false, granular_stiffness: true, ..Self::ALL };

    /// What one or the other needs.
    pub(crate) fn and(self, other: Self) -> Self {
        Self {
            pressure_sinkage: self.pressure_sinkage || other.pressure_sinkage,
            perhaps_pressure_sinkage: self.perhaps_pressure_sinkage || other.perhaps_pressure_sinkage,
            shear: self.shear || other.shear,
            strength: self.strength || other.strength,
            granular_stiffness: self.granular_stiffness || other.granular_stiffness,
            ..self
        }
    }
}

/// Where the pressure–sinkage law comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LawOrigin {
    /// From the request.
    Request,
    /// From the catalogue.
    Catalogue,
    /// From the catalogue, save for single values that the request has in place of its own.
    Overridden,
    /// The preset's gave way to the direct one, whose modulus is fitted.
    Replaced,
    /// There is none, as it has no influence.
    Absent,
}
