//! How much does a free-rolling wheel skid, and what does it take to tow it? (Wong & Reece 1967, part II)
//!
//! Only the soil turns the wheel, so T = 0. Skid s and sinkage z follow from F_z = W and T = 0; the towing resistance is then
//! −F_x. The paper does this with the two zones of [`crate::Braking::TwoZone`], whose shear then balances. With one zone the
//! same two conditions give the letter's model of a towed wheel. The contact of the system chooses between them.
//!
//! A rolling wheel (s = 0) takes a torque, T > 0; with skid the torque falls. Where it passes 0 the wheel keeps its skid: with
//! less skid the missing torque slows it, with more the soil speeds it up. The skid that counts is that of the circle on which the
//! shear displacement is counted: where that does not skid, all shear drives. The skid is sought on a ladder from far less than
//! the contact's geometry calls for, then by Brent's method, each trial solving the load balance. So the least skid without
//! torque is found, unless two lie between neighbouring rungs. Where a trial has no contact or carries no such load, the skids
//! between it and its neighbour are tried by halving.

use crate::circles::Kinematics;
use crate::contact::Angles;
use crate::error::Error;
use crate::forces::{ForceModel, Forces, Method};
use crate::numerics::brent::{Sample, bracketed_root};
use crate::rolling::WheelOnSoil;
use crate::slip::Slip;

/// Relative tolerance of the skid: finer than this the error of the load balance hides the torque.
const TOLERANCE: f64 = 1e-12;

/// Largest torque that counts as zero, relative to the larger one at the ends of the bracket: where E jumps, the torque changes
/// sign without a zero.
const LARGEST_RESIDUAL: f64 = 1e-6;

/// First skid of the ladder over θ1². E first changes sign at a skid of about θ1²/6, and this is below a hundredth of it.
const FIRST: f64 = 1e-3;

/// Factor from one rung of the ladder to the next.
const RUNG: f64 = 4.0;

/// Lowest start of the ladder: 50 rungs below 1.
const LEAST: f64 = 1e-30;

/// Halvings that close in on the last skid with a solution.
const HALVINGS: u32 = 40;

/// A towed wheel that rolls freely under its load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Towed {
    /// The slip as it is counted; below 0 where that is on the circle of the displacement.
    pub slip: Slip,
    /// Sinkage z (m).
    pub sinkage: f64,
    /// Characteristic angles.
    pub angles: Angles,
    /// The forces: the normal force carries the load, and the torque is 0 to the accuracy of the skid.
    pub forces: Forces,
    /// Load balances that were solved.
    pub balances: u32,
}

impl Towed {
    /// Towing resistance −F_x (N).
    #[must_use]
    pub fn resistance(&self) -> f64 {
        -self.forces.longitudinal
    }
}

impl WheelOnSoil {
    /// The wheel rolling freely under `load` (N), by the quadrature with the normal stress at the rim.
    ///
    /// # Errors
    /// What [`ForceModel::solve_towed`] refuses.
    pub fn solve_towed(&self, load: f64) -> Result<Towed, Error> {
        ForceModel::at_rim(Method::Quadrature).solve_towed(self, load)
    }
}

impl ForceModel {
    /// The wheel of `system` rolling freely under `load` (N).
    ///
    /// # Errors
    /// What [`ForceModel::solve_sinkage`] refuses at every skid; [`Error::NotFreeRolling`] where the torque does not pass 0 at
    /// any skid at which it can be found, as on a soil without shear strength.
    pub fn solve_towed(&self, system: &WheelOnSoil, load: f64) -> Result<Towed, Error> {
        let mut search = Search { model: self, system, load, balances: 0 };
        let (less, more) = search.bracket()?;
        let sample = |trial: &Trial| Sample { x: trial.skid, y: trial.torque() };
        let found = bracketed_root(|skid| Ok(search.at(skid)?.torque()), sample(&less), sample(&more), TOLERANCE)?;
        let trial = search.at(found.best.x)?;
        let scale = less.torque().max(-more.torque());
        if found.converged && trial.torque().abs() <= LARGEST_RESIDUAL * scale {
            Ok(Towed { balances: search.balances, ..trial.towed })
        } else {
            Err(search.not_free(&trial))
        }
    }
}

/// The loaded wheel at a skid.
#[derive(Clone, Copy)]
struct Trial {
    /// Skid of the circle of the displacement, from 0 to 1.
    skid: f64,
    towed: Towed,
}

impl Trial {
    fn torque(&self) -> f64 {
        self.towed.forces.torque
    }
}

struct Search<'a> {
    model: &'a ForceModel,
    system: &'a WheelOnSoil,
    load: f64,
    balances: u32,
}

impl Search<'_> {
    /// The loaded wheel at this skid, with whatever torque it then has.
    fn at(&mut self, skid: f64) -> Result<Trial, Error> {
        self.balances += 1;
        let WheelOnSoil { wheel, contact, .. } = self.system;
        let slip = Slip::new(Kinematics::slip_ratio_at(contact.circles(), wheel, skid))?;
        let rolling = self.model.rolling(self.system, slip)?;
        let carried = self.model.solve_sinkage(&rolling, self.load)?;
        let angles = self.model.contact(&rolling, carried.sinkage)?.angles;
        let towed =
            Towed { slip: rolling.slip, sinkage: carried.sinkage, angles, forces: carried.forces, balances: self.balances };
        Ok(Trial { skid, towed })
    }

    fn not_free(&self, nearest: &Trial) -> Error {
        Error::NotFreeRolling { load: self.load, slip: nearest.towed.slip.ratio(), torque: nearest.torque() }
    }

    /// Two skids: at the first the torque is above 0, at the second below.
    fn bracket(&mut self) -> Result<(Trial, Trial), Error> {
        let rolling = self.at(0.0);
        if let Err(error @ Error::Invalid(_)) = rolling {
            return Err(error);
        }
        let mut skid = (FIRST * rolling.map_or(1.0, |rolling| rolling.towed.angles.entry.powi(2))).max(LEAST);
        let mut less = None;
        let mut refusal = None;
        loop {
            match (self.at(skid), less) {
                (Ok(here), _) if here.torque() > 0.0 => less = Some(here),
                (Ok(here), Some(less)) if here.torque() < 0.0 => return Ok((less, here)),
                (Ok(here), None) if here.torque() < 0.0 && refusal.is_some() => {
                    return self.bracket_beside(here, skid / RUNG);
                }
                (Ok(here), _) => return Err(self.not_free(&here)),
                (Err(_), Some(less)) => return self.bracket_beside(less, skid),
                (Err(error), None) => refusal = refusal.or(Some(error)),
            }
            if skid >= 1.0 {
                break;
            }
            skid = (skid * RUNG).min(1.0);
        }
        match (less, refusal) {
            (Some(less), _) => Err(self.not_free(&less)),
            (None, refusal) => Err(refusal.unwrap_or(Error::NotFinite)),
        }
    }

    /// A bracket between a skid whose torque has one sign and a skid that has no solution.
    fn bracket_beside(&mut self, mut known: Trial, mut none: f64) -> Result<(Trial, Trial), Error> {
        for _ in 0..HALVINGS {
            let middle = 0.5 * (none + known.skid);
            match self.at(middle) {
                Ok(here) if here.torque() > 0.0 && known.torque() < 0.0 => return Ok((here, known)),
                Ok(here) if here.torque() < 0.0 && known.torque() > 0.0 => return Ok((known, here)),
                Ok(here) => known = here,
                Err(_) => none = middle,
            }
        }
        Err(self.not_free(&known))
    }
}
