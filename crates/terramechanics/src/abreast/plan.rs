//! From an operation to the numbers that a closed form takes, and back to an operating point.

use super::{Found, Setting, Shared, Sought};
use crate::braking::Braking;
use crate::circles::{Kinematics, Rings};
use crate::contact::{Contact, ExitRule};
use crate::forces::{Changing, ForceModel, Lambda, Method};
use crate::load::{bekker_estimate, is_met};
use crate::operating_point::{KnownSinkage, OperatingPoint, Sinkage};
use crate::pressure_sinkage::{Plate, PressureCurve};
use crate::rolling::WheelOnSoil;
use crate::slip::Slip;
use crate::soil::Soil;
use crate::strength::Strength;

/// What points of one wheel on one soil have in common, where a closed form gives their forces.
pub(crate) struct Plan<'a> {
    pub(super) shared: Shared<'a>,
    system: &'a WheelOnSoil,
    sinkage: &'a Sinkage,
    plate: Plate,
    /// The numbers that do not change with slip.
    fixed: Setting,
    /// Pressure over depth, where that does not change with slip.
    fixed_curve: Option<PressureCurve>,
}

impl<'a> Plan<'a> {
    /// None for a method that is no closed form, and for what a point alone refuses.
    #[inline(always)]
    pub(crate) fn of(system: &'a WheelOnSoil, model: &'a ForceModel, sinkage: &'a Sinkage) -> Option<Self> {
        if !takes(&model.method) {
            return None;
        }
        let WheelOnSoil { wheel, soil, contact } = system;
        let (sought, load) = match *sinkage {
            Sinkage::Given(_) | Sinkage::FromStatic { .. } => (Sought::Forces, f64::NAN),
            Sinkage::UnderLoad { load, .. } => (Sought::ForcesUnderLoad, load),
            Sinkage::CarryingLoad(load) => (Sought::Balance, load),
        };
        if sought != Sought::Forces && WheelOnSoil::NORMAL_LOAD.check(load).is_err() {
            return None;
        }
        if sought == Sought::Balance && !leaves_at_lowest_point(contact) {
            return None;
        }
        let strength = Strength::of(soil, contact.params().interface.as_ref()).ok()?;
        let (rings, leverage) = (Rings::of(contact.circles(), wheel), model.leverage(system, &strength));
        let by = Changing { method: &model.method, contact, shear: soil.shear()? };
        let radius = wheel.radius();
        let [slip, modulus, exponent] = [f64::NAN; 3];
        let fixed = Setting { radius, rings, leverage, slip, sinkage: f64::NAN, modulus, exponent, load };
        let shared = Shared { by, sought, lugged: rings.offset != 0.0 };
        let plate = system.plate();
        let is_fixed = soil.sinkage_exponent().is_none_or(|exponent| exponent.is_fixed());
        let fixed_curve = if is_fixed { curve_of(soil, &plate, sought, Slip::ROLLING) } else { None };
        Some(Self { shared, system, sinkage, plate, fixed, fixed_curve })
    }

    /// The numbers at `slip`, where a balance is perhaps `near` a sinkage (m); none for what is left to a point alone.
    #[inline(always)]
    pub(super) fn setting(&self, slip: Slip, near: Option<f64>) -> Option<Setting> {
        if self.shared.sought == Sought::Balance { self.guess(slip, near) } else { self.known(slip) }
    }

    /// The same where a balance is sought.
    #[inline(always)]
    fn guess(&self, slip: Slip, near: Option<f64>) -> Option<Setting> {
        if Kinematics::at(&self.fixed.rings, slip.ratio()).skid > 0.0 {
            return None;
        }
        let curve = self.curve(slip)?;
        let sinkage = match near {
            Some(near) => near,
            None => bekker_estimate(&self.system.wheel, &curve, self.fixed.load),
        };
        self.at(slip, sinkage.min(self.fixed.radius))
    }

    /// The same where the sinkage is known.
    #[inline(always)]
    fn known(&self, slip: Slip) -> Option<Setting> {
        let sinkage = match *self.sinkage {
            Sinkage::Given(sinkage) | Sinkage::UnderLoad { sinkage: KnownSinkage::Given(sinkage), .. } => sinkage,
            Sinkage::FromStatic { static_sinkage, law }
            | Sinkage::UnderLoad { sinkage: KnownSinkage::FromStatic { static_sinkage, law }, .. } => {
                law.sinkage(static_sinkage, slip)
            }
            Sinkage::CarryingLoad(_) => return None,
        };
        self.at(slip, sinkage)
    }

    /// The numbers at `slip` and a sinkage (m).
    #[inline(always)]
    fn at(&self, slip: Slip, sinkage: f64) -> Option<Setting> {
        if slip.is_locked() || self.has_two_zones(slip) {
            return None;
        }
        let inside = sinkage > 0.0 && sinkage <= self.fixed.radius;
        let PressureCurve { modulus, exponent } = self.curve(slip)?;
        inside.then_some(Setting { slip: slip.ratio(), sinkage, modulus, exponent, ..self.fixed })
    }

