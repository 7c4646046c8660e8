//! The covariance of a line that forgets: against dense matrices by numpy, and against what noise does to many runs.

mod common;

use common::{Noise, slip};
use serde_json::Value;
use terramechanics::{
    AngleRatio, Circles, Contact, ContactParams, Direct, ExitRule, JanosiHanamoto, NormalStressRadius, PeakRule, PressureSinkage,
    ShapeIntegrals, ShearLaw, SinkageExponent, Soil, SoilParams, Wheel, WheelOnSoil, WheelParams, WongReece,
};
use terramechanics_identification::{RollingSample, RunningStrength};

/// By `reference/strength.py`.
const REFERENCE: &str = include_str!("reference/strength.json");

/// The reference inverts XᵀWX with both columns as they are: its condition number is some 1e9, and the variances have its square
/// root's share of the digits.
const DENSE: f64 = 1e-7;

fn lugged(modulus: f64, contact: ContactParams) -> WheelOnSoil {
    let exponent = SinkageExponent { base: 1.0, slip_gain: 0.0, skid_gain: None };
    let soil = SoilParams {
        cohesion: 1.0,
        friction_angle: 0.3,
        shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus })),
        pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 1e6, exponent })),
        ..SoilParams::BARE
    };
    WheelOnSoil {
        wheel: Wheel::new(WheelParams { radius: 0.15, width: 0.12, lug_height: 0.008, lug_coefficient: 0.5 }).expect("a wheel"),
        soil: Soil::new(soil).expect("a soil"),
        contact: Contact::new(contact).expect("a contact"),
    }
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} in {value}"))
}

