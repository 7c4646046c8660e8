//! What the columns of a batch are: fields of a request, and others that its answer repeats or leaves out.

use std::fmt::Display;

use arrow_schema::DataType;
use terramechanics_reading::{FieldFault, Node, Object, Path, shortened};
use utoipa::openapi::RefOr;
use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::{Schema, SchemaType, Type};

use crate::series::{ExtraColumns, LEAVING_OUT};
use crate::words::{HINTS, nearest};

/// Fields that may be columns: as many as a row has bits for them, and more than any request has.
pub(super) const MOST_FIELDS: usize = 64;

/// Columns that the answer repeats in front of its own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Echo {
    /// All that are not left out.
    All,
    /// Those of these names.
    Names(Vec<String>),
}

/// What is wanted of the columns.
#[derive(Debug, Clone)]
pub(crate) struct Wanted {
    /// The request that a row stands for.
    pub(crate) object: &'static Object,
    /// What all rows have in common.
    pub(crate) constants: Node<'static>,
    pub(crate) echo: Echo,
    pub(crate) extra: ExtraColumns,
    /// Whether columns of an Arrow stream are repeated as they come.
    pub(crate) keeps_arrays: bool,
    /// The columns of the answer.
    pub(crate) answered: Vec<&'static str>,
}

/// What the cells of a column with a type are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CellKind {
    Numbers,
    Texts,
    Flags,
    Nothing,
    Others,
}

/// A name that a column may have.
struct Known {
    name: String,
    /// Whether it stands for a number and nothing else.
    only_number: bool,
}

/// The columns of a body.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    /// The fields among them.
    pub(crate) fields: Vec<Path>,
    /// Of each field, whether it is a number or may be one.
    pub(super) is_number: Vec<bool>,
    /// Of each field, whether it is a number and nothing else.
    only_number: Vec<bool>,
    /// Of each column the place among the fields, if it is one.
    pub(super) field_of: Vec<Option<usize>>,
    /// Of each column the place among those that the answer repeats.
    pub(super) echo_of: Vec<Option<usize>>,
    /// The names of those.
    pub(crate) echoed: Vec<String>,
    /// Of each of those, of what kind it is where it is repeated as it comes; else it is a text.
    pub(crate) kept: Vec<Option<DataType>>,
    /// The fields that a request may have.
    known: Vec<String>,
    /// Those objects among them that each request has.
    required: Vec<&'static str>,
}

impl Columns {
    /// Their number, with those that are no fields.
    pub(crate) fn len(&self) -> usize {
        self.field_of.len()
    }

    /// That a field, by its place, takes a column of such cells.
    ///
    /// # Errors
    /// Which columns it takes.
    pub(super) fn takes(&self, field: usize, cells: CellKind, kind: impl Display) -> Result<(), FieldFault> {
        let detail = match cells {
            CellKind::Numbers | CellKind::Nothing => return Ok(()),
            _ if self.only_number[field] => {
                format!("must be a column of numbers (integers, Float32 or Float64), not of {kind}")
            }
            CellKind::Texts | CellKind::Flags => return Ok(()),
            CellKind::Others => format!("must be a column of numbers, booleans, texts or a dictionary of texts, not of {kind}"),
        };
        Err(FieldFault::new(self.fields[field].pointer(), detail))
    }

    /// Whether a row may mend what is wrong with the field at `pointer` by its words, such as another preset or method.
    pub(crate) fn may_mend(&self, pointer: &str) -> bool {
        let dotted = pointer.trim_start_matches('/').replace('/', ".");
        let is_known = |known: &String| known.strip_prefix(&dotted).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
        if self.required.contains(&dotted.as_str()) || !self.known.iter().any(is_known) {
            return false;
        }
        let around = dotted.split('.').next().unwrap_or_default();
        let mut words = self.fields.iter().zip(&self.is_number).filter(|(_, is_number)| !**is_number);
        words.any(|(path, _)| matches!(path.names(), [first, rest @ ..] if rest.is_empty() || first == around))
    }
}

impl Wanted {
    /// The columns of these names, or all that is wrong with them.
    pub(super) fn columns(&self, names: &[String]) -> Result<Columns, Vec<FieldFault>> {
        let mut columns = Columns::default();
        let mut faults = Vec::new();
        let known = self.names();
        columns.required = self.object.fields().filter(|field| field.is_required()).map(|field| field.name()).collect();
        for (i, name) in names.iter().enumerate() {
            let pointer = || Path::of_dotted(name).map_or_else(String::new, |path| path.pointer());
            let mut refuse = |detail: String| faults.push(FieldFault::new(pointer(), detail));
            if names[..i].contains(name) {
                refuse(format!("the column `{}` is there more than once", shortened(name)));
            }
            let field = self.field(name, &known).unwrap_or_else(|detail| {
                refuse(detail);
                None
            });
            columns.field_of.push(field.as_ref().map(|_| columns.fields.len()));
            let is_known = field.is_some();
            if let Some((path, is_number)) = field {
                columns.is_number.push(is_number);
                columns.only_number.push(known.iter().any(|known| known.name == *name && known.only_number));
                columns.fields.push(path);
            }
            let is_wanted = match &self.echo {
                Echo::All => is_known || self.extra == ExtraColumns::Ignore,
                Echo::Names(wanted) => wanted.contains(name),
            };
            columns.echo_of.push(is_wanted.then_some(columns.echoed.len()));
            columns.echoed.extend(is_wanted.then(|| self.echoed(name)));
            columns.kept.extend(is_wanted.then_some(None));
        }
        if columns.fields.len() > MOST_FIELDS {
            faults.push(FieldFault::new("", format!("a batch may have at most {MOST_FIELDS} columns that are fields")));
        }
        faults.extend(self.absent(names));
        for (_, name) in columns.echoed.iter().enumerate().filter(|(i, name)| columns.echoed[..*i].contains(name)) {
            faults.push(FieldFault::new("/echo", format!("two columns would be repeated as `{}`; rename one", shortened(name))));
        }
        columns.known = known.into_iter().map(|known| known.name).collect();
        if faults.is_empty() { Ok(columns) } else { Err(faults) }
    }

