//! The catalogue as tables: one row per entry, one column per value, an empty cell for what is not known (RFC 4180).

use std::fmt::Write;

use terramechanics::{Contact, Law, PeakRule, PressureSinkage, ShearLaw};

use super::record::{SOIL_FIELDS, SoilRecord, Values, WHEEL_FIELDS, WheelRecord};

/// Values of a wheel that are no part of a request.
const WHEEL_FACTS: [&str; 2] = ["lug_count", "nominal_load_n"];

/// A table in the making.
struct Table {
    text: String,
    row_is_empty: bool,
}

impl Table {
    fn with_header<'a>(names: impl IntoIterator<Item = &'a str>) -> Self {
        let mut table = Self { text: String::new(), row_is_empty: true };
        names.into_iter().for_each(|name| table.word(name));
        table.end_row();
        table
    }

    fn cell(&mut self) {
        if !self.row_is_empty {
            self.text.push(',');
        }
        self.row_is_empty = false;
    }

    /// A cell of text, in quotes where a comma or a quote in it would break the table.
    fn word(&mut self, word: &str) {
        self.cell();
        if word.contains([',', '"', '\n', '\r']) {
            self.text.push('"');
            self.text.push_str(&word.replace('"', "\"\""));
            self.text.push('"');
        } else {
            self.text.push_str(word);
        }
    }

    /// A cell with the value of that name in the shortest form that parses to the same number.
    fn number(&mut self, values: Option<&Values>, name: &str) {
        self.cell();
        if let Some(value) = values.and_then(|values| values.get(name)) {
            let _ = write!(self.text, "{:?}", value.value); // writing to a String cannot fail
        }
    }

    fn end_row(&mut self) {
        self.text.push('\n');
        self.row_is_empty = true;
    }
}

/// The wheels as a table.
pub(crate) fn wheels_table<'a>(records: impl Iterator<Item = &'a WheelRecord>) -> String {
    let values: Vec<&str> = WHEEL_FIELDS.into_iter().chain(WHEEL_FACTS).collect();
    let mut table = Table::with_header(["id", "name", "kind", "grade"].into_iter().chain(values.iter().copied()));
    for record in records {
        [&record.id, &record.name, &record.kind, record.grade.name()].into_iter().for_each(|word| table.word(word));
        values.iter().for_each(|name| table.number(Some(&record.values), name));
        table.end_row();
    }
    table.text
}

/// The soils as a table.
pub(crate) fn soils_table<'a>(records: impl Iterator<Item = &'a SoilRecord>) -> String {
    let (of_laws, of_shear, of_rules) =
        (parameters(PressureSinkage::LAWS), parameters(ShearLaw::LAWS), parameters(PeakRule::LAWS));
    let of_rules = [&[Contact::EXIT_RATIO.name], &of_rules[..]].concat();
    let header = [&["id", "name", "kind", "grade"][..], &SOIL_FIELDS, &["law"], &of_laws, &["shear_law"], &of_shear];
    let mut table = Table::with_header(header.into_iter().flatten().chain(&["rule"]).chain(&of_rules).copied());
    for record in records {
        [&record.id, &record.name, &record.kind, record.grade.name()].into_iter().for_each(|word| table.word(word));
        SOIL_FIELDS.iter().for_each(|name| table.number(Some(&record.values), name));
        table.word(record.law.as_deref().unwrap_or(""));
        of_laws.iter().for_each(|name| table.number(Some(&record.values), name));
        table.word(record.shear.as_ref().map_or("", |shear| &shear.law));
        of_shear.iter().for_each(|name| table.number(record.shear.as_ref().map(|shear| &shear.values), name));
        table.word(record.contact.as_ref().map_or("", |contact| &contact.rule));
        of_rules.iter().for_each(|name| table.number(record.contact.as_ref().map(|contact| &contact.values), name));
        table.end_row();
    }
    table.text
}

/// The parameters of all laws of a family, each once, but those that every soil has.
fn parameters<F>(laws: &'static [Law<F>]) -> Vec<&'static str> {
    let names = laws.iter().flat_map(|law| law.parameters).map(|parameter| parameter.name);
    super::distinct(names.filter(|name| !SOIL_FIELDS.contains(name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_with_a_comma_or_a_quote_is_quoted() {
        let mut table = Table::with_header(["id", "name"]);
        table.word("a");
        table.word("wheel \"B\", smooth");
        table.end_row();
        assert_eq!(table.text, "id,name\na,\"wheel \"\"B\"\", smooth\"\n");
    }
}
