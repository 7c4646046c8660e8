//! The sentence of a warning: the only place where one is made.

use terramechanics::{Caution, TestedRange};

use super::words::{behind_colon, capitalised, quoted};
use super::{Rows, Subject, Warning};
use crate::quantity::with_unit;

impl Warning {
    /// The warning in words: where, what, and what to do, in the units of the request.
    pub(crate) fn detail(&self) -> String {
        let many = self.rows.as_ref().is_some_and(|rows| rows.count() > 1);
        let said = match &self.subject {
            Subject::Finding(finding) => finding.sentence(many),
            Subject::Caution(caution) => of_caution(caution, self.varies),
        };
        let names: Vec<&str> = self.series.iter().map(String::as_str).collect();
        let series = (!names.is_empty()).then(|| format!("in {}", quoted(&names)));
        let rows = self.rows.as_ref().map(Rows::in_words);
        match [series, rows].into_iter().flatten().collect::<Vec<_>>().join(", ").as_str() {
            "" => capitalised(&said),
            place => format!("{}: {}", capitalised(place), behind_colon(&said)),
        }
    }
}

/// The sentence for a caution: quantity and range, what that means, what to do. Of several values it names the one furthest out.
fn of_caution(caution: &Caution, varies: bool) -> String {
    let kind = caution.kind;
    let rest = format!("{} {}", kind.meaning, kind.advice);
    let Some(TestedRange { quantity, unit, lower, upper, source }) = kind.range.as_ref() else { return rest };
    let side = match (lower, upper) {
        (Some(lower), _) if caution.value < *lower => format!("below {}", with_unit(*lower, unit)),
        (_, Some(upper)) => format!("above {}", with_unit(*upper, unit)),
        _ => "outside its range".to_owned(),
    };
    let worst = if varies { " at worst" } else { "" };
    format!("{quantity} is {}{worst}, {side} ({source}). {rest}", with_unit(caution.value, unit))
}
