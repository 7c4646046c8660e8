//! A time series in the columns of a JSON body.

use std::borrow::Cow;

use serde::de::SeqAccess;
use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::{ArrayBuilder, ObjectBuilder, SchemaType, Type};
use utoipa::openapi::{RefOr, Schema};

use crate::series::{Column, ExtraColumns, Layout, MOST_IN_COLUMNS, Row};
use crate::wire::{Entry, Field, Scope, Spec, Wire, wire_object};

/// Numbers over time, null where one is missing.
#[derive(Debug, Clone)]
pub(crate) struct Signal {
    values: Vec<f64>,
    /// The first item that is neither, and what it is.
    wrong: Option<(usize, Cow<'static, str>)>,
}

/// The description of a column.
pub(crate) struct SignalSpec(&'static str);

impl Spec for SignalSpec {
    fn schema(&self) -> RefOr<Schema> {
        let items = ObjectBuilder::new().schema_type(SchemaType::from_iter([Type::Number, Type::Null]));
        ArrayBuilder::new().description(Some(self.0)).items(items).min_items(Some(1)).max_items(Some(MOST_IN_COLUMNS)).into()
    }

    /// None: what stands in a query goes with a body that is the series.
    fn parameters(&self, _: &str, _: &mut Vec<Parameter>) {}
}

impl Wire for Signal {
    type Spec = SignalSpec;
    const EXPECTED: &'static str = "an array of numbers";

    fn list<'de, A: SeqAccess<'de>>(mut list: A) -> Result<Option<Self>, A::Error> {
        let mut signal = Self { values: Vec::new(), wrong: None };
        while let Some(item) = list.next_element::<Field<f64>>()? {
            let at = signal.values.len();
            match item {
                _ if at > MOST_IN_COLUMNS => continue, // one more than allowed is kept, which the check refuses
                Field::Given(value) => signal.values.push(value),
                Field::Wrong(found) => {
                    if found != "null" {
                        signal.wrong.get_or_insert((at, found));
                    }
                    signal.values.push(f64::NAN);
                }
                Field::Absent => {}
            }
        }
        Ok(Some(signal))
    }
}

wire_object! {
    /// Samples over time, as columns of one length: `time_s`, with `slip` or both velocities. A null is a value that is missing: its row has no result.
    ColumnsDto as "TrackColumns" {
        time_s: Signal = SignalSpec("Time (s), not decreasing."),
        slip: Signal = SignalSpec("Slip ratio s (–), from −1 to 1."),
        forward_velocity_m_s: Signal = SignalSpec("Forward velocity v of the axle (m/s)."),
        angular_velocity_rad_s: Signal = SignalSpec("Angular velocity ω of the wheel (rad/s)."),
        sinkage_m: Signal = SignalSpec("Measured sinkage z (m); the forces are then those at it."),
        torque_n_m: Signal = SignalSpec("Measured torque T (N·m), positive when it turns the wheel forward."),
        normal_load_n: Signal = SignalSpec("Vertical load W (N)."),
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
    pub(crate) fn row(&self, index: usize) -> Row {
        let cells = self.columns.each_ref().map(|column| column.as_ref().map_or(f64::NAN, |values| values[index]));
        Row { cells, unreadable: false }
    }
}

impl ColumnsDto {
    /// In the order of [`Column::NAMES`].
    fn entries(&self) -> [Entry<'_, Signal>; Column::COUNT] {
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

    pub(super) fn check(&self, extra: ExtraColumns, place: &Scope<'_>) -> Option<Samples> {
        extra.report(self, place);
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

impl Entry<'_, Signal> {
    fn checked(&self, object: &Scope<'_>) -> Option<Vec<f64>> {
        let signal = self.given(object)?;
        let place = object.field(self.name);
        if !(1..=MOST_IN_COLUMNS).contains(&signal.values.len()) {
            place.fault(format_args!("must have from 1 to {MOST_IN_COLUMNS} values; a longer series can be sent as a stream"));
            return None;
        }
        if let Some((at, found)) = &signal.wrong {
            place.item(*at).fault(format_args!("must be a number or null, not {found}"));
            return None;
        }
        Some(signal.values.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_columns_of_a_body_are_in_the_order_of_their_names() {
        assert_eq!(ColumnsDto::default().entries().map(|entry| entry.name), Column::NAMES);
    }
}
