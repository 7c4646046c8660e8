//! Do the data bound an estimate on both sides? A comparison of the cost near the minimum with the parabola that a standard error
//! assumes.
//!
//! A standard error assumes that the cost is a parabola: at the end of the interval it has risen by t² s², with the other
//! unknowns refitted (Bates & Watts 1988, Nonlinear Regression Analysis and Its Applications, ch. 6). An unknown may saturate,
//! such as the shear modulus of a soil that is sheared far beyond it. The cost then rises on one side and stays level on the
//! other, and a value that looks determined is not. So the cost is evaluated at both ends, with the other unknowns moved along
//! the valley; this takes one set of predictions. Where the cost differs from the parabola, the others are refitted there and,
//! if necessary, farther out.
//!
//! If the rise at an end is half of the assumed one, the true value lies beyond it in 1 − Φ(1.96 √0.5) = 8.3 % of all cases
//! instead of 2.5 %, and the interval still contains it in 89 %. Below that, the end is moved out to where the cost has risen
//! as assumed.
//!
//! Whether an unknown is bounded at all is decided at the far end, where the estimate would no longer be of use, and by a
//! stricter limit. Among many fits to data that carry no information on the unknown, some look determined by chance, and
//! exactly those would be reported. For the same reason an interval that passes this limit only just is extended to the far
//! end: it was selected by chance, and the usual interval would be too short (the winner's curse).

use crate::estimate::{Bound, Identifiability};
use crate::obstacle::Obstacle;
use crate::uncertainty::Uncertainty;

/// Rise at an end, relative to the assumed one, that has to be reached.
const SHARE: f64 = 0.5;

/// Relative difference from the assumed rise along the valley above which the other unknowns are refitted.
const AGREEMENT: f64 = 0.3;

/// Least rise at the far end, relative to the assumed rise at the end of the interval, for an unknown to count as bounded. It
/// belongs to 1.96 √3 = 3.4 standard errors, which chance exceeds on one side in 3 of 10 000 cases.
const FAR_RISE: f64 = 3.0;

/// The same ratio above which the interval was not selected by chance: 4.8 standard errors.
const SURE_RISE: f64 = 6.0;

/// Share of the useful width below which the cost cannot turn within the interval.
const NARROW: f64 = 0.3;

/// Share of the useful width over which any function is close to a straight line.
const STRAIGHT: f64 = 1e-3;

/// Steps of the search for an end.
const STEPS: u32 = 5;

/// The cost near a minimum, over scaled unknowns. Sides are −1 and 1.
pub(crate) trait Valley {
    /// What the derivatives at the minimum tell.
    fn uncertainty(&self) -> &Uncertainty;

    /// Change of the unknown `i` that would matter.
    fn useful(&self, i: usize) -> f64;

    /// Distance to the bound of the unknown `i` on a side.
    fn room(&self, i: usize, side: f64) -> f64;

    /// Whether that bound is physical: cohesion and friction cannot be below 0.
    fn is_natural(&self, i: usize, side: f64) -> bool;

    /// Rise of the cost at a step from the minimum, with the other unknowns moved along the valley.
    fn rise_along(&self, i: usize, step: f64) -> Result<f64, Obstacle>;

    /// The same with the other unknowns refitted, where it is known to be at most `most`.
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
    /// Judges the interval of ± `half` about the scaled unknown `i`.
    ///
    /// # Errors
    /// The budget, where it is spent.
    pub(crate) fn of(valley: &impl Valley, i: usize, half: f64) -> Result<Self, Obstacle> {
        if half < STRAIGHT * valley.useful(i) {
            return Ok(Self([Flank::End(half); 2]));
        }
        Ok(Self([flank(valley, i, half, -1.0)?, flank(valley, i, half, 1.0)?]))
    }

    /// The ends about a centre; on a side without an end, the bound.
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
    // The range down to zero is part of the interval.
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

/// A distance, found by doubling, at which the cost has risen as assumed.
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
