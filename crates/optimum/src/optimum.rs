//! The best point of a task.

use crate::aim::Aim;
use crate::archive::Seen;
use crate::descent::{Descent, StopReason};
use crate::ledger::{Function, Ledger, Stopped};
use crate::search::{best_of, given_start, searches, survey};
use crate::starts;
use crate::task::{Goal, Limit, Sense, Side, Task};

/// What came of a task.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome<T> {
    /// What was sought.
    Found(T),
    /// No point that was tried keeps all limits.
    Infeasible(Infeasible),
    /// The function has no answer at any point that was tried.
    NoAnswer {
        /// How many were tried.
        evaluations: u32,
    },
}

/// An end of a variable's range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// The lower one.
    From,
    /// The upper one.
    To,
}

/// A variable that lies at its bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BoundHit {
    /// The variable, by its place.
    pub variable: usize,
    /// The bound.
    pub bound: Bound,
}

/// The best point that keeps all limits.
#[derive(Debug, Clone, PartialEq)]
pub struct Optimum {
    /// The variables.
    pub values: Vec<f64>,
    /// The outputs there.
    pub outputs: Vec<f64>,
    /// How far each limit is kept, in its own unit.
    pub margins: Vec<f64>,
    /// The limits, by their places, that keep the goal from a better value: kept by less than a ten-thousandth.
    pub active: Vec<usize>,
    /// What each active limit costs; of some it is not known, where the evaluations did not suffice.
    pub loosened: Vec<Loosened>,
    /// The variables at a bound, to a ten-thousandth of the range.
    pub at_bounds: Vec<BoundHit>,
    /// The variables where the search began that found it.
    pub found_from: Vec<f64>,
    /// The place of that search.
    pub search: usize,
    /// How many searches were made.
    pub searches: usize,
    /// How many of them found as good a value, to a ten-thousandth of its spread over the bounds.
    pub agreed: usize,
    /// The least and the largest value of each variable among these: a wide range tells that many points are as good.
    pub agreed_ranges: Vec<(f64, f64)>,
    /// How often the function was evaluated.
    pub evaluations: u32,
    /// How often it had no answer.
    pub unanswered: u32,
    /// Why the search ended.
    pub stop: StopReason,
}

/// What a limit costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loosened {
    /// The limit, by its place.
    pub limit: usize,
    /// The goal where the limit is looser by a hundredth of its value; of a limit of zero, by a hundredth of its output's spread.
    pub goal: f64,
}

/// A limit that is missed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Missed {
    /// The limit, by its place.
    pub limit: usize,
    /// By how much, in its own unit.
    pub by: f64,
    /// The output that came nearest to keeping it, or keeps it best, wherever it was sought, whatever the other limits.
    pub best: f64,
    /// Whether it is kept there: then only the other limits forbid it.
    pub is_kept_alone: bool,
}

/// The point that misses the limits least, each by the spread of its output.
#[derive(Debug, Clone, PartialEq)]
pub struct Infeasible {
    /// The variables.
    pub values: Vec<f64>,
    /// The outputs there.
    pub outputs: Vec<f64>,
    /// The limits that are missed there.
    pub missed: Vec<Missed>,
    /// The variables at a bound, to a ten-thousandth of the range.
    pub at_bounds: Vec<BoundHit>,
    /// How often the function was evaluated.
    pub evaluations: u32,
    /// How often it had no answer.
    pub unanswered: u32,
    /// Why the search ended.
    pub stop: StopReason,
}

/// Share of a limit by which it is kept and still counts as active, and share of a range at which a bound does.
const ACTIVE: f64 = 1e-4;

/// Share of the spread of the goal by which searches may differ and still agree.
const AGREED: f64 = 1e-4;

/// By how much a limit is loosened to see what it costs.
const LOOSER: f64 = 0.01;

/// Share of the evaluations that is kept for asking of each limit whether it can be kept at all: one in so many.
const SHARE_OF_LIMITS: u32 = 4;

/// The best point of `task` for `function`.
///
/// # Errors
/// That the function said [`Refusal::Stop`](crate::Refusal::Stop).
///
/// ```
/// use terramechanics_optimum::{Goal, Limit, Outcome, Sense, Side, Spacing, Task, TaskParams, Variable, optimum};
///
/// // The smallest x + y where x y is at least 4.
/// let side = Variable { from: 0.1, to: 100.0, start: None, spacing: Spacing::Logarithmic };
/// let task = Task::new(TaskParams {
///     variables: vec![side, side],
///     outputs: 2,
///     goal: Goal { output: 0, sense: Sense::Minimise },
///     limits: vec![Limit { output: 1, side: Side::AtLeast, value: 4.0 }],
///     starts: 4,
///     seed: 1,
///     evaluations: 2000,
/// })?;
/// let found = optimum(&task, &mut |x| Ok(vec![x[0] + x[1], x[0] * x[1]]))?;
/// let Outcome::Found(best) = found else { panic!("{found:?}") };
/// assert!((best.values[0] - 2.0).abs() < 1e-3 && (best.outputs[0] - 4.0).abs() < 1e-6);
/// assert_eq!(best.active, [0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn optimum(task: &Task, function: &mut Function<'_>) -> Result<Outcome<Optimum>, Stopped> {
    let ledger = Ledger::new(task, function);
    let params = task.params();
    survey(&ledger);
    let aim = Aim::new(params.goal, params.limits.clone(), &ledger.archive());
    let reserve = if params.limits.is_empty() { 0 } else { ledger.left() / SHARE_OF_LIMITS };
    let mut found = searches(&ledger, &aim, given_start(&ledger), params.starts, ledger.left() - reserve);
    ledger.goes_on()?;
    let Some(place) = best_of(&aim, &found) else { return Ok(Outcome::NoAnswer { evaluations: ledger.spent() }) };
    if !aim.is_kept(&found[place].best) {
        return infeasible(&ledger, &aim, &found[place].best, found[place].stop).map(Outcome::Infeasible);
    }
    if found[place].stop == StopReason::Evaluations && ledger.left() > 0 {
        let further = searches(&ledger, &aim, vec![found[place].best.clone()], 1, ledger.left());
        let start = found[place].start.clone();
        found.extend(further.into_iter().map(|further| Descent { start: start.clone(), ..further }));
        found.swap_remove(place);
        ledger.goes_on()?;
    }
    let place = best_of(&aim, &found).unwrap_or(place);
    let loosened = loosened(&ledger, &aim, &found[place].best)?;
    Ok(Outcome::Found(Optimum { loosened, evaluations: ledger.spent(), ..described(&ledger, &aim, &found, place) }))
}

