//! The columns of a set of measurements.

use std::borrow::Cow;

use serde::{Serialize, Serializer};
use utoipa::openapi::schema::ObjectBuilder;
use utoipa::openapi::{Ref, RefOr, Schema};
use utoipa::{PartialSchema, ToSchema};

use crate::quantity::{About, Columns, Field, Shape, Values};
use crate::validation::{COMPARED, Compared, Prediction, Record, all_runs};

/// Columns of one length, measured and predicted.
#[derive(Debug, Serialize, ToSchema)]
pub(super) struct ValidationColumns {
    /// Slip ratio s (–), in the plane of the wheel.
    #[schema(value_type = Vec<f64>)]
    slip: Values,
    /// Vertical load W (N).
    #[schema(value_type = Vec<f64>)]
    normal_load_n: Values,
    /// Slip ratio (–) as published where the wheel moved at a slip angle: of the speed of travel, not of its component along
    /// the heading.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Vec<f64>, required = false)]
    travel_slip: Option<Values>,
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    contact: Option<ContactColumns>,
    pub(super) measured: ForceColumns,
    pub(super) predicted: PredictedColumns,
}

/// The contact where it goes with the published slip: rule `wong_reece` with `c2` 0.
#[derive(Debug, Serialize, ToSchema)]
struct ContactColumns {
    /// θm/θ1 (–).
    #[schema(value_type = Vec<f64>)]
    c1: Values,
    /// θ2/θ1 (–).
    #[schema(value_type = Vec<f64>)]
    c3: Values,
}

/// Columns of what is compared.
#[derive(Debug)]
pub(super) struct OfSet;

pub(super) type ForceColumns = Columns<OfSet>;

impl Shape for OfSet {
    const NAME: &'static str = "ValidationForces";
    const DOC: &'static str = "Null where a quantity was not measured or a point has no solution.";

    fn fields() -> Vec<Field> {
        let field = |Compared { about, sideways, .. }: &'static Compared| Field {
            present: sideways.then_some("where the wheel moved at a slip angle"),
            ..Field::or_null(about)
        };
        COMPARED.iter().map(field).collect()
    }
}

/// The columns of every run.
#[derive(Debug)]
pub(super) struct PredictedColumns(Vec<(&'static str, ForceColumns)>);

impl Serialize for PredictedColumns {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(series, columns)| (series, columns)))
    }
}

impl PartialSchema for PredictedColumns {
    fn schema() -> RefOr<Schema> {
        const DOC: &str = "By method, and by the options that differ from the defaults of a request; the sinkage is solved for the load, save under a `known_load`: there it is the measured one, or follows from that of the first point by (18), and the load takes the place of the modulus. \
                           Sets at a slip angle have no closed forms; sets of braking wheels have both laws of braking.";
        let runs = all_runs().into_iter();
        let object = runs.fold(ObjectBuilder::new().description(Some(DOC)), |object, run| {
            object.property(run.series, Ref::from_schema_name(ForceColumns::name()))
        });
        object.required("quadrature").into()
    }
}

impl ToSchema for PredictedColumns {
    fn name() -> Cow<'static, str> {
        "PredictedColumns".into()
    }

    fn schemas(found: &mut Vec<(String, RefOr<Schema>)>) {
        found.push((ForceColumns::name().into_owned(), ForceColumns::schema()));
    }
}

/// The columns of a set, each by `values`.
fn columns(record: &Record, values: impl Fn(&Compared) -> Vec<f64>) -> ForceColumns {
    let is_sideways = record.side_slip.is_some();
    let there = COMPARED.iter().filter(|compared| is_sideways || !compared.sideways);
    Columns::new(there.map(|compared| (&compared.about, Values::Numbers(values(compared)))).collect::<Vec<(&About, _)>>())
}

impl ValidationColumns {
    pub(super) fn of(record: &Record, predictions: &[Prediction]) -> Self {
        let points = record.points();
        let (published, load) = (&points.slip, points.load());
        let contact = record.side_slip.map(|side| ContactColumns {
            c1: Values::Numbers(published.iter().map(|slip| side.c1(*slip)).collect()),
            c3: Values::Numbers(published.iter().map(|slip| side.c3(*slip)).collect()),
        });
        let predicted = |prediction: &Prediction| {
            (prediction.run.series, columns(record, |compared| compared.predicted(prediction.points(), &load)))
        };
        Self {
            slip: Values::Numbers(record.slip()),
            travel_slip: record.side_slip.is_some().then(|| Values::Numbers(published.clone())),
            contact,
            measured: columns(record, |compared| compared.measured(points, &load)),
            predicted: PredictedColumns(predictions.iter().map(predicted).collect()),
            normal_load_n: Values::Numbers(load),
        }
    }

    /// The slips and the load, then `measured.` and `predicted.series.` with the name of each column.
    pub(super) fn named(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let mut columns = vec![(Cow::from("slip"), self.slip.numbers()), ("normal_load_n".into(), self.normal_load_n.numbers())];
        columns.extend(self.travel_slip.iter().map(|slip| ("travel_slip".into(), slip.numbers())));
        if let Some(ContactColumns { c1, c3 }) = &self.contact {
            columns.extend([("contact.c1".into(), c1.numbers()), ("contact.c3".into(), c3.numbers())]);
        }
        columns.extend(self.measured.named().map(|(name, column)| (format!("measured.{name}").into(), column)));
        for (series, forces) in self.predicted.each() {
            columns.extend(forces.named().map(|(name, column)| (format!("predicted.{series}.{name}").into(), column)));
        }
        columns
    }
}

impl PredictedColumns {
    /// Each run with its columns.
    pub(super) fn each(&self) -> impl Iterator<Item = (&'static str, &ForceColumns)> {
        self.0.iter().map(|(series, columns)| (*series, columns))
    }
}
