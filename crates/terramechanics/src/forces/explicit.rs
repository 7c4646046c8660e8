//! What forces follow from slip and sinkage alone? The letter's own explicit formulas (Eqs. 14–17).
//!
//! With σm = K_s z_m^N (Eq. 1) and E at the peak (Eq. 6), and with the printed errors corrected:
//!
//! | equation | here |
//! |---|---|
//! | (14a) A = (1 − λ_A) √(z/(2r)) | [`approximate_shape`] |
//! | (14b) B = (1 + λ_B) z/(2r), with r for the printed π (erratum 8) | [`approximate_shape`] |
//! | (15) F_x = −(1 + λ_B) b K_s (z/2)^(N+1) + (r_s/√r) (1 − λ_A) b E [K_s tan φ (z/2)^(N+1/2) + c (z/2)^(1/2)] | [`ClosedForm::forces`](super::ClosedForm::forces) |
//! | (16) F_z = √r (1 − λ_A) b K_s (z/2)^(N+1/2) + (r_s/r) (1 + λ_B) b E [K_s tan φ (z/2)^(N+1) + c (z/2)] | [`ClosedForm::forces`](super::ClosedForm::forces) |
//! | (17) T = (r_s²/2) b E θ1 [c + (z/2)^N K_s tan φ] | [`ClosedForm::forces`](super::ClosedForm::forces) |
//!
//! Eqs. (15) and (16) are A Y − B X and A X + B Y of Eq. (11), with X = r b σm, Y = r_s b τm, A and B from (14) and z_m = z/2
//! from (8). They are computed in that form, which also gives the four parts of the forces. A test compares the result with the
//! formulas above.
//!
//! Units: SI, forces in N, the torque in N·m; λ_A and λ_B have none. Validity: exit at the lowest point, θ2 = 0, from which
//! (14) and (17) follow. The half sinkage of Eq. (8) is exact under the rule [`HalfSinkage`](crate::HalfSinkage). With the peak
//! at the midpoint of a shallow contact the depth there is 3/4 of the sinkage, so the published form carries much less than the
//! quadrature.
//!
//! Departures: (15) prints r_s √r for r_s/√r (erratum 9) and C for c (erratum 10). (17) uses the whole entry angle, arccos(1 −
//! z/r), which (13) halves (erratum 7). Options: the normal stress at r_s (erratum 3), the geometric depth under the peak, and
//! λ_A and λ_B computed so that (14) is exact.

use super::outline::Outline;
use super::shape::{self, shape_within};
use super::{Lambda, ShapeIntegrals};
use crate::contact::AngleRates;
use crate::numerics::elementary::Number;

/// A and B by Eq. (14); where λ is exact, that is what Eq. (12) gives.
#[inline(always)]
pub(super) fn approximate_shape<F: Number>(outline: &Outline<F>, [lambda_a, lambda_b]: [Lambda; 2]) -> ShapeIntegrals<F> {
    let half_depth_ratio = outline.depth_ratio * 0.5; // z/(2r)
    let mut shape = ShapeIntegrals {
        a: half_depth_ratio.sqrt(),
        b: half_depth_ratio,
        h: outline.angles.entry * 0.5, // Eq. (17)
    };
    let exact = if [lambda_a, lambda_b].contains(&Lambda::Exact) { shape_within(&outline.angles) } else { shape };
    shape.a = match lambda_a {
        Lambda::Given(lambda) => shape.a * (1.0 - lambda), // Eq. (14a)
        Lambda::Exact => exact.a,
    };
    shape.b = match lambda_b {
        Lambda::Given(lambda) => shape.b * (1.0 + lambda), // Eq. (14b), with r for π (erratum 8)
        Lambda::Exact => exact.b,
    };
    shape
}

