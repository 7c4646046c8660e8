//! Identities and numbers that can be had without this crate: by hand, from the letter, or from other programs.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, contact, forces, letter, slip, system};
use terramechanics::{
    Angles, Circles, Contact, ForceModel, Forces, Lambda, Method, Operation, Outcome, PeakDepth, PeakRule, ShapeIntegrals,
    Sinkage, SlipSinkage, StressProfile, WheelOnSoil, WheelParams, WongReece, cautions,
};

/// ∫ f over [from, to] by Simpson's rule, whose error here is far below the tolerances: an independent rule on purpose.
fn simpson(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let steps = 4000;
    let h = (to - from) / f64::from(steps);
    let inner: f64 = (1..steps).map(|i| f(from + h * f64::from(i)) * if i % 2 == 1 { 4.0 } else { 2.0 }).sum();
    (f(from) + inner + f(to)) * h / 3.0
}

#[test]
fn shape_integrals_are_the_integrals_of_the_triangle() {
    for (depth_ratio, rule, exit_ratio) in [
        (0.1, PeakRule::Midpoint, 0.0),
        (0.6, PeakRule::Midpoint, -0.4),
        (1.0, PeakRule::HalfSinkage, 0.1),
        (0.3, PeakRule::WongReece(WongReece { c1: 0.4, c2: 0.1 }), -0.9),
    ] {
        let angles = contact(rule, exit_ratio).angles(depth_ratio, slip(0.3)).expect("a contact");
        let Angles { entry, peak, exit } = angles;
        let rise = |theta: f64| (theta - exit) / (peak - exit);
        let fall = |theta: f64| (entry - theta) / (entry - peak);
        let integral = |g: fn(f64) -> f64| simpson(|t| rise(t) * g(t), exit, peak) + simpson(|t| fall(t) * g(t), peak, entry);
        let shape = ShapeIntegrals::of(&angles);
        for (computed, reference) in [(shape.a, integral(f64::cos)), (shape.b, integral(f64::sin)), (shape.h, integral(|_| 1.0))]
        {
            assert!((computed - reference).abs() <= 1e-10 * shape.h, "{computed} {reference}");
        }
    }
}

/// At z/r = 0.1: θ1 = 0.451027, A = 0.218873, B = 0.050213; and for small z/r at the midpoint λ_A → (5/24) z/r, λ_B → (1/24) z/r.
#[test]
fn exact_lambdas_are_those_of_geometry() {
    let lambdas = |depth_ratio: f64| {
        let angles = Contact::MIDPOINT.angles(depth_ratio, slip(0.0)).expect("a contact");
        let ShapeIntegrals { a, b, .. } = ShapeIntegrals::of(&angles);
        (1.0 - a / (0.5 * depth_ratio).sqrt(), b / (0.5 * depth_ratio) - 1.0)
    };
    let (lambda_a, lambda_b) = lambdas(0.1);
    assert!((lambda_a - (1.0 - 0.218_873 / 0.05f64.sqrt())).abs() < 3e-6);
    assert!((lambda_b - (0.050_213 / 0.05 - 1.0)).abs() < 2e-5);
    for depth_ratio in [1e-3, 1e-4] {
        let (lambda_a, lambda_b) = lambdas(depth_ratio);
        assert!((lambda_a / (5.0 / 24.0 * depth_ratio) - 1.0).abs() < depth_ratio, "{lambda_a}");
        assert!((lambda_b / (1.0 / 24.0 * depth_ratio) - 1.0).abs() < 2.0 * depth_ratio, "{lambda_b}");
    }
}

#[test]
fn shear_starts_at_the_entry_and_stresses_are_continuous_at_the_peak() {
    for (ratio, exit_ratio) in [(0.2, 0.0), (1.0, -0.3), (-0.3, 0.0), (0.0, 0.05)] {
        let system = system(LETTER_WHEEL, LETTER_SOIL, contact(PeakRule::Midpoint, exit_ratio));
        let rolling = system.rolling(slip(ratio)).expect("a rolling wheel");
        let patch = rolling.contact(0.03).expect("a contact");
        let Angles { entry, peak, exit } = patch.angles;
        let stresses = patch.stresses().expect("a law");
        assert_eq!((patch.shear_displacement(entry), stresses.shear(entry), stresses.normal(entry)), (0.0, 0.0, 0.0));
        assert_eq!(stresses.normal(exit), 0.0);
        let (before, after) = (stresses.at(peak - 1e-13), stresses.at(peak));
        assert!((before.normal / after.normal - 1.0).abs() < 1e-11 && (before.shear / after.shear - 1.0).abs() < 1e-10);
        // The front half has the depth of the rim below the surface, at the peak as well; the rear half mirrors it.
        let below = |theta: f64| 0.2 * (theta.cos() - entry.cos());
        assert!((patch.depth(peak) - below(peak)).abs() < 1e-15 && (below(0.0) - 0.03).abs() < 1e-15, "{ratio}");
        let mirrored = entry - (0.5 * (peak + exit) - exit) * (entry - peak) / (peak - exit); // Eq. (4), half way
        assert!((patch.depth(0.5 * (peak + exit)) - below(mirrored)).abs() < 1e-15, "{ratio}");
    }
}

