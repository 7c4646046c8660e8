//! When does a result leave the range in which its model was tested?
//!
//! A caution changes no number. It is data: the quantity, its value, the range, who found the range, and what to do; whoever
//! shows it makes the sentence. Each kind is listed in [`Caution::KINDS`], so that a service can tell its users beforehand what
//! it watches.

mod kinds;

pub(crate) use kinds::*;

use crate::error::Parameter;
use crate::forces::Method;
use crate::lateral::Bulldozing;
use crate::operation::{OperatingPoint, Operation, Sinkage};
use crate::pressure_sinkage::PressureSinkage;
use crate::rolling::WheelOnSoil;
use crate::slip::Slip;
use crate::slip_sinkage::SlipSinkage;

/// A reason to take a result with care.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Caution {
    /// What is watched.
    pub kind: &'static CautionKind,
    /// The value of the quantity, outside the kind's range; 0 where it has none.
    pub value: f64,
}

/// Something that is watched.
#[derive(Debug, PartialEq)]
pub struct CautionKind {
    /// A name for programs; kinds that say the same of different laws share it.
    pub code: &'static str,
    /// What it means, in sentences.
    pub meaning: &'static str,
    /// What to do about it, in a sentence.
    pub advice: &'static str,
    /// The input that a user may want to change, where it is one.
    pub parameter: Option<Parameter>,
    /// The range that is left, where it is about one.
    pub range: Option<TestedRange>,
}

/// The range of a quantity in which a model was tested.
#[derive(Debug, PartialEq)]
pub struct TestedRange {
    /// The quantity.
    pub quantity: &'static str,
    /// Its unit, by the Unified Code for Units of Measure; 1 for a ratio.
    pub unit: &'static str,
    /// Lower end.
    pub lower: Option<f64>,
    /// Upper end.
    pub upper: Option<f64>,
    /// Where the range comes from.
    pub source: &'static str,
}

/// What a caution is judged by, besides the operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// The slip.
    pub slip: Slip,
    /// Sinkage z (m).
    pub sinkage: f64,
    /// Normal force F_z (N), where it is known.
    pub normal: Option<f64>,
    /// Estimate of the relative error of the integrals (–).
    pub integration_error: f64,
    /// Share of the pressure on the side wall that is mobilised (–), where a slip angle was asked for.
    pub mobilised_share: Option<f64>,
}

impl From<&OperatingPoint> for Outcome {
    fn from(point: &OperatingPoint) -> Self {
        let OperatingPoint { slip, sinkage, forces, .. } = point;
        Self {
            slip: *slip,
            sinkage: *sinkage,
            normal: Some(forces.normal),
            integration_error: forces.integration_error,
            mobilised_share: forces.side.map(|side| side.mobilised_share),
        }
    }
}

impl Caution {
    /// Everything that is watched.
    pub const KINDS: &'static [&'static CautionKind] = &kinds::ALL;

    /// How far the value is outside the range, in the unit of the quantity.
    #[must_use]
    pub fn excess(&self) -> f64 {
        let Some(TestedRange { lower, upper, .. }) = self.kind.range else { return 0.0 };
        let below = lower.map_or(0.0, |lower| lower - self.value);
        let above = upper.map_or(0.0, |upper| self.value - upper);
        below.max(above)
    }
}

impl CautionKind {
    /// The caution, if the value is outside the range.
    pub(crate) fn of(&'static self, value: f64) -> Option<Caution> {
        let caution = Caution { kind: self, value };
        (caution.excess() > 0.0).then_some(caution)
    }

    /// The caution, if what it is about is so.
    pub(crate) fn when(&'static self, is_so: bool) -> Option<Caution> {
        is_so.then_some(Caution { kind: self, value: 0.0 })
    }
}

/// The cautions that apply to whatever is found of a wheel on a soil.
pub fn system_cautions(system: &WheelOnSoil) -> impl Iterator<Item = Caution> + use<> {
    let low = system.soil.gravity().and_then(|gravity| LOW_GRAVITY.of(gravity));
    [low, LUG_HEIGHT_ASSUMED.when(system.wheel.lug_height_is_assumed())].into_iter().flatten()
}

