//! The variables: which fields vary, and between which bounds.

use terramechanics_optimum::{Expression, MOST_VARIABLES, Spacing, Variable};
use terramechanics_reading::{Field, Label, Number, Object, Objects, Path, Reader, Word};

use crate::varied::varied_field;

const FIELD: Field<Label> = Field::required(
    "field",
    "The field that varies: the JSON pointer of any numeric field of the request, such as /wheel/radius_m or /slip, whether or not the request has it.",
    Label,
);
const NAME: Field<Label> = Field::new(
    "name",
    "Its name in formulas: letters, digits and underscores, and none that formulas or the answer have already, such as pi or torque_n_m. The last name of the pointer unless given.",
    Label,
);
const FROM: Field<Number> = Field::required("from", "Lower bound, in the unit of the field.", Number::any(""));
const TO: Field<Number> = Field::required("to", "Upper bound.", Number::any(""));
const START: Field<Number> = Field::new("start", "Where the first search starts; the middle unless given.", Number::any(""));
const SPACING: Field<Word<Spacing>> = Field::new(
    "spacing",
    "What the search takes equal steps of: the value (linear) or, between bounds above 0, its logarithm (log).",
    Word::new(&[("linear", Spacing::Linear), ("log", Spacing::Logarithmic)]).or(Spacing::Linear),
);

const VARIABLE: Object = Object {
    name: "OptimumVariable",
    doc: "A field of the request and its bounds.",
    groups: &[&[&FIELD, &FROM, &TO, &START, &SPACING, &NAME]],
};

const VARIABLES: Field<Objects> =
    Field::required("variables", "The fields that vary.", Objects { object: &VARIABLE, fewest: 1, most: MOST_VARIABLES });

/// The fields of a request.
pub(super) const FIELDS: &[&dyn terramechanics_reading::Declared] = &[&VARIABLES];

/// A field that varies.
#[derive(Debug, Clone)]
pub(crate) struct Varying {
    pub(crate) path: Path,
    /// Its name in formulas.
    pub(crate) name: String,
    pub(crate) range: Variable,
}

/// The variables, each of a field that `request` declares.
pub(super) fn read(object: &Reader<'_>, request: &'static Object) -> Option<Vec<Varying>> {
    let variables = object.required(&VARIABLES)?.each(|variable, _| one(variable, request))?;
    for (i, Varying { name, .. }) in variables.iter().enumerate() {
        if variables[..i].iter().any(|other| other.name == *name) {
            let detail = format!("another variable is called `{name}`; give a `{}`", NAME.name);
            object.place_of(&VARIABLES).item(i).field(NAME.name).fault(detail);
            return None;
        }
    }
    Some(variables)
}

fn one(variable: &Reader<'_>, request: &'static Object) -> Option<Varying> {
    let field = variable.required(&FIELD).and_then(|pointer| varied_field(request, pointer, &variable.place_of(&FIELD)));
    let name = match variable.optional(&NAME)? {
        Some(name) if !is_name(name) => {
            let place = variable.place_of(&NAME);
            place.fault("must have letters of English, digits and underscores, and no digit first");
            return None;
        }
        given => given.map(str::to_owned),
    };
    let (from, to, start) = (variable.required(&FROM), variable.required(&TO), variable.optional(&START));
    let spacing = variable.or_default(&SPACING);
    let (path, number) = field?;
    if number.is_whole() {
        variable
            .place_of(&FIELD)
            .fault("is a whole number, which this search does not step through; ask for each, or use `/v1/sweep`");
        return None;
    }
    let (from, to, start) = (from?, to?, start?);
    let ends = [(&FROM, Some(from)), (&TO, Some(to)), (&START, start)];
    let wrong =
        ends.iter().filter(|(field, value)| value.is_some_and(|value| number.check(&variable.place_of(field), value).is_none()));
    if wrong.count() > 0 {
        return None;
    }
    if from >= to {
        variable.place_of(&TO).fault("must be above `from`");
        return None;
    }
    let spacing = spacing?;
    if spacing == Spacing::Logarithmic && from <= 0.0 {
        variable.place_of(&FROM).fault("must be above 0, because steps are of the logarithm");
        return None;
    }
    if start.is_some_and(|start| !(from..=to).contains(&start)) {
        variable.place_of(&START).fault("must lie between `from` and `to`");
        return None;
    }
    let name = name.or_else(|| path.names().last().cloned())?;
    Some(Varying { path, name, range: Variable { from, to, start, spacing } })
}

/// Whether the names of the variables mean nothing else in a formula; a name that does is reported. A variable that is itself the
/// quantity of that name, such as the slip, may have it.
pub(super) fn mean_nothing_else(object: &Reader<'_>, variables: &[Varying], columns: &[&'static str]) -> bool {
    let mut is_sound = true;
    for (i, Varying { path, name, .. }) in variables.iter().enumerate() {
        let is_quantity = columns.contains(&name.as_str()) && path.dotted() != *name;
        let quantity = is_quantity.then_some("a quantity of the answer");
        if let Some(meaning) =
            Expression::own_meaning(name).map(|own| format!("{own} of formulas")).or(quantity.map(str::to_owned))
        {
            let detail = format!("`{name}` is {meaning}; give the variable another `{}`", NAME.name);
            object.place_of(&VARIABLES).item(i).field(NAME.name).fault(detail);
            is_sound = false;
        }
    }
    is_sound
}

fn is_name(name: &str) -> bool {
    let is_letter = |c: char| c.is_ascii_alphabetic() || c == '_';
    name.starts_with(is_letter) && name.chars().all(|c| is_letter(c) || c.is_ascii_digit())
}

/// Reports a fault of the field of a variable.
pub(super) fn fault_of_field(object: &Reader<'_>, variable: usize, detail: &str) {
    object.place_of(&VARIABLES).item(variable).field(FIELD.name).fault(detail);
}
