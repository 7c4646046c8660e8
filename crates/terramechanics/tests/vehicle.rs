//! A rover on a slope: the values of a peer's own function, sums that have to hold, loads by hand, ruts.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, contact, letter, system};
use proptest::prelude::*;
use terramechanics::{
    Bekker, Braking, CentreOfMass, Contact, Drive, Error, ForceModel, JanosiHanamoto, Method, Nearest, Operation, PeakRule,
    PressureSinkage, ShearLaw, Sinkage, SinkageExponent, Slip, SlopeLimit, SoilParams, Station, Turning, Unloading, Vehicle,
    VehicleError, VehicleParams, WheelOnSoil, WheelParams, WongReece,
};

/// Solved slips and loads.
const SOLVED: f64 = 1e-9;

/// JSC-1A under the wheel of RoverDevKit's example, whose own mobility function computed the values below.
fn jsc_1a() -> WheelOnSoil {
    let exponent = SinkageExponent { base: 1.0, slip_gain: 0.0, skid_gain: None };
    let soil = SoilParams {
        cohesion: 1000.0,
        friction_angle: 45f64.to_radians(),
        shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.018 })),
        pressure_sinkage: Some(PressureSinkage::Bekker(Bekker { k_c: 1400.0, k_phi: 820e3, exponent })),
        ..SoilParams::BARE
    };
    let wheel = WheelParams { radius: 0.1, width: 0.06, lug_height: 0.0, lug_coefficient: 0.5 };
    system(wheel, soil, contact(PeakRule::WongReece(WongReece { c1: 0.4, c2: 0.2 }), 0.0))
}

fn alike(mass: f64, count: u32, system: WheelOnSoil) -> VehicleParams {
    VehicleParams {
        mass,
        gravity: 1.625,
        stations: vec![Station { position: None, count, system, turning: Turning::Together }],
        centre_of_mass: None,
        hitch_height: 0.0,
        drive: Drive::OneSlip,
        model: ForceModel::at_rim(Method::Quadrature),
        unloading: None,
    }
}

fn with_stations(places: &[f64], centre_of_mass: Option<CentreOfMass>, system: WheelOnSoil) -> VehicleParams {
    let stations =
        places.iter().map(|&place| Station { position: Some(place), count: 1, system, turning: Turning::Together }).collect();
    VehicleParams { stations, centre_of_mass, ..alike(20.0, 1, system) }
}

fn vehicle(params: VehicleParams) -> Vehicle {
    Vehicle::new(params).expect("a rover")
}

#[test]
fn a_peers_rovers_climb_as_far_as_its_own_function_says() {
    for (mass, degrees) in [(10.0, 23.1400), (20.0, 21.4820), (40.0, 20.0097)] {
        let found = vehicle(alike(mass, 4, jsc_1a())).largest_slope(0.0, 0.6).expect("a slope");
        assert!((found.slope.to_degrees() - degrees).abs() <= 5e-5, "{mass} kg: {}", found.slope.to_degrees());
        assert_eq!(found.limit, SlopeLimit::Pull);
    }
}

#[test]
fn a_peers_rover_slips_as_much_as_its_own_function_says() {
    let rover = vehicle(alike(20.0, 4, jsc_1a()));
    for (degrees, slip) in [(0f64, 0.10106), (5.0, 0.18191), (10.0, 0.27747), (15.0, 0.39478), (20.0, 0.54583)] {
        let found = rover.on_slope(degrees.to_radians(), 0.0).expect("a slip").driven;
        assert!((found.slip.ratio() - slip).abs() <= 5e-6, "{degrees}°: {}", found.slip.ratio());
    }
}

#[test]
fn at_the_largest_slope_the_slip_is_the_limit() {
    let rover = vehicle(alike(20.0, 4, jsc_1a()));
    for (limit, hitch) in [(0.3, 0.0), (0.6, 0.0), (0.6, 5.0)] {
        let largest = rover.largest_slope(hitch, limit).expect("a slope").slope;
        let slip = rover.on_slope(largest, hitch).expect("a slip").driven.slip.ratio();
        assert!((slip - limit).abs() < 1e-8 && slip <= limit, "{slip} against {limit}");
    }
}

