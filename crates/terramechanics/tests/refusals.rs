//! Everything the model refuses, each with the input at fault.

mod common;

use common::{LETTER_LAW, LETTER_SOIL, LETTER_WHEEL, contact, letter, slip, system};
use terramechanics::{
    AngleRatio, Bekker, Contact, ContactParams, Direct, Error, ExitRule, ForceModel, InvalidInput, JanosiHanamoto, Lambda,
    Method, OperatingPoint, Operation, Parameter, PeakDepth, PeakRule, PressureSinkage, ShearLaw, Sinkage, SinkageExponent,
    SinkageRatio, Slip, SlipSweep, Soil, SoilParams, Wheel, WheelOnSoil, WheelParams, WongPeak, WongReece, WongResidual,
};

const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

fn at_fault<T: std::fmt::Debug>(result: Result<T, InvalidInput>) -> Vec<Parameter> {
    result.expect_err("refused").faults.iter().map(|fault| *fault.parameter).collect()
}

#[test]
fn dimensions_of_the_wheel() {
    let wheel = |change: fn(&mut WheelParams, f64), value: f64| {
        let mut params = LETTER_WHEEL;
        change(&mut params, value);
        Wheel::new(params)
    };
    let radius: fn(&mut WheelParams, f64) = |p, v| p.radius = v;
    let width: fn(&mut WheelParams, f64) = |p, v| p.width = v;
    let height: fn(&mut WheelParams, f64) = |p, v| p.lug_height = v;
    let coefficient: fn(&mut WheelParams, f64) = |p, v| p.lug_coefficient = v;
    for (change, parameter, bad) in [
        (radius, Wheel::RADIUS, [0.0, -1.0]),
        (width, Wheel::WIDTH, [0.0, -1.0]),
        (height, Wheel::LUG_HEIGHT, [-1e-9, -1.0]),
        (coefficient, Wheel::LUG_COEFFICIENT, [-0.01, 1.01]),
    ] {
        for value in bad.into_iter().chain(NOT_FINITE) {
            assert_eq!(at_fault(wheel(change, value)), [parameter], "{value}");
        }
    }
}

#[test]
fn parameters_of_the_soil() {
    for value in [-1e-9].into_iter().chain(NOT_FINITE) {
        assert_eq!(at_fault(Soil::new(SoilParams { cohesion: value, ..LETTER_SOIL })), [Soil::COHESION]);
    }
    for value in [-0.1, std::f64::consts::FRAC_PI_2, 2.0].into_iter().chain(NOT_FINITE) {
        assert_eq!(at_fault(Soil::new(SoilParams { friction_angle: value, ..LETTER_SOIL })), [Soil::FRICTION_ANGLE]);
    }
    for value in [0.0, -0.01].into_iter().chain(NOT_FINITE) {
        assert_eq!(
            at_fault(Soil::new(SoilParams {
                shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: value })),
                ..LETTER_SOIL
            })),
            [JanosiHanamoto::MODULUS]
        );
    }
    for value in [0.0, -0.01].into_iter().chain(NOT_FINITE) {
        let peak = ShearLaw::WongPeak(WongPeak { peak_displacement: value });
        let residual = ShearLaw::WongResidual(WongResidual { residual_ratio: value, peak_displacement: value });
        assert_eq!(at_fault(Soil::new(SoilParams { shear: Some(peak), ..LETTER_SOIL })), [WongPeak::PEAK_DISPLACEMENT]);
        let both = [WongResidual::RESIDUAL_RATIO, WongPeak::PEAK_DISPLACEMENT];
        assert_eq!(at_fault(Soil::new(SoilParams { shear: Some(residual), ..LETTER_SOIL })), both);
    }
    for value in [0.0, -0.01].into_iter().chain(NOT_FINITE) {
        let soil = SoilParams { unit_weight: Some(value), lateral_shear_modulus: Some(value), ..LETTER_SOIL };
        assert_eq!(at_fault(Soil::new(soil)), [Soil::UNIT_WEIGHT, Soil::LATERAL_SHEAR_MODULUS]);
    }
    for value in NOT_FINITE {
        let law = PressureSinkage::Bekker(Bekker { k_phi: value, ..LETTER_LAW });
        assert_eq!(at_fault(Soil::new(SoilParams { pressure_sinkage: Some(law), ..LETTER_SOIL })), [Bekker::K_PHI]);
    }
}

