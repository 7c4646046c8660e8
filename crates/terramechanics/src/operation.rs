//! One operating point from start to end: slip, sinkage, forces.

use crate::abreast::Plan;
use crate::error::Error;
use crate::forces::{ForceModel, Forces, Method};
use crate::known_load::LoadedForces;
use crate::load::CarriedLoad;
use crate::operating_point::{KnownSinkage, NormalStressFrom, OperatingPoint, Sinkage};
use crate::rolling::{Rolling, WheelOnSoil};
use crate::slip::Slip;

/// A wheel on a soil, a way to find its forces and a way to find its sinkage: all but the slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Operation {
    /// The wheel on its soil.
    pub system: WheelOnSoil,
    /// How the forces are found.
    pub model: ForceModel,
    /// How the sinkage is known.
    pub sinkage: Sinkage,
}

impl Operation {
    /// The operating point at `slip`.
    ///
    /// # Errors
    /// What [`WheelOnSoil::rolling`], [`Rolling::curve`], [`Rolling::contact`], [`ForceModel::forces`],
    /// [`ForceModel::solve_sinkage`] and [`ForceModel::forces_under`] refuse; under a known load not the sinkage modulus.
    pub fn at(&self, slip: Slip) -> Result<OperatingPoint, Error> {
        self.with_sinkage(slip, &self.sinkage)
    }

    /// The operating point at `slip` where the sinkage is known in another way than the operation says.
    #[inline]
    pub(crate) fn with_sinkage(&self, slip: Slip, sinkage: &Sinkage) -> Result<OperatingPoint, Error> {
        self.near(slip, sinkage, None)
    }

    /// The same, with a sinkage (m) that is likely to be near the one that carries the load.
    pub(crate) fn near(&self, slip: Slip, sinkage: &Sinkage, near: Option<f64>) -> Result<OperatingPoint, Error> {
        if let Sinkage::CarryingLoad(_) = sinkage {
            return self.carrying(slip, sinkage, near);
        }
        // The answer is written where it belongs: a copy of it would cost a part of a closed form's time.
        if let Some(plan) = Plan::of(&self.system, &self.model, sinkage)
            && let Some((exponent, found)) = plan.alone(slip)
        {
            return Ok(plan.point(slip, exponent, &found));
        }
        self.by_steps(slip, sinkage, near)
    }

    /// The same at the sinkage that carries a load. Apart, so that other points do not carry its code along.
    #[inline(never)]
    fn carrying(&self, slip: Slip, sinkage: &Sinkage, near: Option<f64>) -> Result<OperatingPoint, Error> {
        if let Some(plan) = Plan::of(&self.system, &self.model, sinkage)
            && let Some((exponent, found)) = plan.carrying(slip, near)
        {
            return Ok(plan.point(slip, exponent, &found));
        }
        self.by_steps(slip, sinkage, near)
    }

    /// The same step by step, with a reason where there is no point.
    #[inline(never)]
    fn by_steps(&self, slip: Slip, sinkage: &Sinkage, near: Option<f64>) -> Result<OperatingPoint, Error> {
        if let Sinkage::UnderLoad { sinkage, load } = *sinkage {
            return self.under_load(slip, &sinkage, load);
        }
        if self.model.method == Method::ResistiveForce {
            return self.in_grains(slip, sinkage);
        }
        let rolling = self.system.rolling(slip)?;
        let curve = *rolling.curve()?;
        let (sinkage, solved) = self.found(&rolling, sinkage, near)?;
        let patch = rolling.contact(sinkage)?;
        let forces = match solved {
            Some(forces) => forces,
            None => self.model.forces(&patch)?,
        };
        let (angles, normal_stress_from) = (patch.angles, NormalStressFrom::Soil);
        Ok(OperatingPoint { slip, sinkage, angles, curve: Some(curve), granular_stiffness: None, normal_stress_from, forces })
    }

    /// The same by the resistive force method. Apart, so that other points do not carry its code along.
    #[inline(never)]
    fn in_grains(&self, slip: Slip, sinkage: &Sinkage) -> Result<OperatingPoint, Error> {
        let rolling = self.model.rolling(&self.system, slip)?;
        let (sinkage, solved) = self.found(&rolling, sinkage, None)?;
        let patch = self.model.contact(&rolling, sinkage)?;
        let forces = match solved {
            Some(forces) => forces,
            None => self.model.forces(&patch)?,
        };
        let (angles, granular_stiffness) = (patch.angles, self.system.soil.granular_stiffness());
        let normal_stress_from = NormalStressFrom::Soil;
        Ok(OperatingPoint { slip, sinkage, angles, curve: None, granular_stiffness, normal_stress_from, forces })
    }

