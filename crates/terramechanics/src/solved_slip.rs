//! At which slip does a wheel pull as much as is asked of it? The forces of Eqs. (10)–(17), solved for the slip.
//!
//! The sinkage may be given, follow from the slip or carry a load; it is found anew at every slip. The pull of a loaded wheel rises
//! with slip on most soils. Where the sinkage grows with slip it has a maximum; of the two slips that give a smaller pull, the one
//! nearer to 0 is found.

use crate::error::Error;
use crate::operating_point::OperatingPoint;
use crate::operation::Operation;
use crate::pull::Pull;
use crate::slip::Slip;
use crate::slip_search::{Searched, slip_of_pull};

/// The point at which a wheel gives a pull.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolvedSlip {
    /// The operating point.
    pub point: OperatingPoint,
    /// Operating points that were tried.
    pub evaluations: u32,
}

/// The same quantity as `pull` of a point.
fn given(pull: Pull, point: &OperatingPoint) -> Result<f64, Error> {
    match pull {
        Pull::Force(_) => Ok(point.forces.longitudinal),
        Pull::Coefficient(_) => point.forces.drawbar_coefficient().ok_or(Error::NotFinite),
    }
}

impl Operation {
    /// The operating point at which the wheel gives `pull`: of several slips the one nearest to 0, on the driving side where the pull
    /// is larger than that without slip.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a pull that is not finite; [`Error::PullOutOfReach`] with the largest or the least pull where no slip
    /// from −1 to 1 gives it; what [`Operation::at`] refuses, where it has no point at any slip.
    ///
    /// ```
    /// use terramechanics::*;
    /// # let soil = SoilParams {
    /// #     friction_angle: 0.478,
    /// #     shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.005 })),
    /// #     pressure_sinkage: Some(PressureSinkage::Bekker(Bekker {
    /// #         k_c: -660.0,
    /// #         k_phi: 754_130.0,
    /// #         exponent: SinkageExponent { base: 0.91, slip_gain: 0.0, skid_gain: None },
    /// #     })),
    /// #     ..SoilParams::BARE
    /// # };
    /// # let system = WheelOnSoil {
    /// #     wheel: Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 })?,
    /// #     soil: Soil::new(soil)?,
    /// #     contact: Contact::MIDPOINT,
    /// # };
    /// // The letter's own example (its Fig. 1b): 16.906 N at 20 % slip, by an independent integration.
    /// let operation = Operation { system, model: ForceModel::at_rim(Method::Quadrature), sinkage: Sinkage::Given(0.02) };
    /// let solved = operation.solve_slip(Pull::Force(16.906))?;
    /// assert!((solved.point.slip.ratio() - 0.2).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn solve_slip(&self, pull: Pull) -> Result<SolvedSlip, Error> {
        let value = pull.parameter().check(pull.value()).map_err(Error::Invalid)?;
        let mut evaluations = 1;
        let pull_at = |slip: f64| {
            evaluations += 1;
            given(pull, &self.at(Slip::new(slip)?)?)
        };
        match slip_of_pull(pull_at, value, (-1.0, 1.0))? {
            Searched::Met { slip } => Ok(SolvedSlip { point: self.at(Slip::new(slip)?)?, evaluations }),
            Searched::Missed { slip, pull: reached, nearest } => Err(Error::PullOutOfReach { pull, reached, slip, nearest }),
        }
    }
}
