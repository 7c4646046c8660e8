//! A load that is known in place of the sinkage modulus.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, LUGS, REFERENCE_CASES, cases, contact, letter, model_of, slip, system, system_of};
use proptest::prelude::*;
use terramechanics::{
    Braking, Bulldozing, Contact, Coupled, Direct, Error, ForceModel, Forces, JanosiHanamoto, KnownSinkage, Lambda,
    LinearSlipSinkage, Method, NormalStressFrom, NormalStressRadius, Operation, Outcome, PeakDepth, PeakRule, PressureSinkage,
    Sample, SampleMotion, ShearCoupling, ShearLaw, SideSlip, Sinkage, SinkageExponent, SlipAngle, SlipSinkage, SoilLaw,
    SoilParams, Thresholds, Tracker, WheelOnSoil, WheelParams, cautions,
};

/// A solved sinkage leaves this of its load, on the scale of the normal force, and so do the forces that follow.
const SOLVED: f64 = 1e-10;
/// Some tens of roundings.
const ROUNDING: f64 = 1e-12;
/// What the quadrature promises.
const QUADRATURE: f64 = 1e-10;

fn methods() -> Vec<Method> {
    let side = |coupling| {
        let angle = SlipAngle::new(-0.2).expect("an angle");
        Method::SideSlipping(SideSlip { angle, coupling, bulldozing: Bulldozing::Full })
    };
    let fitted = Method::Explicit { peak_depth: PeakDepth::Geometric, lambda_a: Lambda::Given(0.1), lambda_b: Lambda::Exact };
    let sides = [ShearCoupling::Independent, ShearCoupling::Coupled].map(side);
    [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT, fitted].into_iter().chain(sides).collect()
}

fn assert_alike(one: &Forces, other: &Forces, tolerance: f64) {
    let scale = one.longitudinal_scale();
    assert!((one.longitudinal - other.longitudinal).abs() <= tolerance * scale, "{one:?}, {other:?}");
    assert!((one.normal - other.normal).abs() <= tolerance * one.normal_scale(), "{one:?}, {other:?}");
    assert!((one.torque - other.torque).abs() <= tolerance * scale, "{one:?}, {other:?}");
    match (one.side, other.side) {
        (Some(one), Some(other)) => {
            let scale = one.lateral.abs().max(scale);
            assert!((one.lateral - other.lateral).abs() <= tolerance * scale);
            assert!((one.aligning_moment - other.aligning_moment).abs() <= tolerance * scale);
        }
        (None, None) => {}
        _ => panic!("a side force in one alone"),
    }
}

/// The wheels of the reference: what they carry by thirty digits leads back to their pull, their torque and their modulus.
#[test]
fn the_loads_of_the_reference_lead_back_to_its_forces() {
    let mut compared = 0;
    for case in cases(REFERENCE_CASES).iter().chain(&cases(LUGS)) {
        let (input, expected) = (&case["input"], &case["expected"]);
        let system = system_of(input);
        let number = |value: &serde_json::Value| value.as_f64().expect("a number");
        let rolling = system.rolling(slip(number(&input["slip"]))).expect("a rolling wheel");
        let patch = rolling.contact(number(&input["sinkage_m"])).expect("a contact");
        for method in ["quadrature", "linearised", "explicit"] {
            let of = |name: &str| number(&expected[method][name]);
            let load = of("normal_force_n");
            let scale = of("normal_support_n").abs() + of("shear_support_n").abs();
            if load < 0.05 * scale {
                continue; // a braking wheel that carries next to nothing: digits are lost in the difference
            }
            let loaded = model_of(input, method).forces_under(&patch, load).expect("forces");
            let tolerance = 20.0 * if method == "quadrature" { QUADRATURE } else { ROUNDING };
            let longitudinal_scale = of("traction_n").abs() + of("resistance_n").abs();
            assert!((loaded.forces.longitudinal - of("longitudinal_force_n")).abs() <= tolerance * longitudinal_scale, "{case}");
            assert!((loaded.forces.torque - of("torque_n_m")).abs() <= tolerance * longitudinal_scale, "{case}");
            let (found, soils) = (loaded.curve.expect("an exponent"), rolling.curve().expect("a law"));
            assert_eq!(found.exponent, soils.exponent);
            assert!((found.modulus / soils.modulus - 1.0).abs() <= tolerance, "{case}");
            compared += 1;
        }
    }
    assert!(compared > 250, "{compared}");
}

