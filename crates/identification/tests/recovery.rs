//! The fit finds the parameters that made the data, from starts far off.

mod common;

use common::{at, column, five, measured, programme, slip, sought, truth};
use terramechanics::{Method, Sinkage, SlipSinkage};
use terramechanics_identification::{
    Fit, FitError, FitOptions, Observations, Setup, SinkageSource, Sought, StopReason, Unknown, fit,
};

/// What is asked of a fit without noise; the rounding of the data, times the condition number, stays well below.
const RECOVERED: f64 = 1e-6;

const METHODS: [Method; 3] = [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT];

fn assert_recovered(fit: &Fit, truth: &Setup) {
    assert!(fit.converged() && fit.is_identifiable(), "{fit:#?}");
    for estimate in &fit.estimates {
        let expected = estimate.unknown.value(truth).expect("a parameter");
        let error = (estimate.value - expected).abs() / expected.abs().max(1e-3);
        assert!(error < RECOVERED, "{}: {} instead of {expected}", estimate.unknown, estimate.value);
    }
}

fn fitted(setup: &Setup, observations: &Observations, sought: &[Sought]) -> Fit {
    fit(setup, observations, sought, &FitOptions::default()).expect("a fit")
}

#[test]
fn five_parameters_of_the_soil_at_measured_sinkages() {
    for method in METHODS {
        let truth = truth(method, SinkageSource::Measured);
        assert_recovered(&fitted(&truth, &measured(&truth, &programme(40)), &five(&truth)), &truth);
    }
}

#[test]
fn the_peaks_place_and_the_slip_gain() {
    for method in METHODS {
        let truth = truth(method, SinkageSource::Measured);
        let starts = [
            (Unknown::FRICTION_ANGLE, 0.4),
            (Unknown::SINKAGE_MODULUS, 3e5),
            (Unknown::BASE_EXPONENT, 1.1),
            (Unknown::SLIP_GAIN, 0.0),
            (Unknown::PEAK_INTERCEPT, 0.35),
            (Unknown::PEAK_SLIP_GAIN, 0.0),
        ];
        // The peak may leave the contact on the way, where the model has no answer: one start need not be enough.
        let starts_tried = if method == Method::EXPLICIT { 8 } else { 1 };
        let options = FitOptions { starts: starts_tried, ..FitOptions::default() };
        let observations = measured(&truth, &programme(60));
        assert_recovered(&fit(&truth, &observations, &sought(&truth, &starts), &options).expect("a fit"), &truth);
    }
}

/// Where the search runs into the border of the model it says so instead of taking the border for a minimum.
#[test]
fn a_search_that_the_model_stops_has_not_converged() {
    let truth = truth(Method::EXPLICIT, SinkageSource::Measured);
    let starts = [
        (Unknown::FRICTION_ANGLE, 0.4),
        (Unknown::SINKAGE_MODULUS, 3e5),
        (Unknown::BASE_EXPONENT, 1.1),
        (Unknown::SLIP_GAIN, 0.0),
        (Unknown::PEAK_INTERCEPT, 0.35),
        (Unknown::PEAK_SLIP_GAIN, 0.0),
    ];
    let found = fitted(&truth, &measured(&truth, &programme(60)), &sought(&truth, &starts));
    assert_eq!(found.stop, StopReason::ModelRefuses, "{found:#?}");
    assert!(!found.converged() && (found.estimates[0].value - 0.55).abs() > RECOVERED);
}

#[test]
fn the_constants_of_the_explicit_method() {
    let method = Method::Explicit {
        peak_depth: terramechanics::PeakDepth::Half,
        lambda_a: terramechanics::Lambda::Given(0.05),
        lambda_b: terramechanics::Lambda::Given(-0.1),
    };
    let truth = truth(method, SinkageSource::Measured);
    let starts =
        [(Unknown::LAMBDA_A, 0.0), (Unknown::LAMBDA_B, 0.0), (Unknown::FRICTION_ANGLE, 0.45), (Unknown::SINKAGE_MODULUS, 5e5)];
    assert_recovered(&fitted(&truth, &measured(&truth, &programme(40)), &sought(&truth, &starts)), &truth);
}

