//! The points of a sweep: all combinations of the values of its axes, the last axis fastest.

use super::request::axes::Axis;

/// The axes of a grid.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    axes: Vec<Axis>,
}

/// Points inside that are looked at beside the corners.
const SAMPLES: usize = 100;

impl Grid {
    /// The grid of at least one axis, each of at least one value.
    pub(super) fn of(axes: Vec<Axis>) -> Self {
        Self { axes }
    }

    /// Number of its points.
    pub(super) fn len(&self) -> usize {
        self.axes.iter().map(|axis| axis.steps.len()).product()
    }

    pub(super) fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// Adds the values of a point to `values`.
    pub(super) fn point(&self, index: usize, values: &mut Vec<f64>) {
        let start = values.len();
        let mut rest = index;
        for axis in self.axes.iter().rev() {
            values.push(axis.steps.at(rest % axis.steps.len()));
            rest /= axis.steps.len();
        }
        values[start..].reverse();
    }

    /// The corners, then points spread over the whole.
    pub(super) fn samples(&self) -> Vec<Vec<f64>> {
        let corner = |which: usize| {
            let end = |(i, axis): (usize, &Axis)| axis.steps.at(if which >> i & 1 == 0 { 0 } else { axis.steps.len() - 1 });
            self.axes.iter().enumerate().map(end).collect()
        };
        let all = self.len();
        let inside = |i: usize| {
            let mut values = Vec::new();
            self.point(i * all / (SAMPLES + 1), &mut values);
            values
        };
        (0..1 << self.axes.len()).map(corner).chain((1..=SAMPLES).map(inside)).collect()
    }
}

#[cfg(test)]
mod tests {
    use terramechanics_reading::Path;

    use super::*;
    use crate::api::sweep::request::axes::Steps;

    fn grid() -> Grid {
        let path = Path::of_pointer("/slip").expect("a pointer");
        let axis = |values: &[f64]| Axis { path: path.clone(), steps: Steps::List(values.to_vec()) };
        Grid::of(vec![axis(&[1.0, 2.0]), axis(&[3.0, 4.0, 5.0])])
    }

    #[test]
    fn the_last_axis_is_the_fastest() {
        let mut values = Vec::new();
        (0..grid().len()).for_each(|i| grid().point(i, &mut values));
        assert_eq!(values, [1.0, 3.0, 1.0, 4.0, 1.0, 5.0, 2.0, 3.0, 2.0, 4.0, 2.0, 5.0]);
    }

    #[test]
    fn the_samples_have_all_corners() {
        let samples = grid().samples();
        for corner in [[1.0, 3.0], [1.0, 5.0], [2.0, 3.0], [2.0, 5.0]] {
            assert!(samples[..4].contains(&corner.to_vec()), "{corner:?}");
        }
    }
}