/// dA/dθ1, dB/dθ1 and dH/dθ1 (1/rad) of that shape as the wheel sinks: A grows as √z, B as z.
#[inline(always)]
pub(super) fn shape_changes<F: Number>(
    outline: &Outline<F>,
    shape: &ShapeIntegrals<F>,
    lambdas: [Lambda; 2],
    rates: &AngleRates<F>,
) -> ShapeIntegrals<F> {
    let deepening = outline.deepening(); // d ln z/dθ1
    let mut changes = ShapeIntegrals { a: shape.a * deepening * 0.5, b: shape.b * deepening, h: shape.h.like(0.5) };
    if lambdas.contains(&Lambda::Exact) {
        let exact = shape::shape_changes(&outline.angles, rates);
        changes.a = if lambdas[0] == Lambda::Exact { exact.a } else { changes.a };
        changes.b = if lambdas[1] == Lambda::Exact { exact.b } else { changes.b };
    }
    changes
}

#[cfg(test)]
mod tests {
    use crate::contact::Contact;
    use crate::forces::{ForceModel, Lambda, Method, PeakDepth};
    use crate::pressure_sinkage::{Direct, PressureSinkage, SinkageExponent};
    use crate::rolling::WheelOnSoil;
    use crate::shear::{JanosiHanamoto, ShearLaw};
    use crate::slip::Slip;
    use crate::soil::{Soil, SoilParams};
    use crate::wheel::{Wheel, WheelParams};

    /// Rounding of some ten operations and a power.
    const ROUNDING: f64 = 1e-13;

    /// Eqs. (15)–(17) as the head of this file has them, term by term.
    #[test]
    fn the_forces_are_the_explicit_formulas() {
        let (r, b, h, lambda_s): (f64, f64, f64, f64) = (0.2, 0.1, 0.02, 0.5);
        let (c, phi, modulus): (f64, f64, f64) = (300.0, 0.478, 0.015);
        let (k_s, n0, n1): (f64, f64, f64) = (7.5e5, 0.91, 0.3);
        let (lambda_a, lambda_b): (f64, f64) = (0.05, -0.02);
        let exponent = SinkageExponent { base: n0, slip_gain: n1, skid_gain: None };
        let system = WheelOnSoil {
            wheel: Wheel::new(WheelParams { radius: r, width: b, lug_height: h, lug_coefficient: lambda_s }).expect("a wheel"),
            soil: Soil::new(SoilParams {
                cohesion: c,
                friction_angle: phi,
                shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus })),
                pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s, exponent })),
                ..SoilParams::BARE
            })
            .expect("a soil"),
            contact: Contact::MIDPOINT,
        };
        let method = Method::Explicit {
            peak_depth: PeakDepth::Half,
            lambda_a: Lambda::Given(lambda_a),
            lambda_b: Lambda::Given(lambda_b),
        };
        for (s, z) in [(0.0_f64, 0.02_f64), (0.3, 0.005), (0.8, 0.12), (-0.2, 0.03)] {
            let rolling = system.rolling(Slip::new(s).expect("a slip")).expect("a rolling wheel");
            let patch = rolling.contact(z).expect("a contact");
            let forces = ForceModel::at_rim(method).forces(&patch).expect("forces");
            let (r_s, n, e, tan) = (r + lambda_s * h, n0 + n1 * s, patch.peak_mobilisation(), phi.tan());
            let half = z / 2.0;
            let pull = -(1.0 + lambda_b) * b * k_s * half.powf(n + 1.0)
                + r_s / r.sqrt() * (1.0 - lambda_a) * b * e * (k_s * tan * half.powf(n + 0.5) + c * half.sqrt()); // Eq. (15)
            let normal = r.sqrt() * (1.0 - lambda_a) * b * k_s * half.powf(n + 0.5)
                + r_s / r * (1.0 + lambda_b) * b * e * (k_s * tan * half.powf(n + 1.0) + c * half); // Eq. (16)
            let torque = 0.5 * r_s * r_s * b * e * (1.0 - z / r).acos() * (c + half.powf(n) * k_s * tan); // Eq. (17)
            assert!((forces.longitudinal - pull).abs() <= ROUNDING * forces.longitudinal_scale(), "{s}, {z}: {pull}");
            assert!((forces.normal - normal).abs() <= ROUNDING * forces.normal_scale(), "{s}, {z}: {normal}");
            assert!((forces.torque - torque).abs() <= ROUNDING * torque.abs(), "{s}, {z}: {torque}");
        }
    }
}
