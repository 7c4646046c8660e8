//! What do measured forces tell without a pressure–sinkage law? The torque from the load, and the longitudinal force from load
//! and torque (Ding et al. 2009, 2015). The letter contrasts its own formulas with these coupled forms (below its Eq. 18).
//!
//! Linear stresses (letter, Eq. 11) give three equations: the normal force F_z = A X + B Y, the torque T = r_s H Y, and the
//! shear stress at the peak, Y = r_s E (b c + X tan φ/r_n). A known load W = F_z replaces the pressure–sinkage law, which
//! cancels:
//!
//! | what | here |
//! |---|---|
//! | T = r_s² H E [b c + W tan φ/(r_n A)] / [1 + r_s B E tan φ/(r_n A)] | [`Coupled::forces`] without a torque |
//! | F_x = (A/H + B²/(A H)) T/r_s − (B/A) W | [`pull_from_torque`] |
//!
//! Units: SI. Validity: that of linear stresses. If a wheel brakes so hard that the shear stress takes away all that the normal
//! stress supports, the denominator vanishes and the wheel is refused. If the load is below what the shear stress alone
//! supports, the normal stress is negative, and [`CoupledForces::caution`] says so.
//!
//! Departures: the papers were not read; the formulas were seen in public simulation code, with r for r_n. That code also has
//! coefficients fitted to one test wheel, by which torque and pull vary with the load; they are left out. The forms above were
//! derived from Eq. (11) for lugs and for both radii of the normal stress, and tests compare them with the linearised method.

use crate::braking::Braking;
use crate::caution::{Caution, DEEP_SINKAGE, NEGATIVE_NORMAL_STRESS, SLIP_BEYOND_COUPLED_TESTS};
use crate::contact::Angles;
use crate::error::Error;
use crate::forces::{NormalStressRadius, ShapeIntegrals};
use crate::motion::Heading;
use crate::outcome::{interface_caution, system_cautions};
use crate::patch::ContactPatch;
use crate::pull_from_torque::{CoupledForces, pull_from_torque, torque_against_slip};
use crate::rolling::{Rolling, WheelOnSoil};
use crate::slip::Slip;
use crate::track::Measured;

/// Least share of the support by the normal stress that the shear stress of a braking wheel may leave: with less, the difference
/// would lose seven digits of the torque.
const LEAST_SUPPORT: f64 = 1e-7;

/// What is known of the forces on a wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coupled {
    /// Normal load W (N), greater than 0.
    pub normal_load: f64,
    /// Torque T (N·m), where it was measured; positive when it turns the wheel in its direction of motion.
    pub torque: Option<f64>,
    /// The radius at which the normal stress acts.
    pub normal_stress_radius: NormalStressRadius,
}

