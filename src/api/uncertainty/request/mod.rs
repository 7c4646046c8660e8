//! The request of `/v1/uncertainty`.

mod asked;
mod conditions;
mod distribution;
mod inputs;
mod matrix;
mod nominal;
mod posterior;

use terramechanics_reading::{Assumption, Field, Flag, Label, Number, Object, Path, Reader, Word};
use terramechanics_uncertainty::{Design, LEAST_SAMPLES, MOST_SEED};

use crate::api::either::{self, Of};
use crate::api::forces::ForcesCase;
use crate::api::sweep::request::axes::{self, Axis};
use crate::api::vehicle::VehicleCase;
use crate::catalogue::Held;
use crate::request::{Documented, Request};
use crate::varied::{Template, Varied};
use asked::{Asked, fault_of_spread};
pub(super) use conditions::{Condition, Side};
pub(super) use distribution::{form_of, form_of_samples};
use inputs::Uncertain;
pub(super) use inputs::{Origin, UncertainField};

/// Most samples.
const MOST_SAMPLES: usize = 16_384;
/// Most evaluations at one value of the axis: all their numbers are kept until it is done.
const MOST_AT_ONCE: usize = 1 << 17;
/// Most evaluations in all.
const MOST_EVALUATIONS: usize = 1_000_000;
/// Most values of the axis.
const MOST_ON_AXIS: usize = 201;

const OF: Field<Word<Of>> =
    either::of("What is computed of each sample: forces, as by /v1/forces, or vehicle, a rover on one slope, as by /v1/vehicle.");
const REQUEST: Field<Asked> = Field::required(
    "request",
    "The request that is asked with each sample, as that operation takes it; an uncertain field may be left out. Its `soil` may have \"spread\": \"catalogue\" beside its preset: then cohesion, friction angle, shear modulus and pressure–sinkage law spread over what is published of soils of that kind, save those that the soil or `inputs` have.",
    Asked { requests: either::REQUESTS.requests },
);
const AXIS: Field<&Object> =
    Field::new("axis", "A field that varies, of at most 201 values: there are bands at each, of the same samples.", &axes::AXIS);
const SAMPLES: Field<Number> = Field::new(
    "samples",
    "Number of samples; a power of two fills the space of the inputs most evenly.",
    Number::new("1", LEAST_SAMPLES as f64, MOST_SAMPLES as f64).whole().or(1024.0),
);
const SEED: Field<Number> = Field::new(
    "seed",
    "The same seed gives the same samples, on every machine.",
    Number::new("1", 0.0, MOST_SEED as f64).whole().or(0.0),
);
const SENSITIVITY: Field<Flag> = Field::new(
    "sensitivity",
    "false: no sensitivities. They take 2 + n times as many evaluations, where n is the number of inputs that are independent of one another.",
    Flag,
);
const SENSITIVITY_OF: Field<Label> =
    Field::new("sensitivity_of", "The one quantity whose sensitivities are asked for; else those of all.", Label);

/// Uncertainty, checked.
pub(crate) enum UncertaintyCase {
    Forces(Box<Uncertainty<ForcesCase>>),
    Vehicle(Box<Uncertainty<VehicleCase>>),
}

/// A request with uncertain fields.
pub(crate) struct Uncertainty<R> {
    pub(super) template: Template<R>,
    pub(super) design: Design,
    pub(super) seed: u32,
    pub(super) fields: Vec<UncertainField>,
    /// Values that were assumed for distributions that are relative to them.
    pub(super) assumed: Vec<Assumption>,
    /// What of a soil does not spread.
    pub(super) held: Vec<Held>,
    pub(super) axis: Option<Axis>,
    pub(super) conditions: Vec<Condition>,
    pub(super) has_sensitivities: bool,
    /// The one column that has sensitivities; else all have.
    pub(super) sensitive: Option<usize>,
    /// A case, for what all have in common.
    pub(super) sample: R,
}

impl<R> Uncertainty<R> {
    /// Evaluations in all.
    pub(super) fn evaluations(&self) -> usize {
        self.design.rows() * self.axis.as_ref().map_or(1, |axis| axis.steps.len())
    }
}

pub(super) type UncertaintyRequest = Documented<UncertaintyCase>;

impl Request for UncertaintyCase {
    const OBJECT: &'static Object = &Object {
        name: "UncertaintyRequest",
        doc: "A request for forces or of a rover of which some fields are uncertain, at a point or over one axis.",
        groups: &[&[
            &OF,
            &REQUEST,
            &inputs::INPUTS,
            &inputs::CORRELATION,
            &posterior::POSTERIOR,
            &AXIS,
            &SAMPLES,
            &SEED,
            &conditions::CONDITIONS,
            &SENSITIVITY,
            &SENSITIVITY_OF,
        ]],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        match object.required(&OF) {
            Some(Of::Forces) => uncertainty(object).map(|read| Self::Forces(Box::new(read))),
            Some(Of::Vehicle) => uncertainty(object).map(|read| Self::Vehicle(Box::new(read))),
            None => {
                let _ = object.required(&REQUEST);
                None
            }
        }
    }
}

