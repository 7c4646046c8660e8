//! The answer of `/v1/track`.

use serde::Serialize;
use terramechanics::{CautionTally, Channel, CulpritTally, Event, Status, Tally, TrackRow, Tracker};
use terramechanics_identification::{RunningStrength, StrengthTally};
use utoipa::ToSchema;

use super::warning::system_warnings;
use super::{Column, Warning};
use crate::request::TrackPlan;
use crate::series::{Column as SeriesColumn, SeriesFault, StrengthCells, Unreadable};

/// A wheel over time.
#[derive(Debug, Default, Serialize, ToSchema)]
#[schema(as = Track)]
pub(crate) struct TrackReply {
    columns: TrackColumns,
    /// When the wheel was stuck; the first thousand times.
    events: Vec<EventReply>,
    warnings: Vec<Warning>,
}

/// Columns of one length; null in all but the time where a sample has no result, for which `status` has the reason.
#[derive(Debug, Default, Serialize, ToSchema)]
#[schema(as = TrackedColumns)]
struct TrackColumns {
    /// Time (s), as it was sent.
    #[schema(value_type = Vec<Option<f64>>)]
    time_s: Column,
    /// Slip ratio s (–); told as well where only the forces have no solution.
    #[schema(value_type = Vec<Option<f64>>)]
    slip: Column,
    /// Sinkage z (m).
    #[schema(value_type = Vec<Option<f64>>)]
    sinkage_m: Column,
    /// Longitudinal force F_x, the drawbar pull (N).
    #[schema(value_type = Vec<Option<f64>>)]
    longitudinal_force_n: Column,
    /// Normal force F_z (N).
    #[schema(value_type = Vec<Option<f64>>)]
    normal_force_n: Column,
    /// Torque T about the axle (N·m).
    #[schema(value_type = Vec<Option<f64>>)]
    torque_n_m: Column,
    /// F_x/F_z (–).
    #[schema(value_type = Vec<Option<f64>>)]
    drawbar_coefficient: Column,
    /// F_x v/(T ω) (–), while the wheel drives; null at rest.
    #[schema(value_type = Vec<Option<f64>>)]
    tractive_efficiency: Column,
    /// Mechanical power T ω (W); null where only the slip is known.
    #[schema(value_type = Vec<Option<f64>>)]
    power_w: Column,
    /// Energy since the first sample (J), by the trapezoidal rule from one good sample to the next.
    #[schema(value_type = Vec<Option<f64>>)]
    energy_j: Column,
    /// ok; static: at rest, with the numbers of the rolling limit; or why there is no result: missing_value, unreadable, out_of_range, slip_out_of_range, opposite_rotation, time_backwards, no_solution.
    status: Vec<&'static str>,
    /// With a measured torque: F_x by Ding's coupled form from that torque and the load (N); null where one of them is missing, which `status` does not tell but a warning.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Vec<Option<f64>>>, nullable = false)]
    longitudinal_force_coupled_n: Option<Column>,
    /// With `strength`: cohesion c (Pa) of the line through the samples so far; null until two of them differ.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Vec<Option<f64>>>, nullable = false)]
    cohesion_pa: Option<Column>,
    /// With `strength`: tan φ (–).
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Vec<Option<f64>>>, nullable = false)]
    tan_friction: Option<Column>,
    /// With `strength`: variance of c (Pa²) from noise in the samples; null with fewer than three, and while c is held at 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Vec<Option<f64>>>, nullable = false)]
    cohesion_variance_pa2: Option<Column>,
    /// With `strength`: variance of tan φ (–), null as above.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Vec<Option<f64>>>, nullable = false)]
    tan_friction_variance: Option<Column>,
    /// With `strength`: covariance of c and tan φ (Pa), null as above.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Vec<Option<f64>>>, nullable = false)]
    cohesion_tan_friction_covariance_pa: Option<Column>,
}

impl TrackReply {
    /// A reply without rows, with a column for the coupled form or without.
    pub(crate) fn new(coupled: bool, strength: bool, rows: usize) -> Self {
        let mut reply = Self::default();
        for column in reply.columns.strength() {
            *column = strength.then(Column::default);
        }
        reply.columns.longitudinal_force_coupled_n = coupled.then(Column::default);
        for column in reply.columns.numbers() {
            column.0.reserve(rows);
        }
        reply
    }

