//! A closed form of the forces (letter, Eq. 11): what both of them have in common.
//!
//! F_x = A Y − B X, F_z = A X + B Y, T = r_s H Y, with X = r_n b σm and Y = r_s b τm; the methods differ in A, B, H and in the depth
//! under the peak. Departures: X carries r, not r_s (erratum 3), unless asked otherwise; T carries r_s, not r (erratum 6).

use super::{Components, ForceModel, Forces, Method, PeakDepth, ShapeIntegrals, explicit, peak};
use crate::patch::ContactPatch;
use crate::stress::StressField;

/// A closed form in one contact.
pub(crate) struct ClosedForm<'a> {
    patch: &'a ContactPatch<'a>,
    shape: ShapeIntegrals,
    /// Depth z_m (m) under the peak.
    pub(crate) depth: f64,
    /// E (–) at the peak.
    mobilisation: f64,
    /// r_n b and r_s b (m²), and r_s (m).
    normal_area: f64,
    shear_area: f64,
    shearing_radius: f64,
}

impl ForceModel {
    /// The closed form of the method in a contact of one zone; none for an integral.
    #[inline]
    pub(crate) fn closed_form<'a>(&self, patch: &'a ContactPatch<'a>) -> Option<ClosedForm<'a>> {
        let (peak_depth, shape) = match self.method {
            Method::Quadrature | Method::SideSlipping(_) | Method::ResistiveForce => return None,
            Method::Linearised { peak_depth } => (peak_depth, ShapeIntegrals::of(&patch.angles)),
            Method::Explicit { peak_depth, lambda_a, lambda_b } => {
                (peak_depth, explicit::approximate_shape(patch, lambda_a, lambda_b))
            }
        };
        Some(self.closed_form_of(patch, peak_depth, shape))
    }

    #[inline]
    fn closed_form_of<'a>(&self, patch: &'a ContactPatch<'a>, depth: PeakDepth, shape: ShapeIntegrals) -> ClosedForm<'a> {
        let wheel = &patch.rolling.system.wheel;
        let point = peak(patch);
        ClosedForm {
            patch,
            shape,
            depth: depth.of(patch, &point),
            mobilisation: patch.mobilisation_of_one_zone(&point),
            normal_area: self.normal_stress_radius(wheel) * wheel.width(),
            shear_area: wheel.shearing_radius() * wheel.width(),
            shearing_radius: wheel.shearing_radius(),
        }
    }
}

impl ForceModel {
    /// The forces of the closed form of the method in a contact of one zone, and their changes against the entry angle (per rad); none
    /// for an integral.
    pub(super) fn closed_forces_and_changes(&self, stresses: &StressField<'_>) -> Option<(Forces, Forces)> {
        let StressField { patch, curve } = *stresses;
        let form = self.closed_form(patch)?;
        let rates = &patch.rolling.system.contact.rates(&patch.angles);
        let (depth, shape) = match self.method {
            Method::Linearised { peak_depth } => (peak_depth, ShapeIntegrals::changes(&patch.angles, rates)),
            Method::Explicit { peak_depth, lambda_a, lambda_b } => {
                (peak_depth, explicit::shape_changes(patch, &form.shape, [lambda_a, lambda_b], rates))
            }
            Method::Quadrature | Method::SideSlipping(_) | Method::ResistiveForce => return None,
        };
        let point = peak(patch);
        let deepening = match depth {
            PeakDepth::Geometric => (patch.entry.sin() - point.sin * rates.peak) / (2.0 * point.rise), // d ln z_m/dθ1
            PeakDepth::Half => 1.0 / patch.entry_rate(),
        };
        let normal = curve.pressure(form.depth);
        let normal_rate = curve.exponent * normal * deepening;
        let share_rate = patch.mobilisation_rate(&point, form.mobilisation, rates.peak);
        let rolling = patch.rolling;
        let shear = form.mobilisation * rolling.shear_strength(normal);
        let shear_rate =
            share_rate * rolling.shear_strength(normal) + form.mobilisation * rolling.strength.tan_friction * normal_rate;
        let (moved, grown) = (form.with_shape(shape).forces_by(normal, shear), form.forces_by(normal_rate, shear_rate));
        Some((form.forces_by(normal, shear), moved.plus(&grown)))
    }
}

impl ClosedForm<'_> {
    fn with_shape(&self, shape: ShapeIntegrals) -> Self {
        Self { shape, ..*self }
    }

    /// The forces by the normal stress σm (Pa) at the peak.
    #[inline]
    pub(crate) fn forces(&self, normal_stress: f64) -> Forces {
        self.forces_by(normal_stress, self.mobilisation * self.patch.rolling.shear_strength(normal_stress))
    }

    /// The forces by both stresses (Pa) at the peak; linear in them and in the shape.
    #[inline]
    fn forces_by(&self, normal_stress: f64, shear_stress: f64) -> Forces {
        let x = self.normal_area * normal_stress;
        let y = self.shear_area * shear_stress;
        let ShapeIntegrals { a, b, h } = self.shape;
        let components = Components { traction: a * y, resistance: b * x, normal_support: a * x, shear_support: b * y };
        Forces::new(components, self.shearing_radius * h * y, 0.0) // Eq. (11c) with r_s (erratum 6)
    }

    /// F_z = f_0 + σm f_1: f_0 (N), what cohesion carries; f_1 (m²), and the part of it that the normal stress carries itself.
    pub(crate) fn normal_force_parts(&self) -> (f64, f64, f64) {
        let strength = &self.patch.rolling.strength;
        let sheared = self.shape.b * self.shear_area * self.mobilisation;
        let direct = self.shape.a * self.normal_area;
        (sheared * strength.cohesion, direct + sheared * strength.tan_friction, direct)
    }
}
