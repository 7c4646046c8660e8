//! What have others measured, and what does the model give for it? Published single-wheel tests, compiled in from
//! `validation/*.json`, and the predictions for them.
//!
//! A set is a series of measurements together with the soil that stands for theirs. Where parameters of that soil were fitted
//! to the very measurements, the set says so, and nothing is averaged over sets of both kinds. Adding a set is adding a
//! record to that folder and to [`RECORDS`]. What is said of several sets together is in `validation/across-sets`.

mod compared;
mod held_out;
mod inputs;
mod points;
mod pooled;
mod prediction;
mod record;
mod run;
mod sensitivity;
mod side_slip;

pub(crate) use compared::{COMPARED, Compared};
pub(crate) use held_out::{FitScore, HeldOut, Part, fits, held_out};
pub(crate) use inputs::Origin;
pub(crate) use pooled::{Pooled, pooled_error};
pub(crate) use prediction::{Prediction, root_mean_square, system};
pub(crate) use record::{MeasurementGrade, Record};
pub(crate) use run::{Known, Run, all_runs};
pub(crate) use sensitivity::{AtModulus, of_shear_modulus};

use std::sync::LazyLock;

/// The records, in the order in which they are shown.
const RECORDS: [&str; 23] = [
    include_str!("../../validation/ding-2011-smooth.json"),
    include_str!("../../validation/ding-2011-smooth-fitted.json"),
    include_str!("../../validation/ding-2011-lug10.json"),
    include_str!("../../validation/ding-2011-lug10-fitted.json"),
    include_str!("../../validation/wang-han-2016-smooth.json"),
    include_str!("../../validation/wang-han-2016-smooth-fitted.json"),
    include_str!("../../validation/wang-han-2016-lug10.json"),
    include_str!("../../validation/wang-han-2016-lug10-fitted.json"),
    include_str!("../../validation/hurrell-2025-rashid.json"),
    include_str!("../../validation/yoshida-2003-24n.json"),
    include_str!("../../validation/yoshida-2003-34n.json"),
    include_str!("../../validation/yoshida-2003-54n.json"),
    include_str!("../../validation/cmu-grousered-driving.json"),
    include_str!("../../validation/cmu-grousered-braking.json"),
    include_str!("../../validation/cmu-smooth-driving.json"),
    include_str!("../../validation/cmu-smooth-braking.json"),
    include_str!("../../validation/cmu-grousered-side-15.json"),
    include_str!("../../validation/cmu-grousered-side-30.json"),
    include_str!("../../validation/cmu-grousered-side-45.json"),
    include_str!("../../validation/cmu-smooth-side-15.json"),
    include_str!("../../validation/cmu-smooth-side-30.json"),
    include_str!("../../validation/cmu-smooth-side-45.json"),
    include_str!("../../validation/apollo-lrv.json"),
];

static SETS: LazyLock<Vec<Record>> = LazyLock::new(|| {
    RECORDS
        .iter()
        .map(|text| serde_json::from_str(text).expect("the records are compiled in and their tests read them"))
        .collect()
});

/// All sets.
pub(crate) fn records() -> &'static [Record] {
    &SETS
}

/// The set of that name.
pub(crate) fn record(id: &str) -> Option<&'static Record> {
    records().iter().find(|record| record.id == id)
}

/// The names of all sets.
pub(crate) fn ids() -> Vec<&'static str> {
    records().iter().map(|record| record.id.as_str()).collect()
}

/// Operating points that all sets together take by the quadrature: straight ahead, and at a slip angle.
pub(crate) fn quadratures() -> (usize, usize) {
    let of = |is_sideways: bool| {
        let runs = records().iter().flat_map(|record| record.runs().into_iter().map(move |run| (record, run)));
        let by_quadrature = runs.filter(|(_, run)| run.is_integral() && run.side.is_some() == is_sideways);
        by_quadrature.map(|(record, _)| record.points().slip.len()).sum()
    };
    let straight = records().iter().filter(|record| record.side_slip.is_none());
    let beside: usize = straight.map(|record| sensitivity::RUNS * record.points().slip.len()).sum();
    let pooled = Pooled::kept();
    let of_pooled: usize = pooled.sets.iter().filter_map(|id| record(id)).map(|record| record.points().slip.len()).sum();
    (of(false) + beside + pooled.variants.len() * of_pooled, of(true))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_file_is_a_set_named_like_it() {
        let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/validation")).expect("the folder");
        let paths = files.map(|file| file.expect("a file").path()).filter(|path| path.is_file());
        let named: BTreeSet<String> =
            paths.map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned()).collect();
        assert_eq!(ids().into_iter().map(str::to_owned).collect::<BTreeSet<_>>(), named);
        assert_eq!(ids().len(), named.len());
    }

    #[test]
    fn columns_are_as_long_as_the_slip_which_ascends() {
        for record in records() {
            let points = record.points();
            assert!(points.slip.is_sorted() && !points.slip.is_empty(), "{}", record.id);
            let load = points.load();
            assert_eq!(load.len(), points.slip.len(), "{}", record.id);
            for column in COMPARED.iter().filter_map(|compared| compared.published(points)) {
                assert_eq!(column.len(), points.slip.len(), "{}", record.id);
            }
            assert!(load.iter().all(|load| *load > 0.0));
            assert!(record.slip().is_sorted(), "{}", record.id);
        }
    }
}
