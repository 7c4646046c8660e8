//! The answer of `/v1/optimum`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics_optimum::{Bound, Side};
use utoipa::ToSchema;

use super::columns::{FrontColumns, MARKS, Quantities};
use super::found::{Agreement, Effort, Found, FoundBest, FoundConstraint, FoundFront, FoundVariable};
use super::stop::StopReply;
use crate::reply::{AssumedReply, Reply};
use crate::warning::Warning;

/// The best point, or, with a second goal, the trade-off of both.
#[derive(Debug, Serialize, ToSchema)]
#[serde(untagged)]
#[schema(as = Optimum)]
pub(crate) enum OptimumReply {
    Best(Box<BestReply>),
    Front(FrontReply),
}

/// The best point; where no point keeps all constraints, the one that misses them least.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = BestPoint)]
pub(crate) struct BestReply {
    /// Whether the point keeps all constraints. If not, `met` tells which of them it misses, and the warning `infeasible` by how much. In a table, 1 or 0.
    feasible: bool,
    /// What was to become small or large.
    objective: f64,
    /// In the order of the request.
    variables: Vec<VariableReply>,
    /// In the order of the request; one with two limits stands here twice. Of a rover that must climb, the last one says so.
    constraints: Vec<ConstraintReply>,
    quantities: Quantities,
    /// Whether the best search ended by itself. That does not prove that no better point exists: `agreed` of several searches tells more.
    converged: bool,
    /// `feasible` and `converged` as the cells of a table.
    #[serde(skip)]
    marks: [f64; 2],
    /// Why it ended.
    stop_reason: StopReply,
    /// How many searches were made; null where no point keeps the constraints, like the two that follow.
    searches: Option<usize>,
    /// How many of them came as far, to a ten-thousandth of the spread of the objective within the bounds.
    agreed: Option<usize>,
    /// Which of them found it, from 0; its start is told at the variables.
    found_by: Option<usize>,
    /// How often the operation was asked.
    evaluations: u32,
    /// How often it had no answer.
    without_answer: u32,
    warnings: Vec<Warning>,
    /// What was assumed; absent where the request did not allow it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    assumed: Option<Vec<AssumedReply>>,
}

/// A variable at that point.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = OptimumVariableFound)]
struct VariableReply {
    /// The field, as a JSON pointer into the request.
    #[schema(example = "/wheel/radius_m")]
    field: String,
    /// Its name in formulas.
    #[schema(example = "radius_m")]
    name: String,
    /// Its value, in the unit of the field.
    value: f64,
    /// The bound at which it lies: a better point may lie beyond. Null where it lies between.
    at_bound: Option<BoundReply>,
    /// Its least value among the searches that agree; where this and the largest are far apart, many points are as good. Null where no point keeps the constraints, like the two that follow.
    agreed_from: Option<f64>,
    /// Its largest value among them.
    agreed_to: Option<f64>,
    /// Where the search began that found the point.
    start: Option<f64>,
    #[serde(skip)]
    dotted: String,
}

/// A bound of a variable.
#[derive(Debug, Clone, Copy, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
#[schema(as = OptimumBound)]
enum BoundReply {
    From,
    To,
}

/// A constraint at that point.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = OptimumConstraintFound)]
struct ConstraintReply {
    /// The quantity, as it was sent.
    #[schema(example = "sinkage_m")]
    quantity: String,
    /// Its least value.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    at_least: Option<f64>,
    /// Its largest value.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    at_most: Option<f64>,
    /// Its value here.
    value: f64,
    /// How far it is from the limit; negative where it misses it.
    margin: f64,
    /// Whether it keeps the limit.
    met: bool,
    /// Whether the limit holds the optimum: the quantity keeps it by less than a ten-thousandth.
    active: bool,
    /// Of an active one: the objective if its limit were looser by a hundredth of its value (of a limit of 0, of the spread of its quantity); null where the evaluations did not suffice to tell, and of the others.
    objective_if_looser: Option<f64>,
    /// Of one that is missed: the best value of the quantity found anywhere within the bounds, whatever the other constraints; else null.
    best: Option<f64>,
    /// Of one that is missed: whether that value would keep the limit, so that only the other constraints forbid it; else null.
    met_alone: Option<bool>,
}

/// The trade-off of two goals: points of which none is better than another in both.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = TradeOff)]
pub(crate) struct FrontReply {
    /// True: every point keeps all constraints. Where none does, the answer is the one point that misses them least.
    feasible: bool,
    columns: FrontColumns,
    /// Points that were left out because another is as good in both goals.
    dominated: usize,
    /// Whether the search of every point ended by itself.
    converged: bool,
    /// How often the operation was asked.
    evaluations: u32,
    /// How often it had no answer.
    without_answer: u32,
    warnings: Vec<Warning>,
    /// What was assumed; absent where the request did not allow it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    assumed: Option<Vec<AssumedReply>>,
}

