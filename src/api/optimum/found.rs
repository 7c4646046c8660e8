//! The best of a request, or the trade-off of two goals.

mod asked;

use terramechanics_optimum::{
    Bound, BoundHit, Front, Infeasible, Limit, Optimum, Outcome, Refusal, Side, StopReason, Task, TaskParams, Trade, front,
    optimum,
};
use terramechanics_reading::Assumption;

use super::request::{Constraint, Goals, Sought};
use crate::compute::Pace;
use crate::problem::Problem;
use crate::quantity::{About, number};
use crate::varied::Varied;
use crate::warning::{Finding, Rows, Warning, of_assumptions};
use asked::Asked;

/// What was found.
#[derive(Debug)]
pub(super) enum Found {
    Best(Box<FoundBest>),
    Front(FoundFront),
}

/// The best point, or the one that misses the constraints least.
#[derive(Debug)]
pub(super) struct FoundBest {
    pub(super) is_feasible: bool,
    pub(super) objective: f64,
    pub(super) variables: Vec<FoundVariable>,
    pub(super) constraints: Vec<FoundConstraint>,
    pub(super) columns: Vec<(&'static About, f64)>,
    pub(super) agreement: Option<Agreement>,
    pub(super) effort: Effort,
    pub(super) stop: StopReason,
    pub(super) warnings: Vec<Warning>,
    pub(super) assumed: Option<Vec<Assumption>>,
}

/// Which search found it, and how many came to the same.
#[derive(Debug, Clone, Copy)]
pub(super) struct Agreement {
    pub(super) search: usize,
    pub(super) searches: usize,
    pub(super) agreed: usize,
}

/// What it took.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    pub(super) evaluations: u32,
    pub(super) unanswered: u32,
}

/// A variable at the point found.
#[derive(Debug)]
pub(super) struct FoundVariable {
    pub(super) pointer: String,
    /// Its column of a table.
    pub(super) dotted: String,
    pub(super) name: String,
    pub(super) value: f64,
    pub(super) at_bound: Option<Bound>,
    /// Its range among the searches that agree.
    pub(super) agreed: Option<(f64, f64)>,
    /// Where the search began.
    pub(super) start: Option<f64>,
}

/// A constraint at the point found.
#[derive(Debug)]
pub(super) struct FoundConstraint {
    pub(super) quantity: String,
    pub(super) side: Side,
    pub(super) limit: f64,
    pub(super) value: f64,
    pub(super) margin: f64,
    pub(super) is_active: bool,
    /// Of an active one: the objective where the limit is looser by a hundredth.
    pub(super) looser: Option<f64>,
    /// Of one that is missed: the best value anywhere, and whether that meets it.
    pub(super) alone: Option<(f64, bool)>,
    pub(super) is_met: bool,
}

impl FoundConstraint {
    /// Of one that is missed: what was asked, and by how much it is missed.
    fn in_words(&self) -> String {
        let Self { quantity, side, limit, margin, .. } = self;
        let side = if *side == Side::AtLeast { "at least" } else { "at most" };
        format!("`{quantity}` {side} {} by {}", number(*limit), number(-margin))
    }
}

/// The points of a trade-off.
#[derive(Debug)]
pub(super) struct FoundFront {
    pub(super) columns: Vec<(String, Vec<f64>)>,
    pub(super) stops: Vec<StopReason>,
    pub(super) dominated: usize,
    pub(super) effort: Effort,
    pub(super) warnings: Vec<Warning>,
    pub(super) assumed: Option<Vec<Assumption>>,
}