impl Coupled {
    /// Torque and longitudinal force of a wheel that moves forward in the contact `patch`.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a load not greater than 0 or a torque that is not finite; [`Error::LoadNotCoupled`] where no
    /// normal stress carries the load; [`Error::NotFinite`] where a result overflows.
    ///
    /// ```
    /// use terramechanics::*;
    /// // A contact of θ1 = 0.5 rad at 10 % slip under 25.1728984 N: an independent evaluation of the triangular stresses
    /// // with σm = 5000 Pa gave T = 0.8743675 N·m and F_x = −1.9390407 N.
    /// let system = WheelOnSoil {
    ///     wheel: Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 })?,
    ///     soil: Soil::new(SoilParams {
    ///         cohesion: 0.0,
    ///         friction_angle: 0.478,
    ///         shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.02 })),
    ///         pressure_sinkage: None, // it cancels
    ///         ..SoilParams::BARE
    ///     })?,
    ///     contact: Contact::MIDPOINT,
    /// };
    /// let rolling = system.rolling(Slip::new(0.1)?)?;
    /// let patch = rolling.contact(0.2 * (1.0 - 0.5_f64.cos()))?;
    /// let known = Coupled { normal_load: 25.1728984, torque: None, normal_stress_radius: NormalStressRadius::Rim };
    /// let forces = known.forces(&patch)?;
    /// assert!((forces.torque - 0.8743675).abs() < 1e-6);
    /// assert!((forces.longitudinal + 1.9390407).abs() < 1e-6);
    /// assert!((forces.peak_normal_stress - 5000.0).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn forces(&self, patch: &ContactPatch<'_>) -> Result<CoupledForces, Error> {
        WheelOnSoil::NORMAL_LOAD.check(self.normal_load).map_err(Error::Invalid)?;
        let wheel = &patch.rolling.system.wheel;
        let torque = match self.torque {
            Some(torque) => torque,
            None => self.torque_from_load(patch, self.normal_stress_radius.of(wheel))?,
        };
        let measured = Measured { torque, normal_load: self.normal_load };
        pull_from_torque(wheel, &ShapeIntegrals::of(&patch.angles), measured, self.normal_stress_radius)
    }

    /// The same of the wheel of `system` at a slip and a sinkage (m), with the angles of its contact. Where the torque was measured the
    /// soil has no influence, save on the angles of a braking wheel with two zones; and the slip has none, save on the angles of such a
    /// wheel and of a contact whose peak moves with it.
    ///
    /// # Errors
    /// [`Error::SinkageOutsideWheel`], [`Error::PeakOutsideContact`]; what [`Coupled::forces`] refuses; without a torque or with two
    /// zones what [`WheelOnSoil::rolling_under_load`] and [`Rolling::contact`] refuse.
    ///
    /// ```
    /// use terramechanics::*;
    /// // Triangular stresses with σm = 9000 Pa in a contact of θ1 = 0.7 rad, as in `pull_from_torque`, on a soil that is nothing.
    /// let system = WheelOnSoil {
    ///     wheel: Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 })?,
    ///     soil: Soil::new(SoilParams::BARE)?,
    ///     contact: Contact::MIDPOINT,
    /// };
    /// let radius = NormalStressRadius::Rim;
    /// let known = Coupled { normal_load: 70.459026, torque: Some(7.0004767), normal_stress_radius: radius };
    /// let (_, forces) = known.at(&system, Slip::new(0.3)?, 0.2 * (1.0 - 0.7_f64.cos()))?;
    /// assert!((forces.longitudinal - 11.1630643).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn at(&self, system: &WheelOnSoil, slip: Slip, sinkage: f64) -> Result<(Angles, CoupledForces), Error> {
        let WheelOnSoil { wheel, contact, .. } = system;
        let Some(torque) = self.torque.filter(|_| contact.braking() == Braking::OneZone) else {
            let rolling = system.rolling_under_load(slip)?;
            let patch = rolling.contact(sinkage)?;
            return Ok((patch.angles, self.forces(&patch)?));
        };
        let radius = wheel.radius();
        if !(sinkage > 0.0 && sinkage <= radius) {
            return Err(Error::SinkageOutsideWheel { sinkage, radius });
        }
        let angles = contact.angles(sinkage / radius, slip)?;
        let measured = Measured { torque, normal_load: self.normal_load };
        Ok((angles, pull_from_torque(wheel, &ShapeIntegrals::of(&angles), measured, self.normal_stress_radius)?))
    }

    fn torque_from_load(&self, patch: &ContactPatch<'_>, normal_radius: f64) -> Result<f64, Error> {
        let Rolling { system, strength, .. } = patch.rolling;
        let shearing_radius = system.wheel.shearing_radius();
        let ShapeIntegrals { a, b, h } = ShapeIntegrals::of(&patch.angles);
        let mobilisation = patch.peak_mobilisation();
        let friction = strength.tan_friction / (normal_radius * a);
        let support = 1.0 + shearing_radius * mobilisation * b * friction;
        if support.is_nan() || support < LEAST_SUPPORT {
            return Err(Error::LoadNotCoupled { support });
        }
        let strength = system.wheel.width() * strength.cohesion + self.normal_load * friction;
        Ok(shearing_radius * shearing_radius * h * mobilisation * strength / support)
    }
}

impl CoupledForces {
    /// The forces of the wheel moving in `heading`: moving backward, those along x and the torque change sign.
    #[must_use]
    pub fn heading(self, heading: Heading) -> Self {
        match heading {
            Heading::Forward => self,
            Heading::Backward => Self { longitudinal: -self.longitudinal, torque: -self.torque, ..self },
        }
    }

    /// A warning where load and torque together leave a negative normal stress: by linear stresses they do not belong
    /// together.
    #[must_use]
    pub fn caution(&self) -> Option<Caution> {
        NEGATIVE_NORMAL_STRESS.of(self.peak_normal_stress)
    }

    /// All that is to be taken with care at this sinkage (m) and, where it is known, this slip; nothing of the pressure–sinkage law,
    /// which cancels.
    pub fn cautions(&self, system: &WheelOnSoil, slip: Option<Slip>, sinkage: f64) -> impl Iterator<Item = Caution> + use<> {
        let against = slip.and_then(|slip| torque_against_slip(&system.wheel, &system.contact, slip, sinkage, self.torque));
        let own = [self.caution(), against];
        own.into_iter().flatten().chain(coupled_cautions(system, slip, sinkage))
    }
}

/// What is to be taken with care of the coupled forms at this sinkage (m) and, where it is known, this slip, whatever load and torque
/// are.
pub(crate) fn coupled_cautions(system: &WheelOnSoil, slip: Option<Slip>, sinkage: f64) -> impl Iterator<Item = Caution> + use<> {
    let own = [
        DEEP_SINKAGE.of(sinkage / system.wheel.radius()),
        slip.and_then(|slip| SLIP_BEYOND_COUPLED_TESTS.of(slip.ratio())),
        interface_caution(&system.wheel, system.contact.params()),
    ];
    own.into_iter().flatten().chain(system_cautions(system))
}
