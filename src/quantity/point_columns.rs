//! The quantities of operating points as columns.

use terramechanics::{Motion, NormalStressFrom, Operation, SlipSweep};

use super::columns::{Columns, Shape, Values};
use super::point::{OfPoint, Point, PointValue};
use super::schema::Field;
use super::{About, TABLE};

/// The rows of the table that an operating point has.
pub(crate) fn point_rows() -> impl Iterator<Item = (&'static About, OfPoint)> {
    TABLE.iter().filter_map(|quantity| Some((&quantity.about, quantity.point?)))
}

/// The columns that operating points may have.
pub(crate) fn every_point_column() -> impl Iterator<Item = (&'static About, PointValue)> {
    point_rows().filter(|(_, of)| of.part.is_column() || of.value.is_under_load()).map(|(about, of)| (about, of.value))
}

/// The columns of operating points; with those across the wheel where a slip angle was sent, and with what the load shows of the
/// soil where it is known beside the sinkage.
pub(crate) fn point_columns(
    operation: &Operation,
    is_sideways: bool,
) -> impl Iterator<Item = (&'static About, PointValue)> + use<> {
    let under_load = operation.sinkage.normal_stress_from() == NormalStressFrom::Load;
    every_point_column().filter(move |(_, value)| (is_sideways || !value.is_sideways()) && (under_load || !value.is_under_load()))
}

/// Columns of operating points.
#[derive(Debug, Clone)]
pub(crate) struct OfPoints;

pub(crate) type PointColumns = Columns<OfPoints>;

impl Shape for OfPoints {
    const NAME: &'static str = "SweepColumns";
    const DOC: &'static str = "Columns of one length; null where a point has no solution or a coefficient is undefined.";

    fn fields() -> Vec<Field> {
        let field = |(about, value): (&'static About, PointValue)| Field {
            about,
            nullable: !matches!(value, PointValue::Asked(_)),
            present: match value {
                PointValue::Sideways(_) => Some("where a slip angle was sent"),
                PointValue::UnderLoad(_) => Some("where the load is known beside the sinkage"),
                PointValue::Asked(_) | PointValue::Found(_) | PointValue::OrNone(_) => None,
            },
        };
        every_point_column().map(field).collect()
    }
}

impl PointColumns {
    /// The columns of a sweep of a wheel that moves forward.
    pub(crate) fn of(sweep: &SlipSweep, operation: &Operation, is_sideways: bool) -> Self {
        let system = &operation.system;
        let wanted: Vec<_> = point_columns(operation, is_sideways).collect();
        let mut lists: Vec<Vec<f64>> = wanted.iter().map(|_| Vec::with_capacity(sweep.rows.len())).collect();
        for row in &sweep.rows {
            let point = row.point.as_ref().ok().map(|point| Point::of(system, Motion::forward(row.slip), point));
            for (list, (_, value)) in lists.iter_mut().zip(&wanted) {
                list.push(point.as_ref().map_or_else(|| value.without(row.slip), |point| value.at(point)));
            }
        }
        Self::new(wanted.into_iter().map(|(about, _)| about).zip(lists.into_iter().map(Values::Numbers)).collect())
    }
}
