//! The line with its account of what the samples do not tell.

mod common;

use common::{at, column, measured, programme, slip, truth};
use terramechanics::{Contact, ForceModel, Method, PressureSinkage, Sinkage, SoilParams};
use terramechanics_identification::{
    Bound, DesignGap, Estimate, FitError, Identifiability, LinearFit, Observations, Quantity, Setup, SinkageSource, Unknown,
    fit_line,
};

/// The usual wheel and soil, with the peak where the method has it.
fn setup(method: Method) -> Setup {
    Setup { contact: *Contact::MIDPOINT.params(), ..truth(method, SinkageSource::Measured) }
}

fn line(setup: &Setup, observations: &Observations) -> LinearFit {
    fit_line(setup, observations).expect("samples").expect("a line")
}

/// What a wheel shows at some slips under some loads.
fn under_loads(setup: &Setup, loads: &[f64], slips: &[f64]) -> Observations {
    let points: Vec<_> = loads
        .iter()
        .flat_map(|&load| slips.iter().map(move |&ratio| (load, ratio)))
        .map(|(load, ratio)| at(setup, ratio, Sinkage::CarryingLoad(load)))
        .collect();
    Observations {
        slip: points.iter().map(|point| point.slip).collect(),
        sinkage: column(points.iter().map(|point| point.sinkage).collect()),
        normal: column(points.iter().map(|point| point.forces.normal).collect()),
        torque: column(points.iter().map(|point| point.forces.torque).collect()),
        ..Observations::default()
    }
}

#[test]
fn linear_stresses_give_the_strength_back() {
    let setup = setup(Method::LINEARISED);
    let found = line(&setup, &measured(&setup, &programme(20)));
    let [cohesion, friction] = found.estimates.each_ref().map(|estimate| estimate.value);
    assert!((cohesion / 600.0 - 1.0).abs() < 1e-9 && (friction / 0.55 - 1.0).abs() < 1e-10, "{found:?}");
    assert!(found.converged && found.is_identifiable() && found.gaps.is_empty());
    assert!(found.torque.rmse < 1e-9 && (found.used, found.samples()) == (20, 20));
}

/// Four slips under one load, by the explicit formulas: the interval of the cohesion misses the truth by far, and the answer must
/// not hide it.
#[test]
fn one_load_never_determines_cohesion_and_friction() {
    let setup = setup(Method::EXPLICIT);
    let found = line(&setup, &under_loads(&setup, &[80.0], &[0.1, 0.2, 0.4, 0.6]));
    assert!(found.converged && !found.is_identifiable());
    assert_eq!(found.gaps, [DesignGap::OneLoad]);
    let [cohesion, friction] = &found.estimates;
    assert_eq!(cohesion.identifiability, Identifiability::Unseparated(DesignGap::OneLoad, vec![Unknown::FRICTION_ANGLE]));
    assert_eq!(friction.identifiability, Identifiability::Unseparated(DesignGap::OneLoad, vec![Unknown::COHESION]));
    let [lower, upper] = cohesion.interval.expect("an interval");
    assert!(!(lower..=upper).contains(&600.0), "or else this is no test of it: {found:?}");
}

/// At one slip a wrong shear modulus turns both by one factor.
#[test]
fn one_slip_does_not_show_a_wrong_shear_modulus() {
    let setup = setup(Method::LINEARISED);
    let found = line(&setup, &under_loads(&setup, &[30.0, 60.0, 90.0, 120.0], &[0.3]));
    assert_eq!(found.gaps, [DesignGap::OneSlip]);
    for estimate in &found.estimates {
        let expected = Identifiability::Unseparated(DesignGap::OneSlip, vec![Unknown::SHEAR_MODULUS]);
        assert_eq!(estimate.identifiability, expected);
    }
}

#[test]
fn two_samples_have_no_error_and_determine_nothing() {
    let setup = setup(Method::LINEARISED);
    let found = line(&setup, &measured(&setup, &programme(2)));
    for Estimate { standard_error, interval, identifiability, .. } in &found.estimates {
        assert_eq!((standard_error, interval), (&None, &None));
        assert!(!identifiability.is_determined());
    }
    assert_eq!(found.correlation, None);
}

