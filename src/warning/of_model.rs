//! Findings that follow from what the model lacks and what data do not tell.

use terramechanics::Lacking;
use terramechanics_identification::DesignGap;

use super::Finding;

impl Finding {
    /// Why the estimate of that name is null.
    pub(crate) fn lacking(estimate: &'static str, lacking: &Lacking) -> Self {
        match *lacking {
            Lacking::ExponentBelowThree { exponent } => Self::NeedsExponentBelowThree { estimate, exponent },
            Lacking::UnitWeight => Self::NeedsUnitWeight { estimate },
            Lacking::DrivingSlip => Self::NeedsDrivingSlip { estimate },
            Lacking::JanosiHanamoto => Self::NeedsJanosiHanamoto { estimate },
        }
    }

    /// The finding that such data leave `parameters` open.
    pub(crate) fn gap(gap: DesignGap, parameters: Vec<&'static str>) -> Self {
        match gap {
            DesignGap::OneSlip => Self::SingleSlip { parameters },
            DesignGap::OneLoad => Self::SingleLoad { parameters },
            DesignGap::FewPoints => Self::FewPoints { parameters },
            DesignGap::NormalForceOnly => Self::NormalForceOnly { parameters },
        }
    }
}

/// The code of the warning about such data.
pub(crate) fn gap_code(gap: DesignGap) -> &'static str {
    Finding::gap(gap, Vec::new()).code()
}
