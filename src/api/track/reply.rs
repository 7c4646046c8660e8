//! The answer of `/v1/track`.

use serde::Serialize;
use terramechanics::Event;
use utoipa::ToSchema;

use super::found::FoundTrack;
use crate::quantity::SampleColumns;
use crate::reply::AssumedReply;
use crate::warning::Warning;

/// A wheel over time.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Track)]
pub(crate) struct TrackReply {
    columns: SampleColumns,
    /// When the wheel was stuck; the first thousand times.
    events: Vec<EventReply>,
    warnings: Vec<Warning>,
    /// What was assumed; absent where the request did not allow it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    assumed: Option<Vec<AssumedReply>>,
}

impl TrackReply {
    /// The columns of a run with its findings.
    pub(crate) fn of(columns: SampleColumns, FoundTrack { events, warnings, assumed, .. }: FoundTrack) -> Self {
        let assumed = assumed.map(|assumed| assumed.into_iter().map(AssumedReply::from).collect());
        Self { columns, events: events.iter().map(EventReply::from).collect(), warnings, assumed }
    }
}

/// A time in which the wheel was stuck.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = TrackEvent)]
pub(crate) struct EventReply {
    /// `stall`: the slip stayed high; `entrapment`: the wheel sank deep.
    #[schema(example = "stall")]
    pub(crate) code: &'static str,
    /// Index of the first sample, from 0.
    pub(crate) row: u64,
    /// Its time (s).
    pub(crate) from_s: f64,
    /// Time of its last sample (s).
    pub(crate) to_s: f64,
}

impl From<&Event> for EventReply {
    fn from(event: &Event) -> Self {
        Self { code: event.kind.code(), row: event.row, from_s: event.from, to_s: event.to }
    }
}
