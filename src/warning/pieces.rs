//! Parts of findings that several share.

use terramechanics_identification::DesignGap;

use super::words::quoted;
use crate::quantity::number;

/// The values of one column that are out of range.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct BeyondRange {
    pub(crate) column: &'static str,
    pub(crate) first: f64,
    pub(crate) largest: f64,
    pub(crate) count: u64,
    /// The value has to be greater than this.
    pub(crate) lower: Option<f64>,
    pub(crate) upper: Option<f64>,
}

impl BeyondRange {
    pub(super) fn in_words(&self) -> String {
        let demand = match (self.lower, self.upper) {
            (Some(lower), Some(upper)) => format!("greater than {} and at most the radius {} m", number(lower), number(upper)),
            (Some(lower), None) => format!("finite and greater than {}", number(lower)),
            _ => "finite".to_owned(),
        };
        let found = if self.count == 1 { "it".to_owned() } else { format!("the first of {}", self.count) };
        format!("`{}` has to be {demand}; {found} is {}.", self.column, number(self.first))
    }

    /// Whether a value is larger than the radius allows.
    pub(super) fn is_beyond_radius(&self) -> bool {
        self.upper.is_some_and(|upper| self.largest > upper)
    }
}

/// What the operating points of the data do not vary.
pub(crate) fn gap_in_words(gap: DesignGap) -> &'static str {
    match gap {
        DesignGap::OneSlip => "all samples have one slip",
        DesignGap::OneLoad => "all samples have one load, measured or, where it was not, predicted by the model",
        DesignGap::FewPoints => "the samples repeat too few operating points to determine that many parameters",
        DesignGap::NormalForceOnly => "only the normal force is fitted, to which the shear stress adds little",
    }
}

/// What such data leave open.
pub(super) fn gap_of(gap: DesignGap, parameters: &[&'static str]) -> String {
    let reason = gap_in_words(gap);
    format!("{reason}, so only the assumed shape of the stresses determines {}.", quoted(parameters))
}

/// What to do about such data.
pub(super) fn gap_advice(gap: DesignGap) -> &'static str {
    match gap {
        DesignGap::OneSlip => "Measure at other slips as well.",
        DesignGap::OneLoad => "Measure under other loads as well.",
        DesignGap::FewPoints => "Measure at more operating points.",
        DesignGap::NormalForceOnly => "Send a torque or a longitudinal force as well.",
    }
}
