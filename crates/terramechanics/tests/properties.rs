//! Properties that hold for every wheel and soil, exactly or to rounding.

mod common;

use common::{contact, slip, system};
use proptest::prelude::*;
use terramechanics::{
    Bekker, Contact, Direct, ForceModel, Forces, JanosiHanamoto, Lambda, Method, PeakDepth, PeakRule, PressureSinkage, ShearLaw,
    SinkageExponent, SoilParams, StressProfile, WheelOnSoil, WheelParams, WongReece,
};

/// Some tens of roundings.
const ROUNDING: f64 = 1e-12;
/// What the quadrature promises.
const QUADRATURE: f64 = 1e-10;
/// Share of the parts of the normal force below which a load is lost among them: the sinkage is solved to 1e-13, which changes steep
/// parts by some ten times as much, and that is a millionth of such a load.
const NOTHING: f64 = 1e-5;

const METHODS: [Method; 3] = [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT];

#[derive(Debug, Clone, Copy)]
struct Case {
    wheel: WheelParams,
    soil: SoilParams,
    contact: Contact,
    depth_ratio: f64,
}

impl Case {
    fn system(&self) -> WheelOnSoil {
        system(self.wheel, self.soil, self.contact)
    }

    fn sinkage(&self) -> f64 {
        self.depth_ratio * self.wheel.radius
    }
}

fn rules() -> impl Strategy<Value = PeakRule> {
    prop_oneof![
        Just(PeakRule::Midpoint),
        (0.35..0.55, -0.1..0.2).prop_map(|(c1, c2)| PeakRule::WongReece(WongReece { c1, c2 })),
        Just(PeakRule::HalfSinkage),
    ]
}

prop_compose! {
    fn wheels()(radius in 0.03..0.7, width in 0.03..0.6, lugs in prop_oneof![Just(0.0), 0.001..0.03], lug_coefficient in 0.0..=1.0)
        -> WheelParams {
        WheelParams { radius, width, lug_height: lugs, lug_coefficient }
    }
}

prop_compose! {
    fn soils()(
        cohesion in prop_oneof![Just(0.0), 10.0..20_000.0],
        friction_angle in 0.0..1.0,
        log_shear_modulus in -3.3..-1.0,
        log_modulus in 4.0..7.0,
        least_exponent in 0.1..1.8,
        slip_gain in prop_oneof![Just(0.0), 0.0..0.7],
    ) -> SoilParams {
        let exponent = SinkageExponent { base: least_exponent + slip_gain, slip_gain, skid_gain: None }; // N > 0 down to s = −1
        let pressure_sinkage = PressureSinkage::Direct(Direct { k_s: 10f64.powf(log_modulus), exponent });
        let shear = ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 10f64.powf(log_shear_modulus) });
        SoilParams { cohesion, friction_angle, shear: Some(shear), pressure_sinkage: Some(pressure_sinkage), ..SoilParams::BARE }
    }
}

prop_compose! {
    fn cases(exit: std::ops::RangeInclusive<f64>)
        (wheel in wheels(), soil in soils(), rule in rules(), exit_ratio in exit, log_depth in -5.0..0.0) -> Case {
        Case { wheel, soil, contact: contact(rule, exit_ratio), depth_ratio: 10f64.powf(log_depth) }
    }
}

fn find(system: &WheelOnSoil, ratio: f64, sinkage: f64, method: Method) -> Forces {
    common::forces(system, ratio, sinkage, method)
}

/// Largest difference relative to the scales on which the forces are accurate.
fn difference(a: &Forces, b: &Forces) -> f64 {
    let torque_scale = a.torque.abs().max(b.torque.abs()).max(f64::MIN_POSITIVE);
    ((a.longitudinal - b.longitudinal).abs() / a.longitudinal_scale().max(f64::MIN_POSITIVE))
        .max((a.normal - b.normal).abs() / a.normal_scale())
        .max((a.torque - b.torque).abs() / torque_scale)
}

