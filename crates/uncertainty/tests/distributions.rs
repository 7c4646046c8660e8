//! Each distribution against its closed forms.

mod common;

use common::{answers, free};
use terramechanics_uncertainty::{Bounds, Design, Distribution, Inputs, Joint, Marginal, Source, Summary};

fn all() -> Vec<Distribution> {
    vec![
        Distribution::Normal { mean: -3.0, deviation: 0.7 },
        Distribution::LogNormal { mean: 2.0, deviation: 1.5 },
        Distribution::Uniform { low: -1.0, high: 4.0 },
        Distribution::Triangular { low: 0.0, mode: 1.0, high: 5.0 },
        Distribution::Triangular { low: 0.0, mode: 0.0, high: 2.0 },
        Distribution::Triangular { low: 0.0, mode: 2.0, high: 2.0 },
        Distribution::Quantiles { values: vec![1.0, 2.0, 2.0, 10.0] },
    ]
}

/// What many samples of one input are like.
fn sampled(source: Source) -> Summary {
    let design = Design::new(Inputs::new(vec![source]).expect("inputs"), 16_384, 9).expect("a design");
    Summary::of(&answers(&design, |x| x[0])).expect("a summary")
}

#[test]
fn samples_have_the_mean_and_deviation_of_the_distribution() {
    for distribution in all() {
        let summary = sampled(free(distribution.clone()));
        let (mean, deviation) = (distribution.mean(), distribution.deviation());
        assert!((summary.mean.value - mean).abs() < 1e-3 * deviation, "{distribution:?}: {summary:?}");
        assert!((summary.deviation.value / deviation - 1.0).abs() < 5e-3, "{distribution:?}: {summary:?}");
    }
}

#[test]
fn the_share_below_a_quantile_is_its_probability() {
    for distribution in all() {
        let marginal = Marginal::new(distribution.clone(), Bounds::NONE).expect("a marginal");
        for p in [0.01, 0.2, 0.3, 0.5, 0.7, 0.99] {
            let share = distribution.share_below(marginal.quantile(p));
            // Known quantiles with a step of no width have no share between.
            let is_step = matches!(distribution, Distribution::Quantiles { .. }) && (1.0 / 3.0..2.0 / 3.0).contains(&p);
            assert!(is_step || (share - p).abs() < 1e-12, "{distribution:?}, {p}: {share}");
        }
    }
}

/// By hand: the triangle's quantiles from its area, the lognormal median m/√(1 + (s/m)²), the even steps of known quantiles.
#[test]
fn quantiles_are_those_of_the_closed_forms() {
    let of = |distribution: Distribution, p: f64| Marginal::new(distribution, Bounds::NONE).expect("a marginal").quantile(p);
    let triangular = |p: f64| of(Distribution::Triangular { low: 0.0, mode: 1.0, high: 5.0 }, p);
    // The area left of the mode is 1/5; 1/20 is a quarter of it, at half the way; 1/5 of the area lies right of 5 − 2.
    assert!((triangular(0.05) - 0.5).abs() < 1e-14);
    assert!((triangular(0.2) - 1.0).abs() < 1e-14);
    assert!((triangular(0.8) - 3.0).abs() < 1e-14);
    assert!((of(Distribution::LogNormal { mean: 2.0, deviation: 1.5 }, 0.5) - 2.0 / 1.5625_f64.sqrt()).abs() < 1e-14);
    assert!((of(Distribution::Normal { mean: 10.0, deviation: 2.0 }, 0.95) - 13.289_707_253_902_945).abs() < 1e-13);
    assert_eq!(of(Distribution::Uniform { low: -1.0, high: 4.0 }, 0.2), 0.0);
    assert_eq!(of(Distribution::Quantiles { values: vec![1.0, 2.0, 4.0] }, 0.75), 3.0);
}

