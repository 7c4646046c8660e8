//! What are the forces where the load is known as well as the sinkage? The load takes the place of the sinkage modulus, in every
//! method.
//!
//! The normal force is linear in K_s: F_z = K_s F_z1 + F_z0, where F_z0 is what cohesion alone carries and F_z1 the rest, so that
//!
//! K_s = (W − F_z0)/F_z1
//!
//! without iteration: [`ForceModel::forces_under`]. In the closed forms (letter, Eqs. 11–17) K_s z_m^N is one unknown, the normal
//! stress at the peak, and neither K_s nor N is needed: with y = r_s b E
//!
//! | quantity | formula |
//! |---|---|
//! | X = r_n b σm | (W − B y c)/(A + B (r_s/r_n) E tan φ) |
//! | Y | y (c + σm tan φ) |
//! | F_x, F_z, T | A Y − B X, A X + B Y = W, r_s H Y |
//!
//! These are Ding's coupled forms (Ding et al. 2009, 2015; sources 7, 4), see [`Coupled`](crate::Coupled). The quadrature needs N, for
//! the shape of the stresses, but no modulus.
//!
//! The load of a rover's wheel is known at least as well as its sinkage. As printed, the letter's forces from slip alone let F_z drift
//! with slip by 60 to 180 % of a load that in truth is constant (seven public sets of single-wheel tests).
//!
//! By the resistive force method the load takes the place of the granular stiffness ξ, to which all of its forces are proportional.
//!
//! Refused: a load that cohesion alone carries, and a braking wheel whose shear stress takes away what the normal stress supports.

use crate::error::Error;
use crate::forces::{ClosedForm, ForceModel, Forces, Method, resistive};
use crate::patch::ContactPatch;
use crate::pressure_sinkage::{PressureCurve, pressure};
use crate::rolling::WheelOnSoil;

/// Share of the parts of F_z1 that has to be left of them: with less, seven digits would be lost in the difference.
pub(crate) const LEAST_SUPPORT: f64 = 1e-7;

/// The forces of a wheel whose load is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadedForces {
    /// The forces; the normal one is the load.
    pub forces: Forces,
    /// Pressure over depth that the load shows: the modulus is a measurement of the soil in place. None where the soil has no
    /// exponent, which only closed forms do without.
    pub curve: Option<PressureCurve>,
    /// Granular stiffness ξ (N/m³) that the load shows, by the resistive force method.
    pub granular_stiffness: Option<f64>,
}

