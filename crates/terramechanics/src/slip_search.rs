//! At which slip does a pull take a given value? The search that a wheel and a vehicle share.
//!
//! The pull rises with slip, but not throughout: it may have a maximum, end where the contact ends, or jump at s = 0 between two laws
//! of braking. So the slips are walked from 0 outward, in steps that grow with the slip because the pull rises fastest near 0. Where
//! two neighbours lie on different sides of the value, Brent's method finds the slip between them. Where none do, the extremum of the
//! samples is refined by golden section, because the value may lie between the largest sample and the maximum. The walk starts to the
//! side on which a pull that rises with slip has the value. So the slip nearest to 0 on that side is found, unless two lie between
//! neighbouring samples.

use crate::error::Error;
use crate::numerics::brent::{Sample, bracketed_root};
use crate::pull::Nearest;

/// Samples on one side of 0.
const STEPS: u32 = 24;

/// Samples for the largest pull, which need only find the hump.
const FEW_STEPS: u32 = 8;

/// Halvings that close in on the last slip with a solution.
const HALVINGS: u32 = 30;

/// Steps of the golden section, after which the bracket is below 1e-8 of its first width and a flat maximum is met to rounding.
const GOLDEN_STEPS: u32 = 40;

/// Jumps through the value that are passed over on one side.
const MOST_JUMPS: u32 = 2;

/// Relative tolerance of the slip; the error of a load balance hides what is finer.
const TOLERANCE: f64 = 1e-13;

/// Largest miss of the value, as a share of that of the bracket's worse end: beyond it the pull jumps past the value.
const LARGEST_MISS: f64 = 1e-6;

/// How a search ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Searched {
    /// The slip at which the pull has the value.
    Met { slip: f64 },
    /// No slip has it: what comes nearest.
    Missed { slip: f64, pull: f64, nearest: Nearest },
}

/// The slip nearest to 0 at which `pull` has `value`, between `least` < 0 and `most` > 0; slips at which there is no pull are
/// passed over. At most about 1500 evaluations, and usually 20.
///
/// # Errors
/// The first of `pull`, where it has none at any slip that was tried.
pub(crate) fn slip_of_pull(
    pull: impl FnMut(f64) -> Result<f64, Error>,
    value: f64,
    (least, most): (f64, f64),
) -> Result<Searched, Error> {
    let mut search = Search { pull, value, best: None, refusal: None, jumped: false };
    let start = search.at(0.0);
    if let Some(Sample { y: 0.0, .. }) = start {
        return Ok(Searched::Met { slip: 0.0 });
    }
    let sides = if start.is_some_and(|start| start.y > 0.0) { [least, most] } else { [most, least] };
    for end in sides {
        if let Some(slip) = search.side(start, end) {
            return Ok(Searched::Met { slip });
        }
    }
    search.missed()
}

/// The largest pull at slips from 0 to `most`, with its slip.
///
/// # Errors
/// The first of `pull`, where it has none at any slip that was tried.
pub(crate) fn largest_pull(mut pull: impl FnMut(f64) -> Result<f64, Error>, most: f64) -> Result<Sample, Error> {
    let mut refusal = None;
    let mut at = |slip: f64| match pull(slip) {
        Ok(pull) if pull.is_nan() => None,
        Ok(pull) => Some(Sample { x: slip, y: pull }),
        Err(error) => {
            refusal = refusal.or(Some(error));
            None
        }
    };
    let slips = (0..=FEW_STEPS).map(|i| place(most, i, FEW_STEPS));
    let samples: Vec<Option<Sample>> = slips.map(&mut at).collect();
    let Some((i, highest)) = highest(&samples, |sample| sample.y) else { return Err(refusal.unwrap_or(Error::NotFinite)) };
    let Some((before, after)) = neighbours(&samples, i) else { return Ok(highest) };
    let summit = golden(before.x, after.x, f64::INFINITY, &mut at, |sample| sample.y);
    Ok(summit.filter(|summit| summit.y > highest.y).unwrap_or(highest))
}

/// The slip at a step of the walk from 0 to `end` in so many steps.
fn place(end: f64, step: u32, steps: u32) -> f64 {
    end * (f64::from(step) / f64::from(steps)).powi(2)
}

/// The sample of the highest score, with its index.
fn highest(samples: &[Option<Sample>], score: impl Fn(&Sample) -> f64) -> Option<(usize, Sample)> {
    let there = samples.iter().enumerate().filter_map(|(i, sample)| Some((i, (*sample)?)));
    there.max_by(|(_, a), (_, b)| score(a).total_cmp(&score(b)))
}

/// The samples on both sides of one; none where it is an end.
fn neighbours(samples: &[Option<Sample>], i: usize) -> Option<(Sample, Sample)> {
    let at = |i: usize| samples.get(i).copied().flatten();
    Some((at(i.checked_sub(1)?)?, at(i + 1)?))
}