/// What is sought, found.
///
/// # Errors
/// That the work is to end, or that the operation has no answer anywhere.
pub(super) fn found<R: Varied>(sought: &Sought<R>, pace: &Pace) -> Result<Found, Problem> {
    let mut asked = Asked::of(sought, pace);
    let task = task(sought).ok_or(Problem::Internal)?;
    let mut function = |values: &[f64]| if pace.goes_on() { asked.outputs(values) } else { Err(Refusal::Stop) };
    match &sought.goals.against {
        None => match optimum(&task, &mut function) {
            Ok(Outcome::Found(optimum)) => best(sought, &mut asked, optimum),
            Ok(Outcome::Infeasible(nearest)) => nearest_of(sought, &mut asked, nearest),
            Ok(Outcome::NoAnswer { evaluations }) => Err(asked.no_answer(evaluations)),
            Err(_) => Err(ended(pace)),
        },
        Some((against, points)) => {
            let against = terramechanics_optimum::Goal { output: 1, sense: against.sense };
            match front(&task, Trade { against, points: *points }, &mut function) {
                Ok(Outcome::Found(front)) => curve(sought, &mut asked, front),
                Ok(Outcome::Infeasible(nearest)) => nearest_of(sought, &mut asked, nearest),
                Ok(Outcome::NoAnswer { evaluations }) => Err(asked.no_answer(evaluations)),
                Err(_) => Err(ended(pace)),
            }
        }
    }
}

/// Why the work is to end.
fn ended(pace: &Pace) -> Problem {
    pace.look().map_or_else(Problem::from, |()| Problem::Internal)
}

/// The task: the goal is the first output, then the other goal where there is one, then the constraints.
fn task<R>(sought: &Sought<R>) -> Option<Task> {
    let Sought { variables, goals: Goals { goal, constraints, against }, starts, seed, evaluations, .. } = sought;
    let first = 1 + usize::from(against.is_some());
    let limit =
        |(i, constraint): (usize, &Constraint)| Limit { output: first + i, side: constraint.side, value: constraint.limit };
    let params = TaskParams {
        variables: variables.iter().map(|variable| variable.range).collect(),
        outputs: first + constraints.len(),
        goal: terramechanics_optimum::Goal { output: 0, sense: goal.sense },
        limits: constraints.iter().enumerate().map(limit).collect(),
        starts: *starts,
        seed: *seed,
        evaluations: *evaluations,
    };
    Task::new(params).ok()
}

/// That a search did not end by itself, where it did not.
fn unfinished(stop: StopReason) -> Option<Warning> {
    (!stop.is_converged()).then(|| Finding::SearchUnfinished {}.into())
}

/// The best point as it is told.
fn best<R: Varied>(sought: &Sought<R>, asked: &mut Asked<'_, R>, optimum: Optimum) -> Result<Found, Problem> {
    let Optimum { values, outputs, margins, active, loosened, at_bounds, found_from, agreed_ranges, .. } = optimum;
    let row = asked.row(&values);
    let first = outputs.len() - margins.len();
    let constraint = |(i, constraint): (usize, &Constraint)| FoundConstraint {
        is_active: active.contains(&i),
        looser: loosened.iter().find(|looser| looser.limit == i).map(|looser| looser.goal),
        is_met: true,
        ..constraint_at(constraint, outputs[first + i])
    };
    let variable = |i: usize| FoundVariable {
        agreed: Some(agreed_ranges[i]),
        start: Some(found_from[i]),
        ..variable_at(sought, i, values[i], &at_bounds)
    };
    Ok(Found::Best(Box::new(FoundBest {
        is_feasible: true,
        objective: outputs[0],
        variables: (0..values.len()).map(variable).collect(),
        constraints: sought.goals.constraints.iter().enumerate().map(constraint).collect(),
        columns: row.columns,
        agreement: Some(Agreement { search: optimum.search, searches: optimum.searches, agreed: optimum.agreed }),
        effort: Effort { evaluations: optimum.evaluations, unanswered: optimum.unanswered },
        stop: optimum.stop,
        warnings: unfinished(optimum.stop).into_iter().chain(row.warnings).collect(),
        assumed: row.assumed,
    })))
}

