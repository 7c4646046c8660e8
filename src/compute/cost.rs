//! What a computation costs, known from its input before it runs.
//!
//! Two figures. What it usually takes decides whether it is short, and so goes before the long ones. Its price is what it may
//! take: work is ended at twice that. Both are processor time on a machine of 2026.

use std::time::Duration;

use terramechanics::{Drive, Method, Operation, Sinkage, Turning, Vehicle};

use super::SLICE;

/// The cost of a computation, in nanoseconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cost {
    usual: f64,
    price: f64,
}

/// Below this, work on the thread of a connection holds up the other connections of that thread too little to be noticed.
const NEXT_TO_NOTHING: f64 = 100e3;

/// Allowance on top of a price by the point, so that a few stiff contacts are not ended. One of them may take a hundred times
/// the usual time; the slowest known took 45 ms.
const ALLOWANCE: f64 = 1e9;

/// Work between two checks of the pace (ns), at its price.
const CHECK: f64 = 1e6;

/// Most points between two checks: more of them found together are not found faster.
const MOST_BETWEEN_CHECKS: usize = 256;

/// The price of a single contact that is solved by the quadrature: see [`ALLOWANCE`].
const SOLVED: f64 = 60e6;

/// Operating points that the search for the slip of a pull usually takes.
const SLIP_SEARCH: f64 = 30.0;

/// How many times the cost of a load balance one in a rut has.
const RUT: f64 = 2.0;

/// Load balances that a wheel takes whose slip follows from the torque of the others.
const SHARED_TORQUE: f64 = 16.0;

/// And from a torque of its own, for which all slips are searched: in ruts for each slip of the others, else once on a slope.
const OWN_TORQUE: [f64; 2] = [90.0, 10.0];

/// What one operating point costs, in nanoseconds.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Point {
    /// The kind of work, in words.
    pub(crate) work: &'static str,
    usual: f64,
    /// Among many.
    price: f64,
}

const fn point(work: &'static str, usual: f64, price: f64) -> Point {
    Point { work, usual, price }
}

/// Each method with a known sinkage, with one solved for a load, and with both known: then the quadrature has an integral without
/// cohesion and, where there is some, one of cohesion alone; at a slip angle a third one.
const POINTS: [[Point; 3]; 3] = [
    [
        point("a closed form", 300.0, 2e3),
        point("a closed form under a load", 2e3, 30e3),
        point("a closed form under a known load", 300.0, 2e3),
    ],
    [
        point("the quadrature", 1e3, 40e3),
        point("the quadrature under a load", 4e3, 300e3),
        point("the quadrature under a known load", 1e3, 50e3),
    ],
    [
        point("the quadrature at a slip angle", 20e3, 300e3),
        point("the quadrature at a slip angle under a load", 200e3, 3e6),
        point("the quadrature at a slip angle under a known load", 60e3, 900e3),
    ],
];

impl Point {
    fn of(operation: &Operation) -> Self {
        let [known, solved, under_load] = Self::by_method(operation.model.method);
        match operation.sinkage {
            Sinkage::Given(_) | Sinkage::FromStatic { .. } => known,
            Sinkage::CarryingLoad(_) => solved,
            Sinkage::UnderLoad { .. } => under_load,
        }
    }

    /// With a known sinkage, with one solved for a load, and with a load known beside the sinkage.
    fn by_method(method: Method) -> [Self; 3] {
        match method {
            Method::Linearised { .. } | Method::Explicit { .. } => POINTS[0],
            Method::Quadrature | Method::ResistiveForce => POINTS[1],
            Method::SideSlipping(_) => POINTS[2],
        }
    }

    /// Points that are computed for a warning alone: the standstill, from which the normal force of a wheel drifts whose sinkage
    /// follows from a static one.
    fn at_standstill(operation: &Operation) -> f64 {
        if matches!(operation.sinkage, Sinkage::FromStatic { .. }) { 1.0 } else { 0.0 }
    }

