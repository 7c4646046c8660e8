//! What forces act on a wheel that moves at an angle to its plane? The forces in the plane, the lateral force and its moments.
//!
//! F_y = ∫ {r_s b τ_y + R_b (r − h cos θ)} dθ (Ishigami et al. 2005, 2007), with the wall as deep as the rim at θ, also
//! behind the peak of the stresses.
//!
//! M_x = r F_y is the published overturning moment. The published M_z is F_y r sin θm, as if the whole force acted at the peak
//! of the stresses. Here M_z is the moment of the stresses themselves, ∫ {r_s² b τ_y + r R_b (r − h cos θ)} sin θ dθ: an
//! element of F_y at θ acts r sin θ ahead of the axle. So no point of action has to be assumed.
//!
//! With independent stresses the forces in the plane of the wheel equal those without a slip angle, to the last bit.

use super::panels::{Edges, ROUNDING, Resolved, error_of, integrate};
use super::quadrature;
use super::shearing::{Rim, Shearing};
use super::{ForceModel, Forces};
use crate::lateral::{Bulldozing, ShearCoupling, SideForce, SideSlip, SideWall};
use crate::numerics::elementary::Number;
use crate::numerics::gauss_legendre::{NODES, Node};
use crate::patch::ContactPatch;
use crate::rim::RimPoint;
use crate::stress::StressField;

pub(super) fn forces(model: &ForceModel, stresses: &StressField<'_>, side: &SideSlip) -> Forces {
    let patch = stresses.patch;
    let rim = Rim::of(stresses);
    // Straight ahead there is no lateral stress to couple.
    let along = if side.coupling == ShearCoupling::Independent || side.angle.sign() == 0.0 {
        quadrature::forces(model, stresses)
    } else {
        quadrature::forces_by::<_, _, FEW>(model, &rim, &Coupled { patch, side })
    };
    let (force, error) = side_force(&rim, side);
    Forces { integration_error: along.integration_error.max(error), side: Some(force), ..along }
}

/// Most panels to begin with: edges at a shear layer, two turns of the slip velocity and two reversals.
const FEW: usize = 6;

/// The component of a coupled stress along the rim.
struct Coupled<'a> {
    patch: &'a ContactPatch<'a>,
    side: &'a SideSlip,
}

impl Shearing for Coupled<'_> {
    #[inline(always)]
    fn ahead<F: Number>(&self, point: &RimPoint<F>) -> F {
        point.by_lane(|point| self.side.coupled_longitudinal_share(self.patch, point))
    }

    #[inline(always)]
    fn behind<F: Number>(&self, point: &RimPoint<F>) -> F {
        point.by_lane(|point| self.side.coupled_longitudinal_share(self.patch, point))
    }

    fn edges(&self, rim: &Rim<'_>) -> Edges {
        edges(rim, self.side)
    }
}

/// Ends of the panels: the end of a thin layer of shear, and for stresses that are coupled the places where the slip velocity
/// along the rim is least or turns, and where j changes sign.
fn edges(rim: &Rim<'_>, side: &SideSlip) -> Edges {
    let mut edges = Edges::new();
    rim.split_layer(&mut edges, side.layer(rim.patch));
    if side.coupling == ShearCoupling::Coupled {
        let turning = rim.patch.rolling.turning();
        for place in [turning, -turning] {
            let arc = rim.patch.angles.entry - place;
            if arc > 0.0 && arc < rim.whole {
                rim.split(&mut edges, arc);
            }
        }
        rim.split_reversals(&mut edges);
    }
    edges.close()
}

