//! What forces and torque does the soil exert on the wheel? (letter, Eqs. 10–17)
//!
//! By the letter three ways: [`quadrature`] of the stresses (Eq. 10), the linearised stresses in [`closed`] form (Shibly et al. 2005, source 16;
//! Eqs. 7, 11, 12), and the letter's own [`explicit`] formulas (Eqs. 14–17). Linear stresses hold for contacts of one zone; the
//! power law of the pressure is rounder than a triangle, so that they carry less than the quadrature with the peak at the midpoint.
//!
//! Beside these, [`resistive`]: the same integrals over the stresses of the resistive force method.
//!
//! Departures from the letter as printed, with the number of the erratum: the normal stress acts at the rim unless asked
//! otherwise (3); the normal force is the sum of both parts (4); the torque's integral starts at the exit (5); the torque
//! carries r_s² (6); B ≈ z/(2r) (8); the shear terms of (15) carry r_s/√r (9).

mod at_slips;
mod closed;
mod explicit;
mod method;
pub(crate) mod outline;
mod panel;
mod panels;
mod quadrature;
pub(crate) mod resistive;
pub(crate) mod rutted;
mod shape;
mod shearing;
mod side;

pub(crate) use at_slips::forces_at_slips;
pub(crate) use closed::{Changing, ClosedForces, ClosedForm, Frame, Leverage};
pub use method::{Lambda, Method, NormalStressRadius, PeakDepth};
pub use shape::ShapeIntegrals;

use crate::circles::SlipRadius;
use crate::error::Error;
use crate::fault::Fault;
use crate::lateral::SideForce;
use crate::motion::Heading;
use crate::patch::ContactPatch;
use crate::rim::RimPoint;
use crate::rolling::WheelOnSoil;
use crate::slip::Slip;
use crate::strength::Strength;
use crate::stress::{StressField, Stresses};
use crate::wheel::Wheel;

/// A method together with the radius of the normal stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceModel {
    /// The method.
    pub method: Method,
    /// The radius at which the normal stress acts.
    pub normal_stress_radius: NormalStressRadius,
}

impl ForceModel {
    /// `method` with the normal stress at the rim.
    #[must_use]
    pub fn at_rim(method: Method) -> Self {
        Self { method, normal_stress_radius: NormalStressRadius::Rim }
    }

    /// Radius r_n (m) at which the normal stress acts on `wheel`.
    #[must_use]
    pub fn normal_stress_radius(&self, wheel: &Wheel) -> f64 {
        self.normal_stress_radius.of(wheel)
    }

    /// What turns stresses at the peak into forces.
    #[inline]
    pub(crate) fn leverage(&self, system: &WheelOnSoil, strength: &Strength) -> Leverage {
        let wheel = &system.wheel;
        let Strength { cohesion, tan_friction, per_shear_scale, .. } = *strength;
        let (normal_area, shear_area) =
            (self.normal_stress_radius(wheel) * wheel.width(), wheel.shearing_radius() * wheel.width());
        let shearing_radius = wheel.shearing_radius();
        Leverage { normal_area, shear_area, shearing_radius, cohesion, tan_friction, per_shear_scale }
    }