#[test]
fn all_faults_are_named_at_once() {
    let faults = at_fault(Wheel::new(WheelParams { radius: -1.0, width: f64::NAN, lug_height: 0.0, lug_coefficient: 2.0 }));
    assert_eq!(faults, [Wheel::RADIUS, Wheel::WIDTH, Wheel::LUG_COEFFICIENT]);
}

#[test]
fn a_modulus_that_is_not_positive_on_this_wheel() {
    let law = PressureSinkage::Bekker(Bekker { k_c: -100_000.0, ..LETTER_LAW }); // positive only for b > 0.1326 m
    let soil = SoilParams { pressure_sinkage: Some(law), ..LETTER_SOIL };
    let narrow = system(LETTER_WHEEL, soil, Contact::MIDPOINT);
    assert!(matches!(narrow.rolling(slip(0.2)), Err(Error::ModulusNotPositive { modulus }) if modulus < 0.0));
    assert!(system(WheelParams { width: 0.2, ..LETTER_WHEEL }, soil, Contact::MIDPOINT).rolling(slip(0.2)).is_ok());
}

#[test]
fn an_exponent_that_is_not_positive() {
    let exponent = SinkageExponent { base: 0.5, slip_gain: 1.0, skid_gain: None };
    let soil = SoilParams { pressure_sinkage: Some(PressureSinkage::Bekker(Bekker { exponent, ..LETTER_LAW })), ..LETTER_SOIL };
    let system = system(LETTER_WHEEL, soil, Contact::MIDPOINT);
    assert_eq!(system.rolling(slip(-0.5)), Err(Error::ExponentNotPositive { exponent: 0.0 }));
    assert!(system.rolling(slip(-0.4)).is_ok());
}

/// With a skid gain of its own the exponent grows on both sides of rolling, continuously.
#[test]
fn a_skid_gain_replaces_the_slip_gain_at_negative_slip() {
    let exponent = SinkageExponent { base: 1.46, slip_gain: 0.01, skid_gain: Some(0.74) };
    for (ratio, expected) in [(0.5, 1.465), (0.0, 1.46), (-0.5, 1.83)] {
        assert!((exponent.at(slip(ratio)) - expected).abs() < 1e-15);
    }
}

#[test]
fn slip_outside_its_range() {
    for value in [-1.0 - 1e-12, 1.0 + 1e-12].into_iter().chain(NOT_FINITE) {
        assert!(matches!(Slip::new(value), Err(Error::Invalid(fault)) if *fault.parameter == Slip::RATIO));
    }
}

#[test]
fn sinkage_outside_the_wheel() {
    let system = letter();
    let rolling = system.rolling(slip(0.2)).expect("a rolling wheel");
    for sinkage in [0.0, -0.01, 0.2 + 1e-12].into_iter().chain(NOT_FINITE) {
        assert!(matches!(rolling.contact(sinkage), Err(Error::SinkageOutsideWheel { .. })), "{sinkage}");
    }
    assert!(rolling.contact(0.2).is_ok());
}

#[test]
fn a_peak_outside_the_contact() {
    for (rule, exit_ratio) in [
        (PeakRule::WongReece(WongReece { c1: 1.0, c2: 0.0 }), 0.0),
        (PeakRule::WongReece(WongReece { c1: 0.9, c2: 0.5 }), 0.0),
        (PeakRule::WongReece(WongReece { c1: 0.2, c2: -1.0 }), 0.0),
        (PeakRule::WongReece(WongReece { c1: 0.2, c2: 0.0 }), 0.3),
        (PeakRule::HalfSinkage, 0.8),
    ] {
        let system = system(LETTER_WHEEL, LETTER_SOIL, contact(rule, exit_ratio));
        let rolling = system.rolling(slip(0.3)).expect("a rolling wheel");
        assert!(matches!(rolling.contact(0.02), Err(Error::PeakOutsideContact { .. })), "{rule:?}");
    }
    let at_fault_with = |exit| at_fault(Contact::new(ContactParams { exit, ..ContactParams::MIDPOINT }));
    for c3 in [-1.2 - 1e-9, 1.0].into_iter().chain(NOT_FINITE) {
        assert_eq!(at_fault_with(ExitRule::AngleRatio(AngleRatio { c3 })), [AngleRatio::C3]);
    }
    for ratio in [-1e-9, 1.2 + 1e-9].into_iter().chain(NOT_FINITE) {
        assert_eq!(at_fault_with(ExitRule::SinkageRatio(SinkageRatio { ratio })), [SinkageRatio::RATIO]);
    }
}

