//! How the wheels of a rover turn.

use terramechanics::{Drive, Slip, Turning, WheelOnSoil};
use terramechanics_reading::{Field, Group, Number, Reader, Word};

use crate::request::laws::field;
use crate::request::motion::RATIO;

const WORDS: Word<Drive> = Word::new(&[("one_slip", Drive::OneSlip), ("equal_torque", Drive::EqualTorque)]);

pub(super) const DRIVE: Field<Word<Drive>> = Field::new(
    "drive",
    "What the wheels have in common: one_slip, as with wheels of one speed; or equal_torque, as with motors that share a current, where each slips as its load and soil ask. Then `slip` of the answer is the largest, and the slip limit holds for it. A station with a slip or torque of its own takes no part.",
    WORDS.or(Drive::OneSlip),
);

const SLIP: Field<Number> =
    Field::new(Slip::RATIO.name, "Slip of this wheel [–], in place of that of the others: −1 of a locked one.", RATIO);
const TORQUE: Field<Number> =
    field(&WheelOnSoil::TORQUE, "Torque (N·m) of this wheel, which then slips as that asks: 0 of one that rolls freely.");

pub(super) const TURNING: Group = &[&SLIP, &TORQUE];

/// How the wheel of a station turns.
pub(super) fn turning(station: &Reader<'_>) -> Option<Turning> {
    let (slip, torque) = (station.optional(&SLIP), station.optional(&TORQUE));
    if station.has(&SLIP) && station.has(&TORQUE) {
        station.place_of(&TORQUE).fault("give either `slip` or `torque_n_m`, not both");
        return None;
    }
    match (slip?, torque?) {
        (Some(slip), _) => Slip::new(slip).map(Turning::AtSlip).map_err(|error| station.place_of(&SLIP).fault(error)).ok(),
        (None, Some(torque)) => Some(Turning::UnderTorque(torque)),
        (None, None) => Some(Turning::Together),
    }
}

/// The word for what wheels have in common.
pub(crate) fn word(drive: Drive) -> &'static str {
    match drive {
        Drive::OneSlip => "one_slip",
        Drive::EqualTorque => "equal_torque",
    }
}
