//! Functions without an answer here and there, limits that nothing keeps, plains without a slope, budgets and callers that end it.

use super::tasks::{between, found, outcome, task};
use terramechanics_optimum::{
    Bound, BoundHit, Goal, InvalidTask, Limit, Outcome, Refusal, Sense, Side, Spacing, StopReason, Stopped, Task, TaskParams,
    Variable, optimum,
};

fn sought(
    params: TaskParams,
    function: impl Fn(&[f64]) -> Result<Vec<f64>, Refusal>,
) -> Outcome<terramechanics_optimum::Optimum> {
    optimum(&Task::new(params).expect("a task"), &mut |values| function(values)).expect("nobody stops it")
}

#[test]
fn the_edge_of_a_hole_is_found() {
    // The least x² + y² where there is no answer for x + 2 y < 1: 1/5 at (1/5, 2/5), on the edge.
    let edge = |x: &[f64]| if x[0] + 2.0 * x[1] < 1.0 { Err(Refusal::NoAnswer) } else { Ok(vec![x[0] * x[0] + x[1] * x[1]]) };
    let Outcome::Found(best) = sought(task(vec![between(-1.0, 1.0); 2], 1), edge) else { panic!("there is one") };
    assert!((best.outputs[0] - 0.2).abs() < 1e-3, "{best:?}");
    assert!((best.values[0] - 0.2).abs() < 0.03 && (best.values[1] - 0.4).abs() < 0.03, "{best:?}");
    assert!(best.unanswered > 0, "{best:?}");
}

#[test]
fn a_ground_full_of_holes_hides_no_minimum() {
    // No answer in every other square of a board; the minimum, at (0.56, 0.31), lies in a square that answers.
    let board = |x: &[f64]| {
        let is_hole = ((x[0] * 8.0).floor() + (x[1] * 8.0).floor()) as i32 % 2 != 0;
        let goal = (x[0] - 0.56).powi(2) + (x[1] - 0.31).powi(2);
        if is_hole { Ok(vec![f64::NAN]) } else { Ok(vec![goal]) }
    };
    let Outcome::Found(best) = sought(task(vec![between(0.0, 1.0); 2], 1), board) else { panic!("there is one") };
    assert!(best.outputs[0] < 1e-8 && best.stop.is_converged(), "{best:?}");
}

#[test]
fn a_rare_answer_is_looked_for_as_long_as_the_budget_allows() {
    // One in four hundred points answers.
    let rare = |x: &[f64]| {
        if x.iter().all(|x| (0.40..0.45).contains(x)) { Ok(vec![x[0] + x[1]]) } else { Err(Refusal::NoAnswer) }
    };
    let Outcome::Found(best) = sought(task(vec![between(0.0, 1.0); 2], 1), rare) else { panic!("there is one") };
    assert!((best.outputs[0] - 0.8).abs() < 1e-3, "{best:?}");
    let never = sought(TaskParams { evaluations: 100, ..task(vec![between(0.0, 1.0); 2], 1) }, |_| Err(Refusal::NoAnswer));
    assert_eq!(never, Outcome::NoAnswer { evaluations: 100 });
}

