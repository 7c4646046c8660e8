//! The sum of squares over all shear tests. Only the shear modulus has to be searched.

use crate::consent::{Consent, POINTS_PER_QUESTION, Stopped};
use crate::obstacle::Obstacle;
use crate::profile::Valley;
use crate::uncertainty::Uncertainty;

/// Shear moduli of the scan: twenty to a decade.
const SCANNED: u32 = 121;

/// Steps of the golden section: 0.618^64 of the scan's step is below rounding.
const SECTIONS: u32 = 64;

/// Fewer steps where the value of the minimum is wanted and not its place: 0.618^12 is a third of a thousandth of the scan's
/// step.
const FEW_SECTIONS: u32 = 12;

/// Squared sine of the angle between the columns of c and tan φ below which they differ by rounding alone. A hundredth of the
/// points under a normal stress that differs by a thousandth give 1e-8.
const ONE_COLUMN: f64 = 1e-13;

/// c, tan φ and K.
#[derive(Debug, Clone, Copy)]
pub(super) struct Law {
    pub(super) cohesion: f64,
    pub(super) tan_friction: f64,
    pub(super) modulus: f64,
}

/// 1 − e^(−j/K), the share of the strength that is mobilised: 0 without displacement, whatever the modulus.
pub(super) fn mobilised(displacement: f64, modulus: f64) -> f64 {
    if displacement == 0.0 { 0.0 } else { -(-displacement / modulus).exp_m1() }
}

/// The derivative of that share with respect to ln K: −x e^(−x) with x = j/K, which tends to 0 for a displacement far beyond the
/// modulus.
pub(super) fn mobilised_by_log_modulus(displacement: f64, modulus: f64) -> f64 {
    let ratio = displacement / modulus;
    if ratio.is_finite() { -ratio * (-ratio).exp() } else { 0.0 }
}

impl Law {
    pub(super) fn strength(&self, normal: f64) -> f64 {
        self.cohesion + normal * self.tan_friction
    }

    pub(super) fn shear(&self, normal: f64, displacement: f64) -> f64 {
        self.strength(normal) * mobilised(displacement, self.modulus)
    }
}

/// A point of a test: stresses in units of the largest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub(super) normal: f64,
    pub(super) displacement: f64,
    pub(super) shear: f64,
}

/// The points of all tests.
pub(super) struct Points<'a> {
    pub(super) list: Vec<Point>,
    /// The largest stress (Pa).
    pub(super) unit: f64,
    /// The largest displacement (m).
    pub(super) farthest: f64,
    pub(super) consent: &'a Consent<'a>,
}

/// Which unknown is held while the others are fitted.
#[derive(Debug, Clone, Copy)]
enum Held {
    Nothing,
    Cohesion(f64),
    TanFriction(f64),
}

