//! The pool: threads for work that would hold up the other requests of a connection's thread for too long.
//!
//! Work on the pool has a place (so many may run or wait), takes turns with the rest ([`Pace`]) and ends when it is done, its
//! caller has gone, its deadline has passed or it has taken twice its price.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use super::cost::Cost;
use super::pace::{Pace, Stop, Terms};
use super::tally::Tally;
use super::turns::{Class, Turns};
use crate::problem::Problem;

/// How many times its price work may cost.
pub(crate) const OVERDRAFT: u32 = 2;

/// Places for short work, for each place for long work: they take next to no memory and are soon free again.
const SHORT_PLACES: usize = 4;

/// Bounds of the pool.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PoolBounds {
    /// Computations that run at once.
    pub(crate) threads: usize,
    /// Long computations that may run or wait.
    pub(crate) places: usize,
    /// Streams that may be open.
    pub(crate) stream_places: usize,
    /// Time in which a computation has to end.
    pub(crate) deadline: Duration,
    /// Highest price of one computation (processor time).
    pub(crate) price_limit: Duration,
}

impl PoolBounds {
    /// Threads of the runtime that the pool may hold at once: a computation that waits for its next turn keeps its own.
    pub(crate) fn blocking_threads(&self) -> usize {
        self.places * (1 + SHORT_PLACES) + self.threads
    }
}

/// The pool. Streams have places of their own: they are open for as long as their clients send, and must not keep the others
/// out; and so has short work, which long work must not keep out.
#[derive(Debug, Clone)]
pub(crate) struct Pool {
    turns: Turns,
    places: Arc<Semaphore>,
    short_places: Arc<Semaphore>,
    stream_places: Arc<Semaphore>,
    /// What the work that has a place usually takes (microseconds of processor time).
    ahead: Arc<AtomicU64>,
    tally: Tally,
    threads: usize,
    deadline: Duration,
    price_limit: Duration,
}

impl Pool {
    pub(crate) fn new(bounds: &PoolBounds) -> Self {
        let places = |count: usize| Arc::new(Semaphore::new(count));
        Self {
            turns: Turns::new(bounds.threads),
            places: places(bounds.places),
            short_places: places(bounds.places * SHORT_PLACES),
            stream_places: places(bounds.stream_places),
            ahead: Arc::default(),
            tally: Tally::new(),
            threads: bounds.threads,
            deadline: bounds.deadline,
            price_limit: bounds.price_limit,
        }
    }

    /// Places that are free for long computations.
    pub(crate) fn free_places(&self) -> usize {
        self.places.available_permits()
    }

    /// Places that are free for streams.
    pub(crate) fn free_stream_places(&self) -> usize {
        self.stream_places.available_permits()
    }

    /// How much short and how much long work waits for a thread.
    pub(crate) fn waiting(&self) -> [usize; 2] {
        self.turns.waiting()
    }

    /// What was counted.
    pub(crate) fn tally(&self) -> &Tally {
        &self.tally
    }

    /// A place for a computation that goes on in slices.
    ///
    /// # Errors
    /// [`Problem::Busy`] if none is free.
    pub(crate) fn place(&self) -> Result<Place, Problem> {
        self.counted(self.place_among(&self.places, Cost::NONE))
    }

    /// A place for a stream.
    ///
    /// # Errors
    /// [`Problem::Busy`] if none is free.
    pub(crate) fn stream_place(&self) -> Result<Place, Problem> {
        self.counted(self.place_among(&self.stream_places, Cost::NONE))
    }

    fn counted<T>(&self, result: Result<T, Problem>) -> Result<T, Problem> {
        self.tally.count(&result);
        result
    }

    fn place_among(&self, places: &Arc<Semaphore>, cost: Cost) -> Result<Place, Problem> {
        let permit = places.clone().try_acquire_owned().map_err(|_| Problem::Busy(self.time_ahead()))?;
        let usual = cost.usual().as_micros() as u64;
        self.ahead.fetch_add(usual, Ordering::Relaxed);
        Ok(Place { _permit: permit, turns: self.turns.clone(), usual, ahead: self.ahead.clone() })
    }

    /// The time that the work with a place usually takes from here, if it has only begun; no work takes longer than its deadline.
    fn time_ahead(&self) -> Duration {
        let ahead = Duration::from_micros(self.ahead.load(Ordering::Relaxed));
        (ahead / u32::try_from(self.threads.max(1)).unwrap_or(u32::MAX)).min(self.deadline)
    }