/// Forces times a factor.
fn scaled(forces: &Forces, factor: f64) -> Forces {
    let mut scaled = *forces;
    for value in [
        &mut scaled.longitudinal,
        &mut scaled.normal,
        &mut scaled.torque,
        &mut scaled.components.traction,
        &mut scaled.components.resistance,
        &mut scaled.components.normal_support,
        &mut scaled.components.shear_support,
    ] {
        *value *= factor;
    }
    scaled
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn mobilised_strength_lies_between_zero_and_one_while_driving(case in cases(-0.9..=0.1), ratio in 0.0..=1.0, share in 0.0..1.0) {
        let system = case.system();
        let rolling = system.rolling(slip(ratio)).expect("a rolling wheel");
        let patch = rolling.contact(case.sinkage()).expect("a contact");
        let theta = patch.angles.exit + share * (patch.angles.entry - patch.angles.exit);
        prop_assert!(patch.shear_displacement(theta) >= 0.0);
        let stresses = patch.stresses().expect("a law");
        let strength = case.soil.cohesion + stresses.normal(theta) * case.soil.friction_angle.tan();
        let shear = stresses.shear(theta);
        prop_assert!((0.0..=strength * (1.0 + ROUNDING)).contains(&shear), "{shear} of {strength}");
    }

    #[test]
    fn linearised_at_half_sinkage_is_explicit_with_exact_lambdas(case in cases(0.0..=0.0), ratio in -0.9..=1.0) {
        let linearised = Method::Linearised { peak_depth: PeakDepth::Half };
        let explicit =
            Method::Explicit { peak_depth: PeakDepth::Half, lambda_a: Lambda::Exact, lambda_b: Lambda::Exact };
        let system = case.system();
        let (a, b) = (find(&system, ratio, case.sinkage(), linearised), find(&system, ratio, case.sinkage(), explicit));
        prop_assert!(difference(&a, &b) <= ROUNDING);
    }

    #[test]
    fn without_cohesion_everything_scales_with_the_modulus(case in cases(-0.5..=0.1), ratio in -0.9..=1.0, factor in 0.1..10.0) {
        let soil = SoilParams { cohesion: 0.0, ..case.soil };
        let Some(PressureSinkage::Direct(law)) = soil.pressure_sinkage else { unreachable!("cases have a direct law") };
        let firmer = SoilParams { pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: factor * law.k_s, ..law })), ..soil };
        for method in METHODS {
            let a = find(&system(case.wheel, soil, case.contact), ratio, case.sinkage(), method);
            let b = find(&system(case.wheel, firmer, case.contact), ratio, case.sinkage(), method);
            prop_assert!(difference(&scaled(&a, factor), &b) <= ROUNDING, "{method:?}");
        }
    }

    #[test]
    fn everything_scales_with_the_width_if_the_modulus_does_not_depend_on_it(case in cases(-0.5..=0.1), ratio in -0.9..=1.0, factor in 0.1..10.0) {
        let wider = WheelParams { width: factor * case.wheel.width, ..case.wheel };
        for method in METHODS {
            let a = find(&case.system(), ratio, case.sinkage(), method);
            let b = find(&system(wider, case.soil, case.contact), ratio, case.sinkage(), method);
            prop_assert!(difference(&scaled(&a, factor), &b) <= ROUNDING, "{method:?}");
        }
    }

    #[test]
    fn the_four_parts_add_up(case in cases(-0.9..=0.1), ratio in -1.0..=1.0) {
        for method in METHODS {
            let forces = find(&case.system(), ratio, case.sinkage(), method);
            prop_assert_eq!(forces.longitudinal, forces.components.traction - forces.components.resistance);
            prop_assert_eq!(forces.normal, forces.components.normal_support + forces.components.shear_support);
        }
    }

    /// The rule of the quadrature is exercised through a profile: the linear stresses of a fine one, summed by trapezia,
    /// which are exact for the area and good to the square of the spacing for the rest.
    #[test]
    fn integrals_of_the_linear_stresses_are_the_linearised_forces(case in cases(-0.5..=0.1), ratio in 0.01..=1.0) {
        let system = case.system();
        let rolling = system.rolling(slip(ratio)).expect("a rolling wheel");
        let patch = rolling.contact(case.sinkage()).expect("a contact");
        let profile = StressProfile::of(&patch.stresses().expect("a law"), 4001, PeakDepth::Geometric);
        let mut sums = [0.0; 5];
        for i in 1..profile.len() {
            let step = profile.theta[i] - profile.theta[i - 1];
            for k in [i - 1, i] {
                let (theta, sigma, tau) = (profile.theta[k], profile.normal_linear[k], profile.shear_linear[k]);
                for (sum, value) in sums.iter_mut().zip([sigma * theta.cos(), sigma * theta.sin(), tau * theta.cos(), tau * theta.sin(), tau]) {
                    *sum += 0.5 * step * value;
                }
            }
        }
        let (r, b, r_s) = (case.wheel.radius, case.wheel.width, system.wheel.shearing_radius());
        let forces = ForceModel::at_rim(Method::LINEARISED).forces(&patch).expect("forces");
        let parts = forces.components;
        let span = patch.angles.entry - patch.angles.exit;
        let trapezia = span * span / (4000.0f64 * 4000.0); // relative error of the sums
        prop_assert!((r * b * sums[0] - parts.normal_support).abs() <= trapezia * forces.normal_scale());
        prop_assert!((r * b * sums[1] - parts.resistance).abs() <= trapezia * forces.normal_scale());
        prop_assert!((r_s * b * sums[2] - parts.traction).abs() <= trapezia * parts.traction.abs());
        prop_assert!((r_s * b * sums[3] - parts.shear_support).abs() <= trapezia * parts.traction.abs());
        prop_assert!((r_s * r_s * b * sums[4] - forces.torque).abs() <= ROUNDING * forces.torque.abs());
    }

    #[test]
    fn normal_force_grows_with_sinkage_on_a_driving_wheel(case in cases(0.0..=0.0), ratio in 0.0..=1.0, factor in 1.0001..1.5f64) {
        let system = case.system();
        let deeper = (case.sinkage() * factor).min(case.wheel.radius);
        prop_assume!(deeper > case.sinkage());
        let a = find(&system, ratio, case.sinkage(), Method::Quadrature).normal;
        let b = find(&system, ratio, deeper, Method::Quadrature).normal;
        prop_assert!(b > a, "{a} at {} and {b} at {deeper}", case.sinkage());
    }

    #[test]
    fn forces_are_continuous_at_zero_slip(case in cases(-0.5..=0.1)) {
        let system = case.system();
        let step = 1e-12;
        // |dE/ds| ≤ r (θ1 − θ2)/K and |dσ/ds| ≤ n1 |ln z| σ ≤ 12 σ, on a stress of at most c + σ (1 + tan φ).
        let at_rest = system.rolling(slip(0.0)).expect("a rolling wheel");
        let patch = at_rest.contact(case.sinkage()).expect("a contact");
        let span = patch.angles.entry - patch.angles.exit;
        let largest_normal = at_rest.curve().expect("a law").pressure(case.sinkage());
        let stress = case.soil.cohesion + largest_normal * (1.0 + case.soil.friction_angle.tan());
        let force = stress * span * system.wheel.shearing_radius() * case.wheel.width;
        let Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus })) = case.soil.shear else { unreachable!("cases have that law") };
        let change = 2.0 * step * (case.wheel.radius * span / modulus + 12.0) * force;
        for method in METHODS {
            let rolling = find(&system, 0.0, case.sinkage(), method);
            for ratio in [-step, step] {
                let near = find(&system, ratio, case.sinkage(), method);
                for (a, b, scale) in [
                    (near.normal, rolling.normal, rolling.normal_scale()),
                    (near.longitudinal, rolling.longitudinal, rolling.longitudinal_scale()),
                    (near.torque / case.wheel.radius, rolling.torque / case.wheel.radius, rolling.longitudinal_scale()),
                ] {
                    prop_assert!((a - b).abs() <= change + QUADRATURE * scale, "{method:?}: {a} and {b}");
                }
            }
        }
    }

    #[test]
    fn a_solved_sinkage_carries_its_load(case in cases(-0.3..=0.0), ratio in 0.0..=1.0) {
        let system = case.system();
        let rolling = system.rolling(slip(ratio)).expect("a rolling wheel");
        for method in METHODS {
            let load = find(&system, ratio, case.sinkage(), method).normal;
            let carried = ForceModel::at_rim(method).solve_sinkage(&rolling, load).expect("a load that was just carried");
            prop_assert!((carried.forces.normal / load - 1.0).abs() <= 1e-11);
            prop_assert!(carried.iterations <= 20, "{} evaluations", carried.iterations);
        }
    }

    #[test]
    fn every_load_has_an_answer_or_a_reason(case in cases(-1.0..=0.2), ratio in -1.0..=1.0, log_load in -6.0..7.0) {
        let system = case.system();
        if let Ok(rolling) = system.rolling(slip(ratio)) {
            let load = 10f64.powf(log_load);
            for method in METHODS {
                match ForceModel::at_rim(method).solve_sinkage(&rolling, load) {
                    Ok(carried) => {
                        prop_assert!(carried.sinkage > 0.0 && carried.sinkage <= case.wheel.radius);
                        prop_assert!(carried.residual.abs() <= 1e-9 * carried.forces.normal_scale());
                    }
                    Err(terramechanics::Error::LoadBeyondCapacity { largest, .. }) => prop_assert!(largest < load),
                    Err(terramechanics::Error::PeakOutsideContact { .. }) => {}
                    // A load that is nothing beside the parts of the normal force is less than what is known of these; the cohesion,
                    // which supports in one place and pulls down in another, is such a part.
                    Err(terramechanics::Error::LoadNotBalanced { sinkage, .. }) => {
                        let cohesion = case.soil.cohesion * case.wheel.width * case.wheel.radius;
                        let parts = find(&system, ratio, sinkage, method).normal_scale() + cohesion;
                        prop_assert!(load <= NOTHING * parts, "{load} N beside {parts} N");
                    }
                    Err(other) => prop_assert!(false, "{other}"),
                }
            }
        }
    }

    /// Bekker's law with k_c = 0 is the direct law with K_s = k_phi: laws differ in their modulus only.
    #[test]
    fn bekker_without_cohesive_modulus_is_the_direct_law(case in cases(-0.5..=0.1), ratio in -0.9..=1.0) {
        let Some(PressureSinkage::Direct(Direct { k_s, exponent })) = case.soil.pressure_sinkage else { unreachable!("cases have a direct law") };
        let bekker = SoilParams { pressure_sinkage: Some(PressureSinkage::Bekker(Bekker { k_c: 0.0, k_phi: k_s, exponent })), ..case.soil };
        let a = find(&case.system(), ratio, case.sinkage(), Method::Quadrature);
        let b = find(&system(case.wheel, bekker, case.contact), ratio, case.sinkage(), Method::Quadrature);
        prop_assert_eq!(a, b);
    }
}
