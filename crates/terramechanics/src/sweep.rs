//! How do the forces change with slip? The same operation at many slips, row by row.
//!
//! A row is the operating point itself, so what follows from a point follows from a row by the same formula. By a closed form it
//! differs from the point alone by rounding, less than 1e-12 of it (`abreast/`). Where the sinkage is solved for, the search of a row
//! starts from the rows before it, and ends within its tolerance of where it would end alone.

use crate::abreast::{ABREAST, Abreast, Plan};
use crate::error::Error;
use crate::numerics::lanes::LANES;
use crate::one_contact::{AT_ONCE, OneContact};
use crate::operating_point::{OperatingPoint, Sinkage};
use crate::operation::Operation;
use crate::slip::Slip;

/// One slip of a sweep, with what holds there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepRow {
    /// The slip.
    pub slip: Slip,
    /// The operating point, or why there is none.
    pub point: Result<OperatingPoint, Error>,
}

impl SweepRow {
    /// The row after others of the same operation, which tell where its solution is likely to be.
    #[inline]
    fn after(rows: &[Self], operation: &Operation, slip: Slip) -> Self {
        let near = match operation.sinkage {
            Sinkage::CarryingLoad(_) => extrapolated_sinkage(latest_points(rows), slip),
            Sinkage::Given(_) | Sinkage::FromStatic { .. } | Sinkage::UnderLoad { .. } => None,
        };
        Self { slip, point: operation.near(slip, &operation.sinkage, near) }
    }
}

/// The points of the latest rows, each a slip with its sinkage (m), the latest first, up to a row without one.
fn latest_points(rows: &[SweepRow]) -> impl Iterator<Item = (Slip, f64)> {
    rows.iter().rev().map_while(|row| row.point.as_ref().ok().map(|point| (point.slip, point.sinkage)))
}

/// Points that a sinkage is extrapolated from: their polynomial over the slip is of the third degree.
pub(crate) const NEIGHBOURS: usize = 4;

/// Largest factor from the latest sinkage to one that counts as near.
const NEAR: f64 = 1.5;

/// The sinkage (m) at `slip` that other points of one load lead to, each a slip with its sinkage (m), the latest first; none where
/// they say nothing, or lead far away.
pub(crate) fn extrapolated_sinkage(points: impl Iterator<Item = (Slip, f64)>, slip: Slip) -> Option<f64> {
    let mut known = [(0.0, 0.0); NEIGHBOURS];
    let mut count = 0;
    for (known, (slip, sinkage)) in known.iter_mut().zip(points) {
        *known = (slip.ratio(), sinkage);
        count += 1;
    }
    let known = &mut known[..count];
    let (_, latest) = *known.first()?;
    // Neville's scheme: each step joins neighbouring polynomials to one of a degree more.
    for degree in 1..count {
        for i in 0..count - degree {
            let (near, far) = (known[i].0, known[i + degree].0);
            known[i].1 += (slip.ratio() - near) / (far - near) * (known[i + 1].1 - known[i].1);
        }
    }
    let found = known[0].1;
    (found < NEAR * latest && found > latest / NEAR).then_some(found)
}

/// An operation over slip.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SlipSweep {
    /// One per slip, in the order of the slips.
    pub rows: Vec<SweepRow>,
}

impl SlipSweep {
    /// The points of `operation` at each of `slips`.
    #[must_use]
    pub fn of(operation: &Operation, slips: &[Slip]) -> Self {
        let mut sweep = Self::with_capacity(slips.len());
        sweep.fill(operation, slips);
        sweep
    }

    /// A sweep without rows, with room for `rows`.
    #[must_use]
    pub fn with_capacity(rows: usize) -> Self {
        Self { rows: Vec::with_capacity(rows) }
    }

    /// The same into rows that are there already, without allocating where there are enough of them.
    pub fn fill(&mut self, operation: &Operation, slips: &[Slip]) {
        self.rows.clear();
        self.extend(operation, slips);
    }

    /// Adds the rows of `slips`, for a caller that has to look up between some of them. All rows of a sweep are of one `operation`.
    pub fn extend(&mut self, operation: &Operation, slips: &[Slip]) {
        self.rows.reserve(slips.len());
        let Operation { system, model, sinkage } = operation;
        if let Some(contact) = OneContact::of(system, model, sinkage) {
            for slips in slips.chunks(AT_ONCE) {
                contact.find(slips, |i, point| self.push_found(operation, slips[i], point));
            }
            return;
        }
        let Some(plan) = Plan::of(system, model, sinkage) else {
            slips.iter().for_each(|&slip| self.push(operation, slip));
            return;
        };
        let mut abreast = Abreast::of(plan);
        // Balances are guessed from the rows before.
        let at_once = if matches!(operation.sinkage, Sinkage::CarryingLoad(_)) { LANES } else { ABREAST };
        for slips in slips.chunks(at_once) {
            let near = self.near(operation, slips);
            let near = near.as_ref().map(|near| &near[..]);
            abreast.find(slips, near, |i, point| self.push_found(operation, slips[i], point));
        }
    }

    /// Adds the row of a point that was found, or else finds it.
    #[inline(always)]
    fn push_found(&mut self, operation: &Operation, slip: Slip, point: Option<OperatingPoint>) {
        match point {
            Some(point) => self.rows.push(SweepRow { slip, point: Ok(point) }),
            None => self.push(operation, slip),
        }
    }

    /// Sinkages (m) at slips to come that the latest rows lead to.
    fn near(&self, operation: &Operation, slips: &[Slip]) -> Option<[f64; LANES]> {
        if !matches!(operation.sinkage, Sinkage::CarryingLoad(_)) {
            return None;
        }
        let mut near = [f64::NAN; LANES];
        for (near, &slip) in near.iter_mut().zip(slips) {
            *near = extrapolated_sinkage(latest_points(&self.rows), slip)?;
        }
        Some(near)
    }

    /// Adds the row of `slip`. All rows of a sweep are of one `operation`.
    pub fn push(&mut self, operation: &Operation, slip: Slip) {
        let row = SweepRow::after(&self.rows, operation, slip);
        self.rows.push(row);
    }

    /// The points there are, each with the index of its row.
    pub fn points(&self) -> impl Iterator<Item = (usize, &OperatingPoint)> {
        self.rows.iter().enumerate().filter_map(|(row, of)| Some((row, of.point.as_ref().ok()?)))
    }

    /// The rows without a point: index, slip and reason.
    pub fn gaps(&self) -> impl Iterator<Item = (usize, Slip, Error)> {
        self.rows.iter().enumerate().filter_map(|(row, of)| Some((row, of.slip, of.point.err()?)))
    }
}
