//! What the data cannot tell is said, always.

mod common;

use common::{at, column, five, measured, programme, slip, sought, truth};
use terramechanics::{Method, Sinkage};
use terramechanics_identification::{
    DesignGap, Fit, FitOptions, Identifiability, Observations, Setup, SinkageSource, Sought, Unknown, fit,
};

const METHODS: [Method; 3] = [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT];

fn fitted(setup: &Setup, observations: &Observations, sought: &[Sought]) -> Fit {
    fit(setup, observations, sought, &FitOptions::default()).expect("a fit")
}

fn finding(fit: &Fit, unknown: Unknown) -> &Identifiability {
    let estimate = fit.estimates.iter().find(|estimate| estimate.unknown == unknown);
    &estimate.expect("an estimate").identifiability
}

#[test]
fn a_single_slip() {
    for method in METHODS {
        let truth = truth(method, SinkageSource::Measured);
        let one_slip: Vec<(f64, f64)> = programme(20).into_iter().map(|(_, sinkage)| (0.3, sinkage)).collect();
        let observations = measured(&truth, &one_slip);
        let found = fitted(&truth, &observations, &five(&truth));
        assert!(!found.is_identifiable());
        assert!(matches!(finding(&found, Unknown::SHEAR_MODULUS), Identifiability::Unseparated(DesignGap::OneSlip, _)));
        // N = n0 + n1 s at one s: no design flag is needed, the direction is dead.
        let exponents =
            sought(&truth, &[(Unknown::BASE_EXPONENT, 1.1), (Unknown::SLIP_GAIN, 0.0), (Unknown::SINKAGE_MODULUS, 2e6)]);
        let found = fitted(&truth, &observations, &exponents);
        assert_eq!(finding(&found, Unknown::BASE_EXPONENT), &Identifiability::Inseparable(vec![Unknown::SLIP_GAIN]));
        assert!(found.condition_number.is_infinite() && found.estimates[0].standard_error.is_none());
        assert!(found.estimates[2].standard_error.is_some(), "the modulus is told apart");
        let [(_, n0), (_, n1), (_, modulus)] = found.dead_directions[0][..] else { panic!("one direction of three") };
        assert!((n0 + n1).abs() < 1e-6 && modulus.abs() < 1e-6, "n0 up, n1 down: {n0} {n1} {modulus}");
    }
}

#[test]
fn a_single_load() {
    for method in METHODS {
        let truth = truth(method, SinkageSource::Load);
        let slips: Vec<f64> = programme(20).into_iter().map(|(slip, _)| slip).collect();
        let points: Vec<_> = slips.iter().map(|&ratio| at(&truth, ratio, Sinkage::CarryingLoad(60.0))).collect();
        let observations = Observations {
            slip: slips.iter().map(|&ratio| slip(ratio)).collect(),
            normal: column(vec![60.0; slips.len()]),
            torque: column(points.iter().map(|point| point.forces.torque).collect()),
            longitudinal: column(points.iter().map(|point| point.forces.longitudinal).collect()),
            sinkage: None,
        };
        let found = fitted(&truth, &observations, &five(&truth));
        assert!(!found.is_identifiable());
        for unknown in [Unknown::COHESION, Unknown::SINKAGE_MODULUS, Unknown::BASE_EXPONENT] {
            assert!(matches!(
                finding(&found, unknown),
                Identifiability::Unseparated(DesignGap::OneLoad, _) | Identifiability::Inseparable(_)
            ));
        }
    }
}

#[test]
fn nothing_but_the_normal_force() {
    for method in METHODS {
        let truth = truth(method, SinkageSource::Measured);
        let all = measured(&truth, &programme(40));
        let observations = Observations { longitudinal: None, torque: None, ..all };
        let found = fitted(&truth, &observations, &five(&truth));
        assert!(!found.is_identifiable());
        for unknown in [Unknown::COHESION, Unknown::FRICTION_ANGLE, Unknown::SHEAR_MODULUS] {
            assert!(!finding(&found, unknown).is_determined(), "{unknown}");
        }
        // The pressure–sinkage law alone is what a normal force over sinkage shows.
        let law = sought(&truth, &[(Unknown::SINKAGE_MODULUS, 3e5), (Unknown::BASE_EXPONENT, 1.3)]);
        assert!(fitted(&truth, &observations, &law).is_identifiable());
    }
}