    /// Forces and torque on the wheel in the contact `patch`.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a λ that is not finite, [`Error::ClosedFormOfTwoZones`] for a closed form of a braking wheel
    /// with two zones, [`Error::SlipAngleOfTwoZones`] for a slip angle of one, [`Error::MissingLaw`] for what the method needs of
    /// the soil, [`Error::NotFinite`] where a result overflows.
    ///
    /// ```
    /// use terramechanics::*;
    /// // The letter's own example (its Fig. 1b), 20 mm deep at 20 % slip.
    /// let system = WheelOnSoil {
    ///     wheel: Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 })?,
    ///     soil: Soil::new(SoilParams {
    ///         cohesion: 0.0,
    ///         friction_angle: 0.478,
    ///         shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.005 })),
    ///         pressure_sinkage: Some(PressureSinkage::Bekker(Bekker {
    ///             k_c: -660.0,
    ///             k_phi: 754_130.0,
    ///             exponent: SinkageExponent { base: 0.91, slip_gain: 0.0, skid_gain: None },
    ///         })),
    ///         ..SoilParams::BARE
    ///     })?,
    ///     contact: Contact::MIDPOINT,
    /// };
    /// let rolling = system.rolling(Slip::new(0.2)?)?;
    /// let forces = ForceModel::at_rim(Method::Quadrature).forces(&rolling.contact(0.02)?)?;
    /// // An independent integration with 401 000 points gave 16.906 N, 89.716 N and 7.3396 N·m.
    /// assert!((forces.longitudinal - 16.906).abs() < 5e-4);
    /// assert!((forces.normal - 89.716).abs() < 5e-4);
    /// assert!((forces.torque - 7.3396).abs() < 5e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn forces(&self, patch: &ContactPatch<'_>) -> Result<Forces, Error> {
        if self.method == Method::ResistiveForce {
            return resistive::forces_in_grains(patch.rolling, patch.sinkage);
        }
        self.check(patch)?;
        let stresses = &patch.stresses()?;
        let forces = match (self.method, self.closed_form(patch)) {
            (_, Some(form)) => form.forces(stresses.curve.pressure(form.depth)).summed(),
            (Method::SideSlipping(side), None) => side::forces(self, stresses, &side),
            (_, None) => quadrature::forces(self, stresses),
        };
        if forces.is_finite() { Ok(forces) } else { Err(Error::NotFinite) }
    }

    /// The forces of a contact and their changes against its entry angle (per rad), for a search of the sinkage: by few
    /// nodes for a `coarse` look. None where that does not serve.
    pub(crate) fn forces_and_changes(&self, patch: &ContactPatch<'_>, coarse: bool) -> Option<(Forces, Forces)> {
        let stresses = &patch.stresses().ok()?;
        match self.method {
            Method::Quadrature => quadrature::forces_and_changes(self, stresses, coarse),
            Method::Linearised { .. } | Method::Explicit { .. } => self.closed_forces_and_changes(stresses),
            Method::SideSlipping(_) | Method::ResistiveForce => None,
        }
    }

    /// Whether the method takes the contact, and its constants are numbers.
    #[inline]
    pub(crate) fn check(&self, patch: &ContactPatch<'_>) -> Result<(), Error> {
        match self.method {
            Method::SideSlipping(side) if patch.has_two_zones() && side.angle.angle() != 0.0 => Err(Error::SlipAngleOfTwoZones),
            Method::Linearised { .. } | Method::Explicit { .. } if patch.has_two_zones() => Err(Error::ClosedFormOfTwoZones),
            Method::Explicit { lambda_a, lambda_b, .. } => {
                for (parameter, lambda) in [(&Lambda::A, lambda_a), (&Lambda::B, lambda_b)] {
                    if let Lambda::Given(value) = lambda
                        && !value.is_finite()
                    {
                        return Err(Error::Invalid(Fault { parameter, value }));
                    }
                }
                Ok(())
            }
            Method::Quadrature | Method::SideSlipping(_) | Method::Linearised { .. } | Method::ResistiveForce => Ok(()),
        }
    }
}

/// The four parts of the forces, which the letter explains below Eq. (12).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Components<F = f64> {
    /// Traction AY: the shear stress along x (N).
    pub traction: F,
    /// Resistance BX: the normal stress against x (N).
    pub resistance: F,
    /// Normal support AX: the normal stress along z (N).
    pub normal_support: F,
    /// Shear support BY: the shear stress along z (N).
    pub shear_support: F,
}

/// Forces and torque on a wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Forces {
    /// Longitudinal force F_x, the drawbar pull (N).
    pub longitudinal: f64,
    /// Normal force F_z (N).
    pub normal: f64,
    /// Torque T about the axle that the wheel has to be given (N·m).
    pub torque: f64,
    /// The four parts.
    pub components: Components,
    /// The force across the wheel, where a slip angle was asked for.
    pub side: Option<SideForce>,
    /// Estimate of the relative error of the integrals by quadrature, on the scale of the parts; 0 for the closed forms,
    /// which have none.
    pub integration_error: f64,
}

