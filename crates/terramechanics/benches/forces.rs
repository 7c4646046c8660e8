//! What one answer costs: `cargo bench -p terramechanics`.

use divan::{Bencher, black_box};
use terramechanics::{
    Bekker, Braking, CentreOfMass, Circles, Contact, ContactParams, Drive, ForceModel, Interface, JanosiHanamoto, KnownSinkage,
    Measured, Method, NormalStressRadius, Operation, PeakDepth, PressureSinkage, Pull, Sample, SampleMotion, ShapeIntegrals,
    ShearLaw, Sinkage, SinkageExponent, Slip, SlipRadius, SlipSinkage, SlipSweep, Soil, SoilParams, Station, StressProfile,
    Thresholds, Tracker, Turning, Unloading, Vehicle, VehicleParams, Velocities, Wheel, WheelOnSoil, WheelParams,
    pull_from_torque,
};

fn main() {
    divan::main();
}

const METHODS: [&str; 4] = ["quadrature", "resistive_force", "linearised", "explicit"];

fn model(name: &str) -> ForceModel {
    ForceModel::at_rim(match name {
        "quadrature" => Method::Quadrature,
        "resistive_force" => Method::ResistiveForce,
        "linearised" => Method::LINEARISED,
        _ => Method::EXPLICIT,
    })
}

/// The letter's wheel and soil (its Fig. 1b), with a density of dry sand.
fn system() -> WheelOnSoil {
    let exponent = SinkageExponent { base: 0.91, slip_gain: 0.0, skid_gain: None };
    WheelOnSoil {
        wheel: Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 }).expect("a wheel"),
        soil: Soil::new(SoilParams {
            cohesion: 0.0,
            friction_angle: 0.478,
            shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.005 })),
            pressure_sinkage: Some(PressureSinkage::Bekker(Bekker { k_c: -660.0, k_phi: 754_130.0, exponent })),
            bulk_density: Some(1600.0),
            ..SoilParams::BARE
        })
        .expect("a soil"),
        contact: Contact::MIDPOINT,
    }
}

fn operation(method: &str, sinkage: Sinkage) -> Operation {
    Operation { system: system(), model: model(method), sinkage }
}

/// The same wheel with lugs, the displacement on the shearing circle and the slip on the lug tips, in cohesive soil.
fn lugged(method: &str, sinkage: Sinkage) -> Operation {
    let plain = system();
    let wheel = Wheel::new(WheelParams { lug_height: 0.02, ..*plain.wheel.params() }).expect("a wheel");
    let soil = Soil::new(SoilParams { cohesion: 100.0, ..*plain.soil.params() }).expect("a soil");
    let contact = plain.contact.with_circles(Circles { slip: SlipRadius::LugTip, ..Circles::SHEARING });
    Operation { system: WheelOnSoil { wheel, soil, contact }, model: model(method), sinkage }
}

fn slip(ratio: f64) -> Slip {
    Slip::new(ratio).expect("a slip")
}

fn one_point(bencher: Bencher<'_, '_>, method: &str, sinkage: Sinkage, ratio: f64) {
    let operation = operation(method, sinkage);
    bencher.bench_local(|| black_box(&operation).at(black_box(slip(ratio))));
}

// Many evaluations a sample, or the clock would be a part of what is measured.
#[divan::bench(args = METHODS, sample_size = 1000)]
fn forces_driving(bencher: Bencher<'_, '_>, method: &str) {
    one_point(bencher, method, Sinkage::Given(0.02), 0.2);
}

// Many evaluations a sample, or the clock would be a part of what is measured.
#[divan::bench(args = METHODS, sample_size = 1000)]
fn forces_braking(bencher: Bencher<'_, '_>, method: &str) {
    one_point(bencher, method, Sinkage::Given(0.02), -0.05);
}

#[divan::bench(args = METHODS, sample_size = 1000)]
fn forces_driving_lugged(bencher: Bencher<'_, '_>, method: &str) {
    let operation = lugged(method, Sinkage::Given(0.02));
    bencher.bench_local(|| black_box(&operation).at(black_box(slip(0.2))));
}

/// The load in place of the sinkage modulus, without and with cohesion, which takes an integral more.
#[divan::bench(args = METHODS, sample_size = 1000)]
fn known_load(bencher: Bencher<'_, '_>, method: &str) {
    one_point(bencher, method, Sinkage::UnderLoad { sinkage: KnownSinkage::Given(0.02), load: 80.0 }, 0.2);
}

#[divan::bench(args = METHODS, sample_size = 1000)]
fn known_load_lugged_cohesive(bencher: Bencher<'_, '_>, method: &str) {
    let operation = lugged(method, Sinkage::UnderLoad { sinkage: KnownSinkage::Given(0.02), load: 80.0 });
    bencher.bench_local(|| black_box(&operation).at(black_box(slip(0.2))));
}

