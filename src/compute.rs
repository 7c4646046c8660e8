//! Where computations run: short ones at once, long ones on a bounded pool apart from the threads that serve connections.

use std::sync::Arc;
use std::time::Duration;

use terramechanics::{Method, Operation, Sinkage};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use crate::problem::Problem;
use crate::request::IdentifyQuery;

/// What a computation costs at the worst, in nanoseconds on a machine of 2026.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(crate) struct Cost(f64);

impl Cost {
    /// Above this a computation would hold up the other requests of its thread.
    const LONGEST_AT_ONCE: Self = Self(100_000.0);

    /// Of what is there already.
    pub(crate) const NONE: Self = Self(0.0);

    /// Of `points` operating points, and of writing their rows.
    pub(crate) fn of_points(operation: &Operation, points: usize) -> Self {
        // A stiff contact makes the quadrature refine to dozens of panels; most take a fortieth of this.
        let evaluation = match operation.model.method {
            Method::Quadrature => 80_000.0,
            Method::SideSlipping(_) => 300_000.0, // two integrals, whose integrands take longer
            Method::Linearised { .. } | Method::Explicit { .. } => 200.0,
        };
        let evaluations = if matches!(operation.sinkage, Sinkage::CarryingLoad(_)) { 20.0 } else { 1.0 };
        Self(points as f64 * (evaluation * evaluations + 500.0))
    }

    /// Of one evaluation of closed forms.
    pub(crate) fn of_closed_forms() -> Self {
        Self(1_000.0)
    }

    /// Of `points` operating points by each of several methods and laws.
    pub(crate) fn of_comparison(operations: impl Iterator<Item = Operation>, points: usize) -> Self {
        Self(operations.map(|operation| Self::of_points(&operation, points).0).sum())
    }

    /// Operating points that are computed without a pause.
    pub(crate) fn points_in_a_slice(operation: &Operation) -> usize {
        const SLICE: f64 = 10e6; // 10 ms at the worst
        (SLICE / Self::of_points(operation, 1).0).max(1.0) as usize
    }

    /// Of measurements that are predicted under their load, counted by quadratures: closed forms take next to nothing.
    pub(crate) fn of_validation((straight, sideways): (usize, usize)) -> Self {
        Self(20.0 * (straight as f64 * 80_000.0 + sideways as f64 * 300_000.0))
    }

    /// Of a towed wheel, whose skid takes up to a hundred load balances (most take fifteen).
    pub(crate) fn of_towed(operation: &Operation) -> Self {
        Self::of_points(operation, 100)
    }

    /// Of an identification: a line through the samples, or a search that may spend its evaluations.
    pub(crate) fn of_identification(query: &IdentifyQuery) -> Self {
        match query {
            IdentifyQuery::Linear(query) => {
                // With a law, the quadrature a few times for each sample.
                let each = if query.law_known { 100_000.0 } else { 2_000.0 };
                Self(query.observations.slip.len() as f64 * each)
            }
            IdentifyQuery::Fit(query) => Self(query.options.evaluations as f64 * 200.0),
        }
    }

    /// Of fitting curves with `points` points in all: a shear modulus is tried a few hundred times.
    pub(crate) fn of_curves(points: usize) -> Self {
        Self(points as f64 * 10_000.0)
    }

    /// Of writing the contract, with the answer to each of its examples.
    pub(crate) fn of_contract() -> Self {
        Self(100e6)
    }

    /// Of reading a request body of `bytes`.
    pub(crate) fn of_body(bytes: usize) -> Self {
        Self(bytes as f64 * 8.0)
    }

    /// Of a profile with `points` places at one operating point.
    pub(crate) fn of_profile(operation: &Operation, points: usize) -> Self {
        let solved = if matches!(operation.sinkage, Sinkage::CarryingLoad(_)) { Self::of_points(operation, 1).0 } else { 0.0 };
        Self(solved + points as f64 * 500.0)
    }
}

/// The pool for long computations. Streams have places of their own: they are open for as long as their clients send, and
/// must not keep the others out.
#[derive(Debug, Clone)]
pub(crate) struct Pool {
    places: Arc<Semaphore>,
    stream_places: Arc<Semaphore>,
    deadline: Duration,
}

impl Pool {
    /// A pool that takes `places` computations and `stream_places` streams, waiting or running; the runtime bounds how many run
    /// at once.
    pub(crate) fn new(places: usize, stream_places: usize, deadline: Duration) -> Self {
        Self { places: Arc::new(Semaphore::new(places)), stream_places: Arc::new(Semaphore::new(stream_places)), deadline }
    }

