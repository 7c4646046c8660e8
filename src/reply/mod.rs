//! Answers as they stand on the wire, made from what the model returns.

mod compare;
mod coupled;
mod curves;
mod difference;
mod forces;
mod identify;
mod resistances;
mod slip_sweep;
mod soil;
mod stress_profile;
mod towed;
mod track;
mod validation;
mod warning;

pub(crate) use compare::CompareReply;
pub(crate) use coupled::CoupledReply;
pub(crate) use curves::{PlatesReply, ShearReply};
pub(crate) use forces::ForcesReply;
pub(crate) use identify::IdentifyReply;
pub(crate) use resistances::ResistancesReply;
pub(crate) use slip_sweep::SweepReply;
pub(crate) use stress_profile::ProfileReply;
pub(crate) use towed::TowedReply;
pub(crate) use track::{EventReply, Findings, TrackReply};
pub(crate) use validation::ValidationSet;
pub(crate) use warning::{RowCautions, Warning};

use std::borrow::Cow;
use std::fmt::Write as _;
use std::io;

use serde::ser::SerializeSeq;
use serde::{Serialize, Serializer};
use terramechanics::Angles;
use utoipa::ToSchema;

/// An answer that can also be written as a table.
pub(crate) trait Reply: Serialize {
    /// The columns by name, all of one length; NaN where there is no value.
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])>;

    /// What else there is to say.
    fn warnings(&self) -> &[Warning];
}

/// A column of numbers; NaN in memory, null on the wire, where there is none.
#[derive(Debug, Clone, Default)]
pub(crate) struct Column(pub(crate) Vec<f64>);

impl Serialize for Column {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(Some(self.0.len()))?;
        for &value in &self.0 {
            list.serialize_element(&value.is_finite().then_some(value))?;
        }
        list.end()
    }
}

/// The table of a reply: a header row with the names of the columns, then a row per point; an empty cell for no value.
pub(crate) fn write_table(columns: &[(Cow<'static, str>, &[f64])], out: &mut impl io::Write) -> io::Result<()> {
    let names: Vec<Cow<'_, str>> = columns.iter().map(|(name, _)| cell_of(name)).collect();
    writeln!(out, "{}", names.join(","))?;
    let rows = columns.first().map_or(0, |(_, column)| column.len());
    let mut line = String::new();
    for row in 0..rows {
        line.clear();
        for (i, (_, column)) in columns.iter().enumerate() {
            if i > 0 {
                line.push(',');
            }
            if column[row].is_finite() {
                // The shortest form that parses to the same number; writing to a String cannot fail.
                let _ = write!(line, "{:?}", column[row]);
            }
        }
        line.push('\n');
        out.write_all(line.as_bytes())?;
    }
    Ok(())
}

/// A text as a cell: in quotes where it would else be taken apart (RFC 4180, section 2).
fn cell_of(text: &str) -> Cow<'_, str> {
    if text.contains([',', '"', '\r', '\n']) { format!("\"{}\"", text.replace('"', "\"\"")).into() } else { text.into() }
}

/// The characteristic angles of the contact, from straight down, positive towards the front.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Angles)]
pub(crate) struct AnglesReply {
    /// Entry angle θ1 (rad).
    entry_rad: f64,
    /// Angle of maximum stress θm (rad).
    maximum_stress_rad: f64,
    /// Exit angle θ2 (rad).
    exit_rad: f64,
}

impl From<Angles> for AnglesReply {
    fn from(angles: Angles) -> Self {
        Self { entry_rad: angles.entry, maximum_stress_rad: angles.peak, exit_rad: angles.exit }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_has_names_rows_and_empty_cells() {
        let table = |columns: &[(Cow<'static, str>, &[f64])]| {
            let mut text = Vec::new();
            write_table(columns, &mut text).expect("memory takes all");
            String::from_utf8(text).expect("text")
        };
        let text = table(&[("slip".into(), &[0.0, 0.1]), ("torque_n_m".into(), &[f64::NAN, 1e-7])]);
        assert_eq!(text, "slip,torque_n_m\n0.0,\n0.1,1e-7\n");
        assert_eq!(table(&[("a, b".into(), &[1.0]), ("5\" wide".into(), &[2.0])]), "\"a, b\",\"5\"\" wide\"\n1.0,2.0\n");
    }

    #[test]
    fn no_value_is_null() {
        let text = serde_json::to_string(&Column(vec![1.5, f64::NAN, f64::INFINITY])).expect("JSON");
        assert_eq!(text, "[1.5,null,null]");
    }
}