/// A bare rim, which slips on the grains before the soil shears in itself.
#[divan::bench(args = ["quadrature", "linearised", "explicit"], sample_size = 1000)]
fn interface(bencher: Bencher<'_, '_>, method: &str) {
    let system = system();
    let contact = ContactParams {
        interface: Some(Interface { friction_angle: Some(0.35), adhesion: Some(0.0), shear_modulus: Some(0.0015) }),
        ..*system.contact.params()
    };
    let contact = Contact::new(contact).expect("a contact");
    let operation = Operation { system: WheelOnSoil { contact, ..system }, model: model(method), sinkage: Sinkage::Given(0.02) };
    bencher.bench_local(|| black_box(&operation).at(black_box(slip(0.2))));
}

#[divan::bench(args = METHODS)]
fn solved_load(bencher: Bencher<'_, '_>, method: &str) {
    one_point(bencher, method, Sinkage::CarryingLoad(80.0), 0.2);
}

/// The same of a braking wheel, whose balance a bracket finds.
#[divan::bench(args = METHODS)]
fn solved_load_braking(bencher: Bencher<'_, '_>, method: &str) {
    one_point(bencher, method, Sinkage::CarryingLoad(80.0), -0.05);
}

/// A braking wheel of two zones: at a sinkage, and under a load, whose balance a bracket finds.
#[divan::bench(args = ["given", "solved"])]
fn two_zones(bencher: Bencher<'_, '_>, sinkage: &str) {
    let plain = system();
    let contact = plain.contact.with_braking(Braking::TwoZone);
    let sinkage = if sinkage == "given" { Sinkage::Given(0.02) } else { Sinkage::CarryingLoad(80.0) };
    let operation = Operation { system: WheelOnSoil { contact, ..plain }, model: model("quadrature"), sinkage };
    assert!(operation.at(slip(-0.05)).is_ok());
    bencher.bench_local(|| black_box(&operation).at(black_box(slip(-0.05))));
}

/// Braking slips, at a sinkage and under a load.
#[divan::bench(args = METHODS)]
fn sweep_1001_braking(bencher: Bencher<'_, '_>, method: &str) {
    braking_sweep(bencher, method, Sinkage::Given(0.02));
}

#[divan::bench(args = METHODS)]
fn sweep_1001_braking_solved_sinkage(bencher: Bencher<'_, '_>, method: &str) {
    braking_sweep(bencher, method, Sinkage::CarryingLoad(80.0));
}

fn braking_sweep(bencher: Bencher<'_, '_>, method: &str, sinkage: Sinkage) {
    let operation = operation(method, sinkage);
    let slips: Vec<Slip> = (0..1001).map(|i| slip(-1e-4 * f64::from(i))).collect();
    let mut columns = SlipSweep::of(&operation, &slips);
    bencher.bench_local(|| columns.fill(black_box(&operation), black_box(&slips)));
}

fn sweep(bencher: Bencher<'_, '_>, method: &str, sinkage: Sinkage, points: u32) {
    let operation = operation(method, sinkage);
    let slips: Vec<Slip> = (0..points).map(|i| slip(f64::from(i) / f64::from(points - 1))).collect();
    let mut columns = SlipSweep::of(&operation, &slips);
    bencher.bench_local(|| columns.fill(black_box(&operation), black_box(&slips)));
}

#[divan::bench(args = METHODS)]
fn sweep_1001_given_sinkage(bencher: Bencher<'_, '_>, method: &str) {
    sweep(bencher, method, Sinkage::Given(0.02), 1001);
}

#[divan::bench(args = METHODS)]
fn sweep_1001_solved_sinkage(bencher: Bencher<'_, '_>, method: &str) {
    sweep(bencher, method, Sinkage::CarryingLoad(80.0), 1001);
}

/// Rows that are found in one piece of a long sweep, and then given away.
const PIECE: usize = 10_000;

/// Ten times the points should cost ten times the time. The memory is that of one piece.
#[divan::bench(args = [1_000, 10_000, 100_000, 1_000_000, 10_000_000], sample_count = 5, sample_size = 1)]
fn growth_explicit(bencher: Bencher<'_, '_>, points: usize) {
    growth(bencher, "explicit", points);
}

#[divan::bench(args = [1_000, 10_000, 100_000, 1_000_000, 10_000_000], sample_count = 3, sample_size = 1)]
fn growth_quadrature(bencher: Bencher<'_, '_>, points: usize) {
    growth(bencher, "quadrature", points);
}

fn growth(bencher: Bencher<'_, '_>, method: &str, points: usize) {
    let operation = operation(method, Sinkage::Given(0.02));
    let slips: Vec<Slip> = (0..PIECE.min(points)).map(|i| slip(i as f64 / PIECE as f64)).collect();
    let mut columns = SlipSweep::of(&operation, &slips);
    bencher.bench_local(|| {
        for _ in 0..points / slips.len() {
            columns.fill(black_box(&operation), black_box(&slips));
        }
    });
}

/// Sweeps side by side: a thread more should cost each of them nothing.
#[divan::bench(args = METHODS, threads = [1, 2])]
fn threads_1001_given_sinkage(bencher: Bencher<'_, '_>, method: &str) {
    let operation = operation(method, Sinkage::Given(0.02));
    let slips: Vec<Slip> = (0..1001).map(|i| slip(f64::from(i) / 1000.0)).collect();
    bencher.bench(|| SlipSweep::of(black_box(&operation), black_box(&slips)));
}

