//! The request of `/v1/identify`.

mod data;
mod linear;
mod setup;

use terramechanics::{Error, Wheel};
use terramechanics_identification::{
    FitError, FitOptions, Loss, MOST_STARTS, Observations, Quantity, Range, Setup, SinkageSource, Sought, Unknown,
};
use terramechanics_reading::{Field, FieldFault, Number, Object, Reader, Tagged, Word, Words};

use self::data::{DATA, STANDARD_DEVIATION};
use self::setup::Found;
pub(crate) use self::setup::Measured;
use crate::request::assume::ASSUME;
use crate::request::circles::CIRCLES;
use crate::request::fitted_law;
use crate::request::unknowns::{self, BOUNDS_FIELD, By, NAMES, START};
pub(crate) use data::column_name;

use crate::request::method::{LAMBDAS, METHOD_OF_FIT, STRESSES};
use crate::request::sinkage::SLIP_SINKAGE;
use crate::request::soil::LawOrigin;
use crate::request::system::{CONTACT, SOIL, WHEEL};
use crate::request::unused::Unused;
use crate::request::{Documented, Request};

const PARTIAL_SOIL: Field<&Object> = Field {
    meaning: "What is known of the soil; fitted fields may be absent, and are starts where they are not.",
    required: false,
    ..SOIL
};
const SLIP_SINKAGE_OF_FIT: Field<&Tagged> =
    Field { meaning: "Slip–sinkage law where static_sinkage_m is fitted; lyasko unless given.", ..SLIP_SINKAGE };
const FIT: Field<Words<Unknown>> =
    Field::required("fit", "The parameters to find.", Words { word: NAMES, most: NAMES.words.len(), first_unless_given: 0 });
const STARTS: Field<Number> = Field::new(
    "starts",
    "Number of starts to try; further ones are spread over the values of known soils.",
    Number::new("1", 1.0, MOST_STARTS as f64).whole().or(1.0),
);
const LOSS: Field<Word<Loss>> = Field::new(
    "loss",
    "How a residual counts: by its square, or by less where it is an outlier.",
    Word::new(&[
        ("least_squares", Loss::LeastSquares),
        ("huber", Loss::Huber),
        ("soft_l1", Loss::SoftL1),
        ("cauchy", Loss::Cauchy),
    ])
    .or(Loss::LeastSquares),
);
const ESTIMATOR: Field<Word<Estimator>> = Field::new(
    "estimator",
    "nonlinear: any parameters by any method. linear: cohesion_pa and friction_angle_rad from torque, load, slip and sinkage in one pass (Iagnemma et al. 2004), for linear stresses, which bias both; needs the soil's shear_modulus_m, takes contact and normal_stress_radius, and no pressure–sinkage law; with one, each estimate has its model_bias.",
    Word::new(&[("nonlinear", Estimator::Nonlinear), ("linear", Estimator::Linear)]).or(Estimator::Nonlinear),
);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Estimator {
    Nonlinear,
    Linear,
}

/// A fit, checked.
pub(crate) struct FitCase {
    pub(crate) setup: Setup,
    pub(crate) observations: Observations,
    pub(crate) sought: Vec<Sought>,
    pub(crate) options: FitOptions,
    /// Whether the preset's law gave way to the direct one, whose modulus is fitted.
    pub(crate) law_replaced: bool,
    pub(crate) measured: Vec<Measured>,
    /// What was sent and is not read.
    pub(crate) unused: Unused,
}

/// A linear estimate, checked: slip, sinkage, a load and torque were measured.
pub(crate) struct LinearCase {
    pub(crate) setup: Setup,
    pub(crate) observations: Observations,
    /// Whether the pressure–sinkage law of the setup is that of the soil.
    pub(crate) law_known: bool,
    /// What was sent and is not read.
    pub(crate) unused: Unused,
}

/// What is asked for.
pub(crate) enum IdentifyCase {
    Fit(Box<FitCase>),
    Linear(Box<LinearCase>),
}