impl From<FoundVariable> for VariableReply {
    fn from(FoundVariable { pointer, dotted, name, value, at_bound, agreed, start }: FoundVariable) -> Self {
        let at_bound = at_bound.map(|bound| match bound {
            Bound::From => BoundReply::From,
            Bound::To => BoundReply::To,
        });
        let (agreed_from, agreed_to) = (agreed.map(|(from, _)| from), agreed.map(|(_, to)| to));
        Self { field: pointer, name, value, at_bound, agreed_from, agreed_to, start, dotted }
    }
}

impl From<FoundConstraint> for ConstraintReply {
    fn from(found: FoundConstraint) -> Self {
        let FoundConstraint { quantity, side, limit, value, margin, is_active, looser, alone, is_met } = found;
        Self {
            quantity,
            at_least: (side == Side::AtLeast).then_some(limit),
            at_most: (side == Side::AtMost).then_some(limit),
            value,
            margin,
            met: is_met,
            active: is_active,
            objective_if_looser: looser,
            best: alone.map(|(best, _)| best),
            met_alone: alone.map(|(_, is_met)| is_met),
        }
    }
}

fn assumed(assumed: Option<Vec<terramechanics_reading::Assumption>>) -> Option<Vec<AssumedReply>> {
    assumed.map(|assumed| assumed.into_iter().map(AssumedReply::from).collect())
}

impl From<Found> for OptimumReply {
    fn from(found: Found) -> Self {
        match found {
            Found::Best(found) => Self::Best(Box::new((*found).into())),
            Found::Front(found) => Self::Front(found.into()),
        }
    }
}

impl From<FoundBest> for BestReply {
    fn from(found: FoundBest) -> Self {
        let Effort { evaluations, unanswered } = found.effort;
        let of_agreement = |value: fn(Agreement) -> usize| found.agreement.map(value);
        Self {
            feasible: found.is_feasible,
            objective: found.objective,
            searches: of_agreement(|agreement| agreement.searches),
            agreed: of_agreement(|agreement| agreement.agreed),
            found_by: of_agreement(|agreement| agreement.search),
            variables: found.variables.into_iter().map(VariableReply::from).collect(),
            constraints: found.constraints.into_iter().map(ConstraintReply::from).collect(),
            quantities: Quantities(found.columns),
            converged: found.stop.is_converged(),
            marks: [found.is_feasible, found.stop.is_converged()].map(|mark| f64::from(u8::from(mark))),
            stop_reason: found.stop.into(),
            evaluations,
            without_answer: unanswered,
            warnings: found.warnings,
            assumed: assumed(found.assumed),
        }
    }
}

impl From<FoundFront> for FrontReply {
    fn from(found: FoundFront) -> Self {
        let Effort { evaluations, unanswered } = found.effort;
        Self {
            feasible: true,
            converged: found.stops.iter().all(|stop| stop.is_converged()),
            columns: FrontColumns::of(found.columns, &found.stops),
            dominated: found.dominated,
            evaluations,
            without_answer: unanswered,
            warnings: found.warnings,
            assumed: assumed(found.assumed),
        }
    }
}

impl Reply for OptimumReply {
    /// Of the best point one row: the objective, the variables, the quantities, and whether the point is what was sought.
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        match self {
            Self::Front(front) => front.columns.as_table(),
            Self::Best(best) => {
                let mut table = vec![("objective".into(), std::slice::from_ref(&best.objective))];
                for variable in &best.variables {
                    table.push((variable.dotted.clone().into(), std::slice::from_ref(&variable.value)));
                }
                for (about, value) in &best.quantities.0 {
                    if best.variables.iter().all(|variable| variable.dotted != about.name) {
                        table.push((about.name.into(), std::slice::from_ref(value)));
                    }
                }
                table.extend(MARKS.into_iter().map(Into::into).zip(best.marks.chunks(1)));
                table
            }
        }
    }

    fn warnings(&self) -> &[Warning] {
        match self {
            Self::Best(best) => &best.warnings,
            Self::Front(front) => &front.warnings,
        }
    }

    fn warn(&mut self, warning: Warning) {
        match self {
            Self::Best(best) => best.warnings.push(warning),
            Self::Front(front) => front.warnings.push(warning),
        }
    }
}
