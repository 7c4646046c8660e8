//! The ways in which a set is run: a method, and the laws that a request chooses beside it.

use serde_json::{Value, json};

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
}

/// What is chosen for a wheel that moves at a slip angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SideLaws {
    pub(crate) shear_coupling: &'static str,
    pub(crate) bulldozing: &'static str,
}

const fn by(method: &'static str) -> Run {
    Run { series: method, method, braking: "one_zone", side: None }
}

const fn sideways(series: &'static str, shear_coupling: &'static str, bulldozing: &'static str) -> Run {
    Run { series, side: Some(SideLaws { shear_coupling, bulldozing }), ..by("quadrature") }
}

/// Straight ahead: every method; the last only where a density is known.
const STRAIGHT: [Run; 4] = [by("quadrature"), by("linearised"), by("explicit"), by(GRAINS)];

/// The method that needs a density and none of the laws.
const GRAINS: &str = "resistive_force";

/// A wheel that brakes at every point: also by the other law of braking, which has no closed form.
const BRAKING: [Run; 5] = [
    STRAIGHT[0],
    STRAIGHT[1],
    STRAIGHT[2],
    Run { series: "quadrature_two_zone", braking: "two_zone", ..STRAIGHT[0] },
    STRAIGHT[3],
];

/// At a slip angle: every pair of laws, the defaults of a request first. No closed form has a lateral force, and no slip angle
/// has two zones.
const SIDEWAYS: [Run; 4] = [
    sideways("quadrature", "independent", "full"),
    sideways("quadrature_mobilised", "independent", "mobilised"),
    sideways("quadrature_coupled", "coupled", "full"),
    sideways("quadrature_coupled_mobilised", "coupled", "mobilised"),
];

/// The runs of a set, by what its wheel does; by grains where that is asked for.
pub(super) fn runs_of(is_sideways: bool, is_braking: bool, by_grains: bool) -> &'static [Run] {
    let runs: &[Run] = match (is_sideways, is_braking) {
        (true, _) => return &SIDEWAYS,
        (false, true) => &BRAKING,
        (false, false) => &STRAIGHT,
    };
    let (last, others) = (runs.len(), runs.len() - 1);
    &runs[..if by_grains { last } else { others }]
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
