//! The linear estimate against Iagnemma's identity, closed forms and a batch solution.

mod common;

use common::{Noise, slip};
use terramechanics::{
    Contact, Coupled, Direct, JanosiHanamoto, NormalStressRadius, PressureSinkage, ShearLaw, SinkageExponent, Soil, SoilParams,
    Wheel, WheelOnSoil, WheelParams,
};
use terramechanics_identification::{RollingSample, RunningStrength, StrengthBound, StressPoint, linear_strength};

use NormalStressRadius::Rim;

/// The identity, and anything without noise, up to rounding.
const EXACT: f64 = 1e-12;

/// A smooth wheel on a soil with a shear modulus; what else the soil has must not matter.
fn system(radius: f64, width: f64, modulus: f64) -> WheelOnSoil {
    with_strength(radius, width, modulus, 123.0, 0.1)
}

fn with_strength(radius: f64, width: f64, modulus: f64, cohesion: f64, friction_angle: f64) -> WheelOnSoil {
    let exponent = SinkageExponent { base: 1.3, slip_gain: 0.0, skid_gain: None };
    let soil = SoilParams {
        cohesion,
        friction_angle,
        shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus })),
        pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 1e4, exponent })),
        ..SoilParams::BARE
    };
    WheelOnSoil {
        wheel: Wheel::new(WheelParams { radius, width, lug_height: 0.0, lug_coefficient: 0.5 }).expect("a wheel"),
        soil: Soil::new(soil).expect("a soil"),
        contact: Contact::MIDPOINT,
    }
}

/// What a smooth wheel of given size, at an entry angle, slip and peak stress, shows of a soil.
struct Case {
    radius: f64,
    width: f64,
    modulus: f64,
    cohesion: f64,
    friction: f64,
    entry: f64,
    slip: f64,
    normal: f64,
}

const LETTER: Case =
    Case { radius: 0.2, width: 0.1, modulus: 0.02, cohesion: 500.0, friction: 0.6, entry: 0.7, slip: 0.3, normal: 9000.0 };

impl Case {
    fn mobilisation(&self) -> f64 {
        let Self { radius, modulus, entry, slip, .. } = *self;
        1.0 - (-(radius / modulus) * (entry / 2.0 + (1.0 - slip) * ((entry / 2.0).sin() - entry.sin()))).exp()
    }

    /// Shibly's closed forms at the midpoint, written out.
    fn sample(&self) -> RollingSample {
        let Self { radius, width, entry, normal, .. } = *self;
        let shear = self.mobilisation() * (self.cohesion + normal * self.friction.tan());
        let a = 2.0 / entry * (2.0 * (entry / 2.0).cos() - 1.0 - entry.cos());
        let b = 2.0 / entry * (2.0 * (entry / 2.0).sin() - entry.sin());
        RollingSample {
            slip: slip(self.slip),
            sinkage: radius * (1.0 - entry.cos()),
            load: radius * width * (a * normal + b * shear),
            torque: radius * radius * width * entry / 2.0 * shear,
        }
    }

    /// Iagnemma's κ1, κ2, κ3.
    fn kappas(&self) -> [f64; 3] {
        let Self { radius, width, entry, .. } = *self;
        let RollingSample { load, torque, .. } = self.sample();
        let e = self.mobilisation();
        let g = entry.cos() - 2.0 * (entry / 2.0).cos() + 1.0;
        [
            e * (entry * entry * load * radius + 4.0 * torque * entry.sin() - 8.0 * torque * (entry / 2.0).sin()),
            4.0 * torque * g,
            2.0 * width * radius * radius * entry * e * g,
        ]
    }
}

#[test]
fn iagnemmas_identity_holds_and_is_the_line_that_is_fitted() {
    let second = Case { cohesion: 0.0, friction: 0.478, entry: 0.5, slip: 0.1, normal: 5000.0, ..LETTER };
    for (case, load, torque) in [(LETTER, 70.459_026, 7.000_476_7), (second, 25.172_900_8, 0.874_367_5)] {
        let sample = case.sample();
        // Computed independently, to about this many digits.
        assert!((sample.load - load).abs() < 1e-6 && (sample.torque - torque).abs() < 1e-6, "{sample:?}");
        let [k1, k2, k3] = case.kappas();
        let tan_friction = case.friction.tan();
        assert!((k1 * tan_friction - k3 * case.cohesion + k2).abs() < EXACT * k2.abs());
        let on = system(case.radius, case.width, case.modulus);
        let point = StressPoint::of(&on, Rim, &sample).expect("a point").expect("mobilised");
        assert!((point.strength / (k2 / k3) - 1.0).abs() < EXACT, "{point:?}");
        assert!((point.normal / (-k1 / k3) - 1.0).abs() < EXACT && (point.normal / case.normal - 1.0).abs() < EXACT);
        let on = with_strength(case.radius, case.width, case.modulus, case.cohesion, case.friction);
        let rolling = on.rolling(sample.slip).expect("a rolling wheel");
        let patch = rolling.contact(sample.sinkage).expect("a contact");
        let known = Coupled { normal_load: sample.load, torque: None, normal_stress_radius: Rim };
        assert!((known.forces(&patch).expect("forces").torque / sample.torque - 1.0).abs() < EXACT);
    }
}

fn cases(count: usize) -> Vec<RollingSample> {
    let case = |i: usize| {
        let share = i as f64 / count as f64;
        Case { entry: 0.4 + 0.4 * share, slip: 0.1 + 0.7 * (7.3 * share).fract(), normal: 4000.0 + 9000.0 * share, ..LETTER }
    };
    (0..count).map(|i| case(i).sample()).collect()
}

