//! Where along the rim does the shear change its direction? The zeros of the shear displacement, at which an integral is split.

use crate::contact::Angles;
use crate::numerics::brent::{Sample, bracketed_root};
use crate::patch::ContactPatch;

impl ContactPatch<'_> {
    /// Arcs δ = θ1 − θ (rad) behind the entry, ascending, at which j changes sign: only where its circle skids, at most two,
    /// the second only behind the lowest point.
    ///
    /// With g(θ) = κ sin θ − θ, which is odd, j = r_j (g(θ) − g(θ1')); g rises between −θ* and θ* = arccos(1/κ) and falls
    /// outside. So j can vanish once on the rise and once more on the fall behind −θ*. Of two zones the one between them, the
    /// peak, is not listed, and θ0 < θ*. Where θ* ≥ θ1', the second lies behind −√3 θ1' or so, which no contact reaches.
    pub(crate) fn shear_reversals(&self) -> ShearReversals {
        let mut reversals = ShearReversals::default();
        let Angles { entry, exit, .. } = self.angles;
        if self.rolling.kinematics.skid <= 0.0 || self.rolling.slip.is_locked() {
            return reversals;
        }
        let turning = self.rolling.turning();
        if self.has_two_zones() {
            self.push_reversal_between(-turning, exit, &mut reversals); // j falls from θ0 on, until it turns
            return reversals;
        }
        if turning >= self.sheared_arc(&self.rim_point(entry)) {
            return reversals; // j falls from its own entry on
        }
        for (front, rear) in [(turning.min(entry), (-turning).max(exit)), (-turning, exit)] {
            self.push_reversal_between(front, rear, &mut reversals);
        }
        reversals
    }

    /// Adds the arc at which j changes sign between two angles (rad), if it does.
    fn push_reversal_between(&self, front: f64, rear: f64, reversals: &mut ShearReversals) {
        if rear >= front {
            return;
        }
        let at = |theta: f64| Sample { x: theta, y: self.shear_displacement(theta) };
        let (front, rear) = (at(front), at(rear));
        if front.y * rear.y >= 0.0 {
            return;
        }
        let find = |theta| Ok::<_, std::convert::Infallible>(self.shear_displacement(theta));
        // A reversal misplaced by ε changes the integral by about ε³, so this tolerance is ample.
        let Ok(found) = bracketed_root(find, front, rear, 1e-10);
        reversals.push(self.angles.entry - found.best.x);
    }
}

/// Up to two arcs (rad) at which the shear displacement changes sign.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ShearReversals {
    arcs: [f64; 2],
    count: usize,
}

impl ShearReversals {
    fn push(&mut self, arc: f64) {
        self.arcs[self.count] = arc;
        self.count += 1;
    }

    pub(crate) fn arcs(&self) -> &[f64] {
        &self.arcs[..self.count]
    }
}