#[test]
fn a_load_that_is_none_or_beyond_what_the_soil_carries() {
    let system = letter();
    let rolling = system.rolling(slip(0.2)).expect("a rolling wheel");
    for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
        let model = ForceModel::at_rim(method);
        for load in [0.0, -1.0].into_iter().chain(NOT_FINITE) {
            let refused = model.solve_sinkage(&rolling, load);
            assert!(matches!(refused, Err(Error::Invalid(fault)) if *fault.parameter == WheelOnSoil::NORMAL_LOAD));
        }
        let largest_carried = model.forces(&rolling.contact(0.2).expect("to the axle")).expect("forces").normal;
        let Err(Error::LoadBeyondCapacity { load, largest, sinkage }) = model.solve_sinkage(&rolling, 1.001 * largest_carried)
        else {
            panic!("a load beyond the soil's is refused");
        };
        assert_eq!((load, largest, sinkage), (1.001 * largest_carried, largest_carried, 0.2));
        let carried = model.solve_sinkage(&rolling, 0.999 * largest_carried).expect("just carried");
        assert!(carried.sinkage < 0.2 && carried.sinkage > 0.199);
    }
}

#[test]
fn a_lambda_that_is_not_finite() {
    let system = letter();
    let rolling = system.rolling(slip(0.2)).expect("a rolling wheel");
    let patch = rolling.contact(0.02).expect("a contact");
    for value in NOT_FINITE {
        let method = Method::Explicit { peak_depth: PeakDepth::Half, lambda_a: Lambda::Exact, lambda_b: Lambda::Given(value) };
        let refused = ForceModel::at_rim(method).forces(&patch);
        assert!(matches!(refused, Err(Error::Invalid(fault)) if *fault.parameter == Lambda::B));
    }
}

#[test]
fn a_result_that_overflows() {
    let law = PressureSinkage::Bekker(Bekker { k_phi: 1e308, ..LETTER_LAW });
    let soil = SoilParams { pressure_sinkage: Some(law), friction_angle: 1.57, ..LETTER_SOIL };
    let system = system(WheelParams { width: 1e6, ..LETTER_WHEEL }, soil, Contact::MIDPOINT);
    let rolling = system.rolling(slip(0.2)).expect("a rolling wheel");
    let patch = rolling.contact(0.2).expect("a contact");
    for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
        assert_eq!(ForceModel::at_rim(method).forces(&patch), Err(Error::NotFinite));
    }
}

#[test]
fn a_sweep_names_its_gaps_and_fills_the_rest() {
    let contact = contact(PeakRule::WongReece(WongReece { c1: 0.5, c2: 1.0 }), 0.0); // outside the contact from s = 0.5 on
    let system = system(LETTER_WHEEL, LETTER_SOIL, contact);
    let operation = Operation { system, model: ForceModel::at_rim(Method::Quadrature), sinkage: Sinkage::CarryingLoad(50.0) };
    let slips: Vec<Slip> = [-0.2, 0.0, 0.2, 0.4, 0.5, 0.9].map(slip).to_vec();
    let sweep = SlipSweep::of(&operation, &slips);
    assert_eq!(sweep.gaps().map(|(row, ..)| row).collect::<Vec<_>>(), [4, 5]);
    assert!(sweep.gaps().all(|(_, _, error)| matches!(error, Error::PeakOutsideContact { .. })));
    assert_eq!(sweep.points().map(|(row, _)| row).collect::<Vec<_>>(), [0, 1, 2, 3]);
    for (row, &slip) in sweep.rows.iter().zip(&slips) {
        assert_eq!(row.slip, slip);
        match (row.point, operation.at(slip)) {
            (Ok(found), Ok(alone)) => assert_same(&found, &alone),
            (found, alone) => assert_eq!(found, alone),
        }
    }
}

