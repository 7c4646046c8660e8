//! Which panels does an integral along the rim need? Few at first, the worst halved until the error is small enough.
//!
//! A panel is a range of u in [0, 1], see [`quadrature`](super::quadrature); its sums say how well they are resolved.

use std::ops::Range;

/// Panels after which no more are halved.
pub(super) const PANELS: usize = 48;

/// Relative error at which refining stops.
pub(super) const TOLERANCE: f64 = 1e-10;

/// Rounding left in any sum of this length.
pub(super) const ROUNDING: f64 = 2e-15;

/// Ends of panels to begin with at the most: of a coupled stress both ends, a layer of shear, two reversals and two places where
/// the slip velocity turns.
const MOST_EDGES: usize = 7;

/// Sums over a panel, or over all of them, with their errors.
pub(super) trait Resolved: Copy + Default {
    /// Adds the sums of another panel.
    fn add(&mut self, other: &Self);
    /// The error relative to the size of the sums.
    fn relative_error(&self) -> f64;
    /// The error relative to the size of the sums over all panels.
    fn error_share(&self, total: &Self) -> f64;
}

/// Error from the null sums: the rule's own error falls about as their square, taken as the power 1.5 so that it is not
/// underestimated where the coefficients decay slowly.
pub(super) fn error_of(null: [f64; 2], size: f64) -> f64 {
    let [high, higher] = null.map(|sum| sum / size);
    let share = 10.0 * (high * high + higher * higher).sqrt();
    if size > 0.0 { size * share * share.sqrt() } else { 0.0 }
}

/// Ends of the first panels, ascending from 0 to 1.
pub(super) struct Edges {
    places: [f64; MOST_EDGES],
    count: usize,
}

impl Edges {
    /// The first end alone.
    #[inline]
    pub(super) fn new() -> Self {
        Self { places: [0.0; MOST_EDGES], count: 1 }
    }

    /// Whether one panel has all, once they are closed.
    pub(super) fn are_of_one_panel(&self) -> bool {
        self.count == 2
    }

    /// An end at t = u⁴, if u lies inside `within`.
    #[inline]
    pub(super) fn split(&mut self, t: f64, within: Range<f64>) {
        let u = t.sqrt().sqrt();
        if u > within.start && u < within.end {
            self.places[self.count] = u;
            self.count += 1;
        }
    }

    /// The ranges between the ends, each in so many equal parts.
    pub(super) fn ranges(&self, parts: u32) -> impl Iterator<Item = [f64; 2]> {
        self.places[..self.count].windows(2).flat_map(move |ends| {
            let at = move |part: u32| ends[0] + (ends[1] - ends[0]) * (f64::from(part) / f64::from(parts));
            (0..parts).map(move |part| [at(part), at(part + 1)])
        })
    }

    /// The ends with the last one.
    #[inline]
    pub(super) fn close(mut self) -> Self {
        self.places[self.count] = 1.0;
        self.count += 1;
        self.places[..self.count].sort_unstable_by(f64::total_cmp);
        self
    }
}

/// A range of u and the sums over it.
#[derive(Clone, Copy, Default)]
struct Panel<S> {
    from: f64,
    to: f64,
    sums: S,
}

/// The sums over all panels, of which `sums` gives those over a range of u; at most `FEW` panels to begin with.
#[inline]
pub(super) fn integrate<S: Resolved, const FEW: usize>(edges: &Edges, sums: impl Fn(f64, f64) -> S) -> S {
    if edges.are_of_one_panel() {
        let only = Panel { from: 0.0, to: 1.0, sums: sums(0.0, 1.0) };
        return if only.sums.relative_error() <= TOLERANCE { only.sums } else { refine(&[only], sums) };
    }
    let mut few = [Panel::default(); FEW];
    let panels = &mut few[..edges.count - 1];
    for (panel, edge) in panels.iter_mut().zip(edges.places.windows(2)) {
        *panel = Panel { from: edge[0], to: edge[1], sums: sums(edge[0], edge[1]) };
    }
    let total = total(panels);
    if total.relative_error() <= TOLERANCE { total } else { refine(panels, sums) }
}

fn total<S: Resolved>(panels: &[Panel<S>]) -> S {
    let mut total = panels[0].sums;
    for panel in &panels[1..] {
        total.add(&panel.sums);
    }
    total
}

/// Halves the worst panel until the error is small enough or there are [`PANELS`]. Apart, because few contacts need it.
#[cold]
fn refine<S: Resolved>(coarse: &[Panel<S>], sums: impl Fn(f64, f64) -> S) -> S {
    let mut panels = [Panel::default(); PANELS];
    panels[..coarse.len()].copy_from_slice(coarse);
    let mut used = coarse.len();
    loop {
        let total = total(&panels[..used]);
        if total.relative_error() <= TOLERANCE || used == PANELS {
            return total;
        }
        let mut worst = 0;
        for i in 1..used {
            if panels[i].sums.error_share(&total) > panels[worst].sums.error_share(&total) {
                worst = i;
            }
        }
        let Panel { from, to, .. } = panels[worst];
        let middle = 0.5 * (from + to);
        panels[worst] = Panel { from, to: middle, sums: sums(from, middle) };
        panels[used] = Panel { from: middle, to, sums: sums(middle, to) };
        used += 1;
    }
}
