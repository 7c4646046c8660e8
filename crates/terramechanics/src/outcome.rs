//! When does a result leave the range in which its model was tested?

use crate::caution::{
    BULLDOZING_LEFT_OUT, BULLDOZING_NOT_MOBILISED, COHESION_LEFT_OUT, Caution, DEEP_SINKAGE, INTEGRATION_ERROR,
    INTERFACE_OF_LUGGED_WHEEL, LOAD_RESIDUAL, LOW_GRAVITY, LUG_HEIGHT_ASSUMED, MODULI_OF_OTHER_GRAVITY, MODULUS_UNLIKE_SOIL,
    NORMAL_FORCE_DRIFTS, PEAK_RULE_SET_ASIDE, RESISTIVE_FORCE_BRAKING, ROUGH_CYLINDER, SLIP_BEYOND_FIT, SLIP_BEYOND_OWN_FIT,
    SLIP_GAIN_EXTRAPOLATED, UNIT_WEIGHTS_DIFFER,
};
use crate::contact::ContactParams;
use crate::forces::Method;
use crate::lateral::Bulldozing;
use crate::operating_point::{NormalStressFrom, OperatingPoint, Sinkage};
use crate::operation::Operation;
use crate::pressure_sinkage::{PressureCurve, PressureSinkage};
use crate::rolling::WheelOnSoil;
use crate::slip::Slip;
use crate::wheel::Wheel;

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
    /// Normal force (N) at the standstill, where it is known: see [`Operation::standstill_normal`].
    pub standstill_normal: Option<f64>,
    /// Pressure over depth that a known load shows, where it does.
    pub found_curve: Option<PressureCurve>,
}

impl From<&OperatingPoint> for Outcome {
    fn from(point: &OperatingPoint) -> Self {
        let OperatingPoint { slip, sinkage, forces, curve, normal_stress_from, .. } = point;
        Self {
            slip: *slip,
            sinkage: *sinkage,
            normal: Some(forces.normal),
            integration_error: forces.integration_error,
            mobilised_share: forces.side.map(|side| side.mobilised_share),
            standstill_normal: None,
            found_curve: curve.filter(|_| *normal_stress_from == NormalStressFrom::Load),
        }
    }
}

/// The cautions that apply to whatever is found of a wheel on a soil.
pub fn system_cautions(system: &WheelOnSoil) -> impl Iterator<Item = Caution> + use<> {
    let low = system.soil.gravity().and_then(|gravity| LOW_GRAVITY.of(gravity));
    let contradiction = UNIT_WEIGHTS_DIFFER.of(system.soil.weight_contradiction());
    [low, contradiction, LUG_HEIGHT_ASSUMED.when(system.wheel.lug_height_is_assumed())].into_iter().flatten()
}

/// The caution that applies where lugs leave no interface between rim and soil, and the contact has one.
#[must_use]
pub fn interface_caution(wheel: &Wheel, contact: &ContactParams) -> Option<Caution> {
    INTERFACE_OF_LUGGED_WHEEL.when(wheel.lug_height() > 0.0 && contact.interface.is_some())
}

/// The cautions that apply where the pressure–sinkage law is used.
pub(crate) fn pressure_cautions(system: &WheelOnSoil) -> impl Iterator<Item = Caution> + use<> {
    let law = system.soil.pressure_sinkage();
    let [first, second] = law.map_or([None, None], |law| law.cautions(&system.plate()));
    let elsewhere = match law {
        Some(PressureSinkage::Bekker(_) | PressureSinkage::Direct(_) | PressureSinkage::Diameter(_)) => {
            MODULI_OF_OTHER_GRAVITY.when(system.soil.has_left_its_gravity())
        }
        Some(PressureSinkage::Reece(_)) | None => None,
    };
    [first, second, elsewhere].into_iter().flatten()
}

/// The cautions that apply to the force across a wheel.
fn side_cautions(operation: &Operation, outcome: &Outcome) -> impl Iterator<Item = Caution> + use<> {
    let Method::SideSlipping(side) = operation.model.method else { return [None, None].into_iter().flatten() };
    let left_out = side.angle.angle() != 0.0 && operation.system.soil.unit_weight().is_none();
    let counted = if side.bulldozing == Bulldozing::Full { outcome.mobilised_share } else { None };
    let not_mobilised = counted.and_then(|share| BULLDOZING_NOT_MOBILISED.of(share));
    [BULLDOZING_LEFT_OUT.when(left_out), not_mobilised].into_iter().flatten()
}

