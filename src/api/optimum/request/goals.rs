//! What is to become small or large, and the limits to keep.

use terramechanics_optimum::{Sense, Side};
use terramechanics_reading::{Field, Number, Object, Objects, Reader, Scope, Text};

use super::formula::{self, Formula, Names, TEXT, Unresolved};

const MINIMISE: Field<Text> = Field::new(
    "minimise",
    "What is to become small: a quantity of the answer, such as torque_n_m, or a formula of such quantities and of the variables by their names, such as 2700*0.002*2*pi*radius_m*width_m. Operators + - * / ^, brackets, pi, sqrt, exp, ln, abs, sin, cos, tan, atan, min and max.",
    TEXT,
);
const MAXIMISE: Field<Text> = Field::new("maximise", "In place of `minimise`: what is to become large.", TEXT);

const QUANTITY: Field<Text> = Field::required("quantity", "A quantity, or a formula as in `minimise`.", TEXT);
const AT_LEAST: Field<Number> = Field::new("at_least", "The least value that it may have.", Number::any(""));
const AT_MOST: Field<Number> = Field::new("at_most", "The largest value that it may have.", Number::any(""));
const CONSTRAINT: Object = Object {
    name: "OptimumConstraint",
    doc: "A quantity and its limits: `at_least`, `at_most` or both.",
    groups: &[&[&QUANTITY, &AT_LEAST, &AT_MOST]],
};
const MOST_CONSTRAINTS: usize = 10;
const CONSTRAINTS: Field<Objects> =
    Field::new("constraints", "What has to hold.", Objects { object: &CONSTRAINT, fewest: 0, most: MOST_CONSTRAINTS });

const FEWEST_POINTS: f64 = 2.0;
const MOST_POINTS: f64 = 50.0;
const POINTS: Field<Number> = Field::new(
    "points",
    "Points sought along the curve, ends included.",
    Number::new("1", FEWEST_POINTS, MOST_POINTS).whole().or(20.0),
);
const AGAINST_OBJECT: Object = Object {
    name: "OptimumAgainst",
    doc: "A second goal, `minimise` or `maximise`.",
    groups: &[&[&MINIMISE, &MAXIMISE, &POINTS]],
};
const AGAINST: Field<&Object> = Field::new(
    "against",
    "A second goal. The answer is then the trade-off of both: the points where one cannot become better but at the cost of the other.",
    &AGAINST_OBJECT,
);

/// The fields of a request.
pub(super) const FIELDS: &[&dyn terramechanics_reading::Declared] = &[&MINIMISE, &MAXIMISE, &CONSTRAINTS, &AGAINST];

/// A quantity to make small or large.
#[derive(Debug, Clone)]
pub(crate) struct Goal<F = Formula> {
    pub(crate) formula: F,
    pub(crate) sense: Sense,
}

/// A limit that a quantity has to keep.
#[derive(Debug, Clone)]
pub(crate) struct Constraint<F = Formula> {
    pub(crate) quantity: F,
    pub(crate) side: Side,
    pub(crate) limit: f64,
    /// Its place in the request.
    place: usize,
}

/// What is sought.
#[derive(Debug, Clone)]
pub(crate) struct Goals<F = Formula> {
    pub(crate) goal: Goal<F>,
    pub(crate) constraints: Vec<Constraint<F>>,
    /// The second goal, and the points along the curve.
    pub(crate) against: Option<(Goal<F>, u32)>,
}

/// The goals, their names not looked up yet.
pub(super) fn read(object: &Reader<'_>) -> Option<Goals<Unresolved>> {
    let goal = goal(object);
    let constraints = object.optional(&CONSTRAINTS).and_then(|items| items.unwrap_or_default().each(constraint));
    let against = match object.optional(&AGAINST)? {
        None => Some(None),
        Some(sent) => {
            let (goal, points) = (self::goal(&sent), sent.or_default(&POINTS));
            goal.zip(points).map(|(goal, points)| Some((goal, points as u32)))
        }
    };
    let constraints = constraints?.into_iter().flatten().collect();
    Some(Goals { goal: goal?, constraints, against: against? })
}

fn goal(object: &Reader<'_>) -> Option<Goal<Unresolved>> {
    let formula = |field: &Field<Text>| {
        let text = object.optional(field)?;
        text.map_or(Some(None), |text| formula::read(text, &object.place_of(field)).map(Some))
    };
    let (small, large) = (formula(&MINIMISE), formula(&MAXIMISE));
    match (small?, large?) {
        (Some(formula), None) => Some(Goal { formula, sense: Sense::Minimise }),
        (None, Some(formula)) => Some(Goal { formula, sense: Sense::Maximise }),
        (None, None) => {
            object.place_of(&MINIMISE).fault(format_args!("is required, or `{}`", MAXIMISE.name));
            None
        }
        (Some(_), Some(_)) => {
            object.place_of(&MAXIMISE).fault(format_args!("give either `{}` or `{}`", MINIMISE.name, MAXIMISE.name));
            None
        }
    }
}

fn constraint(sent: &Reader<'_>, place: usize) -> Option<Vec<Constraint<Unresolved>>> {
    let quantity = sent.required(&QUANTITY).and_then(|text| formula::read(text, &sent.place_of(&QUANTITY)));
    let (least, most) = (sent.optional(&AT_LEAST), sent.optional(&AT_MOST));
    let (quantity, least, most) = (quantity?, least?, most?);
    if least.is_none() && most.is_none() {
        sent.place_of(&AT_LEAST).fault(format_args!("is required, or `{}`", AT_MOST.name));
        return None;
    }
    let sides = [(Side::AtLeast, least), (Side::AtMost, most)].into_iter();
    let limits = sides.filter_map(|(side, limit)| limit.map(|limit| (side, limit)));
    Some(limits.map(|(side, limit)| Constraint { quantity: quantity.clone(), side, limit, place }).collect())
}

impl Goals<Unresolved> {
    /// The goals with all names looked up; those that are not known are reported.
    pub(super) fn resolved(self, names: &Names<'_>, object: &Reader<'_>) -> Option<Goals> {
        let Self { goal, constraints, against } = self;
        let goal = goal.resolved(names, object.place());
        let constraint = |Constraint { quantity, side, limit, place }: Constraint<Unresolved>| {
            let constraints = object.place_of(&CONSTRAINTS);
            let item = constraints.item(place);
            let quantity = quantity.resolved(names, &item.field(QUANTITY.name))?;
            Some(Constraint { quantity, side, limit, place })
        };
        let constraints: Vec<Option<Constraint>> = constraints.into_iter().map(constraint).collect();
        let against = match against {
            None => Some(None),
            Some((goal, points)) => goal.resolved(names, &object.place_of(&AGAINST)).map(|goal| Some((goal, points))),
        };
        Some(Goals { goal: goal?, constraints: constraints.into_iter().collect::<Option<_>>()?, against: against? })
    }
}

impl Goal<Unresolved> {
    fn resolved(self, names: &Names<'_>, object: &Scope<'_>) -> Option<Goal> {
        let field = match self.sense {
            Sense::Minimise => &MINIMISE,
            Sense::Maximise => &MAXIMISE,
        };
        let formula = self.formula.resolved(names, &object.field(field.name))?;
        Some(Goal { formula, sense: self.sense })
    }
}