proptest! {
    /// Solving the sinkage for a load and then giving both gives the same forces, by every method.
    #[test]
    fn a_solved_sinkage_with_its_load_gives_the_same_forces(
        (cohesion, friction_angle, log_modulus) in (prop_oneof![Just(0.0), 10.0..3000.0], 0.1..0.9, 4.8..7.0),
        (ratio, load, lug_height) in (-0.3..=1.0, 5.0..300.0, prop_oneof![Just(0.0), 0.001..0.02]),
        (shearing, exit_ratio) in (any::<bool>(), -0.3..=0.1),
    ) {
        let exponent = SinkageExponent { base: 0.95, slip_gain: 0.2, skid_gain: None };
        let law = PressureSinkage::Direct(Direct { k_s: 10f64.powf(log_modulus), exponent });
        let soil = SoilParams {
            cohesion, friction_angle, pressure_sinkage: Some(law), unit_weight: Some(1.5e4), ..LETTER_SOIL
        };
        let wheel = WheelParams { lug_height, ..LETTER_WHEEL };
        let system = system(wheel, soil, contact(PeakRule::Midpoint, exit_ratio));
        let normal_stress_radius = if shearing { NormalStressRadius::Shearing } else { NormalStressRadius::Rim };
        for method in methods() {
            let model = ForceModel { method, normal_stress_radius };
            let Ok(solved) = (Operation { system, model, sinkage: Sinkage::CarryingLoad(load) }).at(slip(ratio)) else { continue };
            let sinkage = Sinkage::UnderLoad { sinkage: KnownSinkage::Given(solved.sinkage), load };
            let both = (Operation { system, model, sinkage }).at(slip(ratio)).expect("a point");
            // What the balance leaves of the load grows with what the parts are larger than it.
            let tolerance = SOLVED * (solved.forces.normal_scale() / load).powi(2);
            assert_alike(&solved.forces, &both.forces, tolerance);
            prop_assert_eq!((solved.sinkage, solved.angles), (both.sinkage, both.angles));
            prop_assert_eq!([solved.normal_stress_from, both.normal_stress_from], [NormalStressFrom::Soil, NormalStressFrom::Load]);
            let moduli = [solved, both].map(|point| point.sinkage_modulus().expect("a modulus"));
            prop_assert!((moduli[1] / moduli[0] - 1.0).abs() <= tolerance, "{:?}", moduli);
            prop_assert!((both.forces.normal / load - 1.0).abs() <= ROUNDING * both.forces.normal_scale() / load);
        }
    }

    /// Neither modulus nor exponent enters the closed forms; the modulus does not enter the quadrature.
    #[test]
    fn what_the_load_replaces_changes_nothing(
        (ratio, sinkage, load) in (-0.1..=1.0, 0.002..0.1, 20.0..200.0), (k_s, base) in (1e3..1e7, 0.4..1.8),
    ) {
        let at = |pressure_sinkage: Option<PressureSinkage>, method| {
            let soil = SoilParams { cohesion: 80.0, pressure_sinkage, ..LETTER_SOIL };
            let sinkage = Sinkage::UnderLoad { sinkage: KnownSinkage::Given(sinkage), load };
            let system = system(LETTER_WHEEL, soil, Contact::MIDPOINT);
            (Operation { system, model: ForceModel::at_rim(method), sinkage }).at(slip(ratio)).map(|point| point.forces)
        };
        let law = |k_s, base| {
            let exponent = SinkageExponent { base, slip_gain: 0.0, skid_gain: None };
            Some(PressureSinkage::Direct(Direct { k_s, exponent }))
        };
        for method in [Method::LINEARISED, Method::EXPLICIT] {
            prop_assert_eq!(at(None, method), at(law(k_s, base), method));
        }
        // Not even whether it is one: a modulus below 0 is another's business.
        prop_assert_eq!(at(law(k_s, 0.9), Method::Quadrature), at(law(-k_s, 0.9), Method::Quadrature));
        prop_assert_eq!(at(None, Method::Quadrature), Err(Error::MissingLaw(SoilLaw::PressureSinkage)));
    }

    /// The linear stresses under a load are Ding's coupled form.
    #[test]
    fn the_linearised_method_under_a_load_is_the_coupled_form(
        (ratio, sinkage, load) in (0.0..=1.0, 0.002..0.1, 20.0..200.0), lug_height in 0.0..0.02, shearing in any::<bool>(),
    ) {
        let soil = SoilParams { cohesion: 60.0, pressure_sinkage: None, ..LETTER_SOIL };
        let system = system(WheelParams { lug_height, ..LETTER_WHEEL }, soil, Contact::MIDPOINT);
        let rolling = system.rolling(slip(ratio)).expect("a rolling wheel");
        let patch = rolling.contact(sinkage).expect("a contact");
        let normal_stress_radius = if shearing { NormalStressRadius::Shearing } else { NormalStressRadius::Rim };
        let coupled = Coupled { normal_load: load, torque: None, normal_stress_radius }.forces(&patch).expect("forces");
        let model = ForceModel { method: Method::LINEARISED, normal_stress_radius };
        let Ok(loaded) = model.forces_under(&patch, load) else { return Ok(()) }; // cohesion alone carries it
        let scale = loaded.forces.longitudinal_scale();
        prop_assert!((coupled.longitudinal - loaded.forces.longitudinal).abs() <= ROUNDING * scale);
        prop_assert!((coupled.torque - loaded.forces.torque).abs() <= ROUNDING * scale);
    }
}

