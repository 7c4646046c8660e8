//! Warnings of rows that come one by one, in constant memory however many there are.

use terramechanics::Caution;

use super::{Finding, Reason, Rows, Warning};

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

    /// The rows of a finding of that kind about that field; a refusal of the model is the same if it has the same cause.
    fn same(&mut self, finding: &Finding) -> Option<&mut Rows> {
        let kind = |of: &Finding| match of {
            Finding::NoSolution { reason: Reason::Model(error), .. } => Some(std::mem::discriminant(error)),
            _ => None,
        };
        let is_same = |known: &Finding| {
            known.code() == finding.code() && known.pointer() == finding.pointer() && kind(known) == kind(finding)
        };
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

#[cfg(test)]
mod tests {
    use terramechanics::Error;

    use super::*;
    use crate::warning::no_solution;

    #[test]
    fn rows_without_a_solution_are_counted_by_cause() {
        let heavy = |load: f64| Error::LoadBeyondCapacity { load, largest: 50.0, sinkage: 0.1 };
        let light = Error::LoadTooLight { load: 1.0, least: 2.0, sinkage: 0.01 };
        let mut tally = Tally::default();
        for error in [heavy(80.0), light, heavy(90.0), heavy(100.0)] {
            tally.begin_row();
            tally.finding(no_solution(error, "/normal_load_n"));
        }
        let mut later = Tally::behind(4);
        later.begin_row();
        later.finding(no_solution(light, "/normal_load_n"));
        tally.follow(later);
        let told = tally.into_warnings();
        let counts: Vec<u64> = told.iter().filter_map(|warning| Some(warning.rows.as_ref()?.count())).collect();
        assert_eq!(counts, [3, 2]);
        assert!(told[0].detail().contains("does not carry 80 N") && told[1].detail().contains("brakes"), "{told:?}");
    }
}
