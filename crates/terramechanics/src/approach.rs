//! How deep does a loaded wheel sink, where the balance is unique? Newton's method on the normal force and its slope.
//!
//! ln F_z is nearly a straight line over ln z, with a slope of about N + 1/2, so a step by the slope in place leaves about a tenth of
//! the square of the error. One pass over the contact gives the forces and their slopes. The first passes take few nodes; the last
//! takes all, and where its step is so small that the forces are linear in it, they are corrected instead of computed anew.
//!
//! On a wheel whose circle of displacement does not skid and whose exit is at the lowest point, F_z grows with z, and so it does in
//! grains: any balance is the one. Under a wheel that skids it need not grow throughout. There a balance counts where F_z rises through
//! the load all the way from Bekker's estimate to it, as seen at [`ON_THE_WAY`]. Elsewhere, and wherever a step goes astray, the
//! search in a bracket (`load.rs`) decides.
//!
//! The two zones of a braking wheel need a least sinkage, from which the search counts then.

use crate::forces::{ForceModel, Forces, Method, resistive};
use crate::load::{CarriedLoad, bekker_estimate};
use crate::rolling::{Rolling, WheelOnSoil};

/// Step in ln z within which the forces are linear: its square is below the rounding of a solved sinkage.
pub(crate) const LINEAR: f64 = 3e-7;

/// Step in ln z after which few nodes tell no more: what it leaves is less than [`LINEAR`].
const SETTLED: f64 = 1.5e-3;

/// Longest step in ln z that is followed.
pub(crate) const LONGEST: f64 = 3.0;

/// Places on the way from the balance to Bekker's estimate at which F_z is looked at under a wheel that skids, as shares of the way in
/// ln z.
const ON_THE_WAY: [f64; 2] = [0.5, 1.0];

/// Distance in ln z from the balance within which a look by few nodes does not tell on which side of the load F_z is.
const TOO_CLOSE: f64 = 0.05;

/// Most passes with few nodes, and with all.
const COARSE_PASSES: u32 = 6;
const FINE_PASSES: u32 = 4;

/// A search for the sinkage at which a wheel of that motion carries a load (N).
struct Search<'a> {
    model: &'a ForceModel,
    rolling: &'a Rolling<'a>,
    load: f64,
    /// Sinkages (m) between which there is a contact; the search counts from the smaller.
    least: f64,
    most: f64,
}

/// A sinkage on the way, and what was found there.
struct Pass {
    /// Sinkage beyond the least one (m).
    beyond: f64,
    forces: Forces,
    /// Change of the forces over the logarithm of that (N).
    slopes: Forces,
    /// Step in that logarithm to the balance.
    step: f64,
}

impl ForceModel {
    /// The balance with `load` (N) near the sinkage `guess` (m), which is `close` where it comes from a neighbour; none where it is
    /// not known to be the one or the method finds no way.
    pub(crate) fn approach(&self, rolling: &Rolling<'_>, load: f64, guess: f64, close: bool) -> Option<CarriedLoad> {
        if !self.has_slopes(rolling) {
            return None;
        }
        let (least, most) = rolling.sinkages();
        let search = Search { model: self, rolling, load, least, most };
        let found = search.balance(guess, close)?;
        (self.has_one_balance(rolling) || search.rises_to(found.sinkage)?).then_some(found)
    }

    /// The same from Bekker's estimate; none for a load that is not greater than 0.
    pub(crate) fn approach_alone(&self, rolling: &Rolling<'_>, load: f64) -> Option<CarriedLoad> {
        WheelOnSoil::NORMAL_LOAD.check(load).ok()?;
        let guess = bekker_estimate(&rolling.system.wheel, &self.guide(rolling).ok()?, load);
        self.approach(rolling, load, guess, false)
    }

    /// Whether the method knows how its forces change as the wheel sinks.
    fn has_slopes(&self, rolling: &Rolling<'_>) -> bool {
        match self.method {
            Method::ResistiveForce => true,
            Method::Quadrature => !rolling.slip.is_locked(),
            Method::Linearised { .. } | Method::Explicit { .. } => !rolling.slip.is_locked() && rolling.reversal.is_none(),
            Method::SideSlipping(_) => false,
        }
    }