#[test]
fn limits_that_contradict_each_other_are_told_apart_from_one_that_nothing_keeps() {
    // At most 0.2 and at least 0.8 of the same: missed least, and alike, in the middle.
    let middle = outcome(task(vec![between(0.0, 1.0)], 3), |x| vec![x[0], 0.2 - x[0], x[0] - 0.8]);
    let Outcome::Infeasible(middle) = middle else { panic!("{middle:?}") };
    assert!((middle.values[0] - 0.5).abs() < 1e-6, "{middle:?}");
    assert_eq!(
        middle.missed.iter().map(|missed| (missed.limit, missed.is_kept_alone)).collect::<Vec<_>>(),
        [(0, true), (1, true)]
    );
    assert!(middle.missed.iter().all(|missed| (missed.by - 0.3).abs() < 1e-6), "{middle:?}");

    // x (1 - x) reaches 1/4 at most; that x is at least 0.9 is no trouble.
    let params = TaskParams {
        limits: vec![Limit { output: 1, side: Side::AtLeast, value: 0.3 }, Limit { output: 0, side: Side::AtLeast, value: 0.4 }],
        ..task(vec![between(0.0, 1.0)], 2)
    };
    let never = outcome(params, |x| vec![x[0], x[0] * (1.0 - x[0])]);
    let Outcome::Infeasible(never) = never else { panic!("{never:?}") };
    assert!((never.values[0] - 0.5).abs() < 1e-3 && never.missed.len() == 1, "{never:?}");
    let missed = never.missed[0];
    assert!(missed.limit == 0 && !missed.is_kept_alone, "{missed:?}");
    assert!((missed.by - 0.05).abs() < 1e-6 && (missed.best - 0.25).abs() < 1e-6, "{missed:?}");
}

#[test]
fn on_a_plain_all_points_agree() {
    let best = found(task(vec![between(1.0, 2.0), between(-5.0, 5.0)], 1), |_| vec![7.0]);
    assert_eq!((best.outputs[0], best.agreed), (7.0, best.searches));
    let (least, most) = best.agreed_ranges[1];
    assert!(most - least > 5.0 && best.stop.is_converged(), "{best:?}");
    // A plain with one pit of a twentieth of the width.
    let pit = |x: &[f64]| vec![if (x[0] - 0.731).abs() < 0.025 { (x[0] - 0.731).abs() } else { 1.0 }];
    let best = found(task(vec![between(0.0, 1.0)], 1), pit);
    assert!((best.values[0] - 0.731).abs() < 1e-6 && best.agreed < best.searches, "{best:?}");
}

#[test]
fn bounds_and_limits_that_hold_the_optimum_are_named_and_no_others() {
    // The largest x + y: x at its upper bound, y where 2 y = 3; x y ≤ 100 is far.
    let params = TaskParams {
        goal: Goal { output: 0, sense: Sense::Maximise },
        limits: vec![Limit { output: 1, side: Side::AtMost, value: 3.0 }, Limit { output: 2, side: Side::AtMost, value: 100.0 }],
        ..task(vec![between(0.0, 2.0), between(0.0, 9.0)], 3)
    };
    let best = found(params, |x| vec![x[0] + x[1], 2.0 * x[1], x[0] * x[1]]);
    assert!((best.outputs[0] - 3.5).abs() < 1e-8, "{best:?}");
    assert_eq!(
        (best.active.as_slice(), best.at_bounds.as_slice()),
        (&[0][..], &[BoundHit { variable: 0, bound: Bound::To }][..])
    );
    assert!((best.margins[1] - 97.0).abs() < 1e-6, "{best:?}");
}

#[test]
fn the_cost_of_an_active_limit_is_told() {
    // The least x + y where x y is at least 4 is 2 √4; where it is at least 3.96, 2 √3.96. That x is at most 9 costs nothing.
    let limits = vec![Limit { output: 1, side: Side::AtLeast, value: 4.0 }, Limit { output: 2, side: Side::AtMost, value: 9.0 }];
    let params = TaskParams { limits, ..task(vec![between(0.1, 10.0); 2], 3) };
    let best = found(params, |x| vec![x[0] + x[1], x[0] * x[1], x[0]]);
    let [cost] = best.loosened.as_slice() else { panic!("{best:?}") };
    assert!(cost.limit == 0 && (cost.goal - 2.0 * 3.96_f64.sqrt()).abs() < 1e-6, "{best:?}");
}

