//! Wheels of a rover that turn at one slip, at equal torques or as they are told, against an independent solution; hitches in statics.

mod common;

use common::{LETTER_LAW, cases, contact, system};
use proptest::prelude::*;
use serde_json::Value;
use terramechanics::{
    Bekker, CentreOfMass, Drive, Driven, ForceModel, JanosiHanamoto, Method, Nearest, PeakRule, PressureSinkage, ShearLaw,
    SinkageExponent, Slip, SoilParams, Station, Turning, Unloading, Vehicle, VehicleError, VehicleParams, WheelOnSoil,
    WheelParams, WongReece,
};

const REFERENCE: &str = include_str!("reference/vehicle.json");

/// Solved slips, loads and torques.
const SOLVED: f64 = 1e-9;

fn number(of: &Value, name: &str) -> f64 {
    of[name].as_f64().unwrap_or_else(|| panic!("no {name} in {of}"))
}

fn wheel_on_soil(station: &Value, rule: PeakRule) -> WheelOnSoil {
    let (wheel, soil) = (&station["wheel"], &station["soil"]);
    let law = &soil["pressure_sinkage"];
    let exponent = SinkageExponent { base: number(law, "n0"), ..LETTER_LAW.exponent };
    let bekker = Bekker { k_c: number(law, "k_c"), k_phi: number(law, "k_phi"), exponent };
    let soil = SoilParams {
        cohesion: number(soil, "cohesion_pa"),
        friction_angle: number(soil, "friction_angle_rad"),
        shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: number(soil, "shear_modulus_m") })),
        pressure_sinkage: Some(PressureSinkage::Bekker(bekker)),
        ..SoilParams::BARE
    };
    let (radius, width) = (number(wheel, "radius_m"), number(wheel, "width_m"));
    system(WheelParams { radius, width, lug_height: 0.0, lug_coefficient: 0.5 }, soil, contact(rule, 0.0))
}

fn rover(input: &Value) -> VehicleParams {
    let rule = &input["contact"];
    let rule = PeakRule::WongReece(WongReece { c1: number(rule, "c1"), c2: number(rule, "c2") });
    let station = |of: &Value| Station {
        position: Some(number(of, "x_m")),
        count: 1,
        system: wheel_on_soil(of, rule),
        turning: match (of["slip"].as_f64(), of["torque_n_m"].as_f64()) {
            (Some(slip), _) => Turning::AtSlip(Slip::new(slip).expect("a slip")),
            (None, Some(torque)) => Turning::UnderTorque(torque),
            (None, None) => Turning::Together,
        },
    };
    let centre = &input["centre_of_mass"];
    VehicleParams {
        mass: number(input, "mass_kg"),
        gravity: number(input, "gravity_m_s2"),
        stations: input["stations"].as_array().expect("stations").iter().map(station).collect(),
        centre_of_mass: Some(CentreOfMass { position: number(centre, "x_m"), height: number(centre, "height_m") }),
        hitch_height: number(input, "hitch_height_m"),
        drive: if input["drive"] == "equal_torque" { Drive::EqualTorque } else { Drive::OneSlip },
        model: ForceModel::at_rim(Method::Quadrature),
        unloading: None,
    }
}

/// The first reference case of that name.
fn case(name: &str) -> VehicleParams {
    let all = cases(REFERENCE);
    rover(&all.iter().find(|case| case["name"] == name).expect("a case")["input"])
}

fn vehicle(params: VehicleParams) -> Vehicle {
    Vehicle::new(params).expect("a rover")
}

#[test]
fn every_drive_meets_an_independent_solution() {
    for case in cases(REFERENCE) {
        let (name, input, expected) = (&case["name"], &case["input"], &case["expected"]);
        let rover = vehicle(rover(input));
        let hitch = number(input, "hitch_pull_n");
        let slope = number(expected, "slope_rad");
        if let Some(limit) = input["slip_limit"].as_f64() {
            let largest = rover.largest_slope(hitch, limit).expect("a slope").slope;
            assert!((largest / slope - 1.0).abs() < SOLVED, "{name}: {largest} against {slope}");
        }
        let driven = rover.on_slope(slope, hitch).unwrap_or_else(|error| panic!("{name}: {error}")).driven;
        let wheels = expected["wheels"].as_array().expect("wheels");
        assert_eq!(driven.wheels.len(), wheels.len());
        for (wheel, expected) in driven.wheels.iter().zip(wheels) {
            let found = [
                ("slip", wheel.slip.ratio(), 1.0),
                ("sinkage_m", wheel.sinkage, 0.01),
                ("normal_load_n", wheel.load, 10.0),
                ("longitudinal_force_n", wheel.forces.longitudinal, 10.0),
                ("torque_n_m", wheel.forces.torque, 1.0),
            ];
            for (field, value, scale) in found {
                let expected = number(expected, field);
                assert!((value - expected).abs() < SOLVED * scale, "{name}, {field}: {value} against {expected}");
            }
        }
    }
}

#[test]
fn equal_torques_are_equal_and_the_slip_is_the_largest() {
    let rover = vehicle(case("equal torques, steep"));
    for slope in [-0.1, 0.0, 0.1, 0.2] {
        let Driven { slip, wheels, .. } = rover.on_slope(slope, 0.0).expect("a slip").driven;
        let largest = wheels.iter().map(|wheel| wheel.slip).fold(Slip::LOCKED, |a, b| if b > a { b } else { a });
        assert_eq!(largest, slip);
        for wheel in &wheels {
            assert!((wheel.forces.torque / wheels[0].forces.torque - 1.0).abs() < SOLVED, "{wheels:?}");
        }
    }
}

