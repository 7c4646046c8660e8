//! Warnings of rows that come one by one, in constant memory however many there are.

use terramechanics::Caution;

use super::{Finding, Rows, Warning};

/// Findings that are told apart; of more kinds than there are fields to be wrong nothing is kept.
const MOST_FINDINGS: usize = 100;

/// What rows have given so far: of each kind the worst or the first, with the rows.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tally {
    row: u64,
    rows: u64,
    cautions: Vec<(Caution, bool, Rows)>,
    findings: Vec<(Finding, Rows)>,
}

impl Tally {
    /// The next row begins.
    pub(crate) fn begin_row(&mut self) {
        self.row = self.rows;
        self.rows += 1;
    }

    /// The row has a caution of the model.
    pub(crate) fn caution(&mut self, caution: Caution) {
        let known = self.cautions.iter_mut().find(|(known, ..)| std::ptr::eq(known.kind, caution.kind));
        if let Some((worst, varies, rows)) = known {
            *varies |= caution.value.to_bits() != worst.value.to_bits();
            if caution.excess() > worst.excess() {
                *worst = caution;
            }
            return rows.push(self.row);
        }
        let mut rows = Rows::none();
        rows.push(self.row);
        self.cautions.push((caution, false, rows));
    }

    /// The row has a finding; of those of one kind about one field the first is told.
    pub(crate) fn finding(&mut self, finding: Finding) {
        let is_same = |known: &Finding| known.code() == finding.code() && known.pointer() == finding.pointer();
        if let Some((_, rows)) = self.findings.iter_mut().find(|(known, _)| is_same(known)) {
            return rows.push(self.row);
        }
        if self.findings.len() < MOST_FINDINGS {
            let mut rows = Rows::none();
            rows.push(self.row);
            self.findings.push((finding, rows));
        }
    }

    /// The warnings: findings first, each with its rows unless it holds for all of several cautions.
    pub(crate) fn into_warnings(self) -> Vec<Warning> {
        let all = self.rows;
        let findings = self.findings.into_iter().map(|(finding, rows)| Warning::from(finding).at(rows));
        let cautions = self.cautions.into_iter().map(move |(caution, varies, rows)| {
            let warning = Warning::from(caution).varying(varies);
            if rows.count() == all { warning } else { warning.at(rows) }
        });
        findings.chain(cautions).collect()
    }
}
