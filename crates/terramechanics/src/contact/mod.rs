//! Where does the wheel touch the soil, and where are the stresses largest? (letter, Eqs. 3, 8, 13)
//!
//! Departure: Eq. (13) as printed halves the entry angle; Eq. (3) at θ = 0 gives θ1 = arccos(1 − z/r) (erratum 7).

mod exit;
mod half_sinkage;
mod interface;
mod midpoint;
mod wong_reece;

pub use exit::{AngleRatio, ExitRule, SinkageRatio};
pub use half_sinkage::HalfSinkage;
pub use interface::Interface;
pub use midpoint::Midpoint;
pub use wong_reece::WongReece;

use crate::braking::Braking;
use crate::circles::Circles;
use crate::error::Error;
use crate::fault::InvalidInput;
use crate::law::family;
use crate::numerics::elementary::Number;
use crate::slip::Slip;

family! {
    /// Rule for the angle of maximum stress θm.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub enum PeakRule {
        /// θm = (θ1 + θ2)/2. Shibly et al. 2005.
        Midpoint,
        /// θm = (c1 + c2 s) θ1. Wong & Reece 1967.
        WongReece(WongReece),
        /// θm = arccos(1 − z/(2r)): half of the sinkage lies above the peak, which makes Eq. (8) exact.
        HalfSinkage,
    }
}

impl PeakRule {
    /// θm (rad) in a contact; the rule does not look whether it lies inside.
    #[inline(always)]
    fn peak<F: Number>(&self, arc: &ContactArc<F>) -> F {
        match self {
            Self::Midpoint => Midpoint.peak(arc),
            Self::WongReece(rule) => rule.peak(arc),
            Self::HalfSinkage => HalfSinkage.peak(arc),
        }
    }

    /// dθm/dθ1 (–) as the wheel sinks and its exit moves at `exit_rate` = dθ2/dθ1.
    #[inline(always)]
    fn rate<F: Number>(&self, depth_ratio: F, slip: F, exit_rate: F) -> F {
        match self {
            Self::Midpoint => Midpoint.rate(exit_rate),
            Self::WongReece(rule) => rule.rate(slip),
            Self::HalfSinkage => HalfSinkage.rate(depth_ratio),
        }
    }
}

/// A contact, as far as the rules for its peak ask.
struct ContactArc<F> {
    /// Entry angle θ1 (rad).
    entry: F,
    /// Exit angle θ2 (rad).
    exit: F,
    /// z/r (–).
    depth_ratio: F,
    /// The slip ratio (–).
    slip: F,
}

/// Parameters of the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactParams {
    /// Rule for the angle of maximum stress.
    pub rule: PeakRule,
    /// Rule for the exit angle.
    pub exit: ExitRule,
    /// The circles on which displacement and slip are counted.
    pub circles: Circles,
    /// What the rim has in place of the soil's strength, where it was measured.
    pub interface: Option<Interface>,
}

impl ContactParams {
    /// Peak at the midpoint, exit at the lowest point, the displacement counted where the stress acts and the slip on the rim, the
    /// strength of the soil.
    pub const MIDPOINT: Self =
        Self { rule: PeakRule::Midpoint, exit: ExitRule::LOWEST_POINT, circles: Circles::SHEARING, interface: None };
}

/// How the contact is placed on the rim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    params: ContactParams,
    braking: Braking,
}

/// The characteristic angles of a contact (rad), from straight down, positive towards the front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Angles<F = f64> {
    /// Entry angle θ1.
    pub entry: F,
    /// Angle of maximum stress θm, strictly between exit and entry.
    pub peak: F,
    /// Exit angle θ2.
    pub exit: F,
}

/// How the angles of a contact move as the wheel sinks (–).
#[derive(Debug, Clone, Copy)]
pub(crate) struct AngleRates<F = f64> {
    /// dθm/dθ1.
    pub(crate) peak: F,
    /// dθ2/dθ1.
    pub(crate) exit: F,
}

impl AngleRates {
    /// Of angles that do not move.
    pub(crate) const FIXED: Self = Self { peak: 0.0, exit: 0.0 };
}

impl Contact {
    /// Peak at the midpoint, exit at the lowest point.
    pub const MIDPOINT: Self = Self { params: ContactParams::MIDPOINT, braking: Braking::OneZone };

    /// Checks the parameters. A braking wheel has one zone, see [`Contact::with_braking`].
    ///
    /// # Errors
    /// Every parameter that is not finite or outside its range.
    pub fn new(params: ContactParams) -> Result<Self, InvalidInput> {
        let interface = params.interface.iter().flat_map(Interface::parameters);
        InvalidInput::check(params.rule.parameters().chain(params.exit.parameters()).chain(interface))?;
        Ok(Self { params, braking: Braking::OneZone })
    }

    /// The parameters it was made of.
    #[must_use]
    pub fn params(&self) -> &ContactParams {
        &self.params
    }

    /// The same contact with another law for a braking wheel. Two zones have their peak where they part, not where the rule
    /// for a driving wheel has it.
    #[must_use]
    pub fn with_braking(self, braking: Braking) -> Self {
        Self { braking, ..self }
    }

