//! Ishigami's function, of which all indices are known: Ishigami & Homma (1990), sin x₁ + a sin² x₂ + b x₃⁴ sin x₁ with x in (−π, π).

mod common;

use std::f64::consts::PI;

use common::{answers, inputs};
use terramechanics_uncertainty::{Design, Distribution, Sensitivity, Summary, sensitivities};

const A: f64 = 7.0;
const B: f64 = 0.1;

fn ishigami(x: &[f64]) -> f64 {
    x[0].sin() + A * x[1].sin().powi(2) + B * x[2].powi(4) * x[0].sin()
}

/// The indices of first order and the total ones, from the closed forms of the partial variances.
fn exact() -> [[f64; 2]; 3] {
    let v_1 = 0.5 * (1.0 + B * PI.powi(4) / 5.0).powi(2);
    let v_2 = A * A / 8.0;
    let v_13 = 8.0 * B * B * PI.powi(8) / 225.0;
    let v = v_1 + v_2 + v_13;
    [[v_1 / v, (v_1 + v_13) / v], [v_2 / v, v_2 / v], [0.0, v_13 / v]]
}

fn design(samples: usize, seed: u32) -> Design {
    let whole = || Distribution::Uniform { low: -PI, high: PI };
    Design::new(inputs(vec![whole(), whole(), whole()]), samples, seed).expect("a design").with_sensitivities()
}

fn found(samples: usize, seed: u32) -> Vec<Sensitivity> {
    let design = design(samples, seed);
    let answers = answers(&design, ishigami);
    sensitivities(&design, &answers).into_iter().map(|one| one.expect("indices")).collect()
}

#[test]
fn indices_are_the_exact_ones() {
    for (one, [first, total]) in found(16_384, 1).iter().zip(exact()) {
        assert!((one.first.value - first).abs() < 0.01, "{one:?}, {first}");
        assert!((one.total.value - total).abs() < 0.01, "{one:?}, {total}");
        assert_eq!(one.left_out, 0);
    }
}

/// Over many seeds the deviation from the exact value, in units of the error that is told, has a mean square near 1. By Student's
/// distribution with 15 degrees of freedom it is 15/13.
#[test]
fn the_errors_of_indices_are_what_they_say() {
    let mut squares = [[0.0; 2]; 3];
    let seeds = 100;
    for seed in 0..seeds {
        for (i, (one, [first, total])) in found(1024, seed).iter().zip(exact()).enumerate() {
            squares[i][0] += ((one.first.value - first) / one.first.error).powi(2);
            squares[i][1] += ((one.total.value - total) / one.total.error).powi(2);
        }
    }
    for square in squares.as_flattened() {
        let mean = square / f64::from(seeds);
        assert!((0.6..2.0).contains(&mean), "{squares:?}");
    }
}

#[test]
fn the_mean_converges_faster_than_random_sampling_does() {
    // E f = a/2.
    let scatter = |samples: usize| {
        let square = |seed: u32| {
            let design = design(samples, seed);
            let answers = answers(&design, ishigami);
            (Summary::of(&answers[..samples]).expect("a summary").mean.value - 0.5 * A).powi(2)
        };
        ((0..20).map(square).sum::<f64>() / 20.0).sqrt()
    };
    let (few, many) = (scatter(256), scatter(16_384));
    // Random samples, 64 times as many, have an eighth of the error.
    assert!(few / many > 16.0, "{few}, {many}");
}

#[test]
fn a_failed_row_is_left_out_of_the_indices_and_counted() {
    let design = design(1024, 3);
    let mut answers = answers(&design, ishigami);
    // One in A, which all indices need, and one in the set of the second input.
    answers[5] = None;
    answers[3 * 1024 + 7] = None;
    let found = sensitivities(&design, &answers);
    let left_out: Vec<usize> = found.iter().map(|one| one.as_ref().expect("indices").left_out).collect();
    assert_eq!(left_out, [1, 2, 1]);
}

#[test]
fn there_are_no_indices_where_nothing_varies_or_rows_are_missing() {
    let design = design(256, 0);
    let constant = answers(&design, |_| 3.5);
    assert!(sensitivities(&design, &constant).iter().all(Option::is_none));
    assert!(sensitivities(&design, &constant[1..]).is_empty());
    assert!(sensitivities(&design, &vec![None; design.rows()]).iter().all(Option::is_none));
}
