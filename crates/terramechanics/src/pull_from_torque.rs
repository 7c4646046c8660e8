//! How hard does a wheel pull whose torque and load are measured? No soil is needed (Ding et al. 2009, 2015; sources 7, 4; letter,
//! Eq. 11).
//!
//! Of linear stresses T = r_s H Y gives Y, W = A X + B Y then X, and F_x = A Y − B X is
//!
//! F_x = (A/H + B²/(A H)) T/r_s − (B/A) W: [`pull_from_torque`].
//!
//! Units: N, N·m. A, B and H are the letter's (12), of the contact alone. Validity: linear stresses on contacts of one zone. On the
//! single-wheel tests of Ding et al. 2011 (source 6) it gives the measured pull within 0.024 (smooth) and 0.027 (lugs) of the load,
//! which no form with a soil does.
//!
//! The shear stress has one sign along the contact where the circle of the displacement slips one way all along: backwards where it
//! does not skid, forwards where it skids so much that cos θ > 1/κ up to its entry. A torque of the other sign contradicts the slip:
//! [`torque_against_slip`].

use crate::braking::Braking;
use crate::caution::{Caution, TORQUE_AGAINST_SLIP};
use crate::circles::Kinematics;
use crate::contact::{Contact, angle_at_depth};
use crate::error::Error;
use crate::forces::{NormalStressRadius, ShapeIntegrals};
use crate::rolling::WheelOnSoil;
use crate::slip::Slip;
use crate::track::Measured;
use crate::wheel::Wheel;

/// Forces that follow from those that are known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoupledForces {
    /// Longitudinal force F_x, the drawbar pull (N).
    pub longitudinal: f64,
    /// Torque T (N·m): the one measured, else what follows from the load.
    pub torque: f64,
    /// Normal stress σm at the peak (Pa) that load and torque leave.
    pub peak_normal_stress: f64,
    /// Shear stress τm at the peak (Pa) that the torque shows.
    pub peak_shear_stress: f64,
}

/// What follows from the torque and the load of a wheel that moves forward, in a contact of that shape.
///
/// # Errors
/// [`Error::Invalid`] for a load not greater than 0 or a torque that is not finite; [`Error::NotFinite`] where a result overflows.
///
/// ```
/// use terramechanics::*;
/// // Triangular stresses with σm = 9000 Pa in a contact of θ1 = 0.7 rad, c = 500 Pa, φ = 0.6, K = 20 mm at a slip of 0.3: an
/// // independent evaluation gave 70.459026 N, 7.0004767 N·m and 11.1630643 N.
/// let wheel = Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 })?;
/// let angles = Contact::MIDPOINT.angles(1.0 - 0.7_f64.cos(), Slip::new(0.3)?)?;
/// let measured = Measured { torque: 7.0004767, normal_load: 70.459026 };
/// let found = pull_from_torque(&wheel, &ShapeIntegrals::of(&angles), measured, NormalStressRadius::Rim)?;
/// assert!((found.longitudinal - 11.1630643).abs() < 1e-6);
/// assert!((found.peak_normal_stress - 9000.0).abs() < 1e-2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pull_from_torque(
    wheel: &Wheel,
    shape: &ShapeIntegrals,
    measured: Measured,
    normal_stress_radius: NormalStressRadius,
) -> Result<CoupledForces, Error> {
    let Measured { torque, normal_load } = measured;
    WheelOnSoil::NORMAL_LOAD.check(normal_load).map_err(Error::Invalid)?;
    WheelOnSoil::TORQUE.check(torque).map_err(Error::Invalid)?;
    let ShapeIntegrals { a, b, h } = *shape;
    let y = torque / (wheel.shearing_radius() * h); // Eq. (11c), with r_s (erratum 6)
    let x = (normal_load - b * y) / a; // Eq. (11b)
    let forces = CoupledForces {
        longitudinal: (a + b * b / a) * y - b / a * normal_load, // A Y − B X, Eq. (11a)
        torque,
        peak_normal_stress: x / (normal_stress_radius.of(wheel) * wheel.width()),
        peak_shear_stress: y / (wheel.shearing_radius() * wheel.width()),
    };
    let results = [forces.longitudinal, forces.torque, forces.peak_normal_stress, forces.peak_shear_stress];
    if results.iter().all(|value| value.is_finite()) { Ok(forces) } else { Err(Error::NotFinite) }
}

/// A warning where a torque (N·m) has the sign that no shear stress has on a wheel that moves forward at this slip and sinkage (m).
///
/// ```
/// use terramechanics::*;
/// let wheel = Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 })?;
/// let told = |slip, torque| Ok::<_, Error>(torque_against_slip(&wheel, &Contact::MIDPOINT, Slip::new(slip)?, 0.02, torque).is_some());
/// assert!(told(0.2, -6.0)? && !told(0.2, 6.0)?); // driving
/// assert!(told(-0.5, 6.0)? && !told(-0.5, -6.0)?); // braking hard
/// assert!(!told(-0.01, 6.0)? && !told(-0.01, -6.0)?); // about to roll freely
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn torque_against_slip(wheel: &Wheel, contact: &Contact, slip: Slip, sinkage: f64, torque: f64) -> Option<Caution> {
    let kinematics = Kinematics::of(contact.circles(), wheel, slip);
    let drives = kinematics.skid <= 0.0;
    // 1 − cos of the entry of the circle of the displacement: the depth of that circle over its radius.
    let depth_ratio = (kinematics.offset + sinkage) / kinematics.radius;
    let behind = contact.params().exit.exit(angle_at_depth(sinkage / wheel.radius()), sinkage / wheel.radius());
    // Behind the mirrored entry the way gathered ahead may be undone.
    let mirrored = 2.0 * (0.5 * behind).sin().powi(2) <= depth_ratio;
    let one_way = slip.is_locked() || (kinematics.skid >= depth_ratio && mirrored);
    let brakes = one_way && contact.braking() == Braking::OneZone; // two zones shear both ways
    TORQUE_AGAINST_SLIP.when((drives && torque < 0.0) || (brakes && torque > 0.0))
}
