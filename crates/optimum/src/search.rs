//! From a survey of the whole range to several searches from where it looks best.

use crate::aim::Aim;
use crate::archive::Seen;
use crate::descent::{Descent, StopReason, descend};
use crate::ledger::Ledger;
use crate::sequence::Sequence;
use crate::starts::promising;

/// Points of a survey of one variable; for each further one twice as many, up to [`MOST_POINTS`].
const POINTS_OF_ONE: u32 = 64;

/// Most points of a survey.
const MOST_POINTS: u32 = 256;

/// Share of the evaluations that the survey may take: one in so many.
const SHARE_OF_SURVEY: u32 = 4;

/// Evaluations below which a search makes little sense: a simplex, and a few steps.
const LEAST_OF_A_SEARCH: u32 = 10;

/// Looks at points all over the bounds, first at the start that was given, and goes on until one of them has an answer.
pub(crate) fn survey(ledger: &Ledger<'_>) {
    let params = ledger.task().params();
    let dimensions = params.variables.len();
    let points = (POINTS_OF_ONE << (dimensions - 1)).min(MOST_POINTS).min(params.evaluations / SHARE_OF_SURVEY);
    let mut even = Sequence::new(dimensions, params.seed);
    let place = |i: u32| match dimensions {
        // Of one variable: a grid, ends included.
        1 if points > 1 && i < points => Some(vec![f64::from(i) / f64::from(points - 1)]),
        _ => even.next(),
    };
    for (i, shares) in std::iter::once(start_of(ledger)).chain((0..).map_while(place)).enumerate() {
        let is_enough = i > points as usize && ledger.archive().len() > 0;
        if is_enough || ledger.at(&shares).is_err() {
            return;
        }
    }
}

/// The searches of a task for an aim, with so many evaluations in all. The first one starts from the start that was given, if it
/// has an answer; then those that were found before, then the most promising points.
pub(crate) fn searches(ledger: &Ledger<'_>, aim: &Aim, first: Vec<Seen>, count: u32, evaluations: u32) -> Vec<Descent> {
    let end = ledger.left().saturating_sub(evaluations);
    let left = |ledger: &Ledger<'_>| ledger.left().saturating_sub(end);
    let affordable = left(ledger) / 2 / (LEAST_OF_A_SEARCH + 2 * ledger.task().params().variables.len() as u32);
    let count = count.min(affordable).max(1) as usize;
    let mut starts = first;
    starts.truncate(count);
    let others = promising(&ledger.archive(), aim, count - starts.len(), &starts);
    starts.extend(others);
    // Each gets a share of half of them; the better a search went, the more it gets of the rest.
    let total = starts.len() as u32;
    let half = left(ledger) / 2;
    let mut found: Vec<Descent> = starts.into_iter().map(|start| descend(ledger, aim, start, half / total)).collect();
    let mut order: Vec<usize> = (0..found.len()).collect();
    order.sort_by(|&a, &b| aim.order(&found[a].best, &found[b].best));
    order.retain(|&place| found[place].stop == StopReason::Evaluations);
    for (i, &place) in order.iter().enumerate() {
        let search = &mut found[place];
        let share = if i + 1 == order.len() { left(ledger) } else { left(ledger) / 2 };
        if share > 0 {
            let further = descend(ledger, aim, search.best.clone(), share);
            *search = Descent { start: search.start.clone(), ..further };
        }
    }
    found
}

/// The place of the best search.
pub(crate) fn best_of(aim: &Aim, found: &[Descent]) -> Option<usize> {
    (0..found.len()).reduce(|best, i| if aim.is_better(&found[i].best, &found[best].best) { i } else { best })
}

/// The start that was given, if it has an answer: the survey looked there first.
pub(crate) fn given_start(ledger: &Ledger<'_>) -> Vec<Seen> {
    let shares = start_of(ledger);
    ledger.archive().first().filter(|seen| seen.shares == shares).cloned().into_iter().collect()
}

/// The shares of the start that was given, or of the middle.
fn start_of(ledger: &Ledger<'_>) -> Vec<f64> {
    let variables = &ledger.task().params().variables;
    variables.iter().map(|variable| variable.start.map_or(0.5, |start| variable.share(start))).collect()
}
