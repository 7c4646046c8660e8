//! Where is the normal stress of grains largest?
//!
//! The edge is sampled closely where γ swings, over all of it first, then between the neighbours of the highest place, until the
//! samples are close. A quartic through five of them gives the rest. The stress is flat there, so it has all of its digits where the
//! place has six or so.

use super::LeadingEdge;
use crate::numerics::brent::Sample;
use crate::numerics::elementary::Number;
use crate::numerics::lanes::LANES;
use crate::numerics::level::level;
use fearless_simd::prelude::*;
use fearless_simd::{Simd, dispatch, f64x8};

/// Vectors of places over the whole edge.
const VECTORS: usize = 2;

/// Most times that the places between two are sampled, to find the highest of them at neither end.
const ROUNDS: u32 = 5;

/// Largest step between samples through which the quartic is laid: its vertex is off by about the fourth power.
const CLOSE: f64 = 0.05;

impl LeadingEdge {
    /// Angle θ (rad) of the largest normal stress.
    pub(crate) fn peak(&self) -> f64 {
        let chord = dispatch!(level(), simd => self.highest(simd));
        2.0 * (0.5 * chord).asin()
    }

    /// Its chord (–).
    #[inline(always)]
    fn highest<L: Simd>(&self, simd: L) -> f64 {
        let (scale, whole) = self.crowding();
        let stride = whole / (VECTORS * LANES) as f64;
        let mut highest = Sample { x: 0.0, y: f64::NEG_INFINITY };
        for vector in 0..VECTORS {
            let first = (vector * LANES) as f64 * stride;
            let row = self.row(simd, scale, [first, stride]);
            let best = row[highest_of(&row)];
            highest = if best.y > highest.y { best } else { highest };
        }
        let (mut left, mut right) = ((highest.x - stride).max(0.0), (highest.x + stride).min(whole));
        for _ in 0..ROUNDS {
            let step = (right - left) / (LANES - 1) as f64;
            let row = self.row(simd, scale, [left, step]);
            let best = highest_of(&row);
            (left, right) = ((row[best].x - step).max(left), (row[best].x + step).min(right));
            highest = row[best];
            if best == 0 || best == LANES - 1 || step > CLOSE {
                continue;
            }
            let centre = best.clamp(2, LANES - 3);
            let place = row[centre].x
                + step * vertex([row[centre - 2].y, row[centre - 1].y, row[centre].y, row[centre + 1].y, row[centre + 2].y]);
            if place.is_finite() {
                highest.x = place.clamp(left, right);
            }
            break;
        }
        self.chord(scale, highest.x)
    }

    /// Chord w = e sinh u (–) at a place u, where e is the `scale` of the crowding.
    #[inline(always)]
    fn chord<F: Number>(&self, scale: f64, place: F) -> F {
        let growth = place.exp();
        ((growth - growth.like(1.0) / growth) * (0.5 * scale)).at_most(self.reach)
    }

    /// σ/ξ (m) at eight places.
    #[inline(always)]
    fn row<L: Simd>(&self, simd: L, scale: f64, [first, step]: [f64; 2]) -> [Sample; LANES] {
        let places = f64x8::simd_from(simd, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]) * step + first;
        let at = self.at(self.chord(scale, places));
        let stresses = at.depth * at.normal;
        let mut row = [Sample { x: first, y: 0.0 }; LANES];
        for (lane, sample) in row.iter_mut().enumerate() {
            *sample = Sample { x: places[lane], y: stresses[lane] };
        }
        row
    }
}

/// Which sample is the highest.
#[inline(always)]
fn highest_of(row: &[Sample; LANES]) -> usize {
    let mut best = 0;
    for lane in 1..LANES {
        best = if row[lane].y > row[best].y { lane } else { best };
    }
    best
}

/// Place of the vertex of the quartic through five samples a step apart, in steps from the middle one; not a number where they are on
/// a line.
#[inline(always)]
fn vertex([a, b, c, d, e]: [f64; 5]) -> f64 {
    let (near, far) = (d - b, e - a);
    let (near_sum, far_sum) = (d + b, e + a);
    let (slope, jerk) = ((8.0 * near - far) / 12.0, 0.5 * far - near);
    let (bend, snap) = ((16.0 * near_sum - far_sum - 30.0 * c) / 12.0, far_sum - 4.0 * near_sum + 6.0 * c);
    let mut place = -slope / bend;
    for _ in 0..2 {
        let left = slope + place * (bend + place * (0.5 * jerk + place * snap / 6.0));
        place -= left / (bend + place * (jerk + place * 0.5 * snap));
    }
    place
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::circles::{Circles, SlipRadius};
    use crate::contact::Contact;
    use crate::rolling::WheelOnSoil;
    use crate::slip::Slip;
    use crate::soil::{Soil, SoilParams};
    use crate::wheel::{Wheel, WheelParams};

    /// Places of a plain search over the edge, evenly over the angle and evenly over the logarithm of the chord.
    const PLACES: u32 = 2000;

    /// Share of the stress by which the search may stay below the highest of them.
    const ROUNDING: f64 = 1e-12;

    fn largest_of_many(edge: &LeadingEdge) -> f64 {
        let share = |i: u32| f64::from(i) / f64::from(PLACES);
        let even = (0..=PLACES).map(|i| edge.reach * share(i));
        let near_the_exit = (0..=PLACES).map(|i| edge.reach * 1e-14_f64.powf(share(i)));
        let stress = |chord: f64| {
            let place = edge.at(chord);
            place.depth * place.normal
        };
        even.chain(near_the_exit).map(stress).fold(f64::NEG_INFINITY, f64::max)
    }

    #[test]
    fn no_place_of_the_edge_has_a_larger_stress() {
        let powers = || (0..=90).map(|i| 10f64.powf(-0.1 * f64::from(i)));
        let even = (-50..=50).map(|i| 0.02 * f64::from(i));
        let slips: Vec<f64> = powers().flat_map(|size| [size, -size, 1.0 - size, size - 1.0]).chain(even).collect();
        let lugs = [(0.0, SlipRadius::Rim), (0.05, SlipRadius::LugTip), (0.3, SlipRadius::Shearing)];
        for (lug_height, slip) in lugs {
            let wheel = WheelParams { radius: 1.0, width: 1.0, lug_height, lug_coefficient: 0.5 };
            let system = WheelOnSoil {
                wheel: Wheel::new(wheel).expect("a wheel"),
                soil: Soil::new(SoilParams::BARE).expect("a soil"),
                contact: Contact::MIDPOINT.with_circles(Circles { slip, ..Circles::SHEARING }),
            };
            for &ratio in &slips {
                let rolling = system.rolling_in_grains(Slip::new(ratio).expect("a slip"));
                for sinkage in [1e-9, 1e-6, 1e-3, 0.01, 0.03, 0.1, 0.2, 0.35, 0.5, 0.75, 0.9, 1.0] {
                    let edge = LeadingEdge::of_unit_stiffness(&rolling, sinkage).expect("an edge");
                    let place = edge.at_angle(edge.peak()).expect("a place of the edge");
                    let (found, largest) = (place.depth * place.normal, largest_of_many(&edge));
                    assert!(found >= largest * (1.0 - ROUNDING), "{lug_height} {ratio} {sinkage}: {found} of {largest}");
                }
            }
        }
    }
}
