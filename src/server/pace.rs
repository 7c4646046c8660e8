//! How fast the other side is, over the time in which it is waited for.

use std::time::Duration;

use tokio::time::Instant;

/// The slowest pace that is borne.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Slowest {
    /// Bytes a second, as a mean; 0 bears any.
    pub rate: u32,
    /// Time of waiting over which the mean is taken.
    pub window: Duration,
}

/// Bytes that moved, and the time that was waited for them. Time in which nobody waits does not count: a side that is not
/// asked cannot be late.
#[derive(Debug)]
pub(super) struct Pace {
    slowest: Slowest,
    /// Waited in this window, without the wait that goes on.
    waited: Duration,
    /// Moved in this window (bytes).
    moved: u64,
    /// Since when a wait goes on.
    since: Option<Instant>,
}

impl Pace {
    pub(super) fn new(slowest: Slowest) -> Self {
        Self { slowest, waited: Duration::ZERO, moved: 0, since: None }
    }

    /// The other side is waited for, from now on unless it was already.
    pub(super) fn wait(&mut self, now: impl FnOnce() -> Instant) {
        self.since.get_or_insert_with(now);
    }

    /// Since when the other side is waited for.
    pub(super) fn since(&self) -> Option<Instant> {
        self.since
    }

    /// The other side moved `bytes`, which ends the wait.
    pub(super) fn moved(&mut self, bytes: usize, now: impl FnOnce() -> Instant) {
        self.moved = self.moved.saturating_add(bytes as u64);
        if let Some(since) = self.since.take() {
            self.waited += now().saturating_duration_since(since);
        }
    }

    /// When the pace is to be judged, should nothing move until then.
    pub(super) fn judged_at(&self) -> Option<Instant> {
        let since = self.since.filter(|_| self.slowest.rate > 0)?;
        Some(since + self.slowest.window.saturating_sub(self.waited))
    }

    /// Whether the window is over and too little moved in it. A window that is over with enough begins anew.
    pub(super) fn is_too_slow(&mut self, now: Instant) -> bool {
        let going_on = self.since.map_or(Duration::ZERO, |since| now.saturating_duration_since(since));
        let waited = self.waited + going_on;
        if self.slowest.rate == 0 || waited < self.slowest.window {
            return false;
        }
        let is_too_slow = (self.moved as f64) < f64::from(self.slowest.rate) * waited.as_secs_f64();
        if !is_too_slow {
            (self.waited, self.moved) = (Duration::ZERO, 0);
            self.since = self.since.map(|_| now);
        }
        is_too_slow
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SLOWEST: Slowest = Slowest { rate: 10, window: Duration::from_secs(30) };

    /// The seconds after which a sender of `bytes` every `period` seconds is found too slow, within an hour.
    fn found_after(bytes: usize, period: u64) -> Option<u64> {
        let start = Instant::now();
        let mut pace = Pace::new(SLOWEST);
        for second in 0..3600 {
            let now = start + Duration::from_secs(second);
            if second > 0 && second.is_multiple_of(period) {
                pace.moved(bytes, || now);
            }
            pace.wait(|| now);
            if pace.is_too_slow(now) {
                return Some(second);
            }
        }
        None
    }

    #[test]
    fn a_mean_below_the_slowest_is_found_at_the_end_of_a_window() {
        assert_eq!(found_after(1, 25), Some(30));
        assert_eq!(found_after(9, 1), Some(30));
        assert_eq!(found_after(20, 1), None);
        assert_eq!(found_after(300, 15), None);
    }

    #[test]
    fn a_burst_pays_for_one_window_only() {
        let start = Instant::now();
        let mut pace = Pace::new(SLOWEST);
        pace.moved(1 << 20, || start);
        pace.wait(|| start);
        assert_eq!(pace.judged_at(), Some(start + SLOWEST.window));
        assert!(!pace.is_too_slow(start + SLOWEST.window));
        assert_eq!(pace.judged_at(), Some(start + 2 * SLOWEST.window));
        assert!(pace.is_too_slow(start + 2 * SLOWEST.window));
    }

    #[test]
    fn time_without_waiting_does_not_count() {
        let start = Instant::now();
        let mut pace = Pace::new(SLOWEST);
        pace.wait(|| start);
        pace.moved(1, || start + Duration::from_secs(1));
        assert!(!pace.is_too_slow(start + Duration::from_secs(3600)));
        assert_eq!(pace.judged_at(), None);
    }

    #[test]
    fn no_slowest_pace_bears_any() {
        let start = Instant::now();
        let mut pace = Pace::new(Slowest { rate: 0, ..SLOWEST });
        pace.wait(|| start);
        assert!(pace.judged_at().is_none() && !pace.is_too_slow(start + Duration::from_secs(3600)));
    }
}