/// The quadrature's torques and loads are not those of linear stresses. What misleads the line is known where the law is.
#[test]
fn the_bias_of_linear_stresses_is_found_by_simulation() {
    let setup = setup(Method::Quadrature);
    let found = line(&setup, &under_loads(&setup, &[20.0, 50.0, 80.0, 110.0], &[0.1, 0.2, 0.4, 0.6]));
    let bias = found.model_bias().expect("a bias");
    for (i, truth) in [600.0, 0.55].into_iter().enumerate() {
        let Estimate { value, interval, .. } = found.estimates[i];
        let [lower, upper] = interval.expect("an interval");
        assert!(!(lower..=upper).contains(&truth), "noise-free, and still off: {value} for {truth}");
        // The steps towards it leave a hundredth.
        assert!(((value - bias[i]) / truth - 1.0).abs() < 0.01, "{value} less {} for {truth}", bias[i]);
    }
}

/// Nothing of the line depends on the pressure–sinkage law; the bias does.
#[test]
fn the_law_cancels() {
    let setup = setup(Method::Quadrature);
    let observations = measured(&setup, &programme(12));
    let mut soft = setup;
    if let Some(PressureSinkage::Direct(law)) = &mut soft.soil.pressure_sinkage {
        law.k_s = 1e4;
    }
    let (found, other) = (line(&setup, &observations), line(&soft, &observations));
    assert_eq!((found.estimates.clone(), found.line), (other.estimates.clone(), other.line));
    assert_ne!(found.model_bias(), other.model_bias());
}

#[test]
fn a_cohesion_below_zero_is_held_and_says_so() {
    let mut setup = setup(Method::LINEARISED);
    setup.soil = SoilParams { cohesion: 0.0, ..setup.soil };
    let mut observations = measured(&setup, &programme(20));
    let loads = observations.normal.clone().expect("loads").values;
    let torque = observations.torque.as_mut().expect("torques");
    torque.values.iter_mut().zip(loads).for_each(|(torque, load)| *torque *= 1.0 + 1e-3 * (load - 100.0) / 100.0);
    let found = line(&setup, &observations);
    assert_eq!((found.estimates[0].value, found.estimates[0].at_bound), (0.0, Some(Bound::Lower)));
    assert_eq!(found.estimates[0].identifiability, Identifiability::AtBound);
    assert!(found.converged, "the best on the bound is an end of the search");
}

#[test]
fn numbers_too_far_apart_do_not_converge() {
    let setup = setup(Method::LINEARISED);
    let mut observations = measured(&setup, &programme(8));
    observations.torque.as_mut().expect("torques").values[3] = 1e200;
    // The squares overflow: whatever comes out, it is not called an end.
    assert!(!fit_line(&setup, &observations).is_ok_and(|found| found.is_some_and(|found| found.converged)));
}

#[test]
fn what_has_no_line_is_refused_or_none() {
    let setup = setup(Method::LINEARISED);
    let good = measured(&setup, &programme(5));
    let lacking = Observations { torque: None, ..good.clone() };
    assert_eq!(fit_line(&setup, &lacking).err(), Some(FitError::Missing(Quantity::Torque)));
    let mut lifted = good.clone();
    lifted.normal.as_mut().expect("loads").values[2] = 0.0;
    assert_eq!(fit_line(&setup, &lifted).err(), Some(FitError::Value { quantity: Quantity::Normal, row: 2 }));
    let mut deep = good;
    deep.sinkage.as_mut().expect("sinkages").values[4] = 0.2;
    assert!(matches!(fit_line(&setup, &deep).err(), Some(FitError::Refused { row: 4, .. })));
    let point = at(&setup, 0.2, Sinkage::Given(0.01));
    let alike = Observations {
        slip: vec![slip(0.2); 3],
        sinkage: column(vec![0.01; 3]),
        normal: column(vec![point.forces.normal; 3]),
        torque: column(vec![point.forces.torque; 3]),
        ..Observations::default()
    };
    assert_eq!(fit_line(&setup, &alike), Ok(None));
    let exact = Setup { model: ForceModel::at_rim(Method::Quadrature), ..setup };
    let data = measured(&setup, &programme(6));
    assert_eq!(line(&exact, &data).line, line(&setup, &data).line, "the method has no influence");
}
