//! A time series in the columns of a JSON body.

use terramechanics::Channel;
use terramechanics_reading::{Field, Number, Numbers, Object, Reader, group};

use crate::reply::MOST_IN_COLUMNS;
use crate::series::{Column, Layout, Row};

const fn signal(column: Column, unit: &'static str, meaning: &'static str) -> Field<Numbers> {
    let numbers = Numbers::new(Number::any(unit), 1, MOST_IN_COLUMNS).with_gaps();
    Field::new(column.name(), meaning, Numbers { advice: "; a longer series can be sent as a stream", ..numbers })
}

/// In the order of [`Column::NAMES`].
static SIGNALS: [Field<Numbers>; Column::COUNT] = [
    signal(Column::Time, "s", "Time (s), not decreasing."),
    signal(Column::Slip, "1", "Slip ratio s (–), from −1 to 1."),
    signal(Column::ForwardVelocity, "m/s", "Forward velocity v of the axle (m/s)."),
    signal(Column::AngularVelocity, "rad/s", "Angular velocity ω of the wheel (rad/s)."),
    signal(Column::Sinkage, "m", "Measured sinkage z (m); the forces are then those at it."),
    signal(Column::Torque, "N.m", "Measured torque T (N·m), positive when it turns the wheel forward."),
    signal(Column::NormalLoad, "N", "Vertical load W (N)."),
];

/// The columns of a series.
pub(super) const COLUMNS: Object = Object {
    name: "TrackColumns",
    doc: "Samples over time, as columns of one length: `time_s`, with `slip` or both velocities. A null is a value that is missing: its row has no result.",
    groups: &[&group(&SIGNALS)],
};

impl From<Channel> for Column {
    fn from(channel: Channel) -> Self {
        match channel {
            Channel::Time => Self::Time,
            Channel::Slip => Self::Slip,
            Channel::ForwardVelocity => Self::ForwardVelocity,
            Channel::AngularVelocity => Self::AngularVelocity,
            Channel::Sinkage => Self::Sinkage,
            Channel::Torque => Self::Torque,
            Channel::NormalLoad => Self::NormalLoad,
        }
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

/// The columns that were sent, right or wrong.
pub(super) fn layout(columns: &Reader<'_>) -> Layout {
    let mut layout = Layout::default();
    for (index, _) in SIGNALS.iter().enumerate().filter(|(_, signal)| columns.has(signal)) {
        layout.add(index);
    }
    layout
}

/// The samples, of which every column has as many.
pub(super) fn read(object: &Reader<'_>) -> Option<Samples> {
    let columns = SIGNALS.each_ref().map(|signal| object.optional(signal));
    let mut count = None;
    let mut complete = true;
    for (signal, column) in SIGNALS.iter().zip(&columns) {
        let Some(values) = column else {
            complete = false;
            continue;
        };
        let Some(values) = values else { continue };
        let expected = *count.get_or_insert(values.len());
        if values.len() != expected {
            let found = values.len();
            object.place_of(signal).fault(format_args!("has {found} values, the columns before it have {expected}"));
            complete = false;
        }
    }
    let columns = columns.map(|column| column.flatten().map(<[f64]>::to_vec));
    complete.then_some(Samples { columns, count: count?, layout: layout(object) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_columns_of_a_body_are_in_the_order_of_their_names() {
        assert_eq!(SIGNALS.each_ref().map(|signal| signal.name), Column::NAMES);
    }
}