    pub(crate) fn push(&mut self, row: &TrackRow, strength: Option<&StrengthCells>) {
        let columns = &mut self.columns;
        for (column, value) in columns.numbers().into_iter().zip(crate::series::numbers(row)) {
            column.0.push(value);
        }
        columns.status.push(row.status.code());
        if let Some(coupled) = &mut columns.longitudinal_force_coupled_n {
            coupled.0.push(row.longitudinal_coupled);
        }
        for (column, value) in columns.strength().into_iter().flatten().zip(strength.into_iter().flatten()) {
            column.0.push(*value);
        }
    }

    pub(crate) fn end(&mut self, findings: Findings) {
        self.events = findings.events;
        self.warnings = findings.warnings;
    }
}

impl TrackColumns {
    /// In the order of [`StrengthCells`].
    fn strength(&mut self) -> [&mut Option<Column>; 5] {
        [
            &mut self.cohesion_pa,
            &mut self.tan_friction,
            &mut self.cohesion_variance_pa2,
            &mut self.tan_friction_variance,
            &mut self.cohesion_tan_friction_covariance_pa,
        ]
    }

    /// In the order of [`crate::series::NUMBERS`].
    fn numbers(&mut self) -> [&mut Column; crate::series::NUMBERS.len()] {
        [
            &mut self.time_s,
            &mut self.slip,
            &mut self.sinkage_m,
            &mut self.longitudinal_force_n,
            &mut self.normal_force_n,
            &mut self.torque_n_m,
            &mut self.drawbar_coefficient,
            &mut self.tractive_efficiency,
            &mut self.power_w,
            &mut self.energy_j,
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
    /// Index of the sample, from 0, at which it began.
    pub(crate) row: u64,
    /// Its time (s).
    pub(crate) from_s: f64,
    /// Time of the last sample at which it held (s).
    pub(crate) to_s: f64,
}

impl From<&Event> for EventReply {
    fn from(event: &Event) -> Self {
        Self { code: event.kind.code(), row: event.row, from_s: event.from, to_s: event.to }
    }
}

/// What a run says of itself when it is over.
#[derive(Debug)]
pub(crate) struct Findings {
    pub(crate) rows: u64,
    pub(crate) events: Vec<EventReply>,
    pub(crate) warnings: Vec<Warning>,
}

impl Findings {
    /// The findings of a run that has ended.
    pub(crate) fn of(tracker: &Tracker, plan: &TrackPlan, unreadable: &Unreadable, strength: Option<&RunningStrength>) -> Self {
        let mut warnings = Vec::new();
        warnings.extend(unreadable.first.as_ref().map(|first| unread(tracker, unreadable.count, first)));
        for status in Status::ALL.into_iter().filter(|status| !status.is_good() && *status != Status::Unreadable) {
            warnings.extend(tracker.tally(status).map(|tally| without_result(tracker, status, tally)));
        }
        warnings.extend(tracker.missing_torque().map(|tally| without_coupled("missing_torque", SeriesColumn::Torque, tally)));
        warnings.extend(tracker.missing_load().map(|tally| without_coupled("missing_load", SeriesColumn::NormalLoad, tally)));
        if plan.lacks_load() {
            warnings.push(Warning::new("not_coupled", "a torque is measured but no load is known: give `normal_load_n`"));
        }
        warnings.extend(tracker.not_coupled().map(|tally| {
            let samples = counted(tally.count, tally.first_row);
            Warning::new("not_coupled", format!("no pull by the coupled form for {samples}: {}", reason(tally)))
        }));
        let good: u64 = Status::ALL
            .iter()
            .filter(|status| status.is_good())
            .filter_map(|&status| tracker.tally(status))
            .map(|tally| tally.count)
            .sum();
        warnings.extend(tracker.cautions().iter().map(|tally| caution(tally, good)));
        warnings.extend(system_warnings(&tracker.system().wheel, tracker.system().soil.params()));
        if tracker.has_moved_backward() {
            warnings.push(Warning::mirrored());
        }
        warnings.extend(strength.into_iter().flat_map(|running| of_strength(running.tally())));
        let (events, left_out) = tracker.events();
        if left_out > 0 {
            warnings.push(Warning::new("events_left_out", format!("{left_out} more events are not listed")));
        }
        Self { rows: tracker.rows(), events: events.iter().map(EventReply::from).collect(), warnings }
    }
}

/// What the samples do not tell of the strength.
fn of_strength(tally: &StrengthTally) -> impl Iterator<Item = Warning> + use<> {
    let StrengthTally { estimates, one_load, one_slip, no_cohesion, no_friction } = *tally;
    let counted = move |code: &'static str, count: u64, what: &str| {
        (count > 0).then(|| Warning::new(code, format!("in {count} of {estimates} rows with an estimate {what}")))
    };
    let none = (estimates == 0).then(|| {
        let detail = "no two samples that mobilise enough of the strength differ in their normal stress: there is no estimate";
        Warning::new("not_identifiable", detail)
    });
    let found = [
        Some(Warning::linearised_stresses()),
        none,
        counted(
            "single_load",
            one_load,
            "the samples that are remembered have one load: nothing but the assumed shape of the stresses tells cohesion from friction",
        ),
        counted(
            "single_slip",
            one_slip,
            "the samples that are remembered have one slip: a wrong shear_modulus_m changes both estimates by one factor and does not show",
        ),
        counted("at_bound", no_cohesion, "cohesion_pa is held at its lower bound 0, and has no variance"),
        counted("at_bound", no_friction, "tan_friction is held at its lower bound 0, and has no variance"),
    ];
    found.into_iter().flatten()
}

/// Cells that are no numbers, and the samples that have no result because of them.
fn unread(tracker: &Tracker, count: u64, first: &SeriesFault) -> Warning {
    let values = if count == 1 { "1 value is no number".to_owned() } else { format!("{count} values are no numbers, the first") };
    let samples = match tracker.tally(Status::Unreadable) {
        Some(tally) => format!("no result for {}", counted(tally.count, tally.first_row)),
        None => "no sample is without result for that".to_owned(),
    };
    Warning::new(Status::Unreadable.code(), format!("{samples}; {values}: {first}"))
}

fn without_result(tracker: &Tracker, status: Status, tally: &Tally) -> Warning {
    let culprits = || tracker.culprits().iter().filter(|culprit| culprit.status == status);
    let why = match status {
        Status::MissingValue => format!("a value is missing: {}", culprits().map(missing).collect::<Vec<_>>().join(", ")),
        Status::OutOfRange => joined(culprits().map(|culprit| out_of_range(culprit, tracker.system().wheel.radius()))),
        Status::SlipOutOfRange => joined(culprits().map(slip_out_of_range)),
        Status::TimeBackwards => "the time is before that of the sample before; no energy is added there".to_owned(),
        _ => reason(tally),
    };
    Warning::new(status.code(), format!("no result for {}: {why}", counted(tally.count, tally.first_row)))
}

fn without_coupled(code: &'static str, column: SeriesColumn, tally: &Tally) -> Warning {
    let samples = counted(tally.count, tally.first_row);
    Warning::new(code, format!("no pull by the coupled form for {samples}: `{}` is missing", column.name()))
}

fn name(culprit: &CulpritTally) -> &'static str {
    SeriesColumn::from(culprit.channel).name()
}