#[test]
fn fewer_measurements_than_unknowns() {
    let truth = truth(Method::LINEARISED, SinkageSource::Measured);
    let found = fitted(&truth, &measured(&truth, &programme(1)), &five(&truth));
    assert!(!found.is_identifiable() && found.dead_directions.len() >= 2);
    assert!(found.estimates.iter().all(|estimate| estimate.standard_error.is_none()));
}

/// On one wheel k_c/b + k_φ is one number.
#[test]
fn both_of_bekkers_moduli_on_one_wheel() {
    let mut truth = truth(Method::LINEARISED, SinkageSource::Measured);
    let exponent = truth.soil.pressure_sinkage.expect("a law").exponent();
    truth.soil.pressure_sinkage =
        Some(terramechanics::PressureSinkage::Bekker(terramechanics::Bekker { k_c: 5e3, k_phi: 8e5, exponent }));
    let moduli = sought(&truth, &[(Unknown::COHESIVE_MODULUS, 0.0), (Unknown::FRICTIONAL_MODULUS, 5e5)]);
    let found = fitted(&truth, &measured(&truth, &programme(30)), &moduli);
    assert_eq!(finding(&found, Unknown::COHESIVE_MODULUS), &Identifiability::Inseparable(vec![Unknown::FRICTIONAL_MODULUS]));
    let modulus = |setup: &Setup| {
        Unknown::COHESIVE_MODULUS.value(setup).expect("k_c") / 0.12 + Unknown::FRICTIONAL_MODULUS.value(setup).expect("k_φ")
    };
    assert!((modulus(&found.setup) / modulus(&truth) - 1.0).abs() < 1e-6, "what is one number is found");
}

#[test]
fn a_parameter_that_the_data_do_not_know() {
    // At full slip of a firmly sheared contact E is 1 all along, whatever K.
    let mut truth = truth(Method::EXPLICIT, SinkageSource::Measured);
    truth.soil.shear = Some(terramechanics::ShearLaw::JanosiHanamoto(terramechanics::JanosiHanamoto { modulus: 2e-5 }));
    let full: Vec<(f64, f64)> = programme(10).into_iter().map(|(_, sinkage)| (1.0, sinkage)).collect();
    let start = sought(&truth, &[(Unknown::SHEAR_MODULUS, 2e-5)]);
    let found = fitted(&truth, &measured(&truth, &full), &start);
    assert_eq!(finding(&found, Unknown::SHEAR_MODULUS), &Identifiability::WithoutEffect);
}

/// Noise that swamps the effect of a parameter makes it uncertain, and that is said.
#[test]
fn an_estimate_that_noise_leaves_open() {
    let truth = truth(Method::EXPLICIT, SinkageSource::Measured);
    let mut observations = measured(&truth, &programme(12));
    let mut noise = common::Noise::seeded(3);
    noise.on(&mut observations.torque, 0.5);
    noise.on(&mut observations.longitudinal, 6.0);
    noise.on(&mut observations.normal, 12.0);
    let found = fitted(&truth, &observations, &five(&truth));
    assert!(!found.is_identifiable());
    assert!(
        found.estimates.iter().any(|estimate| estimate.identifiability == Identifiability::Uncertain),
        "{:#?}",
        found.estimates
    );
    assert!(found.estimates.iter().all(|estimate| estimate.interval.is_some()), "an open estimate still has an interval");
}

