//! The quantities of operating points as columns.

use terramechanics::{Motion, SlipSweep, WheelOnSoil};

use super::columns::{Columns, Shape, Values};
use super::point::{OfPoint, Point, PointValue};
use super::schema::Field;
use super::{About, TABLE};

/// The rows of the table that an operating point has.
pub(crate) fn point_rows() -> impl Iterator<Item = (&'static About, OfPoint)> {
    TABLE.iter().filter_map(|quantity| Some((&quantity.about, quantity.point?)))
}

/// The columns of a sweep.
fn columns() -> impl Iterator<Item = (&'static About, PointValue)> {
    point_rows().filter(|(_, of)| of.part.is_column()).map(|(about, of)| (about, of.value))
}

/// The columns of rows of operating points; with those across the wheel where a slip angle was sent.
pub(crate) fn point_columns(is_sideways: bool) -> impl Iterator<Item = (&'static About, PointValue)> {
    columns().filter(move |(_, value)| is_sideways || !value.is_sideways())
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
            present: value.is_sideways().then_some("where a slip angle was sent"),
        };
        columns().map(field).collect()
    }
}

impl PointColumns {
    /// The columns of a sweep of a wheel that moves forward; with those across it where a slip angle was sent.
    pub(crate) fn of(sweep: &SlipSweep, system: &WheelOnSoil, is_sideways: bool) -> Self {
        let wanted: Vec<_> = point_columns(is_sideways).collect();
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