#[test]
fn cohesion_and_friction_come_back() {
    let (estimate, used) = linear_strength(system(0.2, 0.1, 0.02), Rim, cases(20)).expect("samples");
    let estimate = estimate.expect("a line");
    assert_eq!(used, 20);
    assert!((estimate.cohesion / 500.0 - 1.0).abs() < 1e-10, "{estimate:?}");
    assert!((estimate.tan_friction / 0.6_f64.tan() - 1.0).abs() < EXACT);
}

/// Dense normal equations, solved by Cramer's rule, for the same points.
#[test]
fn without_forgetting_the_running_estimate_is_the_batch() {
    let mut noise = Noise::seeded(11);
    let samples: Vec<RollingSample> = cases(60)
        .into_iter()
        .map(|sample| RollingSample { torque: sample.torque * (1.0 + 0.02 * noise.normal()), ..sample })
        .collect();
    let (estimate, _) = linear_strength(system(0.2, 0.1, 0.02), Rim, samples.clone()).expect("samples");
    let estimate = estimate.expect("a line");
    let points: Vec<StressPoint> = samples
        .iter()
        .map(|sample| StressPoint::of(&system(0.2, 0.1, 0.02), Rim, sample).expect("a point").expect("mobilised"))
        .collect();
    let sum = |of: &dyn Fn(&StressPoint) -> f64| points.iter().map(of).sum::<f64>();
    let (n, sx, sy) = (60.0, sum(&|p| p.normal), sum(&|p| p.strength));
    let (sxx, sxy) = (sum(&|p| p.normal * p.normal), sum(&|p| p.normal * p.strength));
    let determinant = n * sxx - sx * sx;
    let (slope, intercept) = ((n * sxy - sx * sy) / determinant, (sxx * sy - sx * sxy) / determinant);
    assert!((estimate.tan_friction / slope - 1.0).abs() < 1e-10 && (estimate.cohesion / intercept - 1.0).abs() < 1e-8);
    let squares = sum(&|p| (p.strength - intercept - slope * p.normal).powi(2));
    let variance = squares / 58.0 * n / determinant;
    assert!((estimate.tan_friction_variance / variance - 1.0).abs() < 1e-8);
    let cohesion_variance = squares / 58.0 * sxx / determinant;
    assert!((estimate.cohesion_variance / cohesion_variance - 1.0).abs() < 1e-8);
}

#[test]
fn forgetting_follows_a_soil_that_changes() {
    let mut running = RunningStrength::new(system(0.2, 0.1, 0.02), Rim, 0.9).expect("an estimate");
    let mut rigid = RunningStrength::new(system(0.2, 0.1, 0.02), Rim, 1.0).expect("an estimate");
    let weak = |i: usize| Case { friction: 0.4, normal: 4000.0 + 700.0 * (i % 9) as f64, ..LETTER }.sample();
    let strong = |i: usize| Case { normal: 4000.0 + 700.0 * (i % 9) as f64, ..LETTER }.sample();
    for i in 0..100 {
        let sample = if i < 50 { weak(i) } else { strong(i) };
        assert!(running.take(&sample).expect("a sample") && rigid.take(&sample).expect("a sample"));
    }
    let (running, rigid) = (running.estimate().expect("a line"), rigid.estimate().expect("a line"));
    // After fifty samples 0.9^50 = 0.5 % of the weight is left to the weak soil.
    assert!((running.tan_friction / 0.6_f64.tan() - 1.0).abs() < 0.02, "{running:?}");
    assert!((rigid.tan_friction / 0.6_f64.tan() - 1.0).abs() > 0.1, "{rigid:?}");
}

#[test]
fn samples_under_one_stress_have_no_line() {
    let (estimate, used) = linear_strength(system(0.2, 0.1, 0.02), Rim, vec![LETTER.sample(); 30]).expect("samples");
    assert_eq!((estimate, used), (None, 30));
    assert_eq!(linear_strength(system(0.2, 0.1, 0.02), Rim, []).expect("no samples"), (None, 0));
}

#[test]
fn a_line_below_zero_is_held_at_no_cohesion() {
    let samples: Vec<RollingSample> =
        cases(20).into_iter().map(|sample| RollingSample { torque: sample.torque * sample.load / 60.0, ..sample }).collect();
    let (estimate, _) = linear_strength(system(0.2, 0.1, 0.02), Rim, samples).expect("samples");
    let estimate = estimate.expect("a line");
    assert_eq!((estimate.cohesion, estimate.bound), (0.0, Some(StrengthBound::NoCohesion)));
}

#[test]
fn what_cannot_be_is_refused() {
    let deep = RollingSample { sinkage: 0.3, ..LETTER.sample() };
    assert!(linear_strength(system(0.2, 0.1, 0.02), Rim, [LETTER.sample(), deep]).is_err_and(|(row, _)| row == 1));
    for sample in [RollingSample { load: 0.0, ..LETTER.sample() }, RollingSample { torque: f64::NAN, ..LETTER.sample() }] {
        assert!(linear_strength(system(0.2, 0.1, 0.02), Rim, [LETTER.sample(), sample]).is_err_and(|(row, _)| row == 1));
    }
    for forgetting in [0.0, 1.1, f64::NAN] {
        assert!(RunningStrength::new(system(0.2, 0.1, 0.02), Rim, forgetting).is_none());
    }
    let rolling = RollingSample { slip: slip(-0.02), ..LETTER.sample() };
    assert!(StressPoint::of(&system(0.2, 0.1, 10.0), Rim, &rolling).expect("a sample").is_none(), "next to nothing is mobilised");
}
