//! Plate tests and shear tests: recovery, a published set of plates, and what cannot be told.

mod common;

use common::Noise;
use terramechanics_identification::{
    Bound, Identifiability, PlateCurve, PlatesError, ShearCurve, ShearError, fit_plates, fit_shear_curves,
};

/// Noise-free recovery of the plates: closed form, so rounding alone.
const PLATES: f64 = 1e-10;

/// Tolerance for shear tests: the minimum of a smooth function of K is found to the square root of rounding.
const SHEAR: f64 = 1e-6;

fn plate(width: f64, k_c: f64, k_phi: f64, n: f64) -> PlateCurve {
    let sinkage: Vec<f64> = (1..=12).map(|i| 0.003 * f64::from(i)).collect();
    let pressure = sinkage.iter().map(|z| (k_c / width + k_phi) * z.powf(n)).collect();
    PlateCurve { width, sinkage, pressure }
}

#[test]
fn bekkers_parameters_come_back_from_two_plates_and_from_more() {
    for widths in [vec![0.05, 0.1], vec![0.03, 0.06, 0.1, 0.15]] {
        for (k_c, k_phi, n) in [(1400.0, 820_000.0, 1.0), (-660.0, 754_130.0, 0.91), (0.0, 2e6, 1.4)] {
            let fit = fit_plates(&widths.iter().map(|&b| plate(b, k_c, k_phi, n)).collect::<Vec<_>>()).expect("a fit");
            let [found_c, found_phi, found_n] = fit.estimates.each_ref().map(|estimate| estimate.value);
            assert!((found_c - k_c).abs() < PLATES * k_phi && (found_phi / k_phi - 1.0).abs() < PLATES, "{fit:?}");
            assert!((found_n - n).abs() < PLATES && fit.rmse < 1e-6);
            assert!(fit.plates.iter().all(|plate| (plate.own_exponent.expect("an exponent") - n).abs() < PLATES));
        }
    }
}

/// An error of p at the shallow end, which plain logarithms would follow, hardly matters with the weights p².
#[test]
fn the_deep_end_of_a_curve_counts() {
    let mut curves = [plate(0.05, 1400.0, 820_000.0, 1.0), plate(0.1, 1400.0, 820_000.0, 1.0)];
    curves[0].pressure[0] *= 1.5;
    let fit = fit_plates(&curves).expect("a fit");
    // The common slope without weights.
    let (mut spread, mut product) = (0.0, 0.0);
    for curve in &curves {
        let mean = |values: &[f64]| values.iter().map(|value| value.ln()).sum::<f64>() / values.len() as f64;
        let (depth, pressure) = (mean(&curve.sinkage), mean(&curve.pressure));
        for (z, p) in curve.sinkage.iter().zip(&curve.pressure) {
            spread += (z.ln() - depth).powi(2);
            product += (z.ln() - depth) * (p.ln() - pressure);
        }
    }
    let (weighted, plain) = ((fit.estimates[2].value - 1.0).abs(), (product / spread - 1.0).abs());
    assert!(weighted < 0.02 && weighted < 0.5 * plain, "{weighted} against {plain}");
}

/// Static plate tests on dry sand (Yoshida et al. 2003, Annual Conference of the Robotics Society of Japan, paper 3G12; read
/// from the vectors of its figure): width (m), pressure (Pa) and sinkage (mm). The wider plate is the stiffer one at a given
/// sinkage, the opposite of a cohesive soil, and the fit says so by a negative k_c.
#[test]
fn plates_on_dry_sand_give_a_negative_cohesive_modulus() {
    let curve = |width: f64, points: [(f64, f64); 8]| PlateCurve {
        width,
        pressure: points.iter().map(|(pressure, _)| *pressure).collect(),
        sinkage: points.iter().map(|(_, millimetres)| 1e-3 * millimetres).collect(),
    };
    let narrow = [
        (247.0, 0.71),
        (342.0, 1.017),
        (438.0, 1.116),
        (629.0, 1.522),
        (885.0, 1.829),
        (1100.0, 2.134),
        (1291.0, 2.538),
        (1461.0, 2.639),
    ];
    let wide = [
        (469.0, 0.813),
        (684.0, 0.914),
        (974.0, 1.219),
        (1371.0, 1.421),
        (1744.0, 1.93),
        (2096.0, 2.233),
        (2465.0, 2.538),
        (2826.0, 3.045),
    ];
    let fit = fit_plates(&[curve(0.06, narrow), curve(0.116, wide)]).expect("a fit");
    let [k_c, k_phi, n] = &fit.estimates;
    // By hand from the last points of both curves: p/z is 554 and 928 kPa/m, so (at n = 1) k_c = (554 − 928)/(1/0.06 − 1/0.116).
    let by_hand = -374_000.0 / (1.0 / 0.06 - 1.0 / 0.116);
    assert!(k_c.value < 0.0 && k_phi.value > 0.0, "{fit:?}");
    assert!(n.value > 1.0 && n.value < 1.6, "{n:?}");
    // The same on the scale of the fitted exponent: at 2.6 mm the moduli differ as the curves do.
    let at_depth = k_c.value * 0.002_64_f64.powf(n.value) / 0.002_64;
    assert!((at_depth / by_hand - 1.0).abs() < 0.2, "{at_depth} against {by_hand}");
    assert!(fit.rmse < 120.0, "{}", fit.rmse);
    assert_eq!(n.identifiability, Identifiability::Determined);
}

