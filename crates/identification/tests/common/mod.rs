//! Measurements made up from the model, with and without noise.
#![allow(dead_code, reason = "each test file uses its own part")]

use terramechanics::{
    Circles, ContactParams, Direct, ForceModel, JanosiHanamoto, Method, OperatingPoint, Operation, PeakRule, PressureSinkage,
    ShearLaw, Sinkage, SinkageExponent, Slip, SoilParams, Wheel, WheelParams, WongReece,
};
use terramechanics_identification::{Column, Observations, Setup, SinkageSource, Sought, Unknown};

/// A cohesive sand under a wheel of the size of a small rover's.
pub(crate) fn truth(method: Method, sinkage: SinkageSource) -> Setup {
    let exponent = SinkageExponent { base: 0.9, slip_gain: 0.3, skid_gain: None };
    Setup {
        wheel: Wheel::new(WheelParams { radius: 0.15, width: 0.12, lug_height: 0.008, lug_coefficient: 0.5 }).expect("a wheel"),
        soil: SoilParams {
            cohesion: 600.0,
            friction_angle: 0.55,
            shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.012 })),
            pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 9e5, exponent })),
            ..SoilParams::BARE
        },
        contact: ContactParams {
            rule: PeakRule::WongReece(WongReece { c1: 0.45, c2: 0.1 }),
            circles: Circles::RIM,
            ..ContactParams::MIDPOINT
        },
        model: ForceModel::at_rim(method),
        sinkage,
    }
}

pub(crate) fn slip(ratio: f64) -> Slip {
    Slip::new(ratio).expect("a slip")
}

/// Slips and sinkages that cover a test programme: both vary, and not together.
pub(crate) fn programme(samples: usize) -> Vec<(f64, f64)> {
    let share = |i: usize, factor: f64| (0.5 + i as f64 * factor).fract();
    (0..samples).map(|i| (0.03 + 0.75 * share(i, 0.754_877_666), 0.006 + 0.03 * share(i, 0.569_840_291))).collect()
}

pub(crate) fn at(setup: &Setup, ratio: f64, sinkage: Sinkage) -> OperatingPoint {
    let system = setup.system().expect("a system");
    Operation { system, model: setup.model, sinkage }.at(slip(ratio)).expect("an operating point")
}

pub(crate) fn column(values: Vec<f64>) -> Option<Column> {
    Some(Column { values, deviation: None })
}

/// Everything measured, without noise, at the slips and sinkages of a programme.
pub(crate) fn measured(setup: &Setup, programme: &[(f64, f64)]) -> Observations {
    let points: Vec<OperatingPoint> =
        programme.iter().map(|&(ratio, sinkage)| at(setup, ratio, Sinkage::Given(sinkage))).collect();
    Observations {
        slip: points.iter().map(|point| point.slip).collect(),
        sinkage: column(points.iter().map(|point| point.sinkage).collect()),
        longitudinal: column(points.iter().map(|point| point.forces.longitudinal).collect()),
        normal: column(points.iter().map(|point| point.forces.normal).collect()),
        torque: column(points.iter().map(|point| point.forces.torque).collect()),
    }
}

/// The unknowns, each from a start off the truth by the given factor, or by the given addition where the truth may be 0.
pub(crate) fn sought(setup: &Setup, starts: &[(Unknown, f64)]) -> Vec<Sought> {
    starts.iter().map(|&(unknown, start)| Sought { start, ..Sought::from_setup(unknown, setup) }).collect()
}

/// The five unknowns of the usual fit, from starts that are those of another soil.
pub(crate) fn five(setup: &Setup) -> Vec<Sought> {
    sought(
        setup,
        &[
            (Unknown::COHESION, 100.0),
            (Unknown::FRICTION_ANGLE, 0.4),
            (Unknown::SHEAR_MODULUS, 0.03),
            (Unknown::SINKAGE_MODULUS, 2e6),
            (Unknown::BASE_EXPONENT, 1.2),
        ],
    )
}

/// Normal noise that is the same in every run: SplitMix64 (Steele, Lea & Flood 2014) and Box–Muller.
pub(crate) struct Noise(u64);

impl Noise {
    /// Streams of neighbouring seeds have nothing in common: the seed goes through the generator's own mixing, since states one
    /// increment apart would give the same stream shifted by one.
    pub(crate) fn seeded(seed: u64) -> Self {
        Self(mixed(mixed(seed ^ 0xD1B5_4A32_D192_ED03)))
    }

    pub(crate) fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        (mixed(self.0) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }

    /// Noise of one standard deviation on a column.
    pub(crate) fn on(&mut self, column: &mut Option<Column>, deviation: f64) {
        let column = column.as_mut().expect("a column");
        column.values.iter_mut().for_each(|value| *value += deviation * self.normal());
    }
}

/// The finalizer of SplitMix64.
fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}
