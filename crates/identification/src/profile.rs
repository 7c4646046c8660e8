//! Do the data bound an estimate on both sides? The cost beside the minimum, against what the errors presume of it.
//!
//! A standard error presumes that the cost rises as a parabola: at the end of the interval by t² s², with the other unknowns
//! refitted (Bates & Watts 1988, Nonlinear Regression Analysis and Its Applications, ch. 6). Where an unknown saturates, such as
//! the shear modulus of a soil that is sheared far beyond it, the cost rises on one side and runs level on the other, and a value
//! that looks determined is none. So the cost is taken at both ends, the others moved along the valley, which one set of
//! predictions shows; where that is not what was presumed, the others are refitted there and, if need be, farther out.
//!
//! Where the rise at an end is half of the presumed one, the truth lies beyond it in 1 − Φ(1.96 √0.5) = 8.3 % of all cases instead
//! of 2.5 %, and the interval still holds it in 89 %. Below that the end is moved out to where the cost has risen as presumed.
//!
//! Whether an unknown is bounded at all is asked at the far end, where the estimate would no longer be of use, and more strictly:
//! among many fits to data that do not know the unknown, those that seem to by chance are the very ones that would be called
//! determined. For the same reason an interval that passes narrowly reaches to the far end: chance has chosen it, and the usual one
//! would be too short (the winner's curse).

use crate::estimate::{Bound, Identifiability};
use crate::obstacle::Obstacle;
use crate::uncertainty::Uncertainty;

/// Rise at an end, over the presumed one, that has to be reached.
const SHARE: f64 = 0.5;

/// How far the rise along the valley may be off the presumed one before the others are refitted.
const AGREEMENT: f64 = 0.3;

/// Rise at the far end, over that presumed at the end of the interval, below which nothing is bounded: at 1.96 √3 = 3.4 standard
/// errors, which chance passes on one side in 3 of 10 000 cases.
const FAR_RISE: f64 = 3.0;

/// The same from which on the interval is not chosen by chance: at 4.8 standard errors.
const SURE_RISE: f64 = 6.0;

/// Share of the useful width below which an interval is too narrow for the cost to turn beyond it.
const NARROW: f64 = 0.3;

/// Share of the useful width below which any function is a straight line.
const STRAIGHT: f64 = 1e-3;

/// Steps of the search for an end.
const STEPS: u32 = 5;

/// The cost about a minimum, over scaled unknowns. Sides are −1 and 1.
pub(crate) trait Valley {
    /// What the derivatives at the minimum tell.
    fn uncertainty(&self) -> &Uncertainty;

    /// Change of the unknown `i` that would matter.
    fn useful(&self, i: usize) -> f64;

    /// How far the bound of the unknown `i` is away on a side.
    fn room(&self, i: usize, side: f64) -> f64;

    /// Whether that bound is nature's: no cohesion and no friction are below 0.
    fn is_natural(&self, i: usize, side: f64) -> bool;

    /// How much the cost rises a step from the minimum, with the others moved along the valley.
    fn rise_along(&self, i: usize, step: f64) -> Result<f64, Obstacle>;

    /// The same with the others refitted, where that is known to be at most `most`.
    fn rise(&self, i: usize, step: f64, most: f64) -> Result<f64, Obstacle>;
}

/// How an interval ends on one side, as a distance from the estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Flank {
    /// Near enough.
    End(f64),
    /// Too far away to be of use.
    Wide(f64),
    /// Nowhere before the bound.
    Open(f64),
}

/// What the cost says of an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Flanks([Flank; 2]);

impl Flanks {
    /// What becomes of the interval of ± `half` about the scaled unknown `i`.
    ///
    /// # Errors
    /// The budget, where it is spent.
    pub(crate) fn of(valley: &impl Valley, i: usize, half: f64) -> Result<Self, Obstacle> {
        if half < STRAIGHT * valley.useful(i) {
            return Ok(Self([Flank::End(half); 2]));
        }
        Ok(Self([flank(valley, i, half, -1.0)?, flank(valley, i, half, 1.0)?]))
    }

    /// The ends about a centre; the bound at a side that nothing else ends.
    pub(crate) fn ends(&self, centre: f64) -> [f64; 2] {
        let [below, above] = self.0.map(|flank| match flank {
            Flank::End(distance) | Flank::Wide(distance) | Flank::Open(distance) => distance,
        });
        [centre - below, centre + above]
    }

    /// What an estimate that looks determined is.
    pub(crate) fn finding(&self) -> Identifiability {
        match self.0 {
            [Flank::End(_), Flank::End(_)] => Identifiability::Determined,
            [Flank::Open(_), Flank::End(_)] => Identifiability::OneSided(Bound::Upper),
            [Flank::End(_), Flank::Open(_)] => Identifiability::OneSided(Bound::Lower),
            _ => Identifiability::Uncertain,
        }
    }
}

fn flank(valley: &impl Valley, i: usize, half: f64, side: f64) -> Result<Flank, Obstacle> {
    let room = valley.room(i, side);
    let useful = valley.useful(i);
    let presumed = valley.uncertainty().presumed_rise(i, half);
    let near = half.min(room);
    let along = valley.rise_along(i, side * near)?;
    let agrees = (along / (presumed * (near / half).powi(2)) - 1.0).abs() <= AGREEMENT;
    if agrees && near == half && half <= NARROW * useful {
        return Ok(Flank::End(half));
    }
    // The way down to nothing is part of the interval.
    if valley.is_natural(i, side) && room <= useful {
        return Ok(Flank::End(half));
    }
    let rise = valley.rise(i, side * near, along)?;
    let far = useful.max(half).min(room);
    let far_rise = if far > near { valley.rise(i, side * far, f64::INFINITY)? } else { rise };
    let turns = far_rise < SHARE * presumed * (far / half).powi(2);
    if turns && far_rise < FAR_RISE * presumed {
        let is_open =
            (far >= room && far_rise < presumed) || (room.is_finite() && valley.rise(i, side * room, f64::INFINITY)? < presumed);
        return Ok(if is_open { Flank::Open(room) } else { Flank::Wide(beyond(valley, i, side * far, presumed)?) });
    }
    if turns && far_rise < SURE_RISE * presumed {
        return Ok(Flank::End(far));
    }
    if rise >= SHARE * presumed && near == half {
        return Ok(Flank::End(half));
    }
    let [mut inner, mut outer] = if rise < presumed { [near, far] } else { [0.0, near] };
    for _ in 0..STEPS {
        let middle = 0.5 * (inner + outer);
        if valley.rise(i, side * middle, f64::INFINITY)? < presumed { inner = middle } else { outer = middle }
    }
    Ok(Flank::End(outer))
}

/// A distance, found by doubling, at which the cost has risen as presumed.
fn beyond(valley: &impl Valley, i: usize, step: f64, presumed: f64) -> Result<f64, Obstacle> {
    let room = valley.room(i, step);
    let mut distance = step.abs();
    for _ in 0..STEPS {
        if distance >= room || valley.rise(i, distance.copysign(step), f64::INFINITY)? >= presumed {
            break;
        }
        distance = (2.0 * distance).min(room);
    }
    Ok(distance)
}