    /// Every kind.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        POINTS.into_iter().flatten()
    }

    /// Points of an operation between two checks of the pace: so many as cost about [`CHECK`] at the most, and not so few that they
    /// cannot be found together.
    pub(crate) fn between_checks(operation: &Operation) -> usize {
        ((CHECK / Self::of(operation).price) as usize).clamp(1, MOST_BETWEEN_CHECKS)
    }

    /// The price of one of many points, with that of writing its row.
    pub(crate) fn price(&self) -> Duration {
        duration(self.price + Self::ROW)
    }

    /// The cost of writing a row (ns).
    const ROW: f64 = 2e3;
}

/// The allowance on top of the price of several points.
pub(crate) fn allowance() -> Duration {
    duration(ALLOWANCE)
}

fn duration(nanoseconds: f64) -> Duration {
    Duration::try_from_secs_f64(1e-9 * nanoseconds).unwrap_or(Duration::MAX)
}

impl Cost {
    /// The cost of what is already computed.
    pub(crate) const NONE: Self = Self { usual: 0.0, price: 0.0 };

    const fn fixed(nanoseconds: f64) -> Self {
        Self { usual: nanoseconds, price: nanoseconds }
    }

    #[cfg(test)]
    pub(super) const fn long(price: Duration) -> Self {
        Self { usual: 1e9, price: price.as_nanos() as f64 }
    }

    #[cfg(test)]
    pub(super) const fn short(price: Duration) -> Self {
        Self { usual: 0.0, price: price.as_nanos() as f64 }
    }

    /// The cost of one operating point.
    pub(crate) fn of_point(operation: &Operation) -> Self {
        let Point { usual, price, .. } = Point::of(operation);
        let times = 1.0 + Point::at_standstill(operation);
        Self { usual: times * usual + Point::ROW, price: if Self::is_search(operation) { SOLVED } else { times * price } }
    }

    /// Whether it is a search that some contacts make a hundred times as long as usual. Closed forms are alike everywhere.
    fn is_search(operation: &Operation) -> bool {
        matches!(operation.sinkage, Sinkage::CarryingLoad(_)) && !operation.model.method.is_closed_form()
    }

    /// The cost of the slip that gives a pull: it usually takes some thirty operating points, and at most some 1500.
    pub(crate) fn of_solved_slip(operation: &Operation) -> Self {
        let Point { usual, .. } = Point::of(operation);
        Self { usual: SLIP_SEARCH * usual + Point::ROW, price: ALLOWANCE }
    }

    /// The cost of `points` operating points for each of several operations, and of writing their rows.
    pub(crate) fn of_points(operations: impl IntoIterator<Item = Operation>, points: usize) -> Self {
        let count = points as f64;
        let (mut usual, mut price) = (0.0, 0.0);
        for operation in operations {
            let point = Point::of(&operation);
            let points = count + Point::at_standstill(&operation);
            usual += points * point.usual + count * Point::ROW;
            price += points * point.price + count * Point::ROW;
        }
        let allowance = if price > NEXT_TO_NOTHING { ALLOWANCE } else { 0.0 };
        Self { usual, price: price + allowance }
    }

    /// The cost of so many requests like one for an operating point, each read by itself; where the slip is solved, of as many searches.
    pub(crate) fn of_rows(operation: &Operation, solves_slip: bool, rows: usize) -> Self {
        let point = Point::of(operation);
        let points = if solves_slip { SLIP_SEARCH } else { 1.0 + Point::at_standstill(operation) };
        let each = |of_point: f64| rows as f64 * (points * of_point + Self::READ + Point::ROW);
        Self { usual: each(point.usual), price: ALLOWANCE + each(point.price) }
    }

    /// What it takes to read a request that is there already (ns).
    const READ: f64 = 3e3;

    /// The cost of a rover on so many slopes: each takes some fifteen slips, and the largest slope some hundred and fifty, with a load
    /// balance for every station at each, or with several where its slip follows from a torque.
    pub(crate) fn of_vehicle(vehicle: &Vehicle, slopes: usize) -> Self {
        let params = vehicle.params();
        let [_, loaded, _] = Point::by_method(params.model.method);
        let in_rut = if params.unloading.is_some() { RUT } else { 1.0 };
        let slips = 15.0 * slopes as f64 + 150.0;
        let balances = params.stations.iter().map(|station| match (station.turning, params.drive) {
            (Turning::UnderTorque(_), _) => OWN_TORQUE[usize::from(params.unloading.is_none())],
            (Turning::Together, Drive::EqualTorque) => SHARED_TORQUE,
            (Turning::Together, Drive::OneSlip) | (Turning::AtSlip(_), _) => 1.0,
        });
        let usual = slips * balances.sum::<f64>() * in_rut * loaded.usual + slopes as f64 * Point::ROW;
        Self { usual, price: ALLOWANCE + 3.0 * usual }
    }

