//! How far is the pull off over all the points that other programs have predicted too? `validation/across-sets/pooled.json` has
//! the sets and what the others publish.

use std::sync::LazyLock;

use serde::Deserialize;
use serde_json::{Map, Value};

use super::prediction::Variation;
use super::{Prediction, Record, root_mean_square};

/// Sets whose points are pooled.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Pooled {
    pub(crate) sets: Vec<String>,
    /// The runs that are shown, by the names of their columns.
    pub(crate) series: Vec<String>,
    /// Further ways to run the sets.
    pub(crate) variants: Vec<Variant>,
    pub(crate) published: Vec<Published>,
}

/// Another way to run the sets: by other conventions.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Variant {
    pub(crate) series: String,
    /// Fields of the request in place of those of the set.
    fields: Map<String, Value>,
}

impl Variant {
    /// Error of the pull of a set, at each point over its load; none where a point has no solution.
    pub(crate) fn error(&self, record: &Record) -> Option<f64> {
        let run = record.quadrature()?;
        let prediction = Prediction::varied(record, run, &Variation { of_soil: &[], fields: Some(&self.fields) });
        let errors = prediction.pull_errors(record);
        if errors.iter().any(|error| error.is_nan()) { None } else { root_mean_square(errors.into_iter()) }
    }
}

/// What another program publishes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Published {
    pub(crate) program: String,
    /// Error of the pull over the load, by set.
    pub(crate) drawbar_rmse_over_load: Vec<f64>,
}

static POOLED: LazyLock<Pooled> = LazyLock::new(|| {
    serde_json::from_str(include_str!("../../validation/across-sets/pooled.json"))
        .expect("the sets are compiled in and their test reads them")
});

impl Pooled {
    /// Those that are kept.
    pub(crate) fn kept() -> &'static Self {
        &POOLED
    }
}

/// The error over the points of several sets together, from the error and the number of points of each; none where one is lacking.
pub(crate) fn pooled_error(of_sets: impl Iterator<Item = (Option<f64>, usize)>) -> Option<f64> {
    let (mut squares, mut count) = (0.0, 0.0);
    for (error, points) in of_sets {
        let points = points as f64;
        squares += error?.powi(2) * points;
        count += points;
    }
    (count > 0.0).then(|| (squares / count).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::record;

    #[test]
    fn every_set_is_a_prediction_and_every_program_has_an_error_for_it() {
        let Pooled { sets, published, variants, .. } = Pooled::kept();
        for variant in variants {
            for id in sets {
                assert!(record(id).and_then(|record| variant.error(record)).is_some(), "{} of {id}", variant.series);
            }
        }
        for id in sets {
            assert_eq!(record(id).map(|record| &record.fitted_to), Some(&None), "{id}");
        }
        for Published { program, drawbar_rmse_over_load } in published {
            assert_eq!(drawbar_rmse_over_load.len(), sets.len(), "{program}");
        }
    }

    #[test]
    fn errors_are_pooled_by_their_squares_and_points() {
        assert_eq!(pooled_error([(Some(3.0), 1), (Some(1.0), 7)].into_iter()), Some(2.0_f64.sqrt()));
        assert_eq!(pooled_error([(Some(3.0), 1), (None, 7)].into_iter()), None);
        assert_eq!(pooled_error([].into_iter()), None);
    }
}
