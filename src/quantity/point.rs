//! Quantities of an operating point: how `/v1/forces` and every sweep have them.

use terramechanics::{Forces, Motion, OperatingPoint, SideForce, Slip, SlipRadius, Wheel, WheelOnSoil};

/// Where a quantity stands in the object of `/v1/forces`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    Motion,
    Resultant,
    Components,
    Across,
    Coefficients,
    /// A property of soil and wheel at this slip: given for a single point, and as a column where a known load shows it.
    Soil,
}

impl Part {
    /// All of them, in the order of the object.
    pub(crate) const ALL: [Self; 6] =
        [Self::Motion, Self::Resultant, Self::Components, Self::Across, Self::Coefficients, Self::Soil];

    /// Whether tables have its quantities.
    pub(crate) fn is_column(self) -> bool {
        self != Self::Soil
    }
}

/// How an operating point gives a quantity, and when.
#[derive(Debug, Clone, Copy)]
pub(crate) enum PointValue {
    /// An input, which is present even without a result.
    Asked(fn(Slip) -> f64),
    /// There at every point.
    Found(fn(&Point<'_>) -> f64),
    /// Undefined at some points.
    OrNone(fn(&Point<'_>) -> Option<f64>),
    /// A property of the soil, and a column only where a known load shows it.
    UnderLoad(fn(&Point<'_>) -> Option<f64>),
    /// There where a slip angle was sent.
    Sideways(fn(&SideForce) -> f64),
}

/// How an operating point gives a quantity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OfPoint {
    pub(crate) part: Part,
    pub(crate) value: PointValue,
}

impl OfPoint {
    /// The operations whose answers have it.
    pub(super) fn operations(self) -> &'static [&'static str] {
        match (self.part, self.value) {
            (Part::Soil, PointValue::UnderLoad(_)) => &["/v1/forces", "/v1/slip-sweep", "/v1/compare"],
            (Part::Soil, _) => &["/v1/forces"],
            // A comparison is of wheels that go straight ahead.
            (_, PointValue::Sideways(_)) => &["/v1/forces", "/v1/slip-sweep"],
            _ => &["/v1/forces", "/v1/slip-sweep", "/v1/compare"],
        }
    }
}

/// An operating point of a wheel that moves.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Point<'a> {
    pub(crate) wheel: &'a Wheel,
    /// The circle on which the slip is counted.
    pub(crate) slip_radius: SlipRadius,
    pub(crate) motion: Motion,
    pub(crate) point: &'a OperatingPoint,
    /// The forces in the heading of the wheel.
    pub(crate) forces: Forces,
}

impl<'a> Point<'a> {
    pub(crate) fn of(system: &'a WheelOnSoil, motion: Motion, point: &'a OperatingPoint) -> Self {
        let (wheel, slip_radius) = (&system.wheel, system.contact.circles().slip);
        Self { wheel, slip_radius, motion, point, forces: point.forces.heading(motion.heading) }
    }

    /// None at rest, where it is 0/0.
    pub(super) fn tractive_efficiency(&self) -> Option<f64> {
        let Motion { slip, heading, at_rest } = self.motion;
        if at_rest { None } else { self.forces.tractive_efficiency(self.wheel, self.slip_radius, slip, heading) }
    }
}

impl PointValue {
    /// The value at a point; NaN where there is none.
    pub(crate) fn at(self, point: &Point<'_>) -> f64 {
        match self {
            Self::Asked(value) => value(point.motion.slip),
            Self::Found(value) => value(point),
            Self::OrNone(value) | Self::UnderLoad(value) => value(point).unwrap_or(f64::NAN),
            Self::Sideways(value) => point.forces.side.as_ref().map_or(f64::NAN, value),
        }
    }

    /// The value at a slip without an answer.
    pub(crate) fn without(self, slip: Slip) -> f64 {
        match self {
            Self::Asked(value) => value(slip),
            Self::Found(_) | Self::OrNone(_) | Self::UnderLoad(_) | Self::Sideways(_) => f64::NAN,
        }
    }

    pub(crate) fn is_sideways(self) -> bool {
        matches!(self, Self::Sideways(_))
    }

    pub(super) fn is_under_load(self) -> bool {
        matches!(self, Self::UnderLoad(_))
    }
}
