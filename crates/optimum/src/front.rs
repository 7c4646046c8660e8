//! The trade-off of two outputs: the points where one cannot be made better but at the cost of the other.
//!
//! By epsilon constraints (Haimes, Lasdon and Wismer 1971): the best of each by itself gives the ends; between them the goal is
//! sought under a limit on the other output, step by step. Unlike weighted sums this finds the hollow parts of the curve, too.

use crate::aim::Aim;
use crate::archive::Seen;
use crate::descent::StopReason;
use crate::ledger::{Function, Ledger, Stopped};
use crate::optimum::{Outcome, infeasible};
use crate::scale::spread;
use crate::search::{best_of, given_start, searches, survey};
use crate::starts;
use crate::task::{Goal, Limit, Sense, Side, Task};

/// The other side of a trade-off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Trade {
    /// The output that the goal is weighed against.
    pub against: Goal,
    /// Points sought along the curve.
    pub points: u32,
}

/// A point of the curve.
#[derive(Debug, Clone, PartialEq)]
pub struct FrontPoint {
    /// The variables.
    pub values: Vec<f64>,
    /// The outputs there.
    pub outputs: Vec<f64>,
    /// Why its search ended.
    pub stop: StopReason,
}

/// The curve, from the best of the goal to the best of the other.
#[derive(Debug, Clone, PartialEq)]
pub struct Front {
    /// None of them is better than another in both.
    pub points: Vec<FrontPoint>,
    /// Points that were left out because another is no worse in both.
    pub dominated: usize,
    /// How often the function was evaluated.
    pub evaluations: u32,
    /// How often it had no answer.
    pub unanswered: u32,
}

/// Share of an output's spread that counts as equal.
const EQUAL: f64 = 1e-7;

/// Share of the evaluations for each end of the curve: one in so many.
const SHARE_OF_END: u32 = 5;

/// A point on the way to the curve.
type Found = (Seen, StopReason);

/// The trade-off of a task's goal against another output.
///
/// # Errors
/// That the function said [`Refusal::Stop`](crate::Refusal::Stop).
pub fn front(task: &Task, trade: Trade, function: &mut Function<'_>) -> Result<Outcome<Front>, Stopped> {
    let ledger = Ledger::new(task, function);
    let (goal, against) = (task.params().goal, trade.against);
    survey(&ledger);
    let Some(best) = end(&ledger, goal, against)? else { return Ok(Outcome::NoAnswer { evaluations: ledger.spent() }) };
    let aim = Aim::new(goal, task.params().limits.clone(), &ledger.archive());
    if !aim.is_kept(&best.0) {
        return infeasible(&ledger, &aim, &best.0, best.1).map(Outcome::Infeasible);
    }
    let other = end(&ledger, against, goal)?;
    let mut found = vec![best];
    found.extend(other.filter(|(other, _)| aim.is_kept(other)));
    levels(&ledger, trade, &mut found)?;
    let sought = found.len();
    let points = undominated(&ledger, goal, against, found);
    Ok(Outcome::Found(Front {
        dominated: sought - points.len(),
        points: points
            .into_iter()
            .map(|(seen, stop)| FrontPoint { values: ledger.values(&seen.shares), outputs: seen.outputs, stop })
            .collect(),
        evaluations: ledger.spent(),
        unanswered: ledger.unanswered(),
    }))
}

/// An end of the curve: the best of `first`, and of several such points the best of `second`.
fn end(ledger: &Ledger<'_>, first: Goal, second: Goal) -> Result<Option<Found>, Stopped> {
    let params = ledger.task().params();
    let share = params.evaluations / SHARE_OF_END;
    let aim = Aim::new(first, params.limits.clone(), &ledger.archive());
    let found = searches(ledger, &aim, given_start(ledger), params.starts, share - share / 4);
    ledger.goes_on()?;
    let Some(place) = best_of(&aim, &found) else { return Ok(None) };
    let (best, stop) = (found[place].best.clone(), found[place].stop);
    if !aim.is_kept(&best) {
        return Ok(Some((best, stop)));
    }
    let as_good = bound(ledger, first, best.outputs[first.output], EQUAL);
    let limits = params.limits.iter().copied().chain([as_good]).collect();
    let tied = Aim::new(second, limits, &ledger.archive());
    searches(ledger, &tied, vec![best.clone()], 1, share / 4);
    ledger.goes_on()?;
    let best = starts::best(&ledger.archive(), &tied).cloned().unwrap_or(best);
    Ok(Some((best, stop)))
}

/// That an output is as good as `value`, but for a share of its spread.
fn bound(ledger: &Ledger<'_>, goal: Goal, value: f64, share: f64) -> Limit {
    let slack = share * spread(ledger.archive().outputs(goal.output));
    match goal.sense {
        Sense::Minimise => Limit { output: goal.output, side: Side::AtMost, value: value + slack },
        Sense::Maximise => Limit { output: goal.output, side: Side::AtLeast, value: value - slack },
    }
}

/// Seeks the points between both ends, from the better end of the other output: what was found there keeps the next limit.
fn levels(ledger: &Ledger<'_>, trade: Trade, found: &mut Vec<Found>) -> Result<(), Stopped> {
    let [(first, _), (last, _)] = found.as_slice() else { return Ok(()) };
    let params = ledger.task().params();
    let against = trade.against;
    let (worst, best) = (first.outputs[against.output], last.outputs[against.output]);
    let mut before = last.clone();
    let inner = trade.points.saturating_sub(2);
    for i in 1..=inner {
        let share = f64::from(i) / f64::from(inner + 1);
        let level = bound(ledger, against, best * (1.0 - share) + worst * share, 0.0);
        let limits = params.limits.iter().copied().chain([level]).collect();
        let aim = Aim::new(params.goal, limits, &ledger.archive());
        let made = searches(ledger, &aim, vec![before.clone()], 2, ledger.left() / (inner + 1 - i));
        ledger.goes_on()?;
        let Some(place) = best_of(&aim, &made) else { continue };
        let stop = made[place].stop;
        // A search for another point may have passed here.
        let Some(seen) = starts::best(&ledger.archive(), &aim).filter(|seen| aim.is_kept(seen)).cloned() else { continue };
        before = seen.clone();
        found.push((seen, stop));
    }
    Ok(())
}

/// The points that no other is as good as in both outputs, from the best of the goal on.
fn undominated(ledger: &Ledger<'_>, goal: Goal, against: Goal, found: Vec<Found>) -> Vec<Found> {
    let archive = ledger.archive();
    let cost = |of: Goal| {
        let aim = Aim::new(of, Vec::new(), &archive);
        move |seen: &Seen| aim.objective(seen)
    };
    let (first, second) = (cost(goal), cost(against));
    let mut sorted: Vec<(f64, f64, Found)> = found.into_iter().map(|one| (first(&one.0), second(&one.0), one)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut kept: Vec<Found> = Vec::with_capacity(sorted.len());
    let mut least = f64::INFINITY;
    for (_, of_second, one) in sorted {
        if of_second < least - EQUAL {
            least = of_second;
            kept.push(one);
        }
    }
    kept
}