/// The cautions that apply to the resistive force method.
fn grain_cautions(operation: &Operation, outcome: &Outcome) -> impl Iterator<Item = Caution> + use<> {
    let WheelOnSoil { wheel, soil, .. } = &operation.system;
    let own = match operation.model.method {
        Method::ResistiveForce => [
            RESISTIVE_FORCE_BRAKING.of(outcome.slip.ratio()),
            COHESION_LEFT_OUT.of(soil.cohesion()),
            ROUGH_CYLINDER.when(wheel.lug_height() > 0.0),
        ],
        Method::Quadrature | Method::SideSlipping(_) | Method::Linearised { .. } | Method::Explicit { .. } => [None, None, None],
    };
    own.into_iter().flatten()
}

/// What the slip is beyond: the tests of the sinkage exponent's gain, where the soil has one.
fn gain_cautions(system: &WheelOnSoil, slip: f64) -> [Option<Caution>; 2] {
    let Some(exponent) = system.soil.sinkage_exponent().filter(|exponent| exponent.slip_gain != 0.0) else { return [None, None] };
    let beyond = match system.soil.largest_fitted_slip() {
        Some(largest) => SLIP_BEYOND_OWN_FIT.when(slip > largest),
        None => SLIP_BEYOND_FIT.of(slip),
    };
    [beyond, if exponent.skid_gain.is_none() { SLIP_GAIN_EXTRAPOLATED.of(slip) } else { None }]
}

/// The cautions that apply to the outcome of `operation`.
pub fn cautions(operation: &Operation, outcome: &Outcome) -> impl Iterator<Item = Caution> {
    cautions_with_sinkage(operation, &operation.sinkage, outcome)
}

/// The same where the sinkage is known in another way than the operation says.
pub(crate) fn cautions_with_sinkage(
    operation: &Operation,
    sinkage: &Sinkage,
    outcome: &Outcome,
) -> impl Iterator<Item = Caution> + use<> {
    let system = &operation.system;
    let residual = match (sinkage.load(), outcome.normal) {
        (Some(load), Some(normal)) => (normal - load).abs() / load,
        _ => 0.0,
    };
    // A load that is known takes the place of the modulus; the exponent is left to the integrals.
    let by_load = sinkage.normal_stress_from() == NormalStressFrom::Load;
    let in_grains = operation.model.method == Method::ResistiveForce;
    let no_exponent = in_grains || by_load && operation.model.method.is_closed_form();
    let [beyond_gain, braking_gain] = if no_exponent { [None, None] } else { gain_cautions(system, outcome.slip.ratio()) };
    let [beyond_law, braking_law] = sinkage.law().map_or([None, None], |law| law.cautions(outcome.slip));
    let drift = match (sinkage, outcome.normal, outcome.standstill_normal) {
        (Sinkage::FromStatic { .. }, Some(normal), Some(standstill)) if standstill > 0.0 => {
            NORMAL_FORCE_DRIFTS.of(normal / standstill - 1.0)
        }
        _ => None,
    };
    // Both have one exponent, so that the moduli are to each other as the pressures.
    let unlike = outcome.found_curve.and_then(|found| {
        let own = system.curve(outcome.slip).ok()?;
        MODULUS_UNLIKE_SOIL.of(found.modulus / own.modulus)
    });
    let of_outcome = [
        DEEP_SINKAGE.of(outcome.sinkage / system.wheel.radius()),
        beyond_gain,
        beyond_law,
        braking_gain,
        braking_law,
        PEAK_RULE_SET_ASIDE.when(!in_grains && system.contact.sets_rule_aside() && system.kinematics(outcome.slip).skid > 0.0),
        INTEGRATION_ERROR.of(outcome.integration_error),
        LOAD_RESIDUAL.of(residual),
        drift,
        unlike,
        if in_grains { None } else { interface_caution(&system.wheel, system.contact.params()) },
    ];
    let across = side_cautions(operation, outcome);
    let grains = grain_cautions(operation, outcome);
    let pressure = (!by_load && !in_grains).then(|| pressure_cautions(system)).into_iter().flatten();
    pressure.chain(system_cautions(system)).chain(of_outcome.into_iter().flatten()).chain(across).chain(grains)
}
