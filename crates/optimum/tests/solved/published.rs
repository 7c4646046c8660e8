//! Problems whose solutions are published: W. Hock and K. Schittkowski, Test Examples for Nonlinear Programming Codes, Lecture Notes
//! in Economics and Mathematical Systems 187, Springer 1981 (HS and its number), and functions from the literature of global
//! optimisation. Bounds that are infinite there are finite here, wide of the solution.

use super::tasks::{between, found, task};
use terramechanics_optimum::{StopReason, TaskParams, Variable};

/// Share of the goal, or of 1 where it is near zero, by which a minimum may be missed. A model of soil is never that sure.
const GOAL: f64 = 1e-8;

/// Distance at which the place of a minimum is found: the root of what the goal allows, for it is flat there.
const PLACE: f64 = 1e-4;

struct Case {
    name: &'static str,
    variables: Vec<Variable>,
    /// The goal, then what has to be at least zero.
    outputs: fn(&[f64]) -> Vec<f64>,
    least: f64,
    at: Vec<f64>,
}

fn sqrt(x: f64) -> f64 {
    x.sqrt()
}

fn hock_schittkowski() -> Vec<Case> {
    vec![
        Case {
            name: "HS 21",
            variables: vec![between(2.0, 50.0), between(-50.0, 50.0)],
            outputs: |x| vec![0.01 * x[0].powi(2) + x[1].powi(2) - 100.0, 10.0 * x[0] - x[1] - 10.0],
            least: -99.96,
            at: vec![2.0, 0.0],
        },
        Case {
            name: "HS 24",
            variables: vec![between(0.0, 10.0); 2],
            outputs: |x| {
                let goal = ((x[0] - 3.0).powi(2) - 9.0) * x[1].powi(3) / (27.0 * sqrt(3.0));
                let side = x[0] + sqrt(3.0) * x[1];
                vec![goal, x[0] / sqrt(3.0) - x[1], side, 6.0 - side]
            },
            least: -1.0,
            at: vec![3.0, sqrt(3.0)],
        },
        Case {
            name: "HS 29",
            variables: vec![between(0.0, 10.0); 3],
            outputs: |x| vec![-x[0] * x[1] * x[2], 48.0 - x[0].powi(2) - 2.0 * x[1].powi(2) - 4.0 * x[2].powi(2)],
            least: -16.0 * sqrt(2.0),
            at: vec![4.0, 2.0 * sqrt(2.0), 2.0],
        },
        Case {
            name: "HS 30",
            variables: vec![between(1.0, 10.0), between(-10.0, 10.0), between(-10.0, 10.0)],
            outputs: |x| vec![x.iter().map(|x| x * x).sum(), x[0].powi(2) + x[1].powi(2) - 1.0],
            least: 1.0,
            at: vec![1.0, 0.0, 0.0],
        },
        Case {
            name: "HS 31",
            variables: vec![between(-10.0, 10.0), between(1.0, 10.0), between(-10.0, 1.0)],
            outputs: |x| vec![9.0 * x[0].powi(2) + x[1].powi(2) + 9.0 * x[2].powi(2), x[0] * x[1] - 1.0],
            least: 6.0,
            at: vec![1.0 / sqrt(3.0), sqrt(3.0), 0.0],
        },
        Case {
            name: "HS 33",
            variables: vec![between(0.0, 10.0), between(0.0, 10.0), between(0.0, 5.0)],
            outputs: |x| {
                let [a, b, c] = [x[0].powi(2), x[1].powi(2), x[2].powi(2)];
                vec![(x[0] - 1.0) * (x[0] - 2.0) * (x[0] - 3.0) + x[2], c - b - a, a + b + c - 4.0]
            },
            least: sqrt(2.0) - 6.0,
            at: vec![0.0, sqrt(2.0), sqrt(2.0)],
        },
        Case {
            name: "HS 34",
            variables: vec![between(0.0, 100.0), between(0.0, 100.0), between(0.0, 10.0)],
            outputs: |x| vec![-x[0], x[1] - x[0].exp(), x[2] - x[1].exp()],
            least: -10_f64.ln().ln(),
            at: vec![10_f64.ln().ln(), 10_f64.ln(), 10.0],
        },
        Case {
            name: "HS 35, Beale",
            variables: vec![between(0.0, 10.0); 3],
            outputs: |x| {
                let squares = 2.0 * x[0].powi(2) + 2.0 * x[1].powi(2) + x[2].powi(2);
                let linear = 9.0 - 8.0 * x[0] - 6.0 * x[1] - 4.0 * x[2];
                vec![linear + squares + 2.0 * x[0] * x[1] + 2.0 * x[0] * x[2], 3.0 - x[0] - x[1] - 2.0 * x[2]]
            },
            least: 1.0 / 9.0,
            at: vec![4.0 / 3.0, 7.0 / 9.0, 4.0 / 9.0],
        },
        Case {
            name: "HS 36",
            variables: vec![between(0.0, 20.0), between(0.0, 11.0), between(0.0, 42.0)],
            outputs: |x| vec![-x[0] * x[1] * x[2], 72.0 - x[0] - 2.0 * x[1] - 2.0 * x[2]],
            least: -3300.0,
            at: vec![20.0, 11.0, 15.0],
        },
        Case {
            name: "HS 37",
            variables: vec![between(0.0, 42.0); 3],
            outputs: |x| {
                let sum = x[0] + 2.0 * x[1] + 2.0 * x[2];
                vec![-x[0] * x[1] * x[2], 72.0 - sum, sum]
            },
            least: -3456.0,
            at: vec![24.0, 12.0, 12.0],
        },
        Case {
            name: "HS 43, Rosen and Suzuki",
            variables: vec![between(-10.0, 10.0); 4],
            outputs: |x| {
                let [a, b, c, d] = [x[0].powi(2), x[1].powi(2), x[2].powi(2), x[3].powi(2)];
                vec![
                    a + b + 2.0 * c + d - 5.0 * x[0] - 5.0 * x[1] - 21.0 * x[2] + 7.0 * x[3],
                    8.0 - a - b - c - d - x[0] + x[1] - x[2] + x[3],
                    10.0 - a - 2.0 * b - c - 2.0 * d + x[0] + x[3],
                    5.0 - 2.0 * a - b - c - 2.0 * x[0] + x[1] + x[3],
                ]
            },
            least: -44.0,
            at: vec![0.0, 1.0, 2.0, -1.0],
        },
        Case {
            name: "HS 44",
            variables: vec![between(0.0, 10.0); 4],
            outputs: |x| {
                let products = -x[0] * x[2] + x[0] * x[3] + x[1] * x[2] - x[1] * x[3];
                vec![
                    x[0] - x[1] - x[2] + products,
                    8.0 - x[0] - 2.0 * x[1],
                    12.0 - 4.0 * x[0] - x[1],
                    12.0 - 3.0 * x[0] - 4.0 * x[1],
                    8.0 - 2.0 * x[2] - x[3],
                    8.0 - x[2] - 2.0 * x[3],
                    5.0 - x[2] - x[3],
                ]
            },
            least: -15.0,
            at: vec![0.0, 3.0, 0.0, 4.0],
        },
        Case {
            name: "HS 76",
            variables: vec![between(0.0, 10.0); 4],
            outputs: |x| {
                let squares = x[0].powi(2) + 0.5 * x[1].powi(2) + x[2].powi(2) + 0.5 * x[3].powi(2);
                vec![
                    squares - x[0] * x[2] + x[2] * x[3] - x[0] - 3.0 * x[1] + x[2] - x[3],
                    5.0 - x[0] - 2.0 * x[1] - x[2] - x[3],
                    4.0 - 3.0 * x[0] - x[1] - 2.0 * x[2] + x[3],
                    x[1] + 4.0 * x[2] - 1.5,
                ]
            },
            least: -103.0 / 22.0,
            at: vec![3.0 / 11.0, 23.0 / 11.0, 0.0, 6.0 / 11.0],
        },
    ]
}