#[test]
fn equal_torques_of_alike_wheels_are_one_slip() {
    let mut params = case("one slip");
    params.centre_of_mass = None;
    params.stations = vec![params.stations[0]; 3];
    let of = |drive: Drive| vehicle(VehicleParams { drive, ..params.clone() }).on_slope(0.1, 1.0).expect("a slip");
    assert_eq!(of(Drive::EqualTorque), of(Drive::OneSlip));
}

#[test]
fn a_wheel_told_its_own_solution_changes_nothing() {
    let params = case("one slip");
    let all = vehicle(params.clone()).on_slope(0.1, 0.0).expect("a slip").driven;
    for turning in [Turning::AtSlip(all.slip), Turning::UnderTorque(all.wheels[1].forces.torque)] {
        let mut told = params.clone();
        told.stations[1].turning = turning;
        let found = vehicle(told).on_slope(0.1, 0.0).expect("a slip").driven;
        assert!((found.slip.ratio() - all.slip.ratio()).abs() < SOLVED, "{turning:?}: {:?}", found.slip);
        assert!((found.wheels[1].slip.ratio() - all.slip.ratio()).abs() < SOLVED);
    }
}

proptest! {
    #[test]
    fn a_pull_at_a_height_takes_its_moment_from_the_loads(
        slope in -0.2..0.2f64, pull in -3.0..3.0f64, height in 0.0..0.3f64, shift in -0.05..0.05f64,
    ) {
        let centre_of_mass = Some(CentreOfMass { position: shift, height: 0.2 });
        let rover = vehicle(VehicleParams { hitch_height: height, centre_of_mass, ..case("one slip") });
        let loads = rover.loads(slope, pull).expect("loads");
        let weight = 20.0 * 1.625;
        let sum: f64 = loads.iter().sum();
        let moment: f64 = loads.iter().zip([0.4, 0.05, -0.5]).map(|(load, x)| load * x).sum();
        prop_assert!((sum - weight * slope.cos()).abs() < 1e-13 * weight);
        let expected = weight * (slope.cos() * shift - slope.sin() * 0.2) - pull * height;
        prop_assert!((moment - expected).abs() < 1e-12 * weight);
        // Statics know the weight along the slope as a pull at the height of the centre of mass.
        let level = vehicle(VehicleParams { hitch_height: 0.2, centre_of_mass, ..case("one slip") });
        let tilted = vehicle(VehicleParams { hitch_height: 0.0, centre_of_mass, ..case("one slip") });
        let by_weight = tilted.loads(slope, 0.0).expect("loads");
        let lifted = level.loads(0.0, weight * slope.tan()).expect("loads");
        for (a, b) in by_weight.iter().zip(lifted) {
            prop_assert!((a - b * slope.cos()).abs() < 1e-12 * weight, "{a} {b}");
        }
    }
}

#[test]
fn what_cannot_be_solved_is_refused() {
    let refused = |params: VehicleParams| Vehicle::new(params).expect_err("no rover");
    let params = case("one slip");
    let mut told = params.clone();
    told.stations.iter_mut().for_each(|station| station.turning = Turning::UnderTorque(0.1));
    assert_eq!(refused(told), VehicleError::NothingTogether);
    let in_ruts = VehicleParams { unloading: Some(Unloading::MEASURED), drive: Drive::EqualTorque, ..params.clone() };
    assert_eq!(refused(in_ruts), VehicleError::RutAtEqualTorque);
    let high = VehicleParams { hitch_height: 0.1, centre_of_mass: None, ..params.clone() };
    assert_eq!(refused(high), VehicleError::HitchWithoutStatics);
    let below = VehicleParams { hitch_height: -0.1, ..params.clone() };
    assert!(matches!(refused(below), VehicleError::Invalid(fault) if fault.parameter == &Vehicle::HITCH_HEIGHT));
    let mut endless = params.clone();
    endless.stations[0].turning = Turning::UnderTorque(f64::INFINITY);
    assert!(matches!(refused(endless), VehicleError::Invalid(fault) if fault.parameter == &WheelOnSoil::TORQUE));
    // No more torque than soil holds: at full slip it is r F τ, far below 50 N·m.
    let mut strong = params;
    strong.stations[2].turning = Turning::UnderTorque(50.0);
    match vehicle(strong).on_slope(0.0, 0.0) {
        Err(VehicleError::TorqueNotHeld { station: 2, torque: 50.0, reached, nearest: Nearest::Largest, .. }) => {
            assert!(reached > 0.0 && reached < 5.0, "{reached}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_locked_wheel_in_the_rut_takes_no_energy_and_brakes() {
    let mut params = VehicleParams { unloading: Some(Unloading::MEASURED), ..case("one slip") };
    let apart = vehicle(params.clone()).on_slope(-0.3, 0.0).expect("a slip").driven;
    params.stations[2].turning = Turning::AtSlip(Slip::LOCKED);
    let driven = vehicle(params).on_slope(-0.3, 0.0).expect("a slip").driven;
    assert!(driven.wheels[2].rut_depth > 0.0);
    assert_eq!(driven.wheels[2].energy_per_metre(), 0.0);
    assert!(driven.wheels[2].forces.longitudinal < apart.wheels[2].forces.longitudinal);
    assert!(driven.slip > apart.slip);
}
