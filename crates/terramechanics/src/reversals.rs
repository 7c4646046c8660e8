//! Where along the rim does the shear change its direction? The zeros of the shear displacement, at which an integral is split.
//!
//! Newton's method finds them from the zeros of the displacement's cubic series; a bracket does where it leaves the range.

use crate::contact::Angles;
use crate::numerics::brent::{Sample, bracketed_root};
use crate::patch::ContactPatch;
use crate::rim::RimPoint;

/// Length (rad) of a step of Newton's method after which the next one is below rounding: the steps square.
const SETTLED: f64 = 1e-6;

/// Most steps.
const STEPS: u32 = 8;

/// Error (relative) of a place that a bracket finds. A reversal misplaced by ε changes the integral by about ε³, so it is ample.
const TOLERANCE: f64 = 1e-10;

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
        if let (Some(zones), Some(parted)) = (self.zones(), self.rolling.reversal) {
            if -turning > exit {
                let behind = |place: &RimPoint| zones.displacement_behind(self.rolling, place);
                let [_, near] = self.equals_of(parted);
                self.push_reversal_between(behind, [-turning, exit], near, &mut reversals); // j falls from θ0 on, until it turns
            }
            return reversals;
        }
        let sheared_entry = entry + self.lead.arc;
        if turning >= sheared_entry {
            return reversals; // j falls from its own entry on
        }
        let j = |place: &RimPoint| self.displacement(place);
        let [ahead, behind] = self.equals_of(sheared_entry);
        self.push_reversal_between(j, [turning.min(entry), (-turning).max(exit)], ahead, &mut reversals);
        self.push_reversal_between(j, [-turning, exit], behind, &mut reversals);
        reversals
    }

    /// Angles (rad) at which g is about what it is at `angle` (rad), the larger first; not numbers where there are none.
    ///
    /// By its series g(θ) = (κ − 1) θ − κ θ³/6, which is a cubic with a known zero: θ² + a θ + a² = 6 (κ − 1)/κ.
    fn equals_of(&self, angle: f64) -> [f64; 2] {
        let root = (24.0 * self.rolling.kinematics.skid - 3.0 * angle * angle).sqrt();
        [0.5 * (root - angle), -0.5 * (root + angle)]
    }

    /// Adds the arc at which `j` (m) changes sign between two angles (rad), if it does; perhaps near the angle `near` (rad).
    fn push_reversal_between(
        &self,
        j: impl Fn(&RimPoint) -> f64,
        [front, rear]: [f64; 2],
        near: f64,
        reversals: &mut ShearReversals,
    ) {
        if rear >= front {
            return;
        }
        let place = |theta: f64| self.rim_point(self.angles.entry - theta);
        let at = |theta: f64| Sample { x: theta, y: j(&place(theta)) };
        let (front, rear) = (at(front), at(rear));
        if front.y * rear.y >= 0.0 {
            return;
        }
        let by_steps = || {
            let mut theta = near;
            for _ in 0..STEPS {
                if !(theta > rear.x && theta < front.x) {
                    return None;
                }
                let place = place(theta);
                // dj/dθ = −r_j (1 − κ cos θ)
                let step = j(&place) / (self.rolling.kinematics.radius * self.slip_velocity(&place));
                theta += step;
                if step.abs() <= SETTLED {
                    return Some(theta.clamp(rear.x, front.x));
                }
            }
            None
        };
        let theta = by_steps().unwrap_or_else(|| {
            let Ok(found) = bracketed_root(|theta| Ok::<_, std::convert::Infallible>(at(theta).y), front, rear, TOLERANCE);
            found.best.x
        });
        reversals.push(self.angles.entry - theta);
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

#[cfg(test)]
mod tests {
    use crate::braking::Braking;
    use crate::circles::{Circles, SlipRadius};
    use crate::contact::{AngleRatio, Contact, ContactParams, ExitRule};
    use crate::numerics::brent::{Sample, bracketed_root};
    use crate::pressure_sinkage::{Direct, PressureSinkage, SinkageExponent};
    use crate::rolling::WheelOnSoil;
    use crate::shear::{JanosiHanamoto, ShearLaw};
    use crate::slip::Slip;
    use crate::soil::{Soil, SoilParams};
    use crate::wheel::{Wheel, WheelParams};

    /// Every change of sign of j between a thousand places, closed in on by a bracket, is among the reversals, and no other.
    #[test]
    fn the_reversals_are_the_changes_of_sign() {
        const PLACES: u32 = 1000;
        const PLACE: f64 = 1e-9; // what the bracket leaves
        let soil = Soil::new(SoilParams {
            friction_angle: 0.5,
            shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.01 })),
            pressure_sinkage: Some(PressureSinkage::Direct(Direct {
                k_s: 1e6,
                exponent: SinkageExponent { base: 1.0, slip_gain: 0.0, skid_gain: None },
            })),
            ..SoilParams::BARE
        })
        .expect("a soil");
        let mut found = [0; 3];
        for (lug_height, braking, c3) in [
            (0.0, Braking::OneZone, 0.0),
            (0.0, Braking::OneZone, -0.95),
            (0.02, Braking::OneZone, -0.3),
            (0.0, Braking::TwoZone, -0.9),
            (0.01, Braking::TwoZone, -0.5),
        ] {
            let exit = ExitRule::AngleRatio(AngleRatio { c3 });
            let circles = Circles { slip: SlipRadius::LugTip, ..Circles::SHEARING };
            let contact = Contact::new(ContactParams { exit, circles, ..ContactParams::MIDPOINT }).expect("a contact");
            let wheel = Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height, lug_coefficient: 0.5 }).expect("a wheel");
            let system = WheelOnSoil { wheel, soil, contact: contact.with_braking(braking) };
            for skid in (1..100).map(|i| 0.01 * f64::from(i)).chain([1e-9, 1e-6, 1e-4, 1e-3, 3e-3]) {
                let rolling = system.rolling(Slip::new(-skid).expect("a slip")).expect("a rolling wheel");
                for sinkage in [1e-9, 1e-6, 1e-4, 0.002, 0.01, 0.03, 0.08, 0.15, 0.2] {
                    let Ok(patch) = rolling.contact(sinkage) else { continue };
                    let angles = patch.angles;
                    let front = if patch.has_two_zones() { angles.peak } else { angles.entry };
                    let place = |i: u32| front - (front - angles.exit) * (f64::from(i) + 0.5) / f64::from(PLACES);
                    let at = |i: u32| Sample { x: place(i), y: patch.shear_displacement(place(i)) };
                    let changes = (1..PLACES).map(|i| (at(i - 1), at(i))).filter(|(a, b)| a.y * b.y < 0.0);
                    let expected: Vec<f64> = changes
                        .map(|(a, b)| {
                            let find = |theta| Ok::<_, std::convert::Infallible>(patch.shear_displacement(theta));
                            let Ok(root) = bracketed_root(find, a, b, 1e-13);
                            angles.entry - root.best.x
                        })
                        .collect();
                    let reversals = patch.shear_reversals();
                    let step = (front - angles.exit) / f64::from(PLACES);
                    let inside: Vec<f64> = reversals
                        .arcs()
                        .iter()
                        .copied()
                        .filter(|arc| *arc > angles.entry - front + step && *arc < angles.entry - angles.exit - step)
                        .collect();
                    assert!(inside.len() <= expected.len(), "{skid} {sinkage} {inside:?} {expected:?}");
                    for root in &expected {
                        let nearest = reversals.arcs().iter().map(|arc| (arc - root).abs()).fold(f64::INFINITY, f64::min);
                        assert!(nearest <= PLACE * angles.entry, "{skid} {sinkage} {reversals:?} {root}");
                    }
                    found[expected.len()] += 1;
                }
            }
        }
        assert!(found.iter().all(|count| *count > 10), "{found:?}");
    }
}
