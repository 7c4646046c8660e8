//! Is the wheel stuck? Stall and entrapment as indicators over time.
//!
//! A wheel stalls where its slip stays at or above a threshold for a time; it is entrapped where it has sunk beyond a ratio to
//! its radius. Both are rules of operation, not physics: no threshold holds for every rover, so all three are the caller's.

use crate::fault::InvalidInput;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement, present};

/// When a wheel counts as stuck.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thresholds {
    /// Slip (–) from which on the wheel may stall, greater than 0 and at most 1.
    pub stall_slip: f64,
    /// Time (s) for which the slip has to stay there, not negative.
    pub stall_time: f64,
    /// Ratio of sinkage to radius (–) beyond which the wheel is entrapped, from 0 to 1.
    pub entrapment_sinkage_ratio: f64,
}

impl Default for Thresholds {
    /// 80 % slip for two seconds; a sinkage of half the radius. A choice, because no published rule is known.
    fn default() -> Self {
        Self::CHOSEN
    }
}

impl Thresholds {
    const CHOSEN: Self = Self { stall_slip: 0.8, stall_time: 2.0, entrapment_sinkage_ratio: 0.5 };

    /// s_stall.
    pub const STALL_SLIP: Parameter = Parameter {
        name: "stall_slip",
        symbol: "s_stall",
        unit: "1",
        meaning: "Slip from which on the wheel may stall.",
        requirement: Requirement::Within { min: f64::MIN_POSITIVE, max: 1.0 },
        least: 0.01,
        most: 1.0,
        presence: Presence::Default(Self::CHOSEN.stall_slip),
    };

    /// t_stall.
    pub const STALL_TIME: Parameter = Parameter {
        name: "stall_time_s",
        symbol: "t_stall",
        unit: "s",
        meaning: "Time for which the slip has to stay there.",
        requirement: Requirement::NotNegative,
        least: 0.0,
        most: 1e6,
        presence: Presence::Default(Self::CHOSEN.stall_time),
    };

    /// z/r.
    pub const ENTRAPMENT_SINKAGE_RATIO: Parameter = Parameter {
        name: "entrapment_sinkage_ratio",
        symbol: "z/r",
        unit: "1",
        meaning: "Share of the radius beyond which the sinkage is an entrapment.",
        requirement: Requirement::Within { min: 0.0, max: 1.0 },
        least: 0.0,
        most: 1.0,
        presence: Presence::Default(Self::CHOSEN.entrapment_sinkage_ratio),
    };

    /// # Errors
    /// Every threshold outside its range.
    pub(crate) fn check(&self) -> Result<(), InvalidInput> {
        InvalidInput::check(present(Self::PARAMETERS, self.values()))
    }
}

impl Parametrised for Thresholds {
    const PARAMETERS: &'static [Parameter] = &[Self::STALL_SLIP, Self::STALL_TIME, Self::ENTRAPMENT_SINKAGE_RATIO];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[stall_slip, stall_time, entrapment_sinkage_ratio] = values else { return None };
        Some(Self { stall_slip: stall_slip?, stall_time: stall_time?, entrapment_sinkage_ratio: entrapment_sinkage_ratio? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        [self.stall_slip, self.stall_time, self.entrapment_sinkage_ratio].map(Some).to_vec()
    }
}

/// What happened to the wheel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// The slip stayed high.
    Stall,
    /// The wheel sank deep.
    Entrapment,
}

impl EventKind {
    /// A name for programs.
    #[must_use]
    pub fn code(self) -> &'static str {
        match self {
            Self::Stall => "stall",
            Self::Entrapment => "entrapment",
        }
    }
}

/// A time in which the wheel was stuck.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// What happened.
    pub kind: EventKind,
    /// Sample, counted from 0, at which the condition began to hold.
    pub row: u64,
    /// Its time (s).
    pub from: f64,
    /// Time (s) of the last sample at which it held.
    pub to: f64,
}

/// A condition that has to hold for a time to be an event.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Watch {
    kind: EventKind,
    least_time: f64,
    /// The event, if the condition has held long enough by now.
    holding: Option<Event>,
}

impl Watch {
    pub(crate) fn new(kind: EventKind, least_time: f64) -> Self {
        Self { kind, least_time, holding: None }
    }

    /// Whether the condition holds at a sample; gives the event that ended before it, if one did.
    pub(crate) fn see(&mut self, holds: bool, row: u64, time: f64) -> Option<Event> {
        if !holds {
            return self.end();
        }
        match &mut self.holding {
            Some(event) => event.to = time,
            None => self.holding = Some(Event { kind: self.kind, row, from: time, to: time }),
        }
        None
    }

    /// The event that has lasted up to now, which ends here.
    pub(crate) fn end(&mut self) -> Option<Event> {
        self.holding.take().filter(|event| event.to - event.from >= self.least_time)
    }
}
