//! Telemetry: rows, energy, samples without a result, events.

mod common;

use common::letter;
use terramechanics::{
    Channel, Error, EventKind, ForceModel, LinearSlipSinkage, Measured, Method, Motion, Operation, Parameter, Sample,
    SampleMotion, Sinkage, SlipRadius, SlipSinkage, Status, Thresholds, TrackRow, Tracker, Velocities,
};

/// Rounding of a sum of a few hundred products.
const ROUNDING: f64 = 1e-13;

const STATIC: Sinkage = Sinkage::FromStatic { static_sinkage: 0.02, law: SlipSinkage::Lyasko };

fn operation(method: Method) -> Operation {
    Operation { system: letter(), model: ForceModel::at_rim(method), sinkage: STATIC }
}

fn tracker(method: Method) -> Tracker {
    Tracker::new(operation(method), Thresholds::default()).expect("thresholds")
}

fn moving(time: f64, forward: f64, angular: f64) -> Sample {
    let motion = SampleMotion::Velocities(Velocities { forward, angular });
    Sample { time, motion, sinkage: STATIC, measured: None, unreadable: false }
}

fn slipping(time: f64, slip: f64) -> Sample {
    Sample { time, motion: SampleMotion::Slip(slip), sinkage: STATIC, measured: None, unreadable: false }
}

fn bits(row: &TrackRow) -> Vec<u64> {
    [row.slip, row.sinkage, row.longitudinal, row.normal, row.torque, row.drawbar_coefficient, row.tractive_efficiency]
        .iter()
        .map(|value| value.to_bits())
        .collect()
}

#[test]
fn a_row_is_the_operating_point_of_its_sample() {
    for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
        let mut tracker = tracker(method);
        for (i, forward) in [0.2, 0.15, 0.05, 0.21, 0.3].into_iter().enumerate() {
            let velocities = Velocities { forward, angular: 1.0 };
            let row = tracker.push(&moving(i as f64, forward, 1.0));
            let motion = Motion::of(&letter().wheel, SlipRadius::Rim, velocities).expect("a motion");
            let point = operation(method).at(motion.slip).expect("a solution");
            assert_eq!(
                (row.sinkage, row.longitudinal, row.torque),
                (point.sinkage, point.forces.longitudinal, point.forces.torque)
            );
            assert_eq!(row.power, point.forces.torque, "at 1 rad/s");
            assert_eq!(row.status, Status::Ok);
        }
    }
}

/// The row of a slip of 0.3 alone, and after others with gaps among them.
fn alone_and_after_others(sample_at: impl Fn(f64) -> Sample) -> [TrackRow; 2] {
    let alone = tracker(Method::EXPLICIT).push(&sample_at(0.3));
    let mut after_others = tracker(Method::EXPLICIT);
    for slip in [0.9, -0.4, f64::NAN, 0.0] {
        after_others.push(&sample_at(slip));
    }
    [alone, after_others.push(&sample_at(0.3))]
}

#[test]
fn a_row_does_not_depend_on_the_rows_before_it() {
    let [alone, after_others] = alone_and_after_others(|slip| slipping(1.0, slip));
    assert_eq!(bits(&after_others), bits(&alone));
}

#[test]
fn a_row_under_a_load_depends_on_the_rows_before_it_within_the_tolerance_of_the_search() {
    /// How far a search that starts elsewhere may end from another, relative.
    const SOLVED: f64 = 1e-12;
    let [alone, after_others] =
        alone_and_after_others(|slip| Sample { sinkage: Sinkage::CarryingLoad(80.0), ..slipping(1.0, slip) });
    for (one, other) in [
        (alone.sinkage, after_others.sinkage),
        (alone.longitudinal, after_others.longitudinal),
        (alone.normal, after_others.normal),
        (alone.torque, after_others.torque),
    ] {
        assert!((one / other - 1.0).abs() <= SOLVED, "{one} {other}");
    }
}

#[test]
fn energy_is_the_trapezoidal_integral_of_the_power() {
    let mut tracker = tracker(Method::EXPLICIT);
    let (mut sum, mut before) = (0.0, None);
    for i in 0..200 {
        let time = f64::from(i) * 0.1 + 0.04 * f64::from(i % 3);
        let row = tracker.push(&moving(time, 0.1 + 0.0004 * f64::from(i), 1.0));
        if let Some((earlier, power)) = before {
            sum += 0.5 * (power + row.power) * (time - earlier);
        }
        before = Some((time, row.power));
        assert!((row.energy - sum).abs() <= ROUNDING * sum.abs());
    }
    assert!(sum > 1.0);
}