/// The sample of the highest score between two slips by golden section, or the first whose score is `enough`; none where a slip between
/// them has no sample.
fn golden(
    mut left: f64,
    mut right: f64,
    enough: f64,
    mut at: impl FnMut(f64) -> Option<Sample>,
    score: impl Fn(&Sample) -> f64,
) -> Option<Sample> {
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    let mut inner_left = at(right - GOLDEN * (right - left))?;
    let mut inner_right = at(left + GOLDEN * (right - left))?;
    for _ in 0..GOLDEN_STEPS {
        let left_is_higher = score(&inner_left) > score(&inner_right);
        let higher = if left_is_higher { inner_left } else { inner_right };
        if score(&higher) >= enough {
            return Some(higher);
        }
        if left_is_higher {
            (right, inner_right) = (inner_right.x, inner_left);
            inner_left = at(right - GOLDEN * (right - left))?;
        } else {
            (left, inner_left) = (inner_left.x, inner_right);
            inner_right = at(left + GOLDEN * (right - left))?;
        }
    }
    Some(if score(&inner_left) > score(&inner_right) { inner_left } else { inner_right })
}

struct Search<F> {
    pull: F,
    value: f64,
    /// The sample nearest to the value.
    best: Option<Sample>,
    /// Why the first slip without a pull has none.
    refusal: Option<Error>,
    jumped: bool,
}

impl<F: FnMut(f64) -> Result<f64, Error>> Search<F> {
    /// The pull minus the value at a slip.
    fn excess(&mut self, slip: f64) -> Result<f64, Error> {
        let excess = (self.pull)(slip)? - self.value;
        if excess.is_nan() {
            return Err(Error::NotFinite);
        }
        if self.best.is_none_or(|best| excess.abs() < best.y.abs()) {
            self.best = Some(Sample { x: slip, y: excess });
        }
        Ok(excess)
    }

    fn at(&mut self, slip: f64) -> Option<Sample> {
        match self.excess(slip) {
            Ok(excess) => Some(Sample { x: slip, y: excess }),
            Err(error) => {
                self.refusal = self.refusal.or(Some(error));
                None
            }
        }
    }

    /// The slip between 0 and `end`.
    fn side(&mut self, start: Option<Sample>, end: f64) -> Option<f64> {
        let mut samples: Vec<Option<Sample>> = vec![start];
        let (mut jumps, mut has_edge) = (0, false);
        for i in 1..=STEPS {
            let slip = place(end, i, STEPS);
            let before = samples.last().copied().flatten();
            let here = self.at(slip);
            samples.push(here);
            let bracket = match (before, here) {
                (Some(before), Some(here)) => Some((before, here)),
                // Of several ends of the contact the first is closed in on.
                (Some(known), None) if !has_edge => {
                    has_edge = true;
                    self.beside_gap(known, slip)
                }
                (None, Some(known)) if !has_edge && i > 1 => {
                    has_edge = true;
                    self.beside_gap(known, place(end, i - 1, STEPS)).map(|(known, other)| (other, known))
                }
                _ => None,
            };
            let Some((a, b)) = bracket.filter(|(a, b)| a.y * b.y <= 0.0) else { continue };
            if let Some(slip) = self.root(a, b) {
                return Some(slip);
            }
            jumps += 1;
            self.jumped = true;
            if jumps == MOST_JUMPS {
                return None;
            }
        }
        if jumps > 0 { None } else { self.beyond_samples(&samples) }
    }

    /// The slip at which the pull has the value in a bracket; none where it jumps past it there.
    fn root(&mut self, a: Sample, b: Sample) -> Option<f64> {
        let scale = a.y.abs().max(b.y.abs());
        let found = bracketed_root(|slip| self.excess(slip), a, b, TOLERANCE).ok()?.best;
        (found.y.abs() <= LARGEST_MISS * scale).then_some(found.x)
    }

    /// Two slips with the value between them, between one that has a pull and one that has none.
    fn beside_gap(&mut self, mut known: Sample, mut gap: f64) -> Option<(Sample, Sample)> {
        for _ in 0..HALVINGS {
            match self.at(0.5 * (known.x + gap)) {
                Some(here) if here.y * known.y <= 0.0 => return Some((known, here)),
                Some(here) => known = here,
                None => gap = 0.5 * (known.x + gap),
            }
        }
        None
    }

    /// The slip where the value lies between the sample that comes nearest to it and the extremum beside that.
    fn beyond_samples(&mut self, samples: &[Option<Sample>]) -> Option<f64> {
        let (i, nearest) = highest(samples, |sample| -sample.y.abs())?;
        let (before, after) = neighbours(samples, i)?;
        let rise = -nearest.y.signum(); // towards the value
        let summit = golden(before.x, after.x, 0.0, |slip| self.at(slip), |sample| rise * sample.y)?;
        if rise * summit.y >= 0.0 { self.root(before, summit) } else { None }
    }

    fn missed(self) -> Result<Searched, Error> {
        let Some(best) = self.best else { return Err(self.refusal.unwrap_or(Error::NotFinite)) };
        let nearest = match (self.jumped, best.y < 0.0) {
            (true, _) => Nearest::AtJump,
            (false, true) => Nearest::Largest,
            (false, false) => Nearest::Least,
        };
        Ok(Searched::Missed { slip: best.x, pull: best.y + self.value, nearest })
    }
}
