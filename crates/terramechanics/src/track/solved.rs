//! The latest solved sinkages of a track, from which the search for the next one starts.

use crate::operating_point::Sinkage;
use crate::slip::Slip;
use crate::sweep::{NEIGHBOURS, extrapolated_sinkage};

/// The latest samples under one load: slip and sinkage (m), the latest first.
#[derive(Debug, Clone, Default)]
pub(super) struct Solved {
    load: f64,
    points: [Option<(Slip, f64)>; NEIGHBOURS],
}

impl Solved {
    /// The sinkage (m) at `slip` that the samples before lead to; none for another load, and where none is solved for.
    pub(super) fn near(&self, sinkage: &Sinkage, slip: Slip) -> Option<f64> {
        match *sinkage {
            Sinkage::CarryingLoad(load) if load == self.load => {
                // A steady wheel has one slip for long, and no polynomial goes through one slip twice.
                let same = self.points.iter().flatten().find(|(known, _)| *known == slip);
                same.map(|(_, sinkage)| *sinkage)
                    .or_else(|| extrapolated_sinkage(self.points.iter().map_while(|point| *point), slip))
            }
            _ => None,
        }
    }

    /// Keeps a sinkage (m) that was solved for.
    pub(super) fn keep(&mut self, sinkage: &Sinkage, slip: Slip, found: f64) {
        let Sinkage::CarryingLoad(load) = *sinkage else { return };
        if load != self.load {
            *self = Self { load, ..Self::default() };
        }
        if self.points.iter().flatten().any(|(known, _)| *known == slip) {
            return;
        }
        self.points.rotate_right(1);
        self.points[0] = Some((slip, found));
    }
}