/// Evaluations of the forces that a fit may take: five parameters of as many samples as are taken need a tenth of it.
const EVALUATIONS: u64 = 20_000_000;

pub(super) type IdentifyRequest = Documented<IdentifyCase>;

impl Request for IdentifyCase {
    const OBJECT: &'static Object = &Object {
        name: "IdentifyRequest",
        doc: "Measurements of a wheel, and which parameters to find from them; what is not fitted has to be known; what is fitted may be left out of the soil and the contact.",
        groups: &[
            &[&WHEEL, &PARTIAL_SOIL, &CONTACT, &ASSUME],
            CIRCLES,
            &[&METHOD_OF_FIT],
            STRESSES,
            LAMBDAS,
            &[&SLIP_SINKAGE_OF_FIT, &FIT, &DATA, &STANDARD_DEVIATION, &START, &BOUNDS_FIELD, &STARTS, &LOSS, &ESTIMATOR],
        ],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let estimator = object.or_default(&ESTIMATOR);
        let fitted = object.required(&FIT);
        let starts = unknowns::starts(object, fitted.as_deref());
        let bounds = unknowns::bounds(object, fitted.as_deref());
        let count = object.or_default(&STARTS);
        let loss = object.or_default(&LOSS);
        // Where `fit` itself is wrong, nothing of the soil is asked for that may have been meant.
        let anything: Vec<Unknown> = Unknown::ALL.into_iter().filter(|&unknown| unknown != Unknown::STATIC_SINKAGE).collect();
        let data = object.required(&DATA);
        let sought = setup::Sought {
            fitted: fitted.as_deref().unwrap_or(&anything),
            starts: &starts,
            needs_law: estimator != Some(Estimator::Linear),
        };
        let found = setup::read(object, &sought, data.as_ref());
        let observations = data.as_ref().and_then(|data| observations(object, data, found.wheel.as_ref()));
        let (Found { setup, law, measured, unused, .. }, fitted) = (found, fitted?);
        let (setup, law) = (setup?, law?);
        if estimator? == Estimator::Linear {
            let case = LinearCase { setup, observations: observations?, law_known: law != LawOrigin::Absent, unused };
            return linear::check(object, &fitted, &case).then(|| Self::Linear(Box::new(case)));
        }
        let sought: Option<Vec<Sought>> =
            (0..fitted.len()).map(|i| sought_of(object, (i, &fitted), &setup, &starts, &bounds)).collect();
        let (sought, observations) = (sought?, observations?);
        check_columns(object, &data?, &setup, &observations)?;
        let options = FitOptions { starts: count? as u32, loss: loss?, evaluations: EVALUATIONS, until: None };
        let law_replaced = law == LawOrigin::Replaced;
        Some(Self::Fit(Box::new(FitCase { setup, observations, sought, options, law_replaced, measured, unused })))
    }
}

fn observations(object: &Reader<'_>, data: &Reader<'_>, wheel: Option<&Wheel>) -> Option<Observations> {
    let deviations = object.optional(&STANDARD_DEVIATION)?;
    data::read(data, deviations.as_ref(), wheel)
}

/// One parameter with its bounds and its start.
fn sought_of(
    object: &Reader<'_>,
    (i, fitted): (usize, &[Unknown]),
    setup: &Setup,
    starts: &By<f64>,
    bounds: &By<Range>,
) -> Option<Sought> {
    let unknown = *fitted.get(i)?;
    let Some(known) = unknown.value(setup) else {
        object.place_of(&FIT).item(i).fault(format_args!(
            "the law, the contact or the method of the request has no `{}`{}",
            unknown.name(),
            fitted_law::home_of(unknown, setup)
        ));
        return None;
    };
    let given = unknowns::of(starts, unknown);
    let start = given.unwrap_or(known);
    let usual = within_soil(unknown, setup, fitted);
    if usual.upper <= usual.lower {
        let detail =
            format_args!("an interface has at most the strength of the soil, and this one has none: `{}` is 0", unknown.name());
        object.place_of(&FIT).item(i).fault(detail);
        return None;
    }
    // A start outside what is usual widens it.
    let widened = Range::new(usual.lower.min(start), usual.upper.max(start));
    let bounds = unknowns::of(bounds, unknown).unwrap_or(widened);
    if given.is_some() && !bounds.contains(start) {
        object.place().field(START.name).field(unknown.name()).fault("lies outside its bounds");
        return None;
    }
    // What is known of the soil is only a hint; where the bounds exclude it the search begins at the nearer one.
    Some(Sought { unknown, bounds, start: start.clamp(bounds.lower, bounds.upper) })
}