#[test]
fn the_largest_slope_is_climbed() {
    for mass in [1.0, 5.0, 20.0, 33.0, 80.0] {
        for count in [3, 4, 6] {
            for limit in [0.2, 0.45, 0.6, 0.99] {
                let rover = vehicle(alike(mass, count, jsc_1a()));
                let largest = rover.largest_slope(0.0, limit).expect("a slope").slope;
                let slip = rover.on_slope(largest, 0.0).expect("a slip").driven.slip.ratio();
                assert!(slip <= limit, "{mass} kg on {count} wheels: {slip} above {limit}");
                let beyond = rover.on_slope(largest + 1e-6, 0.0).map_or(1.0, |on| on.driven.slip.ratio());
                assert!(beyond > limit, "{mass} kg on {count} wheels climb more: {beyond} of {limit}");
            }
        }
    }
}

#[test]
fn alike_wheels_are_one_wheel_counted() {
    let rover = vehicle(alike(20.0, 4, jsc_1a()));
    let found = rover.on_slope(0.1, 0.0).expect("a slip");
    let load = 20.0 * 1.625 * 0.1f64.cos() / 4.0;
    let operation =
        Operation { system: jsc_1a(), model: ForceModel::at_rim(Method::Quadrature), sinkage: Sinkage::CarryingLoad(load) };
    let wheel = operation.at(found.driven.slip).expect("a point");
    assert_eq!(found.driven.wheels[0].forces, wheel.forces);
    let expected = 4.0 * wheel.forces.torque / (0.1 * (1.0 - found.driven.slip.ratio()));
    assert!((found.driven.energy_per_metre / expected - 1.0).abs() < 1e-14);
    assert!((found.specific_resistance - expected / (20.0 * 1.625)).abs() < 1e-14);
    assert!((found.driven.wheels[0].power(0.05) * 4.0 / (expected * 0.05) - 1.0).abs() < 1e-14);
}

