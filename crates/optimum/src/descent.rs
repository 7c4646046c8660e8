//! The search from one start: Powell's COBYLA (1994), which needs no derivatives and treats every limit by itself.
//!
//! COBYLA expects numbers everywhere. Where the function has no answer, it gets those of the best point so far, and one more
//! limit that is missed by the distance from there: the way back is the way out.

use std::cell::{Cell, RefCell};

use cobyla::{FailStatus, Func, RhoBeg, StopTols, SuccessStatus, minimize};

use crate::aim::Aim;
use crate::archive::Seen;
use crate::ledger::{Ended, Ledger};

/// Why a search ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopReason {
    /// Its steps became a hundred-millionth of the bounds, and another search from there found nothing better.
    SmallStep,
    /// Its evaluations were spent.
    Evaluations,
    /// Rounding keeps it from a better point.
    Rounding,
}

impl StopReason {
    /// Whether the search ended by itself.
    #[must_use]
    pub fn is_converged(self) -> bool {
        matches!(self, Self::SmallStep | Self::Rounding)
    }
}

/// Where a search led.
#[derive(Debug, Clone)]
pub(crate) struct Descent {
    pub(crate) start: Seen,
    pub(crate) best: Seen,
    pub(crate) stop: StopReason,
}

/// The first step, and the first of each search that follows from where the one before has ended. Without a second one, COBYLA now
/// and then ends on a simplex that is flat.
const FIRST_STEPS: [f64; 5] = [0.1, 0.02, 0.1, 0.005, 0.05];

/// The step at which a search ends.
const LAST_STEP: f64 = 1e-8;

/// Gain that is none: by the scale of the goal, or of a limit.
const NO_GAIN: f64 = 1e-9;

/// Largest number that COBYLA is told: it squares and multiplies them.
const LARGEST: f64 = 1e12;

/// Follows the function from `start` to a point from which no step is better, with so many evaluations at most.
pub(crate) fn descend(ledger: &Ledger<'_>, aim: &Aim, start: Seen, most: u32) -> Descent {
    let (mut best, mut left) = (start.clone(), most);
    let mut stop = StopReason::Evaluations;
    for first_step in FIRST_STEPS {
        let before = ledger.spent();
        let round = Round::new(ledger, aim, best.clone());
        stop = round.run(first_step, left);
        left = left.saturating_sub(ledger.spent() - before);
        let reached = round.best.into_inner();
        let is_gain = aim.is_kept(&reached) != aim.is_kept(&best) || aim.rank(&best) - aim.rank(&reached) > NO_GAIN;
        best = reached;
        let is_second = first_step != FIRST_STEPS[0];
        if stop == StopReason::Evaluations || (is_second && !is_gain) {
            break;
        }
    }
    Descent { start, best, stop }
}

/// One run of COBYLA.
struct Round<'a, 'l> {
    ledger: &'a Ledger<'l>,
    aim: &'a Aim,
    /// The aim by the scales around the start.
    near: Aim,
    /// Whether the start misses a limit. Then the goal counts for nothing: the first thing is to keep them.
    is_astray: bool,
    /// The best point so far.
    best: RefCell<Seen>,
    /// The last point, and what COBYLA is told of it: it asks for the goal and for each limit apart.
    last: RefCell<(Vec<f64>, Told)>,
    has_ended: Cell<bool>,
}

/// What COBYLA is told of a point.
#[derive(Debug, Clone, Default)]
struct Told {
    objective: f64,
    /// The last is that of the point having an answer.
    margins: Vec<f64>,
}

impl<'a, 'l> Round<'a, 'l> {
    fn new(ledger: &'a Ledger<'l>, aim: &'a Aim, start: Seen) -> Self {
        let near = aim.near(&start, &ledger.archive());
        let is_astray = !aim.is_kept(&start);
        let last = RefCell::new((start.shares.clone(), told(&near, &start, 0.0)));
        Self { ledger, aim, near, is_astray, best: RefCell::new(start), last, has_ended: Cell::new(false) }
    }

    fn run(&self, first_step: f64, most: u32) -> StopReason {
        let start = self.best.borrow().shares.clone();
        let objective = |shares: &[f64], (): &mut ()| {
            let objective = self.told(shares, |told| told.objective);
            if self.is_astray { 0.0 } else { objective }
        };
        let limits =
            (0..=self.aim.limits.len()).map(|i| move |shares: &[f64], (): &mut ()| self.told(shares, |told| told.margins[i]));
        let limits: Vec<_> = limits.collect();
        let limits: Vec<&dyn Func<()>> = limits.iter().map(|limit| limit as &dyn Func<()>).collect();
        let bounds = vec![(0.0, 1.0); start.len()];
        let stop_at = StopTols { xtol_abs: vec![LAST_STEP; start.len()], ..StopTols::default() };
        if most == 0 {
            return StopReason::Evaluations;
        }
        let ended = minimize(objective, &start, &bounds, &limits, (), most as usize, RhoBeg::All(first_step), Some(stop_at));
        match ended {
            _ if self.has_ended.get() => StopReason::Evaluations,
            Ok((SuccessStatus::MaxEvalReached | SuccessStatus::MaxTimeReached, ..)) => StopReason::Evaluations,
            Ok((SuccessStatus::Success | SuccessStatus::StopValReached, ..)) => StopReason::SmallStep,
            Ok((SuccessStatus::FtolReached | SuccessStatus::XtolReached, ..)) => StopReason::SmallStep,
            Err((FailStatus::RoundoffLimited, ..)) => StopReason::Rounding,
            Err(_) => StopReason::Rounding,
        }
    }

    /// Something of what COBYLA is told of these shares.
    fn told(&self, shares: &[f64], part: impl Fn(&Told) -> f64) -> f64 {
        if self.last.borrow().0 != shares {
            let told = self.look(shares);
            self.last.replace((shares.to_vec(), told));
        }
        part(&self.last.borrow().1)
    }

    fn look(&self, shares: &[f64]) -> Told {
        let mut best = self.best.borrow_mut();
        if self.has_ended.get() {
            return told(&self.near, &best, 0.0); // until COBYLA has spent its own count
        }
        match self.ledger.at(shares) {
            Ok(Some(seen)) => {
                let told = told(&self.near, &seen, 0.0);
                if self.aim.is_better(&seen, &best) {
                    *best = seen;
                }
                told
            }
            Ok(None) => told(&self.near, &best, best.distance(shares)),
            Err(Ended::Budget | Ended::Stopped) => {
                self.has_ended.set(true);
                told(&self.near, &best, 0.0)
            }
        }
    }
}

fn told(aim: &Aim, seen: &Seen, beyond: f64) -> Told {
    let bounded = |number: f64| number.clamp(-LARGEST, LARGEST);
    Told { objective: bounded(aim.objective(seen)), margins: aim.margins(seen).chain([-beyond]).map(bounded).collect() }
}