#[test]
fn constant_power_gives_energy_in_proportion_to_time_after_many_samples() {
    let mut tracker = tracker(Method::EXPLICIT);
    let step = 1.0 / 1024.0; // exact, so that only the sum can lose digits
    let last = (0..100_000).map(|i| tracker.push(&moving(f64::from(i) * step, 0.16, 1.0))).last().expect("rows");
    let exact = last.power * 99_999.0 * step;
    assert!((last.energy - exact).abs() <= 4.0 * f64::EPSILON * exact, "{} {exact}", last.energy);
}

#[test]
fn a_bad_sample_is_null_counted_and_bridged() {
    let bad: [(Sample, Status); 9] = [
        (moving(1.0, f64::NAN, 1.0), Status::MissingValue),
        (moving(1.0, 0.1, f64::NAN), Status::MissingValue),
        (moving(1.0, 0.1, -1.0), Status::OppositeRotation),
        (moving(1.0, f64::INFINITY, 1.0), Status::OutOfRange),
        (slipping(1.0, 1.1), Status::SlipOutOfRange),
        (slipping(1.0, f64::NAN), Status::MissingValue),
        (Sample { sinkage: Sinkage::Given(f64::NAN), ..moving(1.0, 0.1, 1.0) }, Status::MissingValue),
        (Sample { sinkage: Sinkage::Given(0.0), ..moving(1.0, 0.1, 1.0) }, Status::OutOfRange),
        (Sample { sinkage: Sinkage::CarryingLoad(1e9), ..moving(1.0, 0.1, 1.0) }, Status::NoSolution),
    ];
    for (sample, status) in bad {
        let (mut with, mut without) = (tracker(Method::EXPLICIT), tracker(Method::EXPLICIT));
        with.push(&moving(0.0, 0.1, 1.0));
        without.push(&moving(0.0, 0.1, 1.0));
        let row = with.push(&sample);
        assert_eq!(row.status, status);
        assert!(
            [row.sinkage, row.longitudinal, row.normal, row.torque, row.power, row.energy].iter().all(|value| value.is_nan())
        );
        assert_eq!(with.tally(status).map(|tally| (tally.count, tally.first_row)), Some((1, 1)));
        let (bridged, plain) = (with.push(&moving(2.0, 0.15, 1.0)), without.push(&moving(2.0, 0.15, 1.0)));
        assert_eq!((bridged.energy, bridged.status), (plain.energy, Status::Ok));
        assert_eq!(with.tally(Status::Ok).map(|tally| tally.count), Some(2));
    }
}

#[test]
fn a_wheel_at_rest_is_static_and_takes_no_power() {
    let mut tracker = tracker(Method::Quadrature);
    for (forward, angular) in [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0)] {
        let row = tracker.push(&moving(0.0, forward, angular));
        assert_eq!((row.status, row.slip, row.sinkage, row.power), (Status::Static, 0.0, 0.02, 0.0));
    }
    assert_eq!(tracker.push(&slipping(1.0, 0.0)).status, Status::Ok, "rolling without slip is no rest");
    let efficiency = |tracker: &mut Tracker, forward, angular| tracker.push(&moving(2.0, forward, angular)).tractive_efficiency;
    assert!(efficiency(&mut tracker, 0.0, 0.0).is_nan(), "F_x v/(T ω) is 0/0");
    assert!(efficiency(&mut tracker, 0.0, 1.0) == 0.0, "v alone is 0 on a wheel that spins");
    assert!(efficiency(&mut tracker, 0.1, 0.0).is_nan(), "ω alone is 0 on a locked wheel");
}

#[test]
fn a_wheel_that_rolls_back_takes_the_same_power() {
    let ahead = tracker(Method::Quadrature).push(&moving(0.0, 0.15, 1.0));
    let mut tracker = tracker(Method::Quadrature);
    let back = tracker.push(&moving(0.0, -0.15, -1.0));
    assert_eq!((back.power, back.longitudinal, back.torque), (ahead.power, -ahead.longitudinal, -ahead.torque));
    assert!(tracker.has_moved_backward());
}

#[test]
fn cautions_are_counted_by_kind_with_the_one_furthest_out() {
    let mut tracker = tracker(Method::EXPLICIT);
    for (i, slip) in [0.1, -0.1, -0.3, -0.2].into_iter().enumerate() {
        tracker.push(&slipping(i as f64, slip));
    }
    let braking = tracker.cautions().iter().find(|tally| tally.worst.kind.code == "slip_sinkage_extrapolated");
    let braking = braking.expect("the law was fitted to driving wheels");
    assert_eq!((braking.count, braking.first_row, braking.worst.value), (3, 1, -0.3));
}

