//! Operating points by a closed form of the forces: one alone, or eight side by side.
//!
//! Every formula here and in what it calls is written once, over [`Number`], so that points which belong together may be
//! found together. A point among others differs from the same point alone by the rounding of its exponentials, logarithms and
//! arcsines: by less than 1e-12 of it. What has no place in it (a locked wheel, two zones, a value that is
//! refused) is left to the way of one point alone, see [`Operation`](crate::Operation).

mod balance;
mod lanes;
mod plan;

pub(crate) use lanes::{ABREAST, Abreast};
pub(crate) use plan::Plan;

use crate::circles::{Kinematics, Rings};
use crate::contact::Angles;
use crate::displacement::{Lead, Way};
use crate::forces::outline::Outline;
use crate::forces::{Changing, ClosedForces, ClosedForm, Frame, Leverage};
use crate::known_load::LEAST_SUPPORT;
use crate::numerics::elementary::Number;
use crate::pressure_sinkage::pressure;

/// What points share that are found together.
#[derive(Clone, Copy)]
pub(crate) struct Shared<'a> {
    by: Changing<'a>,
    sought: Sought,
    /// Whether the displacement of any wheel is counted on another circle than the rim.
    lugged: bool,
}

/// What is sought.
#[derive(Clone, Copy, PartialEq)]
enum Sought {
    /// The forces at a sinkage.
    Forces,
    /// The same under a load that takes the place of the sinkage modulus.
    ForcesUnderLoad,
    /// The sinkage that carries a load, and the forces there.
    Balance,
}

/// A wheel on its soil at a slip, in numbers.
#[derive(Clone, Copy)]
pub(crate) struct Setting<T = f64> {
    /// r (m).
    radius: T,
    rings: Rings<T>,
    leverage: Leverage<T>,
    /// The slip ratio (–).
    slip: T,
    /// The sinkage z (m), or a guess at it.
    sinkage: T,
    /// K_s (Pa/m^N) and N (–).
    modulus: T,
    exponent: T,
    /// W (N), where it is known.
    load: T,
}

/// What is found there.
#[derive(Clone, Copy)]
pub(crate) struct Found<T = f64> {
    sinkage: T,
    angles: Angles<T>,
    forces: ClosedForces<T>,
    /// K_s (Pa/m^N).
    modulus: T,
    /// Longest step in ln z that was left to the balance; 0 where none is sought.
    left: T,
}

impl Shared<'_> {
    /// The contact at a sinkage (m).
    #[inline(always)]
    fn frame<F: Number>(&self, setting: &Setting<F>, sinkage: F) -> Option<Frame<F>> {
        Frame::of(self.by.method, Outline::of(self.by.contact, [setting.radius, sinkage, setting.slip]))
    }

    /// The way along which the soil is sheared there.
    #[inline(always)]
    fn way<F: Number>(&self, setting: &Setting<F>, outline: &Outline<F>) -> Way<F> {
        let kinematics = Kinematics::at(&setting.rings, setting.slip);
        let Outline { radius, sinkage, angles, .. } = *outline;
        let lead = if self.lugged { Lead::of(&kinematics, radius, sinkage, angles.entry) } else { Lead::none(sinkage) };
        Way { kinematics, lead }
    }

    /// E (–) at the peak. Eq. (6).
    #[inline(always)]
    fn mobilisation<F: Number>(&self, setting: &Setting<F>, way: &Way<F>, outline: &Outline<F>) -> F {
        self.by.shear.mobilisation(way.displacement(&outline.peak) * setting.leverage.per_shear_scale)
    }

    /// The forces in a contact; not numbers where no normal stress carries the load.
    #[inline(always)]
    fn forces<F: Number>(&self, setting: &Setting<F>, frame: &Frame<F>) -> Found<F> {
        let Setting { modulus, exponent, load, leverage, .. } = *setting;
        let Outline { sinkage, angles, .. } = frame.outline;
        let way = self.way(setting, &frame.outline);
        let form = frame.form(self.mobilisation(setting, &way, &frame.outline), leverage);
        let (normal, modulus) = if self.sought == Sought::ForcesUnderLoad {
            let normal = normal_stress_under(&form, load);
            (normal, normal / pressure(load.like(1.0), exponent, form.depth))
        } else {
            (pressure(modulus, exponent, form.depth), modulus)
        };
        Found { sinkage, angles, forces: form.forces(normal), modulus, left: load.like(0.0) }
    }
}

/// σm (Pa) at the peak under a load (N): F_z = A X + B Y = W, solved for it. Not a number where no normal stress carries a load, not
/// greater than 0 where cohesion alone does.
#[inline(always)]
fn normal_stress_under<F: Number>(form: &ClosedForm<F>, load: F) -> F {
    let (cohesive, frictional, direct) = form.normal_force_parts();
    let scale = direct.abs() + (frictional - direct).abs();
    let spare = frictional - scale * LEAST_SUPPORT;
    spare.if_not_negative((load - cohesive) / frictional, load.like(f64::NAN))
}