    /// A place for a stream of this cost, which may last for so long.
    ///
    /// # Errors
    /// [`Problem::TooCostly`] where its price is higher; [`Problem::Busy`] if none is free.
    pub(crate) fn stream_place_for(&self, cost: Cost, longest: Duration) -> Result<Place, Problem> {
        let price = cost.price();
        if price > longest {
            return self.counted(Err(Problem::TooCostly { price, limit: longest, spent: false }));
        }
        self.stream_place()
    }

    /// Runs `work` where its cost allows and returns its result. The work has to check its pace often.
    ///
    /// # Errors
    /// [`Problem::TooCostly`] for a price above the limit, and where the work took far more than its price; [`Problem::Busy`] if
    /// no place is free, [`Problem::Late`] if the result takes too long, [`Problem::Internal`] if the work panics, and what the
    /// work itself refuses.
    pub(crate) async fn run<T, F>(&self, cost: Cost, work: F) -> Result<T, Problem>
    where
        T: Send + 'static,
        F: FnOnce(&Pace) -> Result<T, Problem> + Send + 'static,
    {
        if cost.is_next_to_nothing() {
            return work(&Pace::at_once());
        }
        self.counted(self.run_on_a_thread(cost, work).await)
    }

    async fn run_on_a_thread<T, F>(&self, cost: Cost, work: F) -> Result<T, Problem>
    where
        T: Send + 'static,
        F: FnOnce(&Pace) -> Result<T, Problem> + Send + 'static,
    {
        let price = cost.price();
        if price > self.price_limit {
            return Err(Problem::TooCostly { price, limit: self.price_limit, spent: false });
        }
        let class = if cost.is_short() { Class::Short } else { Class::Long };
        let places = if class == Class::Short { &self.short_places } else { &self.places };
        let place = self.place_among(places, cost)?;
        self.tally.prices.observe(price.as_secs_f64());
        let caller = Caller::default();
        let terms = Terms {
            gone: caller.0.clone(),
            time: self.deadline,
            deadline: Instant::now() + self.deadline,
            most: price * OVERDRAFT,
        };
        let turns = self.turns.clone();
        let computed = async {
            let turn = turns.turn(class).await;
            let turns = turns.clone();
            let task = tokio::task::spawn_blocking(move || {
                let pace = Pace::of(&turns, turn, terms);
                let result = work(&pace);
                drop(place); // free again when the work is done, not when its client has gone
                (result, pace.stop())
            });
            task.await
        };
        match tokio::time::timeout(self.deadline, computed).await {
            Err(_) | Ok(Ok((_, Some(Stop::Late | Stop::Gone)))) => Err(Problem::Late(self.deadline)),
            Ok(Ok((_, Some(Stop::Overspent)))) => Err(Problem::TooCostly { price, limit: self.price_limit, spent: true }),
            Ok(Ok((result, None))) => result,
            Ok(Err(panic)) => Err(panicked(&panic)),
        }
    }
}

/// The caller of a piece of work. Its future is dropped when the client goes or the deadline passes, and this with it.
#[derive(Debug, Default)]
struct Caller(Arc<AtomicBool>);

impl Drop for Caller {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// A place on the pool, free again when it is dropped.
#[derive(Debug)]
pub(crate) struct Place {
    _permit: OwnedSemaphorePermit,
    turns: Turns,
    usual: u64,
    ahead: Arc<AtomicU64>,
}

impl Drop for Place {
    fn drop(&mut self) {
        self.ahead.fetch_sub(self.usual, Ordering::Relaxed);
    }
}

impl Place {
    /// What a slice of work returns. It ends by itself, after about [`SLICE`](super::SLICE).
    ///
    /// # Errors
    /// [`Problem::Internal`] if the work panics.
    pub(crate) async fn run<T: Send + 'static>(&self, slice: impl FnOnce() -> T + Send + 'static) -> Result<T, Problem> {
        let turn = self.turns.turn(Class::Long).await;
        let task = tokio::task::spawn_blocking(move || {
            let _turn = turn;
            slice()
        });
        task.await.map_err(|panic| panicked(&panic))
    }
}

fn panicked(panic: &tokio::task::JoinError) -> Problem {
    tracing::error!(%panic, "a computation panicked");
    Problem::Internal
}

#[cfg(test)]
mod tests;
