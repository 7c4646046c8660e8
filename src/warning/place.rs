//! The rows for which a warning holds.

/// Most pairs that a warning names; the count covers the rest.
const MOST_RANGES: usize = 20;

/// Rows by their indices from 0.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Rows {
    /// First and last of each run of neighbours, ascending.
    ranges: Vec<[u64; 2]>,
    count: u64,
    /// Whether the ranges are all of them.
    all_named: bool,
}

impl Rows {
    /// These rows, ascending.
    pub(crate) fn of(rows: &[usize]) -> Self {
        let mut found = Self::none();
        rows.iter().for_each(|&row| found.push(row as u64));
        found
    }

    /// No rows so far.
    pub(crate) fn none() -> Self {
        Self { ranges: Vec::new(), count: 0, all_named: true }
    }

    /// Adds a row behind the others; the last one again is no other.
    pub(crate) fn push(&mut self, row: u64) {
        let is_full = self.ranges.len() > MOST_RANGES;
        match self.ranges.last_mut() {
            Some([_, last]) if *last == row => return,
            Some([_, last]) if *last + 1 == row => *last = row,
            _ if !is_full => self.ranges.push([row, row]),
            _ => {}
        }
        self.count += 1;
        self.all_named = self.ranges.len() <= MOST_RANGES;
    }

    /// A number of rows of which only the first is known.
    pub(crate) fn counted(count: u64, first: u64) -> Self {
        Self { ranges: vec![[first, first]], count, all_named: count == 1 }
    }

    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    /// The pairs that are named.
    pub(super) fn ranges(&self) -> impl Iterator<Item = [u64; 2]> {
        self.ranges.iter().copied().take(MOST_RANGES)
    }

    /// Where, in words: `at row 3`, `at rows 3, 5 to 9 and 12`, `at 7 rows, the first of them 3`.
    pub(super) fn in_words(&self) -> String {
        if !self.all_named && self.ranges.len() == 1 {
            return format!("at {} rows, the first of them {}", self.count, self.ranges[0][0]);
        }
        let names: Vec<String> = self
            .ranges()
            .map(|[first, last]| if first == last { first.to_string() } else { format!("{first} to {last}") })
            .collect();
        let rows = if self.count == 1 { "row" } else { "rows" };
        match names.as_slice() {
            [others @ .., last] if self.all_named && !others.is_empty() => format!("at {rows} {} and {last}", others.join(", ")),
            _ if self.all_named => format!("at {rows} {}", names.join(", ")),
            _ => format!("at {} rows: {} and more", self.count, names.join(", ")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbouring_rows_are_one_range() {
        let rows = Rows::of(&[3, 5, 6, 7, 12]);
        assert_eq!(rows.in_words(), "at rows 3, 5 to 7 and 12");
        assert_eq!(rows.ranges().collect::<Vec<_>>(), [[3, 3], [5, 7], [12, 12]]);
        assert_eq!(Rows::of(&[4]).in_words(), "at row 4");
        assert_eq!(Rows::of(&[4, 5]).in_words(), "at rows 4 to 5");
    }

    #[test]
    fn many_rows_are_cut_and_counted() {
        let rows = Rows::of(&(0..100).map(|i| 2 * i).collect::<Vec<_>>());
        assert!(rows.in_words().starts_with("at 100 rows: 0, 2") && rows.in_words().ends_with("38 and more"));
        assert_eq!((rows.ranges().count(), rows.count()), (20, 100));
        let mut rows = Rows::none();
        [0, 2, 2, 3].into_iter().for_each(|row| rows.push(row));
        assert_eq!((rows.in_words().as_str(), rows.count()), ("at rows 0 and 2 to 3", 3));
        assert_eq!(Rows::counted(7, 3).in_words(), "at 7 rows, the first of them 3");
        assert_eq!(Rows::counted(1, 3).in_words(), "at row 3");
    }
}