    /// The same contact with displacement and slip counted on other circles.
    #[must_use]
    pub fn with_circles(self, circles: Circles) -> Self {
        Self { params: ContactParams { circles, ..self.params }, ..self }
    }

    /// The circles on which displacement and slip are counted.
    #[must_use]
    pub fn circles(&self) -> Circles {
        self.params.circles
    }

    /// Law for a braking wheel.
    #[must_use]
    pub fn braking(&self) -> Braking {
        self.braking
    }

    /// Whether the peak of a contact of one zone lies elsewhere at another slip.
    #[must_use]
    pub fn peak_moves_with_slip(&self) -> bool {
        match self.params.rule {
            PeakRule::WongReece(rule) => rule.c2 != 0.0,
            PeakRule::Midpoint | PeakRule::HalfSinkage => false,
        }
    }

    /// Whether the law for a braking wheel sets aside a rule for the peak other than the plain midpoint.
    pub(crate) fn sets_rule_aside(&self) -> bool {
        self.braking == Braking::TwoZone && self.params.rule != PeakRule::Midpoint
    }

    /// Angles of a contact of one zone whose sinkage is `depth_ratio` = z/r, in 0 < z/r ≤ 1.
    ///
    /// # Errors
    /// [`Error::PeakOutsideContact`] where the rule does not give θ2 < θm < θ1.
    ///
    /// ```
    /// # use terramechanics::{Contact, Slip};
    /// let angles = Contact::MIDPOINT.angles(1.0, Slip::ROLLING)?; // sunk to the axle: a quarter of the rim
    /// assert!((angles.entry - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    /// assert_eq!(angles.peak, 0.5 * angles.entry);
    /// # Ok::<(), terramechanics::Error>(())
    /// ```
    pub fn angles(&self, depth_ratio: f64, slip: Slip) -> Result<Angles, Error> {
        let angles = self.angles_by_rule(depth_ratio, slip.ratio());
        let Angles { entry, peak, exit } = angles;
        if angles.are_in_order() { Ok(angles) } else { Err(Error::PeakOutsideContact { entry, peak, exit }) }
    }

    /// The same whether or not the peak lies inside, at a `slip` ratio (–).
    #[inline(always)]
    pub(crate) fn angles_by_rule<F: Number>(&self, depth_ratio: F, slip: F) -> Angles<F> {
        let entry = angle_at_depth(depth_ratio); // Eq. (13), corrected
        let exit = self.params.exit.place(entry, depth_ratio);
        let peak = self.params.rule.peak(&ContactArc { entry, exit, depth_ratio, slip });
        Angles { entry, peak, exit }
    }

    /// Rates of the angles of a contact of one zone against the entry angle, as the wheel sinks: at z/r and a slip ratio (–).
    #[inline(always)]
    pub(crate) fn rates<F: Number>(&self, depth_ratio: F, slip: F) -> AngleRates<F> {
        let exit = self.params.exit.rate(depth_ratio);
        AngleRates { peak: self.params.rule.rate(depth_ratio, slip, exit), exit }
    }

    /// Angles of a contact of two zones that part at `reversal` (rad), and of sinkage `depth_ratio` = z/r.
    ///
    /// # Errors
    /// [`Error::ReversalOutsideContact`] where there is no room for both.
    #[cold]
    #[inline(never)]
    pub(crate) fn angles_parted_at(&self, reversal: f64, depth_ratio: f64) -> Result<Angles, Error> {
        let entry = angle_at_depth(depth_ratio);
        let exit = self.params.exit.exit(entry, depth_ratio);
        if exit < reversal && reversal < entry {
            Ok(Angles { entry, peak: reversal, exit })
        } else {
            Err(Error::ReversalOutsideContact { entry, reversal, exit })
        }
    }

    /// Sinkages (m) between which two zones that part at `reversal` (rad) have room, on a wheel of `radius` (m): where the
    /// contact enters there, and where it leaves there if it leaves ahead of the lowest point.
    pub(crate) fn sinkages_parted_at(&self, reversal: f64, radius: f64) -> (f64, f64) {
        let depth_at = |angle: f64| 2.0 * radius * (0.5 * angle).sin().powi(2);
        let deepest = match self.params.exit.entry_of(reversal) {
            Some(entry) if entry < std::f64::consts::FRAC_PI_2 => depth_at(entry) * (1.0 - INSIDE),
            _ => radius,
        };
        (depth_at(reversal), deepest)
    }
}

impl Angles {
    /// Whether θ2 < θm < θ1.
    #[inline]
    pub(crate) fn are_in_order(&self) -> bool {
        self.exit < self.peak && self.peak < self.entry
    }
}

/// Share by which the deepest contact stays short of the one that has no rear zone.
const INSIDE: f64 = 1e-9;

/// Angle (rad) whose cosine lies d = z/r below 1: arccos(1 − d) as 2 arcsin √(d/2), which keeps its digits where d is small. For d
/// from 0 to 1.2, beyond which no contact reaches.
#[inline(always)]
pub(crate) fn angle_at_depth<F: Number>(d: F) -> F {
    (d * 0.5).arcsin_root() * 2.0
}
