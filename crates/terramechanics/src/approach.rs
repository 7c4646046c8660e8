//! How deep does a loaded wheel sink, where the balance is unique? Newton's method on the normal force and its slope.
//!
//! ln F_z is nearly a straight line over ln z, with a slope of about N + 1/2, so a step by the slope in place leaves about a tenth of
//! the square of the error. One pass over the contact gives the forces and their slopes. The first passes take few nodes; the last
//! takes all, and where its step is so small that the forces are linear in it, they are corrected instead of computed anew.
//!
//! On a wheel whose circle of displacement does not skid and whose exit is at the lowest point, F_z grows with z: any balance is the
//! one. Elsewhere, and wherever a step goes astray, the search in a bracket (`load.rs`) decides.

use crate::forces::{ForceModel, Forces};
use crate::load::{CarriedLoad, bekker_estimate};
use crate::rolling::{Rolling, WheelOnSoil};

/// Step in ln z within which the forces are linear: its square is below the rounding of a solved sinkage.
pub(crate) const LINEAR: f64 = 3e-7;

/// Step in ln z after which few nodes tell no more: what it leaves is less than [`LINEAR`].
const SETTLED: f64 = 1.5e-3;

/// Longest step in ln z that is followed.
pub(crate) const LONGEST: f64 = 3.0;

/// Most passes with few nodes, and with all.
const COARSE_PASSES: u32 = 6;
const FINE_PASSES: u32 = 4;

/// A sinkage on the way, and what was found there.
struct Pass {
    sinkage: f64,
    forces: Forces,
    /// Change of the forces over ln z (N).
    slopes: Forces,
    /// Step in ln z to the balance.
    step: f64,
}

impl ForceModel {
    /// The balance with `load` (N) near the sinkage `guess` (m), which is `close` where it comes from a neighbour; none where it is
    /// not unique or the method finds no way.
    pub(crate) fn approach(&self, rolling: &Rolling<'_>, load: f64, guess: f64, close: bool) -> Option<CarriedLoad> {
        let kinematics = &rolling.kinematics;
        if !self.has_slopes() || rolling.reversal.is_some() || kinematics.skid > 0.0 || rolling.slip.is_locked() {
            return None;
        }
        let radius = rolling.system.wheel.radius();
        let mut sinkage = guess.min(radius);
        let mut iterations = 0;
        let coarse_passes = if close || self.method.is_closed_form() { 0 } else { COARSE_PASSES };
        for _ in 0..coarse_passes {
            let pass = self.pass(rolling, load, sinkage, true)?;
            iterations += 1;
            sinkage = pass.next(radius)?;
            if pass.step.abs() < SETTLED {
                break;
            }
        }
        let fine_passes = if self.method.is_closed_form() { COARSE_PASSES } else { FINE_PASSES };
        for _ in 0..fine_passes {
            let pass = self.pass(rolling, load, sinkage, false)?;
            iterations += 1;
            if pass.step.abs() <= LINEAR {
                return pass.corrected(load, radius, iterations);
            }
            sinkage = pass.next(radius)?;
        }
        None
    }

    /// The same from Bekker's estimate; none for a load that is not greater than 0.
    pub(crate) fn approach_alone(&self, rolling: &Rolling<'_>, load: f64) -> Option<CarriedLoad> {
        WheelOnSoil::NORMAL_LOAD.check(load).ok()?;
        let guess = bekker_estimate(&rolling.system.wheel, rolling.curve().ok()?, load);
        self.approach(rolling, load, guess, false)
    }

    /// The forces at a sinkage (m) and the step from there.
    fn pass(&self, rolling: &Rolling<'_>, load: f64, sinkage: f64, coarse: bool) -> Option<Pass> {
        let patch = rolling.contact(sinkage).ok().filter(|patch| patch.angles.exit == 0.0)?;
        let (forces, changes) = self.forces_and_changes(&patch, coarse)?;
        let slopes = changes.scaled(patch.entry_rate());
        let step = (load / forces.normal).ln() * forces.normal / slopes.normal;
        let followed = forces.normal > 0.0 && slopes.normal > 0.0 && step.abs() <= LONGEST;
        followed.then_some(Pass { sinkage, forces, slopes, step })
    }
}

impl Pass {
    /// The sinkage (m) a step away; none where the wheel is in to its axle and would sink further.
    fn next(&self, radius: f64) -> Option<f64> {
        (self.sinkage < radius || self.step < 0.0).then(|| (self.sinkage * self.step.exp()).min(radius))
    }

