//! A time series in the columns of a JSON body.

use std::borrow::Cow;

use serde::de::SeqAccess;
use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::{ArrayBuilder, ObjectBuilder, SchemaType, Type};
use utoipa::openapi::{RefOr, Schema};

use crate::series::{Cells, Column, Layout};
use crate::wire::{Entry, Field, Object, Scope, Spec, Wire, wire_object};

/// Samples that a JSON body may have; there is no limit to those of a stream.
const MOST: usize = 100_000;

/// Numbers over time, null where one is missing.
#[derive(Debug, Clone)]
pub(crate) struct Series {
    values: Vec<f64>,
    /// The first item that is neither, and what it is.
    wrong: Option<(usize, Cow<'static, str>)>,
}

/// The description of a column.
pub(crate) struct SeriesSpec(&'static str);

impl Spec for SeriesSpec {
    fn schema(&self) -> RefOr<Schema> {
        let items = ObjectBuilder::new().schema_type(SchemaType::from_iter([Type::Number, Type::Null]));
        ArrayBuilder::new().description(Some(self.0)).items(items).min_items(Some(1)).max_items(Some(MOST)).into()
    }

    /// None: what stands in a query goes with a body that is the series.
    fn parameters(&self, _: &str, _: &mut Vec<Parameter>) {}
}

impl Wire for Series {
    type Spec = SeriesSpec;
    const EXPECTED: &'static str = "an array of numbers";

    fn list<'de, A: SeqAccess<'de>>(mut list: A) -> Result<Option<Self>, A::Error> {
        let mut series = Self { values: Vec::new(), wrong: None };
        while let Some(item) = list.next_element::<Field<f64>>()? {
            let at = series.values.len();
            match item {
                _ if at > MOST => continue, // one more than allowed is kept, which the check refuses
                Field::Given(value) => series.values.push(value),
                Field::Wrong(found) => {
                    if found != "null" {
                        series.wrong.get_or_insert((at, found));
                    }
                    series.values.push(f64::NAN);
                }
                Field::Absent => {}
            }
        }
        Ok(Some(series))
    }
}

wire_object! {
    /// Samples over time, as columns of one length: `time_s`, with `slip` or both velocities. A null is a value that is missing: its row has no result.
    ColumnsDto as "TrackColumns" {
        time_s: Series = SeriesSpec("Time (s), not decreasing."),
        slip: Series = SeriesSpec("Slip ratio s (–), from −1 to 1."),
        forward_velocity_m_s: Series = SeriesSpec("Forward velocity v of the axle (m/s)."),
        angular_velocity_rad_s: Series = SeriesSpec("Angular velocity ω of the wheel (rad/s)."),
        sinkage_m: Series = SeriesSpec("Measured sinkage z (m); the forces are then those at it."),
        torque_n_m: Series = SeriesSpec("Measured torque T (N·m), positive when it turns the wheel forward."),
        normal_load_n: Series = SeriesSpec("Vertical load W (N)."),
    }
}

/// Samples in memory.
#[derive(Debug)]
pub(crate) struct Samples {
    columns: [Option<Vec<f64>>; Column::COUNT],
    pub(crate) count: usize,
    pub(crate) layout: Layout,
}

impl Samples {
    pub(crate) fn cells(&self, row: usize) -> Cells {
        self.columns.each_ref().map(|column| column.as_ref().map_or(f64::NAN, |values| values[row]))
    }
}

impl ColumnsDto {
    fn entries(&self) -> [Entry<'_, Series>; Column::COUNT] {
        [
            self.time_s(),
            self.slip(),
            self.forward_velocity_m_s(),
            self.angular_velocity_rad_s(),
            self.sinkage_m(),
            self.torque_n_m(),
            self.normal_load_n(),
        ]
    }

    /// The columns that were sent, right or wrong.
    pub(super) fn layout(&self) -> Layout {
        let mut layout = Layout::default();
        for (index, _) in self.entries().iter().enumerate().filter(|(_, entry)| entry.is_present()) {
            layout.add(index);
        }
        layout
    }

    pub(super) fn check(&self, place: &Scope<'_>) -> Option<Samples> {
        self.report_oddities(place);
        let columns = self.entries().map(|entry| entry.checked(place));
        let mut count = None;
        let mut complete = true;
        for (entry, column) in self.entries().iter().zip(&columns) {
            let Some(values) = column else {
                complete &= !entry.is_present();
                continue;
            };
            let expected = *count.get_or_insert(values.len());
            if values.len() != expected {
                let found = values.len();
                place.field(entry.name).fault(format_args!("has {found} values, the columns before it have {expected}"));
                complete = false;
            }
        }
        complete.then_some(Samples { columns, count: count?, layout: self.layout() })
    }
}

impl Entry<'_, Series> {
    fn checked(&self, object: &Scope<'_>) -> Option<Vec<f64>> {
        let series = self.given(object)?;
        let place = object.field(self.name);
        if !(1..=MOST).contains(&series.values.len()) {
            place.fault(format_args!("must have from 1 to {MOST} values; a longer series can be sent as a stream"));
            return None;
        }
        if let Some((at, found)) = &series.wrong {
            place.item(*at).fault(format_args!("must be a number or null, not {found}"));
            return None;
        }
        Some(series.values.clone())
    }
}