#[test]
fn plates_that_cannot_tell_are_refused() {
    let one = plate(0.05, 0.0, 1e6, 1.0);
    assert_eq!(fit_plates(std::slice::from_ref(&one)), Err(PlatesError::Count));
    assert_eq!(fit_plates(&[one.clone(), one.clone()]), Err(PlatesError::OneWidth));
    let point = |width: f64| PlateCurve { width, sinkage: vec![0.01; 3], pressure: vec![1e3, 1.1e3, 0.9e3] };
    assert_eq!(fit_plates(&[point(0.05), point(0.1)]), Err(PlatesError::OneSinkage));
    for bad in [-1.0, f64::NAN] {
        let broken = PlateCurve { pressure: vec![bad], sinkage: vec![0.01], width: 0.1 };
        assert_eq!(fit_plates(&[one.clone(), broken]), Err(PlatesError::Curve(1)));
    }
}

/// Shares of 1000 intervals of 95 %: such a share scatters by 0.7 %.
const COVERED: std::ops::RangeInclusive<u32> = 925..=985;

/// Noise of one size, of a size that drowns the shallow end, and noise that grows with the pressure.
#[test]
fn intervals_of_plates_hold_the_truth_whatever_the_noise() {
    type Noisy = fn(f64, &mut Noise) -> f64;
    let kinds: [(&str, Noisy); 4] = [
        ("100 Pa", |p, noise| p + 100.0 * noise.normal()),
        ("600 Pa", |p, noise| (p + 600.0 * noise.normal()).max(0.0)),
        ("3 %", |p, noise| p * (1.0 + 0.03 * noise.normal())),
        ("10 %", |p, noise| p * (1.0 + 0.1 * noise.normal())),
    ];
    for widths in [vec![0.05, 0.1], vec![0.05, 0.1, 0.15]] {
        for (name, noisy) in kinds {
            let mut covered = [0_u32; 3];
            for seed in 0..1000 {
                let mut noise = Noise::seeded(seed + 17);
                let mut plates: Vec<PlateCurve> = widths.iter().map(|&width| plate(width, 1400.0, 820_000.0, 1.0)).collect();
                plates.iter_mut().flat_map(|plate| &mut plate.pressure).for_each(|p| *p = noisy(*p, &mut noise));
                let fit = fit_plates(&plates).expect("a fit");
                for ((estimate, truth), covered) in fit.estimates.iter().zip([1400.0, 820_000.0, 1.0]).zip(&mut covered) {
                    let [low, high] = estimate.interval.expect("an interval");
                    *covered += u32::from((low..=high).contains(&truth));
                }
            }
            assert!(covered.iter().all(|covered| COVERED.contains(covered)), "{name}, {} plates: {covered:?}", widths.len());
        }
    }
}

#[test]
fn intervals_of_shear_tests_hold_the_truth_whatever_the_noise() {
    type Noisy = fn(f64, &mut Noise) -> f64;
    let kinds: [(&str, Noisy); 2] =
        [("60 Pa", |shear, noise| shear + 60.0 * noise.normal()), ("3 %", |shear, noise| shear * (1.0 + 0.03 * noise.normal()))];
    for (name, noisy) in kinds {
        let mut covered = [0_u32; 3];
        for seed in 0..300 {
            let mut noise = Noise::seeded(seed + 17);
            let mut tests = shear_tests(800.0, 0.5, 0.012);
            tests.iter_mut().flat_map(|test| &mut test.shear).for_each(|shear| *shear = noisy(*shear, &mut noise));
            let fit = fit_shear_curves(&tests).expect("a fit");
            assert!(
                fit.estimates.iter().all(|estimate| estimate.identifiability == Identifiability::Determined),
                "{name}: {fit:?}"
            );
            for ((estimate, truth), covered) in fit.estimates.iter().zip([800.0, 0.5, 0.012]).zip(&mut covered) {
                let [low, high] = estimate.interval.expect("an interval");
                *covered += u32::from((low..=high).contains(&truth));
            }
        }
        // The larger of two errors is stated, so more than 95 % may contain the true value.
        assert!(covered.iter().all(|covered| *covered >= 276), "{name}: {covered:?} of 300");
    }
}