    /// The cost of so many rovers like one, each read by itself and on one slope.
    pub(crate) fn of_rovers(vehicle: &Vehicle, rovers: usize) -> Self {
        let usual = rovers as f64 * (Self::of_vehicle(vehicle, 1).usual + Self::READ);
        Self { usual, price: ALLOWANCE + 3.0 * usual }
    }

    /// The cost of one evaluation of closed forms.
    pub(crate) fn of_closed_forms() -> Self {
        Self::fixed(1e3)
    }

    /// The cost of predicting measurements under their load, and of fits to a few of them. It counts the quadratures; closed forms
    /// cost next to nothing.
    pub(crate) fn of_validation((straight, sideways): (usize, usize), fits: usize) -> Self {
        let (straight, sideways, fits) = (straight as f64, sideways as f64, fits as f64);
        let usual = 20e3 * straight + 200e3 * sideways + 3e6 * fits;
        Self { usual, price: ALLOWANCE + 2e6 * straight + 6e6 * sideways + 50e6 * fits }
    }

    /// The cost of a towed wheel: its skid usually takes fifteen load balances, and at most a hundred.
    pub(crate) fn of_towed() -> Self {
        Self { usual: 0.5e6, price: ALLOWANCE }
    }

    /// Of a line through `samples` samples; with a pressure–sinkage law its bias is simulated, by the quadrature a few times for each.
    pub(crate) fn of_line(samples: usize, law_known: bool) -> Self {
        let each = if law_known { 100e3 } else { 2e3 };
        Self::of_fit(samples as f64 * each)
    }

    /// Of a search that may spend so many evaluations of the forces.
    pub(crate) fn of_search(evaluations: u64) -> Self {
        Self::of_fit(evaluations as f64 * 200.0)
    }

    /// The cost of fitting curves with `points` points in all: the search tries a few thousand shear moduli.
    pub(crate) fn of_curves(points: usize) -> Self {
        Self::of_fit(points as f64 * 100e3)
    }

    /// The cost of a fit. It always goes to the pool, because no formula says how long a search takes.
    fn of_fit(usual: f64) -> Self {
        Self { usual, price: ALLOWANCE + 4.0 * usual }
    }

    /// The cost of writing the contract, with the answer to each of its examples.
    pub(crate) fn of_contract() -> Self {
        Self { usual: 100e6, price: ALLOWANCE }
    }

    /// The cost of reading a request body of `bytes`.
    pub(crate) fn of_body(bytes: usize) -> Self {
        let usual = bytes as f64 * 8.0;
        Self { usual, price: if usual > NEXT_TO_NOTHING { 10.0 * usual + SOLVED } else { usual } }
    }

    /// The cost of a profile with `points` places at one operating point.
    pub(crate) fn of_profile(operation: &Operation, points: usize) -> Self {
        let places = points as f64 * 500.0;
        match operation.sinkage {
            Sinkage::CarryingLoad(_) => Self { usual: Point::of(operation).usual + places, price: SOLVED + 4.0 * places },
            Sinkage::Given(_) | Sinkage::FromStatic { .. } | Sinkage::UnderLoad { .. } => {
                let Self { usual, price } = Self::of_point(operation);
                Self { usual: usual + places, price: price + 4.0 * places }
            }
        }
    }

    /// Whether the work may run on the thread of a connection.
    pub(super) fn is_next_to_nothing(self) -> bool {
        self.price <= NEXT_TO_NOTHING
    }

    /// Whether the work is usually done within its first slice.
    pub(super) fn is_short(self) -> bool {
        self.usual <= 0.5 * SLICE.as_nanos() as f64
    }

    /// What the work usually takes.
    pub(super) fn usual(self) -> Duration {
        duration(self.usual)
    }

    /// The price.
    pub(super) fn price(self) -> Duration {
        duration(self.price)
    }
}
