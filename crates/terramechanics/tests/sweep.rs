//! A sweep has the points that its slips have alone, although it finds them together.

mod common;

use common::{CIRCLES, LUGS, REFERENCE_CASES, cases, model_of, slip, system_of};
use terramechanics::{KnownSinkage, OperatingPoint, Operation, Sinkage, Slip, SlipSinkage, SlipSweep};

/// A closed form takes its exponentials, logarithms and arcsines from series where points are found together, and from the library
/// alone. They differ by two units in the last place; hundreds of such roundings stay below this.
const ROUNDED: f64 = 1e-12;

/// A solved sinkage ends where its search does, which starts elsewhere within a sweep.
const SOLVED: f64 = 1e-12;

fn slips() -> Vec<Slip> {
    (0..=70).map(|i| slip(-1.0 + 2.0 * f64::from(i) / 70.0)).collect()
}

/// Every operation of the cases by three methods, and the sweep of each.
fn sweeps(sinkage_of: impl Fn(f64) -> Sinkage) -> impl Iterator<Item = (Operation, SlipSweep)> {
    let cases: Vec<_> = [REFERENCE_CASES, LUGS, CIRCLES].into_iter().flat_map(cases).step_by(4).collect();
    let operations: Vec<_> = cases
        .iter()
        .flat_map(|case| {
            let input = &case["input"];
            let sinkage = sinkage_of(input["sinkage_m"].as_f64().expect("a sinkage"));
            ["quadrature", "linearised", "explicit"].map(|method| Operation {
                system: system_of(input),
                model: model_of(input, method),
                sinkage,
            })
        })
        .collect();
    operations.into_iter().map(|operation| (operation, SlipSweep::of(&operation, &slips())))
}

/// One number of a point.
type Number = fn(&OperatingPoint) -> f64;

/// Whether two points of an operation are one within `allowed`, each number on its own scale. The soil shears a braking wheel forwards
/// and backwards, and the torque is the difference: its scale is that of the load at the rim.
fn agree(operation: &Operation, [point, alone]: [&OperatingPoint; 2], allowed: f64) -> bool {
    let forces = &alone.forces;
    let torque = if alone.slip.is_driving() { 0.0 } else { forces.normal_scale() * operation.system.wheel.radius() };
    let (along, upward) = (forces.longitudinal_scale(), forces.normal_scale());
    let numbers: [(Number, f64); 8] = [
        (|point| point.sinkage, alone.sinkage),
        (|point| point.angles.entry, alone.angles.entry),
        (|point| point.angles.peak, alone.angles.entry),
        (|point| point.angles.exit, alone.angles.entry),
        (|point| point.sinkage_modulus().unwrap_or(0.0), alone.sinkage_modulus().unwrap_or(0.0)),
        (|point| point.forces.longitudinal, along),
        (|point| point.forces.normal, upward),
        (|point| point.forces.torque, forces.torque.abs().max(along * 1e-2).max(torque)),
    ];
    numbers.iter().all(|(number, scale)| (number(point) - number(alone)).abs() <= allowed * scale)
}

fn have_their_points(sinkage_of: impl Fn(f64) -> Sinkage) {
    let mut points = 0;
    for (operation, sweep) in sweeps(sinkage_of) {
        assert_eq!(sweep.rows.len(), slips().len());
        for (row, slip) in sweep.rows.iter().zip(slips()) {
            assert_eq!(row.slip, slip);
            match (&row.point, &operation.at(slip)) {
                (Ok(point), Ok(alone)) if operation.model.method.is_closed_form() => {
                    assert!(agree(&operation, [point, alone], ROUNDED), "{operation:?}: {point:?} for {alone:?}");
                }
                (found, alone) => assert_eq!(found, alone, "{operation:?}"),
            }
            points += usize::from(row.point.is_ok());
        }
    }
    assert!(points > 3000, "only {points} points");
}

#[test]
fn a_row_at_a_given_sinkage_is_its_point() {
    have_their_points(Sinkage::Given);
}

#[test]
fn a_row_at_a_sinkage_that_follows_the_slip_is_its_point() {
    have_their_points(|sinkage| Sinkage::FromStatic { static_sinkage: 0.3 * sinkage, law: SlipSinkage::Lyasko });
}

#[test]
fn a_row_under_a_known_load_is_its_point() {
    have_their_points(|sinkage| Sinkage::UnderLoad { sinkage: KnownSinkage::Given(sinkage), load: 50.0 });
}

#[test]
fn a_row_that_carries_a_load_is_its_point_within_the_tolerance_of_the_search() {
    let mut points = 0;
    for (operation, sweep) in sweeps(|_| Sinkage::CarryingLoad(30.0)) {
        for row in &sweep.rows {
            let alone = operation.at(row.slip);
            let (Ok(point), Ok(alone)) = (row.point, alone) else {
                assert_eq!(row.point.is_ok(), alone.is_ok(), "{operation:?} at {:?}", row.slip);
                continue;
            };
            assert!(agree(&operation, [&point, &alone], SOLVED), "{operation:?}: {point:?} for {alone:?}");
            points += 1;
        }
    }
    assert!(points > 1000, "only {points} points");
}