/// Without the column of the normal force the load is the one that the model predicts, and one load stays one load.
#[test]
fn a_single_load_that_was_not_measured() {
    for (method, shares) in [(Method::EXPLICIT, [0.0, 0.02]), (Method::LINEARISED, [0.0, 0.02])] {
        let truth = truth(method, SinkageSource::Measured);
        let slips: Vec<f64> = programme(20).into_iter().map(|(slip, _)| slip).collect();
        let points: Vec<_> = slips.iter().map(|&ratio| at(&truth, ratio, Sinkage::CarryingLoad(60.0))).collect();
        let clean = Observations {
            slip: slips.iter().map(|&ratio| slip(ratio)).collect(),
            sinkage: column(points.iter().map(|point| point.sinkage).collect()),
            torque: column(points.iter().map(|point| point.forces.torque).collect()),
            longitudinal: column(points.iter().map(|point| point.forces.longitudinal).collect()),
            normal: None,
        };
        for share in shares {
            for seed in 0..20 {
                let mut noise = common::Noise::seeded(seed);
                let mut observations = clean.clone();
                for column in [&mut observations.torque, &mut observations.longitudinal] {
                    let values = &mut column.as_mut().expect("a column").values;
                    values.iter_mut().for_each(|value| *value *= 1.0 + share * noise.normal());
                }
                let found = fitted(&truth, &observations, &five(&truth));
                assert!(!found.is_identifiable(), "{method:?} {share} {seed}: {:#?}", found.estimates);
            }
        }
        // Loads that vary are seen to, measured or not.
        let varied = Observations { normal: None, ..measured(&truth, &programme(40)) };
        let found = fitted(&truth, &varied, &five(&truth));
        assert!(found.gaps.is_empty(), "{:?}", found.gaps);
    }
}

/// Repeating a point adds no number that it has not given.
#[test]
fn one_point_over_and_over() {
    let method = Method::Explicit {
        peak_depth: terramechanics::PeakDepth::Half,
        lambda_a: terramechanics::Lambda::Given(0.05),
        lambda_b: terramechanics::Lambda::Given(-0.1),
    };
    let truth = truth(method, SinkageSource::Measured);
    let observations = measured(&truth, &[(0.3, 0.02); 6]);
    let unknowns = sought(&truth, &[(Unknown::FRICTION_ANGLE, 0.45), (Unknown::SINKAGE_MODULUS, 5e5), (Unknown::LAMBDA_A, 0.0)]);
    let found = fitted(&truth, &observations, &unknowns);
    assert!(!found.is_identifiable());
    assert!(found.gaps.iter().any(|(gap, together)| *gap == DesignGap::FewPoints && together.len() == 3), "{:?}", found.gaps);
    // Two points give six numbers, five of which are not too many for them, three repeated are.
    let two: Vec<(f64, f64)> = [(0.1, 0.01), (0.5, 0.03)].into_iter().cycle().take(8).collect();
    let found = fitted(&truth, &Observations { torque: None, normal: None, ..measured(&truth, &two) }, &unknowns);
    assert!(found.gaps.iter().any(|(gap, _)| *gap == DesignGap::FewPoints), "{:?}", found.gaps);
}

/// A column in another unit, or a wheel of another size, is missed, whatever the data determine.
#[test]
fn a_column_that_is_missed_says_so() {
    let truth = truth(Method::LINEARISED, SinkageSource::Measured);
    let observations = measured(&truth, &programme(40));
    let missed =
        |fit: &Fit| -> Vec<_> { fit.columns.iter().filter(|column| column.is_missed()).map(|column| column.quantity).collect() };
    assert_eq!(missed(&fitted(&truth, &observations, &five(&truth))), []);
    let mut kilonewtons = observations.clone();
    for column in [&mut kilonewtons.longitudinal, &mut kilonewtons.normal] {
        column.as_mut().expect("a column").values.iter_mut().for_each(|value| *value *= 1e-3);
    }
    assert!(missed(&fitted(&truth, &kilonewtons, &five(&truth))).contains(&terramechanics_identification::Quantity::Torque));
}