    /// The same of a wheel whose load is known too. Apart, so that other points do not carry its code along.
    #[inline(never)]
    fn under_load(&self, slip: Slip, sinkage: &KnownSinkage, load: f64) -> Result<OperatingPoint, Error> {
        let rolling = match self.model.method {
            Method::ResistiveForce => self.model.rolling(&self.system, slip)?,
            Method::Quadrature | Method::SideSlipping(_) | Method::Linearised { .. } | Method::Explicit { .. } => {
                self.system.rolling_under_load(slip)?
            }
        };
        let sinkage = sinkage.at(slip);
        let patch = self.model.contact(&rolling, sinkage)?;
        let LoadedForces { forces, curve, granular_stiffness } = self.model.forces_under(&patch, load)?;
        let (angles, normal_stress_from) = (patch.angles, NormalStressFrom::Load);
        Ok(OperatingPoint { slip, sinkage, angles, curve, granular_stiffness, normal_stress_from, forces })
    }

    /// The operating point at `slip` by the quadrature under a load, where a few steps find it: the one of [`at`](Self::at), in a tenth
    /// of a millisecond at the most. None where it takes a search, where there is no such point, and for other operations.
    #[must_use]
    pub fn at_in_few_steps(&self, slip: Slip) -> Option<OperatingPoint> {
        let Self { system, model, sinkage: Sinkage::CarryingLoad(load) } = self else { return None };
        if model.method != Method::Quadrature {
            return None;
        }
        let rolling = system.rolling(slip).ok()?;
        let CarriedLoad { sinkage, forces, .. } = model.approach_alone(&rolling, *load)?;
        let angles = rolling.contact(sinkage).ok()?.angles;
        let (curve, normal_stress_from) = (Some(*rolling.curve().ok()?), NormalStressFrom::Soil);
        Some(OperatingPoint { slip, sinkage, angles, curve, granular_stiffness: None, normal_stress_from, forces })
    }

    /// Normal force F_z (N) at the standstill, from which that of a wheel drifts whose sinkage follows from a static one and whose
    /// load is not known; none for another sinkage, or where the model has no answer at rest.
    #[must_use]
    pub fn standstill_normal(&self) -> Option<f64> {
        match self.sinkage {
            Sinkage::FromStatic { .. } => self.at(Slip::ROLLING).ok().map(|point| point.forces.normal),
            Sinkage::Given(_) | Sinkage::CarryingLoad(_) | Sinkage::UnderLoad { .. } => None,
        }
    }

    /// The sinkage (m) of the wheel as it rolls by the method ([`ForceModel::rolling`]), and the forces where finding it has found them too.
    ///
    /// # Errors
    /// What [`ForceModel::solve_sinkage`] refuses.
    pub fn sinkage_of(&self, rolling: &Rolling<'_>) -> Result<(f64, Option<Forces>), Error> {
        self.found(rolling, &self.sinkage, None)
    }

    #[inline]
    fn found(&self, rolling: &Rolling<'_>, sinkage: &Sinkage, near: Option<f64>) -> Result<(f64, Option<Forces>), Error> {
        match *sinkage {
            Sinkage::Given(sinkage) => Ok((sinkage, None)),
            Sinkage::FromStatic { static_sinkage, law } => Ok((law.sinkage(static_sinkage, rolling.slip), None)),
            Sinkage::CarryingLoad(load) => {
                let carried = match near {
                    None => self.model.solve_sinkage(rolling, load)?,
                    Some(_) => self.model.solve_sinkage_near(rolling, load, near)?, // a load that its neighbours have too
                };
                Ok((carried.sinkage, Some(carried.forces)))
            }
            Sinkage::UnderLoad { sinkage, load } => {
                let sinkage = sinkage.at(rolling.slip);
                let loaded = self.model.forces_under(&self.model.contact(rolling, sinkage)?, load)?;
                Ok((sinkage, Some(loaded.forces)))
            }
        }
    }
}
