//! A linear model of normal inputs, of which everything is known: it is normal, with the variance aᵀ Σ a.

mod common;

use common::{answers, inputs};
use terramechanics_uncertainty::{Correlation, Design, Distribution, Estimate, Probability, Summary, sensitivities};

const WEIGHTS: [f64; 3] = [2.0, -1.0, 0.5];
const MEANS: [f64; 3] = [1.0, 10.0, -4.0];
const DEVIATIONS: [f64; 3] = [0.5, 2.0, 3.0];
/// Between the first and the third input.
const COEFFICIENT: f64 = 0.6;

/// Quantiles of the standard normal distribution at 5, 25, 50, 75 and 95 %, from tables.
const NORMAL: [f64; 5] = [-1.644_853_627, -0.674_489_750, 0.0, 0.674_489_750, 1.644_853_627];

fn linear(x: &[f64]) -> f64 {
    x.iter().zip(WEIGHTS).map(|(x, weight)| x * weight).sum()
}

fn design(coefficient: f64, seed: u32) -> Design {
    let normal = |i: usize| Distribution::Normal { mean: MEANS[i], deviation: DEVIATIONS[i] };
    let matrix = vec![vec![1.0, 0.0, coefficient], vec![0.0, 1.0, 0.0], vec![coefficient, 0.0, 1.0]];
    let inputs = inputs((0..3).map(normal).collect());
    let inputs = inputs.correlated(Correlation::new(matrix).expect("a correlation")).expect("correlated inputs");
    Design::new(inputs, 4096, seed).expect("a design").with_sensitivities()
}

/// Variance of the whole.
fn variance(coefficient: f64) -> f64 {
    let scaled: Vec<f64> = WEIGHTS.iter().zip(DEVIATIONS).map(|(weight, deviation)| weight * deviation).collect();
    scaled.iter().map(|one| one * one).sum::<f64>() + 2.0 * coefficient * scaled[0] * scaled[2]
}

/// Within five of its standard errors, which are themselves small.
fn is_close(estimate: Estimate, exact: f64, largest_error: f64) -> bool {
    (estimate.value - exact).abs() <= 5.0 * estimate.error && estimate.error < largest_error
}

#[test]
fn mean_deviation_quantiles_and_probability_are_exact_within_their_errors() {
    for coefficient in [0.0, COEFFICIENT, -0.9] {
        let design = design(coefficient, 11);
        let answers = answers(&design, linear);
        let answers = &answers[..design.samples()];
        let summary = Summary::of(answers).expect("a summary");
        let mean: f64 = linear(&MEANS);
        let deviation = variance(coefficient).sqrt();
        assert!(is_close(summary.mean, mean, 1e-3 * deviation), "{summary:?}");
        assert!(is_close(summary.deviation, deviation, 3e-3 * deviation), "{summary:?}");
        for (quantile, normal) in summary.quantiles.iter().zip(NORMAL) {
            // Random samples would have an error of 0.033 deviations at 5 %: √(0.05 · 0.95 / 4096) over the density 0.103.
            assert!(is_close(*quantile, mean + normal * deviation, 0.04 * deviation), "{quantile:?}, {normal}");
        }
        let limit = mean + NORMAL[1] * deviation;
        let holds: Vec<_> = answers.iter().map(|answer| answer.map(|answer| answer < limit)).collect();
        let probability = Probability::of(&holds);
        assert!(is_close(probability.among_answered.expect("a probability"), 0.25, 5e-3), "{probability:?}");
        assert_eq!((probability.least, probability.most), (probability.among_answered.expect("one").value, probability.most));
    }
}

#[test]
fn sensitivities_of_independent_inputs_are_their_shares_of_the_variance() {
    let design = design(0.0, 5);
    let found = sensitivities(&design, &answers(&design, linear));
    assert_eq!(found.len(), 3);
    for (i, one) in found.iter().enumerate() {
        let one = one.as_ref().expect("indices");
        let share = (WEIGHTS[i] * DEVIATIONS[i]).powi(2) / variance(0.0);
        assert!(is_close(one.first, share, 5e-3) && is_close(one.total, share, 5e-3), "{one:?}, {share}");
    }
}

/// Correlated inputs are one group, whose share has its covariance in it.
#[test]
fn correlated_inputs_have_one_sensitivity() {
    let design = design(COEFFICIENT, 5);
    assert_eq!(design.inputs().groups(), [vec![0, 2], vec![1]]);
    let found = sensitivities(&design, &answers(&design, linear));
    let alone = (WEIGHTS[1] * DEVIATIONS[1]).powi(2) / variance(COEFFICIENT);
    for (one, share) in found.iter().zip([1.0 - alone, alone]) {
        let one = one.as_ref().expect("indices");
        assert!(is_close(one.first, share, 5e-3) && is_close(one.total, share, 5e-3), "{one:?}, {share}");
    }
}

/// Far from 0 and in any unit.
#[test]
fn figures_follow_shift_and_unit() {
    let design = design(COEFFICIENT, 2);
    let plain = answers(&design, linear);
    let moved = answers(&design, |x| 1e150 * (linear(x) + 1e4));
    let (of_plain, of_moved) = (sensitivities(&design, &plain), sensitivities(&design, &moved));
    for (one, other) in of_plain.iter().flatten().zip(of_moved.iter().flatten()) {
        assert!((one.first.value - other.first.value).abs() < 1e-9, "{one:?}, {other:?}");
        assert!((one.total.value - other.total.value).abs() < 1e-9, "{one:?}, {other:?}");
    }
    let [one, other] = [&plain, &moved].map(|of| Summary::of(&of[..4096]).expect("a summary"));
    assert!((other.mean.value / 1e150 - 1e4 - one.mean.value).abs() < 1e-9);
    assert!((other.deviation.value / 1e150 / one.deviation.value - 1.0).abs() < 1e-9);
}

/// Over many seeds, as for the indices.
#[test]
fn the_errors_of_a_summary_are_what_they_say() {
    let seeds = 100;
    let deviation = variance(COEFFICIENT).sqrt();
    let mut squares = [0.0; 7];
    for seed in 0..seeds {
        let design = design(COEFFICIENT, seed);
        let answers: Vec<_> = (0..design.samples()).map(|row| Some(linear(&design.row(row).expect("a row")))).collect();
        let summary = Summary::of(&answers).expect("a summary");
        let exact = NORMAL.map(|normal| linear(&MEANS) + normal * deviation);
        let pairs = summary.quantiles.into_iter().zip(exact);
        let pairs = pairs.chain([(summary.mean, linear(&MEANS)), (summary.deviation, deviation)]);
        for (square, (estimate, exact)) in squares.iter_mut().zip(pairs) {
            *square += ((estimate.value - exact) / estimate.error).powi(2) / f64::from(seeds);
        }
    }
    assert!(squares.iter().all(|square| (0.6..2.0).contains(square)), "{squares:?}");
}
