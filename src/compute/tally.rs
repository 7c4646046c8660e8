//! Counts of what the pool did, for operators.

use prometheus_client::encoding::EncodeLabelSet;
use prometheus_client::metrics::counter::Counter;
use prometheus_client::metrics::family::Family;
use prometheus_client::metrics::histogram::{Histogram, exponential_buckets};

use crate::problem::Problem;

/// Why work has no result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, EncodeLabelSet)]
pub(crate) struct Why {
    reason: &'static str,
}

/// The counts.
#[derive(Debug, Clone)]
pub(crate) struct Tally {
    /// Prices of the work that was taken (s).
    pub(crate) prices: Histogram,
    /// Work without a result.
    pub(crate) failed: Family<Why, Counter>,
}

impl Tally {
    pub(super) fn new() -> Self {
        let tally = Self { prices: Histogram::new(exponential_buckets(1e-3, 4.0, 9)), failed: Family::default() }; // 1 ms to 66 s
        for reason in ["busy", "too_costly", "overspent", "late"] {
            drop(tally.failed.get_or_create(&Why { reason }));
        }
        tally
    }

    /// Counts what became of work.
    pub(super) fn count<T>(&self, result: &Result<T, Problem>) {
        let reason = match result {
            Err(Problem::Busy(_)) => "busy",
            Err(Problem::TooCostly { spent: false, .. }) => "too_costly",
            Err(Problem::TooCostly { spent: true, .. }) => "overspent",
            Err(Problem::Late(_)) => "late",
            _ => return,
        };
        self.failed.get_or_create(&Why { reason }).inc();
    }
}
