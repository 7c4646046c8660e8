//! What one identification costs: `cargo bench -p terramechanics-identification`.

#[path = "../tests/common/mod.rs"]
mod common;

use common::{five, measured, programme, slip, truth};
use divan::{Bencher, black_box};
use terramechanics::{ContactParams, Method, NormalStressRadius, PeakRule};
use terramechanics_identification::{FitOptions, Observations, RollingSample, RunningStrength, Setup, SinkageSource, fit};

fn main() {
    divan::main();
}

const METHODS: [&str; 3] = ["quadrature", "linearised", "explicit"];

fn setup(method: &str, sinkage: SinkageSource) -> Setup {
    let method = match method {
        "quadrature" => Method::Quadrature,
        "linearised" => Method::LINEARISED,
        _ => Method::EXPLICIT,
    };
    let contact = ContactParams { rule: PeakRule::Midpoint, ..ContactParams::MIDPOINT };
    Setup { contact, ..truth(method, sinkage) }
}

/// A hundred samples over slip and sinkage, each force off by a percent or so to one side or the other.
fn observations(setup: &Setup) -> Observations {
    let mut observations = measured(setup, &programme(100));
    let forces = [&mut observations.longitudinal, &mut observations.normal, &mut observations.torque];
    for (column, factor) in forces.into_iter().zip([0.618_033_989, 0.414_213_562, 0.732_050_808]) {
        for (i, value) in column.iter_mut().flat_map(|column| column.values.iter_mut()).enumerate() {
            *value *= 1.0 + 0.02 * ((0.5 + i as f64 * factor).fract() - 0.5);
        }
    }
    observations
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
    let sample = RollingSample { slip: slip(0.2), sinkage: 0.02, load: 60.0, torque: 4.0 };
    let other = RollingSample { load: 90.0, torque: 6.0, ..sample };
    bencher.bench_local(|| (running.take(black_box(&sample)), running.take(black_box(&other)), running.estimate()));
}