/// Without a measured sinkage the normal force is the load, and the sinkage is solved for every trial.
#[test]
fn four_parameters_under_measured_loads() {
    for method in METHODS {
        let truth = truth(method, SinkageSource::Load);
        let loads: Vec<(f64, f64)> = programme(24).into_iter().map(|(slip, share)| (slip, 20.0 + 4000.0 * share)).collect();
        let points: Vec<_> = loads.iter().map(|&(ratio, load)| at(&truth, ratio, Sinkage::CarryingLoad(load))).collect();
        let observations = Observations {
            slip: loads.iter().map(|&(ratio, _)| slip(ratio)).collect(),
            sinkage: column(points.iter().map(|point| point.sinkage).collect()),
            normal: column(loads.iter().map(|&(_, load)| load).collect()),
            torque: column(points.iter().map(|point| point.forces.torque).collect()),
            longitudinal: column(points.iter().map(|point| point.forces.longitudinal).collect()),
        };
        let starts = [
            (Unknown::FRICTION_ANGLE, 0.4),
            (Unknown::SHEAR_MODULUS, 0.03),
            (Unknown::SINKAGE_MODULUS, 2e6),
            (Unknown::BASE_EXPONENT, 1.1),
        ];
        assert_recovered(&fitted(&truth, &observations, &sought(&truth, &starts)), &truth);
        let unmeasured = Observations { sinkage: None, ..observations };
        assert_recovered(&fitted(&truth, &unmeasured, &sought(&truth, &starts)), &truth);
    }
}

#[test]
fn the_static_sinkage() {
    let source = SinkageSource::Static { static_sinkage: 0.013, law: SlipSinkage::Lyasko };
    let truth = truth(Method::Quadrature, source);
    let slips: Vec<f64> = programme(20).into_iter().map(|(slip, _)| slip).collect();
    let sinkage = Sinkage::FromStatic { static_sinkage: 0.013, law: SlipSinkage::Lyasko };
    let points: Vec<_> = slips.iter().map(|&ratio| at(&truth, ratio, sinkage)).collect();
    let observations = Observations {
        slip: slips.iter().map(|&ratio| slip(ratio)).collect(),
        sinkage: column(points.iter().map(|point| point.sinkage).collect()),
        normal: column(points.iter().map(|point| point.forces.normal).collect()),
        torque: column(points.iter().map(|point| point.forces.torque).collect()),
        longitudinal: None,
    };
    let starts = [(Unknown::STATIC_SINKAGE, 0.005), (Unknown::SINKAGE_MODULUS, 2e6), (Unknown::FRICTION_ANGLE, 0.4)];
    assert_recovered(&fitted(&truth, &observations, &sought(&truth, &starts)), &truth);
}

/// From a far start one search ends elsewhere or nowhere; several find the truth, and the result is the same in every run.
#[test]
fn several_starts_find_what_one_misses_and_are_repeatable() {
    let truth = truth(Method::EXPLICIT, SinkageSource::Measured);
    let observations = measured(&truth, &programme(40));
    let far: Vec<Sought> = five(&truth)
        .into_iter()
        .map(|one| Sought { start: if one.unknown == Unknown::SHEAR_MODULUS { 0.9 } else { one.start }, ..one })
        .collect();
    let options = FitOptions { starts: 6, ..FitOptions::default() };
    let found = fit(&truth, &observations, &far, &options).expect("a fit");
    assert_recovered(&found, &truth);
    assert_eq!(found, fit(&truth, &observations, &far, &options).expect("a fit"));
}

#[test]
fn an_estimate_at_its_bound_is_there_exactly_and_says_so() {
    let mut truth = truth(Method::LINEARISED, SinkageSource::Measured);
    truth.soil.cohesion = 0.0;
    let observations = measured(&truth, &programme(40));
    let mut sought = five(&truth);
    sought[1].bounds = terramechanics_identification::Range::new(0.0, 0.5); // the truth is 0.55
    sought[1].start = 0.3;
    let found = fitted(&truth, &observations, &sought);
    let angle = &found.estimates[1];
    assert_eq!((angle.value, angle.at_bound), (0.5, Some(terramechanics_identification::Bound::Upper)));
    assert_eq!(angle.identifiability, terramechanics_identification::Identifiability::AtBound);
    // A start at the bound leaves it where the data ask for that.
    sought[1].bounds.upper = 1.5;
    sought[1].start = 0.0;
    sought[0].start = 0.0;
    let found = fitted(&truth, &observations, &sought);
    assert!((found.estimates[1].value - 0.55).abs() < RECOVERED && found.estimates[0].value.abs() < 1e-3);
}

#[test]
fn a_search_that_runs_out_of_evaluations_or_time_says_so() {
    let truth = truth(Method::LINEARISED, SinkageSource::Measured);
    let observations = measured(&truth, &programme(40));
    let soon = FitOptions { evaluations: 1500, ..FitOptions::default() };
    let found = fit(&truth, &observations, &five(&truth), &soon).expect("what was reached");
    assert!(found.stop == StopReason::Budget && !found.converged(), "{:?}", found.stop);
    let late = FitOptions { until: Some(std::time::Instant::now()), ..FitOptions::default() };
    assert_eq!(fit(&truth, &observations, &five(&truth), &late), Err(FitError::OutOfBudget));
}
