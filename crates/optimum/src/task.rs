//! What is to be found.

use crate::variable::Variable;

/// Most variables of a task: beyond, a survey of their whole range says next to nothing.
pub const MOST_VARIABLES: usize = 6;

/// Most searches of a task.
pub const MOST_STARTS: u32 = 64;

/// Which way is better.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// The smaller the better.
    Minimise,
    /// The larger the better.
    Maximise,
}

/// An output to make small or large.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Goal {
    /// The output, by its place.
    pub output: usize,
    /// Which way is better.
    pub sense: Sense,
}

/// The side of a limit on which an output has to stay.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Not below it.
    AtLeast,
    /// Not above it.
    AtMost,
}

/// A limit that an output has to keep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// The output, by its place.
    pub output: usize,
    /// The side on which it has to stay.
    pub side: Side,
    /// The limit.
    pub value: f64,
}

impl Limit {
    /// How far an output is on the right side; negative on the wrong one.
    #[must_use]
    pub fn margin(&self, output: f64) -> f64 {
        match self.side {
            Side::AtLeast => output - self.value,
            Side::AtMost => self.value - output,
        }
    }
}

/// A task.
#[derive(Debug, Clone, PartialEq)]
pub struct TaskParams {
    /// The variables.
    pub variables: Vec<Variable>,
    /// How many outputs the function has.
    pub outputs: usize,
    /// The output to make small or large.
    pub goal: Goal,
    /// The limits to keep.
    pub limits: Vec<Limit>,
    /// How many searches start.
    pub starts: u32,
    /// What the survey is drawn with: the same seed, the same result.
    pub seed: u64,
    /// How often the function may be evaluated.
    pub evaluations: u32,
}

/// Why a task makes no sense.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InvalidTask {
    /// No variables, or too many.
    Variables,
    /// A variable, by its place, without a range, or with a start outside it.
    Range(usize),
    /// An output that the function does not have.
    Output(usize),
    /// A limit, by its place, that is not finite.
    Limit(usize),
    /// No starts, or too many.
    Starts,
    /// Too few evaluations for a survey and one search.
    Evaluations,
}

/// A task that makes sense.
#[derive(Debug, Clone, PartialEq)]
pub struct Task(TaskParams);

impl Task {
    /// Fewest evaluations of a task.
    pub const LEAST_EVALUATIONS: u32 = 20;

    /// A task.
    ///
    /// # Errors
    /// The first fault, see [`InvalidTask`].
    pub fn new(params: TaskParams) -> Result<Self, InvalidTask> {
        let TaskParams { variables, outputs, goal, limits, starts, evaluations, .. } = &params;
        if !(1..=MOST_VARIABLES).contains(&variables.len()) {
            return Err(InvalidTask::Variables);
        }
        if let Some(improper) = variables.iter().position(|variable| !variable.is_proper()) {
            return Err(InvalidTask::Range(improper));
        }
        let mut asked = limits.iter().map(|limit| limit.output).chain([goal.output]);
        if let Some(missing) = asked.find(|output| output >= outputs) {
            return Err(InvalidTask::Output(missing));
        }
        if let Some(open) = limits.iter().position(|limit| !limit.value.is_finite()) {
            return Err(InvalidTask::Limit(open));
        }
        if !(1..=MOST_STARTS).contains(starts) {
            return Err(InvalidTask::Starts);
        }
        if *evaluations < Self::LEAST_EVALUATIONS {
            return Err(InvalidTask::Evaluations);
        }
        Ok(Self(params))
    }

    /// What it was made of.
    #[must_use]
    pub fn params(&self) -> &TaskParams {
        &self.0
    }
}

impl std::fmt::Display for InvalidTask {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Variables => write!(f, "a task has 1 to {MOST_VARIABLES} variables"),
            Self::Range(i) => write!(f, "variable {i} has no range, or a start outside it"),
            Self::Output(i) => write!(f, "the function has no output {i}"),
            Self::Limit(i) => write!(f, "limit {i} is not finite"),
            Self::Starts => write!(f, "a task has 1 to {MOST_STARTS} starts"),
            Self::Evaluations => write!(f, "a task takes at least {} evaluations", Task::LEAST_EVALUATIONS),
        }
    }
}

impl std::error::Error for InvalidTask {}
