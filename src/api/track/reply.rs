//! The answer of `/v1/track`.

use serde::Serialize;
use terramechanics::Event;
use utoipa::ToSchema;

use super::found::FoundTrack;
use crate::quantity::SampleColumns;
use crate::reply::AssumedReply;
use crate::request::circles::words;
use crate::warning::Warning;

/// A wheel over time.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Track)]
pub(crate) struct TrackReply {
    #[serde(flatten)]
    head: HeadReply,
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
    pub(crate) fn of(columns: SampleColumns, found: FoundTrack) -> Self {
        let head = HeadReply::of(&found);
        let FoundTrack { events, warnings, assumed, .. } = found;
        Self {
            head,
            columns,
            events: events.iter().map(EventReply::from).collect(),
            warnings,
            assumed: assumed.map(|assumed| assumed.into_iter().map(AssumedReply::from).collect()),
        }
    }
}

/// What holds for all samples: in every form of the answer.
#[derive(Debug, Clone, Copy, Serialize, ToSchema)]
#[schema(as = TrackHead)]
pub(crate) struct HeadReply {
    /// Circle on which the shear displacement was counted: shearing or rim; null where the method counts none.
    #[schema(required = true, example = "shearing")]
    shear_displacement_radius: Option<&'static str>,
    /// Circle on which the slip was counted: rim, shearing or lug_tip.
    #[schema(example = "rim")]
    slip_radius: &'static str,
    /// What the normal stress follows from: the pressure–sinkage law of the soil, or the load, which was known beside the sinkage.
    #[schema(example = "soil")]
    normal_stress_from: &'static str,
}

impl HeadReply {
    pub(crate) fn of(found: &FoundTrack) -> Self {
        let (shear_displacement_radius, slip_radius) = words(found.circles);
        Self { shear_displacement_radius, slip_radius, normal_stress_from: found.normal_stress_from.name() }
    }

    /// Each by its name.
    pub(crate) fn named(self) -> [(&'static str, &'static str); 3] {
        let Self { shear_displacement_radius, slip_radius, normal_stress_from } = self;
        [
            ("shear_displacement_radius", shear_displacement_radius.unwrap_or_default()),
            ("slip_radius", slip_radius),
            ("normal_stress_from", normal_stress_from),
        ]
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
