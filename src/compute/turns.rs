//! Who computes next: as many turns as there are threads to compute, short work before long, each kind in the order it came.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::sync::oneshot::{self, Receiver, Sender};

/// How long a piece of work usually takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    /// Less than a slice; such work goes before all long work.
    Short,
    /// Slices, between which it lets others go first.
    Long,
}

/// The turns.
#[derive(Debug, Clone)]
pub(super) struct Turns(Arc<Mutex<State>>);

#[derive(Debug)]
struct State {
    free: usize,
    short: VecDeque<Sender<Turn>>,
    long: VecDeque<Sender<Turn>>,
}

/// A turn to compute; the next in line has it when this one is dropped.
#[derive(Debug)]
pub(super) struct Turn {
    turns: Turns,
    /// Whether it was handed on already.
    spent: bool,
}

impl Turns {
    pub(super) fn new(count: usize) -> Self {
        Self(Arc::new(Mutex::new(State { free: count, short: VecDeque::new(), long: VecDeque::new() })))
    }

    /// A turn, when it is this caller's.
    pub(super) async fn turn(&self, class: Class) -> Turn {
        let waiting = match self.claim(class) {
            Ok(turn) => return turn,
            Err(waiting) => waiting,
        };
        // A sender is dropped unsent only with all the turns.
        waiting.await.unwrap_or_else(|_| Turn { turns: self.clone(), spent: true })
    }

    /// Whether somebody waits.
    pub(super) fn are_awaited(&self) -> bool {
        let state = self.lock();
        !state.short.is_empty() || !state.long.is_empty()
    }

    /// How much short and how much long work waits for a turn.
    pub(super) fn waiting(&self) -> [usize; 2] {
        let state = self.lock();
        [state.short.len(), state.long.len()]
    }

    fn claim(&self, class: Class) -> Result<Turn, Receiver<Turn>> {
        let mut state = self.lock();
        if state.free > 0 {
            state.free -= 1;
            return Ok(Turn { turns: self.clone(), spent: false });
        }
        let (sender, receiver) = oneshot::channel();
        match class {
            Class::Short => state.short.push_back(sender),
            Class::Long => state.long.push_back(sender),
        }
        Err(receiver)
    }

    /// Gives a turn to the next in line that still waits.
    fn hand_on(&self) {
        loop {
            let next = {
                let mut state = self.lock();
                let next = state.short.pop_front().or_else(|| state.long.pop_front());
                if next.is_none() {
                    state.free += 1;
                }
                next
            };
            let Some(next) = next else { return };
            match next.send(Turn { turns: self.clone(), spent: false }) {
                Ok(()) => return,
                // It has gone. Its turn must not hand itself on, or the loop would nest.
                Err(mut turn) => turn.spent = true,
            }
        }
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        // Nothing panics while it is held, and a count or a queue is whole at any moment.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Turn {
    /// Lets everyone who waits go first, and waits on this thread for a turn of long work.
    pub(super) fn pass(self) -> Self {
        let turns = self.turns.clone();
        let (sender, waiting) = oneshot::channel();
        turns.lock().long.push_back(sender);
        drop(self);
        waiting.blocking_recv().unwrap_or(Self { turns, spent: true })
    }
}

impl Drop for Turn {
    fn drop(&mut self) {
        if !self.spent {
            self.spent = true;
            self.turns.hand_on();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn runtime() -> tokio::runtime::Runtime {
        tokio::runtime::Builder::new_current_thread().build().expect("a runtime")
    }

    #[test]
    fn short_work_goes_before_long_work_that_came_earlier() {
        runtime().block_on(async {
            let turns = Turns::new(1);
            let held = turns.turn(Class::Long).await;
            let order = Arc::new(Mutex::new(Vec::new()));
            let mut tasks = Vec::new();
            for (name, class) in [("long", Class::Long), ("later", Class::Long), ("short", Class::Short)] {
                let (turns, order) = (turns.clone(), order.clone());
                tasks.push(tokio::spawn(async move {
                    let _turn = turns.turn(class).await;
                    order.lock().expect("unpoisoned").push(name);
                }));
                tokio::task::yield_now().await;
            }
            drop(held);
            for task in tasks {
                task.await.expect("no panic");
            }
            assert_eq!(*order.lock().expect("unpoisoned"), ["short", "long", "later"]);
        });
    }

    #[test]
    fn a_turn_of_one_who_has_gone_is_the_next_ones() {
        runtime().block_on(async {
            let turns = Turns::new(1);
            let held = turns.turn(Class::Short).await;
            let gone: Vec<_> = (0..1000).map(|_| turns.claim(Class::Short).expect_err("none is free")).collect();
            drop(gone);
            let waiting = turns.claim(Class::Long).expect_err("none is free");
            drop(held);
            drop(waiting.await.expect("the next in line"));
            assert!(!turns.are_awaited() && turns.lock().free == 1);
        });
    }

    #[test]
    fn a_turn_that_is_passed_comes_back_after_the_others() {
        let turns = Turns::new(1);
        let held = turns.claim(Class::Long).expect("a free turn");
        let mut waiting = turns.claim(Class::Long).expect_err("none is free");
        let passing = std::thread::spawn(move || drop(held.pass()));
        let theirs = loop {
            match waiting.try_recv() {
                Ok(turn) => break turn,
                Err(_) => std::thread::yield_now(),
            }
        };
        assert!(!passing.is_finished(), "it waits behind the one that has the turn");
        drop(theirs);
        passing.join().expect("no panic");
        assert_eq!(turns.lock().free, 1);
    }
}
