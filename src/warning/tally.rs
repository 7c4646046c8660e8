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
    /// Of rows of which `first` come before.
    pub(crate) fn behind(first: u64) -> Self {
        Self { row: first, rows: first, ..Self::default() }
    }

    /// Adds what rows have given that come behind these.
    pub(crate) fn follow(&mut self, later: Self) {
        self.rows = later.rows;
        for (caution, varies, rows) in later.cautions {
            match self.cautions.iter_mut().find(|(known, ..)| std::ptr::eq(known.kind, caution.kind)) {
                Some((worst, varied, known)) => {
                    *varied |= varies || caution.value.to_bits() != worst.value.to_bits();
                    if caution.excess() > worst.excess() {
                        *worst = caution;
                    }
                    known.follow(rows);
                }
                None => self.cautions.push((caution, varies, rows)),
            }
        }
        for (finding, rows) in later.findings {
            if let Some(known) = self.same(&finding) {
                known.follow(rows);
            } else if self.findings.len() < MOST_FINDINGS {
                self.findings.push((finding, rows));
            }
        }
    }

    /// The rows of a finding of that kind about that field.
    fn same(&mut self, finding: &Finding) -> Option<&mut Rows> {
        let is_same = |known: &Finding| known.code() == finding.code() && known.pointer() == finding.pointer();
        self.findings.iter_mut().find(|(known, _)| is_same(known)).map(|(_, rows)| rows)
    }

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
        let row = self.row;
        if let Some(rows) = self.same(&finding) {
            return rows.push(row);
        }
        if self.findings.len() < MOST_FINDINGS {
            let mut rows = Rows::none();
            rows.push(self.row);
            self.findings.push((finding, rows));
        }
    }

    /// The warnings: findings first, each with its rows unless there is but one, or it is a caution of all.
    pub(crate) fn into_warnings(self) -> Vec<Warning> {
        let all = self.rows;
        let finding = |(finding, rows)| if all <= 1 { Warning::from(finding) } else { Warning::from(finding).at(rows) };
        let findings = self.findings.into_iter().map(finding);
        let cautions = self.cautions.into_iter().map(move |(caution, varies, rows)| {
            let warning = Warning::from(caution).varying(varies);
            if rows.count() == all { warning } else { warning.at(rows) }
        });
        findings.chain(cautions).collect()
    }
}
