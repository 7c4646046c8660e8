//! The sentences of a warning: the only place where they are made.

use terramechanics::{Caution, TestedRange};

use super::words::{behind_colon, capitalised, quoted};
use super::{Rows, Subject, Warning};
use crate::quantity::with_unit;

/// The sentences of a warning, as they stand behind a colon, in the units of the request.
pub(super) struct Sentences {
    /// What holds.
    pub(super) finding: String,
    /// What that means, and what to do: without a figure of the request.
    pub(super) advice: String,
}

impl Warning {
    /// What holds and what to do, without the place.
    pub(super) fn sentences(&self) -> Sentences {
        let many = self.rows.as_ref().is_some_and(|rows| rows.count() > 1);
        let (finding, advice) = match &self.subject {
            Subject::Finding(finding) => (finding.finding(many), finding.advice(many)),
            Subject::Caution(caution) => of_caution(caution, self.varies),
        };
        Sentences { finding: behind_colon(&finding), advice }
    }

    /// The warning in words: where, what, and what to do.
    pub(crate) fn detail(&self) -> String {
        self.placed(&self.sentences())
    }

    /// The sentences behind the place for which they hold.
    pub(super) fn placed(&self, Sentences { finding, advice }: &Sentences) -> String {
        let names: Vec<&str> = self.series.iter().map(String::as_str).collect();
        let series = (!names.is_empty()).then(|| format!("in {}", quoted(&names)));
        let rows = self.rows.as_ref().map(Rows::in_words);
        match [series, rows].into_iter().flatten().collect::<Vec<_>>().join(", ").as_str() {
            "" => format!("{} {advice}", capitalised(finding)),
            place => format!("{}: {finding} {advice}", capitalised(place)),
        }
    }
}

/// What a caution finds and what follows from it. Of several values it names the one furthest out. Without a range, the finding
/// is what the caution means.
fn of_caution(caution: &Caution, varies: bool) -> (String, String) {
    let kind = caution.kind;
    let Some(TestedRange { quantity, unit, lower, upper, source }) = kind.range.as_ref() else {
        return (kind.meaning.to_owned(), kind.advice.to_owned());
    };
    let side = match (lower, upper) {
        (Some(lower), _) if caution.value < *lower => format!("below {}", with_unit(*lower, unit)),
        (_, Some(upper)) => format!("above {}", with_unit(*upper, unit)),
        _ => "outside its range".to_owned(),
    };
    let worst = if varies { " at worst" } else { "" };
    let finding = format!("{quantity} is {}{worst}, {side} ({source}).", with_unit(caution.value, unit));
    (finding, format!("{} {}", kind.meaning, kind.advice))
}