#[test]
fn forces_grow_with_sinkage_and_traction_with_slip() {
    let system = letter();
    for pair in [0.001, 0.005, 0.02, 0.05, 0.1, 0.15, 0.2].windows(2) {
        assert!(
            forces(&system, 0.2, pair[0], Method::Quadrature).normal < forces(&system, 0.2, pair[1], Method::Quadrature).normal
        );
    }
    for pair in [0.0, 0.05, 0.1, 0.3, 0.6, 1.0].windows(2) {
        let at = |ratio| forces(&system, ratio, 0.02, Method::Quadrature).longitudinal;
        assert!(at(pair[0]) < at(pair[1]));
    }
}

#[test]
fn lyasko_at_sixty_percent_is_sixteen_sevenths() {
    let sinkage = |ratio| SlipSinkage::Lyasko.sinkage(0.01, slip(ratio));
    assert!((sinkage(0.6) - 0.022_857).abs() < 5e-7);
    assert_eq!((sinkage(0.0), sinkage(1.0), sinkage(-1.0)), (0.01, 0.04, 0.0));
}

/// The letter's wheel and soil, smooth, exit at the lowest point, peak at the midpoint, by a program independent of this one
/// (401 000 points): sinkage in mm, slip, then F_x, F_z [N] and T [N·m] by quadrature, linearised, explicit.
const LETTER_TABLE: [(f64, f64, [[f64; 3]; 3]); 12] = [
    (5.0, 0.05, [[0.147, 12.030, 0.2985], [0.169, 10.448, 0.2676], [0.123, 7.269, 0.1852]]),
    (5.0, 0.20, [[2.233, 12.240, 0.7183], [2.111, 10.667, 0.6587], [1.473, 7.420, 0.4559]]),
    (5.0, 0.50, [[3.824, 12.425, 1.0390], [3.628, 10.837, 0.9643], [2.529, 7.538, 0.6674]]),
    (10.0, 0.05, [[1.031, 32.203, 1.2247], [1.138, 28.076, 1.1149], [0.835, 19.649, 0.7724]]),
    (10.0, 0.20, [[6.546, 33.025, 2.3421], [6.325, 28.907, 2.1678], [4.467, 20.223, 1.5018]]),
    (10.0, 0.50, [[9.734, 33.601, 2.9912], [9.199, 29.367, 2.7510], [6.478, 20.541, 1.9058]]),
    (20.0, 0.05, [[5.911, 87.205, 5.0744], [6.354, 76.564, 4.6825], [4.800, 54.202, 3.2503]]),
    (20.0, 0.20, [[16.906, 89.716, 7.3396], [16.611, 78.917, 6.7962], [12.074, 55.829, 4.7175]]),
    (20.0, 0.50, [[21.748, 91.117, 8.3513], [20.284, 79.760, 7.5530], [14.678, 56.411, 5.2429]]),
    (40.0, 0.05, [[20.949, 240.127, 19.3325], [22.235, 212.529, 17.8135], [18.495, 153.756, 12.4162]]),
    (40.0, 0.20, [[32.442, 244.486, 21.8128], [31.941, 215.765, 19.8775], [25.565, 155.991, 13.8549]]),
    (40.0, 0.50, [[36.956, 246.728, 22.8264], [34.032, 216.461, 20.3220], [27.088, 156.473, 14.1647]]),
];

#[test]
fn the_letters_example_is_what_another_program_gives() {
    // Half a unit of the last printed digit.
    let tolerances = [5e-4 + 1e-9, 5e-4 + 1e-9, 5e-5 + 1e-9];
    for (sinkage, ratio, rows) in LETTER_TABLE {
        for (method, row) in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT].into_iter().zip(rows) {
            let Forces { longitudinal, normal, torque, .. } = forces(&letter(), ratio, sinkage * 1e-3, method);
            for ((computed, printed), tolerance) in [longitudinal, normal, torque].into_iter().zip(row).zip(tolerances) {
                assert!((computed - printed).abs() <= tolerance, "{sinkage} mm, {ratio}, {method:?}: {computed}, not {printed}");
            }
        }
    }
}

/// What the simplifications cost on the letter's wheel and sand, over the sinkages of the table above: 11–13 % of F_z by
/// linearising, 34–40 % by the explicit form at the midpoint, 3–9 % with the half-sinkage rule.
#[test]
fn the_gap_between_closed_forms_and_integral_is_the_stated_one() {
    for (sinkage, ratio, _) in LETTER_TABLE {
        let loss = |rule: PeakRule, method: Method| {
            let system = system(LETTER_WHEEL, LETTER_SOIL, contact(rule, 0.0));
            let normal = |method: Method| forces(&system, ratio, sinkage * 1e-3, method).normal;
            1.0 - normal(method) / normal(Method::Quadrature)
        };
        assert!((0.11..0.135).contains(&loss(PeakRule::Midpoint, Method::LINEARISED)), "{sinkage} mm, {ratio}");
        assert!((0.34..0.405).contains(&loss(PeakRule::Midpoint, Method::EXPLICIT)), "{sinkage} mm, {ratio}");
        assert!((0.025..0.095).contains(&loss(PeakRule::HalfSinkage, Method::EXPLICIT)), "{sinkage} mm, {ratio}");
    }
}

