//! What makes one point better than another.

use std::cmp::Ordering;

use crate::archive::{Archive, Seen};
use crate::scale::spread;
use crate::task::{Goal, Limit, Sense, Side};

/// Share of a limit by which it may be missed: rounding, no more. A limit of zero is kept exactly.
const SLACK: f64 = 1e-9;

/// A goal under limits, with the scale of each.
#[derive(Debug, Clone)]
pub(crate) struct Aim {
    pub(crate) goal: Goal,
    pub(crate) limits: Vec<Limit>,
    goal_scale: f64,
    limit_scales: Vec<f64>,
}

impl Aim {
    /// A goal under limits; the scales are those of the points seen so far.
    pub(crate) fn new(goal: Goal, limits: Vec<Limit>, seen: &Archive) -> Self {
        let goal_scale = spread(seen.outputs(goal.output));
        let limit_scales = limits.iter().map(|limit| spread(seen.outputs(limit.output))).collect();
        Self { goal, limits, goal_scale, limit_scales }
    }

    /// What is to become small, by its scale.
    pub(crate) fn objective(&self, seen: &Seen) -> f64 {
        let output = seen.outputs[self.goal.output] / self.goal_scale;
        match self.goal.sense {
            Sense::Minimise => output,
            Sense::Maximise => -output,
        }
    }

    /// How far each limit is kept, by its scale; negative where it is missed.
    pub(crate) fn margins<'a>(&'a self, seen: &'a Seen) -> impl Iterator<Item = f64> + 'a {
        self.limits.iter().zip(&self.limit_scales).map(|(limit, scale)| limit.margin(seen.outputs[limit.output]) / scale)
    }

    /// The same aim by the scales of the points next to one: for a search from there.
    pub(crate) fn near(&self, seen: &Seen, archive: &Archive) -> Self {
        let near = archive.nearest(seen);
        let scale = |output: usize| spread(near.iter().map(|seen| seen.outputs[output]));
        let limit_scales = self.limits.iter().map(|limit| scale(limit.output)).collect();
        Self { goal_scale: scale(self.goal.output), limit_scales, limits: self.limits.clone(), goal: self.goal }
    }

    /// Whether the point keeps limit `i`.
    pub(crate) fn keeps(&self, i: usize, seen: &Seen) -> bool {
        let limit = &self.limits[i];
        limit.margin(seen.outputs[limit.output]) >= -SLACK * limit.value.abs()
    }

    /// Whether the point keeps limit `i` by less than that share of it.
    pub(crate) fn is_active(&self, i: usize, seen: &Seen, share: f64) -> bool {
        self.margin_by_size(i, seen) <= share
    }

    /// The limits with one of them looser by that share of its size.
    pub(crate) fn loosened(&self, i: usize, share: f64) -> Vec<Limit> {
        let mut limits = self.limits.clone();
        let by = share * self.size(i);
        match limits[i].side {
            Side::AtLeast => limits[i].value -= by,
            Side::AtMost => limits[i].value += by,
        }
        limits
    }

    /// How far the point keeps limit `i`, by the size of the limit.
    fn margin_by_size(&self, i: usize, seen: &Seen) -> f64 {
        let limit = &self.limits[i];
        limit.margin(seen.outputs[limit.output]) / self.size(i)
    }

    /// The size of limit `i`: of a limit of zero it is the spread of its output.
    fn size(&self, i: usize) -> f64 {
        let value = self.limits[i].value;
        if value == 0.0 { self.limit_scales[i] } else { value.abs() }
    }

    /// Whether the point keeps all limits.
    pub(crate) fn is_kept(&self, seen: &Seen) -> bool {
        (0..self.limits.len()).all(|i| self.keeps(i, seen))
    }

    /// By how much the worst limit is missed, by its scale; not positive where all are kept.
    pub(crate) fn excess(&self, seen: &Seen) -> f64 {
        self.margins(seen).fold(0.0, |worst, margin| f64::max(worst, -margin))
    }

    /// The rank of a point among those that keep the limits, or among those that do not; the smaller the better.
    pub(crate) fn rank(&self, seen: &Seen) -> f64 {
        if self.is_kept(seen) { self.objective(seen) } else { self.excess(seen) }
    }

    /// Which of two points comes first: one that keeps the limits always does.
    pub(crate) fn order(&self, one: &Seen, other: &Seen) -> Ordering {
        (!self.is_kept(one)).cmp(&!self.is_kept(other)).then(self.rank(one).total_cmp(&self.rank(other)))
    }

    /// Whether a point is better than another.
    pub(crate) fn is_better(&self, one: &Seen, other: &Seen) -> bool {
        self.order(one, other) == Ordering::Less
    }
}
