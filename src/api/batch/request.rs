//! What a batch has beside its rows: fields that all rows have in common, and what becomes of its columns.

use axum::http::Uri;
use terramechanics_reading::{Declared, Faults, Field, FieldFault, Kind, Label, Node, Path, Scope, Word};
use utoipa::IntoParams;
use utoipa::openapi::path::{Parameter, ParameterIn};
use utoipa::openapi::schema::{ObjectBuilder, Type};

use crate::api::forces::ForcesCase;
use crate::extract::{parsed, taken};
use crate::problem::Problem;
use crate::quantity::{About, PointValue, every_point_column};
use crate::request::Request;
use crate::rows::{Echo, Wanted};
use crate::series::ExtraColumns;
use crate::words::HINTS;

use super::answers::STATUS;

const ECHO: Field<Label> = Field::new(
    "echo",
    "Columns of the body, with commas between, that stand again in front of those of the answer, such as an id; `all`: all of them, those that are no fields with `extra_columns=ignore`. A column of `echo` need not be a field. One that has the name of a column of the answer stands there as `echo.slip`, `echo.status` and so on.",
    Label,
);
const EXTRA_COLUMNS: Field<Word<ExtraColumns>> = Field::new(
    "extra_columns",
    "What becomes of columns that are no field and are not named in `echo`: refuse names them all; ignore does not read them, and only `echo=all` repeats them.",
    Word::new(&[("refuse", ExtraColumns::Refuse), ("ignore", ExtraColumns::Ignore)]).or(ExtraColumns::Refuse),
);
const ALL: &str = "all";

/// What is wanted of the columns of a batch, by its query.
///
/// # Errors
/// [`Problem::Invalid`] for what is wrong with `echo` and `extra_columns`. The fields of the request are checked with the rows.
pub(super) fn wanted(uri: &Uri) -> Result<Wanted, Problem> {
    let mut query = parsed(uri)?;
    let faults = Faults::new(&HINTS);
    let root = Scope::root(&faults);
    let extra = taken(&mut query, EXTRA_COLUMNS.name, &root)
        .and_then(|node| EXTRA_COLUMNS.kind.read(&node, root.field(EXTRA_COLUMNS.name)))
        .unwrap_or(ExtraColumns::Refuse);
    let echo = taken(&mut query, ECHO.name, &root).map(echo).unwrap_or(Echo::Names(Vec::new()));
    let list: Vec<FieldFault> = faults.into_list();
    if !list.is_empty() {
        return Err(Problem::Invalid(list));
    }
    let constants = query.into_node().detached();
    let answered = every_point_column().map(|(about, _)| about.name).chain([STATUS]).collect();
    Ok(Wanted { object: ForcesCase::OBJECT, constants, echo, extra, keeps_arrays: false, answered })
}

fn echo(node: Node<'_>) -> Echo {
    let names = match &node {
        Node::Number(value) => value.to_string(),
        other => other.text().unwrap_or_default().to_owned(),
    };
    match names.as_str() {
        ALL => Echo::All,
        names => Echo::Names(names.split(',').map(|name| name.trim().to_owned()).filter(|name| !name.is_empty()).collect()),
    }
}

/// The columns of the answer to rows with these fields: those of operating points that a row may have.
pub(super) fn answered(wanted: &Wanted, fields: &[Path]) -> impl Iterator<Item = (&'static About, PointValue)> {
    let is_constant =
        |name: &str| matches!(&wanted.constants, Node::Object(fields) if fields.iter().any(|(known, _)| known == name));
    let may_have = |name: &str| is_constant(name) || fields.iter().any(|path| path.dotted() == name);
    let goes_sideways = may_have("slip_angle_rad");
    let under_load = may_have("normal_load_n") && (may_have("sinkage_m") || may_have("static_sinkage_m"));
    let is_there = move |value: PointValue| match value {
        PointValue::Sideways(_) => goes_sideways,
        PointValue::UnderLoad(_) => under_load,
        PointValue::Asked(_) | PointValue::Found(_) | PointValue::OrNone(_) => true,
    };
    every_point_column().filter(move |(_, value)| is_there(*value))
}

/// The parameters of a batch for the contract: each field of the request, and what becomes of columns.
pub(crate) struct BatchParameters;

impl IntoParams for BatchParameters {
    fn into_params(_: impl Fn() -> Option<ParameterIn>) -> Vec<Parameter> {
        let mut found = Vec::new();
        ECHO.parameters("", &mut found);
        // A list of names, which has no bounds but those of the columns.
        let list = ObjectBuilder::new().schema_type(Type::String).build();
        found.iter_mut().for_each(|parameter| parameter.schema = Some(list.clone().into()));
        EXTRA_COLUMNS.parameters("", &mut found);
        ForcesCase::OBJECT.parameters("", &mut found);
        // Every field may be a column.
        found.iter_mut().for_each(|parameter| parameter.required = utoipa::openapi::Required::False);
        found
    }
}