#[test]
fn slip_alone_gives_no_power() {
    let row = tracker(Method::EXPLICIT).push(&slipping(0.0, 0.2));
    assert!(row.power.is_nan() && row.energy.is_nan() && row.torque.is_finite() && row.tractive_efficiency.is_finite());
}

#[test]
fn time_that_runs_backwards_adds_no_energy() {
    let mut tracker = tracker(Method::EXPLICIT);
    let energy = |row: TrackRow| row.energy;
    tracker.push(&moving(10.0, 0.16, 1.0));
    let before = energy(tracker.push(&moving(11.0, 0.16, 1.0)));
    assert_eq!(tracker.push(&moving(3.0, 0.16, 1.0)).status, Status::TimeBackwards);
    assert_eq!(energy(tracker.push(&moving(4.0, 0.16, 1.0))), before, "the interval before has no length");
    assert!((energy(tracker.push(&moving(5.0, 0.16, 1.0))) - 2.0 * before).abs() <= ROUNDING * before);
    assert_eq!(energy(tracker.push(&moving(5.0, 0.16, 1.0))), 2.0 * before, "the same time twice adds nothing");
}

#[test]
fn the_coupled_form_gives_back_the_pull_of_linear_stresses() {
    // Torque and load of the linearised method belong together by Eq. (11), so its pull has to come out.
    for (slip, sign) in [(0.2, 1.0), (0.6, -1.0), (-0.1, 1.0)] {
        let forces = operation(Method::LINEARISED).at(common::slip(slip)).expect("a solution").forces;
        let (forward, angular) = if slip >= 0.0 { (0.2 * (1.0 - slip), 1.0) } else { (0.2 / (1.0 + slip), 1.0) };
        let measured = Some(Measured { torque: sign * forces.torque, normal_load: forces.normal });
        let mut tracker = tracker(Method::LINEARISED);
        let row = tracker.push(&Sample { measured, ..moving(0.0, sign * forward, sign * angular) });
        let expected = sign * forces.longitudinal;
        assert!((row.longitudinal_coupled - expected).abs() <= 1e-10 * forces.normal, "{} {expected}", row.longitudinal_coupled);
        assert!(tracker.not_coupled().is_none());
    }
}

#[test]
fn a_stall_lasts_its_time_and_is_told_with_both_ends() {
    let run = |slips: &[f64]| {
        let mut tracker = tracker(Method::EXPLICIT);
        for (i, &slip) in slips.iter().enumerate() {
            tracker.push(&slipping(i as f64, slip));
        }
        tracker.finish();
        let stalls = tracker.events().0.iter().filter(|event| event.kind == EventKind::Stall);
        stalls.map(|event| (event.row, event.from, event.to)).collect::<Vec<_>>()
    };
    assert_eq!(run(&[0.1, 0.9, 0.9, 0.1]), [], "one second is less than two");
    assert_eq!(run(&[0.1, 0.9, 0.8, 0.9, 0.1]), [(1, 1.0, 3.0)]);
    assert_eq!(run(&[0.1, 0.9, 0.9, 0.79, 0.9]), [], "interrupted");
    assert_eq!(run(&[0.9, f64::NAN, 2.0, 0.9]), [(0, 0.0, 3.0)], "a bad sample interrupts nothing");
    assert_eq!(run(&[0.9, 0.9, 0.9, 0.0, 0.9, 0.9, 0.9, 0.9]), [(0, 0.0, 2.0), (4, 4.0, 7.0)], "an open one ends with the run");
}

#[test]
fn a_wheel_beyond_half_its_radius_or_beyond_its_axle_is_entrapped() {
    let at = |time: f64, sinkage: Sinkage| Sample { sinkage, ..slipping(time, 0.2) };
    let linear = SlipSinkage::Linear(LinearSlipSinkage { gain: 100.0, skid_gain: None });
    let mut tracker = tracker(Method::EXPLICIT);
    tracker.push(&at(0.0, Sinkage::Given(0.1))); // just half of 0.2 m
    tracker.push(&at(1.0, Sinkage::Given(0.11)));
    let beyond = tracker.push(&at(2.0, Sinkage::CarryingLoad(1e9)));
    assert_eq!((beyond.status, beyond.slip), (Status::NoSolution, 0.2));
    tracker.push(&at(3.0, Sinkage::FromStatic { static_sinkage: 0.02, law: linear }));
    tracker.push(&at(4.0, Sinkage::Given(0.02)));
    let (events, left_out) = tracker.events();
    let [event] = events else { panic!("{events:?}") };
    assert_eq!((event.kind, event.row, event.from, event.to, left_out), (EventKind::Entrapment, 1, 1.0, 3.0, 0));
    assert!(matches!(tracker.tally(Status::NoSolution).and_then(|tally| tally.error), Some(Error::LoadBeyondCapacity { .. })));
}