/// Normal with mean 0 above 0: mean s √(2/π), deviation s √(1 − 2/π), and quantile p is the quantile (1 + p)/2 of the whole.
#[test]
fn a_normal_distribution_cut_at_its_mean_is_half_normal() {
    let s = 3.0;
    let normal = Distribution::Normal { mean: 0.0, deviation: s };
    let half = Marginal::new(normal, Bounds { lower: 0.0, upper: f64::INFINITY }).expect("a marginal");
    assert!((half.share_cut() - 0.5).abs() < 1e-15);
    assert!((half.quantile(0.5) - s * 0.674_489_750_196_081_7).abs() < 1e-13);
    let summary = sampled(Source::One(half));
    let two_over_pi = std::f64::consts::FRAC_2_PI;
    assert!((summary.mean.value / (s * two_over_pi.sqrt()) - 1.0).abs() < 1e-3, "{summary:?}");
    assert!((summary.deviation.value / (s * (1.0 - two_over_pi).sqrt()) - 1.0).abs() < 3e-3, "{summary:?}");
}

#[test]
fn every_sample_lies_within_the_bounds() {
    let bounds = Bounds { lower: 0.0, upper: 1.2 };
    let cut = |distribution| Source::One(Marginal::new(distribution, bounds).expect("a marginal"));
    let sources = vec![
        cut(Distribution::Normal { mean: 0.4, deviation: 0.5 }),
        cut(Distribution::LogNormal { mean: 0.5, deviation: 0.9 }),
        cut(Distribution::Triangular { low: 0.0, mode: 1.0, high: 1.2 }),
    ];
    let design = Design::new(Inputs::new(sources).expect("inputs"), 16_384, 0).expect("a design");
    for row in 0..design.rows() {
        let row = design.row(row).expect("a row");
        assert!(row.iter().all(|x| *x > 0.0 && *x < 1.2), "{row:?}");
    }
}

/// Whatever holds between the columns of a row holds in the samples, and each row comes as often as another.
#[test]
fn joint_samples_are_drawn_by_whole_rows() {
    let values: Vec<f64> = (0..8).map(f64::from).collect();
    let squares = values.iter().map(|value| value * value).collect();
    let joint = Joint::new(vec![values, squares]).expect("joint samples");
    let design = Design::new(Inputs::new(vec![Source::Joint(joint)]).expect("inputs"), 1024, 4).expect("a design");
    let mut counts = [0; 8];
    for row in 0..design.rows() {
        let row = design.row(row).expect("a row");
        assert_eq!(row[1], row[0] * row[0]);
        counts[row[0] as usize] += 1;
    }
    assert_eq!(counts, [128; 8]);
}

/// Sobol's points in one dimension: of 2^k points one in each of 2^k intervals, in every scrambling.
#[test]
fn every_scrambling_fills_the_interval_evenly() {
    let unit = free(Distribution::Uniform { low: 0.0, high: 1.0 });
    let design = Design::new(Inputs::new(vec![unit; 5]).expect("inputs"), 16 * 64, 77).expect("a design").with_sensitivities();
    for scrambling in 0..16 {
        for set in 0..2 {
            for source in 0..5 {
                let number = |i: usize| design.row(set * 1024 + 16 * i + scrambling).expect("a row")[source];
                let mut places: Vec<usize> = (0..64).map(|i| (64.0 * number(i)) as usize).collect();
                places.sort_unstable();
                assert_eq!(places, (0..64).collect::<Vec<_>>());
            }
        }
    }
}

#[test]
fn a_seed_gives_the_same_rows_and_another_seed_other_ones() {
    let design = |seed: u32| {
        let normal = Distribution::Normal { mean: 0.0, deviation: 1.0 };
        Design::new(Inputs::new(vec![free(normal)]).expect("inputs"), 512, seed).expect("a design")
    };
    let rows = |seed: u32| -> Vec<Vec<f64>> { (0..512).map(|row| design(seed).row(row).expect("a row")).collect() };
    assert_eq!(rows(1), rows(1));
    let (one, other) = (rows(1), rows(2));
    assert!(one.iter().zip(&other).filter(|(one, other)| one == other).count() < 5);
}