/// On a braking wheel of two zones too, by the quadrature.
#[test]
fn two_zones_take_a_load_that_is_known() {
    let soil = SoilParams { cohesion: 200.0, ..LETTER_SOIL };
    let system = system(LETTER_WHEEL, soil, Contact::MIDPOINT.with_braking(Braking::TwoZone));
    let rolling = system.rolling(slip(-0.1)).expect("a rolling wheel");
    let model = ForceModel::at_rim(Method::Quadrature);
    let solved = model.solve_sinkage(&rolling, 90.0).expect("a balance");
    let patch = rolling.contact(solved.sinkage).expect("a contact");
    let loaded = model.forces_under(&patch, 90.0).expect("forces");
    assert_alike(&solved.forces, &loaded.forces, SOLVED);
    let closed = ForceModel::at_rim(Method::LINEARISED).forces_under(&patch, 90.0);
    assert_eq!(closed, Err(Error::ClosedFormOfTwoZones));
}

/// By hand at θ1 = π/2, θm = π/4: B = (4/π)(√2 − 1), and cohesion carries B r_s b E c of the linear stresses. On the spot with K of
/// a micrometre E = 1.
#[test]
fn a_load_that_cohesion_carries_is_refused_with_what_it_carries() {
    let shear = Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 1e-6 }));
    let soil = SoilParams { cohesion: 1000.0, shear, ..LETTER_SOIL };
    let system = system(LETTER_WHEEL, soil, Contact::MIDPOINT);
    let rolling = system.rolling(slip(1.0)).expect("a rolling wheel");
    let patch = rolling.contact(LETTER_WHEEL.radius).expect("a contact");
    let carried = 4.0 / std::f64::consts::PI * (2f64.sqrt() - 1.0) * 0.2 * 0.1 * 1000.0;
    let model = ForceModel::at_rim(Method::LINEARISED);
    match model.forces_under(&patch, 0.99 * carried) {
        Err(Error::LoadBelowCohesion { load, carries }) => {
            assert_eq!(load, 0.99 * carried);
            assert!((carries / carried - 1.0).abs() < ROUNDING, "{carries}");
        }
        other => panic!("{other:?}"),
    }
    assert!(model.forces_under(&patch, 1.01 * carried).expect("forces").curve.expect("an exponent").modulus > 0.0);
    // The integral of the same: ∫ c sin θ dθ = c over a quarter of the rim, all of it but a micrometre mobilised.
    match ForceModel::at_rim(Method::Quadrature).forces_under(&patch, 1.0) {
        Err(Error::LoadBelowCohesion { carries, .. }) => {
            assert!((carries / (0.2 * 0.1 * 1000.0) - 1.0).abs() < 1e-4, "{carries}")
        }
        other => panic!("{other:?}"),
    }
    assert!(matches!(model.forces_under(&patch, 0.0), Err(Error::Invalid(_))));
}

/// A braking wheel whose shear stress takes away more than the normal stress supports.
#[test]
fn a_wheel_that_its_shear_stress_pulls_down_is_refused() {
    let soil = SoilParams { friction_angle: 1.2, ..LETTER_SOIL };
    let system = system(LETTER_WHEEL, soil, Contact::MIDPOINT);
    let rolling = system.rolling(slip(-1.0)).expect("a rolling wheel");
    let patch = rolling.contact(0.2).expect("a contact");
    for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
        let refused = ForceModel::at_rim(method).forces_under(&patch, 50.0);
        assert!(matches!(refused, Err(Error::LoadNotCoupled { support }) if support < 1e-6), "{refused:?}");
    }
}

/// The sinkage by a static one and the slip, the load beside it, one sample after another.
#[test]
fn a_track_takes_the_load_of_each_sample() {
    let system = letter();
    let known = KnownSinkage::FromStatic { static_sinkage: 0.012, law: SlipSinkage::Lyasko };
    let operation = Operation {
        system,
        model: ForceModel::at_rim(Method::Quadrature),
        sinkage: Sinkage::UnderLoad { sinkage: known, load: 1.0 },
    };
    let mut tracker = Tracker::new(operation, Thresholds::default()).expect("thresholds");
    for (i, (ratio, load)) in [(0.0, 60.0), (0.2, 61.0), (0.5, 59.0)].into_iter().enumerate() {
        let sinkage = Sinkage::UnderLoad { sinkage: known, load };
        let motion = SampleMotion::Slip(ratio);
        let row = tracker.push(&Sample { time: i as f64, motion, sinkage, measured: None, unreadable: false });
        assert!((row.normal / load - 1.0).abs() <= ROUNDING, "{row:?}");
        assert_eq!(row.sinkage, known.at(slip(ratio)));
        assert_eq!(row.longitudinal, Operation { sinkage, ..operation }.at(slip(ratio)).expect("a point").forces.longitudinal);
    }
    assert!(!tracker.cautions().iter().any(|tally| tally.worst.kind.code == "normal_force_drifts"));
    let missing = Sinkage::UnderLoad { sinkage: known, load: f64::NAN };
    let row =
        tracker.push(&Sample { time: 9.0, motion: SampleMotion::Slip(0.1), sinkage: missing, measured: None, unreadable: false });
    assert_eq!(row.status, terramechanics::Status::MissingValue);
}

