//! How do tests at a slip angle state the slip, and what is it in the plane of the wheel?
//!
//! A rig drives the axle at the speed V and turns the wheel's heading away by β; its slip compares the rim's speed with V.
//! The model's slip compares it with the component V cos β along the heading (`lateral` of the model): a wheel whose rim is
//! as fast as the carriage drives through the soil once it is turned.
//!
//! | | slip of travel s | in the plane of the wheel |
//! |---|---|---|
//! | V/(rω) | 1 − s driving, 1/(1 + s) braking | κ = cos β V/(rω) |
//! | slip | s | 1 − κ driving, 1/κ − 1 braking |
//!
//! The angles of the contact that were tuned to such tests go with the slip of travel: θm = (a0 + a1 s) θ1 and
//! θ2 = (b0 + b1 s) θ1 while s > 0; a skidding wheel keeps those of s = 0 (Pavlov & Johnson 2024).

use serde::Deserialize;
use serde_json::{Value, json};

/// Motion at a slip angle, and the contact that was tuned to it.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SideSlipOfSet {
    slip_angle_deg: f64,
    a0: f64,
    a1: f64,
    b0: f64,
    b1: f64,
}

impl SideSlipOfSet {
    /// β (rad).
    pub(crate) fn angle(&self) -> f64 {
        self.slip_angle_deg.to_radians()
    }

    /// The slip in the plane of the wheel.
    pub(super) fn slip(&self, travel_slip: f64) -> f64 {
        if travel_slip <= -1.0 {
            return -1.0; // locked, whichever way it is dragged
        }
        let of_travel = if travel_slip >= 0.0 { 1.0 - travel_slip } else { 1.0 / (1.0 + travel_slip) };
        let along = self.angle().cos() * of_travel;
        if along <= 1.0 { 1.0 - along } else { 1.0 / along - 1.0 }
    }

    /// θm/θ1 (–).
    pub(crate) fn c1(&self, travel_slip: f64) -> f64 {
        self.a0 + self.a1 * travel_slip.max(0.0)
    }

    /// θ2/θ1 (–).
    pub(crate) fn c3(&self, travel_slip: f64) -> f64 {
        self.b0 + self.b1 * travel_slip.max(0.0)
    }

    /// The contact of a request.
    pub(super) fn contact(&self, travel_slip: f64) -> Value {
        json!({"rule": "wong_reece", "c1": self.c1(travel_slip), "c2": 0, "c3": self.c3(travel_slip)})
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(slip_angle_deg: f64) -> SideSlipOfSet {
        SideSlipOfSet { slip_angle_deg, a0: 0.3, a1: 0.5, b0: -0.4, b1: -0.2 }
    }

    #[test]
    fn slip_is_that_of_the_component_along_the_heading() {
        for slip in [-1.0, -0.7, 0.0, 0.4, 1.0] {
            assert!((at(0.0).slip(slip) - slip).abs() < 1e-15);
        }
        // cos 60° = 1/2: rim and carriage equally fast drive at 50 %; a rim of half the speed rolls; a quarter brakes at 50 %.
        for (of_travel, in_plane) in [(0.0, 0.5), (-0.5, 0.0), (-0.75, -0.5), (0.5, 0.75), (-1.0, -1.0), (1.0, 1.0)] {
            assert!((at(60.0).slip(of_travel) - in_plane).abs() < 1e-15, "{of_travel}");
        }
    }

    #[test]
    fn the_tuned_angles_are_held_while_the_wheel_skids() {
        let side = at(15.0);
        assert_eq!((side.c1(-0.7), side.c3(-0.7)), (0.3, -0.4));
        assert!((side.c1(0.5) - 0.55).abs() < 1e-15 && (side.c3(0.5) + 0.5).abs() < 1e-15);
    }
}