#[test]
fn loads_are_those_of_statics() {
    // By hand, W = 32.5 N: two axles 0.8 m apart, the centre of mass in the middle and 0.2 m high. On the level each wheel carries a
    // quarter; on a slope the front axle loses W sin α · 0.2/0.8 and the rear one gains it.
    let centre = CentreOfMass { position: 0.0, height: 0.2 };
    let rover = vehicle(with_stations(&[0.4, 0.4, -0.4, -0.4], Some(centre), jsc_1a()));
    assert!(rover.loads(0.0, 0.0).expect("loads").iter().all(|load| (load - 8.125).abs() < 1e-14));
    let slope = 0.3f64;
    let shift = 32.5 * slope.sin() * 0.2 / 0.8 / 2.0;
    let loads = rover.loads(slope, 0.0).expect("loads");
    for (load, sign) in loads.iter().zip([-1.0, -1.0, 1.0, 1.0]) {
        assert!((load - (32.5 * slope.cos() / 4.0 + sign * shift)).abs() < 1e-13, "{loads:?}");
    }
    // Three axles: linear in x, so the middle one keeps its share.
    let rover = vehicle(with_stations(&[0.5, 0.0, -0.5], Some(CentreOfMass { position: 0.1, height: 0.0 }), jsc_1a()));
    // Σ N = 32.5 and Σ N x = 3.25 give N = 32.5/3 ± 3.25.
    let loads = rover.loads(0.0, 0.0).expect("loads");
    for (load, expected) in loads.iter().zip([32.5 / 3.0 + 3.25, 32.5 / 3.0, 32.5 / 3.0 - 3.25]) {
        assert!((load - expected).abs() < 1e-13, "{loads:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn all_sums_hold(
        slope in -0.2..0.35f64, hitch in 0.0..4.0f64, mass in 5.0..60.0f64, height in 0.0..0.3f64, shift in -0.1..0.1f64,
        in_ruts in any::<bool>(),
    ) {
        let centre = CentreOfMass { position: shift, height };
        let params = with_stations(&[0.4, 0.4, 0.0, 0.0, -0.5, -0.5], Some(centre), jsc_1a());
        let unloading = in_ruts.then_some(Unloading::MEASURED);
        let rover = vehicle(VehicleParams { mass, unloading, ..params });
        let weight = mass * 1.625;
        let loads = rover.loads(slope, hitch).expect("loads");
        let sum: f64 = loads.iter().sum();
        prop_assert!((sum / (weight * slope.cos()) - 1.0).abs() < 1e-13);
        let moment: f64 = loads.iter().zip([0.4, 0.4, 0.0, 0.0, -0.5, -0.5]).map(|(load, x)| load * x).sum();
        prop_assert!((moment - weight * (slope.cos() * shift - slope.sin() * height)).abs() < 1e-12 * weight);
        let found = match rover.on_slope(slope, hitch) {
            Err(VehicleError::NotClimbed { .. }) => return Ok(()),
            found => found.expect("a slip"),
        };
        prop_assert!((found.driven.normal / sum - 1.0).abs() < SOLVED);
        prop_assert!((found.driven.pull - (weight * slope.sin() + hitch)).abs() < SOLVED * weight, "{}", found.driven.pull);
        for (wheel, load) in found.driven.wheels.iter().zip(&loads) {
            prop_assert!((wheel.forces.normal / load - 1.0).abs() < SOLVED);
        }
    }

    #[test]
    fn a_rover_that_is_turned_round_has_its_loads_turned_round(shift in -0.1..0.1f64, height in 0.0..0.15f64, slope in -0.3..0.3f64) {
        let loads = |sign: f64| {
            let places = [0.5, 0.1, -0.4].map(|place| sign * place);
            let centre = CentreOfMass { position: sign * shift, height };
            vehicle(with_stations(&places, Some(centre), jsc_1a())).loads(sign * slope, 0.0).expect("loads")
        };
        for (a, b) in loads(1.0).iter().zip(loads(-1.0)) {
            prop_assert!((a - b).abs() < 1e-12 * 32.5);
        }
    }
}

#[test]
fn a_slope_beyond_the_pull_is_told_with_the_largest() {
    let rover = vehicle(alike(20.0, 4, jsc_1a()));
    match rover.on_slope(0.6, 0.0) {
        Err(VehicleError::NotClimbed { needed, reached, nearest: Nearest::Largest, slip }) => {
            assert!((needed - 32.5 * 0.6f64.sin()).abs() < 1e-12);
            let loads = rover.loads(0.6, 0.0).expect("loads");
            let pull = |ratio: f64| rover.at(Slip::new(ratio).expect("a slip"), &loads).expect("a rover").pull;
            let tried = (0..=2000).map(|i| pull(f64::from(i) / 2000.0)).fold(f64::NEG_INFINITY, f64::max);
            assert!(reached >= tried && reached < needed && (pull(slip) - reached).abs() < SOLVED, "{reached} {tried} {slip}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_wheel_that_lifts_off_is_told() {
    // The centre of mass is 0.5 m high over a base of 0.2 m: the front lifts where tan α = 0.1/0.5.
    let centre = CentreOfMass { position: 0.0, height: 0.5 };
    let rover = vehicle(with_stations(&[0.1, -0.1], Some(centre), jsc_1a()));
    let tips = 0.2f64.atan();
    assert!(rover.loads(tips - 1e-6, 0.0).is_ok());
    match rover.on_slope(tips + 0.01, 0.0) {
        Err(VehicleError::Lifted { station: 0, load, .. }) => assert!(load < 0.0),
        other => panic!("{other:?}"),
    }
    let largest = rover.largest_slope(0.0, 0.6).expect("a slope");
    assert!((largest.slope - tips).abs() < 1e-9, "{}", largest.slope);
    assert!(matches!(largest.limit, SlopeLimit::Wheel(VehicleError::Lifted { station: 0, .. })));
}

#[test]
fn with_too_much_at_the_hitch_only_a_descent_is_left() {
    let rover = vehicle(alike(20.0, 4, jsc_1a()));
    let level = rover.largest_slope(0.0, 0.6).expect("a slope").slope;
    let spare = 32.5 * level.sin();
    let largest = rover.largest_slope(2.0 * spare, 0.6).expect("a slope").slope;
    assert!(largest < 0.0, "{largest}");
    let refused = rover.largest_slope(1e3, 0.6);
    assert!(matches!(refused, Err(VehicleError::NotClimbed { nearest: Nearest::Largest, .. })), "{refused:?}");
}

#[test]
fn parts_that_do_not_fit_are_refused() {
    let refused = |params: VehicleParams| Vehicle::new(params).expect_err("no rover");
    let centre = Some(CentreOfMass { position: 0.0, height: 0.2 });
    let at_fault = |params: VehicleParams| match refused(params) {
        VehicleError::Invalid(fault) => fault.parameter.name,
        other => panic!("{other:?}"),
    };
    assert_eq!(at_fault(VehicleParams { mass: 0.0, ..alike(1.0, 4, letter()) }), "mass_kg");
    assert_eq!(at_fault(VehicleParams { gravity: f64::NAN, ..alike(1.0, 4, letter()) }), "gravity_m_s2");
    assert_eq!(refused(VehicleParams { stations: Vec::new(), ..alike(1.0, 4, letter()) }), VehicleError::NoWheels);
    assert_eq!(refused(alike(1.0, 0, letter())), VehicleError::NoWheels);
    assert_eq!(refused(VehicleParams { centre_of_mass: centre, ..alike(1.0, 4, letter()) }), VehicleError::NoBase);
    assert_eq!(refused(with_stations(&[0.1, 0.1], centre, letter())), VehicleError::NoBase);
    let unloading = Some(Unloading::MEASURED);
    assert_eq!(refused(VehicleParams { unloading, ..alike(1.0, 4, letter()) }), VehicleError::NoOrder);
    let stations = with_stations(&[0.1, -0.1], None, letter());
    let linearised = VehicleParams { unloading, model: ForceModel::at_rim(Method::LINEARISED), ..stations };
    assert_eq!(refused(linearised), VehicleError::RutByOtherMethod);
    let two_zones = WheelOnSoil { contact: Contact::MIDPOINT.with_braking(Braking::TwoZone), ..letter() };
    let two_zones = VehicleParams { unloading, ..with_stations(&[0.1, -0.1], None, two_zones) };
    assert_eq!(refused(two_zones), VehicleError::RutByOtherMethod);
    let rover = vehicle(alike(1.0, 4, letter()));
    assert!(matches!(rover.on_slope(1.6, 0.0), Err(VehicleError::Invalid(fault)) if fault.parameter == &Vehicle::SLOPE));
    assert!(
        matches!(rover.largest_slope(0.0, 1.1), Err(VehicleError::Invalid(fault)) if fault.parameter == &Vehicle::SLIP_LIMIT)
    );
    let slick = system(LETTER_WHEEL, SoilParams { shear: None, ..LETTER_SOIL }, Contact::MIDPOINT);
    let refused = vehicle(alike(1.0, 4, slick)).on_slope(0.0, 0.0);
    assert!(matches!(refused, Err(VehicleError::Wheel { station: 0, error: Error::MissingLaw(_) })), "{refused:?}");
}

/// Stress integrals of a driving wheel in a rut by the midpoint rule, written out from Eqs. (1), (3)–(6), (10) and the unloading.
fn in_rut_by_midpoints(pressed: f64, sinkage: f64, slip: f64) -> [f64; 3] {
    const POINTS: u32 = 400_000;
    let (r, b, modulus, exponent) = (0.2f64, 0.1, -660.0 / 0.1 + 754_130.0, 0.91);
    let (tan_phi, k) = (0.478f64.tan(), 0.005);
    let stiffness = Unloading::MEASURED.base + Unloading::MEASURED.gain * pressed;
    let pressure_pressed = modulus * f64::powf(pressed, exponent);
    let floor = pressed - pressure_pressed / stiffness;
    let entry = (1.0 - (sinkage - floor) / r).acos();
    let peak = 0.5 * entry;
    let step = entry / f64::from(POINTS);
    let mut sums = [0.0; 3];
    for i in 0..POINTS {
        let theta = (f64::from(i) + 0.5) * step;
        let mirrored = if theta >= peak { theta } else { entry - theta / peak * (entry - peak) };
        let depth = floor + r * (mirrored.cos() - entry.cos());
        let unloaded = pressure_pressed - stiffness * (pressed - depth);
        let normal = if depth <= pressed { unloaded } else { modulus * depth.powf(exponent) };
        let displacement = r * ((entry - theta) - (1.0 - slip) * (entry.sin() - theta.sin()));
        let shear = (1.0 - (-displacement / k).exp()) * normal * tan_phi;
        sums[0] += r * b * (shear * theta.cos() - normal * theta.sin()) * step;
        sums[1] += r * b * (normal * theta.cos() + shear * theta.sin()) * step;
        sums[2] += r * r * b * shear * step;
    }
    sums
}

#[test]
fn a_wheel_in_a_rut_has_the_forces_of_the_unloaded_soil() {
    let params = VehicleParams {
        mass: 160.0,
        gravity: 1.0,
        unloading: Some(Unloading::MEASURED),
        ..with_stations(&[0.3, -0.3], None, letter())
    };
    let rover = vehicle(params);
    for ratio in [0.1, 0.4] {
        let driven = rover.at(Slip::new(ratio).expect("a slip"), &[80.0, 80.0]).expect("a rover");
        let [front, rear] = driven.wheels[..] else { panic!("two wheels") };
        let [pull, normal, torque] = in_rut_by_midpoints(front.sinkage, rear.sinkage, ratio);
        // The midpoint rule of 400 000 points over two kinks.
        for (value, expected) in [(rear.forces.longitudinal, pull), (rear.forces.normal, normal), (rear.forces.torque, torque)] {
            assert!((value / expected - 1.0).abs() < 1e-8, "{value} against {expected}");
        }
        assert!((normal / 80.0 - 1.0).abs() < 1e-8);
    }
}

#[test]
fn the_wheel_in_the_rut_sinks_less_and_meets_less_resistance() {
    let stations = with_stations(&[0.3, 0.0, -0.3], None, jsc_1a());
    let rover = vehicle(VehicleParams { unloading: Some(Unloading::MEASURED), ..stations });
    let loads = rover.loads(0.0, 0.0).expect("loads");
    let driven = rover.at(Slip::new(0.2).expect("a slip"), &loads).expect("a rover");
    let [first, second, third] = driven.wheels[..] else { panic!("three wheels") };
    assert_eq!(first.rut_depth, 0.0);
    for (before, after) in [(first, second), (second, third)] {
        let rebound = before.sinkage - after.rut_depth;
        assert!(0.0 < rebound && rebound < 1e-3, "the soil comes back by {rebound} m");
        let own = after.sinkage - after.rut_depth;
        assert!(own < before.sinkage - before.rut_depth, "{own} m against {before:?}");
        assert!(after.sinkage > before.sinkage);
        assert!(after.forces.components.resistance < before.forces.components.resistance);
    }
}

#[test]
fn a_rut_in_soil_that_comes_back_whole_is_none() {
    // With the soil's own modulus for k_u, and n = 1, unloading runs back along the curve of loading.
    let modulus = 1400.0 / 0.06 + 820e3;
    let unloading = Some(Unloading { base: modulus, gain: 0.0 });
    let rover = vehicle(VehicleParams { unloading, ..with_stations(&[0.3, -0.3], None, jsc_1a()) });
    let driven = rover.at(Slip::new(0.2).expect("a slip"), &[8.0, 8.0]).expect("a rover");
    let [front, rear] = driven.wheels[..] else { panic!("two wheels") };
    assert!(rear.rut_depth.abs() < 1e-15);
    assert!((rear.sinkage / front.sinkage - 1.0).abs() < SOLVED);
    assert!((rear.forces.torque / front.forces.torque - 1.0).abs() < SOLVED);
}

#[test]
fn wheels_follow_those_of_their_side() {
    // The left front wheel is twice as wide and leaves a shallower rut.
    let narrow = jsc_1a();
    let wide = system(WheelParams { width: 0.12, ..*narrow.wheel.params() }, *narrow.soil.params(), narrow.contact);
    let mut params = with_stations(&[-0.3, -0.3, 0.3, 0.3], None, narrow);
    params.stations[2].system = wide;
    let rover = vehicle(VehicleParams { unloading: Some(Unloading::MEASURED), ..params });
    let wheels = rover.at(Slip::new(0.2).expect("a slip"), &[8.0; 4]).expect("a rover").wheels;
    assert!(wheels[2].sinkage < wheels[3].sinkage);
    assert!(wheels[0].rut_depth < wheels[2].sinkage && wheels[1].rut_depth > wheels[2].sinkage);
    assert_eq!((wheels[2].rut_depth, wheels[3].rut_depth), (0.0, 0.0));
}

/// The caller is asked before each wheel, and not again after a no: of stations whose slips follow from a torque, one slip alone of the
/// others takes a hundred wheels each.
#[test]
fn a_rover_ends_as_soon_as_nobody_wants_it() {
    let mut params = with_stations(&[0.0, 0.3, 0.6, 0.9], None, jsc_1a());
    for station in &mut params.stations[1..] {
        station.turning = Turning::UnderTorque(0.2);
    }
    params.unloading = Some(Unloading::MEASURED);
    let rover = vehicle(params);
    for most in [1, 50, 1000] {
        let asked = std::cell::Cell::new(0);
        let go_on = || {
            asked.set(asked.get() + 1);
            asked.get() < most
        };
        assert_eq!(rover.on_slope_while(0.1, 0.0, &go_on), Err(VehicleError::Stopped));
        assert_eq!(asked.get(), most);
        asked.set(0);
        assert_eq!(rover.largest_slope_while(0.0, 0.6, &go_on), Err(VehicleError::Stopped));
        assert_eq!(asked.get(), most);
    }
    assert_eq!(rover.largest_slope_while(0.0, 0.6, &|| true), rover.largest_slope(0.0, 0.6));
}
