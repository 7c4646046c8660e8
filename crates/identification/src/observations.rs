//! What was measured: columns of one length over slip.

use terramechanics::Slip;

use crate::error::FitError;
use crate::quantity::Quantity;
use crate::range;
use crate::setup::SinkageSource;

/// Samples that one fit takes at most.
pub const MOST_SAMPLES: usize = 10_001;

/// One measured column.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Column {
    /// The values.
    pub values: Vec<f64>,
    /// Their standard deviations, if known, one per value.
    pub deviation: Option<Vec<f64>>,
}

/// Measurements, of one length.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Observations {
    /// Slip s (–).
    pub slip: Vec<Slip>,
    /// Sinkage z (m).
    pub sinkage: Option<Column>,
    /// Longitudinal force F_x (N).
    pub longitudinal: Option<Column>,
    /// Normal force F_z (N).
    pub normal: Option<Column>,
    /// Torque T (N·m).
    pub torque: Option<Column>,
}

/// The measured quantities that give the sinkage, and are taken as known.
fn taken(source: &SinkageSource) -> &'static [Quantity] {
    match source {
        SinkageSource::Measured => &[Quantity::Sinkage],
        SinkageSource::Load => &[Quantity::Normal],
        SinkageSource::UnderLoad => &[Quantity::Sinkage, Quantity::Normal],
        SinkageSource::Static { .. } => &[],
    }
}

impl Observations {
    /// The column of a quantity, if it was measured.
    #[must_use]
    pub fn column(&self, quantity: Quantity) -> Option<&Column> {
        match quantity {
            Quantity::Sinkage => self.sinkage.as_ref(),
            Quantity::Longitudinal => self.longitudinal.as_ref(),
            Quantity::Normal => self.normal.as_ref(),
            Quantity::Torque => self.torque.as_ref(),
        }
    }

    /// The quantities that are compared with predictions. Those that give the sinkage are taken as known.
    #[must_use]
    pub fn fitted(&self, source: &SinkageSource) -> Vec<Quantity> {
        let taken = taken(source);
        let measured = Quantity::ALL.into_iter().filter(|quantity| self.column(*quantity).is_some());
        measured.filter(|quantity| !taken.contains(quantity)).collect()
    }

    /// Checks that the columns fit together and contain what the source of the sinkage needs.
    pub(crate) fn check(&self, source: &SinkageSource) -> Result<(), FitError> {
        let count = self.slip.len();
        if !(1..=MOST_SAMPLES).contains(&count) {
            return Err(FitError::Samples { count });
        }
        let needed = taken(source);
        if let Some(&quantity) = needed.iter().find(|&&quantity| self.column(quantity).is_none()) {
            return Err(FitError::Missing(quantity));
        }
        let fitted = self.fitted(source);
        if fitted.is_empty() {
            return Err(FitError::NothingMeasured);
        }
        let weighted = |quantity: Quantity| self.column(quantity).is_some_and(|column| column.deviation.is_some());
        if fitted.iter().any(|&quantity| weighted(quantity))
            && let Some(&quantity) = fitted.iter().find(|&&quantity| !weighted(quantity))
        {
            return Err(FitError::DeviationMissing(quantity));
        }
        for quantity in Quantity::ALL {
            let Some(column) = self.column(quantity) else { continue };
            if column.values.len() != count || column.deviation.as_ref().is_some_and(|deviation| deviation.len() != count) {
                return Err(FitError::Length(quantity));
            }
            let usable = |value: f64| value.is_finite() && (!needed.contains(&quantity) || value > 0.0);
            if let Some(row) = column.values.iter().position(|&value| !usable(value)) {
                return Err(FitError::Value { quantity, row });
            }
            let size = range::largest(column.values.iter().copied());
            if size > 0.0 && !range::is_usable(size) {
                return Err(FitError::Size(quantity));
            }
            let improper = |deviation: &Vec<f64>| deviation.iter().position(|&value| !range::is_usable(value));
            if let Some(row) = column.deviation.as_ref().and_then(improper) {
                return Err(FitError::Deviation { quantity, row });
            }
        }
        Ok(())
    }
}