/// The force across, and an estimate of its relative error.
fn side_force(rim: &Rim<'_>, side: &SideSlip) -> (SideForce, f64) {
    let system = rim.patch.rolling.system;
    let wheel = &system.wheel;
    let wall = SideWall::of(&system.soil);
    let sign = side.angle.sign();
    let integrals = integrate::<_, FEW>(&edges(rim, side), |from, to| rim.side_panel(from, to, side, wall.as_ref()));
    let (whole, part) = (&integrals.wall, &integrals.mobilised);
    let pushed = match side.bulldozing {
        Bulldozing::Full => whole,
        Bulldozing::Mobilised => part,
    };
    let area = wheel.shearing_radius() * wheel.width();
    let shear = sign * area * integrals.shear.plain;
    let bulldozing = sign * pushed.plain;
    let lateral = shear + bulldozing;
    let moment = wheel.shearing_radius() * area * integrals.shear.sin + wheel.radius() * pushed.sin;
    let force = SideForce {
        lateral,
        overturning_moment: wheel.radius() * lateral,
        aligning_moment: sign * moment,
        shear,
        bulldozing: wall.map(|_| bulldozing),
        mobilised_share: if whole.plain > 0.0 && sign != 0.0 { part.plain / whole.plain } else { 1.0 },
    };
    (force, integrals.relative_error())
}

/// Integrals of one lateral stress, which has no sign here, so that they are their own scale.
#[derive(Clone, Copy, Default)]
struct Integral {
    /// ∫ … dθ.
    plain: f64,
    /// ∫ … sin θ dθ.
    sin: f64,
    null: [f64; 2],
    error: f64,
}

impl Integral {
    #[inline]
    fn take(&mut self, front: f64, rear: f64, sines: [f64; 2], null: [f64; 2]) {
        let both = front + rear;
        self.plain += both;
        self.sin += front * sines[0] + rear * sines[1];
        self.null[0] += both * null[0];
        self.null[1] += both * null[1];
    }

    fn add(&mut self, other: &Self) {
        self.plain += other.plain;
        self.sin += other.sin;
        self.error += other.error;
    }

    fn share(&self, total: &Self) -> f64 {
        if total.plain > 0.0 { self.error / total.plain } else { 0.0 }
    }
}

/// Sums over a panel, or over all of them.
#[derive(Clone, Copy, Default)]
struct Sums {
    /// τ_y.
    shear: Integral,
    /// R_b (r − h cos θ).
    wall: Integral,
    /// The share of it that is mobilised.
    mobilised: Integral,
}

impl Resolved for Sums {
    fn add(&mut self, other: &Self) {
        self.shear.add(&other.shear);
        self.wall.add(&other.wall);
        self.mobilised.add(&other.mobilised);
    }

    fn relative_error(&self) -> f64 {
        ROUNDING + self.error_share(self)
    }

    fn error_share(&self, total: &Self) -> f64 {
        self.shear.share(&total.shear).max(self.wall.share(&total.wall)).max(self.mobilised.share(&total.mobilised))
    }
}

impl Rim<'_> {
    fn side_panel(&self, from: f64, to: f64, side: &SideSlip, wall: Option<&SideWall>) -> Sums {
        let patch = self.patch;
        let radius = patch.rolling.system.wheel.radius();
        let length = to - from;
        let mut sums = Sums::default();
        for Node { place, weight, null } in &NODES {
            let u = from + length * place;
            let cube = u * u * u;
            let t = cube * u;
            let weight = length * weight * 4.0 * cube; // du → dt
            let front = patch.rim_point(t * self.front);
            let rear = patch.rim_point(self.whole - t * self.rear);
            let sines = [front.sin, rear.sin];
            let strength = patch.rolling.shear_strength(self.curve.pressure(patch.geometric_depth(&front)));
            let (front_weight, rear_weight) = (weight * self.front, weight * self.rear);
            let front_shear = front_weight * side.lateral_share(patch, &front) * strength;
            let rear_shear = rear_weight * side.lateral_share(patch, &rear) * strength;
            sums.shear.take(front_shear, rear_shear, sines, *null);
            if let Some(wall) = wall {
                let on_wall = |point| {
                    let depth = patch.geometric_depth(point);
                    wall.resistance(depth) * (radius - depth * point.cos)
                };
                let (front_wall, rear_wall) = (front_weight * on_wall(&front), rear_weight * on_wall(&rear));
                sums.wall.take(front_wall, rear_wall, sines, *null);
                let front_share = side.bulldozing_share(patch, &front);
                sums.mobilised.take(front_share * front_wall, side.bulldozing_share(patch, &rear) * rear_wall, sines, *null);
            }
        }
        for integral in [&mut sums.shear, &mut sums.wall, &mut sums.mobilised] {
            integral.error = error_of(integral.null, integral.plain);
        }
        sums
    }
}
