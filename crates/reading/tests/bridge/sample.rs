//! A request of every kind of field.

use std::borrow::Cow;
use std::sync::LazyLock;

use terramechanics_reading::*;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Load {
    Dead,
    Live,
}

const LENGTH: Number = Number::new("m", 1.0, 5000.0);
pub(crate) const SPAN: Field<Number> = Field::required("span_m", "Span (m).", LENGTH);

static LAWS: LazyLock<Vec<Variant>> = LazyLock::new(|| {
    const WIDTH: Field<Number> = Field::required("width_m", "Width (m).", Number::new("m", 0.01, 10.0));
    const DEPTH: Field<Number> = Field::new("depth", "Depth over width (–).", Number::new("1", 0.1, 10.0).or(2.0));
    const WALL: Field<Number> = Field::required("wall_m", "Wall (m).", Number::new("m", 1e-3, 1.0));
    vec![
        Variant { name: "solid", doc: "A solid beam.", fields: Cow::Borrowed(&[WIDTH, DEPTH]) },
        Variant { name: "hollow", doc: "A hollow beam.", fields: Cow::Borrowed(&[WIDTH, WALL]) },
    ]
});
const BEAM_LAW: Tagged = Tagged {
    name: "Beam",
    doc: "A beam.",
    tag: "law",
    meaning: "Kind of the beam.",
    suffix: "Beam",
    variants: || &LAWS,
    also: &[],
    without_word: None,
};
const BEAM: Field<&Tagged> = Field::required("beam", "The beam.", &BEAM_LAW);

const FORCE: Number = Number::new("N", 0.0, 1e9);
const FROM: Field<Number> = Field::required("from", "Least (N).", FORCE);
const TO: Field<Number> = Field::required("to", "Most (N).", FORCE);
const RANGE: Object = Object { name: "LoadRange", doc: "From here to there.", groups: &[&[&FROM, &TO]] };
const LOAD: Field<OneOf> = Field::required(
    "load",
    "The load.",
    OneOf::new(
        "a number, \"own\", an array of numbers or a range",
        &[
            Alternative::Number(FORCE),
            Alternative::Word("own", "Its own weight."),
            Alternative::Numbers(Numbers::new(FORCE, 1, 100)),
            Alternative::Object(&RANGE, "A range."),
        ],
    ),
);

const SIDES: Word<Load> = Word::new(&[("dead", Load::Dead), ("live", Load::Live)]);
const SIDE: Field<Word<Load>> = Field::new("side", "Which load.", SIDES.or(Load::Dead));
const HEIGHT: Field<Number> = Field::required("height_m", "Height (m).", LENGTH);
const PIER: Object = Object { name: "Pier", doc: "A pier.", groups: &[&[&HEIGHT]] };
const PIERS: Field<Objects> = Field::new("piers", "The piers.", Objects { object: &PIER, fewest: 0, most: 8 });
const ALL_SIDES: Field<Words<Load>> = Field::new("sides", "Which loads.", Words { word: SIDES, most: 4, first_unless_given: 2 });
const LIMITS: Field<Bounds> = Field::new("range_m", "Limits (m).", Bounds(LENGTH));
const NOTE: Field<Label> = Field::new("note", "A note.", Label);

const STRUCTURE: Group = &[&SPAN, &BEAM, &PIERS];
const LOADS: Group = &[&LOAD, &SIDE, &ALL_SIDES, &LIMITS, &NOTE];
pub(crate) const BRIDGE: Object = Object { name: "BridgeRequest", doc: "A bridge.", groups: &[STRUCTURE, LOADS] };

#[derive(Debug)]
pub(crate) struct Bridge {
    pub(crate) span: f64,
    pub(crate) beam: Chosen,
    pub(crate) loads: Vec<f64>,
    pub(crate) side: Load,
    pub(crate) piers: Vec<f64>,
    pub(crate) sides: Vec<Load>,
    pub(crate) range: Option<[f64; 2]>,
}

pub(crate) fn read_bridge(object: &Reader<'_>) -> Option<Bridge> {
    let span = object.required(&SPAN);
    let beam = object.required(&BEAM);
    let loads = object.required(&LOAD).and_then(|load| match load {
        Either::Number(load) => Some(vec![load]),
        Either::Word => Some(vec![0.0]),
        Either::Numbers(loads) => Some(loads.to_vec()),
        Either::Object(range) => {
            let (from, to) = (range.required(&FROM), range.required(&TO));
            Some(vec![from?, to?])
        }
    });
    let side = object.or_default(&SIDE);
    let piers = object.optional(&PIERS).and_then(|piers| piers.unwrap_or_default().each(|pier, _| pier.required(&HEIGHT)));
    let sides = object.or_default(&ALL_SIDES);
    let range = object.optional(&LIMITS);
    let note = object.optional(&NOTE);
    note?;
    Some(Bridge { span: span?, beam: beam?, loads: loads?, side: side?, piers: piers?, sides: sides?, range: range? })
}

pub(crate) fn bridge(text: &str) -> Result<Bridge, Vec<FieldFault>> {
    read(&json(text.as_bytes()).expect("JSON"), &BRIDGE, &Hints::NONE, read_bridge)
}

pub(crate) fn faults_of(text: &str) -> Vec<FieldFault> {
    bridge(text).expect_err("faults")
}

/// What is said of a pointer.
pub(crate) fn said(text: &str, pointer: &str) -> String {
    let faults = faults_of(text);
    let fault = faults.iter().find(|fault| fault.pointer == pointer);
    fault.unwrap_or_else(|| panic!("no fault of {pointer} in {faults:?}")).detail.clone()
}
