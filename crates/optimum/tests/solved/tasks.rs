//! Tasks for tests, in a few words.

use terramechanics_optimum::{Goal, Limit, Optimum, Outcome, Sense, Side, Spacing, Task, TaskParams, Variable, optimum};

/// A variable with equal steps.
pub(crate) fn between(from: f64, to: f64) -> Variable {
    Variable { from, to, start: None, spacing: Spacing::Linear }
}

/// Minimises the first output, where all others have to stay at least zero.
pub(crate) fn task(variables: Vec<Variable>, outputs: usize) -> TaskParams {
    TaskParams {
        variables,
        outputs,
        goal: Goal { output: 0, sense: Sense::Minimise },
        limits: (1..outputs).map(|output| Limit { output, side: Side::AtLeast, value: 0.0 }).collect(),
        starts: 8,
        seed: 1,
        evaluations: 5000,
    }
}

/// What is found for a function that answers everywhere.
pub(crate) fn outcome(params: TaskParams, function: impl Fn(&[f64]) -> Vec<f64>) -> Outcome<Optimum> {
    let task = Task::new(params).expect("a task");
    optimum(&task, &mut |values| Ok(function(values))).expect("nobody stops it")
}

/// The optimum, where there is one.
pub(crate) fn found(params: TaskParams, function: impl Fn(&[f64]) -> Vec<f64>) -> Optimum {
    match outcome(params, function) {
        Outcome::Found(optimum) => optimum,
        other => panic!("{other:?}"),
    }
}