    /// The field that a column is, and whether it is a number or may be one; none of a column that is not read; else what is wrong
    /// with it.
    fn field(&self, name: &str, known: &[Known]) -> Result<Option<(Path, bool)>, String> {
        let path = Path::of_dotted(name).filter(|_| known.iter().any(|known| known.name == name));
        match path {
            Some(path) if is_given(&self.constants, &path) => Err("is given in the query as well".to_owned()),
            Some(path) => {
                let is_number = self.object.number_at(&path, &HINTS).is_ok();
                Ok(Some((path, is_number)))
            }
            None if self.is_let_through(name) => Ok(None),
            None => Err(
                match known
                    .iter()
                    .map(|known| &known.name)
                    .find(|known| known.strip_prefix(name).is_some_and(|rest| rest.starts_with('.')))
                {
                    Some(within) => format!("is an object; a column is one of its fields, such as `{within}`"),
                    None => format!("{}; {}", unknown(name, known), self.way_out(name)),
                },
            ),
        }
    }

    /// The name under which a column is repeated: its own, unless the answer may have a column of that name.
    fn echoed(&self, name: &str) -> String {
        if self.answered.contains(&name) { format!("echo.{name}") } else { name.to_owned() }
    }

    /// What to ask for where a column is to be no field.
    fn way_out(&self, name: &str) -> String {
        match &self.echo {
            Echo::All => "with extra_columns=ignore it is repeated and not read".to_owned(),
            Echo::Names(_) => format!("{LEAVING_OUT}, and echo={} repeats it", shortened(name)),
        }
    }

    /// Whether a column that is no field is no mistake.
    fn is_let_through(&self, name: &str) -> bool {
        let is_echoed = matches!(&self.echo, Echo::Names(names) if names.iter().any(|known| known == name));
        is_echoed || self.extra == ExtraColumns::Ignore
    }

    /// The names that columns may have.
    fn names(&self) -> Vec<Known> {
        let mut parameters = Vec::new();
        self.object.parameters("", &mut parameters);
        let known = parameters.into_iter().map(|Parameter { name, schema, .. }| {
            let only_number = matches!(schema, Some(RefOr::T(Schema::Object(utoipa::openapi::Object { schema_type, .. }))) if is_of_numbers(&schema_type));
            Known { name, only_number }
        });
        known.collect()
    }

    /// The columns that are to be repeated and are not there.
    fn absent(&self, names: &[String]) -> Vec<FieldFault> {
        let Echo::Names(wanted) = &self.echo else { return Vec::new() };
        let known: Vec<&str> = names.iter().map(String::as_str).collect();
        let absent = wanted.iter().filter(|name| !names.contains(name)).map(|name| {
            let meant = nearest(name, &known).map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
            FieldFault::new("/echo", format!("the body has no column `{}`{meant}", shortened(name)))
        });
        absent.collect()
    }
}

fn is_of_numbers(of: &SchemaType) -> bool {
    matches!(of, SchemaType::Type(Type::Number | Type::Integer))
}

/// What is said of a column that is no field.
fn unknown(name: &str, known: &[Known]) -> String {
    let known: Vec<&str> = known.iter().map(|known| known.name.as_str()).collect();
    let last = |name: &'_ str| name.rsplit_once('.').map_or(name.len(), |(_, last)| last.len());
    let own: Vec<&str> = known.iter().map(|known| &known[known.len() - last(known)..]).collect();
    let hint = HINTS.unknown_field(&name[name.len() - last(name)..], &own, &[]);
    let meant = match nearest(name, &known) {
        Some(near) => format!("; did you mean `{near}`?"),
        None if hint.starts_with("known") => String::new(),
        None => format!("; {hint}"),
    };
    let name = shortened(name);
    format!("unknown column `{name}`{meant}")
}

/// Whether something stands under a path.
fn is_given(constants: &Node<'_>, path: &Path) -> bool {
    let mut node = constants;
    for name in path.names() {
        let Node::Object(fields) = node else { return true };
        let Some((_, within)) = fields.iter().find(|(known, _)| known == name) else { return false };
        node = within;
    }
    true
}
