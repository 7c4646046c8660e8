//! Trade-offs whose curves are known.

use super::tasks::{between, task};
use terramechanics_optimum::{Front, Goal, Limit, Outcome, Refusal, Sense, Side, Task, TaskParams, Trade, front};

/// Share of the curve by which a point may lie off it.
const OFF: f64 = 1e-6;

fn curve(params: TaskParams, against: Goal, function: impl Fn(&[f64]) -> Vec<f64>) -> Front {
    let task = Task::new(params).expect("a task");
    let found = front(&task, Trade { against, points: 20 }, &mut |values| Ok(function(values))).expect("nobody stops it");
    match found {
        Outcome::Found(front) => front,
        other => panic!("{other:?}"),
    }
}

fn two(variables: usize, from: f64, to: f64) -> TaskParams {
    TaskParams { limits: vec![], evaluations: 20_000, ..task(vec![between(from, to); variables], 2) }
}

const SMALL: Goal = Goal { output: 1, sense: Sense::Minimise };

fn assert_a_curve(front: &Front) {
    assert!(front.points.len() >= 18, "{} points, {} dominated", front.points.len(), front.dominated);
    assert!(front.evaluations <= 20_000);
    for pair in front.points.windows(2) {
        assert!(pair[0].outputs[0] < pair[1].outputs[0] && pair[0].outputs[1] > pair[1].outputs[1], "{pair:?}");
    }
}

#[test]
fn schaffers_curve_is_met_from_end_to_end() {
    // x² against (x - 2)²: √f₂ = 2 - √f₁ (Schaffer 1985).
    let front = curve(two(1, -10.0, 10.0), SMALL, |x| vec![x[0].powi(2), (x[0] - 2.0).powi(2)]);
    assert_a_curve(&front);
    for point in &front.points {
        let [first, second] = [point.outputs[0], point.outputs[1]];
        assert!((second - (2.0 - first.sqrt()).powi(2)).abs() < 4.0 * OFF, "{point:?}");
    }
    let (first, last) = (&front.points[0], &front.points[front.points.len() - 1]);
    assert!(first.outputs[0] < OFF && last.outputs[1] < OFF, "{first:?} {last:?}");
    // Equal steps of the other output.
    assert!(front.points.windows(2).all(|pair| pair[0].outputs[1] - pair[1].outputs[1] < 1.2 * 4.0 / 19.0));
}

#[test]
fn the_hollow_curve_of_fonseca_and_fleming_is_met_too() {
    // 1 - exp(-Σ(x ∓ 1/√2)²) for two variables: x = y = t from -1/√2 to 1/√2 (Fonseca and Fleming 1995).
    let root = std::f64::consts::FRAC_1_SQRT_2;
    let distance = move |x: &[f64], centre: f64| 1.0 - (-x.iter().map(|x| (x - centre).powi(2)).sum::<f64>()).exp();
    let front = curve(two(2, -4.0, 4.0), SMALL, move |x| vec![distance(x, root), distance(x, -root)]);
    assert_a_curve(&front);
    for point in &front.points {
        let t = root - (-(1.0 - point.outputs[0]).ln() / 2.0).sqrt();
        let expected = 1.0 - (-2.0 * (t + root).powi(2)).exp();
        assert!((point.outputs[1] - expected).abs() < 1e-5, "{point:?} for {expected}");
    }
}

#[test]
fn limits_hold_along_the_curve_and_an_output_may_be_made_large() {
    // Cost x + y against gain x y, where y may be 1 at most: x up to 3, y = 1 or both equal below.
    let params = TaskParams {
        limits: vec![Limit { output: 2, side: Side::AtMost, value: 1.0 }],
        evaluations: 20_000,
        ..task(vec![between(0.0, 3.0); 2], 3)
    };
    let front = curve(params, Goal { output: 1, sense: Sense::Maximise }, |x| vec![x[0] + x[1], x[0] * x[1], x[1]]);
    for point in &front.points {
        let gain = point.outputs[1];
        let least = if gain < 1.0 { 2.0 * gain.max(0.0).sqrt() } else { 1.0 + gain };
        assert!((point.outputs[0] - least).abs() < 1e-4 && point.values[1] <= 1.0 + 1e-8, "{point:?} for {least}");
    }
    let last = &front.points[front.points.len() - 1];
    assert!(front.points.len() >= 18 && (last.outputs[1] - 3.0).abs() < 1e-6, "{last:?}");
}

#[test]
fn aims_without_a_conflict_have_one_best_point() {
    let front = curve(two(2, -1.0, 1.0), SMALL, |x| vec![x[0].powi(2) + x[1].powi(2), 3.0 * (x[0].powi(2) + x[1].powi(2))]);
    assert_eq!(front.points.len(), 1);
    assert!(front.points[0].outputs[1] < 1e-6, "{front:?}");
}

#[test]
fn an_infeasible_trade_and_one_without_answers_are_told() {
    let params = TaskParams { evaluations: 500, ..task(vec![between(0.0, 1.0)], 3) };
    let task = Task::new(params).expect("a task");
    let trade = Trade { against: SMALL, points: 5 };
    let found = front(&task, trade, &mut |x| Ok(vec![x[0], 1.0, -1.0 - x[0]]));
    let Ok(Outcome::Infeasible(never)) = found else { panic!("{found:?}") };
    assert!(never.missed.len() == 1 && never.missed[0].limit == 1 && (never.missed[0].by - 1.0).abs() < 1e-6, "{never:?}");
    let found = front(&task, trade, &mut |_| Err(Refusal::NoAnswer));
    assert_eq!(found, Ok(Outcome::NoAnswer { evaluations: 500 }));
}
