//! Against plain Monte Carlo, with another generator, other sampling and other estimates: a saturating pull of two strengths and a
//! load, with a truncated, a lognormal and a triangular input, two of them correlated.

mod common;

use common::free;
use rand::SeedableRng;
use rand::rngs::StdRng;
use rand_distr::{Distribution as _, Normal, Triangular};
use terramechanics_uncertainty::{
    Bounds, Correlation, Design, Distribution, Inputs, Marginal, Probability, Source, Summary, sensitivities,
};

const RHO: f64 = -0.7;

fn pull(cohesion: f64, friction: f64, load: f64, sinkage: f64) -> f64 {
    (cohesion + load * friction.tan()) * (1.0 - (-3.0 / (1.0 + sinkage)).exp()) - 0.3 * load * sinkage.sqrt()
}

fn inputs() -> Inputs {
    let cohesion = Distribution::Normal { mean: 2.0, deviation: 2.0 };
    let positive = Bounds { lower: 0.0, upper: f64::INFINITY };
    let sources = vec![
        Source::One(Marginal::new(cohesion, positive).expect("a marginal")),
        free(Distribution::LogNormal { mean: 0.5, deviation: 0.1 }),
        free(Distribution::Triangular { low: 8.0, mode: 10.0, high: 15.0 }),
        free(Distribution::LogNormal { mean: 0.6, deviation: 0.4 }),
    ];
    let mut matrix = vec![vec![0.0; 4]; 4];
    (0..4).for_each(|i| matrix[i][i] = 1.0);
    matrix[1][3] = RHO;
    matrix[3][1] = RHO;
    let inputs = Inputs::new(sources).expect("inputs");
    inputs.correlated(Correlation::new(matrix).expect("a correlation")).expect("correlated inputs")
}

/// Plain samples: the truncated one by rejection, the correlated ones by their logarithms.
struct Plain {
    generator: StdRng,
}

impl Plain {
    fn standard(&mut self) -> f64 {
        Normal::new(0.0, 1.0).expect("normal").sample(&mut self.generator)
    }

    fn cohesion(&mut self) -> f64 {
        loop {
            let cohesion = 2.0 + 2.0 * self.standard();
            if cohesion > 0.0 {
                return cohesion;
            }
        }
    }

    fn load(&mut self) -> f64 {
        Triangular::new(8.0, 15.0, 10.0).expect("triangular").sample(&mut self.generator)
    }

    fn friction_and_sinkage(&mut self) -> [f64; 2] {
        let logarithm = |mean: f64, deviation: f64, score: f64| {
            let variance = (1.0 + (deviation / mean).powi(2)).ln();
            (mean.ln() - 0.5 * variance + variance.sqrt() * score).exp()
        };
        let (one, other) = (self.standard(), self.standard());
        [logarithm(0.5, 0.1, one), logarithm(0.6, 0.4, RHO * one + (1.0 - RHO * RHO).sqrt() * other)]
    }

    fn pull(&mut self) -> f64 {
        let [friction, sinkage] = self.friction_and_sinkage();
        pull(self.cohesion(), friction, self.load(), sinkage)
    }
}

/// As many plain samples as leave an error of a thousandth of the deviation.
const PLAIN: usize = 1_000_000;

fn of_row(row: &[f64]) -> f64 {
    pull(row[0], row[1], row[2], row[3])
}

#[test]
fn bands_and_probabilities_are_those_of_plain_monte_carlo() {
    let mut plain = Plain { generator: StdRng::seed_from_u64(2) };
    let mut pulls: Vec<f64> = (0..PLAIN).map(|_| plain.pull()).collect();
    pulls.sort_by(f64::total_cmp);
    let count = PLAIN as f64;
    let mean = pulls.iter().sum::<f64>() / count;
    let deviation = (pulls.iter().map(|pull| (pull - mean).powi(2)).sum::<f64>() / count).sqrt();

    let design = Design::new(inputs(), 16_384, 0).expect("a design");
    let answers: Vec<_> = (0..design.rows()).map(|row| Some(of_row(&design.row(row).expect("a row")))).collect();
    let summary = Summary::of(&answers).expect("a summary");
    let is_close = |one: f64, other: f64| (one - other).abs() < 0.01 * deviation;
    assert!(is_close(summary.mean.value, mean) && is_close(summary.deviation.value, deviation), "{summary:?}");
    for (quantile, probability) in summary.quantiles.iter().zip([0.05, 0.25, 0.5, 0.75, 0.95]) {
        let plain = pulls[(probability * count) as usize];
        assert!((quantile.value - plain).abs() < 5.0 * quantile.error + 0.005 * deviation, "{quantile:?}, {plain}");
        assert!(quantile.error < 0.03 * deviation);
    }
    let limit = 4.0;
    let share = pulls.partition_point(|pull| *pull < limit) as f64 / count;
    let holds: Vec<_> = answers.iter().map(|answer| answer.map(|answer| answer < limit)).collect();
    let probability = Probability::of(&holds).among_answered.expect("a probability");
    assert!((0.02..0.5).contains(&share) && (probability.value - share).abs() < 2e-3, "{probability:?}, {share}");
}

/// The definition itself, by pairs: with the same group in both, the covariance of the pulls is its first-order variance; with all
/// but the group in both, what is missing from the variance is its total one.
#[test]
fn sensitivities_are_those_of_plain_covariances() {
    let mut plain = Plain { generator: StdRng::seed_from_u64(7) };
    // Of groups in the order of the inputs: cohesion; friction with sinkage; load.
    let mut products = [[0.0; 2]; 3];
    let (mut sum, mut square) = (0.0, 0.0);
    for _ in 0..PLAIN {
        let mut draw = || (plain.cohesion(), plain.friction_and_sinkage(), plain.load());
        let (one, other) = (draw(), draw());
        let pull = |(cohesion, [friction, sinkage], load): (f64, [f64; 2], f64)| pull(cohesion, friction, load, sinkage) - 5.0;
        let base = pull(one);
        let only = [(one.0, other.1, other.2), (other.0, one.1, other.2), (other.0, other.1, one.2)];
        let but = [(other.0, one.1, one.2), (one.0, other.1, one.2), (one.0, one.1, other.2)];
        for i in 0..3 {
            products[i][0] += base * pull(only[i]);
            products[i][1] += base * pull(but[i]);
        }
        sum += base;
        square += base * base;
    }
    let count = PLAIN as f64;
    let mean = sum / count;
    let variance = square / count - mean * mean;

    let design = Design::new(inputs(), 8192, 1).expect("a design").with_sensitivities();
    assert_eq!(design.inputs().groups(), [vec![0], vec![1, 3], vec![2]]);
    let answers: Vec<_> = (0..design.rows()).map(|row| Some(of_row(&design.row(row).expect("a row")))).collect();
    let found = sensitivities(&design, &answers);
    for (one, [only, but]) in found.iter().flatten().zip(products) {
        let first = (only / count - mean * mean) / variance;
        let total = 1.0 - (but / count - mean * mean) / variance;
        assert!((one.first.value - first).abs() < 0.01 && (one.total.value - total).abs() < 0.01, "{one:?}, {first}, {total}");
    }
    assert_eq!(found.iter().flatten().count(), 3);
}