fn missing(culprit: &CulpritTally) -> String {
    format!("`{}` in {}", name(culprit), culprit.count)
}

fn out_of_range(culprit: &CulpritTally, radius: f64) -> String {
    let (name, first) = (name(culprit), culprit.first_value);
    let demand = match culprit.channel {
        Channel::Sinkage if culprit.largest > radius => {
            format!("greater than 0 and at most the radius {radius} m; it is in metres")
        }
        Channel::Sinkage => format!("greater than 0 and at most the radius {radius} m"),
        Channel::NormalLoad => "finite and greater than 0".to_owned(),
        _ => "finite".to_owned(),
    };
    format!("`{name}` has to be {demand}; the first of {} is {first}", culprit.count)
}

fn slip_out_of_range(culprit: &CulpritTally) -> String {
    let per_cent = if culprit.largest <= 100.0 { "; per cent have to be divided by 100" } else { "" };
    format!("the slip has to be from -1 to 1, the first is {}{per_cent}", culprit.first_value)
}

fn joined(parts: impl Iterator<Item = String>) -> String {
    parts.collect::<Vec<_>>().join("; ")
}

fn caution(tally: &CautionTally, good: u64) -> Warning {
    let warning = Warning::from(tally.worst);
    if tally.count == good {
        return warning;
    }
    let detail = format!("concerns {}; furthest out: {}", counted(tally.count, tally.first_row), warning.detail);
    Warning { detail, ..warning }
}

fn counted(count: u64, first_row: u64) -> String {
    match count {
        1 => format!("1 sample, at index {first_row}"),
        _ => format!("{count} samples, the first at index {first_row}"),
    }
}

fn reason(tally: &Tally) -> String {
    tally.error.map_or_else(String::new, |error| error.to_string())
}