/// Without a load the normal force drifts, and the caution says by how much.
#[test]
fn a_normal_force_that_drifts_says_by_how_much() {
    let law = SlipSinkage::Linear(LinearSlipSinkage { gain: 2.0, skid_gain: Some(1.2) });
    let sinkage = Sinkage::FromStatic { static_sinkage: 0.01, law };
    let operation = Operation { system: letter(), model: ForceModel::at_rim(Method::Quadrature), sinkage };
    let standstill = operation.standstill_normal().expect("it rests");
    let at_rest = operation.at(slip(0.0)).expect("a point").forces.normal;
    assert_eq!(standstill, at_rest);
    let told = |ratio: f64, standstill_normal| {
        let point = operation.at(slip(ratio)).expect("a point");
        let outcome = Outcome { standstill_normal, ..Outcome::from(&point) };
        let found = cautions(&operation, &outcome).find(|caution| caution.kind.code == "normal_force_drifts");
        (found.map(|caution| caution.value), point.forces.normal / at_rest - 1.0)
    };
    let (value, drift) = told(0.5, Some(standstill));
    assert_eq!(value, Some(drift));
    assert!(drift > 1.0);
    assert_eq!(told(0.5, None).0, None); // it is not known
    assert_eq!(told(0.001, Some(standstill)).0, None); // it hardly drifts
    let given = Operation { sinkage: Sinkage::Given(0.01), ..operation };
    assert_eq!(given.standstill_normal(), None);

    let mut tracker = Tracker::new(operation, Thresholds::default()).expect("thresholds");
    for (i, ratio) in [0.0, 0.5, 0.2].into_iter().enumerate() {
        let motion = SampleMotion::Slip(ratio);
        tracker.push(&Sample { time: i as f64, motion, sinkage, measured: None, unreadable: false });
    }
    let tally = tracker.cautions().iter().find(|tally| tally.worst.kind.code == "normal_force_drifts").expect("it is told");
    assert_eq!((tally.count, tally.first_row), (2, 1));
    assert_eq!(tally.worst.value, drift);
}

/// A skid gain holds at negative slip alone, and there in place of the other; with it the law says no more that it extrapolates.
#[test]
fn a_skid_gain_lets_a_braking_wheel_sink() {
    let law = |skid_gain| SlipSinkage::Linear(LinearSlipSinkage { gain: 0.5, skid_gain });
    for (ratio, with, without) in [(0.4, 1.2, 1.2), (0.0, 1.0, 1.0), (-0.5, 1.6, 0.75), (-1.0, 2.2, 0.5)] {
        assert!((law(Some(1.2)).sinkage(1.0, slip(ratio)) - with).abs() < 1e-15);
        assert!((law(None).sinkage(1.0, slip(ratio)) - without).abs() < 1e-15);
    }
    let told = |law| {
        let sinkage = Sinkage::FromStatic { static_sinkage: 0.01, law };
        let operation = Operation { system: letter(), model: ForceModel::at_rim(Method::LINEARISED), sinkage };
        let point = operation.at(slip(-0.2)).expect("a point");
        cautions(&operation, &Outcome::from(&point)).any(|caution| caution.kind.code == "slip_sinkage_extrapolated")
    };
    assert!(told(law(None)) && told(SlipSinkage::Lyasko) && !told(law(Some(1.2))));
}

/// What is watched of the law that the load replaces is not said: a small wheel by Bekker's law.
#[test]
fn a_known_load_leaves_out_what_is_said_of_the_modulus() {
    let told = |sinkage| {
        let system: WheelOnSoil = letter();
        let operation = Operation { system, model: ForceModel::at_rim(Method::Quadrature), sinkage };
        let point = operation.at(slip(0.2)).expect("a point");
        cautions(&operation, &Outcome::from(&point)).any(|caution| caution.kind.code == "small_wheel")
    };
    assert!(told(Sinkage::Given(0.02)));
    assert!(!told(Sinkage::UnderLoad { sinkage: KnownSinkage::Given(0.02), load: 90.0 }));
}
