//! What the operation gives at a point, and along a trade-off.

use std::borrow::Cow;

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use terramechanics_optimum::StopReason;
use utoipa::openapi::schema::{AdditionalProperties, ArrayBuilder, ObjectBuilder, Type};
use utoipa::openapi::{RefOr, Schema};
use utoipa::{PartialSchema, ToSchema};

use super::stop::StopReply;
use crate::api::either;
use crate::quantity::{About, Field, Values, object_of};

/// What the operation gives at a point.
#[derive(Debug)]
pub(super) struct Quantities(pub(super) Vec<(&'static About, f64)>);

/// Columns of one length: the goals, the variables, and what the operation gives.
#[derive(Debug)]
pub(super) struct FrontColumns {
    columns: Vec<(String, Values)>,
    stops: Vec<&'static str>,
}

/// Names of the columns that say whether a point is what was sought: whether it keeps all constraints, and whether its search ended
/// by itself. 1 or 0, as a table has no other words.
pub(super) const MARKS: [&str; 2] = ["feasible", "converged"];

/// What they mean.
const MARKED: [&str; 2] = [
    "1 where the point keeps all constraints. All points of a curve do; where none does, the answer is the one that misses them least.",
    "1 where the search of the point ended by itself, else 0.",
];

/// Name of the column that says why a search ended.
const STOP: &str = "stop_reason";

impl Serialize for Quantities {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let values = self.0.iter().map(|(about, value)| (about.name, value.is_finite().then_some(value)));
        serializer.collect_map(values)
    }
}

impl PartialSchema for Quantities {
    fn schema() -> RefOr<Schema> {
        object_of("What the operation gives at this point; null where a quantity has no value.", &either::fields(), Field::number)
            .into()
    }
}

impl ToSchema for Quantities {
    fn name() -> Cow<'static, str> {
        "OptimumQuantities".into()
    }
}

impl FrontColumns {
    pub(super) fn of(columns: Vec<(String, Vec<f64>)>, stops: &[StopReason]) -> Self {
        let marks = [vec![1.0; stops.len()], stops.iter().map(|stop| f64::from(u8::from(stop.is_converged()))).collect()];
        let marks = MARKS.into_iter().map(str::to_owned).zip(marks);
        let columns = columns.into_iter().chain(marks).map(|(name, values)| (name, Values::Numbers(values))).collect();
        Self { columns, stops: stops.iter().map(|stop| StopReply::from(*stop).name()).collect() }
    }

    pub(super) fn as_table(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        self.columns.iter().map(|(name, values)| (name.clone().into(), values.numbers())).collect()
    }
}

impl Serialize for FrontColumns {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.columns.len() + 1))?;
        for (name, column) in &self.columns {
            map.serialize_entry(name, column)?;
        }
        map.serialize_entry(STOP, &self.stops)?;
        map.end()
    }
}

impl PartialSchema for FrontColumns {
    fn schema() -> RefOr<Schema> {
        const DOC: &str = "Columns of one length, from the best of the first goal to the best of the second: `objective` and `against`; \
                           one for each variable, named by its field with a dot between an object and its field \
                           (`wheel.radius_m`); those of the operation; `feasible`, `converged` and, save in a table, `stop_reason`.";
        let numbers = |meaning: &str| {
            ArrayBuilder::new().items(ObjectBuilder::new().schema_type(Type::Number)).description(Some(meaning.to_owned()))
        };
        let stop = ObjectBuilder::new().schema_type(Type::String).enum_values(Some([
            StopReply::SmallStep.name(),
            StopReply::Evaluations.name(),
            StopReply::Rounding.name(),
        ]));
        let object = object_of(DOC, &either::fields(), Field::column);
        let object =
            MARKS.into_iter().zip(MARKED).fold(object, |object, (name, of)| object.property(name, numbers(of)).required(name));
        object
            .property("objective", numbers("The first goal."))
            .required("objective")
            .property("against", numbers("The second goal."))
            .required("against")
            .property(STOP, ArrayBuilder::new().items(stop).description(Some("Why the search of each point ended.")))
            .required(STOP)
            .additional_properties(Some(AdditionalProperties::RefOr(numbers("The values of a variable.").into())))
            .into()
    }
}

impl ToSchema for FrontColumns {
    fn name() -> Cow<'static, str> {
        "TradeOffColumns".into()
    }
}