/// An interval that holds 0 leaves the sign of k_c open: noise that is many times what k_c does.
#[test]
fn a_cohesive_modulus_of_open_sign_is_not_determined() {
    let mut called = 0;
    for seed in 0..100 {
        let mut noise = Noise::seeded(seed + 3);
        let mut plates = [plate(0.05, 1400.0, 820_000.0, 1.0), plate(0.1, 1400.0, 820_000.0, 1.0)];
        plates.iter_mut().flat_map(|plate| &mut plate.pressure).for_each(|p| *p *= 1.0 + 0.1 * noise.normal());
        let k_c = &fit_plates(&plates).expect("a fit").estimates[0];
        let [low, high] = k_c.interval.expect("an interval");
        assert!(!(k_c.identifiability.is_determined() && low < 0.0 && high > 0.0), "{k_c:?}");
        called += u32::from(k_c.identifiability.is_determined());
    }
    assert!(called <= 12, "by chance an interval leaves 0 out in 5 of 100 cases, where k_c has no effect: {called}");
}

/// A plate that the soil does not yet resist shows 0, which is a pressure like any other.
#[test]
fn a_pressure_of_nothing_is_a_measurement() {
    let mut plates = [plate(0.05, 1400.0, 820_000.0, 1.0), plate(0.1, 1400.0, 820_000.0, 1.0)];
    plates[0].pressure[0] = 0.0;
    let fit = fit_plates(&plates).expect("a fit");
    assert!((fit.estimates[2].value - 1.0).abs() < 0.02, "{fit:?}");
    plates[0].pressure.fill(0.0);
    assert_eq!(fit_plates(&plates), Err(PlatesError::Curve(0)));
}

fn shear_tests(cohesion: f64, friction: f64, modulus: f64) -> Vec<ShearCurve> {
    let displacement: Vec<f64> = (0..30).map(|i| 0.002 * f64::from(i)).collect();
    let test = |normal: f64| ShearCurve {
        normal,
        shear: displacement.iter().map(|j| (cohesion + normal * friction.tan()) * (1.0 - (-j / modulus).exp())).collect(),
        displacement: displacement.clone(),
    };
    [2e3, 5e3, 1.2e4].into_iter().map(test).collect()
}

#[test]
fn strength_and_modulus_come_back_from_shear_tests() {
    for (cohesion, friction, modulus) in [(800.0, 0.5, 0.012), (50.0, 0.7, 0.001), (3000.0, 0.2, 0.04)] {
        let fit = fit_shear_curves(&shear_tests(cohesion, friction, modulus)).expect("a fit");
        let found = fit.estimates.each_ref().map(|estimate| estimate.value);
        for (found, truth) in found.iter().zip([cohesion, friction, modulus]) {
            assert!((found / truth - 1.0).abs() < SHEAR, "{found} instead of {truth}");
        }
        assert!(fit.estimates.iter().all(|estimate| estimate.identifiability == Identifiability::Determined));
    }
}

#[test]
fn dry_sand_has_its_cohesion_at_the_bound() {
    let mut tests = shear_tests(0.0, 0.6, 0.01);
    tests[0].shear.iter_mut().for_each(|shear| *shear *= 0.9); // the lightest test a little weak: the free line falls below 0
    let fit = fit_shear_curves(&tests).expect("a fit");
    assert_eq!((fit.estimates[0].value, fit.estimates[0].at_bound), (0.0, Some(Bound::Lower)));
    assert_eq!(fit.estimates[0].identifiability, Identifiability::AtBound);
}

/// Displacements far beyond K show the strength and not K.
#[test]
fn a_modulus_that_the_displacements_step_over_is_not_determined() {
    let mut noise = Noise::seeded(2);
    let mut tests = shear_tests(800.0, 0.5, 1e-5);
    tests.iter_mut().flat_map(|test| &mut test.shear).for_each(|shear| *shear += 30.0 * noise.normal());
    let fit = fit_shear_curves(&tests).expect("a fit");
    assert!(!fit.estimates[2].identifiability.is_determined(), "{:?}", fit.estimates[2]);
    assert!(fit.estimates[1].identifiability.is_determined());
}

#[test]
fn shear_tests_that_cannot_tell_are_refused() {
    let tests = shear_tests(800.0, 0.5, 0.012);
    assert_eq!(fit_shear_curves(&tests[..1]), Err(ShearError::Count));
    assert_eq!(fit_shear_curves(&[tests[0].clone(), tests[0].clone()]), Err(ShearError::OneStress));
    let still = |normal: f64| ShearCurve { normal, displacement: vec![0.0; 4], shear: vec![1.0; 4] };
    assert_eq!(fit_shear_curves(&[still(1e3), still(2e3)]), Err(ShearError::NoShear));
    let broken = ShearCurve { normal: f64::NAN, displacement: vec![0.01], shear: vec![1.0] };
    assert_eq!(fit_shear_curves(&[tests[0].clone(), broken]), Err(ShearError::Curve(1)));
}