#[test]
fn estimate_and_covariance_are_those_of_dense_matrices() {
    let reference: Value = serde_json::from_str(REFERENCE).expect("JSON");
    let contact = &reference["contact"];
    let rule = PeakRule::WongReece(WongReece { c1: number(contact, "c1"), c2: number(contact, "c2") });
    let system = lugged(
        number(&reference, "shear_modulus_m"),
        ContactParams {
            rule,
            exit: ExitRule::AngleRatio(AngleRatio { c3: number(contact, "c3") }),
            circles: Circles::RIM,
            ..ContactParams::MIDPOINT
        },
    );
    let mut compared = 0;
    for case in reference["cases"].as_array().expect("cases") {
        let factor = number(case, "forgetting_factor");
        let mut running = RunningStrength::new(system, NormalStressRadius::Rim, factor).expect("an estimate");
        let mut expected = case["estimates"].as_array().expect("estimates").iter().peekable();
        for (row, sample) in reference["samples"].as_array().expect("samples").iter().enumerate() {
            let [ratio, sinkage, load, torque] = [0, 1, 2, 3].map(|i| sample[i].as_f64().expect("a number"));
            assert!(running.take(&RollingSample { slip: slip(ratio), sinkage, load, torque }).expect("a sample"));
            let Some(known) = expected.next_if(|known| known["row"] == row) else { continue };
            let found = running.estimate().expect("a line");
            for (name, value) in [
                ("cohesion_pa", found.cohesion),
                ("tan_friction", found.tan_friction),
                ("cohesion_variance_pa2", found.cohesion_variance),
                ("tan_friction_variance", found.tan_friction_variance),
                ("covariance_pa", found.covariance),
                ("freedom", found.freedom),
            ] {
                let off = value / number(known, name) - 1.0;
                assert!(off.abs() < DENSE, "λ = {factor}, row {row}, {name}: {value} is off by {off:e}");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 4 * 3 * 6);
}

/// A sample with these stresses at its peak, of a wheel on the soil of [`lugged`].
fn sample(system: &WheelOnSoil, ratio: f64, normal: f64, strength: f64) -> RollingSample {
    const SINKAGE: f64 = 0.02;
    let (wheel, slip) = (&system.wheel, slip(ratio));
    let rolling = system.rolling(slip).expect("a rolling wheel");
    let patch = rolling.contact(SINKAGE).expect("a contact");
    let (shape, arm, width) = (ShapeIntegrals::of(&patch.angles), wheel.shearing_radius(), wheel.width());
    let shear = patch.peak_mobilisation() * strength;
    let load = wheel.radius() * width * shape.a * normal + arm * width * shape.b * shear;
    RollingSample { slip, sinkage: SINKAGE, load, torque: arm * arm * width * shape.h * shear }
}

/// Noise on the strength alone, as the covariance assumes: its mean is the variance that many runs show.
///
/// The variance of `RUNS` normal estimates is known to √(2/RUNS), 3.7 %. The mean of the reported variances is known to as much
/// again: each has at least (1 + λ)/(1 − λ) − 2 degrees of freedom, two at λ = 0.6. Four standard deviations of both together
/// are 21 %.
#[test]
fn the_reported_variance_is_the_one_that_noise_causes() {
    const RUNS: usize = 1500;
    const SAMPLES: usize = 120;
    let midpoint = ContactParams { rule: PeakRule::Midpoint, ..ContactParams::MIDPOINT };
    let system = lugged(0.012, midpoint);
    let mut noise = Noise::seeded(5);
    for factor in [1.0, 0.99, 0.9, 0.6] {
        let mut found = Vec::with_capacity(RUNS);
        for _ in 0..RUNS {
            let mut running = RunningStrength::new(system, NormalStressRadius::Rim, factor).expect("an estimate");
            for i in 0..SAMPLES {
                let normal = 4e3 + 800.0 * ((7 * i) % 11) as f64;
                let strength = 600.0 + 0.6 * normal + 5.0 * noise.normal();
                running.take(&sample(&system, 0.1 + 0.1 * (i % 5) as f64, normal, strength)).expect("a sample");
            }
            found.push(running.estimate().expect("a line"));
        }
        let ratio = |value: &dyn Fn(usize) -> f64, variance: &dyn Fn(usize) -> f64| {
            let mean = (0..RUNS).map(value).sum::<f64>() / RUNS as f64;
            let shown = (0..RUNS).map(|i| (value(i) - mean).powi(2)).sum::<f64>() / (RUNS - 1) as f64;
            (0..RUNS).map(variance).sum::<f64>() / RUNS as f64 / shown
        };
        let friction = ratio(&|i| found[i].tan_friction, &|i| found[i].tan_friction_variance);
        let cohesion = ratio(&|i| found[i].cohesion, &|i| found[i].cohesion_variance);
        println!("λ = {factor}: reported over shown variance {friction:.3} of tan φ, {cohesion:.3} of c");
        assert!((friction - 1.0).abs() < 0.21 && (cohesion - 1.0).abs() < 0.21, "λ = {factor}: {friction} and {cohesion}");
    }
}

/// With λ = 1/2 the weights add up to two, and still a freedom is left.
#[test]
fn three_samples_have_a_variance_and_two_have_none() {
    let system = lugged(0.012, ContactParams { rule: PeakRule::Midpoint, ..ContactParams::MIDPOINT });
    let mut running = RunningStrength::new(system, NormalStressRadius::Rim, 0.5).expect("an estimate");
    let mut variance = |normal: f64, strength: f64| {
        running.take(&sample(&system, 0.3, normal, strength)).expect("a sample");
        running.estimate().map(|estimate| estimate.tan_friction_variance)
    };
    assert_eq!(variance(4e3, 3e3), None);
    assert_eq!(variance(6e3, 4.3e3), Some(f64::INFINITY));
    assert!(variance(9e3, 6e3).is_some_and(|variance| variance > 0.0 && variance.is_finite()));
    assert!((0..100).all(|i| variance(4e3 + 1e3 * f64::from(i % 3), 3e3 + 500.0 * f64::from(i % 2)).is_some_and(f64::is_finite)));
}
