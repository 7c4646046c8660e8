//! What is to become small or large, and the limits to keep.

use terramechanics_optimum::{Sense, Side};
use terramechanics_reading::{Field, Number, Object, Objects, Reader, Scope, Text};

use super::formula::{self, Formula, Names, TEXT, Unresolved};

const MINIMISE: Field<Text> = Field::new(
    "minimise",
    "What is to become small: a quantity of the answer, such as torque_n_m, or a formula of such quantities and of the variables by their names, such as 2700*0.002*2*pi*radius_m*width_m; a field that does not vary stands in it as its number. Operators + - * / ^, brackets, pi, sqrt, exp, ln, abs, sin, cos, tan, atan, min and max.",
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
    /// Its place in the request; none where the request asks for it in other words.
    place: Option<usize>,
}

/// What is sought.
#[derive(Debug, Clone)]
pub(crate) struct Goals<F = Formula> {
    pub(crate) goal: Goal<F>,
    pub(crate) constraints: Vec<Constraint<F>>,
    /// The second goal, and the points along the curve.
    pub(crate) against: Option<(Goal<F>, u32)>,
}

/// How much steeper a rover could climb than it has to; the request is asked on one slope.
const CLIMB: &str = "largest_slope_rad - slope_rad";

/// The goals, their names not looked up yet; where the rover has to climb, with that among the constraints.
pub(super) fn read(object: &Reader<'_>, must_climb: bool) -> Option<Goals<Unresolved>> {
    let goal = goal(object);
    let constraints = object.optional(&CONSTRAINTS).and_then(|items| items.unwrap_or_default().each(constraint));
    let against = match object.optional(&AGAINST)? {
        None => Some(None),
        Some(sent) => {
            let (goal, points) = (self::goal(&sent), sent.or_default(&POINTS));
            goal.zip(points).map(|(goal, points)| Some((goal, points as u32)))
        }
    };
    let mut constraints: Vec<Constraint<Unresolved>> = constraints?.into_iter().flatten().collect();
    if contradict(object, &constraints) {
        return None;
    }
    if must_climb {
        constraints.push(Constraint { quantity: Unresolved::of(CLIMB)?, side: Side::AtLeast, limit: 0.0, place: None });
    }
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

/// Whether one quantity has a least value above its largest one, which is reported.
fn contradict(object: &Reader<'_>, constraints: &[Constraint<Unresolved>]) -> bool {
    let mut is_wrong = false;
    for (i, later) in constraints.iter().enumerate() {
        let is_contrary = |earlier: &&Constraint<Unresolved>| {
            let [least, most] = if earlier.side == Side::AtLeast { [*earlier, later] } else { [later, *earlier] };
            earlier.quantity.text == later.quantity.text && earlier.side != later.side && least.limit > most.limit
        };
        let (Some(earlier), Some(place)) = (constraints[..i].iter().find(is_contrary), later.place) else { continue };
        let (own, other) = match later.side {
            Side::AtLeast => (AT_LEAST.name, AT_MOST.name),
            Side::AtMost => (AT_MOST.name, AT_LEAST.name),
        };
        let relation = if later.side == Side::AtLeast { "not be above" } else { "not be below" };
        let whose = if earlier.place == later.place { "" } else { " of the same quantity" };
        let field = object.place_of(&CONSTRAINTS);
        field.item(place).field(own).fault(format_args!("must {relation} `{other}`{whose}, {}", earlier.limit));
        is_wrong = true;
    }
    is_wrong
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
    Some(limits.map(|(side, limit)| Constraint { quantity: quantity.clone(), side, limit, place: Some(place) }).collect())
}

impl Goals<Unresolved> {
    /// The goals with all names looked up; those that are not known are reported.
    pub(super) fn resolved(self, names: &Names<'_>, object: &Reader<'_>) -> Option<Goals> {
        let Self { goal, constraints, against } = self;
        let goal = goal.resolved(names, object.place());
        let constraint = |Constraint { quantity, side, limit, place }: Constraint<Unresolved>| {
            let constraints = object.place_of(&CONSTRAINTS);
            let item = place.map(|place| constraints.item(place));
            let quantity = match &item {
                Some(item) => quantity.resolved(names, &item.field(QUANTITY.name)),
                None => quantity.resolved(names, object.place()),
            };
            let quantity = quantity?;
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

impl Goals {
    /// The formulas: the goal, the other goal where there is one, then the constraints.
    pub(crate) fn formulas(&self) -> impl Iterator<Item = &Formula> {
        let Self { goal, constraints, against } = self;
        let against = against.iter().map(|(of, _)| &of.formula);
        std::iter::once(&goal.formula).chain(against).chain(constraints.iter().map(|of| &of.quantity))
    }

    /// The pointers of their fields; that of the request where it asks for one in other words.
    pub(crate) fn pointers(&self) -> impl Iterator<Item = String> {
        let Self { goal, constraints, against } = self;
        let against = against.iter().map(|(of, _)| format!("/{}/{}", AGAINST.name, of.name()));
        let constraints = constraints.iter().map(|of| match of.place {
            Some(place) => format!("/{}/{place}/{}", CONSTRAINTS.name, QUANTITY.name),
            None => "/request".to_owned(),
        });
        std::iter::once(format!("/{}", goal.name())).chain(against).chain(constraints)
    }

    /// Which of the constraints says that the rover has to climb.
    pub(crate) fn climb(&self) -> Option<usize> {
        self.constraints.iter().position(|constraint| constraint.place.is_none())
    }
}

impl<F> Goal<F> {
    /// The field in which it was sent.
    fn name(&self) -> &'static str {
        match self.sense {
            Sense::Minimise => MINIMISE.name,
            Sense::Maximise => MAXIMISE.name,
        }
    }
}

impl Goal<Unresolved> {
    fn resolved(self, names: &Names<'_>, object: &Scope<'_>) -> Option<Goal> {
        let (name, sense) = (self.name(), self.sense);
        let formula = self.formula.resolved(names, &object.field(name))?;
        Some(Goal { formula, sense })
    }
}
