use super::*;
use crate::compute::SLICE;

/// Long work that may take a second.
const LONG: Cost = Cost::long(Duration::from_secs(1));
/// Short work that may take a second.
const SHORT: Cost = Cost::short(Duration::from_secs(1));

fn runtime() -> tokio::runtime::Runtime {
    tokio::runtime::Builder::new_current_thread().enable_time().build().expect("a runtime")
}

fn pool(threads: usize, places: usize, deadline: Duration) -> Pool {
    Pool::new(&PoolBounds { threads, places, stream_places: 1, deadline, price_limit: Duration::from_secs(60) })
}

const PATIENCE: Duration = Duration::from_secs(10);

/// Works for as long as it may.
fn spin(pace: &Pace) -> Result<(), Problem> {
    loop {
        pace.look()?;
    }
}

async fn until(condition: impl Fn() -> bool) {
    let start = Instant::now();
    while !condition() {
        assert!(start.elapsed() < PATIENCE, "it never comes about");
        tokio::time::sleep(Duration::from_millis(1)).await;
    }
}

#[test]
fn a_full_pool_is_busy_and_frees_its_places() {
    runtime().block_on(async {
        let pool = pool(1, 1, PATIENCE);
        let (release, wait) = std::sync::mpsc::channel::<()>();
        let first = {
            let pool = pool.clone();
            tokio::spawn(async move { pool.run(LONG, move |_| wait.recv().map_err(|_| Problem::Internal)).await })
        };
        until(|| pool.free_places() == 0).await;
        assert_eq!(pool.run(LONG, |_| Ok(())).await, Err(Problem::Busy(LONG.usual())));
        assert_eq!(pool.run(Cost::NONE, |_| Ok(7)).await, Ok(7), "what costs nothing needs no place");
        release.send(()).expect("the first is waiting");
        assert_eq!(first.await.expect("no panic"), Ok(()));
        assert_eq!(pool.run(LONG, |_| Ok(())).await, Ok(()));
    });
}

#[test]
fn late_work_ends_and_panics_are_problems() {
    runtime().block_on(async {
        let limit = Duration::from_millis(30);
        let hasty = pool(2, 1, limit);
        assert_eq!(hasty.run(LONG, spin).await, Err(Problem::Late(limit)));
        until(|| hasty.free_places() == 1).await;
        let pool = pool(2, 1, PATIENCE);
        assert_eq!(pool.run(LONG, |_| -> Result<(), Problem> { panic!("on purpose") }).await, Err(Problem::Internal));
        assert_eq!(pool.run(LONG, |_| Ok(())).await, Ok(()));
    });
}

#[test]
fn work_ends_when_its_caller_goes() {
    runtime().block_on(async {
        let pool = pool(1, 1, PATIENCE);
        let caller = {
            let pool = pool.clone();
            tokio::spawn(async move { pool.run(LONG, spin).await })
        };
        until(|| pool.free_places() == 0).await;
        caller.abort();
        until(|| pool.free_places() == 1).await;
    });
}

#[test]
fn work_ends_at_twice_its_price() {
    runtime().block_on(async {
        let price = Duration::from_millis(50);
        let spent = Problem::TooCostly { price, limit: Duration::from_secs(60), spent: true };
        let began = Instant::now();
        assert_eq!(pool(1, 1, PATIENCE).run(Cost::long(price), spin).await, Err(spent));
        assert!(began.elapsed() >= price * OVERDRAFT, "it may take what it is priced at");
        let price = Duration::from_secs(61);
        let refused = Problem::TooCostly { price, limit: Duration::from_secs(60), spent: false };
        assert_eq!(pool(1, 1, PATIENCE).run(Cost::long(price), |_| Ok(())).await, Err(refused));
    });
}

#[test]
fn short_work_overtakes_long_work_that_runs() {
    runtime().block_on(async {
        let pool = pool(1, 8, PATIENCE);
        let greedy: Vec<_> = (0..8)
            .map(|_| {
                let pool = pool.clone();
                tokio::spawn(async move { pool.run(Cost::long(PATIENCE), spin).await })
            })
            .collect();
        until(|| pool.free_places() == 0).await;
        for _ in 0..20 {
            assert_eq!(pool.run(SHORT, |_| Ok(7)).await, Ok(7));
        }
        greedy.iter().for_each(tokio::task::JoinHandle::abort);
        until(|| pool.free_places() == 8).await;
    });
}

#[test]
fn long_works_share_the_thread() {
    runtime().block_on(async {
        let pool = pool(1, 2, PATIENCE);
        // Each needs the other to get on: neither may hold the thread for good.
        let count = Arc::new(std::sync::atomic::AtomicU32::new(0));
        let one = |mine: u32| {
            let (pool, count) = (pool.clone(), count.clone());
            tokio::spawn(async move {
                let work = move |pace: &Pace| loop {
                    pace.look()?;
                    let now = count.load(Ordering::Relaxed);
                    if now >= 10 {
                        return Ok(());
                    }
                    if now % 2 == mine {
                        count.store(now + 1, Ordering::Relaxed);
                    }
                };
                pool.run(Cost::long(PATIENCE), work).await
            })
        };
        let began = Instant::now();
        let (even, odd) = (one(0), one(1));
        assert_eq!((even.await.expect("no panic"), odd.await.expect("no panic")), (Ok(()), Ok(())));
        assert!(began.elapsed() >= 9 * SLICE, "they went by turns");
    });
}