/// Eqs. (15) and (16) written out term by term as in the letter, with the errata's corrections, against the method.
#[test]
fn the_explicit_method_is_equations_15_to_17() {
    let wheel = WheelParams { lug_height: 0.012, ..LETTER_WHEEL };
    let soil = terramechanics::SoilParams { cohesion: 300.0, ..LETTER_SOIL };
    let (z, lambda_a, lambda_b) = (0.02_f64, 0.03, 0.01);
    let method =
        Method::Explicit { peak_depth: PeakDepth::Half, lambda_a: Lambda::Given(lambda_a), lambda_b: Lambda::Given(lambda_b) };
    let computed = forces(&system(wheel, soil, Contact::MIDPOINT.with_circles(Circles::RIM)), 0.3, z, method);
    let (r, b, r_s) = (0.2_f64, 0.1, 0.206);
    let (k_s, n, c, tan_phi) = (-660.0 / b + 754_130.0, 0.91, 300.0, 0.478_f64.tan());
    let theta_1 = (1.0 - z / r).acos();
    let theta_m = 0.5 * theta_1;
    let e = 1.0 - (-(r / 0.005) * (theta_1 - theta_m - 0.7 * (theta_1.sin() - theta_m.sin()))).exp();
    let h = 0.5 * z;
    let f_x = -(1.0 + lambda_b) * b * k_s * h.powf(n + 1.0)
        + r_s / r.sqrt() * (1.0 - lambda_a) * b * e * k_s * tan_phi * h.powf(n + 0.5)
        + r_s / r.sqrt() * (1.0 - lambda_a) * b * e * c * h.sqrt();
    let f_z = r_s / r * (1.0 + lambda_b) * b * e * k_s * tan_phi * h.powf(n + 1.0)
        + r.sqrt() * (1.0 - lambda_a) * b * k_s * h.powf(n + 0.5)
        + r_s / r * (1.0 + lambda_b) * b * e * c * h;
    let torque = 0.5 * r_s * r_s * b * e * theta_1 * (c + h.powf(n) * k_s * tan_phi);
    assert!((computed.longitudinal / f_x - 1.0).abs() < 1e-12);
    assert!((computed.normal / f_z - 1.0).abs() < 1e-12);
    assert!((computed.torque / torque - 1.0).abs() < 1e-12);
}

#[test]
fn a_profile_rises_from_exit_to_entry_through_the_peak() {
    let system = system(LETTER_WHEEL, LETTER_SOIL, contact(PeakRule::WongReece(WongReece { c1: 0.4, c2: 0.1 }), -0.2));
    let rolling = system.rolling(slip(0.2)).expect("a rolling wheel");
    let patch = rolling.contact(0.02).expect("a contact");
    for points in [3, 4, 5, 50, 201, 10_001] {
        let stresses = patch.stresses().expect("a law");
        let profile = StressProfile::of(&stresses, points, PeakDepth::Geometric);
        assert_eq!(profile.len(), points);
        assert!(profile.theta.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!((profile.theta[0], profile.theta[points - 1]), (patch.angles.exit, patch.angles.entry));
        let peak = profile.theta.iter().position(|&theta| theta == patch.angles.peak).expect("the peak is a point");
        assert_eq!(profile.normal[peak], profile.normal_linear[peak]);
        assert_eq!(profile.shear[peak], profile.shear_linear[peak]);
        assert_eq!((profile.normal[0], profile.normal[points - 1], profile.shear[points - 1]), (0.0, 0.0, 0.0));
        for (i, &theta) in profile.theta.iter().enumerate() {
            assert_eq!(profile.normal[i], stresses.normal(theta));
        }
    }
}

/// What is not known of the lugs changes no number, only what a result says of itself.
#[test]
fn a_wheel_of_unknown_lug_height_has_the_same_forces_and_says_so() {
    let known = letter();
    let unknown = WheelOnSoil { wheel: known.wheel.with_unknown_lug_height(), ..known };
    let codes = |system: WheelOnSoil| {
        let operation = Operation { system, model: ForceModel::at_rim(Method::Quadrature), sinkage: Sinkage::Given(0.02) };
        let outcome = Outcome {
            slip: slip(0.2),
            sinkage: 0.02,
            normal: None,
            standstill_normal: None,
            found_curve: None,
            integration_error: 0.0,
            mobilised_share: None,
        };
        cautions(&operation, &outcome).map(|caution| caution.kind.code).collect::<Vec<_>>()
    };
    assert_eq!(forces(&known, 0.2, 0.02, Method::Quadrature), forces(&unknown, 0.2, 0.02, Method::Quadrature));
    assert_eq!((codes(known), codes(unknown)), (vec!["small_wheel"], vec!["small_wheel", "lug_height_assumed"]));
}