#[test]
fn the_problems_of_hock_and_schittkowski_are_solved() {
    for Case { name, variables, outputs, least, at } in hock_schittkowski() {
        let ranges: Vec<f64> = variables.iter().map(|variable| variable.to - variable.from).collect();
        let limits = outputs(&at).len();
        let best = found(task(variables, limits), outputs);
        let size = f64::max(1.0, least.abs());
        assert!((best.outputs[0] - least).abs() < GOAL * size, "{name}: {} for {least}", best.outputs[0]);
        for (i, (value, expected)) in best.values.iter().zip(&at).enumerate() {
            assert!((value - expected).abs() < PLACE * ranges[i], "{name}: {:?} for {at:?}", best.values);
        }
        assert!(best.stop.is_converged(), "{name}: {:?}", best.stop);
        assert!(best.evaluations <= 5000 && best.unanswered == 0, "{name}");
    }
}

#[test]
fn rosenbrocks_valley_in_a_disc_is_followed_to_its_end_or_said_to_go_on() {
    // The minimum is 0 at (1, 1), on the edge of the disc. A bent valley is the hardest for linear models: it takes many small steps.
    let rosenbrock = |x: &[f64]| (1.0 - x[0]).powi(2) + 100.0 * (x[1] - x[0] * x[0]).powi(2);
    let disc = |x: &[f64]| vec![rosenbrock(x), 2.0 - x[0] * x[0] - x[1] * x[1]];
    let valley = |evaluations| TaskParams { evaluations, ..task(vec![between(-1.5, 1.5); 2], 2) };
    let hurried = found(valley(2000), disc);
    assert!(hurried.outputs[0] < 0.05 && hurried.stop == StopReason::Evaluations, "{hurried:?}");
    let best = found(valley(100_000), disc);
    assert!(best.outputs[0] < 1e-8 && best.values.iter().all(|x| (x - 1.0).abs() < 1e-4), "{best:?}");
    assert!(best.stop.is_converged() && best.agreed == best.searches, "{best:?}");
}