impl ForceModel {
    /// Forces and torque on the wheel that carries `load` W (N) in the contact `patch`.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a load not greater than 0; [`Error::LoadBelowCohesion`] where cohesion alone carries it;
    /// [`Error::LoadNotCoupled`] where no normal stress carries a load; [`Error::MissingLaw`] for a quadrature on a soil without an
    /// exponent; what [`ForceModel::forces`] refuses.
    ///
    /// ```
    /// use terramechanics::*;
    /// // A contact of θ1 = 0.5 rad at 10 % slip under 25.1728984 N, on a soil without a pressure–sinkage law: an independent
    /// // evaluation of the triangular stresses with σm = 5000 Pa gave T = 0.8743675 N·m and F_x = −1.9390407 N.
    /// let system = WheelOnSoil {
    ///     wheel: Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 })?,
    ///     soil: Soil::new(SoilParams {
    ///         cohesion: 0.0,
    ///         friction_angle: 0.478,
    ///         shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.02 })),
    ///         pressure_sinkage: None,
    ///         ..SoilParams::BARE
    ///     })?,
    ///     contact: Contact::MIDPOINT,
    /// };
    /// let rolling = system.rolling(Slip::new(0.1)?)?;
    /// let patch = rolling.contact(0.2 * (1.0 - 0.5_f64.cos()))?;
    /// let loaded = ForceModel::at_rim(Method::LINEARISED).forces_under(&patch, 25.1728984)?;
    /// assert!((loaded.forces.torque - 0.8743675).abs() < 1e-6);
    /// assert!((loaded.forces.longitudinal + 1.9390407).abs() < 1e-6);
    /// assert_eq!(loaded.curve, None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn forces_under(&self, patch: &ContactPatch<'_>, load: f64) -> Result<LoadedForces, Error> {
        WheelOnSoil::NORMAL_LOAD.check(load).map_err(Error::Invalid)?;
        if self.method == Method::ResistiveForce {
            return in_grains_under(patch, load);
        }
        self.check(patch)?;
        let loaded = match self.closed_form(patch) {
            Some(form) => {
                let normal = form.normal_stress_under(load)?;
                let exponent = patch.rolling.curve().ok().map(|curve| curve.exponent);
                let curve =
                    exponent.map(|exponent| PressureCurve { modulus: normal / pressure(1.0, exponent, form.depth), exponent });
                LoadedForces { forces: form.forces(normal).summed(), curve, granular_stiffness: None }
            }
            None => self.integrated_under(patch, load)?,
        };
        if loaded.forces.is_finite() { Ok(loaded) } else { Err(Error::NotFinite) }
    }

    /// The same by quadrature: F_z1 and F_z0 are integrals of their own, so nothing cancels.
    fn integrated_under(&self, patch: &ContactPatch<'_>, load: f64) -> Result<LoadedForces, Error> {
        let exponent = patch.rolling.curve()?.exponent;
        let cohesion = patch.rolling.strength.cohesion;
        let part = |modulus: f64, cohesion: f64| {
            let rolling = patch.rolling.pressed_by(PressureCurve { modulus, exponent }, cohesion);
            self.forces(&patch.with(&rolling))
        };
        let frictional = part(1.0, 0.0)?;
        if frictional.normal < LEAST_SUPPORT * frictional.normal_scale() {
            return Err(Error::LoadNotCoupled { support: frictional.normal / frictional.components.normal_support });
        }
        let cohesive = if cohesion > 0.0 { Some(part(0.0, cohesion)?) } else { None };
        let modulus = left_by(cohesive.map_or(0.0, |forces| forces.normal), load)? / frictional.normal;
        let curve = PressureCurve { modulus, exponent };
        let forces = match self.method {
            Method::SideSlipping(_) => {
                let rolling = patch.rolling.pressed_by(curve, cohesion);
                self.forces(&patch.with(&rolling))?
            }
            Method::Quadrature | Method::Linearised { .. } | Method::Explicit { .. } | Method::ResistiveForce => {
                let forces = frictional.scaled(modulus);
                cohesive.map_or(forces, |cohesive| forces.plus(&cohesive))
            }
        };
        Ok(LoadedForces { forces, curve: Some(curve), granular_stiffness: None })
    }
}

/// The same by the resistive force method, whose forces are proportional to the granular stiffness.
fn in_grains_under(patch: &ContactPatch<'_>, load: f64) -> Result<LoadedForces, Error> {
    let per_stiffness = resistive::forces_per_stiffness(patch.rolling, patch.sinkage)?;
    if per_stiffness.normal < LEAST_SUPPORT * per_stiffness.normal_scale() {
        return Err(Error::LoadNotCoupled { support: per_stiffness.normal / per_stiffness.components.normal_support });
    }
    let stiffness = load / per_stiffness.normal;
    let forces = per_stiffness.scaled(stiffness);
    if forces.is_finite() && stiffness.is_finite() {
        Ok(LoadedForces { forces, curve: None, granular_stiffness: Some(stiffness) })
    } else {
        Err(Error::NotFinite)
    }
}

/// What of the load (N) the normal stress has to carry beside what cohesion `carries` (N).
fn left_by(carries: f64, load: f64) -> Result<f64, Error> {
    if load > carries { Ok(load - carries) } else { Err(Error::LoadBelowCohesion { load, carries }) }
}

impl ClosedForm {
    /// σm (Pa) at the peak of the wheel that carries `load` W (N): F_z = A X + B Y = W, solved for it.
    fn normal_stress_under(&self, load: f64) -> Result<f64, Error> {
        let (cohesive, frictional, direct) = self.normal_force_parts();
        let scale = direct.abs() + (frictional - direct).abs();
        if frictional.is_nan() || frictional < LEAST_SUPPORT * scale || scale == 0.0 {
            return Err(Error::LoadNotCoupled { support: frictional / direct });
        }
        Ok(left_by(cohesive, load)? / frictional)
    }
}
