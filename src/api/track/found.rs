//! What a run over samples says of itself when it is over.

use terramechanics::{Channel, CulpritTally, Event, NormalStressFrom, Status, Tally, Tracker};
use terramechanics_identification::{RunningStrength, StrengthTally};
use terramechanics_reading::Assumption;

use super::plan::TrackPlan;
use crate::request::circles::Counted;
use crate::request::unused::Unused;
use crate::series::{Column, Unreadable};
use crate::warning::{BeyondRange, Finding, Reason, Rows, Warning, of_assumptions, of_system};

/// The findings of a run.
#[derive(Debug)]
pub(crate) struct FoundTrack {
    pub(crate) rows: u64,
    pub(crate) circles: Counted,
    pub(crate) normal_stress_from: NormalStressFrom,
    pub(crate) events: Vec<Event>,
    pub(crate) warnings: Vec<Warning>,
    /// What was assumed of the request; no list where nothing may be.
    pub(crate) assumed: Option<Vec<Assumption>>,
}

impl FoundTrack {
    /// The findings of a run that has ended.
    pub(crate) fn of(tracker: &Tracker, plan: &TrackPlan, unreadable: &Unreadable, strength: Option<&RunningStrength>) -> Self {
        let mut warnings = Vec::new();
        warnings.extend(unread(tracker, unreadable));
        for status in Status::ALL {
            let finding = tracker.tally(status).and_then(|tally| without_result(tracker, status, tally));
            warnings.extend(finding);
        }
        warnings.extend(tracker.missing_torque().map(|tally| at(Finding::MissingTorque {}, tally)));
        warnings.extend(tracker.missing_load().map(|tally| at(Finding::MissingLoad {}, tally)));
        if plan.lacks_load() {
            warnings.push(Finding::NoLoad {}.into());
        }
        warnings.extend(tracker.not_coupled().and_then(|tally| Some(at(Finding::NotCoupled { reason: reason(tally)? }, tally))));
        warnings.extend(cautions(tracker));
        warnings.extend(of_system(tracker.system()));
        if tracker.has_moved_backward() {
            warnings.push(Finding::Mirrored {}.into());
        }
        warnings.extend(strength.into_iter().flat_map(|running| of_strength(running.tally())).map(Warning::from));
        let (events, left_out) = tracker.events();
        if left_out > 0 {
            warnings.push(Finding::EventsLeftOut { events: left_out }.into());
        }
        Self {
            rows: tracker.rows(),
            circles: tracker.system().contact.circles().into(),
            normal_stress_from: plan.normal_stress_from(),
            events: events.to_vec(),
            warnings,
            assumed: None,
        }
    }

    /// Of settings that count on these circles and do not read all that was sent.
    pub(crate) fn by(mut self, circles: Counted, unused: &Unused) -> Self {
        self.warnings.extend(unused.warning());
        Self { circles, ..self }
    }

    /// With what was assumed of the request.
    pub(crate) fn assuming(mut self, assumed: Option<Vec<Assumption>>) -> Self {
        self.warnings.extend(of_assumptions(assumed.as_deref().unwrap_or_default()));
        Self { assumed, ..self }
    }
}

fn at(finding: Finding, tally: &Tally) -> Warning {
    Warning::from(finding).at(Rows::counted(tally.count, tally.first_row))
}

fn reason(tally: &Tally) -> Option<Reason> {
    tally.error.map(Reason::Model)
}

/// Cells that are not numbers, and the samples that have no result because of them.
fn unread(tracker: &Tracker, unreadable: &Unreadable) -> Option<Warning> {
    let finding = Finding::Unreadable { values: unreadable.count, first: unreadable.first.clone()? };
    Some(match tracker.tally(Status::Unreadable) {
        Some(tally) => at(finding, tally),
        None => finding.into(),
    })
}

/// Why samples of a status have no result; nothing of those that have one, and of unreadable ones, whose cells say more.
fn without_result(tracker: &Tracker, status: Status, tally: &Tally) -> Option<Warning> {
    let culprits = || tracker.culprits().iter().filter(|culprit| culprit.status == status);
    let finding = match status {
        Status::Ok | Status::Static | Status::Unreadable => return None,
        Status::MissingValue => Finding::MissingValue { columns: culprits().map(|of| (name(of), of.count)).collect() },
        Status::OutOfRange => {
            Finding::OutOfRange { values: culprits().map(|of| beyond_range(of, tracker.system().wheel.radius())).collect() }
        }
        Status::SlipOutOfRange => {
            let culprit = culprits().next()?;
            Finding::SlipOutOfRange { first: culprit.first_value, largest: culprit.largest }
        }
        Status::OppositeRotation => Finding::OppositeRotation { reason: reason(tally)? },
        Status::TimeBackwards => Finding::TimeBackwards {},
        Status::NoSolution => Finding::NoSolution { reason: reason(tally)?, pointer: "" },
    };
    Some(at(finding, tally))
}

fn name(culprit: &CulpritTally) -> &'static str {
    Column::from(culprit.channel).name()
}

fn beyond_range(culprit: &CulpritTally, radius: f64) -> BeyondRange {
    let (lower, upper) = match culprit.channel {
        Channel::Sinkage => (Some(0.0), Some(radius)),
        Channel::NormalLoad => (Some(0.0), None),
        Channel::Time | Channel::Slip | Channel::ForwardVelocity | Channel::AngularVelocity | Channel::Torque => (None, None),
    };
    let CulpritTally { first_value: first, largest, count, .. } = *culprit;
    BeyondRange { column: name(culprit), first, largest, count, lower, upper }
}

/// The cautions of the good samples; one that all of them carry names no rows.
fn cautions(tracker: &Tracker) -> impl Iterator<Item = Warning> {
    let good = Status::ALL.into_iter().filter(|status| status.is_good()).filter_map(|status| tracker.tally(status));
    let good: u64 = good.map(|tally| tally.count).sum();
    tracker.cautions().iter().map(move |tally| {
        let warning = Warning::from(tally.worst);
        if tally.count == good {
            warning
        } else {
            warning.at(Rows::counted(tally.count, tally.first_row)).varying(tally.count > 1)
        }
    })
}

/// What the samples do not tell of the strength.
fn of_strength(tally: &StrengthTally) -> Vec<Finding> {
    let StrengthTally { estimates, one_load, one_slip, no_cohesion, no_friction } = *tally;
    let mut findings = vec![Finding::LinearisedStresses {}];
    if estimates == 0 {
        findings.push(Finding::NoEstimate {});
    }
    if one_load > 0 {
        findings.push(Finding::SingleLoadOfTrack { rows: one_load, estimates });
    }
    if one_slip > 0 {
        findings.push(Finding::SingleSlipOfTrack { rows: one_slip, estimates });
    }
    for (parameter, rows) in [("cohesion_pa", no_cohesion), ("tan_friction", no_friction)] {
        if rows > 0 {
            findings.push(Finding::HeldAtZero { parameter, rows, estimates });
        }
    }
    findings
}
