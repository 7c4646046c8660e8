//! A closed form of the forces (letter, Eq. 11): what both of them have in common.
//!
//! F_x = A Y − B X, F_z = A X + B Y, T = r_s H Y, with X = r_n b σm and Y = r_s b τm; the methods differ in A, B, H and in the depth
//! under the peak. Departures: X carries r, not r_s (erratum 3), unless asked otherwise; T carries r_s, not r (erratum 6).

use super::outline::Outline;
use super::shape::{shape_changes, shape_within};
use super::{Components, ForceModel, Forces, Method, PeakDepth, ShapeIntegrals, explicit};
use crate::contact::Contact;
use crate::displacement::Way;
use crate::numerics::elementary::Number;
use crate::patch::ContactPatch;
use crate::shear::ShearLaw;
use crate::stress::StressField;

/// What turns stresses at the peak into forces: areas (m²) and radius (m) of the wheel, and the strength of the soil.
#[derive(Clone, Copy)]
pub(crate) struct Leverage<F = f64> {
    /// r_n b and r_s b.
    pub(crate) normal_area: F,
    pub(crate) shear_area: F,
    /// r_s.
    pub(crate) shearing_radius: F,
    /// c (Pa), tan φ (–) and 1/K (1/m).
    pub(crate) cohesion: F,
    pub(crate) tan_friction: F,
    pub(crate) per_shear_scale: F,
}

/// The forces of a closed form, or how they change.
#[derive(Clone, Copy)]
pub(crate) struct ClosedForces<F = f64> {
    pub(crate) components: Components<F>,
    /// T (N·m).
    pub(crate) torque: F,
}

/// What a closed form takes of a contact, whatever the motion of the wheel.
#[derive(Clone, Copy)]
pub(crate) struct Frame<F = f64> {
    pub(crate) outline: Outline<F>,
    shape: ShapeIntegrals<F>,
    /// Depth z_m (m) under the peak.
    pub(crate) depth: F,
}

impl<F: Number> Frame<F> {
    /// Of a `method` that is a closed form; none for an integral.
    #[inline(always)]
    pub(crate) fn of(method: &Method, outline: Outline<F>) -> Option<Self> {
        let (depth, shape) = match *method {
            Method::Quadrature | Method::SideSlipping(_) | Method::ResistiveForce => return None,
            Method::Linearised { peak_depth } => (peak_depth, shape_within(&outline.angles)),
            Method::Explicit { peak_depth, lambda_a, lambda_b } => {
                (peak_depth, explicit::approximate_shape(&outline, [lambda_a, lambda_b]))
            }
        };
        let depth = match depth {
            PeakDepth::Geometric => outline.peak_depth(),
            PeakDepth::Half => outline.sinkage * 0.5, // Eq. (8)
        };
        Some(Self { outline, shape, depth })
    }

    /// The closed form where E (–) at the peak is `mobilisation`.
    #[inline(always)]
    pub(crate) fn form(&self, mobilisation: F, leverage: Leverage<F>) -> ClosedForm<F> {
        ClosedForm { shape: self.shape, depth: self.depth, mobilisation, leverage }
    }
}

/// A closed form in one contact, or in several side by side.
#[derive(Clone, Copy)]
pub(crate) struct ClosedForm<F = f64> {
    shape: ShapeIntegrals<F>,
    /// Depth z_m (m) under the peak.
    pub(crate) depth: F,
    /// E (–) at the peak.
    mobilisation: F,
    leverage: Leverage<F>,
}

impl<F: Number> ClosedForm<F> {
    /// The forces by the normal stress σm (Pa) at the peak.
    #[inline(always)]
    pub(crate) fn forces(&self, normal_stress: F) -> ClosedForces<F> {
        self.forces_by(normal_stress, self.mobilisation * self.strength(normal_stress))
    }

    /// c + σ tan φ (Pa).
    #[inline(always)]
    fn strength(&self, normal_stress: F) -> F {
        normal_stress * self.leverage.tan_friction + self.leverage.cohesion
    }

    /// The forces by both stresses (Pa) at the peak; linear in them and in the shape.
    #[inline(always)]
    fn forces_by(&self, normal_stress: F, shear_stress: F) -> ClosedForces<F> {
        let x = self.leverage.normal_area * normal_stress;
        let y = self.leverage.shear_area * shear_stress;
        let ShapeIntegrals { a, b, h } = self.shape;
        let components = Components { traction: a * y, resistance: b * x, normal_support: a * x, shear_support: b * y };
        ClosedForces { components, torque: self.leverage.shearing_radius * h * y } // Eq. (11c) with r_s (erratum 6)
    }

