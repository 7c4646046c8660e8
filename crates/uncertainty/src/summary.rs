//! What a quantity is like over all samples.

use crate::design::SCRAMBLINGS;
use crate::estimate::{Estimate, ROUNDING, Ratio, scale};

/// The probabilities of the quantiles of a summary.
pub const PROBABILITIES: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];

/// The fewest samples with an answer that are summarised.
const LEAST: usize = 2 * SCRAMBLINGS;

/// Mean, deviation and quantiles of the samples that have an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// How many samples have an answer.
    pub answered: usize,
    /// The mean.
    pub mean: Estimate,
    /// The standard deviation.
    pub deviation: Estimate,
    /// The quantiles at [`PROBABILITIES`].
    pub quantiles: [Estimate; PROBABILITIES.len()],
}

impl Summary {
    /// Of the answers to the first rows of a design, in their order, none where there was no answer. None if there are fewer than
    /// 32 answers, or if one is not finite.
    pub fn of(answers: &[Option<f64>]) -> Option<Self> {
        let known = || answers.iter().enumerate().filter_map(|(sample, answer)| Some((sample, (*answer)?)));
        let mut ascending: Vec<f64> = known().map(|(_, answer)| answer).collect();
        if ascending.len() < LEAST || ascending.iter().any(|answer| !answer.is_finite()) {
            return None;
        }
        ascending.sort_by(f64::total_cmp);
        let scale = scale(ascending.iter().copied());
        let mean = Ratio::mean(known().map(|(sample, answer)| (sample, answer / scale))).estimate()?;
        let square = |answer: f64| (answer / scale - mean.value).powi(2);
        let variance = Ratio::mean(known().map(|(sample, answer)| (sample, square(answer)))).estimate()?;
        if variance.value <= ROUNDING {
            return Some(Self::of_one(mean.times(scale), &ascending));
        }
        let deviation = variance.value.sqrt();
        let error = variance.error / (2.0 * deviation);
        let mut quantiles = [mean; PROBABILITIES.len()];
        for (quantile, probability) in quantiles.iter_mut().zip(PROBABILITIES) {
            *quantile = of_probability(probability, &ascending, known())?;
        }
        Some(Self {
            answered: ascending.len(),
            mean: mean.times(scale),
            deviation: Estimate { value: deviation, error }.times(scale),
            quantiles,
        })
    }

    /// Of answers that are the same but for the rounding of the model: there is no deviation and no error.
    fn of_one(mean: Estimate, ascending: &[f64]) -> Self {
        let quantiles = PROBABILITIES.map(|probability| Estimate { value: quantile(ascending, probability), error: 0.0 });
        Self { answered: ascending.len(), mean: mean.exact(), deviation: Estimate { value: 0.0, error: 0.0 }, quantiles }
    }
}

/// A quantile. Its error is that of the share of samples below it, carried over to the numbers (Woodruff 1952). It is never less than
/// the step to the next sample.
fn of_probability(probability: f64, ascending: &[f64], known: impl Iterator<Item = (usize, f64)>) -> Option<Estimate> {
    let value = quantile(ascending, probability);
    let below = |answer: f64| f64::from(u8::from(answer <= value));
    let share = Ratio::mean(known.map(|(sample, answer)| (sample, below(answer)))).estimate()?;
    let error = share.error.max(1.0 / ascending.len() as f64);
    let [low, high] = [probability - error, probability + error].map(|probability| quantile(ascending, probability));
    // Half of each, because the difference of two large numbers may overflow.
    Some(Estimate { value, error: 0.5 * high - 0.5 * low })
}

/// The quantile of numbers in ascending order: each stands in the middle of its share, with straight lines between (Hyndman & Fan
/// 1996, definition 5).
fn quantile(ascending: &[f64], probability: f64) -> f64 {
    let last = ascending.len() - 1;
    let place = (probability * ascending.len() as f64 - 0.5).clamp(0.0, last as f64);
    let below = place as usize;
    let (low, high) = (ascending[below], ascending[(below + 1).min(last)]);
    let share = place - below as f64;
    low * (1.0 - share) + high * share
}
