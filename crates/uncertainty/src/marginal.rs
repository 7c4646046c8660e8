//! A distribution within what its input may be.

use crate::bounds::Bounds;
use crate::distribution::Distribution;
use crate::error::InputError;

/// The largest share of a distribution that is cut off. With more outside than inside, the centre is outside as well, and the
/// distribution is not what was meant.
pub const MOST_CUT: f64 = 0.5;

/// A distribution cut off at the bounds of its input.
///
/// One without ends, normal or lognormal, is truncated: what is outside is left out and the rest grows to 1, so that no sample piles
/// up at a bound. The mean then is no longer that of the whole distribution; [`share_cut`](Self::share_cut) tells how much is
/// missing. One with ends beyond the bounds is refused, because its ends were chosen.
#[derive(Debug, Clone, PartialEq)]
pub struct Marginal {
    distribution: Distribution,
    bounds: Bounds,
    /// The shares of the whole distribution below the lower and below the upper bound.
    kept: [f64; 2],
}

/// The furthest that a sample comes to 0 and to 1.
pub(crate) const NEAREST_TO_END: f64 = 1.0 / 16_777_216.0;

impl Marginal {
    /// The distribution within the bounds.
    ///
    /// # Errors
    /// Parameters that make no distribution, ends beyond the bounds, or more than [`MOST_CUT`] of it outside.
    pub fn new(distribution: Distribution, bounds: Bounds) -> Result<Self, InputError> {
        distribution.check()?;
        if let Some([low, high]) = distribution.ends() {
            if low < bounds.lower || high > bounds.upper {
                return Err(InputError::Outside { low, high, bounds });
            }
            return Self { distribution, bounds, kept: [0.0, 1.0] }.checked();
        }
        let kept = [distribution.share_below(bounds.lower), distribution.share_below(bounds.upper)];
        let share = 1.0 - (kept[1] - kept[0]);
        // A parameter that overflows makes no number of the share.
        if share.is_nan() {
            return Err(InputError::TooWide);
        }
        if share > MOST_CUT {
            return Err(InputError::MostlyOutside { share, bounds });
        }
        Self { distribution, bounds, kept }.checked()
    }

    /// The quantiles ascend: where those nearest to the ends are finite, all are.
    fn checked(self) -> Result<Self, InputError> {
        let ends = [self.quantile(NEAREST_TO_END), self.quantile(1.0 - NEAREST_TO_END)];
        if ends.iter().all(|end| end.is_finite()) { Ok(self) } else { Err(InputError::TooWide) }
    }

    /// The number below which the share p lies, for p in (0, 1).
    pub fn quantile(&self, p: f64) -> f64 {
        let [below, above] = self.kept;
        self.bounds.clamp(self.distribution.quantile(below + p * (above - below)))
    }

    /// The share of the distribution that lies outside the bounds and is left out.
    pub fn share_cut(&self) -> f64 {
        1.0 - (self.kept[1] - self.kept[0])
    }

    /// The whole distribution.
    pub fn distribution(&self) -> &Distribution {
        &self.distribution
    }

    /// What the input may be.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }
}
