//! The ways in which a set is run: a method, the laws that a request chooses beside it, and what of the sinkage is known.

use serde_json::{Value, json};

use super::points::Points;

/// One way to predict the points of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Run {
    /// Its name among the predicted columns: the method, and the options that differ from the defaults of a request.
    pub(crate) series: &'static str,
    pub(crate) method: &'static str,
    /// Law of a braking wheel; without effect on one that drives.
    pub(crate) braking: &'static str,
    /// For motion at a slip angle.
    pub(crate) side: Option<SideLaws>,
    /// Where the sinkage is known beside the load; else it is solved for the load.
    pub(crate) known: Option<Known>,
}

/// Where a sinkage is known from that stands beside the load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Known {
    /// It was measured at the point.
    Measured,
    /// From that at the first point by (18).
    FromStandstill,
}

impl Known {
    /// Its name on the wire.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Measured => "measured",
            Self::FromStandstill => "from_standstill",
        }
    }

    /// The field of the request for a point that has it; none where the sinkage was not measured.
    fn field(self, points: &Points, row: usize) -> Option<(&'static str, f64)> {
        match self {
            Self::Measured => Some(("sinkage_m", points.sinkage_at(row)?)),
            Self::FromStandstill => {
                let slip = *points.slip.first()?;
                Some(("static_sinkage_m", points.sinkage_at(0)? / ((1.0 + slip) / (1.0 - 0.5 * slip))))
            }
        }
    }
}

/// What is chosen for a wheel that moves at a slip angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SideLaws {
    pub(crate) shear_coupling: &'static str,
    pub(crate) bulldozing: &'static str,
}

const fn by(method: &'static str) -> Run {
    Run { series: method, method, braking: "one_zone", side: None, known: None }
}

const fn known(series: &'static str, method: &'static str, known: Known) -> Run {
    Run { series, known: Some(known), ..by(method) }
}

const fn sideways(series: &'static str, shear_coupling: &'static str, bulldozing: &'static str) -> Run {
    Run { series, side: Some(SideLaws { shear_coupling, bulldozing }), ..by("quadrature") }
}

/// Straight ahead: every method, and a load that is known beside the sinkage.
const STRAIGHT: [Run; 7] = [
    by("quadrature"),
    by("linearised"),
    by("explicit"),
    known("linearised_known_load", "linearised", Known::Measured),
    known("linearised_known_load_from_standstill", "linearised", Known::FromStandstill),
    known("quadrature_known_load", "quadrature", Known::Measured),
    by(GRAINS),
];

/// The method that needs a density and none of the laws.
const GRAINS: &str = "resistive_force";

/// A wheel that brakes at every point: also by the other law of braking, which has no closed form.
/// Equation (18) makes it rise where measured wheels sink, so that no sinkage follows from its standstill.
const BRAKING: [Run; 7] = [
    STRAIGHT[0],
    STRAIGHT[1],
    STRAIGHT[2],
    Run { series: "quadrature_two_zone", braking: "two_zone", ..STRAIGHT[0] },
    STRAIGHT[3],
    STRAIGHT[5],
    STRAIGHT[6],
];

/// At a slip angle: every pair of laws, the defaults of a request first. No closed form has a lateral force, and no slip angle
/// has two zones.
const SIDEWAYS: [Run; 4] = [
    sideways("quadrature", "independent", "full"),
    sideways("quadrature_mobilised", "independent", "mobilised"),
    sideways("quadrature_coupled", "coupled", "full"),
    sideways("quadrature_coupled_mobilised", "coupled", "mobilised"),
];

/// The runs of a set, by what its wheel does; by grains and with a sinkage that is known where that can be.
pub(super) fn runs_of(
    is_sideways: bool,
    is_braking: bool,
    by_grains: bool,
    knows_sinkage: bool,
) -> impl Iterator<Item = &'static Run> {
    let runs: &[Run] = match (is_sideways, is_braking) {
        (true, _) => &SIDEWAYS,
        (false, true) => &BRAKING,
        (false, false) => &STRAIGHT,
    };
    runs.iter().filter(move |run| (by_grains || !run.is_by_grains()) && (knows_sinkage || run.known.is_none()))
}

/// Every run there is, each once.
pub(crate) fn all_runs() -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for run in STRAIGHT.into_iter().chain(BRAKING).chain(SIDEWAYS) {
        if !runs.iter().any(|known| known.series == run.series) {
            runs.push(run);
        }
    }
    runs
}

impl Run {
    /// Whether it takes nothing of the laws of the soil.
    pub(crate) fn is_by_grains(&self) -> bool {
        self.method == GRAINS
    }

    /// Whether its forces are found by integration.
    pub(super) fn is_integral(&self) -> bool {
        self.method == "quadrature" || self.is_by_grains()
    }

    /// The field with the sinkage of a row that stands beside the load, where the run has one.
    pub(super) fn sinkage(&self, points: &Points, row: usize) -> Option<(&'static str, f64)> {
        self.known?.field(points, row)
    }

    /// The fields of a request that choose it.
    pub(super) fn fields(&self) -> Value {
        let mut fields = json!({"method": self.method});
        if self.braking != "one_zone" {
            fields["braking"] = self.braking.into();
        }
        if let Some(SideLaws { shear_coupling, bulldozing }) = self.side {
            fields["shear_coupling"] = shear_coupling.into();
            fields["bulldozing"] = bulldozing.into();
        }
        fields
    }
}
