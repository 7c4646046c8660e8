//! For any finite input every fit ends, with finite numbers or a typed error.

mod common;
mod extremes;

use common::{Noise, five, measured, programme, truth};
use extremes::Draw;
use terramechanics::Method;
use terramechanics_identification::{
    FitError, FitOptions, PlateCurve, PlatesError, Quantity, ShearCurve, ShearError, SinkageSource, StrengthBound, fit,
    fit_line_while, fit_plates, fit_plates_while, fit_shear_curves, fit_shear_curves_while, fit_while,
};

/// Draws from as many seeds, each of some hundred bytes; one in twenty at least has to be a fit and no refusal.
fn draws(count: u64, of: fn(&mut Draw<'_>) -> bool) {
    let is_fit = |seed: &u64| {
        let mut noise = Noise::seeded(*seed);
        let bytes: Vec<u8> = (0..600).map(|_| (256.0 * noise.uniform()) as u8).collect();
        of(&mut Draw::new(&bytes))
    };
    let fits = (0..count).filter(is_fit).count() as u64;
    assert!(fits >= count / 20, "{fits} fits of {count} draws");
}

#[test]
fn shear_tests_over_all_numbers() {
    draws(1_500, extremes::shear);
}

#[test]
fn plates_over_all_numbers() {
    draws(10_000, extremes::plates);
}

#[test]
fn lines_over_all_numbers() {
    draws(10_000, extremes::line);
}

#[test]
fn fits_over_all_numbers() {
    draws(600, extremes::nonlinear);
}

fn test(normal: f64, displacement: &[f64], shear: &[f64]) -> ShearCurve {
    ShearCurve { normal, displacement: displacement.to_vec(), shear: shear.to_vec() }
}

/// Displacements that make the product of a large ratio and of what its exponential leaves 0 times infinity.
#[test]
fn displacements_far_apart_end() {
    let tests = [test(2.0, &[5e-324], &[1.0]), test(0.0, &[0.0], &[0.0])];
    assert_eq!(fit_shear_curves(&tests), Err(ShearError::Displacements));
    let tests = [test(1e3, &[0.001, 1e-6], &[-1.0, 1000.0]), test(1.0, &[0.0, 1e-6], &[0.0, 1e12])];
    let found = fit_shear_curves(&tests).expect("a fit");
    assert!(found.rmse.is_finite() && found.estimates.iter().all(|estimate| estimate.value.is_finite()), "{found:?}");
}

/// All that is displaced is displaced under one stress, where c and σ tan φ are one number: c + σ tan φ is the strength all the same.
#[test]
fn one_displaced_test_shows_one_strength() {
    let moved = [0.001, 0.002, 0.004, 0.02, 0.05];
    let shear = moved.map(|j: f64| 700.0 * (1.0 - (-j / 0.004).exp()));
    let found = fit_shear_curves(&[test(1e3, &moved, &shear), test(2e3, &[0.0], &[0.0])]).expect("a fit");
    let [cohesion, friction, modulus] = found.estimates.each_ref().map(|estimate| estimate.value);
    assert!(((cohesion + 1e3 * friction.tan()) / 700.0 - 1.0).abs() < 1e-6 && (modulus / 0.004 - 1.0).abs() < 1e-6, "{found:?}");
    assert!(found.estimates[..2].iter().all(|estimate| !estimate.identifiability.is_determined()), "{found:?}");
    // Without a normal stress there is nothing but cohesion.
    let found = fit_shear_curves(&[test(0.0, &moved, &shear), test(2e3, &[0.0], &[0.0])]).expect("a fit");
    assert!((found.estimates[0].value / 700.0 - 1.0).abs() < 1e-6, "{found:?}");
}

#[test]
fn numbers_that_cannot_be_squared_are_refused_by_name() {
    let shear = |displacement: f64, stress: f64| {
        fit_shear_curves(&[test(stress, &[displacement], &[stress]), test(2.0 * stress, &[displacement], &[stress])])
    };
    for size in [1e-308, 1e-101, 1e101, 1e300] {
        assert_eq!(shear(size, 1.0), Err(ShearError::Displacements), "{size}");
        assert_eq!(shear(0.01, size), Err(ShearError::Stresses), "{size}");
        let plate = |width: f64, scale: f64| PlateCurve { width, sinkage: vec![0.01, 0.02], pressure: vec![scale, 2.0 * scale] };
        assert_eq!(fit_plates(&[plate(0.1, 1.0), plate(size, 1.0)]), Err(PlatesError::Size(1)));
        assert!(matches!(fit_plates(&[plate(0.1, 1.0), plate(0.2, size)]), Err(PlatesError::Size(_))));
        let truth = truth(Method::LINEARISED, SinkageSource::Measured);
        let mut observations = measured(&truth, &programme(6));
        observations.torque.as_mut().expect("a column").values.fill(size);
        let found = fit(&truth, &observations, &five(&truth), &FitOptions::default());
        assert_eq!(found, Err(FitError::Size(Quantity::Torque)));
    }
}

/// A no to the first question and one in the middle end each fit there.
#[test]
fn a_no_ends_every_fit() {
    let setup = truth(Method::LINEARISED, SinkageSource::Measured);
    let observations = measured(&setup, &programme(300));
    let displacement: Vec<f64> = (0..30).map(|i| 0.002 * f64::from(i)).collect();
    let shear = |normal: f64| displacement.iter().map(|j| (800.0 + normal * 0.5) * (1.0 - (-j / 0.012).exp())).collect();
    let curve = |normal: f64| ShearCurve { normal, displacement: displacement.clone(), shear: shear(normal) };
    let tests = [2e3, 5e3].map(curve);
    let plate = |width: f64| PlateCurve { width, sinkage: vec![0.01, 0.02, 0.03], pressure: vec![1e4, 2.1e4, 2.9e4] };
    let plates = [plate(0.1), plate(0.2)];
    for patience in [0, 7] {
        let asked = std::cell::Cell::new(0);
        let go_on = || {
            asked.set(asked.get() + 1);
            asked.get() <= patience
        };
        let asked_since = || asked.replace(0);
        let options = FitOptions::default();
        assert_eq!(fit_while(&setup, &observations, &five(&setup), &options, &go_on), Err(FitError::Stopped));
        assert_eq!(asked_since(), patience + 1);
        assert_eq!(fit_line_while(&setup, &observations, &go_on), Err(FitError::Stopped));
        assert_eq!(asked_since(), patience + 1);
        assert_eq!(fit_shear_curves_while(&tests, &go_on), Err(ShearError::Stopped));
        assert_eq!(asked_since(), patience + 1);
        assert_eq!(fit_plates_while(&plates, &go_on), Err(PlatesError::Stopped));
        assert_eq!(asked_since(), patience + 1);
    }
}

/// Ten thousand samples and forty thousand residuals: between two questions lies no more than a block of them.
#[test]
fn large_fits_ask_as_they_go() {
    let setup = truth(Method::EXPLICIT, SinkageSource::Measured);
    let observations = measured(&setup, &programme(10_001));
    let asked = std::cell::Cell::new(0_u64);
    let go_on = || {
        asked.set(asked.get() + 1);
        true
    };
    let found = fit_while(&setup, &observations, &five(&setup), &FitOptions::default(), &go_on).expect("a fit");
    assert!(asked.get() >= found.evaluations / 128, "{} questions in {} evaluations", asked.get(), found.evaluations);
    let line = fit_line_while(&setup, &observations, &go_on).expect("samples").expect("a line");
    assert!(line.line.bound != Some(StrengthBound::NoFriction));
}
