//! Distributions of one number, each by the parameters in which people give it.

use crate::error::InputError;
use crate::joint::MOST_VALUES;
use crate::normal;

/// A distribution of one number.
#[derive(Debug, Clone, PartialEq)]
pub enum Distribution {
    /// Gauss's.
    Normal {
        /// Its mean.
        mean: f64,
        /// Its standard deviation.
        deviation: f64,
    },
    /// The logarithm is normal. The parameters are those of the number itself, not of its logarithm.
    LogNormal {
        /// Mean of the number.
        mean: f64,
        /// Standard deviation of the number.
        deviation: f64,
    },
    /// Every number of an interval alike.
    Uniform {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// A density that rises in a line to the mode and falls in a line from it.
    Triangular {
        /// Lower end.
        low: f64,
        /// Where it is densest.
        mode: f64,
        /// Upper end.
        high: f64,
    },
    /// Quantiles at even steps of probability from 0 to 1, with straight lines between them: of k known values in ascending order,
    /// each step between neighbours has the probability 1/(k − 1).
    Quantiles {
        /// The known values, ascending.
        values: Vec<f64>,
    },
}

impl Distribution {
    /// Whether its parameters make a distribution.
    pub(crate) fn check(&self) -> Result<(), InputError> {
        let is_finite = |numbers: &[f64]| numbers.iter().all(|number| number.is_finite());
        let finite = |numbers: &[f64]| if is_finite(numbers) { Ok(()) } else { Err(InputError::NotFinite) };
        match self {
            Self::Normal { mean, deviation } | Self::LogNormal { mean, deviation } => {
                finite(&[*mean, *deviation])?;
                if *deviation <= 0.0 {
                    return Err(InputError::Deviation { deviation: *deviation });
                }
                if matches!(self, Self::LogNormal { .. }) && *mean <= 0.0 {
                    return Err(InputError::Mean { mean: *mean });
                }
            }
            Self::Uniform { low, high } | Self::Triangular { low, high, .. } => {
                finite(&[*low, *high])?;
                if low >= high {
                    return Err(InputError::Ends { low: *low, high: *high });
                }
                if let Self::Triangular { mode, .. } = self
                    && !(low..=high).contains(&mode)
                {
                    return Err(if mode.is_finite() { InputError::Mode { mode: *mode } } else { InputError::NotFinite });
                }
            }
            Self::Quantiles { values } => {
                if !(2..=MOST_VALUES).contains(&values.len()) {
                    return Err(InputError::Count { count: values.len() });
                }
                finite(values)?;
                if let Some(row) = values.windows(2).position(|pair| pair[0] > pair[1]) {
                    return Err(InputError::Order { row: row + 1 });
                }
            }
        }
        Ok(())
    }

    /// Mean and standard deviation of the logarithm of a lognormal number.
    fn of_logarithm(mean: f64, deviation: f64) -> (f64, f64) {
        let relative = deviation / mean;
        let variance = libm::log1p(relative * relative);
        (libm::log(mean) - 0.5 * variance, variance.sqrt())
    }

    /// The number below which the share p of it lies, for p in (0, 1): the inverse of [`share_below`](Self::share_below).
    pub(crate) fn quantile(&self, p: f64) -> f64 {
        match self {
            Self::Normal { mean, deviation } => mean + deviation * normal::quantile(p),
            Self::LogNormal { mean, deviation } => {
                let (centre, width) = Self::of_logarithm(*mean, *deviation);
                libm::exp(centre + width * normal::quantile(p))
            }
            Self::Uniform { low, high } => low + p * (high - low),
            Self::Triangular { low, mode, high } => {
                let below = (mode - low) / (high - low);
                if p < below {
                    low + (high - low) * (p * below).sqrt()
                } else {
                    high - (high - low) * ((1.0 - p) * (1.0 - below)).sqrt()
                }
            }
            Self::Quantiles { values } => {
                let steps = values.len() - 1;
                let place = p * steps as f64;
                let step = (place as usize).min(steps - 1);
                values[step] + (place - step as f64) * (values[step + 1] - values[step])
            }
        }
    }

    /// The share of it below a number.
    pub fn share_below(&self, x: f64) -> f64 {
        match self {
            Self::Normal { mean, deviation } => normal::share_below((x - mean) / deviation),
            Self::LogNormal { mean, deviation } if x > 0.0 => {
                let (centre, width) = Self::of_logarithm(*mean, *deviation);
                normal::share_below((libm::log(x) - centre) / width)
            }
            Self::LogNormal { .. } => 0.0,
            Self::Uniform { low, high } => ((x - low) / (high - low)).clamp(0.0, 1.0),
            Self::Triangular { low, mode, high } => {
                let (place, below) = (((x - low) / (high - low)).clamp(0.0, 1.0), (mode - low) / (high - low));
                match place {
                    1.0 => 1.0,
                    place if place < below => place * place / below,
                    _ => 1.0 - (1.0 - place) * (1.0 - place) / (1.0 - below),
                }
            }
            Self::Quantiles { values } => {
                let within = |pair: &[f64]| if pair[0] < x { ((x - pair[0]) / (pair[1] - pair[0])).min(1.0) } else { 0.0 };
                values.windows(2).map(within).sum::<f64>() / (values.len() - 1) as f64
            }
        }
    }

    /// The quantiles by which it is given, if it is.
    pub fn values(&self) -> Option<&[f64]> {
        match self {
            Self::Quantiles { values } => Some(values),
            Self::Normal { .. } | Self::LogNormal { .. } | Self::Uniform { .. } | Self::Triangular { .. } => None,
        }
    }

    /// The ends beyond which it has nothing, if it has any.
    pub fn ends(&self) -> Option<[f64; 2]> {
        match self {
            Self::Normal { .. } | Self::LogNormal { .. } => None,
            Self::Uniform { low, high } | Self::Triangular { low, high, .. } => Some([*low, *high]),
            Self::Quantiles { values } => Some([*values.first()?, *values.last()?]),
        }
    }

    /// Its mean, before anything is cut off.
    pub fn mean(&self) -> f64 {
        match self {
            Self::Normal { mean, .. } | Self::LogNormal { mean, .. } => *mean,
            Self::Uniform { low, high } => 0.5 * (low + high),
            Self::Triangular { low, mode, high } => (low + mode + high) / 3.0,
            Self::Quantiles { values } => over_steps(values, |low, high| 0.5 * (low + high)),
        }
    }

    /// Its standard deviation, before anything is cut off.
    pub fn deviation(&self) -> f64 {
        match self {
            Self::Normal { deviation, .. } | Self::LogNormal { deviation, .. } => *deviation,
            Self::Uniform { low, high } => (high - low) / 12.0_f64.sqrt(),
            Self::Triangular { low, mode, high } => {
                let (left, right) = (mode - low, high - mode);
                ((left * left + left * right + right * right) / 18.0).sqrt()
            }
            Self::Quantiles { values } => {
                let mean = self.mean();
                let about = |low: f64, high: f64| {
                    let (low, high) = (low - mean, high - mean);
                    (low * low + low * high + high * high) / 3.0
                };
                over_steps(values, about).sqrt()
            }
        }
    }
}

/// The mean of what each step between neighbours has.
fn over_steps(values: &[f64], of: impl Fn(f64, f64) -> f64) -> f64 {
    let steps = values.windows(2).map(|pair| of(pair[0], pair[1]));
    steps.sum::<f64>() / (values.len() - 1) as f64
}
