//! Root of a continuous function in a bracket (Brent 1973, Algorithms for Minimization without Derivatives, ch. 4).
//!
//! Interpolation where it helps, bisection where it does not. Brent's own safeguards let a flat root creep for hundreds of
//! evaluations; here the bracket is also halved whenever it has not shrunk to half within [`PATIENCE`] evaluations, so that
//! the number of evaluations is bounded by that times the bits of a double.

/// A point and the function's value there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sample {
    pub(crate) x: f64,
    pub(crate) y: f64,
}

/// Evaluations within which the bracket has to shrink to half.
const PATIENCE: u32 = 4;

/// Evaluations after which the search ends whatever happens.
const BUDGET: u32 = 320;

/// How a search ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Search {
    /// The best point found: the end of the bracket with the smaller |y|.
    pub(crate) best: Sample,
    /// Evaluations spent.
    pub(crate) evaluations: u32,
    /// Whether the bracket shrank to the tolerance or y to 0.
    pub(crate) converged: bool,
}

/// Root of `f` between `a` and `b`, at which f has opposite signs, to `relative_tolerance` in x.
///
/// An error of `f` ends the search and is returned.
pub(crate) fn bracketed_root<E>(
    mut f: impl FnMut(f64) -> Result<f64, E>,
    a: Sample,
    b: Sample,
    relative_tolerance: f64,
) -> Result<Search, E> {
    debug_assert!(a.y * b.y <= 0.0, "a bracket has opposite signs");
    // `best` is the latest and best estimate, `opposite` the other end of the bracket, `previous` the estimate before.
    let (mut previous, mut best) = (a, b);
    let mut opposite = previous;
    let mut step = best.x - previous.x;
    let mut step_before = step;
    let mut evaluations = 0;
    let mut watched_width = f64::INFINITY;
    loop {
        if opposite.y.abs() < best.y.abs() {
            previous = best;
            best = opposite;
            opposite = previous;
        }
        let tolerance = 2.0 * f64::EPSILON * best.x.abs() + 0.5 * relative_tolerance * best.x.abs();
        let to_middle = 0.5 * (opposite.x - best.x);
        let converged = to_middle.abs() <= tolerance || best.y == 0.0;
        if converged || evaluations >= BUDGET {
            return Ok(Search { best, evaluations, converged });
        }
        let mut creeping = false;
        if evaluations % PATIENCE == 0 {
            creeping = to_middle.abs() > 0.5 * watched_width;
            watched_width = to_middle.abs();
        }
        match interpolated_step(previous, best, opposite) {
            Some(trial)
                if !creeping
                    && step_before.abs() >= tolerance
                    && trial.abs() < (1.5 * to_middle.abs() - 0.5 * tolerance).min(0.5 * step_before.abs())
                    && trial * to_middle > 0.0 =>
            {
                step_before = step;
                step = trial;
            }
            _ => {
                step = to_middle;
                step_before = to_middle;
            }
        }
        previous = best;
        let moved = if step.abs() > tolerance { step } else { tolerance.copysign(to_middle) };
        best.x += moved;
        best.y = f(best.x)?;
        evaluations += 1;
        if (best.y > 0.0) == (opposite.y > 0.0) {
            opposite = previous;
            step = best.x - previous.x;
            step_before = step;
        }
    }
}

/// Step from `best` by the secant, or by the inverse parabola where three points differ; none where that is undefined.
fn interpolated_step(previous: Sample, best: Sample, opposite: Sample) -> Option<f64> {
    let step = if previous.x == opposite.x || previous.y == best.y || opposite.y == best.y || previous.y == opposite.y {
        -best.y * (opposite.x - best.x) / (opposite.y - best.y)
    } else {
        // Lagrange's form of x as a quadratic in y, at y = 0.
        let at = |p: Sample, q: Sample, r: Sample| (p.x - best.x) * q.y * r.y / ((p.y - q.y) * (p.y - r.y));
        at(previous, best, opposite) + at(opposite, best, previous)
    };
    step.is_finite().then_some(step)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;

    fn root(f: impl Fn(f64) -> f64, a: f64, b: f64) -> Search {
        let at = |x| Sample { x, y: f(x) };
        let Ok(found) = bracketed_root(|x| Ok::<_, Infallible>(f(x)), at(a), at(b), 1e-14);
        found
    }

    #[test]
    fn known_roots_are_found() {
        for (found, exact) in [
            (root(|x| x * x - 2.0, 0.0, 2.0), 2f64.sqrt()),
            (root(|x| x.cos() - x, 0.0, 1.0), 0.739_085_133_215_160_6),
            (root(|x| x.powi(9) - 1.0, -1.0, 1.5), 1.0),
            (root(|x| (x - 1.0).powi(3), 0.0, 2.5), 1.0),
        ] {
            assert!(found.converged);
            assert!(
                (found.best.x - exact).abs() <= 1e-13 * (1.0 + exact.abs()) || found.best.y.abs() < 1e-40,
                "{found:?} {exact}"
            );
        }
    }

    #[test]
    fn a_smooth_function_takes_few_evaluations_and_a_step_no_more_than_the_budget() {
        assert!(root(|x| x * x - 2.0, 0.0, 2.0).evaluations <= 10);
        let step = root(|x| if x < 0.3 { -1.0 } else { 1.0 }, 0.0, 1.0);
        assert!(step.converged && (step.best.x - 0.3).abs() < 1e-13);
    }

    #[test]
    fn an_error_of_the_function_is_returned() {
        let found = bracketed_root(|_| Err("no value"), Sample { x: 0.0, y: -1.0 }, Sample { x: 1.0, y: 1.0 }, 1e-12);
        assert_eq!(found, Err("no value"));
    }
}
