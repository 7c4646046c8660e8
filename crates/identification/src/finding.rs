//! The judgement on one unknown: value, error, and whether the data determine it at all.

use crate::design::DesignGap;
use crate::estimate::{Bound, Estimate, Identifiability};
use crate::problem::{Problem, Sought};
use crate::profile::Flanks;
use crate::range::{finite, finite_ends};
use crate::search::Found;
use crate::uncertainty::Uncertainty;
use crate::unknown::Unknown;
use crate::valley::FitValley;

/// What the judgement of every estimate is based on.
pub(crate) struct Judgement<'a> {
    pub(crate) problem: &'a Problem<'a>,
    pub(crate) best: &'a Found,
    pub(crate) others: &'a [Found],
    pub(crate) uncertainty: Option<&'a Uncertainty>,
    pub(crate) gaps: &'a [(DesignGap, Vec<Unknown>)],
    pub(crate) useful: &'a [f64],
}

/// Share of the useful width by which another solution has to differ to count as another.
const DIFFERENT: f64 = 0.01;

impl Judgement<'_> {
    pub(crate) fn estimate(&self, i: usize) -> Estimate {
        let Sought { unknown, bounds, .. } = self.problem.sought[i];
        let value = self.best.values[i];
        let slope = self.problem.scales[i].slope(value).abs();
        let at_bound = match value {
            value if value <= bounds.lower => Some(Bound::Lower),
            value if value >= bounds.upper => Some(Bound::Upper),
            _ => None,
        };
        let scale = self.problem.scales[i];
        let of = |list: fn(&Uncertainty) -> &Vec<Option<f64>>| self.uncertainty.and_then(|known| list(known)[i]);
        let half_width = of(|known| &known.half_width);
        let centre = scale.inward(value);
        let mut estimate = Estimate {
            unknown,
            value,
            standard_error: of(|known| &known.standard_error).and_then(|error| finite(error * slope)),
            interval: half_width.and_then(|half| finite_ends([centre - half, centre + half].map(|end| scale.outward(end)))),
            at_bound,
            identifiability: self.identifiability(i, half_width, at_bound),
        };
        if estimate.identifiability == Identifiability::Determined
            && let (Some(half), Some(uncertainty)) = (half_width, self.uncertainty)
        {
            let valley = FitValley { problem: self.problem, best: self.best, uncertainty, useful: self.useful };
            match Flanks::of(&valley, i, half) {
                Ok(flanks) => {
                    estimate.interval = finite_ends(flanks.ends(centre).map(|end| scale.outward(end)));
                    estimate.identifiability = flanks.finding();
                }
                // An estimate that the budget left unchecked is not called determined.
                Err(_) => estimate.identifiability = Identifiability::Uncertain,
            }
            if matches!(estimate.identifiability, Identifiability::OneSided(_)) {
                estimate.standard_error = None;
            }
        }
        estimate
    }

    /// The gravest finding; `half_width` is on the scaled unknown.
    fn identifiability(&self, i: usize, half_width: Option<f64>, at_bound: Option<Bound>) -> Identifiability {
        let unknown = self.problem.sought[i].unknown;
        let Some(known) = self.uncertainty else { return Identifiability::Uncertain };
        if known.without_effect[i] {
            return Identifiability::WithoutEffect;
        }
        if known.is_dead(i) {
            let others = known.moved_with(i).into_iter().map(|k| self.problem.sought[k].unknown).collect();
            return Identifiability::Inseparable(others);
        }
        if let Some((gap, together)) = self.gaps.iter().find(|(_, together)| together.contains(&unknown)) {
            let others = together.iter().copied().filter(|&other| other != unknown).collect();
            return Identifiability::Unseparated(*gap, others);
        }
        let scale = self.problem.scales[i];
        let distance = |found: &Found| (scale.inward(found.values[i]) - scale.inward(self.best.values[i])).abs();
        if let Some(other) = self.others.iter().find(|found| distance(found) > DIFFERENT * self.useful[i]) {
            return Identifiability::SeveralSolutions { other: other.values[i] };
        }
        if half_width.is_none_or(|half| half > self.useful[i]) {
            return Identifiability::Uncertain;
        }
        if at_bound.is_some() { Identifiability::AtBound } else { Identifiability::Determined }
    }
}
