//! The request of `/v1/identify`.

mod data;
mod setup;
mod unknowns;

use terramechanics::{Error, ShearLaw, Wheel};
use terramechanics_identification::{
    FitError, FitOptions, Loss, MOST_STARTS, Observations, Quantity, Range, Setup, SinkageSource, Sought, Unknown,
};

pub(crate) use data::{DataDto, DeviationsDto, column_name};
pub(crate) use unknowns::{BoundsDto, StartDto, name_of};

use super::operation;
use super::{ContactDto, Request, SlipSinkageDto, SoilDto, WheelDto};
use crate::wire::{Choice, FieldFault, Lambda, Names, NamesSpec, Nested, Number, Scope, wire_object};

const PARAMETER: Choice = Choice { doc: "Name of a parameter.", words: unknowns::names, default: None };

wire_object! {
    /// Measurements of a wheel, and which parameters to find from them; what is not fitted has to be known, what is fitted may be left out of the soil and the contact.
    IdentifyDto as "IdentifyRequest" {
        wheel: WheelDto = operation::WHEEL,
        soil: SoilDto = Nested::optional("What is known of the soil; fitted fields may be absent, and are starts where they are not."),
        contact: ContactDto = operation::CONTACT,
        method: String = operation::METHOD,
        normal_stress_radius: String = operation::NORMAL_STRESS_RADIUS,
        peak_sinkage: String = operation::PEAK_SINKAGE,
        lambda_a: Lambda = operation::LAMBDA_A,
        lambda_b: Lambda = operation::LAMBDA_B,
        slip_sinkage: SlipSinkageDto = Nested::optional("Slip–sinkage law where static_sinkage_m is fitted; lyasko unless given."),
        fit: Names = NamesSpec { doc: "The parameters to find.", word: PARAMETER, most: 13, all_unless_given: false },
        data: DataDto = Nested::required("What was measured."),
        standard_deviation: DeviationsDto = Nested::optional("Standard deviations; without them every column counts by its size. By least_squares only their ratios count: the errors follow from the residuals. A robust loss takes the residuals in units of them."),
        start: StartDto = Nested::optional("Where the search begins."),
        bounds: BoundsDto = Nested::optional("Bounds of the parameters."),
        starts: f64 = Number::new("Starts that are tried; the further ones are spread over what soils have.", 1.0, MOST_STARTS as f64).integer().or(1.0),
        loss: String = Choice {
            doc: "What a residual costs: its square, or less than that where it is an outlier.",
            words: || vec!["least_squares", "huber", "soft_l1", "cauchy"],
            default: Some("least_squares"),
        },
        estimator: String = Choice {
            doc: "nonlinear: any parameters by any method. linear: cohesion_pa and friction_angle_rad from torque, load, slip and sinkage in one pass (Iagnemma et al. 2004), for linear stresses, which bias both; needs the soil's shear_modulus_m, takes contact and normal_stress_radius, and no pressure–sinkage law; with one, each estimate has its model_bias.",
            words: || vec!["nonlinear", "linear"],
            default: Some("nonlinear"),
        },
    }
}

/// A fit, checked.
pub(crate) struct FitQuery {
    pub(crate) setup: Setup,
    pub(crate) observations: Observations,
    pub(crate) sought: Vec<Sought>,
    pub(crate) options: FitOptions,
    /// Whether the preset's law gave way to the direct one, whose modulus is fitted.
    pub(crate) law_replaced: bool,
}

/// A linear estimate, checked: slip, sinkage, a load and torque were measured.
pub(crate) struct LinearQuery {
    pub(crate) setup: Setup,
    pub(crate) observations: Observations,
    /// Whether the pressure–sinkage law of the setup is that of the soil.
    pub(crate) law_known: bool,
}

/// What is asked for.
pub(crate) enum IdentifyQuery {
    Fit(Box<FitQuery>),
    Linear(Box<LinearQuery>),
}

/// Evaluations of the forces that a fit may take: five parameters of as many samples as are taken need a tenth of it.
const EVALUATIONS: u64 = 20_000_000;

impl Request for IdentifyDto {
    type Query = IdentifyQuery;

