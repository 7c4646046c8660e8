//! At which numbers has a model to be evaluated?
//!
//! Saltelli et al. (2010), Computer Physics Communications 181, 259–270: two independent sets A and B of samples, and for each input
//! i a set A with the column of i taken from B. Here the columns of a whole group of correlated inputs are taken at once: the groups
//! are independent of one another, as the decomposition of variance needs, and their members are not.

use crate::error::DesignError;
use crate::inputs::Inputs;
use crate::marginal::NEAREST_TO_END;

/// How many independent scramblings the samples come in.
pub const SCRAMBLINGS: usize = 16;

/// The fewest samples: sixteen points of each scrambling.
pub const LEAST_SAMPLES: usize = 16 * SCRAMBLINGS;

/// The most samples.
pub const MOST_SAMPLES: usize = 1 << 16;

/// The largest seed; beyond it two seeds would share scramblings.
pub const MOST_SEED: u32 = u32::MAX / SCRAMBLINGS as u32;

/// A list of rows of numbers, one number for each input.
///
/// The first [`samples`](Self::samples) rows are those of set A. With sensitivities those of B follow, then those of A with the
/// first group taken from B, and so on. Rows are made when asked for, so that a list of a million takes no memory.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    inputs: Inputs,
    samples: usize,
    seed: u32,
    has_sensitivities: bool,
}

impl Design {
    /// A design of that many samples. A power of two fills the space most evenly.
    ///
    /// # Errors
    /// Fewer samples than [`LEAST_SAMPLES`], more than [`MOST_SAMPLES`], or a seed above [`MOST_SEED`].
    pub fn new(inputs: Inputs, samples: usize, seed: u32) -> Result<Self, DesignError> {
        if !(LEAST_SAMPLES..=MOST_SAMPLES).contains(&samples) {
            return Err(DesignError::Samples { count: samples });
        }
        if seed > MOST_SEED {
            return Err(DesignError::Seed { seed });
        }
        Ok(Self { inputs, samples, seed, has_sensitivities: false })
    }

    /// The same design with the rows that sensitivities need: 2 + groups as many.
    #[must_use]
    pub fn with_sensitivities(self) -> Self {
        Self { has_sensitivities: true, ..self }
    }

    /// Its inputs.
    pub fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// How many samples the bands are made of.
    pub fn samples(&self) -> usize {
        self.samples
    }

    /// How many rows there are.
    pub fn rows(&self) -> usize {
        let sets = if self.has_sensitivities { 2 + self.inputs.groups().len() } else { 1 };
        self.samples * sets
    }

    /// The numbers of a row in the order of the inputs; none beyond the last row.
    pub fn row(&self, row: usize) -> Option<Vec<f64>> {
        if row >= self.rows() {
            return None;
        }
        let (set, sample) = (row / self.samples, row % self.samples);
        let count = self.inputs.sources().len();
        let exchanged = set.checked_sub(2).and_then(|group| self.inputs.groups().get(group));
        let of_b = |source: usize| set == 1 || exchanged.is_some_and(|group| group.contains(&source));
        let point: Vec<f64> =
            (0..count).map(|source| self.coordinate(sample, if of_b(source) { count + source } else { source })).collect();
        Some(self.inputs.values(&point))
    }

    /// A coordinate of a sample, in (0, 1).
    fn coordinate(&self, sample: usize, dimension: usize) -> f64 {
        let scrambling = self.seed * SCRAMBLINGS as u32 + (sample % SCRAMBLINGS) as u32;
        let coordinate = sobol_burley::sample((sample / SCRAMBLINGS) as u32, dimension as u32, scrambling);
        // Coordinates are multiples of 2⁻²³ from 0; half a step further they keep away from both ends.
        f64::from(coordinate) + NEAREST_TO_END
    }
}