#[test]
fn the_deepest_of_several_valleys_is_found() {
    // Sin x + sin 10x/3 between 2.7 and 7.5: -1.8995993 at 5.145735 (Hansen 1979).
    let best = found(task(vec![between(2.7, 7.5)], 1), |x| vec![x[0].sin() + (10.0 / 3.0 * x[0]).sin()]);
    assert!((best.outputs[0] + 1.899_599_3).abs() < 1e-6 && (best.values[0] - 5.145_735).abs() < 1e-3, "{best:?}");
    assert!(best.agreed < best.searches, "{best:?}");

    // Six-hump camel: -1.031628453 at ±(0.0898, -0.7126) (Dixon and Szegő 1978).
    let camel = |x: &[f64]| {
        let (a, b) = (x[0] * x[0], x[1] * x[1]);
        (4.0 - 2.1 * a + a * a / 3.0) * a + x[0] * x[1] + (4.0 * b - 4.0) * b
    };
    let best = found(task(vec![between(-3.0, 3.0), between(-2.0, 2.0)], 1), |x| vec![camel(x)]);
    assert!((best.outputs[0] + 1.031_628_453).abs() < 1e-6, "{best:?}");
    assert!((best.values[0].abs() - 0.0898).abs() < 2e-3 && (best.values[1].abs() - 0.7126).abs() < 2e-3, "{best:?}");

    // The same where sin 4πx - 2 sin² 2πy may not exceed 1.5 in the sense of Gomez and Levy (1982): the minimum stays.
    let pi = std::f64::consts::PI;
    let holes = |x: &[f64]| vec![camel(x), 1.5 + (4.0 * pi * x[0]).sin() - 2.0 * (2.0 * pi * x[1]).sin().powi(2)];
    let best = found(task(vec![between(-1.0, 0.75), between(-1.0, 1.0)], 2), holes);
    assert!((best.outputs[0] + 1.031_628_453).abs() < 1e-5, "{best:?}");
    assert!((best.values[0] - 0.0898).abs() < 5e-3 && (best.values[1] + 0.7126).abs() < 5e-3, "{best:?}");
}

#[test]
fn equal_valleys_agree_and_tell_how_far_they_are_apart() {
    // Branin's function has three minima of 0.39788736, at x = -π, π and 9.42478.
    let pi = std::f64::consts::PI;
    let branin = |x: &[f64]| {
        let bent = x[1] - 5.1 / (4.0 * pi * pi) * x[0].powi(2) + 5.0 / pi * x[0] - 6.0;
        vec![bent.powi(2) + 10.0 * (1.0 - 1.0 / (8.0 * pi)) * x[0].cos() + 10.0]
    };
    let best = found(task(vec![between(-5.0, 10.0), between(0.0, 15.0)], 1), branin);
    assert!((best.outputs[0] - 0.397_887_36).abs() < 1e-6, "{best:?}");
    let (least, most) = best.agreed_ranges[0];
    assert!(best.agreed >= 2 && (least + pi).abs() < 0.2 && (most - 9.42478).abs() < 0.2, "{best:?}");
}

#[test]
fn six_variables_are_not_too_many() {
    // The largest product of six numbers of a given sum: all equal, by the inequality of the means.
    let product = |x: &[f64]| vec![-x.iter().product::<f64>(), 6.0 - x.iter().sum::<f64>()];
    let best = found(task(vec![between(0.0, 4.0); 6], 2), product);
    assert!((best.outputs[0] + 1.0).abs() < 1e-4, "{best:?}");
    assert_eq!(best.active, [0]);
}
