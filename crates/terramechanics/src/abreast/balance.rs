//! The sinkage that carries a load, by Newton's method in ln F over ln z.
//!
//! One pass gives the forces and their slopes, and the step that is left. Where it is so short that the forces are linear in it, they
//! are corrected instead of computed anew. Each lane keeps what it found at its own last pass, so it does not feel the others.

use super::{Found, Setting, Shared};
use crate::approach::{LINEAR, LONGEST};
use crate::contact::Angles;
use crate::forces::{ClosedForces, Components};
use crate::numerics::elementary::Number;
use crate::pressure_sinkage::pressure;

/// Most passes.
const PASSES: u32 = 6;

impl Shared<'_> {
    /// The balance near the setting's sinkage, where it is unique.
    #[inline(always)]
    pub(super) fn balance<F: Number>(&self, setting: &Setting<F>) -> Option<Found<F>> {
        let mut sinkage = setting.sinkage;
        let mut found = Found::unsettled(sinkage);
        for _ in 0..PASSES {
            let (next, step) = self.pass(setting, sinkage)?;
            let settled = -found.left + LINEAR; // not negative where it is
            found = found.unless(settled, &next);
            if found.left.all_at_most(LINEAR) {
                break;
            }
            sinkage = sinkage * step.exp();
            sinkage = (setting.radius - sinkage).if_not_negative(sinkage, setting.radius);
        }
        found.angles = self.by.contact.angles_by_rule(found.sinkage / setting.radius, setting.slip);
        Some(found)
    }

    /// The balance a linear step away from a sinkage (m), and the step in ln z.
    #[inline(always)]
    fn pass<F: Number>(&self, setting: &Setting<F>, sinkage: F) -> Option<(Found<F>, F)> {
        let Setting { slip, modulus, exponent, load, leverage, .. } = *setting;
        let frame = self.frame(setting, sinkage)?;
        let outline = &frame.outline;
        let way = self.way(setting, outline);
        let form = frame.form(self.mobilisation(setting, &way, outline), leverage);
        let normal = pressure(modulus, exponent, form.depth);
        let forces = form.forces(normal);
        let slopes = form.changes(&self.by, outline, &way, [slip, normal, exponent]).scaled(outline.entry_rate()); // over ln z
        let step = (load / forces.normal()).ln() * forces.normal() / slopes.normal();
        let (forces, sinkage) = (forces.plus(&slopes.scaled(step)), sinkage * (step + 1.0));
        Some((
            Found { sinkage, angles: outline.angles, forces, modulus, left: step.abs() },
            step.at_least(-LONGEST).at_most(LONGEST),
        ))
    }
}

impl<F: Number> Found<F> {
    /// Nothing yet, in the lanes of another number.
    #[inline(always)]
    fn unsettled(like: F) -> Self {
        let (none, left) = (like.like(f64::NAN), like.like(f64::INFINITY));
        let components = Components { traction: none, resistance: none, normal_support: none, shear_support: none };
        let angles = Angles { entry: none, peak: none, exit: none };
        Self { sinkage: none, angles, forces: ClosedForces { components, torque: none }, modulus: none, left }
    }

    /// This where `settled` is not negative, and the other elsewhere.
    #[inline(always)]
    fn unless(&self, settled: F, other: &Self) -> Self {
        let (own, others) = (&self.forces.components, &other.forces.components);
        let components = Components {
            traction: settled.if_not_negative(own.traction, others.traction),
            resistance: settled.if_not_negative(own.resistance, others.resistance),
            normal_support: settled.if_not_negative(own.normal_support, others.normal_support),
            shear_support: settled.if_not_negative(own.shear_support, others.shear_support),
        };
        let torque = settled.if_not_negative(self.forces.torque, other.forces.torque);
        let (sinkage, left) =
            (settled.if_not_negative(self.sinkage, other.sinkage), settled.if_not_negative(self.left, other.left));
        Self { sinkage, forces: ClosedForces { components, torque }, left, ..*other }
    }
}
