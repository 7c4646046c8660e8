//! How often does a condition hold?

use crate::estimate::{Estimate, Ratio};

/// The probability of a condition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Probability {
    /// Among the samples that have an answer; none if there is no such sample. The error is never less than one sample.
    pub among_answered: Option<Estimate>,
    /// How many samples have an answer.
    pub answered: usize,
    /// Share of all samples, if the condition held in none without an answer.
    pub least: f64,
    /// Share of all samples, if it held in every one without an answer.
    pub most: f64,
}

impl Probability {
    /// Of whether it holds at the first rows of a design, in their order, none where there was no answer.
    pub fn of(holds: &[Option<bool>]) -> Self {
        let known = || holds.iter().enumerate().filter_map(|(sample, holds)| Some((sample, (*holds)?)));
        let answered = known().count();
        let held = known().filter(|(_, holds)| *holds).count();
        let all = holds.len().max(1) as f64;
        let floor = 1.0 / answered.max(1) as f64;
        let among = Ratio::mean(known().map(|(sample, holds)| (sample, f64::from(u8::from(holds))))).estimate();
        Self {
            among_answered: among.map(|among| Estimate { error: among.error.max(floor), ..among }),
            answered,
            least: held as f64 / all,
            most: (held + holds.len() - answered) as f64 / all,
        }
    }
}