    fn check(&self, place: &Scope<'_>) -> Option<IdentifyQuery> {
        let is_linear = self.estimator().looked_up(place, |word| match word {
            "linear" => Some(true),
            "nonlinear" => Some(false),
            _ => None,
        });
        let is_linear = if self.estimator().is_present() { is_linear } else { Some(false) };
        let fitted = self.fit().looked_up(place, unknowns::named);
        let starts = self.start().given(place).map(|dto| dto.check(&place.field("start"), fitted.as_deref())).unwrap_or_default();
        let bounds =
            self.bounds().given(place).map(|dto| dto.check(&place.field("bounds"), fitted.as_deref())).unwrap_or_default();
        let count = self.starts().or_default(place);
        let loss = self.checked_loss(place);
        // Where `fit` itself is wrong, nothing of the soil is asked for that may have been meant.
        let anything: Vec<Unknown> = Unknown::ALL.into_iter().filter(|&unknown| unknown != Unknown::StaticSinkage).collect();
        let needs_law = is_linear != Some(true);
        let setup = self.setup(place, fitted.as_deref().unwrap_or(&anything), &starts, needs_law);
        let observations = self.observations(place, setup.as_ref().map(|(setup, _)| &setup.wheel));
        let (setup, law) = setup?;
        let fitted = fitted?;
        if is_linear? {
            let query = LinearQuery { setup, observations: observations?, law_known: law.known };
            return self.linear(place, &fitted, query);
        }
        let sought: Option<Vec<Sought>> =
            fitted.iter().enumerate().map(|(i, &unknown)| self.sought(place, i, unknown, &setup, &starts, &bounds)).collect();
        let (sought, observations) = (sought?, observations?);
        self.check_columns(place, &setup, &observations)?;
        let options = FitOptions { starts: count? as u32, loss: loss?, evaluations: EVALUATIONS, until: None };
        Some(IdentifyQuery::Fit(Box::new(FitQuery { setup, observations, sought, options, law_replaced: law.replaced })))
    }
}

impl IdentifyDto {
    fn checked_loss(&self, place: &Scope<'_>) -> Option<Loss> {
        let entry = self.loss();
        if !entry.is_present() {
            return Some(Loss::LeastSquares);
        }
        entry.looked_up(place, |word| match word {
            "least_squares" => Some(Loss::LeastSquares),
            "huber" => Some(Loss::Huber),
            "soft_l1" => Some(Loss::SoftL1),
            "cauchy" => Some(Loss::Cauchy),
            _ => None,
        })
    }

    fn observations(&self, place: &Scope<'_>, wheel: Option<&Wheel>) -> Option<Observations> {
        let data = self.data().required(place)?;
        let around = place.field("standard_deviation");
        let deviations = self.standard_deviation().given(place).map(|dto| (dto, &around));
        if self.standard_deviation().is_present() && deviations.is_none() {
            return None;
        }
        data.check(&place.field("data"), deviations, wheel)
    }

    /// One parameter with its bounds and its start.
    fn sought(
        &self,
        place: &Scope<'_>,
        i: usize,
        unknown: Unknown,
        setup: &Setup,
        starts: &[(Unknown, f64)],
        bounds: &[(Unknown, Range)],
    ) -> Option<Sought> {
        let Some(known) = unknown.value(setup) else {
            place.field("fit").item(i).fault(format_args!(
                "the law, the contact or the method of the request has no `{}`{}",
                name_of(unknown),
                home_of(unknown)
            ));
            return None;
        };
        let given = starts.iter().find(|(known, _)| *known == unknown).map(|(_, value)| *value);
        let start = given.unwrap_or(known);
        let usual = unknown.bounds();
        let bounds = match bounds.iter().find(|(known, _)| *known == unknown) {
            Some((_, bounds)) => *bounds,
            // A start outside what is usual widens it.
            None => Range::new(usual.lower.min(start), usual.upper.max(start)),
        };
        if given.is_some() && !bounds.contains(start) {
            place.field("start").field(name_of(unknown)).fault("lies outside its bounds");
            return None;
        }
        // What is known of the soil is only a hint; where the bounds exclude it the search begins at the nearer one.
        Some(Sought { unknown, bounds, start: start.clamp(bounds.lower, bounds.upper) })
    }

    /// Whether the columns serve the source of the sinkage, and something is left to be fitted.
    fn check_columns(&self, place: &Scope<'_>, setup: &Setup, observations: &Observations) -> Option<()> {
        let data = place.field("data");
        if setup.sinkage == SinkageSource::Load
            && let Some(column) = observations.column(Quantity::Normal)
            && let Some(row) = column.values.iter().position(|&load| load <= 0.0)
        {
            data.field("normal_force_n").item(row).fault("is not greater than 0, and without `sinkage_m` it is the load");
            return None;
        }
        let fitted = observations.fitted(&setup.sinkage);
        if fitted.is_empty() {
            data.fault(
                "has no column to fit: needs `longitudinal_force_n`, `torque_n_m` or, beside `sinkage_m`, `normal_force_n`",
            );
            return None;
        }
        let has_deviation = |quantity: &Quantity| observations.column(*quantity).is_some_and(|column| column.deviation.is_some());
        if fitted.iter().any(has_deviation) {
            let lacking: Vec<&Quantity> = fitted.iter().filter(|quantity| !has_deviation(quantity)).collect();
            for quantity in &lacking {
                place
                    .field("standard_deviation")
                    .field(column_name(**quantity))
                    .fault("is lacking: other fitted columns have one");
            }
            return lacking.is_empty().then_some(());
        }
        Some(())
    }