/// The uncertainty of one kind of request.
fn uncertainty<R: Varied>(object: &Reader<'_>) -> Option<Uncertainty<R>> {
    let request = object.required(&REQUEST);
    let uncertain = Uncertain::read(object, R::OBJECT, request.as_ref().map(|request| &request.tree));
    let axis = axis(object, R::OBJECT);
    let (samples, seed) = (object.or_default(&SAMPLES), object.or_default(&SEED));
    let (sensitivity, sensitivity_of) = (object.optional(&SENSITIVITY), object.optional(&SENSITIVITY_OF));
    let (Some(request), Some(mut uncertain), Some(axis)) = (request, uncertain, axis) else {
        let _ = conditions::read(object, None);
        return None;
    };
    let mut taken = uncertain.paths();
    taken.extend(axis.iter().map(|axis| axis.path.clone()));
    let mut held = Vec::new();
    if let Some(spread) = request.spread(&taken) {
        held.clone_from(&spread.held);
        uncertain.add_spread(spread)?;
    }
    if uncertain.is_empty() {
        match held.first() {
            Some(first) => fault_of_spread(&object.place_of(&REQUEST), &format!("has nothing to take: {}", first.reason)),
            None => object
                .place_of(&inputs::INPUTS)
                .fault("must have a field that is uncertain, unless there is a `posterior` or the soil has a `spread`"),
        }
        return None;
    }
    let inputs = uncertain.inputs(object);
    let has_sensitivities = sensitivity?.unwrap_or(true);
    let seed = seed? as u32;
    let design = Design::new(inputs?, samples? as usize, seed).ok()?;
    let design = if has_sensitivities { design.with_sensitivities() } else { design };
    fits(object, &design, axis.as_ref())?;
    let (template, sample) = template::<R>(object, &request.tree, &uncertain, axis.as_ref(), &design)?;
    let columns = sample.columns();
    let conditions = conditions::read(object, Some(&columns));
    let sensitive = match sensitivity_of? {
        Some(name) => Some(conditions::column(name, &columns, &object.place_of(&SENSITIVITY_OF))?),
        None => None,
    };
    Some(Uncertainty {
        template,
        design,
        seed,
        fields: uncertain.fields,
        assumed: uncertain.assumed,
        held,
        axis,
        conditions: conditions?,
        has_sensitivities,
        sensitive,
        sample,
    })
}

/// The axis, if there is one.
fn axis(object: &Reader<'_>, request: &'static Object) -> Option<Option<Axis>> {
    let Some(axis) = object.optional(&AXIS)? else { return Some(None) };
    let read = axes::read_one(&axis, request)?;
    if read.steps.len() > MOST_ON_AXIS {
        object.place_of(&AXIS).fault(format_args!("must have at most {MOST_ON_AXIS} values, not {}", read.steps.len()));
        return None;
    }
    Some(Some(read))
}

/// Whether the evaluations are not too many.
fn fits(object: &Reader<'_>, design: &Design, axis: Option<&Axis>) -> Option<()> {
    let values = axis.map_or(1, |axis| axis.steps.len());
    let (at_once, all) = (design.rows(), design.rows() * values);
    let (count, most) = if at_once > MOST_AT_ONCE { (at_once, MOST_AT_ONCE) } else { (all, MOST_EVALUATIONS) };
    if count <= most {
        return Some(());
    }
    let advice = if values > 1 {
        "take fewer values of `axis`, fewer samples or no sensitivities"
    } else {
        "take fewer samples, fewer inputs or no sensitivities"
    };
    object.place_of(&SAMPLES).fault(format_args!("make {count} evaluations; at most {most} are computed: {advice}"));
    None
}

/// Samples that are tried for one that makes a valid request.
const TRIED: usize = 64;

/// The template of the request, and a case of it.
fn template<R: Varied>(
    object: &Reader<'_>,
    tree: &terramechanics_reading::Node<'_>,
    uncertain: &Uncertain,
    axis: Option<&Axis>,
    design: &Design,
) -> Option<(Template<R>, R)> {
    let mut paths: Vec<Path> = uncertain.paths();
    paths.extend(axis.map(|axis| axis.path.clone()));
    let tried: Vec<Vec<f64>> = (0..TRIED)
        .filter_map(|i| {
            let mut row = design.row(i)?;
            row.extend(axis.map(|axis| axis.steps.at(i * axis.steps.len() / TRIED)));
            Some(row)
        })
        .collect();
    let found = Template::<R>::new(tree, &paths).and_then(|mut template| {
        let sample = template.first_case(tried.iter().map(Vec::as_slice))?;
        Ok((template, sample))
    });
    let faults = match found {
        Ok((template, Some(sample))) => match sample.refusal() {
            None => return Some((template, sample)),
            Some(fault) => {
                object.place_of(&REQUEST).pass_on(fault);
                return None;
            }
        },
        Ok((_, None)) => {
            object.place_of(&REQUEST).fault(format_args!("makes no valid request with any of the first {TRIED} samples"));
            return None;
        }
        Err(faults) => faults,
    };
    for fault in faults {
        let detail = &fault.fault.detail;
        match fault.field.map(|at| uncertain.fields.get(at)) {
            Some(Some(UncertainField { origin: Origin::Request(place), .. })) => inputs::fault_of_field(object, *place, detail),
            Some(Some(UncertainField { origin: Origin::Posterior(estimate), .. })) => {
                posterior::fault_of_parameter(object, *estimate, detail);
            }
            Some(Some(_)) => fault_of_spread(&object.place_of(&REQUEST), &format!("`{}` {detail}", fault.fault.pointer)),
            Some(None) => object.place_of(&AXIS).field(axes::FIELD.name).fault(detail),
            None => object.place_of(&REQUEST).pass_on(fault.fault),
        }
    }
    None
}