#[divan::bench(sample_size = 1000)]
fn pull_from_a_torque(bencher: Bencher<'_, '_>) {
    let system = system();
    let measured = Measured { torque: 7.3, normal_load: 90.0 };
    bencher.bench_local(|| {
        let angles = system.contact.angles(black_box(0.1), slip(0.2)).expect("angles");
        pull_from_torque(&system.wheel, &ShapeIntegrals::of(&angles), black_box(measured), NormalStressRadius::Rim)
    });
}

#[divan::bench]
fn profile_201(bencher: Bencher<'_, '_>) {
    let system = system();
    let rolling = system.rolling(slip(0.2)).expect("a rolling wheel");
    let patch = rolling.contact(0.02).expect("a contact");
    let stresses = patch.stresses().expect("stresses");
    bencher.bench_local(|| StressProfile::of(black_box(&stresses), 201, PeakDepth::Geometric));
}

/// A thousand samples of telemetry.
#[divan::bench(args = METHODS)]
fn track_1000_static_sinkage(bencher: Bencher<'_, '_>, method: &str) {
    track(bencher, method, Sinkage::FromStatic { static_sinkage: 0.02, law: SlipSinkage::Lyasko });
}

/// The same with the load of each: forces from slip, static sinkage and load.
#[divan::bench(args = METHODS)]
fn track_1000_known_load(bencher: Bencher<'_, '_>, method: &str) {
    let sinkage = KnownSinkage::FromStatic { static_sinkage: 0.02, law: SlipSinkage::Lyasko };
    track(bencher, method, Sinkage::UnderLoad { sinkage, load: 80.0 });
}

fn track(bencher: Bencher<'_, '_>, method: &str, sinkage: Sinkage) {
    let samples: Vec<Sample> = (0..1000)
        .map(|i| {
            let velocities = Velocities { forward: 0.1 + 0.05 * (f64::from(i) / 70.0).sin(), angular: 0.9 };
            Sample {
                time: f64::from(i),
                motion: SampleMotion::Velocities(velocities),
                sinkage,
                measured: None,
                unreadable: false,
            }
        })
        .collect();
    let tracker = Tracker::new(operation(method, sinkage), Thresholds::default()).expect("thresholds");
    bencher.with_inputs(|| tracker.clone()).bench_local_refs(|tracker| {
        for sample in &samples {
            black_box(tracker.push(black_box(sample)));
        }
    });
}

/// The slip that gives a pull, under a load.
#[divan::bench(args = METHODS)]
fn solved_slip(bencher: Bencher<'_, '_>, method: &str) {
    let operation = operation(method, Sinkage::CarryingLoad(80.0));
    bencher.bench_local(|| black_box(&operation).solve_slip(black_box(Pull::Force(12.0))));
}

/// A rover of four wheels: alike, or each of its own, in the ruts of those before, at equal torques, or one under a torque of its own.
fn rover(kind: &str) -> Vehicle {
    let station = |position, count, turning| Station { position, count, system: system(), turning };
    let last = if kind == "own torque" { Turning::UnderTorque(0.0) } else { Turning::Together };
    let stations = match kind {
        "alike" => vec![station(None, 4, Turning::Together)],
        _ => {
            let places = [(0.4, Turning::Together), (0.41, Turning::Together), (-0.4, Turning::Together), (-0.41, last)];
            places.map(|(x, turning)| station(Some(x), 1, turning)).to_vec()
        }
    };
    let centre_of_mass = (kind == "equal torques").then_some(CentreOfMass { position: 0.05, height: 0.2 });
    let drive = if kind == "equal torques" { Drive::EqualTorque } else { Drive::OneSlip };
    let unloading = (kind == "in ruts").then_some(Unloading::MEASURED);
    let model = model("quadrature");
    let params =
        VehicleParams { mass: 40.0, gravity: 9.81, stations, centre_of_mass, hitch_height: 0.0, drive, model, unloading };
    Vehicle::new(params).expect("a rover")
}

const ROVERS: [&str; 5] = ["alike", "stations", "in ruts", "equal torques", "own torque"];

#[divan::bench(args = ROVERS)]
fn vehicle_on_slope(bencher: Bencher<'_, '_>, kind: &str) {
    let rover = rover(kind);
    bencher.bench_local(|| black_box(&rover).on_slope(black_box(0.1), 0.0));
}

#[divan::bench(args = ROVERS)]
fn vehicle_largest_slope(bencher: Bencher<'_, '_>, kind: &str) {
    let rover = rover(kind);
    bencher.bench_local(|| black_box(&rover).largest_slope(black_box(0.0), 0.6));
}

/// A slope that no slip climbs takes the whole search.
#[divan::bench(args = ROVERS)]
fn vehicle_not_climbed(bencher: Bencher<'_, '_>, kind: &str) {
    let rover = rover(kind);
    bencher.bench_local(|| black_box(&rover).on_slope(black_box(0.8), 0.0));
}
