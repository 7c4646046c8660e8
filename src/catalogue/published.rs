//! What was published of a value, by how many sources that do not depend on each other, and how far it lies apart.

use std::collections::BTreeSet;

use super::record::{Grade, Values};

/// The least number of independent sources from which a kind has a range of its own. Two numbers of one laboratory lie as near to each
/// other as its tests repeat, which says nothing of other soils.
const FEWEST_SOURCES: usize = 3;

/// The median of numbers in ascending order; of an even number of them, the mean of the two in the middle, as a decimal.
fn median(ascending: &[f64]) -> Option<f64> {
    let upper = ascending.get(ascending.len() / 2)?;
    let lower = ascending.get(ascending.len().checked_sub(1)? / 2)?;
    // Published numbers are short decimals, and so is their mean, but for the last digits of a sum of binary numbers.
    format!("{:.12e}", 0.5 * (lower + upper)).parse().ok()
}

/// A published value and what published it.
pub(super) struct Published {
    pub(super) value: f64,
    pub(super) source: &'static str,
}

impl Published {
    /// What is published of a value by those who measured or quoted it.
    pub(super) fn of(values: &'static Values, grade: Grade, source: &'static str, name: &str) -> Option<Self> {
        Some(Self::by(founded(values, grade, name)?, values, source, name))
    }

    /// A value of that name, published by a source of its own, else by that of the record.
    pub(super) fn by(value: f64, values: &'static Values, source: &'static str, name: &str) -> Self {
        Self { value, source: values.get(name).and_then(|value| value.source.as_deref()).unwrap_or(source) }
    }

    /// The publication, without the table or page: all up to its year, else the whole.
    fn publication(&self) -> &'static str {
        let is_year = |text: &str| text.len() == 4 && text.bytes().all(|byte| byte.is_ascii_digit());
        let mut openings = self.source.match_indices('(');
        let end = openings.find(|(at, _)| self.source.get(at + 1..at + 5).is_some_and(is_year));
        end.map_or(self.source, |(at, _)| &self.source[..at + 5])
    }
}

/// The middle and the ends of numbers, how many there are and of how many sources.
pub(super) struct Spread {
    count: usize,
    pub(super) sources: usize,
    pub(super) median: f64,
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Spread {
    pub(super) fn of(published: impl Iterator<Item = Published>) -> Option<Self> {
        let (mut values, mut publications) = (Vec::new(), BTreeSet::new());
        for one in published {
            values.push(one.value);
            publications.insert(one.publication());
        }
        values.sort_by(f64::total_cmp);
        Some(Self {
            count: values.len(),
            sources: publications.len(),
            median: median(&values)?,
            low: *values.first()?,
            high: *values.last()?,
        })
    }

    /// What the value is: the median of `what` over entries, or that of the only one there is.
    fn in_words(&self, what: &str, [one, several]: [&str; 2], which: &str) -> String {
        match self.count {
            1 => format!("{what} of the one {one} {which} that publishes it"),
            count => format!("median {what} of the {count} {several} {which} that publish it, from {}", of_sources(self.sources)),
        }
    }
}

/// So many sources in words.
fn of_sources(count: usize) -> String {
    counted(count, ["independent source", "independent sources"])
}

/// A number with what it counts.
fn counted(count: usize, [one, several]: [&str; 2]) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {several}") }
}

/// Entries from which a value may be taken.
pub(super) struct Alike<'a> {
    /// Which they are, behind their noun.
    pub(super) which: &'a str,
    pub(super) spread: Option<Spread>,
}

/// The spread over the entries of a kind, where that has enough sources, else over the first of `wider` that has, the last of them
/// being all; and what it is in words.
pub(super) fn of_kind_or_wider(
    kind: &str,
    what: &str,
    entries: [&str; 2],
    of_kind: Option<Spread>,
    wider: impl IntoIterator<Item = Alike<'static>>,
) -> Option<(String, Spread)> {
    let sources = of_kind.as_ref().map_or(0, |spread| spread.sources);
    let are_enough = |spread: &Spread| spread.sources >= FEWEST_SOURCES;
    if let Some(spread) = of_kind.filter(are_enough) {
        return Some((spread.in_words(what, entries, &format!("of the kind `{kind}`")), spread));
    }
    let mut chosen = None;
    for Alike { which, spread } in wider {
        let Some(spread) = spread else { continue };
        let is_enough = are_enough(&spread);
        chosen = Some((which, spread));
        if is_enough {
            break;
        }
    }
    let (which, spread) = chosen?;
    let few = match sources {
        0 => format!("none of the kind `{kind}` does"),
        few => format!("the kind `{kind}` has {}, too few for a range of its own", of_sources(few)),
    };
    Some((format!("{}; {few}", spread.in_words(what, entries, which)), spread))
}

/// What was published of a value by those who measured or quoted it. What was itself assigned from elsewhere does not count.
pub(super) fn founded(values: &Values, grade: Grade, name: &str) -> Option<f64> {
    values.get(name).filter(|value| value.grade.unwrap_or(grade) != Grade::Proxy).map(|value| value.value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_median_is_in_the_middle() {
        assert_eq!(
            [median(&[]), median(&[3.0]), median(&[1.0, 2.0]), median(&[1.0, 2.0, 9.0])],
            [None, Some(3.0), Some(1.5), Some(2.0)]
        );
        assert_eq!(median(&[0.0114, 0.013]), Some(0.0122));
    }

    #[test]
    fn a_publication_is_named_up_to_its_year() {
        let publication = |source| Published { value: 0.0, source }.publication();
        assert_eq!(publication("Heiken, G. H. (eds.) (1991), ch. 9, Table 9.4"), "Heiken, G. H. (eds.) (1991");
        assert_eq!(publication("A letter (Fig. 1)"), "A letter (Fig. 1)");
        assert_eq!(publication("Größe (µ"), "Größe (µ");
    }
}