    /// The balance, a linear step away.
    fn corrected(&self, load: f64, radius: f64, iterations: u32) -> Option<CarriedLoad> {
        let sinkage = self.sinkage * (1.0 + self.step);
        let error = self.forces.integration_error;
        let forces = Forces { integration_error: error, ..self.forces.plus(&self.slopes.scaled(self.step)) };
        let found = CarriedLoad { sinkage, residual: forces.normal - load, iterations, forces };
        (sinkage <= radius && forces.is_finite() && found.is_met(load)).then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::circles::{Circles, SlipRadius};
    use crate::contact::{Contact, ContactParams, PeakRule, WongReece};
    use crate::forces::{Lambda, Method, PeakDepth};
    use crate::pressure_sinkage::{Direct, PressureSinkage, SinkageExponent};
    use crate::shear::{JanosiHanamoto, ShearLaw, WongPeak, WongResidual};
    use crate::slip::Slip;
    use crate::soil::{Soil, SoilParams};
    use crate::wheel::{Wheel, WheelParams};

    const EXACT: Method = Method::Explicit { peak_depth: PeakDepth::Geometric, lambda_a: Lambda::Exact, lambda_b: Lambda::Exact };
    const METHODS: [Method; 4] = [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT, EXACT];

    /// Wheels with and without lugs, soils by every shear law, contacts by every rule for the peak.
    fn systems() -> Vec<WheelOnSoil> {
        let laws = [
            ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.012 }),
            ShearLaw::WongResidual(WongResidual { residual_ratio: 0.6, peak_displacement: 0.02 }),
            ShearLaw::WongPeak(WongPeak { peak_displacement: 0.03 }),
        ];
        let rules = [PeakRule::Midpoint, PeakRule::WongReece(WongReece { c1: 0.4, c2: 0.2 }), PeakRule::HalfSinkage];
        let mut systems = Vec::new();
        for (i, law) in laws.into_iter().enumerate() {
            for (k, rule) in rules.into_iter().enumerate() {
                let lug_height = if i == k { 0.0 } else { 0.015 };
                let exponent = SinkageExponent { base: 0.7 + 0.2 * k as f64, slip_gain: 0.1, skid_gain: None };
                systems.push(WheelOnSoil {
                    wheel: Wheel::new(WheelParams { radius: 0.18, width: 0.12, lug_height, lug_coefficient: 0.5 })
                        .expect("a wheel"),
                    soil: Soil::new(SoilParams {
                        cohesion: 200.0 * i as f64,
                        friction_angle: 0.5,
                        shear: Some(law),
                        pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 6e5, exponent })),
                        ..SoilParams::BARE
                    })
                    .expect("a soil"),
                    contact: Contact::new(ContactParams {
                        rule,
                        circles: Circles { slip: SlipRadius::Rim, ..Circles::SHEARING },
                        ..ContactParams::MIDPOINT
                    })
                    .expect("a contact"),
                });
            }
        }
        systems
    }

    #[test]
    fn the_slopes_are_those_of_the_forces() {
        const STEP: f64 = 1e-5;
        const DIFFERENCE: f64 = 1e-7; // a central difference of that step errs by about its square
        for (system, method) in systems().iter().flat_map(|system| METHODS.map(|method| (system, method))) {
            let model = ForceModel::at_rim(method);
            for (ratio, sinkage) in [(0.0, 1e-4), (0.1, 0.004), (0.4, 0.02), (1.0, 0.09)] {
                let rolling = system.rolling(Slip::new(ratio).expect("a slip")).expect("a rolling wheel");
                let at = |z: f64| model.forces(&rolling.contact(z).expect("a contact")).expect("forces");
                let pass = model
                    .pass(&rolling, at(sinkage).normal, sinkage, false)
                    .unwrap_or_else(|| panic!("{system:?} {ratio} {sinkage} {:?}", at(sinkage)));
                let (below, above) = (at(sinkage * (-STEP).exp()), at(sinkage * STEP.exp()));
                for (slope, part) in [
                    (pass.slopes.components.traction, (|f| f.components.traction) as fn(&Forces) -> f64),
                    (pass.slopes.components.resistance, |f| f.components.resistance),
                    (pass.slopes.components.normal_support, |f| f.components.normal_support),
                    (pass.slopes.components.shear_support, |f| f.components.shear_support),
                    (pass.slopes.torque, |f| f.torque),
                ] {
                    let difference = (part(&above) - part(&below)) / (2.0 * STEP);
                    let scale = part(&above).abs().max(difference.abs());
                    assert!(
                        (slope - difference).abs() <= DIFFERENCE * scale,
                        "{method:?} {ratio} {sinkage}: {slope} {difference}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_approach_ends_where_the_bracket_does() {
        const SOLVED: f64 = 1e-12;
        for (system, method) in systems().iter().flat_map(|system| METHODS.map(|method| (system, method))) {
            let model = ForceModel::at_rim(method);
            for (ratio, load) in [(0.0, 1.0), (0.0, 80.0), (0.3, 5.0), (0.3, 300.0), (0.95, 60.0)] {
                let rolling = system.rolling(Slip::new(ratio).expect("a slip")).expect("a rolling wheel");
                let bracketed =
                    model.solve_sinkage_in_bracket(&rolling, load, rolling.curve().expect("a curve")).expect("a balance");
                for (factor, close) in [(0.4, false), (1.0, false), (2.5, false), (1.0 + 1e-4, true)] {
                    let found = model.approach(&rolling, load, factor * bracketed.sinkage, close);
                    let found = found.unwrap_or_else(|| panic!("{system:?} {ratio} {load} {factor} {bracketed:?}"));
                    assert!((found.sinkage / bracketed.sinkage - 1.0).abs() <= SOLVED, "{method:?} {found:?} {bracketed:?}");
                    let (forces, expected) = (&found.forces, &bracketed.forces);
                    assert!((forces.longitudinal - expected.longitudinal).abs() <= SOLVED * expected.longitudinal_scale());
                    assert!((forces.torque / expected.torque - 1.0).abs() <= SOLVED);
                    assert!(found.residual.abs() <= SOLVED * load);
                }
            }
        }
    }
}