impl Forces {
    pub(crate) fn new(components: Components, torque: f64, integration_error: f64) -> Self {
        let Components { traction, resistance, normal_support, shear_support } = components;
        Self {
            longitudinal: traction - resistance,    // Eqs. (10a), (11a)
            normal: normal_support + shear_support, // Eqs. (10b), (11b): the sum (erratum 4)
            torque,
            components,
            side: None,
            integration_error,
        }
    }

    /// The forces of stresses `factor` times as large, of a wheel that goes straight ahead.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let Components { traction, resistance, normal_support, shear_support } = self.components;
        let components = Components {
            traction: factor * traction,
            resistance: factor * resistance,
            normal_support: factor * normal_support,
            shear_support: factor * shear_support,
        };
        Self::new(components, factor * self.torque, self.integration_error)
    }

    /// The forces of both stresses together, of a wheel that goes straight ahead.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let (own, others) = (&self.components, &other.components);
        let components = Components {
            traction: own.traction + others.traction,
            resistance: own.resistance + others.resistance,
            normal_support: own.normal_support + others.normal_support,
            shear_support: own.shear_support + others.shear_support,
        };
        Self::new(components, self.torque + other.torque, self.integration_error.max(other.integration_error))
    }

    pub(crate) fn is_finite(&self) -> bool {
        let Components { traction, resistance, normal_support, shear_support } = self.components;
        let all = [traction, resistance, normal_support, shear_support, self.longitudinal, self.normal, self.torque];
        all.iter().all(|value| value.is_finite()) && self.side.is_none_or(|side| side.is_finite())
    }

    /// Scale on which the longitudinal force is accurate, |traction| + |resistance| (N): it is their difference.
    #[must_use]
    pub fn longitudinal_scale(&self) -> f64 {
        self.components.traction.abs() + self.components.resistance.abs()
    }

    /// Scale on which the normal force is accurate, |normal support| + |shear support| (N).
    #[must_use]
    pub fn normal_scale(&self) -> f64 {
        self.components.normal_support.abs() + self.components.shear_support.abs()
    }

    /// The forces of the wheel moving in `heading`: moving backward, those along x, the torque and M_z change sign.
    #[must_use]
    pub fn heading(self, heading: Heading) -> Self {
        match heading {
            Heading::Forward => self,
            Heading::Backward => Self {
                longitudinal: -self.longitudinal,
                torque: -self.torque,
                components: Components {
                    traction: -self.components.traction,
                    resistance: -self.components.resistance,
                    ..self.components
                },
                side: self.side.map(SideForce::mirrored),
                ..self
            },
        }
    }

    /// Drawbar coefficient F_x/F_z (–); none where F_z is not positive.
    #[must_use]
    pub fn drawbar_coefficient(&self) -> Option<f64> {
        let ratio = self.longitudinal / self.normal;
        (self.normal > 0.0 && ratio.is_finite()).then_some(ratio)
    }

    /// Tractive efficiency F_x v/(T ω) = F_x r_slip (1 − s)/T (–), with the slip counted on `circle`; defined only while the
    /// wheel drives: s ≥ 0 and a torque in the sense of the motion.
    #[must_use]
    pub fn tractive_efficiency(&self, wheel: &Wheel, circle: SlipRadius, slip: Slip, heading: Heading) -> Option<f64> {
        let ahead = self.heading(heading); // mirrored back: the ratio is the same for both headings
        let efficiency = ahead.longitudinal * circle.of(wheel) * (1.0 - slip.ratio()) / ahead.torque;
        (slip.is_driving() && ahead.torque > 0.0 && efficiency.is_finite()).then_some(efficiency)
    }
}

/// The place of the peak.
#[inline]
fn peak(patch: &ContactPatch<'_>) -> RimPoint {
    patch.rim_point(patch.angles.entry - patch.angles.peak)
}

/// σm and τm at the peak, with the depth there that a closed form takes.
#[inline]
pub(crate) fn peak_stresses(stresses: &StressField<'_>, peak_depth: PeakDepth) -> Stresses {
    let patch = stresses.patch;
    let peak = peak(patch);
    // Two zones have no shear stress at their peak, and the closed forms are refused there.
    let normal = stresses.curve.pressure(peak_depth.of(patch, &peak));
    Stresses { normal, shear: patch.mobilisation_of_one_zone(&peak) * patch.rolling.shear_strength(normal) }
}