/// A search that starts from its neighbours ends within the tolerance of a solved sinkage of where it ends alone.
fn assert_same(found: &OperatingPoint, alone: &OperatingPoint) {
    const SOLVED: f64 = 1e-12;
    let (forces, expected) = (&found.forces, &alone.forces);
    assert!((found.sinkage / alone.sinkage - 1.0).abs() <= SOLVED, "{} {}", found.sinkage, alone.sinkage);
    assert!((forces.longitudinal - expected.longitudinal).abs() <= SOLVED * expected.longitudinal_scale(), "{found:?} {alone:?}");
    assert!((forces.normal / expected.normal - 1.0).abs() <= SOLVED, "{found:?} {alone:?}");
    // The soil shears a braking wheel forwards and backwards; the torque is the difference.
    let braking = if found.slip.is_driving() { 0.0 } else { expected.normal_scale() * LETTER_WHEEL.radius };
    assert!((forces.torque - expected.torque).abs() <= SOLVED * expected.torque.abs().max(braking), "{found:?} {alone:?}");
}

#[test]
fn a_solved_sweep_is_its_points_however_its_slips_lie() {
    let slips = |ratio: fn(f64) -> f64| (0..=200).map(|i| slip(ratio(f64::from(i) / 200.0))).collect::<Vec<_>>();
    let orders =
        [slips(|x| x), slips(|x| 2.0 * x - 1.0), slips(|x| 1.0 - x), slips(|x| 0.5 + 0.5 * (40.0 * x).sin()), slips(|_| 0.3)];
    for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
        let model = ForceModel::at_rim(method);
        let operation = Operation { system: letter(), model, sinkage: Sinkage::CarryingLoad(50.0) };
        for slips in &orders {
            let sweep = SlipSweep::of(&operation, slips);
            assert_eq!(sweep.points().count(), slips.len());
            for (row, point) in sweep.points() {
                assert_same(point, &operation.at(slips[row]).expect("a point"));
            }
        }
    }
}

#[test]
fn the_largest_load_of_a_locked_wheel_is_the_largest_and_all_below_it_are_carried() {
    // Steep friction: the shear that drags a locked wheel down outgrows the support well before the axle.
    let system = WheelOnSoil {
        soil: Soil::new(SoilParams {
            cohesion: 0.0,
            friction_angle: 1.2,
            shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.005 })),
            pressure_sinkage: Some(PressureSinkage::Direct(Direct {
                k_s: 1e6,
                exponent: SinkageExponent { base: 1.0, slip_gain: 0.0, skid_gain: None },
            })),
            ..SoilParams::BARE
        })
        .expect("a soil"),
        ..letter()
    };
    let rolling = system.rolling(Slip::LOCKED).expect("a rolling wheel");
    let model = ForceModel::at_rim(Method::Quadrature);
    let Err(Error::LoadBeyondCapacity { largest, sinkage, .. }) = model.solve_sinkage(&rolling, 1e6) else {
        panic!("a load beyond the soil's is refused");
    };
    assert!(sinkage > 0.0 && sinkage < 0.2);
    for i in 1..=4000 {
        let normal = model.forces(&rolling.contact(0.2 * f64::from(i) / 4000.0).expect("a contact")).expect("forces").normal;
        assert!(normal <= largest * (1.0 + 1e-12), "{normal} N at sample {i} exceeds {largest} N");
    }
    for share in [0.99, 0.999, 1.0 - 1e-6, 1.0 - 1e-9] {
        let carried = model.solve_sinkage(&rolling, share * largest).expect("below the largest load");
        assert!((carried.forces.normal / (share * largest) - 1.0).abs() < 1e-9, "{share}");
    }
    assert!(model.solve_sinkage(&rolling, largest * (1.0 + 1e-9)).is_err());
}
