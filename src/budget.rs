//! Memory that all connections share out, so that many large texts at a time do not add up.

use std::sync::Arc;

use tokio::sync::{OwnedSemaphorePermit, Semaphore};

/// What one permit stands for (bytes).
const UNIT: usize = 1 << 10;

/// A bound on the memory of one kind of text.
#[derive(Debug, Clone)]
pub(crate) struct Budget {
    free: Arc<Semaphore>,
    units: usize,
}

/// A share of a budget, given back when it is dropped.
#[derive(Debug)]
pub(crate) struct Share(OwnedSemaphorePermit);

impl Budget {
    pub(crate) fn new(bytes: usize) -> Self {
        let units = (bytes / UNIT).clamp(1, u32::MAX as usize);
        Self { free: Arc::new(Semaphore::new(units)), units }
    }

    /// Bytes that are free.
    pub(crate) fn free(&self) -> usize {
        self.free.available_permits() * UNIT
    }

    /// A share for `bytes`, if it is free. What is larger than the whole budget takes all of it.
    pub(crate) fn share(&self, bytes: usize) -> Option<Share> {
        self.free.clone().try_acquire_many_owned(self.units_for(bytes)).ok().map(Share)
    }

    /// A share for `bytes` once it is free, in the order of asking.
    pub(crate) async fn share_when_free(&self, bytes: usize) -> Share {
        match self.free.clone().acquire_many_owned(self.units_for(bytes)).await {
            Ok(permit) => Share(permit),
            // Only a semaphore that was closed refuses, and this one never is.
            Err(_) => std::future::pending().await,
        }
    }

    fn units_for(&self, bytes: usize) -> u32 {
        u32::try_from(bytes.div_ceil(UNIT).min(self.units)).unwrap_or(u32::MAX)
    }
}

impl Share {
    /// Adds another share of the same budget.
    pub(crate) fn join(&mut self, other: Self) {
        self.0.merge(other.0);
    }

    /// Part of this share, for `bytes` or what is left of them; none where nothing is left.
    pub(crate) fn split(&mut self, bytes: usize) -> Option<Self> {
        let units = bytes.div_ceil(UNIT).min(self.0.num_permits());
        if units == 0 { None } else { self.0.split(units).map(Self) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_taken_comes_back() {
        let budget = Budget::new(10 << 10);
        let mut one = budget.share(4000).expect("4 of 10");
        assert!(budget.share(7000).is_none());
        let other = budget.share(6000).expect("6 of 6");
        assert_eq!(budget.free(), 0);
        drop(one.split(3000));
        assert_eq!(budget.free(), 3 << 10);
        let rest = one.split(3000);
        assert!(rest.is_some() && one.split(1).is_none(), "one of four was left");
        drop((rest, other));
        assert_eq!(budget.free(), 10 << 10);
    }

    #[test]
    fn what_is_too_large_takes_all() {
        let budget = Budget::new(10 << 10);
        let all = budget.share(1 << 20).expect("all");
        assert!(budget.share(1).is_none());
        drop(all);
        assert!(budget.share(1).is_some());
    }
}
