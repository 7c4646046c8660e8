//! The request of `/v1/optimum`.

mod formula;
mod goals;
mod variables;

pub(crate) use goals::{Constraint, Goals};
pub(crate) use variables::Varying;

use terramechanics_optimum::{MOST_STARTS, Task};
use terramechanics_reading::{Field, Flag, Nested, Number, Object, Path, Reader, Word};

use crate::api::either::{self, Of};
use crate::api::forces::ForcesCase;
use crate::api::vehicle::VehicleCase;
use crate::request::{Documented, Request};
use crate::varied::{Template, Varied};
use formula::Names;

/// Most evaluations of a search.
const MOST_EVALUATIONS: u32 = 20_000;

/// Numbers up to this are exact in JSON.
const LARGEST_SEED: f64 = 9_007_199_254_740_991.0;

const OF: Field<Word<Of>> =
    either::of("What is evaluated at each point: forces, as by /v1/forces, or vehicle, a rover on one slope, as by /v1/vehicle.");
const REQUEST: Field<Nested> = Field::required(
    "request",
    "The request that is asked at each point, as that operation takes it; a field that varies may be left out.",
    either::REQUESTS,
);
const STARTS: Field<Number> = Field::new(
    "starts",
    "Number of searches, the first from `start`, the others from where a survey of all bounds looks best. The best result counts.",
    Number::new("1", 1.0, MOST_STARTS as f64).whole().or(8.0),
);
const SEED: Field<Number> = Field::new(
    "seed",
    "Shifts the points of the survey. The same seed, the same answer.",
    Number::new("1", 0.0, LARGEST_SEED).whole().or(1.0),
);
const EVALUATIONS: Field<Number> = Field::new(
    "evaluations",
    "How often the operation may be asked in all. Where that is not enough, `converged` is false.",
    Number::new("1", Task::LEAST_EVALUATIONS as f64, MOST_EVALUATIONS as f64).whole().or(3000.0),
);

const MUST_CLIMB: Field<Flag> = Field::new(
    "must_climb",
    "vehicle: whether the rover has to climb its slope at a slip up to its limit. That is a constraint like the others, the last of the answer: `largest_slope_rad - slope_rad` at least 0. false: a rover that does not climb is as good as any other. true unless given.",
    Flag,
);

/// A search, checked.
pub(crate) enum OptimumCase {
    Forces(Box<Sought<ForcesCase>>),
    Vehicle(Box<Sought<VehicleCase>>),
}

/// The best of a request.
pub(crate) struct Sought<R> {
    pub(crate) template: Template<R>,
    /// A case within the bounds, for what all have in common.
    pub(crate) sample: R,
    pub(crate) variables: Vec<Varying>,
    pub(crate) goals: Goals,
    pub(crate) starts: u32,
    pub(crate) seed: u64,
    pub(crate) evaluations: u32,
}

pub(super) type OptimumRequest = Documented<OptimumCase>;

impl Request for OptimumCase {
    const OBJECT: &'static Object = &Object {
        name: "OptimumRequest",
        doc: "A request of which one to six numeric fields are sought, so that a quantity becomes as small or as large as limits allow.",
        groups: &[&[&OF, &REQUEST], variables::FIELDS, goals::FIELDS, &[&MUST_CLIMB, &STARTS, &SEED, &EVALUATIONS]],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        match object.required(&OF) {
            Some(Of::Forces) => {
                if object.has(&MUST_CLIMB) {
                    object.place_of(&MUST_CLIMB).fault("is for a rover alone, with `of` vehicle");
                }
                sought(object, false).map(Box::new).map(Self::Forces)
            }
            Some(Of::Vehicle) => {
                let must_climb = object.optional(&MUST_CLIMB).map(|given| given.unwrap_or(true));
                let found = sought(object, must_climb.unwrap_or(true));
                must_climb.and(found).map(Box::new).map(Self::Vehicle)
            }
            None => {
                let _ = object.required(&REQUEST);
                None
            }
        }
    }
}

/// The search for one kind of request.
fn sought<R: Varied>(object: &Reader<'_>, must_climb: bool) -> Option<Sought<R>> {
    let request = object.required(&REQUEST);
    let variables = variables::read(object, R::OBJECT);
    let goals = goals::read(object, must_climb);
    let (starts, seed) = (object.or_default(&STARTS), object.or_default(&SEED));
    let evaluations = object.or_default(&EVALUATIONS);
    let variables = variables?;
    let paths: Vec<Path> = variables.iter().map(|variable| variable.path.clone()).collect();
    let found = Template::new(request?, &paths).and_then(|mut template| {
        let sample = template.first_case(samples(&variables).iter().map(Vec::as_slice))?;
        Ok((template, sample))
    });
    let (template, sample): (Template<R>, Option<R>) = match found {
        Ok(found) => found,
        Err(faults) => {
            for fault in faults {
                match fault.field {
                    Some(variable) => variables::fault_of_field(object, variable, &fault.fault.detail),
                    None => object.place_of(&REQUEST).pass_on(fault.fault),
                }
            }
            return None;
        }
    };
    if sample.is_none() {
        object.place_of(&REQUEST).fault("makes no valid request at any corner of the bounds");
    }
    let sample = sample?;
    if let Some(fault) = sample.refusal() {
        object.place_of(&REQUEST).pass_on(fault);
    }
    let names = Names {
        variables: variables.iter().map(|variable| variable.name.as_str()).collect(),
        columns: sample.columns().iter().map(|about| about.name).collect(),
    };
    if !variables::mean_nothing_else(object, &variables, &names.columns) {
        return None;
    }
    let goals = goals?.resolved(&names, object)?;
    let (starts, seed, evaluations) = (starts? as u32, seed? as u64, evaluations? as u32);
    Some(Sought { template, sample, variables, goals, starts, seed, evaluations })
}

/// The starts, then the corners of the bounds, then points between.
fn samples(variables: &[Varying]) -> Vec<Vec<f64>> {
    let at = |share: &dyn Fn(usize) -> f64| {
        variables.iter().enumerate().map(|(i, variable)| variable.range.at(share(i))).collect::<Vec<f64>>()
    };
    let start = variables.iter().map(|variable| variable.range.start.unwrap_or_else(|| variable.range.at(0.5))).collect();
    let corners = (0..1_usize << variables.len()).map(|which| at(&|i| f64::from(u8::from(which >> i & 1 == 1))));
    let between = (1..20).map(|step| at(&|i| (f64::from(step) * 0.05 + 0.37 * i as f64).fract()));
    std::iter::once(start).chain(corners).chain(between).collect()
}
