//! What is refused, and what is told of samples without an answer.

mod common;

use common::free;
use terramechanics_uncertainty::{
    Bounds, Correlation, CorrelationError, Design, DesignError, Distribution, InputError, Inputs, Joint, MOST_SAMPLES, MOST_SEED,
    MOST_SOURCES, Marginal, Probability, Source, Summary,
};

const POSITIVE: Bounds = Bounds { lower: 0.0, upper: f64::INFINITY };

fn refused(distribution: Distribution, bounds: Bounds) -> InputError {
    Marginal::new(distribution, bounds).expect_err("a refusal")
}

#[test]
fn parameters_that_make_no_distribution_are_refused() {
    let free = |distribution| refused(distribution, Bounds::NONE);
    let normal = |mean, deviation| Distribution::Normal { mean, deviation };
    assert_eq!(free(normal(f64::NAN, 1.0)), InputError::NotFinite);
    assert_eq!(free(normal(0.0, 0.0)), InputError::Deviation { deviation: 0.0 });
    assert_eq!(free(normal(0.0, 1e308)), InputError::TooWide);
    assert_eq!(free(Distribution::LogNormal { mean: 0.0, deviation: 1.0 }), InputError::Mean { mean: 0.0 });
    assert_eq!(free(Distribution::LogNormal { mean: 1e-300, deviation: 1e300 }), InputError::TooWide);
    assert_eq!(free(Distribution::Uniform { low: 1.0, high: 1.0 }), InputError::Ends { low: 1.0, high: 1.0 });
    assert_eq!(free(Distribution::Uniform { low: -1e308, high: 1e308 }), InputError::TooWide);
    assert_eq!(free(Distribution::Triangular { low: 0.0, mode: 2.0, high: 1.0 }), InputError::Mode { mode: 2.0 });
    assert_eq!(free(Distribution::Triangular { low: 0.0, mode: f64::NAN, high: 1.0 }), InputError::NotFinite);
    assert_eq!(free(Distribution::Quantiles { values: vec![1.0] }), InputError::Count { count: 1 });
    assert_eq!(free(Distribution::Quantiles { values: vec![1.0, 3.0, 2.0] }), InputError::Order { row: 2 });
}

#[test]
fn ends_beyond_the_bounds_are_refused_and_tails_are_cut() {
    let uniform = Distribution::Uniform { low: -1.0, high: 1.0 };
    assert_eq!(refused(uniform, POSITIVE), InputError::Outside { low: -1.0, high: 1.0, bounds: POSITIVE });
    let mostly = refused(Distribution::Normal { mean: -0.1, deviation: 1.0 }, POSITIVE);
    // Φ(0.1) = 0.5398.
    assert!(matches!(mostly, InputError::MostlyOutside { share, .. } if (share - 0.5398).abs() < 1e-4), "{mostly:?}");
    let cut = Marginal::new(Distribution::Normal { mean: 2.0, deviation: 1.0 }, POSITIVE).expect("a marginal");
    // Φ(−2) = 0.02275.
    assert!((cut.share_cut() - 0.022_750_1).abs() < 1e-7, "{}", cut.share_cut());
}

#[test]
fn matrices_that_are_no_correlation_are_refused() {
    let of = |rows: &[&[f64]]| Correlation::new(rows.iter().map(|row| row.to_vec()).collect());
    assert_eq!(of(&[&[1.0, 0.0], &[0.0]]), Err(CorrelationError::Size { expected: 2, found: 1, row: Some(1) }));
    assert_eq!(of(&[&[1.0, 1.5], &[1.5, 1.0]]), Err(CorrelationError::Coefficient { row: 0, column: 1 }));
    assert_eq!(of(&[&[1.0, f64::NAN], &[0.0, 1.0]]), Err(CorrelationError::Coefficient { row: 0, column: 1 }));
    assert_eq!(of(&[&[0.9, 0.0], &[0.0, 1.0]]), Err(CorrelationError::Diagonal { row: 0 }));
    assert_eq!(of(&[&[1.0, 0.1], &[0.2, 1.0]]), Err(CorrelationError::Asymmetric { row: 0, column: 1 }));
    assert_eq!(of(&[&[1.0, 1.0], &[1.0, 1.0]]), Err(CorrelationError::One { row: 1, column: 0 }));
    // a with b and b with c, but a against c.
    let contradiction = of(&[&[1.0, 0.9, -0.9], &[0.9, 1.0, 0.9], &[-0.9, 0.9, 1.0]]);
    // By the product of both, -0.81, and what they leave open, 1 - 0.81 = 0.19.
    let Err(CorrelationError::Contradiction { row: 2, column: 1, third: 0, range: [least, most] }) = contradiction else {
        panic!("{contradiction:?}");
    };
    assert!((least + 1.0).abs() < 1e-12 && (most + 0.62).abs() < 1e-12, "{least} {most}");
    // Four inputs that are all against one another: any three can be by -0.4, but of four -1/3 is the least.
    let all: Vec<Vec<f64>> = (0..4).map(|row| (0..4).map(|column| if row == column { 1.0 } else { -0.4 }).collect()).collect();
    assert_eq!(Correlation::new(all).err(), Some(CorrelationError::NotPositiveDefinite { row: 3 }));
}