/// The point that misses the constraints least, as it is told.
fn nearest_of<R: Varied>(sought: &Sought<R>, asked: &mut Asked<'_, R>, nearest: Infeasible) -> Result<Found, Problem> {
    let Infeasible { values, outputs, missed, at_bounds, evaluations, unanswered, stop } = nearest;
    let row = asked.row(&values);
    let first = outputs.len() - sought.goals.constraints.len();
    let constraint = |(i, constraint): (usize, &Constraint)| {
        let missed = missed.iter().find(|missed| missed.limit == i);
        FoundConstraint {
            is_met: missed.is_none(),
            alone: missed.map(|missed| (missed.best, missed.is_kept_alone)),
            ..constraint_at(constraint, outputs[first + i])
        }
    };
    let constraints: Vec<FoundConstraint> = sought.goals.constraints.iter().enumerate().map(constraint).collect();
    let missed = constraints.iter().filter(|constraint| !constraint.is_met).map(FoundConstraint::in_words).collect();
    let told = std::iter::once(Warning::from(Finding::Infeasible { missed })).chain(unfinished(stop));
    Ok(Found::Best(Box::new(FoundBest {
        is_feasible: false,
        objective: outputs[0],
        variables: (0..values.len()).map(|i| variable_at(sought, i, values[i], &at_bounds)).collect(),
        warnings: told.chain(row.warnings).collect(),
        constraints,
        columns: row.columns,
        agreement: None,
        effort: Effort { evaluations, unanswered },
        stop,
        assumed: row.assumed,
    })))
}

fn constraint_at(constraint: &Constraint, value: f64) -> FoundConstraint {
    let Constraint { quantity, side, limit, .. } = constraint;
    let margin = Limit { output: 0, side: *side, value: *limit }.margin(value);
    let (quantity, side, limit) = (quantity.text.clone(), *side, *limit);
    FoundConstraint { quantity, side, limit, value, margin, is_active: false, looser: None, alone: None, is_met: false }
}

fn variable_at<R>(sought: &Sought<R>, i: usize, value: f64, at_bounds: &[BoundHit]) -> FoundVariable {
    let variable = &sought.variables[i];
    let (pointer, dotted) = (variable.path.pointer(), variable.path.dotted());
    let at_bound = at_bounds.iter().find(|hit| hit.variable == i).map(|hit| hit.bound);
    FoundVariable { pointer, dotted, name: variable.name.clone(), value, at_bound, agreed: None, start: None }
}

/// The trade-off as it is told: both goals, the variables, and what the operation gives.
fn curve<R: Varied>(sought: &Sought<R>, asked: &mut Asked<'_, R>, front: Front) -> Result<Found, Problem> {
    let Front { points, dominated, evaluations, unanswered } = front;
    let (mut rows, mut warnings, assumed) = asked.rows(points.iter().map(|point| point.values.as_slice()));
    let of_points = |value: &dyn Fn(&terramechanics_optimum::FrontPoint) -> f64| points.iter().map(value).collect::<Vec<f64>>();
    let goals = [("objective", 0), ("against", 1)];
    let mut columns: Vec<(String, Vec<f64>)> =
        goals.iter().map(|(name, output)| ((*name).to_owned(), of_points(&|point| point.outputs[*output]))).collect();
    for (i, variable) in sought.variables.iter().enumerate() {
        columns.push((variable.path.dotted(), of_points(&|point| point.values[i])));
    }
    rows.retain(|(about, _)| columns.iter().all(|(name, _)| name != about.name));
    columns.extend(rows.into_iter().map(|(about, values)| (about.name.to_owned(), values)));
    warnings.extend(of_assumptions(assumed.as_deref().unwrap_or_default()));
    let unfinished = points.iter().enumerate().filter(|(_, point)| !point.stop.is_converged());
    let mut rows = Rows::none();
    unfinished.for_each(|(row, _)| rows.push(row as u64));
    if rows.count() > 0 {
        warnings.insert(0, Warning::from(Finding::SearchUnfinished {}).at(rows));
    }
    Ok(Found::Front(FoundFront {
        columns,
        stops: points.iter().map(|point| point.stop).collect(),
        dominated,
        effort: Effort { evaluations, unanswered },
        warnings,
        assumed,
    }))
}
