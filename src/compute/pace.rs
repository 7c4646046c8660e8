//! How work on the pool shares the threads: it checks often, ends when nobody waits for its result any more, lets
//! others go first after a slice of time, and pays for the processor it takes.

use std::cell::{Cell, RefCell};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use rustix::time::{ClockId, clock_gettime};

use super::turns::{Turn, Turns};

/// Time after which work lets others go first. What is short waits no longer than this for a thread.
pub(crate) const SLICE: Duration = Duration::from_millis(10);

/// Number of checks between two readings of the clock, where little work lies between two checks.
const LIGHT_LOOKS: u32 = 32;

/// Time for work that nobody waits for: enough for all.
const AT_ONCE: Duration = Duration::from_secs(60);

/// Why work ends before its result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stop {
    /// Its caller has gone.
    Gone,
    /// Its deadline has passed.
    Late,
    /// It has taken twice the processor time that it was priced at.
    Overspent,
}

/// What a piece of work may take, and whether anybody still waits for it.
#[derive(Debug, Clone)]
pub(super) struct Terms {
    /// Set when the caller goes.
    pub(super) gone: Arc<AtomicBool>,
    /// Time that it is given, with the time for which it waits for others.
    pub(super) time: Duration,
    pub(super) deadline: Instant,
    /// Processor time after which it ends.
    pub(super) most: Duration,
}

/// The pace of a piece of work, on the thread that does it.
#[derive(Debug)]
pub(crate) struct Pace(Option<OnPool>);

#[derive(Debug)]
struct OnPool {
    turns: Turns,
    /// None while it waits for the next one.
    turn: RefCell<Option<Turn>>,
    terms: Terms,
    slice_end: Cell<Instant>,
    /// Processor time of the thread when the work began.
    began: Duration,
    looks: Cell<u32>,
    stop: Cell<Option<Stop>>,
}

impl Pace {
    /// The pace of work that is too short to be interrupted.
    pub(crate) const fn at_once() -> Self {
        Self(None)
    }

    /// The pace of work whose caller has gone.
    #[cfg(test)]
    pub(crate) fn of_nobody() -> Self {
        let time = AT_ONCE;
        let terms = Terms { gone: Arc::new(AtomicBool::new(true)), time, deadline: Instant::now() + time, most: time };
        Self::on_pool(&Turns::new(1), None, terms)
    }

    /// The pace of work that has its turn from now on.
    pub(super) fn of(turns: &Turns, turn: Turn, terms: Terms) -> Self {
        Self::on_pool(turns, Some(turn), terms)
    }

    fn on_pool(turns: &Turns, turn: Option<Turn>, terms: Terms) -> Self {
        Self(Some(OnPool {
            turns: turns.clone(),
            turn: RefCell::new(turn),
            terms,
            slice_end: Cell::new(Instant::now() + SLICE),
            began: processor_time(),
            looks: Cell::new(0),
            stop: Cell::new(None),
        }))
    }

    /// A check, to be made at least once in a millisecond of work.
    ///
    /// # Errors
    /// [`Stop`], now and ever after, where the work is to end.
    pub(crate) fn look(&self) -> Result<(), Stop> {
        self.0.as_ref().map_or(Ok(()), OnPool::look)
    }

    /// A check for work of some microseconds, which reading the clock each time would slow down.
    ///
    /// # Errors
    /// As [`look`](Self::look).
    pub(crate) fn glance(&self) -> Result<(), Stop> {
        let Some(work) = &self.0 else { return Ok(()) };
        let looks = work.looks.get() + 1;
        work.looks.set(looks % LIGHT_LOOKS);
        if looks < LIGHT_LOOKS { work.stop.get().map_or(Ok(()), Err) } else { work.look() }
    }

    /// Time that the work is given in all.
    pub(crate) fn time(&self) -> Duration {
        self.0.as_ref().map_or(AT_ONCE, |work| work.terms.time)
    }

    /// Whether to go on, for a search that asks.
    pub(crate) fn goes_on(&self) -> bool {
        self.look().is_ok()
    }

    /// Why the work was ended, if it was.
    pub(crate) fn stop(&self) -> Option<Stop> {
        self.0.as_ref().and_then(|work| work.stop.get())
    }
}

impl OnPool {
    fn look(&self) -> Result<(), Stop> {
        if let Some(stop) = self.stop.get() {
            return Err(stop);
        }
        if self.terms.gone.load(Ordering::Relaxed) {
            return self.end(Stop::Gone);
        }
        let now = Instant::now();
        if now < self.slice_end.get() {
            return Ok(());
        }
        if now >= self.terms.deadline {
            return self.end(Stop::Late);
        }
        if processor_time().saturating_sub(self.began) >= self.terms.most {
            return self.end(Stop::Overspent);
        }
        if self.turns.are_awaited() {
            let turn = self.turn.take().map(Turn::pass);
            self.turn.replace(turn);
        }
        self.slice_end.set(Instant::now() + SLICE);
        if self.terms.gone.load(Ordering::Relaxed) { self.end(Stop::Gone) } else { Ok(()) }
    }

    fn end(&self, stop: Stop) -> Result<(), Stop> {
        self.stop.set(Some(stop));
        Err(stop)
    }
}

/// Processor time that this thread has taken so far.
fn processor_time() -> Duration {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    Duration::try_from(time).unwrap_or_default()
}
