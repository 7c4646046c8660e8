//! The dearest operating points that a request may ask for: `cargo bench -p terramechanics --bench dearest [-- POINTS]`.
//!
//! Draws wheels, soils and operating points over the whole of their bounds and prints the usual and the highest processor time of each
//! kind of work, with the point that took it. The prices of the service have to cover them.

use std::hint::black_box;
use std::time::{Duration, Instant};

use terramechanics::{
    Braking, Contact, Direct, ForceModel, JanosiHanamoto, KnownSinkage, Method, Operation, PressureSinkage, ShearLaw, Sinkage,
    SinkageExponent, Slip, SlipSinkage, Soil, SoilParams, Wheel, WheelOnSoil, WheelParams, WongPeak, WongResidual,
};

const POINTS: u32 = 200_000;

/// A point that takes longer is timed again, for the system may have taken the thread away.
const DEAR: Duration = Duration::from_micros(20);
const REPEATS: u32 = 4;

/// Numbers in 0..1 by xorshift, the same in every run.
struct Draws(u64);

impl Draws {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.unit()
    }

    /// A number whose logarithm is uniform.
    fn over(&mut self, lower: f64, upper: f64) -> f64 {
        (self.between(lower.ln(), upper.ln())).exp()
    }

    /// One of the ends, or within.
    fn slip(&mut self) -> f64 {
        match self.unit() {
            draw if draw < 0.05 => 1.0,
            draw if draw < 0.1 => -1.0 + 1e-9,
            draw if draw < 0.2 => self.over(1e-12, 1e-3),
            _ => self.between(-1.0, 1.0),
        }
    }

    fn shear(&mut self) -> ShearLaw {
        let length = self.over(1e-6, 10.0);
        match self.unit() {
            draw if draw < 0.6 => ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: length }),
            draw if draw < 0.8 => {
                ShearLaw::WongResidual(WongResidual { residual_ratio: self.between(0.001, 1.0), peak_displacement: length })
            }
            _ => ShearLaw::WongPeak(WongPeak { peak_displacement: length }),
        }
    }

    fn system(&mut self) -> Option<WheelOnSoil> {
        let radius = self.over(1e-3, 100.0);
        let exponent = SinkageExponent { base: self.over(1e-3, 10.0), slip_gain: self.between(0.0, 1.0), skid_gain: None };
        Some(WheelOnSoil {
            wheel: Wheel::new(WheelParams {
                radius,
                width: self.over(1e-3, 100.0),
                lug_height: 0.1 * radius * self.unit(),
                lug_coefficient: 0.5,
            })
            .ok()?,
            soil: Soil::new(SoilParams {
                cohesion: if self.unit() < 0.5 { 0.0 } else { self.over(1.0, 1e8) },
                friction_angle: self.between(0.0, 1.57),
                shear: Some(self.shear()),
                pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: self.over(1e-6, 1e15), exponent })),
                ..SoilParams::BARE
            })
            .ok()?,
            contact: Contact::MIDPOINT.with_braking(if self.unit() < 0.5 { Braking::OneZone } else { Braking::TwoZone }),
        })
    }
}

fn processor_time(work: impl Fn()) -> Duration {
    let once = || {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    let first = once();
    if first < DEAR { first } else { (0..REPEATS).map(|_| once()).fold(first, Duration::min) }
}

/// A sinkage for a wheel of some radius (m).
type Draw = fn(&mut Draws, f64) -> Sinkage;

fn main() {
    let points = std::env::args().find_map(|argument| argument.parse().ok()).unwrap_or(POINTS);
    let kinds: [(&str, Draw); 4] = [
        ("given", |draws, radius| Sinkage::Given(radius * draws.over(1e-9, 1.0))),
        ("from a static one", |draws, radius| Sinkage::FromStatic {
            static_sinkage: radius * draws.over(1e-9, 1.0),
            law: SlipSinkage::Lyasko,
        }),
        ("under a load", |draws, _| Sinkage::CarryingLoad(draws.over(1e-9, 1e12))),
        ("under a known load", |draws, radius| Sinkage::UnderLoad {
            sinkage: KnownSinkage::Given(radius * draws.over(1e-9, 1.0)),
            load: draws.over(1e-9, 1e12),
        }),
    ];
    for (name, method) in [("quadrature", Method::Quadrature), ("linearised", Method::LINEARISED), ("explicit", Method::EXPLICIT)]
    {
        for (kind, sinkage) in kinds {
            let mut draws = Draws(0x9e37_79b9_7f4a_7c15);
            let mut times = Vec::new();
            let mut dearest = (Duration::ZERO, None);
            for _ in 0..points {
                let Some(system) = draws.system() else { continue };
                let (slip, sinkage) = (draws.slip(), sinkage(&mut draws, system.wheel.radius()));
                let operation = Operation { system, model: ForceModel::at_rim(method), sinkage };
                let Ok(slip) = Slip::new(slip) else { continue };
                let time = processor_time(|| {
                    let _ = black_box(black_box(&operation).at(black_box(slip)));
                });
                times.push(time);
                if time > dearest.0 {
                    dearest = (time, Some((operation, slip)));
                }
            }
            times.sort_unstable();
            let at = |share: f64| times[((times.len() - 1) as f64 * share) as usize];
            println!(
                "{name:10} {kind:18} median {:>9.2?}  99 % {:>9.2?}  99.9 % {:>9.2?}  most {:>9.2?}",
                at(0.5),
                at(0.99),
                at(0.999),
                dearest.0
            );
            if std::env::args().any(|argument| argument == "--show") {
                println!("    {:?}", dearest.1);
            }
        }
    }
}
