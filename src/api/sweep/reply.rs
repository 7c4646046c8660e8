//! The answer of `/v1/sweep`.

use std::borrow::Cow;

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use utoipa::openapi::schema::{AdditionalProperties, ArrayBuilder, ObjectBuilder, Type};
use utoipa::openapi::{RefOr, Schema};
use utoipa::{PartialSchema, ToSchema};

use super::found::{FoundGrid, Running};
use crate::api::either;
use crate::compute::{Pace, Stop};
use crate::quantity::{Field, Values, object_of};
use crate::reply::AssumedReply;
use crate::varied::{RowStatus, Varied};
use crate::warning::Warning;

/// The forces over a grid.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Sweep)]
pub(crate) struct GridReply {
    columns: GridColumns,
    warnings: Vec<Warning>,
    /// What was assumed; absent where the request did not allow it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    assumed: Option<Vec<AssumedReply>>,
}

/// Columns of one length: those of the axes, those of the operation, and the status.
#[derive(Debug)]
pub(super) struct GridColumns {
    names: Vec<Cow<'static, str>>,
    columns: Vec<Values>,
    status: Vec<&'static str>,
}

/// Name of the column that says how a row went.
pub(super) const STATUS: &str = "status";

impl GridReply {
    /// All rows of a sweep, as columns.
    ///
    /// # Errors
    /// [`Stop`], where the work is to end.
    pub(super) fn of<R: Varied>(mut running: Running<R>, pace: &Pace) -> Result<Self, Stop> {
        let names: Vec<Cow<'static, str>> = names(&running).collect();
        let mut lists: Vec<Vec<f64>> = names.iter().map(|_| Vec::with_capacity(running.len())).collect();
        let mut status = Vec::with_capacity(running.len());
        let mut cells = Vec::with_capacity(names.len());
        loop {
            pace.look()?;
            cells.clear();
            let Some(of_row) = running.next_row(&mut cells, pace) else { break };
            lists.iter_mut().zip(&cells).for_each(|(list, cell)| list.push(*cell));
            status.push(of_row.name());
        }
        let FoundGrid { warnings, assumed, .. } = running.end();
        let assumed = assumed.map(|assumed| assumed.into_iter().map(AssumedReply::from).collect());
        let columns = lists.into_iter().map(Values::Numbers).collect();
        Ok(Self { columns: GridColumns { names, columns, status }, warnings, assumed })
    }
}

/// The names of the columns, save the status.
pub(super) fn names<R: Varied>(running: &Running<R>) -> impl Iterator<Item = Cow<'static, str>> + use<R> {
    let axes = running.axes().into_iter().map(Cow::Owned);
    let columns: Vec<_> = running.columns().iter().map(|about| Cow::Borrowed(about.name)).collect();
    axes.chain(columns)
}

impl Serialize for GridColumns {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.names.len() + 1))?;
        for (name, column) in self.names.iter().zip(&self.columns) {
            map.serialize_entry(name, column)?;
        }
        map.serialize_entry(STATUS, &self.status)?;
        map.end()
    }
}

impl PartialSchema for GridColumns {
    fn schema() -> RefOr<Schema> {
        const DOC: &str = "Columns of one length: one for each axis, named by its field with a dot between an object and its field \
                           (`wheel.radius_m`); those of the operation, null where a row has no answer; and `status`. A column that an \
                           axis has already stands there once.";
        let statuses = RowStatus::ALL.map(RowStatus::name);
        let status = ObjectBuilder::new().schema_type(Type::String).enum_values(Some(statuses));
        let status = ArrayBuilder::new().items(status).description(Some(
            "ok; invalid, where the values of the row make no request; no_solution, where the model has no answer; not_climbed, where no slip gives the pull that a rover needs; one that climbs only beyond its slip limit is ok, and `climbs` tells it. Warnings say why, counted by cause.",
        ));
        let axis =
            ArrayBuilder::new().items(ObjectBuilder::new().schema_type(Type::Number)).description(Some("The values of an axis."));
        object_of(DOC, &either::fields(), Field::column)
            .property(STATUS, status)
            .required(STATUS)
            .additional_properties(Some(AdditionalProperties::RefOr(axis.into())))
            .into()
    }
}

impl ToSchema for GridColumns {
    fn name() -> Cow<'static, str> {
        "GridColumns".into()
    }
}
