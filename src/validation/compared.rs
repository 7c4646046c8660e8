//! Which quantities are compared with measurements, and how a record and an operating point give them.

use terramechanics::OperatingPoint;

use super::points::Points;
use crate::quantity::About;

/// A quantity that is measured and predicted.
#[derive(Debug)]
pub(crate) struct Compared {
    pub(crate) about: About,
    /// Whether it is there only where the wheel moved at a slip angle.
    pub(crate) sideways: bool,
    /// Whether it is the quantity over the load.
    over_load: bool,
    predicted: fn(&OperatingPoint) -> f64,
    measured: fn(&Points) -> Option<&Vec<Option<f64>>>,
}

/// The pull.
pub(super) const PULL: Compared =
    Compared::new(About::new("longitudinal_force_n", "F_x", "N", "longitudinal force, the drawbar pull"), pull, |points| {
        points.longitudinal_force_n.as_ref()
    });

/// The pull over the load.
pub(super) const PULL_OVER_LOAD: Compared =
    Compared::new(About::new("drawbar_coefficient", "F_x/W", "1", "longitudinal force over the load"), pull, |points| {
        points.longitudinal_force_n.as_ref()
    })
    .over_load();

/// In the order of their columns.
pub(crate) static COMPARED: [Compared; 6] = [
    PULL,
    Compared::new(About::new("sinkage_m", "z", "m", "sinkage"), |point| point.sinkage, |points| points.sinkage_m.as_ref()),
    Compared::new(
        About::new("torque_n_m", "T", "N.m", "torque about the axle"),
        |point| point.forces.torque,
        |points| points.torque_n_m.as_ref(),
    ),
    PULL_OVER_LOAD,
    Compared::new(
        About::new("lateral_force_n", "F_y", "N", "lateral force, positive against the sideways motion"),
        lateral,
        |points| points.lateral_force_n.as_ref(),
    )
    .sideways(),
    Compared::new(About::new("lateral_coefficient", "F_y/W", "1", "lateral force over the load"), lateral, |points| {
        points.lateral_force_n.as_ref()
    })
    .over_load()
    .sideways(),
];

fn pull(point: &OperatingPoint) -> f64 {
    point.forces.longitudinal
}

fn lateral(point: &OperatingPoint) -> f64 {
    point.forces.side.map_or(f64::NAN, |side| side.lateral)
}

impl Compared {
    const fn new(
        about: About,
        predicted: fn(&OperatingPoint) -> f64,
        measured: fn(&Points) -> Option<&Vec<Option<f64>>>,
    ) -> Self {
        Self { about, sideways: false, over_load: false, predicted, measured }
    }

    const fn over_load(self) -> Self {
        Self { over_load: true, ..self }
    }

    const fn sideways(self) -> Self {
        Self { sideways: true, ..self }
    }

    fn scaled(&self, values: impl Iterator<Item = f64>, load: &[f64]) -> Vec<f64> {
        values.zip(load).map(|(value, load)| if self.over_load { value / load } else { value }).collect()
    }

    /// What was published of it, if it was measured.
    pub(super) fn published<'a>(&self, points: &'a Points) -> Option<&'a Vec<Option<f64>>> {
        (self.measured)(points)
    }

    /// What was measured at each point; NaN where it was not.
    pub(crate) fn measured(&self, points: &Points, load: &[f64]) -> Vec<f64> {
        match self.published(points) {
            Some(values) => self.scaled(values.iter().map(|value| value.unwrap_or(f64::NAN)), load),
            None => vec![f64::NAN; load.len()],
        }
    }

    /// What is predicted at each point; NaN where there is no solution.
    pub(crate) fn predicted<'a>(&self, points: impl Iterator<Item = Option<&'a OperatingPoint>>, load: &[f64]) -> Vec<f64> {
        self.scaled(points.map(|point| point.map_or(f64::NAN, self.predicted)), load)
    }
}