#[test]
fn correlation_has_the_size_of_the_inputs_and_leaves_joint_samples_alone() {
    let pair = || Correlation::new(vec![vec![1.0, 0.5], vec![0.5, 1.0]]).expect("a correlation");
    let unit = || free(Distribution::Uniform { low: 0.0, high: 1.0 });
    let joint = Source::Joint(Joint::new(vec![vec![1.0, 2.0]]).expect("joint samples"));
    let of = |sources: Vec<Source>| Inputs::new(sources).expect("inputs").correlated(pair()).expect_err("a refusal");
    assert_eq!(of(vec![unit()]), CorrelationError::Size { expected: 1, found: 2, row: None });
    assert_eq!(of(vec![unit(), joint]), CorrelationError::OfJoint { row: 1 });
}

#[test]
fn joint_samples_have_columns_of_one_length() {
    assert_eq!(Joint::new(vec![]), Err(InputError::Count { count: 0 }));
    assert_eq!(Joint::new(vec![vec![]]), Err(InputError::Count { count: 0 }));
    assert_eq!(Joint::new(vec![vec![1.0, 2.0], vec![1.0]]), Err(InputError::Lengths { column: 1 }));
    assert_eq!(Joint::new(vec![vec![f64::INFINITY]]), Err(InputError::NotFinite));
}

#[test]
fn a_design_has_bounds() {
    let unit = || free(Distribution::Uniform { low: 0.0, high: 1.0 });
    let inputs = || Inputs::new(vec![unit()]).expect("inputs");
    assert_eq!(Inputs::new(vec![]), Err(DesignError::Sources { count: 0 }));
    assert_eq!(Inputs::new(vec![unit(); MOST_SOURCES + 1]), Err(DesignError::Sources { count: MOST_SOURCES + 1 }));
    assert_eq!(Design::new(inputs(), 255, 0), Err(DesignError::Samples { count: 255 }));
    assert_eq!(Design::new(inputs(), MOST_SAMPLES + 1, 0), Err(DesignError::Samples { count: MOST_SAMPLES + 1 }));
    assert_eq!(Design::new(inputs(), 256, MOST_SEED + 1), Err(DesignError::Seed { seed: MOST_SEED + 1 }));
    let largest = Design::new(inputs(), MOST_SAMPLES, MOST_SEED).expect("a design");
    assert!(largest.row(MOST_SAMPLES - 1).is_some() && largest.row(MOST_SAMPLES).is_none());
}

#[test]
fn samples_without_an_answer_are_counted() {
    let answers: Vec<Option<f64>> = (0..256).map(|i| (i % 4 != 0).then_some(f64::from(i))).collect();
    assert_eq!(Summary::of(&answers).expect("a summary").answered, 192);
    assert_eq!(Summary::of(&vec![None; 256]), None);
    let probability = Probability::of(&answers.iter().map(|answer| answer.map(|answer| answer < 128.0)).collect::<Vec<_>>());
    assert_eq!((probability.answered, probability.least, probability.most), (192, 96.0 / 256.0, 160.0 / 256.0));
    assert_eq!(probability.among_answered.expect("a probability").value, 0.5);
    let none = Probability::of(&[None; 256]);
    assert_eq!((none.among_answered, none.least, none.most), (None, 0.0, 1.0));
}

/// A condition that never holds among the samples may still hold: its probability has an error of one sample.
#[test]
fn never_is_not_known_better_than_one_sample() {
    let never = Probability::of(&[Some(false); 1000]).among_answered.expect("a probability");
    assert_eq!((never.value, never.error), (0.0, 1e-3));
}

#[test]
fn an_answer_that_is_not_finite_makes_no_summary() {
    let mut answers = vec![Some(1.0); 256];
    answers[3] = Some(f64::INFINITY);
    assert_eq!(Summary::of(&answers), None);
}

/// Numbers that differ by the rounding of a solver do not scatter, and nothing decides them.
#[test]
fn rounding_is_no_scatter() {
    let answers: Vec<Option<f64>> = (0..256).map(|i| Some(80.0 + 1e-12 * f64::from(i % 7))).collect();
    let summary = Summary::of(&answers).expect("a summary");
    assert_eq!((summary.deviation.value, summary.mean.error, summary.quantiles[0].error), (0.0, 0.0, 0.0));
    assert!((summary.mean.value - 80.0).abs() < 1e-10);
}