#[test]
fn events_beyond_the_number_kept_are_counted() {
    let mut tracker = tracker(Method::EXPLICIT);
    for i in 0..2400 {
        tracker.push(&Sample { sinkage: Sinkage::Given(if i % 2 == 0 { 0.15 } else { 0.02 }), ..slipping(f64::from(i), 0.2) });
    }
    assert_eq!((tracker.events().0.len(), tracker.events().1), (1000, 200));
}

#[test]
fn thresholds_out_of_range_are_all_named() {
    let wrong = Thresholds { stall_slip: 0.0, stall_time: -1.0, entrapment_sinkage_ratio: f64::NAN };
    let invalid = Tracker::new(operation(Method::EXPLICIT), wrong).expect_err("three faults");
    let named: Vec<Parameter> = invalid.faults.iter().map(|fault| *fault.parameter).collect();
    assert_eq!(named, [Thresholds::STALL_SLIP, Thresholds::STALL_TIME, Thresholds::ENTRAPMENT_SINKAGE_RATIO]);
}

#[test]
fn a_torque_or_load_that_only_the_coupled_form_needs_is_missing_there_alone() {
    let plain = tracker(Method::EXPLICIT).push(&slipping(0.0, 0.2));
    let mut tracker = tracker(Method::EXPLICIT);
    let none = f64::NAN;
    for (i, (torque, normal_load)) in [(2.0, 80.0), (none, 80.0), (2.0, none), (none, none), (2.0, -1.0)].into_iter().enumerate()
    {
        let measured = Some(Measured { torque, normal_load });
        let row = tracker.push(&Sample { measured, ..slipping(i as f64, 0.2) });
        assert_eq!((row.status, bits(&row)), (Status::Ok, bits(&plain)));
        assert_eq!(row.longitudinal_coupled.is_finite(), i == 0);
    }
    let first = |tally: Option<&terramechanics::Tally>| tally.map(|tally| (tally.count, tally.first_row));
    assert_eq!(first(tracker.missing_torque()), Some((2, 1)));
    assert_eq!(first(tracker.missing_load()), Some((2, 2)));
    assert_eq!(first(tracker.not_coupled()), Some((1, 4)));
    // The load that the sinkage is solved for is no such value.
    let row = tracker.push(&Sample { sinkage: Sinkage::CarryingLoad(none), ..slipping(5.0, 0.2) });
    assert_eq!(row.status, Status::MissingValue);
}

#[test]
fn the_value_to_blame_is_counted_by_status_and_channel() {
    let mut tracker = tracker(Method::EXPLICIT);
    let deep = |time: f64, sinkage: f64| Sample { sinkage: Sinkage::Given(sinkage), ..slipping(time, 0.2) };
    let samples = [deep(0.0, 20.0), deep(1.0, 0.25), deep(2.0, 0.2), deep(3.0, -0.1), deep(4.0, f64::NAN)];
    let statuses = samples.map(|sample| tracker.push(&sample).status);
    // The radius is 0.2 m: what was measured beyond it is no entrapment but a wrong value.
    let beyond = Status::OutOfRange;
    assert_eq!(statuses, [beyond, beyond, Status::Ok, beyond, Status::MissingValue]);
    tracker.push(&slipping(5.0, 10.0));
    tracker.push(&slipping(6.0, -30.0));
    let unread = Sample { unreadable: true, ..slipping(7.0, f64::NAN) };
    assert_eq!(tracker.push(&unread).status, Status::Unreadable);
    assert_eq!(tracker.push(&Sample { unreadable: true, ..slipping(8.0, 0.1) }).status, Status::Ok, "its value is not needed");
    tracker.finish();
    let entrapped = tracker.events().0.iter().filter(|event| event.kind == EventKind::Entrapment);
    assert_eq!(entrapped.map(|event| (event.from, event.to)).collect::<Vec<_>>(), [(2.0, 2.0)]);
    let told: Vec<_> =
        tracker.culprits().iter().map(|of| (of.status, of.channel, of.count, of.first_value, of.largest)).collect();
    assert_eq!(told[0], (Status::OutOfRange, Channel::Sinkage, 3, 20.0, 20.0));
    assert_eq!((told[1].0, told[1].1, told[1].2), (Status::MissingValue, Channel::Sinkage, 1));
    assert_eq!(told[2], (Status::SlipOutOfRange, Channel::Slip, 2, 10.0, 30.0));
    assert_eq!((told[3].0, told[3].1, told.len()), (Status::Unreadable, Channel::Slip, 4));
}
