//! Results of a run, row by row, with an end that tells a whole answer from one that was cut.

use std::io::Write;

use serde::Serialize;
use terramechanics::TrackRow;
use terramechanics_identification::{StrengthBound, StrengthEstimate};

/// A format that is written row by row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RowFormat {
    /// A header, a row per sample; at the end comments after `#`, of which the last is `#end,<rows>`.
    Csv,
    /// An object per sample; at the end an object with `end`.
    Ndjson,
}

/// Names of the columns that hold numbers; then come `status` and, with a measured torque, [`COUPLED`].
pub(crate) const NUMBERS: [&str; 10] = [
    "time_s",
    "slip",
    "sinkage_m",
    "longitudinal_force_n",
    "normal_force_n",
    "torque_n_m",
    "drawbar_coefficient",
    "tractive_efficiency",
    "power_w",
    "energy_j",
];

/// Name of the pull by Ding's coupled form.
pub(crate) const COUPLED: &str = "longitudinal_force_coupled_n";

/// Names of the running estimate of the strength and its covariance, the last columns where they are asked for.
pub(crate) const STRENGTH: [&str; 5] =
    ["cohesion_pa", "tan_friction", "cohesion_variance_pa2", "tan_friction_variance", "cohesion_tan_friction_covariance_pa"];

/// A running estimate, in the order of [`STRENGTH`]; NaN as long as the samples do not determine it, and for the variance of what
/// a bound decides.
pub(crate) type StrengthCells = [f64; STRENGTH.len()];

pub(super) fn strength_cells(estimate: Option<StrengthEstimate>) -> StrengthCells {
    let Some(estimate) = estimate else { return [f64::NAN; STRENGTH.len()] };
    let unless = |bound: StrengthBound, value: f64| if estimate.bound == Some(bound) { f64::NAN } else { value };
    [
        estimate.cohesion,
        estimate.tan_friction,
        unless(StrengthBound::NoCohesion, estimate.cohesion_variance),
        unless(StrengthBound::NoFriction, estimate.tan_friction_variance),
        if estimate.bound.is_some() { f64::NAN } else { estimate.covariance },
    ]
}

/// The numbers of a row, in the order of [`NUMBERS`].
pub(crate) fn numbers(row: &TrackRow) -> [f64; NUMBERS.len()] {
    [
        row.time,
        row.slip,
        row.sinkage,
        row.longitudinal,
        row.normal,
        row.torque,
        row.drawbar_coefficient,
        row.tractive_efficiency,
        row.power,
        row.energy,
    ]
}

/// Writes the rows of a run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Table {
    pub(crate) format: RowFormat,
    /// Whether there is a column for the pull by the coupled form.
    pub(crate) coupled: bool,
    /// Whether there are columns for the running estimate of the strength.
    pub(crate) strength: bool,
}

impl Table {
    /// What stands before the first row.
    pub(crate) fn head(self, out: &mut Vec<u8>) {
        if self.format == RowFormat::Csv {
            out.extend_from_slice(NUMBERS.join(",").as_bytes());
            out.extend_from_slice(b",status");
            if self.coupled {
                out.push(b',');
                out.extend_from_slice(COUPLED.as_bytes());
            }
            if self.strength {
                out.push(b',');
                out.extend_from_slice(STRENGTH.join(",").as_bytes());
            }
            out.push(b'\n');
        }
    }

    pub(crate) fn row(self, row: &TrackRow, strength: Option<&StrengthCells>, out: &mut Vec<u8>) {
        let status = row.status.code().as_bytes();
        match self.format {
            RowFormat::Csv => {
                for value in numbers(row) {
                    number(value, b"", out);
                    out.push(b',');
                }
                out.extend_from_slice(status);
                if self.coupled {
                    out.push(b',');
                    number(row.longitudinal_coupled, b"", out);
                }
                for &value in strength.into_iter().flatten() {
                    out.push(b',');
                    number(value, b"", out);
                }
                out.push(b'\n');
            }
            RowFormat::Ndjson => {
                let mut before = b'{';
                let mut named = |name: &str, out: &mut Vec<u8>| {
                    out.extend_from_slice(&[std::mem::replace(&mut before, b','), b'"']);
                    out.extend_from_slice(name.as_bytes());
                    out.extend_from_slice(b"\":");
                };
                for (name, value) in NUMBERS.iter().zip(numbers(row)) {
                    named(name, out);
                    number(value, b"null", out);
                }
                named("status", out);
                out.push(b'"');
                out.extend_from_slice(status);
                out.push(b'"');
                if self.coupled {
                    named(COUPLED, out);
                    number(row.longitudinal_coupled, b"null", out);
                }
                for (name, &value) in STRENGTH.iter().zip(strength.into_iter().flatten()) {
                    named(name, out);
                    number(value, b"null", out);
                }
                out.extend_from_slice(b"}\n");
            }
        }
    }

    /// What stands behind the last row of a whole answer.
    pub(crate) fn end(self, ending: &Ending<'_>, out: &mut Vec<u8>) {
        match self.format {
            RowFormat::Csv => {
                for warning in ending.warnings {
                    comment(&["warning", warning.code, &warning.detail], out);
                }
                for event in ending.events {
                    let (row, from, to) = (event.row.to_string(), text(event.from_s), text(event.to_s));
                    comment(&["event", event.code, &row, &from, &to], out);
                }
                comment(&["end", &ending.rows.to_string()], out);
            }
            RowFormat::Ndjson => json(&Last { end: true, ending }, out),
        }
    }

    /// What stands behind the last row where the run ended before its time.
    pub(crate) fn broken(self, problem: &str, out: &mut Vec<u8>) {
        match self.format {
            RowFormat::Csv => comment(&["error", problem], out),
            RowFormat::Ndjson => json(&serde_json::json!({ "error": problem }), out),
        }
    }
}

/// What is known only when a run is over.
#[derive(Debug, Serialize)]
pub(crate) struct Ending<'a> {
    pub(crate) rows: u64,
    pub(crate) warnings: &'a [crate::reply::Warning],
    pub(crate) events: &'a [crate::reply::EventReply],
}

#[derive(Serialize)]
struct Last<'a> {
    end: bool,
    #[serde(flatten)]
    ending: &'a Ending<'a>,
}

/// A value in the shortest form that parses to the same number, or `none`.
fn number(value: f64, none: &[u8], out: &mut Vec<u8>) {
    if value.is_finite() {
        json_number(value, out);
    } else {
        out.extend_from_slice(none);
    }
}

fn json_number(value: f64, out: &mut Vec<u8>) {
    // Writing to memory cannot fail.
    let _ = serde_json::to_writer(out, &value);
}

fn text(value: f64) -> String {
    let mut out = Vec::new();
    number(value, b"", &mut out);
    String::from_utf8(out).unwrap_or_default()
}

/// A comment of several cells; the last may be any text without a line end.
fn comment(cells: &[&str], out: &mut Vec<u8>) {
    let _ = writeln!(out, "#{}", cells.join(",").replace(['\n', '\r'], " "));
}

fn json<T: Serialize>(value: &T, out: &mut Vec<u8>) {
    let _ = serde_json::to_writer(&mut *out, value);
    out.push(b'\n');
}