/// The bounds of an unknown; those of an interface end at the strength of the soil, where that is known.
fn within_soil(unknown: Unknown, setup: &Setup, fitted: &[Unknown]) -> Range {
    let usual = unknown.bounds();
    let soils = match unknown {
        Unknown::INTERFACE_FRICTION_ANGLE => Unknown::FRICTION_ANGLE,
        Unknown::INTERFACE_ADHESION => Unknown::COHESION,
        _ => return usual,
    };
    let strength = soils.value(setup).filter(|_| !fitted.contains(&soils));
    Range::new(usual.lower, strength.map_or(usual.upper, |strength| usual.upper.min(strength)))
}

/// Whether the columns serve the source of the sinkage, and something is left to be fitted.
fn check_columns(object: &Reader<'_>, data: &Reader<'_>, setup: &Setup, observations: &Observations) -> Option<()> {
    if setup.sinkage == SinkageSource::Load
        && let Some(column) = observations.column(Quantity::Normal)
        && let Some(row) = column.values.iter().position(|&load| load <= 0.0)
    {
        let place = data.place_of(&data::NORMAL).item(row);
        place.fault("is not greater than 0, and without `sinkage_m` it is the load");
        return None;
    }
    let fitted = observations.fitted(&setup.sinkage);
    if fitted.is_empty() {
        let detail = "has no column to fit: needs `longitudinal_force_n`, `torque_n_m` or, beside `sinkage_m`, `normal_force_n`";
        data.place().fault(detail);
        return None;
    }
    let has_deviation = |quantity: &Quantity| observations.column(*quantity).is_some_and(|column| column.deviation.is_some());
    if fitted.iter().any(has_deviation) {
        let lacking: Vec<&Quantity> = fitted.iter().filter(|quantity| !has_deviation(quantity)).collect();
        let around = object.place_of(&STANDARD_DEVIATION);
        for quantity in &lacking {
            around.field(column_name(**quantity)).fault("is lacking: other fitted columns have one");
        }
        return lacking.is_empty().then_some(());
    }
    Some(())
}

/// What the model or the fit refuses of a request whose fields are each right.
pub(crate) fn fit_fault(error: &FitError, source: &SinkageSource) -> FieldFault {
    let pointer = match error {
        FitError::Refused { row, error } => refusal_pointer(*row, error, source),
        FitError::Size(quantity) => format!("/data/{}", column_name(*quantity)),
        _ => "/data".to_owned(),
    };
    FieldFault::new(pointer, error)
}

/// The field to which a refusal of the model at one row belongs.
pub(crate) fn refusal_pointer(row: usize, error: &Error, source: &SinkageSource) -> String {
    match error {
        Error::SinkageOutsideWheel { .. } if matches!(source, SinkageSource::Measured | SinkageSource::UnderLoad) => {
            format!("/data/sinkage_m/{row}")
        }
        Error::LoadNotCoupled { .. } if *source == SinkageSource::UnderLoad => format!("/data/normal_load_n/{row}"),
        Error::LoadBeyondCapacity { .. } | Error::LoadNotBalanced { .. } | Error::LoadNotCoupled { .. } => {
            format!("/data/normal_force_n/{row}")
        }
        Error::PeakOutsideContact { .. } => "/contact".to_owned(),
        Error::InterfaceBeyondSoil { .. } => "/contact/interface".to_owned(),
        Error::ModulusNotPositive { .. } | Error::ExponentNotPositive { .. } => "/soil".to_owned(),
        _ => "/data".to_owned(),
    }
}