    /// The changes of the forces against the entry angle (per rad) of a wheel that moves as `way` says, where σm (Pa) grows with the
    /// power `exponent` of the depth.
    #[inline(always)]
    pub(crate) fn changes(
        &self,
        by: &Changing<'_>,
        outline: &Outline<F>,
        way: &Way<F>,
        [slip, normal, exponent]: [F; 3],
    ) -> ClosedForces<F> {
        let rates = &by.contact.rates(outline.depth_ratio, slip);
        let (depth, shape) = match *by.method {
            Method::Explicit { peak_depth, lambda_a, lambda_b } => {
                (peak_depth, explicit::shape_changes(outline, &self.shape, [lambda_a, lambda_b], rates))
            }
            Method::Linearised { peak_depth } => (peak_depth, shape_changes(&outline.angles, rates)),
            Method::Quadrature | Method::SideSlipping(_) | Method::ResistiveForce => (PeakDepth::Half, self.shape),
        };
        let deepening = match depth {
            PeakDepth::Geometric => outline.peak_deepening(rates),
            PeakDepth::Half => outline.deepening(),
        };
        let Leverage { tan_friction, per_shear_scale, .. } = self.leverage;
        let normal_rate = exponent * normal * deepening;
        let x = way.displacement(&outline.peak).abs() * per_shear_scale;
        let steepness = by.shear.steepness(x, self.mobilisation) * per_shear_scale;
        let share_rate =
            steepness * way.displacement_rate([outline.radius, outline.sinkage], &outline.entry, &outline.peak, rates.peak);
        let shear = self.mobilisation * self.strength(normal);
        let shear_rate = share_rate * self.strength(normal) + self.mobilisation * tan_friction * normal_rate;
        Self { shape, ..*self }.forces_by(normal, shear).plus(&self.forces_by(normal_rate, shear_rate))
    }

    /// F_z = f_0 + σm f_1: f_0 (N), what cohesion carries; f_1 (m²), and the part of it that the normal stress carries itself.
    #[inline(always)]
    pub(crate) fn normal_force_parts(&self) -> (F, F, F) {
        let sheared = self.shape.b * self.leverage.shear_area * self.mobilisation;
        let direct = self.shape.a * self.leverage.normal_area;
        (sheared * self.leverage.cohesion, direct + sheared * self.leverage.tan_friction, direct)
    }
}

/// By what the forces change as a wheel sinks: the rules of the contact and the laws that all contacts share.
#[derive(Clone, Copy)]
pub(crate) struct Changing<'a> {
    pub(crate) method: &'a Method,
    pub(crate) contact: &'a Contact,
    pub(crate) shear: &'a ShearLaw,
}

impl<F: Number> ClosedForces<F> {
    /// F_z (N). Eq. (11b).
    #[inline(always)]
    pub(crate) fn normal(&self) -> F {
        self.components.normal_support + self.components.shear_support
    }

    #[inline(always)]
    pub(crate) fn scaled(&self, factor: F) -> Self {
        let Components { traction, resistance, normal_support, shear_support } = self.components;
        let components = Components {
            traction: factor * traction,
            resistance: factor * resistance,
            normal_support: factor * normal_support,
            shear_support: factor * shear_support,
        };
        Self { components, torque: factor * self.torque }
    }

    #[inline(always)]
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let (own, others) = (&self.components, &other.components);
        let components = Components {
            traction: own.traction + others.traction,
            resistance: own.resistance + others.resistance,
            normal_support: own.normal_support + others.normal_support,
            shear_support: own.shear_support + others.shear_support,
        };
        Self { components, torque: self.torque + other.torque }
    }
}

impl ClosedForces {
    /// The same with the sums.
    #[inline]
    pub(crate) fn summed(self) -> Forces {
        Forces::new(self.components, self.torque, 0.0)
    }
}

impl ForceModel {
    /// The closed form of the method in a contact of one zone; none for an integral.
    #[inline]
    pub(crate) fn closed_form(&self, patch: &ContactPatch<'_>) -> Option<ClosedForm> {
        Some(self.framed(patch)?.1)
    }

    #[inline(always)]
    fn framed(&self, patch: &ContactPatch<'_>) -> Option<(Frame, ClosedForm)> {
        if !self.method.is_closed_form() {
            return None;
        }
        let frame = Frame::of(&self.method, Outline::of_patch(patch))?;
        let leverage = self.leverage(patch.rolling.system, &patch.rolling.strength);
        Some((frame, frame.form(patch.mobilisation_of_one_zone(&frame.outline.peak), leverage)))
    }

    /// The forces of the closed form of the method in a contact of one zone, and their changes against the entry angle (per rad); none
    /// for an integral.
    pub(super) fn closed_forces_and_changes(&self, stresses: &StressField<'_>) -> Option<(Forces, Forces)> {
        let StressField { patch, curve } = *stresses;
        let (frame, form) = self.framed(patch)?;
        let normal = curve.pressure(form.depth);
        let rolling = patch.rolling;
        let by = Changing { method: &self.method, contact: &rolling.system.contact, shear: rolling.shear() };
        let changes = form.changes(&by, &frame.outline, &patch.way(), [rolling.slip.ratio(), normal, curve.exponent]);
        Some((form.forces(normal).summed(), changes.summed()))
    }
}