    /// Whether F_z grows with z where the contact leaves at the lowest point.
    fn has_one_balance(&self, rolling: &Rolling<'_>) -> bool {
        // All of an edge in grains is pushed up, see `response.rs`.
        self.method == Method::ResistiveForce || rolling.reversal.is_none() && rolling.kinematics.skid <= 0.0
    }

    /// The forces at a sinkage (m) and their slopes over ln z.
    fn forces_and_slopes(&self, rolling: &Rolling<'_>, sinkage: f64, coarse: bool) -> Option<(Forces, Forces)> {
        if self.method == Method::ResistiveForce {
            return resistive::forces_and_slopes_in_grains(rolling, sinkage, coarse);
        }
        let patch = rolling.contact(sinkage).ok().filter(|patch| patch.angles.exit == 0.0)?;
        let (forces, changes) = self.forces_and_changes(&patch, coarse)?;
        Some((forces, changes.scaled(patch.entry_rate())))
    }
}

impl Search<'_> {
    fn balance(&self, guess: f64, close: bool) -> Option<CarriedLoad> {
        let closed_form = self.model.method.is_closed_form();
        let mut beyond = if close { guess - self.least } else { guess }.min(self.most - self.least);
        let mut iterations = 0;
        let coarse_passes = if close || closed_form { 0 } else { COARSE_PASSES };
        for _ in 0..coarse_passes {
            let pass = self.pass(beyond, true)?;
            iterations += 1;
            beyond = self.next(&pass)?;
            if pass.step.abs() < SETTLED {
                break;
            }
        }
        let fine_passes = if closed_form { COARSE_PASSES } else { FINE_PASSES };
        for _ in 0..fine_passes {
            let pass = self.pass(beyond, false)?;
            iterations += 1;
            if pass.step.abs() <= LINEAR {
                return self.corrected(&pass, iterations);
            }
            beyond = self.next(&pass)?;
        }
        None
    }

    /// The forces at a sinkage (m) beyond the least one, and the step from there.
    fn pass(&self, beyond: f64, coarse: bool) -> Option<Pass> {
        let sinkage = self.least + beyond;
        let (forces, slopes) = self.model.forces_and_slopes(self.rolling, sinkage, coarse)?;
        let slopes = slopes.scaled(beyond / sinkage);
        let step = (self.load / forces.normal).ln() * forces.normal / slopes.normal;
        let followed = forces.normal > 0.0 && slopes.normal > 0.0 && step.abs() <= LONGEST;
        followed.then_some(Pass { beyond, forces, slopes, step })
    }

    /// The sinkage (m) beyond the least one a step away; none where the wheel is in as far as it goes and would sink further.
    fn next(&self, pass: &Pass) -> Option<f64> {
        let span = self.most - self.least;
        (pass.beyond < span || pass.step < 0.0).then(|| (pass.beyond * pass.step.exp()).min(span))
    }

    /// The balance, a linear step away.
    fn corrected(&self, pass: &Pass, iterations: u32) -> Option<CarriedLoad> {
        let Pass { beyond, forces, slopes, step } = pass;
        let sinkage = self.least + beyond * (1.0 + step);
        let forces = Forces { integration_error: forces.integration_error, ..forces.plus(&slopes.scaled(*step)) };
        let found = CarriedLoad { sinkage, residual: forces.normal - self.load, iterations, forces };
        (sinkage <= self.most && forces.is_finite() && found.is_met(self.load)).then_some(found)
    }

    /// Whether F_z is seen to rise through the load between Bekker's estimate and a balance at `sinkage` (m).
    fn rises_to(&self, sinkage: f64) -> Option<bool> {
        let (wheel, span) = (&self.rolling.system.wheel, self.most - self.least);
        let estimate = bekker_estimate(wheel, self.rolling.curve().ok()?, self.load).min(span);
        let balance = sinkage - self.least;
        let way = (estimate / balance).ln();
        Some(way.abs() <= LONGEST && ON_THE_WAY.into_iter().map(|share| share * way).all(|way| self.rises_at(balance, way)))
    }

    /// Whether F_z grows at a place that is `way` in ln z off a `balance` (m beyond the least sinkage), from a side of the load that
    /// fits.
    fn rises_at(&self, balance: f64, way: f64) -> bool {
        way.abs() < TOO_CLOSE || self.pass(balance * way.exp(), true).is_some_and(|pass| pass.step * way < 0.0)
    }
}

#[cfg(test)]
mod tests;
