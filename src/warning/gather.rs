//! Warnings of several rows and series, each said once.

use terramechanics::Caution;

use super::{Rows, Warning};

/// A kind of caution at several rows.
#[derive(Debug, Clone)]
struct Cautioned {
    /// The one that is furthest out.
    worst: Caution,
    /// Whether the values differ.
    varies: bool,
    rows: Vec<usize>,
}

impl Cautioned {
    /// Takes the value of another row or run, if it is of the same kind.
    fn take(&mut self, other: Caution, varies: bool) {
        self.varies |= varies || other.value.to_bits() != self.worst.value.to_bits();
        if other.excess() > self.worst.excess() {
            self.worst = other;
        }
    }

    /// The warning in a table of `count` rows; one of every row names none.
    fn warning(&self, count: usize) -> Warning {
        let warning = Warning::from(self.worst).varying(self.varies);
        if self.rows.len() == count { warning } else { warning.at(Rows::of(&self.rows)) }
    }
}

/// The cautions of several rows: per kind the one that is furthest out, with the rows that carry it.
#[derive(Debug, Clone, Default)]
pub(crate) struct RowCautions(Vec<Cautioned>);

impl RowCautions {
    /// Takes those of a row.
    pub(crate) fn add(&mut self, row: usize, cautions: impl Iterator<Item = Caution>) {
        for caution in cautions {
            match self.0.iter_mut().find(|known| std::ptr::eq(known.worst.kind, caution.kind)) {
                Some(known) => {
                    known.rows.push(row);
                    known.take(caution, false);
                }
                None => self.0.push(Cautioned { worst: caution, varies: false, rows: vec![row] }),
            }
        }
    }

    /// One warning per kind, for a table of `count` rows.
    pub(crate) fn into_warnings(self, count: usize) -> impl Iterator<Item = Warning> {
        self.0.into_iter().map(move |cautioned| cautioned.warning(count))
    }
}

/// The cautions of several runs over the same `count` rows: one warning per kind where the rows agree, with the value that is
/// furthest out, and the names of the runs unless it is all of them.
pub(crate) fn shared_warnings(runs: Vec<(&'static str, RowCautions)>, count: usize) -> Vec<Warning> {
    let all = runs.len();
    let mut found: Vec<(Cautioned, Vec<String>)> = Vec::new();
    for (name, RowCautions(cautions)) in runs {
        for cautioned in cautions {
            let is_same =
                |known: &Cautioned| std::ptr::eq(known.worst.kind, cautioned.worst.kind) && known.rows == cautioned.rows;
            match found.iter_mut().find(|(known, _)| is_same(known)) {
                Some((known, names)) => {
                    names.push(name.to_owned());
                    known.take(cautioned.worst, cautioned.varies);
                }
                None => found.push((cautioned, vec![name.to_owned()])),
            }
        }
    }
    let warnings = found.into_iter().map(|(cautioned, names)| {
        let warning = cautioned.warning(count);
        if names.len() == all { warning } else { warning.of_series(names) }
    });
    warnings.collect()
}

/// What is said of every series, once; then what is said of some, with the names of those.
pub(crate) fn gathered(told: Vec<(String, Vec<Warning>)>) -> Vec<Warning> {
    let all = told.len();
    let mut found: Vec<(Warning, Vec<String>)> = Vec::new();
    for (name, warnings) in told {
        for warning in warnings {
            match found.iter_mut().find(|(known, _)| *known == warning) {
                Some((_, names)) => names.push(name.clone()),
                None => found.push((warning, vec![name.clone()])),
            }
        }
    }
    let (of_all, of_some): (Vec<_>, Vec<_>) = found.into_iter().partition(|(_, names)| names.len() == all);
    of_all
        .into_iter()
        .map(|(warning, _)| warning)
        .chain(of_some.into_iter().map(|(warning, names)| warning.of_series(names)))
        .collect()
}