impl Points<'_> {
    /// Visits every point, as long as the caller wants to go on.
    pub(super) fn each(&self, mut of: impl FnMut(usize, &Point)) -> Result<(), Stopped> {
        for (block, points) in self.list.chunks(POINTS_PER_QUESTION).enumerate() {
            self.consent.ask()?;
            for (i, point) in points.iter().enumerate() {
                of(block * POINTS_PER_QUESTION + i, point);
            }
        }
        Ok(())
    }

    /// The best c and tan φ for this modulus, both at or above 0, and the remaining sum of squares.
    fn at(&self, modulus: f64, held: Held) -> Result<(Law, f64), Stopped> {
        let (mut ee, mut es, mut ss, mut et, mut st) = (0.0, 0.0, 0.0, 0.0, 0.0);
        self.each(|_, &Point { normal, displacement, shear }| {
            let share = mobilised(displacement, modulus);
            let pressed = share * normal;
            ee += share * share;
            es += share * pressed;
            ss += pressed * pressed;
            et += share * shear;
            st += pressed * shear;
        })?;
        let law = |cohesion, tan_friction| Law { cohesion, tan_friction, modulus };
        let (friction_alone, cohesion_alone) = (law(0.0, ratio(st, ss)), law(ratio(et, ee), 0.0));
        let determinant = ee * ss - es * es;
        let free = ((ss * et - es * st) / determinant, (ee * st - es * et) / determinant);
        // The sum is convex: where the free minimum breaks a bound, the best is on a bound.
        let best = match (held, free.0 >= 0.0, free.1 >= 0.0) {
            (Held::Cohesion(cohesion), ..) => law(cohesion, ratio(st - cohesion * es, ss)),
            (Held::TanFriction(tan_friction), ..) => law(ratio(et - tan_friction * es, ee), tan_friction),
            (Held::Nothing, ..) if ss < f64::MIN_POSITIVE || determinant <= ONE_COLUMN * ee * ss => {
                let (by_friction, by_cohesion) = (self.squares(&friction_alone)?, self.squares(&cohesion_alone)?);
                let is_friction = by_friction <= by_cohesion;
                return Ok(if is_friction { (friction_alone, by_friction) } else { (cohesion_alone, by_cohesion) });
            }
            (Held::Nothing, true, true) => law(free.0, free.1),
            (Held::Nothing, false, _) => friction_alone,
            (Held::Nothing, true, false) => cohesion_alone,
        };
        Ok((best, self.squares(&best)?))
    }

    pub(super) fn squares(&self, law: &Law) -> Result<f64, Stopped> {
        let mut squares = 0.0;
        self.each(|_, point| squares += (law.shear(point.normal, point.displacement) - point.shear).powi(2))?;
        Ok(if squares.is_finite() { squares } else { f64::INFINITY })
    }

    /// A modulus of the scan, which covers six decades around the largest displacement.
    fn scanned(&self, i: u32) -> f64 {
        self.farthest * 10_f64.powf(f64::from(i) / 20.0 - 4.5)
    }

    /// The best modulus: from the scan, then by golden section between the neighbours.
    pub(super) fn best(&self) -> Result<Law, Stopped> {
        Ok(self.least(Held::Nothing, SECTIONS)?.0)
    }

    fn least(&self, held: Held, sections: u32) -> Result<(Law, f64), Stopped> {
        let cost = |log: f64| self.at(log.exp(), held).map(|(_, squares)| squares);
        let costs: Vec<f64> =
            (0..SCANNED).map(|i| self.at(self.scanned(i), held).map(|(_, squares)| squares)).collect::<Result<_, _>>()?;
        let best = (0..SCANNED).min_by(|&i, &k| costs[i as usize].total_cmp(&costs[k as usize])).unwrap_or(0);
        let golden = 0.5 * (5_f64.sqrt() - 1.0);
        let ends = [best.saturating_sub(1), (best + 1).min(SCANNED - 1)];
        let [mut low, mut high] = ends.map(|i| self.scanned(i).ln());
        let (mut left, mut right) = (high - golden * (high - low), low + golden * (high - low));
        let (mut at_left, mut at_right) = (cost(left)?, cost(right)?);
        for _ in 0..sections {
            if at_left <= at_right {
                (high, right, at_right) = (right, left, at_left);
                left = high - golden * (high - low);
                at_left = cost(left)?;
            } else {
                (low, left, at_left) = (left, right, at_right);
                right = low + golden * (high - low);
                at_right = cost(right)?;
            }
        }
        self.at((0.5 * (low + high)).exp(), held)
    }
}

/// The best factor of a column, at or above 0; 0 where the column is too small to determine it.
fn ratio(product: f64, square: f64) -> f64 {
    let ratio = product / square;
    if ratio.is_finite() { ratio.max(0.0) } else { 0.0 }
}

/// The sum of squares near its minimum, over c, tan φ and ln K.
pub(super) struct ShearValley<'a> {
    pub(super) points: &'a Points<'a>,
    pub(super) law: &'a Law,
    pub(super) uncertainty: &'a Uncertainty,
    pub(super) useful: [f64; 3],
}

impl ShearValley<'_> {
    fn above(&self, squares: f64) -> Result<f64, Obstacle> {
        Ok((squares - self.points.squares(self.law)?).max(0.0))
    }
}

impl Valley for ShearValley<'_> {
    fn uncertainty(&self) -> &Uncertainty {
        self.uncertainty
    }

    fn useful(&self, i: usize) -> f64 {
        self.useful[i]
    }

    fn room(&self, i: usize, side: f64) -> f64 {
        let modulus = self.law.modulus;
        match (i, side < 0.0) {
            (0, true) => self.law.cohesion,
            (1, true) => self.law.tan_friction,
            (2, true) => (modulus / self.points.scanned(0)).ln().abs(),
            (2, false) => (self.points.scanned(SCANNED - 1) / modulus).ln().abs(),
            _ => f64::INFINITY,
        }
    }

    fn is_natural(&self, i: usize, side: f64) -> bool {
        i < 2 && side < 0.0
    }

    fn rise_along(&self, i: usize, step: f64) -> Result<f64, Obstacle> {
        let moved = |k: usize| step * self.uncertainty.along_the_valley(i, k);
        let law = Law {
            cohesion: (self.law.cohesion + moved(0)).max(0.0),
            tan_friction: (self.law.tan_friction + moved(1)).max(0.0),
            modulus: self.law.modulus * moved(2).exp(),
        };
        self.above(self.points.squares(&law)?)
    }

    fn rise(&self, i: usize, step: f64, most: f64) -> Result<f64, Obstacle> {
        let (_, squares) = match i {
            0 => self.points.least(Held::Cohesion(self.law.cohesion + step), FEW_SECTIONS)?,
            1 => self.points.least(Held::TanFriction(self.law.tan_friction + step), FEW_SECTIONS)?,
            _ => self.points.at(self.law.modulus * step.exp(), Held::Nothing)?,
        };
        Ok(self.above(squares)?.min(most))
    }
}
