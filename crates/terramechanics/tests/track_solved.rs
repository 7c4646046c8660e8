//! Telemetry of a wheel whose sinkage follows from its load.

mod common;

use common::letter;
use terramechanics::{ForceModel, Method, Operation, Sample, SampleMotion, Sinkage, Slip, Status, Thresholds, Tracker};

/// How far a search that starts elsewhere may end from another, relative.
const SOLVED: f64 = 1e-12;

#[test]
fn a_solved_row_is_the_operating_point_of_its_sample() {
    // Steady, drifting, jumping back and forth, next to each other, braking, and at the ends.
    let slips =
        [0.2, 0.2, 0.2, 0.21, 0.22, 0.23, 0.235, 0.9, 0.1, 0.100_000_000_000_1, 0.1, -0.3, -0.31, -0.32, 0.0, 1.0, -1.0, 0.2];
    for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
        let operation = |sinkage| Operation { system: letter(), model: ForceModel::at_rim(method), sinkage };
        let mut tracker = Tracker::new(operation(Sinkage::CarryingLoad(80.0)), Thresholds::default()).expect("thresholds");
        for (i, slip) in slips.into_iter().enumerate() {
            // A load that stays, one that changes now and then, and one that the soil does not carry.
            let load = if i == 5 {
                1e9
            } else if i > 8 {
                60.0
            } else {
                80.0
            };
            let sinkage = Sinkage::CarryingLoad(load);
            let row = tracker.push(&Sample {
                time: i as f64,
                motion: SampleMotion::Slip(slip),
                sinkage,
                measured: None,
                unreadable: false,
            });
            let alone = operation(sinkage).at(Slip::new(slip).expect("a slip"));
            let Ok(point) = alone else {
                assert_eq!(row.status, Status::NoSolution, "{method:?} {slip}");
                continue;
            };
            assert!((row.sinkage / point.sinkage - 1.0).abs() <= SOLVED, "{method:?} {slip}: {} {}", row.sinkage, point.sinkage);
            for (found, expected) in [(row.longitudinal, point.forces.longitudinal), (row.normal, point.forces.normal)] {
                assert!((found - expected).abs() <= SOLVED * load, "{method:?} {slip}: {found} {expected}");
            }
            assert!((row.torque - point.forces.torque).abs() <= SOLVED * load * letter().wheel.radius());
        }
    }
}