/// What each active limit costs.
fn loosened(ledger: &Ledger<'_>, aim: &Aim, best: &Seen) -> Result<Vec<Loosened>, Stopped> {
    let active: Vec<usize> = (0..aim.limits.len()).filter(|&i| aim.is_active(i, best, ACTIVE)).collect();
    let mut told = Vec::with_capacity(active.len());
    for (done, &i) in active.iter().enumerate() {
        let looser = Aim::new(aim.goal, aim.loosened(i, LOOSER), &ledger.archive());
        let share = ledger.left() / (active.len() - done) as u32;
        let found = searches(ledger, &looser, vec![best.clone()], 1, share);
        ledger.goes_on()?;
        if let Some(found) = found.first().filter(|found| found.stop.is_converged()) {
            told.push(Loosened { limit: i, goal: found.best.outputs[aim.goal.output] });
        }
    }
    Ok(told)
}

/// The best of some searches, with what is to be said of it.
fn described(ledger: &Ledger<'_>, aim: &Aim, found: &[Descent], place: usize) -> Optimum {
    let Descent { start, best, stop } = &found[place];
    let agree = |other: &&Descent| aim.is_kept(&other.best) && aim.objective(&other.best) - aim.objective(best) <= AGREED;
    let agreed: Vec<Vec<f64>> = found.iter().filter(agree).map(|other| ledger.values(&other.best.shares)).collect();
    let values = ledger.values(&best.shares);
    let range = |i: usize| agreed.iter().fold((values[i], values[i]), |(least, most), at| (least.min(at[i]), most.max(at[i])));
    Optimum {
        margins: margins(aim, best).collect(),
        active: (0..aim.limits.len()).filter(|&i| aim.is_active(i, best, ACTIVE)).collect(),
        loosened: Vec::new(),
        at_bounds: at_bounds(best),
        found_from: ledger.values(&start.shares),
        search: place,
        searches: found.len(),
        agreed: agreed.len(),
        agreed_ranges: (0..values.len()).map(range).collect(),
        evaluations: ledger.spent(),
        unanswered: ledger.unanswered(),
        stop: *stop,
        outputs: best.outputs.clone(),
        values,
    }
}

/// How far each limit is kept, in its own unit.
fn margins<'a>(aim: &'a Aim, seen: &'a Seen) -> impl Iterator<Item = f64> + 'a {
    aim.limits.iter().map(|limit| limit.margin(seen.outputs[limit.output]))
}

fn at_bounds(seen: &Seen) -> Vec<BoundHit> {
    let hit = |(variable, &share): (usize, &f64)| {
        let bound = match share {
            share if share <= ACTIVE => Bound::From,
            share if share >= 1.0 - ACTIVE => Bound::To,
            _ => return None,
        };
        Some(BoundHit { variable, bound })
    };
    seen.shares.iter().enumerate().filter_map(hit).collect()
}

/// The point that misses the limits least, and whether each of them could be kept by itself.
pub(crate) fn infeasible(ledger: &Ledger<'_>, aim: &Aim, nearest: &Seen, stop: StopReason) -> Result<Infeasible, Stopped> {
    let missing: Vec<usize> = (0..aim.limits.len()).filter(|&i| !aim.keeps(i, nearest)).collect();
    for (done, &i) in missing.iter().enumerate() {
        if !ledger.archive().any(|seen| aim.keeps(i, seen)) {
            let alone = Aim::new(towards(&aim.limits[i]), Vec::new(), &ledger.archive());
            let share = ledger.left() / (missing.len() - done) as u32;
            searches(ledger, &alone, vec![nearest.clone()], 2, share);
            ledger.goes_on()?;
        }
    }
    let archive = ledger.archive();
    let missed = missing.into_iter().filter_map(|i| {
        let limit = aim.limits[i];
        let alone = Aim::new(towards(&limit), Vec::new(), &archive);
        let best = starts::best(&archive, &alone)?;
        Some(Missed {
            limit: i,
            by: -limit.margin(nearest.outputs[limit.output]),
            best: best.outputs[limit.output],
            is_kept_alone: aim.keeps(i, best),
        })
    });
    Ok(Infeasible {
        values: ledger.values(&nearest.shares),
        outputs: nearest.outputs.clone(),
        missed: missed.collect(),
        at_bounds: at_bounds(nearest),
        evaluations: ledger.spent(),
        unanswered: ledger.unanswered(),
        stop,
    })
}

/// The goal that leads into a limit.
fn towards(limit: &Limit) -> Goal {
    let sense = match limit.side {
        Side::AtLeast => Sense::Maximise,
        Side::AtMost => Sense::Minimise,
    };
    Goal { output: limit.output, sense }
}