#[test]
fn units_and_decades_do_not_matter() {
    let params = |spacing| {
        let small = Variable { from: 1e-8, to: 1e-6, start: None, spacing };
        let large = Variable { from: 1e5, to: 1e7, start: None, spacing };
        task(vec![small, large], 2)
    };
    for spacing in [Spacing::Linear, Spacing::Logarithmic] {
        // The least a + b where a b ≥ 1/4 is 1, at 1/2 each.
        let best = found(params(spacing), |x| {
            let (a, b) = (1e7 * x[0], 1e-6 * x[1]);
            vec![1e12 * (a + b), a * b - 0.25]
        });
        assert!((best.outputs[0] * 1e-12 - 1.0).abs() < 1e-8, "{best:?}");
        assert!((best.values[0] / 5e-8 - 1.0).abs() < 1e-3 && (best.values[1] / 5e5 - 1.0).abs() < 1e-3, "{best:?}");
    }
}

#[test]
fn no_more_evaluations_are_made_than_allowed_and_none_after_a_stop() {
    for evaluations in [20, 50, 333] {
        let mut count = 0;
        let params = TaskParams { evaluations, ..task(vec![between(-1.5, 1.5); 3], 1) };
        let found = optimum(&Task::new(params).expect("a task"), &mut |x| {
            count += 1;
            Ok(vec![100.0 * (x[1] - x[0] * x[0]).powi(2) + (1.0 - x[0]).powi(2) + x[2] * x[2]])
        });
        let Ok(Outcome::Found(best)) = found else { panic!("{found:?}") };
        assert!(count <= evaluations && best.evaluations == count, "{count} {best:?}");
        assert_eq!(best.stop, StopReason::Evaluations);
    }
    for stop_at in [1, 100, 1000] {
        let mut count = 0;
        let stopped = optimum(&Task::new(task(vec![between(-1.5, 1.5); 3], 1)).expect("a task"), &mut |x| {
            count += 1;
            if count == stop_at { Err(Refusal::Stop) } else { Ok(vec![100.0 * (x[1] - x[0] * x[0]).powi(2) + x[2].cos()]) }
        });
        assert_eq!((stopped, count), (Err(Stopped), stop_at));
    }
}

#[test]
fn the_same_seed_gives_the_same_and_a_start_that_is_given_is_tried_first() {
    let waves = |x: &[f64]| vec![(9.0 * x[0]).sin() + (7.0 * x[1]).cos() + x[0] * x[1]];
    let params = |seed| TaskParams { seed, ..task(vec![between(0.0, 3.0); 2], 1) };
    assert_eq!(found(params(5), waves), found(params(5), waves));
    let start = |value| Variable { start: Some(value), ..between(0.0, 3.0) };
    let params = TaskParams { starts: 1, ..task(vec![start(0.5), start(2.5)], 1) };
    let best = found(params, waves);
    assert_eq!((best.found_from.as_slice(), best.searches), (&[0.5, 2.5][..], 1));
}

#[test]
fn tasks_that_make_no_sense_are_refused() {
    let good = task(vec![between(0.0, 1.0)], 1);
    let fault = |params: TaskParams| Task::new(params).expect_err("makes no sense");
    assert!(Task::new(good.clone()).is_ok());
    assert_eq!(fault(TaskParams { variables: vec![], ..good.clone() }), InvalidTask::Variables);
    assert_eq!(fault(TaskParams { variables: vec![between(0.0, 1.0); 7], ..good.clone() }), InvalidTask::Variables);
    assert_eq!(fault(TaskParams { variables: vec![between(1.0, 1.0)], ..good.clone() }), InvalidTask::Range(0));
    assert_eq!(fault(TaskParams { goal: Goal { output: 1, sense: Sense::Minimise }, ..good.clone() }), InvalidTask::Output(1));
    let open = Limit { output: 0, side: Side::AtMost, value: f64::INFINITY };
    assert_eq!(fault(TaskParams { limits: vec![open], ..good.clone() }), InvalidTask::Limit(0));
    assert_eq!(fault(TaskParams { starts: 0, ..good.clone() }), InvalidTask::Starts);
    assert_eq!(fault(TaskParams { evaluations: 19, ..good }), InvalidTask::Evaluations);
}
