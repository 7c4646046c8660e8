//! What is being fitted: a wheel on a soil, the method of the forces, and where the sinkage comes from.

use terramechanics::{
    Contact, ContactParams, Error, ForceModel, InvalidInput, Operation, Sinkage, Slip, SlipSinkage, Soil, SoilParams, Wheel,
    WheelOnSoil,
};

/// Where the sinkage of a sample comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SinkageSource {
    /// It was measured: the forces are predicted at the measured slip and sinkage.
    Measured,
    /// The measured normal force is the load: the sinkage is the one that carries it.
    Load,
    /// It was measured, and the measured normal force is the load that it carries: the load takes the place of the sinkage modulus.
    UnderLoad,
    /// It follows from a static sinkage and the slip.
    Static {
        /// Static sinkage z0 (m).
        static_sinkage: f64,
        /// Slip–sinkage law.
        law: SlipSinkage,
    },
}

/// The forward model with all its parameters, as plain numbers that a fit may vary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setup {
    /// The wheel.
    pub wheel: Wheel,
    /// Parameters of the soil.
    pub soil: SoilParams,
    /// Parameters of the contact.
    pub contact: ContactParams,
    /// How the forces are found.
    pub model: ForceModel,
    /// Where the sinkage comes from.
    pub sinkage: SinkageSource,
}

/// The prediction of the model for one sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Prediction {
    /// Sinkage z (m).
    pub(crate) sinkage: f64,
    /// Longitudinal force F_x (N).
    pub(crate) longitudinal: f64,
    /// Normal force F_z (N).
    pub(crate) normal: f64,
    /// Torque T (N·m).
    pub(crate) torque: f64,
}

impl Setup {
    /// The wheel on its soil.
    ///
    /// # Errors
    /// Every parameter that is not valid for a soil or a contact.
    pub fn system(&self) -> Result<WheelOnSoil, InvalidInput> {
        Ok(WheelOnSoil { wheel: self.wheel, soil: Soil::new(self.soil)?, contact: Contact::new(self.contact)? })
    }

    /// The prediction at `slip`, with the sinkage as given.
    pub(crate) fn predicted(&self, system: &WheelOnSoil, slip: Slip, sinkage: Sinkage) -> Result<Prediction, Error> {
        let point = Operation { system: *system, model: self.model, sinkage }.at(slip)?;
        let terramechanics::Forces { longitudinal, normal, torque, .. } = point.forces;
        Ok(Prediction { sinkage: point.sinkage, longitudinal, normal, torque })
    }
}