    /// Places that are free for computations.
    pub(crate) fn free_places(&self) -> usize {
        self.places.available_permits()
    }

    /// Places that are free for streams.
    pub(crate) fn free_stream_places(&self) -> usize {
        self.stream_places.available_permits()
    }

    /// A place for a computation that goes on in slices.
    ///
    /// # Errors
    /// [`Problem::Busy`] if none is free.
    pub(crate) fn place(&self) -> Result<Place, Problem> {
        Place::of(&self.places)
    }

    /// A place for a stream.
    ///
    /// # Errors
    /// [`Problem::Busy`] if none is free.
    pub(crate) fn stream_place(&self) -> Result<Place, Problem> {
        Place::of(&self.stream_places)
    }

    /// What `work` returns, run where its cost allows.
    ///
    /// # Errors
    /// [`Problem::Busy`] if no place is free, [`Problem::Late`] if the result takes too long, [`Problem::Internal`] if the
    /// work panics, and what the work itself refuses.
    pub(crate) async fn run<T, F>(&self, cost: Cost, work: F) -> Result<T, Problem>
    where
        T: Send + 'static,
        F: FnOnce() -> Result<T, Problem> + Send + 'static,
    {
        if cost <= Cost::LONGEST_AT_ONCE {
            return work();
        }
        let place = self.place()?;
        let task = tokio::task::spawn_blocking(move || {
            let _place = place; // free again when the work is done, not when its client has gone
            work()
        });
        match tokio::time::timeout(self.deadline, task).await {
            Err(_) => Err(Problem::Late(self.deadline)),
            Ok(Err(panic)) => {
                tracing::error!(%panic, "a computation panicked");
                Err(Problem::Internal)
            }
            Ok(Ok(result)) => result,
        }
    }
}

/// A place on the pool, free again when it is dropped.
#[derive(Debug)]
pub(crate) struct Place(#[expect(dead_code, reason = "held, not read")] OwnedSemaphorePermit);

impl Place {
    fn of(places: &Arc<Semaphore>) -> Result<Self, Problem> {
        places.clone().try_acquire_owned().map(Self).map_err(|_| Problem::Busy)
    }

    /// What a slice of work returns.
    ///
    /// # Errors
    /// [`Problem::Internal`] if the work panics.
    pub(crate) async fn run<T: Send + 'static>(&self, slice: impl FnOnce() -> T + Send + 'static) -> Result<T, Problem> {
        tokio::task::spawn_blocking(slice).await.map_err(|panic| {
            tracing::error!(%panic, "a computation panicked");
            Problem::Internal
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LONG: Cost = Cost(1e9);

    fn runtime() -> tokio::runtime::Runtime {
        tokio::runtime::Builder::new_current_thread().enable_time().build().expect("a runtime")
    }

    #[test]
    fn a_full_pool_is_busy_and_frees_its_places() {
        runtime().block_on(async {
            let pool = Pool::new(1, 1, Duration::from_secs(10));
            let (release, wait) = std::sync::mpsc::channel::<()>();
            let first = {
                let pool = pool.clone();
                tokio::spawn(async move { pool.run(LONG, move || wait.recv().map_err(|_| Problem::Internal)).await })
            };
            while pool.places.available_permits() > 0 {
                tokio::task::yield_now().await;
            }
            assert_eq!(pool.run(LONG, || Ok(())).await, Err(Problem::Busy));
            assert_eq!(pool.run(Cost(1.0), || Ok(7)).await, Ok(7), "short work needs no place");
            release.send(()).expect("the first is waiting");
            assert_eq!(first.await.expect("no panic"), Ok(()));
            assert_eq!(pool.run(LONG, || Ok(())).await, Ok(()));
        });
    }

    #[test]
    fn late_work_and_panics_are_problems() {
        runtime().block_on(async {
            let pool = Pool::new(2, 1, Duration::from_millis(20));
            let late = pool.run(LONG, || {
                std::thread::sleep(Duration::from_millis(200));
                Ok(())
            });
            assert_eq!(late.await, Err(Problem::Late(Duration::from_millis(20))));
            let pool = Pool::new(2, 1, Duration::from_secs(10));
            assert_eq!(pool.run(LONG, || -> Result<(), Problem> { panic!("on purpose") }).await, Err(Problem::Internal));
            assert_eq!(pool.run(LONG, || Ok(())).await, Ok(()));
        });
    }
}