    /// The numbers that do not change with slip; the others are none.
    pub(super) fn fixed(&self) -> &Setting {
        &self.fixed
    }

    /// Whether the contact is the same at any slip.
    pub(super) fn has_one_contact(&self) -> bool {
        let has_one_sinkage = match *self.sinkage {
            Sinkage::Given(_) | Sinkage::UnderLoad { sinkage: KnownSinkage::Given(_), .. } => true,
            Sinkage::FromStatic { .. } | Sinkage::UnderLoad { .. } | Sinkage::CarryingLoad(_) => false,
        };
        has_one_sinkage && !self.shared.by.contact.peak_moves_with_slip()
    }

    #[inline(always)]
    fn has_two_zones(&self, slip: Slip) -> bool {
        self.shared.by.contact.braking() != Braking::OneZone && Kinematics::at(&self.fixed.rings, slip.ratio()).skid > 0.0
    }

    /// Pressure over depth at `slip`.
    #[inline(always)]
    fn curve(&self, slip: Slip) -> Option<PressureCurve> {
        match self.fixed_curve {
            Some(curve) => Some(curve),
            None => curve_of(&self.system.soil, &self.plate, self.shared.sought, slip),
        }
    }

    /// What is found at `slip` at a sinkage that is known; none for what is left to another way.
    #[inline(always)] // the numbers would pass through memory
    pub(crate) fn alone(&self, slip: Slip) -> Option<(f64, Found)> {
        let setting = self.known(slip)?;
        let found = self.shared.forces(&setting, &self.shared.frame(&setting, setting.sinkage)?);
        self.is_point(setting.exponent, &found).then_some((setting.exponent, found))
    }

    /// The same at the sinkage that carries the load, perhaps `near` one (m).
    #[inline(always)]
    pub(crate) fn carrying(&self, slip: Slip, near: Option<f64>) -> Option<(f64, Found)> {
        let setting = self.guess(slip, near)?;
        let found = self.shared.balance(&setting)?;
        self.is_point(setting.exponent, &found).then_some((setting.exponent, found))
    }

    /// Whether what was found is a point.
    #[inline(always)]
    fn is_point(&self, exponent: f64, found: &Found) -> bool {
        found.forces.summed().is_finite() && found.angles.are_in_order() && self.is_met(exponent, found)
    }

    /// Whether finite forces in a contact are those that were sought.
    #[inline(always)]
    pub(super) fn is_met(&self, exponent: f64, found: &Found) -> bool {
        match self.shared.sought {
            Sought::Forces => true,
            Sought::ForcesUnderLoad => found.modulus > 0.0 || exponent.is_nan(),
            Sought::Balance => {
                let (load, forces) = (self.fixed.load, found.forces.summed());
                let is_inside = found.left <= crate::approach::LINEAR && found.sinkage <= self.fixed.radius;
                is_inside && is_met(forces.normal - load, forces.normal_scale(), load)
            }
        }
    }

    /// The point that was found.
    #[inline(always)]
    pub(crate) fn point(&self, slip: Slip, exponent: f64, found: &Found) -> OperatingPoint {
        let Found { sinkage, angles, modulus, .. } = *found;
        OperatingPoint {
            slip,
            sinkage,
            angles,
            curve: if exponent.is_nan() { None } else { Some(PressureCurve { modulus, exponent }) },
            granular_stiffness: None,
            normal_stress_from: self.sinkage.normal_stress_from(),
            forces: found.forces.summed(),
        }
    }
}

/// Pressure over depth on a `soil`; with an exponent that is no number where a known load does without.
#[inline(always)]
fn curve_of(soil: &Soil, plate: &Plate, sought: Sought, slip: Slip) -> Option<PressureCurve> {
    match sought {
        Sought::ForcesUnderLoad => match soil.sinkage_exponent() {
            Some(exponent) => exponent.shape(slip).ok(),
            None => Some(PressureCurve { modulus: 1.0, exponent: f64::NAN }),
        },
        Sought::Forces | Sought::Balance => soil.pressure_sinkage()?.curve(plate, slip).ok(),
    }
}

/// Whether the method is a closed form whose constants are numbers.
#[inline]
fn takes(method: &Method) -> bool {
    match *method {
        Method::Explicit { lambda_a, lambda_b, .. } => {
            [lambda_a, lambda_b].iter().all(|lambda| !matches!(lambda, Lambda::Given(value) if !value.is_finite()))
        }
        Method::Linearised { .. } => true,
        Method::Quadrature | Method::SideSlipping(_) | Method::ResistiveForce => false,
    }
}

/// Whether every contact leaves the soil at the lowest point: F_z then grows with z, and any balance is the one.
fn leaves_at_lowest_point(contact: &Contact) -> bool {
    match contact.params().exit {
        ExitRule::AngleRatio(rule) => rule.c3 == 0.0,
        ExitRule::SinkageRatio(rule) => rule.ratio == 0.0,
    }
}
