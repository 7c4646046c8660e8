//! The sum of squares of all shear tests, of which only the shear modulus has to be searched.

use crate::problem::Obstacle;
use crate::profile::Valley;
use crate::uncertainty::Uncertainty;

/// Shear moduli of the scan: twenty to a decade.
const SCANNED: u32 = 121;

/// Steps of the golden section: 0.618^64 of the scan's step is below rounding.
const SECTIONS: u32 = 64;

/// The same where a sum of squares is wanted and not its place: 0.618^12 of the scan's step is a third of a thousandth of it.
const FEW_SECTIONS: u32 = 12;

/// c, tan φ and K.
#[derive(Debug, Clone, Copy)]
pub(super) struct Law {
    pub(super) cohesion: f64,
    pub(super) tan_friction: f64,
    pub(super) modulus: f64,
}

impl Law {
    pub(super) fn shear(&self, normal: f64, displacement: f64) -> f64 {
        (self.cohesion + normal * self.tan_friction) * -(-displacement / self.modulus).exp_m1()
    }
}

/// All points: normal stress, displacement, shear stress, stresses in units of the largest.
pub(super) struct Points {
    pub(super) list: Vec<(f64, f64, f64)>,
    pub(super) unit: f64,
}

/// What is held while the others are fitted.
#[derive(Debug, Clone, Copy)]
enum Held {
    Nothing,
    Cohesion(f64),
    TanFriction(f64),
}

impl Points {
    /// The best c and tan φ at a modulus, both at or above 0, and the sum of squares that they leave.
    fn at(&self, modulus: f64, held: Held) -> (Law, f64) {
        let (mut ee, mut es, mut ss, mut et, mut st) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for &(normal, displacement, shear) in &self.list {
            let share = -(-displacement / modulus).exp_m1();
            let pressed = share * normal;
            ee += share * share;
            es += share * pressed;
            ss += pressed * pressed;
            et += share * shear;
            st += pressed * shear;
        }
        let determinant = ee * ss - es * es;
        let free = ((ss * et - es * st) / determinant, (ee * st - es * et) / determinant);
        // The sum is convex: where the free minimum breaks a bound, the best is on a bound.
        let (cohesion, tan_friction) = match (held, free.0 >= 0.0, free.1 >= 0.0) {
            (Held::Cohesion(cohesion), ..) => (cohesion, ((st - cohesion * es) / ss).max(0.0)),
            (Held::TanFriction(tan_friction), ..) => (((et - tan_friction * es) / ee).max(0.0), tan_friction),
            (Held::Nothing, true, true) => free,
            (Held::Nothing, false, _) => (0.0, (st / ss).max(0.0)),
            (Held::Nothing, true, false) => ((et / ee).max(0.0), 0.0),
        };
        let law = Law { cohesion, tan_friction, modulus };
        (law, self.squares(&law))
    }

    pub(super) fn squares(&self, law: &Law) -> f64 {
        let left = |&(normal, displacement, shear): &(f64, f64, f64)| (law.shear(normal, displacement) - shear).powi(2);
        let squares: f64 = self.list.iter().map(left).sum();
        if squares.is_finite() { squares } else { f64::INFINITY }
    }

    /// Modulus of the scan: six decades about the farthest displacement.
    fn scanned(&self, i: u32) -> f64 {
        let farthest = self.list.iter().map(|(_, displacement, _)| *displacement).fold(0.0, f64::max);
        farthest * 10_f64.powf(f64::from(i) / 20.0 - 4.5)
    }

    /// The best modulus: by the scan, then between its neighbours.
    pub(super) fn best(&self) -> Law {
        self.least(Held::Nothing, SECTIONS).0
    }

    fn least(&self, held: Held, sections: u32) -> (Law, f64) {
        let cost = |log: f64| self.at(log.exp(), held).1;
        let costs: Vec<f64> = (0..SCANNED).map(|i| self.at(self.scanned(i), held).1).collect();
        let best = (0..SCANNED).min_by(|&i, &k| costs[i as usize].total_cmp(&costs[k as usize])).unwrap_or(0);
        let golden = 0.5 * (5_f64.sqrt() - 1.0);
        let ends = [best.saturating_sub(1), (best + 1).min(SCANNED - 1)];
        let [mut low, mut high] = ends.map(|i| self.scanned(i).ln());
        let (mut left, mut right) = (high - golden * (high - low), low + golden * (high - low));
        let (mut at_left, mut at_right) = (cost(left), cost(right));
        for _ in 0..sections {
            if at_left <= at_right {
                (high, right, at_right) = (right, left, at_left);
                left = high - golden * (high - low);
                at_left = cost(left);
            } else {
                (low, left, at_left) = (left, right, at_right);
                right = low + golden * (high - low);
                at_right = cost(right);
            }
        }
        self.at((0.5 * (low + high)).exp(), held)
    }
}

/// The sum of squares about its minimum, over c, tan φ and ln K.
pub(super) struct ShearValley<'a> {
    pub(super) points: &'a Points,
    pub(super) law: &'a Law,
    pub(super) uncertainty: &'a Uncertainty,
    pub(super) useful: [f64; 3],
}

impl ShearValley<'_> {
    fn above(&self, squares: f64) -> f64 {
        (squares - self.points.squares(self.law)).max(0.0)
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
        Ok(self.above(self.points.squares(&law)))
    }

    fn rise(&self, i: usize, step: f64, most: f64) -> Result<f64, Obstacle> {
        let (_, squares) = match i {
            0 => self.points.least(Held::Cohesion(self.law.cohesion + step), FEW_SECTIONS),
            1 => self.points.least(Held::TanFriction(self.law.tan_friction + step), FEW_SECTIONS),
            _ => self.points.at(self.law.modulus * step.exp(), Held::Nothing),
        };
        Ok(self.above(squares).min(most))
    }
}