    /// The linear estimate: what it needs and what it cannot take is reported.
    fn linear(&self, place: &Scope<'_>, fitted: &[Unknown], query: LinearQuery) -> Option<IdentifyQuery> {
        let LinearQuery { setup, observations, .. } = &query;
        let mut sound = true;
        let mut report = |place: Scope<'_>, detail: &str| {
            place.fault(detail);
            sound = false;
        };
        if !(fitted.len() == 2 && fitted.contains(&Unknown::Cohesion) && fitted.contains(&Unknown::FrictionAngle)) {
            report(place.field("fit"), "the linear estimator finds `cohesion_pa` and `friction_angle_rad`, both and no other");
        }
        let data = place.field("data");
        for quantity in [Quantity::Sinkage, Quantity::Normal, Quantity::Torque] {
            if observations.column(quantity).is_none() {
                report(data.field(column_name(quantity)), "the linear estimator needs it");
            }
        }
        if let Some(loads) = observations.column(Quantity::Normal)
            && let Some(row) = loads.values.iter().position(|&load| load <= 0.0)
        {
            report(
                data.field(column_name(Quantity::Normal)).item(row),
                "is not greater than 0: the linear estimator takes it as the load",
            );
        }
        if self.method().given(place).is_some_and(|method| method != "linearised") {
            report(place.field("method"), "has no meaning for the linear estimator, whose stresses are those of `linearised`");
        }
        for (name, is_present) in [
            ("start", self.start().is_present()),
            ("bounds", self.bounds().is_present()),
            ("starts", self.starts().is_present()),
            ("loss", self.loss().is_present()),
            ("peak_sinkage", self.peak_sinkage().is_present()),
            ("lambda_a", self.lambda_a().is_present()),
            ("lambda_b", self.lambda_b().is_present()),
            ("standard_deviation", self.standard_deviation().is_present()),
        ] {
            if is_present {
                report(place.field(name), "has no meaning for the linear estimator");
            }
        }
        if !matches!(setup.soil.shear, Some(ShearLaw::JanosiHanamoto(_))) {
            report(place.field("soil").field("shear"), "the linear estimator needs janosi_hanamoto");
        }
        sound.then(|| IdentifyQuery::Linear(Box::new(query)))
    }
}

/// Where a parameter belongs, for a message.
fn home_of(unknown: Unknown) -> &'static str {
    match unknown {
        Unknown::SinkageModulus => ": fit `k_c` and `k_phi`, or choose the law `direct`",
        Unknown::CohesiveModulus | Unknown::FrictionalModulus => ": fit `k_s`, or choose the law `bekker` or `reece`",
        Unknown::PeakIntercept | Unknown::PeakSlipGain => "; the contact rule `wong_reece` has it",
        Unknown::LambdaA | Unknown::LambdaB => "; the method `explicit` with a number for it has it",
        Unknown::ShearModulus => "; the shear law `janosi_hanamoto` has it",
        _ => "",
    }
}

/// What the model or the fit refuses of a request whose fields are each right.
pub(crate) fn fit_fault(error: &FitError, source: &SinkageSource) -> FieldFault {
    let pointer = match error {
        FitError::Refused { row, error } => refusal_pointer(*row, error, source),
        FitError::Size(quantity) => format!("/data/{}", column_name(*quantity)),
        _ => "/data".to_owned(),
    };
    FieldFault { pointer, detail: error.to_string() }
}

/// The field to which a refusal of the model at one row belongs.
pub(crate) fn refusal_pointer(row: usize, error: &Error, source: &SinkageSource) -> String {
    match error {
        Error::SinkageOutsideWheel { .. } if *source == SinkageSource::Measured => format!("/data/sinkage_m/{row}"),
        Error::LoadBeyondCapacity { .. } | Error::LoadNotBalanced { .. } | Error::LoadNotCoupled { .. } => {
            format!("/data/normal_force_n/{row}")
        }
        Error::PeakOutsideContact { .. } => "/contact".to_owned(),
        Error::ModulusNotPositive { .. } | Error::ExponentNotPositive { .. } => "/soil".to_owned(),
        _ => "/data".to_owned(),
    }
}
