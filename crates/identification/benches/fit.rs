//! What one identification costs: `cargo bench -p terramechanics-identification`.

use divan::{Bencher, black_box};
use terramechanics::{
    ContactParams, Direct, ForceModel, JanosiHanamoto, Method, NormalStressRadius, OperatingPoint, Operation, PeakRule,
    PressureSinkage, ShearLaw, Sinkage, SinkageExponent, Slip, SoilParams, Wheel, WheelParams,
};
use terramechanics_identification::{
    Column, FitOptions, Observations, RollingSample, RunningStrength, Setup, SinkageSource, Sought, Unknown, fit,
};

fn main() {
    divan::main();
}

const METHODS: [&str; 3] = ["quadrature", "linearised", "explicit"];

fn setup(method: &str, sinkage: SinkageSource) -> Setup {
    let exponent = SinkageExponent { base: 0.9, slip_gain: 0.3, skid_gain: None };
    Setup {
        wheel: Wheel::new(WheelParams { radius: 0.15, width: 0.12, lug_height: 0.008, lug_coefficient: 0.5 }).expect("a wheel"),
        soil: SoilParams {
            cohesion: 600.0,
            friction_angle: 0.55,
            shear: ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.012 }),
            pressure_sinkage: PressureSinkage::Direct(Direct { k_s: 9e5, exponent }),
            unit_weight: None,
            lateral_shear_modulus: None,
        },
        contact: ContactParams { rule: PeakRule::Midpoint, exit_ratio: 0.0 },
        model: ForceModel::at_rim(match method {
            "quadrature" => Method::Quadrature,
            "linearised" => Method::LINEARISED,
            _ => Method::EXPLICIT,
        }),
        sinkage,
    }
}

/// A hundred samples over slip and sinkage, each force off by a percent or so to one side or the other.
fn observations(setup: &Setup) -> Observations {
    let system = setup.system().expect("a system");
    let share = |i: usize, factor: f64| (0.5 + i as f64 * factor).fract();
    let points: Vec<OperatingPoint> = (0..100)
        .map(|i| {
            let slip = Slip::new(0.03 + 0.75 * share(i, 0.754_877_666)).expect("a slip");
            let sinkage = Sinkage::Given(0.006 + 0.03 * share(i, 0.569_840_291));
            Operation { system, model: setup.model, sinkage }.at(slip).expect("an operating point")
        })
        .collect();
    let column = |of: fn(&OperatingPoint) -> f64, factor: f64| {
        let value = |(i, point): (usize, &OperatingPoint)| of(point) * (1.0 + 0.02 * (share(i, factor) - 0.5));
        Some(Column { values: points.iter().enumerate().map(value).collect(), deviation: None })
    };
    Observations {
        slip: points.iter().map(|point| point.slip).collect(),
        sinkage: Some(Column { values: points.iter().map(|point| point.sinkage).collect(), deviation: None }),
        longitudinal: column(|point| point.forces.longitudinal, 0.618_033_989),
        normal: column(|point| point.forces.normal, 0.414_213_562),
        torque: column(|point| point.forces.torque, 0.732_050_808),
    }
}

/// Cohesion, friction, shear modulus, sinkage modulus and exponent, from the values of another soil.
fn five(setup: &Setup) -> Vec<Sought> {
    let starts = [
        (Unknown::Cohesion, 100.0),
        (Unknown::FrictionAngle, 0.4),
        (Unknown::ShearModulus, 0.03),
        (Unknown::SinkageModulus, 2e6),
        (Unknown::BaseExponent, 1.2),
    ];
    starts.iter().map(|&(unknown, start)| Sought { start, ..Sought::from_setup(unknown, setup) }).collect()
}

fn identify(bencher: Bencher<'_, '_>, setup: &Setup, observations: &Observations) {
    let sought = five(setup);
    let run = || fit(black_box(setup), black_box(observations), &sought, &FitOptions::default()).expect("a fit");
    assert!(run().converged());
    bencher.bench_local(run);
}

#[divan::bench(args = METHODS)]
fn five_parameters_100_samples(bencher: Bencher<'_, '_>, method: &str) {
    let setup = setup(method, SinkageSource::Measured);
    identify(bencher, &setup, &observations(&setup));
}

/// The sinkage of every sample is solved for at every step.
#[divan::bench(args = METHODS)]
fn five_parameters_100_loads(bencher: Bencher<'_, '_>, method: &str) {
    let setup = setup(method, SinkageSource::Load);
    identify(bencher, &setup, &observations(&setup));
}

#[divan::bench]
fn one_sample_of_the_running_estimate(bencher: Bencher<'_, '_>) {
    let setup = setup("linearised", SinkageSource::Measured);
    let mut running =
        RunningStrength::new(setup.system().expect("a system"), NormalStressRadius::Rim, 0.98).expect("an estimate");
    let slip = Slip::new(0.2).expect("a slip");
    let sample = RollingSample { slip, sinkage: 0.02, load: 60.0, torque: 4.0 };
    let other = RollingSample { load: 90.0, torque: 6.0, ..sample };
    bencher.bench_local(|| (running.take(black_box(&sample)), running.take(black_box(&other)), running.estimate()));
}
