//! All points that had an answer: where a new search may start.

/// A point with its outputs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Seen {
    /// Shares of the bounds.
    pub(crate) shares: Vec<f64>,
    pub(crate) outputs: Vec<f64>,
}

impl Seen {
    /// The largest difference in a share.
    pub(crate) fn distance(&self, shares: &[f64]) -> f64 {
        self.shares.iter().zip(shares).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }
}

/// The points, in the order in which they were seen.
#[derive(Debug, Clone, Default)]
pub(crate) struct Archive(Vec<Seen>);

impl Archive {
    pub(crate) fn push(&mut self, seen: Seen) {
        self.0.push(seen);
    }

    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    pub(crate) fn first(&self) -> Option<&Seen> {
        self.0.first()
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &Seen> {
        self.0.iter()
    }

    /// All values of an output.
    pub(crate) fn outputs(&self, output: usize) -> impl Iterator<Item = f64> + '_ {
        self.0.iter().map(move |seen| seen.outputs[output])
    }

    pub(crate) fn any(&self, is_so: impl Fn(&Seen) -> bool) -> bool {
        self.0.iter().any(is_so)
    }

    /// The points next to one, a few for each variable.
    pub(crate) fn nearest(&self, seen: &Seen) -> Vec<&Seen> {
        let mut near: Vec<(f64, &Seen)> = self.0.iter().map(|other| (other.distance(&seen.shares), other)).collect();
        let count = NEIGHBOURS * (seen.shares.len() + 1);
        if near.len() > count {
            near.select_nth_unstable_by(count, |a, b| a.0.total_cmp(&b.0));
            near.truncate(count);
        }
        near.into_iter().map(|(_, seen)| seen).collect()
    }
}

/// Points next to another that count, for each variable and one more.
const NEIGHBOURS: usize = 4;
