//! The catalogue as tables: one row per entry, one column per value, an empty cell for what is not known.

use terramechanics::{AngleRatio, Law, PeakRule, PressureSinkage, ShearLaw};

use super::record::{SOIL_FIELDS, SoilRecord, Values, WHEEL_FIELDS, WheelRecord};
use crate::quantity::{Cell, line};

/// Values of a wheel that are no part of a request.
const WHEEL_FACTS: [&str; 2] = ["lug_count", "nominal_load_n"];

/// The value of that name, if it is known.
fn number<'a>(values: Option<&Values>, name: &str) -> Cell<'a> {
    Cell::Number(values.and_then(|values| values.get(name)).map_or(f64::NAN, |value| value.value))
}

/// A table: its header, then a line for each of `rows`.
fn table<'a>(names: impl IntoIterator<Item = &'a str>, rows: impl Iterator<Item = Vec<Cell<'a>>>) -> Vec<u8> {
    let mut out = Vec::new();
    line(names.into_iter().map(Cell::Word), &mut out);
    rows.for_each(|cells| line(cells, &mut out));
    out
}

/// The wheels as a table.
pub(crate) fn wheels_table<'a>(records: impl Iterator<Item = &'a WheelRecord>) -> Vec<u8> {
    let values: Vec<&str> = WHEEL_FIELDS.into_iter().chain(WHEEL_FACTS).collect();
    let header = ["id", "name", "kind", "grade"].into_iter().chain(values.iter().copied());
    let row = |record: &'a WheelRecord| {
        let words = [&record.id, &record.name, &record.kind, record.grade.name()].map(Cell::Word);
        words.into_iter().chain(values.iter().map(|name| number(Some(&record.values), name))).collect()
    };
    table(header, records.map(row))
}

/// The soils as a table.
pub(crate) fn soils_table<'a>(records: impl Iterator<Item = &'a SoilRecord>) -> Vec<u8> {
    let (of_laws, of_shear, of_rules) =
        (parameters(PressureSinkage::LAWS), parameters(ShearLaw::LAWS), parameters(PeakRule::LAWS));
    let of_rules = [&[AngleRatio::C3.name], &of_rules[..]].concat();
    let header = [&["id", "name", "kind", "grade"][..], &SOIL_FIELDS, &["law"], &of_laws, &["shear_law"], &of_shear];
    let header = header.into_iter().flatten().chain(&["rule"]).chain(&of_rules).copied();
    let row = |record: &'a SoilRecord| {
        let (shear, contact) = (record.shear.as_ref(), record.contact.as_ref());
        let mut cells = [&record.id, &record.name, &record.kind, record.grade.name()].map(Cell::Word).to_vec();
        cells.extend(SOIL_FIELDS.iter().map(|name| number(Some(&record.values), name)));
        cells.push(Cell::Word(record.law.as_deref().unwrap_or("")));
        cells.extend(of_laws.iter().map(|name| number(Some(&record.values), name)));
        cells.push(Cell::Word(shear.map_or("", |shear| &shear.law)));
        cells.extend(of_shear.iter().map(|name| number(shear.map(|shear| &shear.values), name)));
        cells.push(Cell::Word(contact.map_or("", |contact| &contact.rule)));
        cells.extend(of_rules.iter().map(|name| number(contact.map(|contact| &contact.values), name)));
        cells
    };
    table(header, records.map(row))
}

/// The parameters of all laws of a family, each once, but those that every soil has.
fn parameters<F>(laws: &'static [Law<F>]) -> Vec<&'static str> {
    let names = laws.iter().flat_map(|law| law.parameters).map(|parameter| parameter.name);
    super::distinct(names.filter(|name| !SOIL_FIELDS.contains(name)))
}
