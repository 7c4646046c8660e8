//! Counts over the samples of a run, in constant memory.

use super::{Channel, Status};
use crate::caution::Caution;
use crate::error::Error;

/// Count of samples, such as those with one status.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tally {
    /// How many there were.
    pub count: u64,
    /// Row of the first, from 0.
    pub first_row: u64,
    /// Why the model refused the first, where it did.
    pub error: Option<Error>,
}

/// Count of samples that have a status because of their value in one channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CulpritTally {
    /// The status.
    pub status: Status,
    /// The channel.
    pub channel: Channel,
    /// How many there were.
    pub count: u64,
    /// The value of the first, in the channel's unit; NaN where it is missing.
    pub first_value: f64,
    /// The largest magnitude among the values.
    pub largest: f64,
}

/// Count of samples with a caution of one kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CautionTally {
    /// The caution of the sample furthest beyond the range.
    pub worst: Caution,
    /// How many there were.
    pub count: u64,
    /// Row of the first, from 0.
    pub first_row: u64,
}

impl Tally {
    /// Counts the sample of that row.
    pub(super) fn count(tally: &mut Option<Self>, row: u64, error: Option<Error>) {
        match tally {
            Some(tally) => tally.count += 1,
            None => *tally = Some(Self { count: 1, first_row: row, error }),
        }
    }
}

impl CulpritTally {
    /// Counts a sample by the value that gave it the status.
    pub(super) fn count(tallies: &mut Vec<Self>, status: Status, channel: Channel, value: f64) {
        match tallies.iter_mut().find(|known| known.status == status && known.channel == channel) {
            Some(known) => {
                known.count += 1;
                known.largest = known.largest.max(value.abs());
            }
            None => tallies.push(Self { status, channel, count: 1, first_value: value, largest: value.abs() }),
        }
    }
}

impl CautionTally {
    /// Counts the cautions of a sample and keeps, for each kind, the one furthest beyond its range.
    pub(super) fn count(tallies: &mut Vec<Self>, row: u64, cautions: impl Iterator<Item = Caution>) {
        for caution in cautions {
            match tallies.iter_mut().find(|known| std::ptr::eq(known.worst.kind, caution.kind)) {
                Some(known) => {
                    known.count += 1;
                    if caution.excess() > known.worst.excess() {
                        known.worst = caution;
                    }
                }
                None => tallies.push(Self { worst: caution, count: 1, first_row: row }),
            }
        }
    }
}

/// A sum that keeps the digits of small terms after millions of them (Neumaier 1974).
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CompensatedSum {
    sum: f64,
    lost: f64,
}

impl CompensatedSum {
    pub(super) fn add(&mut self, term: f64) {
        let sum = self.sum + term;
        self.lost += if self.sum.abs() >= term.abs() { (self.sum - sum) + term } else { (term - sum) + self.sum };
        self.sum = sum;
    }

    pub(super) fn value(self) -> f64 {
        self.sum + self.lost
    }
}