/// The cautions that apply where the pressure–sinkage law is used.
pub(crate) fn pressure_cautions(system: &WheelOnSoil) -> impl Iterator<Item = Caution> {
    let WheelOnSoil { wheel, soil, .. } = system;
    let [small, narrow] = match soil.pressure_sinkage() {
        PressureSinkage::Bekker(law) => {
            let width_ratio = (law.k_c < 0.0).then(|| -wheel.width() * law.k_phi / law.k_c);
            [SMALL_WHEEL.of(2.0 * wheel.radius()), width_ratio.and_then(|ratio| NEGATIVE_COHESIVE_MODULUS.of(ratio))]
        }
        _ => [None, None],
    };
    [small, narrow].into_iter().flatten()
}

/// The cautions that apply to the force across a wheel.
fn side_cautions(operation: &Operation, outcome: &Outcome) -> impl Iterator<Item = Caution> + use<> {
    let Method::SideSlipping(side) = operation.model.method else { return [None, None].into_iter().flatten() };
    let left_out = side.angle.angle() != 0.0 && operation.system.soil.unit_weight().is_none();
    let counted = if side.bulldozing == Bulldozing::Full { outcome.mobilised_share } else { None };
    let not_mobilised = counted.and_then(|share| BULLDOZING_NOT_MOBILISED.of(share));
    [BULLDOZING_LEFT_OUT.when(left_out), not_mobilised].into_iter().flatten()
}

/// What the slip is beyond: the tests of the sinkage exponent's gain, where the soil has one.
fn gain_cautions(system: &WheelOnSoil, slip: f64) -> [Option<Caution>; 2] {
    let exponent = system.soil.pressure_sinkage().exponent();
    if exponent.slip_gain == 0.0 {
        return [None, None];
    }
    let beyond = match system.soil.largest_fitted_slip() {
        Some(largest) => SLIP_BEYOND_OWN_FIT.when(slip > largest),
        None => SLIP_BEYOND_FIT.of(slip),
    };
    [beyond, if exponent.skid_gain.is_none() { SLIP_GAIN_EXTRAPOLATED.of(slip) } else { None }]
}

/// What the slip is beyond: the tests of the slip–sinkage law, where one is used.
fn slip_sinkage_cautions(sinkage: &Sinkage, slip: f64) -> [Option<Caution>; 2] {
    let Sinkage::FromStatic { law, .. } = sinkage else { return [None, None] };
    match law {
        SlipSinkage::Lyasko => [SLIP_BEYOND_LYASKO.of(slip), SLIP_SINKAGE_EXTRAPOLATED.of(slip)],
        SlipSinkage::Linear(_) => [SLIP_BEYOND_LINEAR.of(slip), LINEAR_SLIP_SINKAGE_EXTRAPOLATED.of(slip)],
    }
}

/// The cautions that apply to the outcome of `operation`.
pub fn cautions(operation: &Operation, outcome: &Outcome) -> impl Iterator<Item = Caution> {
    let Operation { system, sinkage, .. } = operation;
    let slip = outcome.slip.ratio();
    let residual = match (sinkage, outcome.normal) {
        (Sinkage::CarryingLoad(load), Some(normal)) => (normal - load).abs() / load,
        _ => 0.0,
    };
    let [beyond_gain, braking_gain] = gain_cautions(system, slip);
    let [beyond_law, braking_law] = slip_sinkage_cautions(sinkage, slip);
    let of_outcome = [
        DEEP_SINKAGE.of(outcome.sinkage / system.wheel.radius()),
        beyond_gain,
        beyond_law,
        braking_gain,
        braking_law,
        PEAK_RULE_SET_ASIDE.when(!outcome.slip.is_driving() && system.contact.sets_rule_aside()),
        INTEGRATION_ERROR.of(outcome.integration_error),
        LOAD_RESIDUAL.of(residual),
    ];
    let across = side_cautions(operation, outcome);
    pressure_cautions(system).chain(system_cautions(system)).chain(of_outcome.into_iter().flatten()).chain(across)
}
