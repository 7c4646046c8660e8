//! The uncertain fields of a request, and what makes them uncertain.

use terramechanics_reading::{Assumption, Field, Label, Node, Object, Objects, Path, Reader};
use terramechanics_uncertainty::{
    Bounds, Correlation, CorrelationError, Distribution, InputError, Inputs, Joint, MOST_COLUMNS, MOST_SOURCES, Marginal, Source,
    has_size,
};

use super::distribution::{self, FORM, Given, PARAMETERS};
use super::matrix::Matrix;
use super::nominal::nominal;
use super::posterior::{self, POSTERIOR};
use crate::catalogue::{self, Spread};
use crate::varied::varied_field;

/// Most fields that a client makes uncertain. With those of a spread they are no more than a design takes.
pub(super) const MOST_INPUTS: usize = MOST_COLUMNS;

const FIELD: Field<Label> = Field::required(
    "field",
    "The field that is uncertain: the JSON pointer of any numeric field of the request, such as /soil/friction_angle_rad, whether or not the request has it.",
    Label,
);
const INPUT: Object = Object {
    name: "UncertainInput",
    doc: "A field and its distribution. What of a normal or lognormal distribution lies outside the bounds of the field is cut off, which the answer tells; more than half of it, or an end outside, is refused.",
    groups: &[&[&FIELD, &FORM], PARAMETERS],
};
pub(super) const INPUTS: Field<Objects> = Field::new(
    "inputs",
    "The fields that are uncertain; with a `posterior`, or a `spread` of the soil, there may be none.",
    Objects { object: &INPUT, fewest: 0, most: MOST_INPUTS },
);
pub(super) const CORRELATION: Field<Matrix> = Field::new(
    "correlation",
    "Correlation of `inputs`, with a row and a column for each in their order: the coefficients of their normal scores (a Gaussian copula), which for normal inputs are those of the numbers themselves. Fields with joint samples have their own correlation and 0 here.",
    Matrix { most: MOST_INPUTS },
);

/// An uncertain field.
#[derive(Debug, Clone)]
pub(crate) struct UncertainField {
    pub(crate) path: Path,
    /// The place of its source.
    pub(crate) source: usize,
    /// Its column among those of the source.
    pub(crate) column: usize,
    pub(crate) origin: Origin,
}

/// Where a distribution comes from.
#[derive(Debug, Clone)]
pub(crate) enum Origin {
    /// From that place among the inputs of the request.
    Request(usize),
    /// From that place among the estimates of the posterior.
    Posterior(usize),
    Catalogue {
        reason: String,
        soils: Vec<&'static str>,
    },
}

/// The uncertain fields in the order of the numbers of a row, and their sources.
#[derive(Default)]
pub(super) struct Uncertain {
    pub(super) fields: Vec<UncertainField>,
    sources: Vec<Source>,
    /// Of the fields of the posterior, in their order.
    posterior: Vec<Vec<f64>>,
    /// Values that were assumed, because a distribution is relative to them.
    pub(super) assumed: Vec<Assumption>,
}

/// One input that was read.
struct Read {
    path: Path,
    given: Given,
    bounds: Bounds,
    /// What was assumed for it.
    assumed: Option<Assumption>,
}

impl Uncertain {
    /// The inputs that a client sends for fields that `request` declares, of which `tree` is one.
    pub(super) fn read(object: &Reader<'_>, request: &'static Object, tree: Option<&Node<'_>>) -> Option<Self> {
        let mut found = Self::default();
        let inputs = found.read_inputs(object, request, tree);
        let posterior = posterior::read(object, request);
        inputs?;
        if let Some(posterior) = posterior? {
            for (place, (path, marginal)) in posterior.parameters.into_iter().enumerate() {
                found.push(path, Origin::Posterior(place), Source::One(marginal));
            }
            found.posterior = posterior.correlation;
        }
        Some(found)
    }

    fn read_inputs(&mut self, object: &Reader<'_>, request: &'static Object, tree: Option<&Node<'_>>) -> Option<()> {
        let Some(items) = object.optional(&INPUTS)? else { return Some(()) };
        let mut joint = Vec::new();
        let read = items.each(|input, i| {
            let Read { path, given, bounds, assumed } = read_one(input, request, tree)?;
            self.assumed.extend(assumed);
            match given {
                Given::One(distribution) => {
                    let marginal =
                        Marginal::new(distribution, bounds).map_err(|error| distribution::report(input, error)).ok()?;
                    self.push(path, Origin::Request(i), Source::One(marginal));
                }
                Given::Samples(values) => {
                    if joint.first().is_some_and(|(_, _, first): &(_, _, Vec<f64>)| first.len() != values.len()) {
                        distribution::report(input, InputError::Lengths { column: joint.len() });
                        return None;
                    }
                    joint.push((path, i, values));
                }
            }
            Some(())
        });
        read?;
        if !joint.is_empty() {
            let source = self.sources.len();
            let mut columns = Vec::with_capacity(joint.len());
            for (column, (path, place, values)) in joint.into_iter().enumerate() {
                self.fields.push(UncertainField { path, source, column, origin: Origin::Request(place) });
                columns.push(values);
            }
            // Their number and lengths were checked as they were read.
            self.sources.push(Source::Joint(Joint::new(columns).ok()?));
        }
        Some(())
    }

    fn push(&mut self, path: Path, origin: Origin, source: Source) {
        self.fields.push(UncertainField { path, source: self.sources.len(), column: 0, origin });
        self.sources.push(source);
    }

    pub(super) fn paths(&self) -> Vec<Path> {
        self.fields.iter().map(|field| field.path.clone()).collect()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.sources.is_empty()
    }

    /// Adds what spreads of a soil.
    pub(super) fn add_spread(&mut self, spread: Spread) -> Option<()> {
        for value in spread.values {
            let distribution = Distribution::Quantiles { values: value.values };
            let source = self.sources.len();
            // What the catalogue has lies within the bounds of the fields, as its tests make sure.
            self.sources.push(Source::One(Marginal::new(distribution, Bounds::NONE).ok()?));
            let origin = Origin::Catalogue { reason: value.reason, soils: value.soils };
            self.fields.push(UncertainField { path: super::asked::of_soil(value.field)?, source, column: 0, origin });
        }
        if let Some(law) = spread.law {
            let source = self.sources.len();
            self.sources.push(Source::Joint(Joint::new(law.columns).ok()?));
            for (column, parameter) in law.parameters.into_iter().enumerate() {
                let path = super::asked::of_soil(&format!("{}/{parameter}", catalogue::LAW))?;
                let origin = Origin::Catalogue { reason: law.reason.clone(), soils: law.soils.clone() };
                self.fields.push(UncertainField { path, source, column, origin });
            }
        }
        Some(())
    }

    /// The inputs of a design, with the correlations that a client sends.
    pub(super) fn inputs(&self, object: &Reader<'_>) -> Option<Inputs> {
        let matrix = object.optional(&CORRELATION)?;
        if self.sources.len() > MOST_SOURCES {
            let detail =
                format_args!("makes {} independent sources with the others; there may be {MOST_SOURCES}", self.sources.len());
            object.place_of(&POSTERIOR).fault(detail);
            return None;
        }
        let inputs = Inputs::new(self.sources.clone()).ok()?;
        if matrix.is_none() && self.posterior.is_empty() {
            return Some(inputs);
        }
        // That of a posterior was checked by itself, and both together are sound where each is.
        let place = object.place_of(&CORRELATION);
        let mut of_sources = match matrix {
            Some(matrix) => self.of_sources(&matrix).map_err(|error| place.fault(error)).ok()?,
            None => self.uncorrelated(),
        };
        let places = self.fields.iter().filter_map(|field| match field.origin {
            Origin::Posterior(place) => Some((place, field.source)),
            Origin::Request(_) | Origin::Catalogue { .. } => None,
        });
        let places: Vec<(usize, usize)> = places.collect();
        for &(row, one) in &places {
            for &(column, other) in &places {
                of_sources[one][other] = self.posterior[row][column];
            }
        }
        let correlated = Correlation::new(of_sources).and_then(|correlation| inputs.correlated(correlation));
        correlated.map_err(|error| place.fault(error)).ok()
    }

    /// The matrix of sources without correlation.
    fn uncorrelated(&self) -> Vec<Vec<f64>> {
        let count = self.sources.len();
        (0..count).map(|row| (0..count).map(|column| f64::from(u8::from(row == column))).collect()).collect()
    }

    /// The matrix of the inputs of a request as one of the sources: joint samples are one source, and what spreads is independent.
    fn of_sources(&self, matrix: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, CorrelationError> {
        let sent = |field: &UncertainField| match field.origin {
            Origin::Request(place) => Some(place),
            Origin::Posterior(_) | Origin::Catalogue { .. } => None,
        };
        let count = self.fields.iter().filter_map(sent).count();
        has_size(matrix, count)?;
        Correlation::new(matrix.to_vec())?;
        let is_joint = |source: usize| matches!(self.sources[source], Source::Joint(_));
        let mut found = self.uncorrelated();
        for one in &self.fields {
            for other in &self.fields {
                let (Some(row), Some(column)) = (sent(one), sent(other)) else { continue };
                if row == column {
                    continue;
                }
                if is_joint(one.source) && matrix[row][column] != 0.0 {
                    return Err(CorrelationError::OfJoint { row });
                }
                if !is_joint(one.source) && !is_joint(other.source) {
                    found[one.source][other.source] = matrix[row][column];
                }
            }
        }
        Ok(found)
    }
}

/// Reports a fault of the field of an input.
pub(super) fn fault_of_field(object: &Reader<'_>, input: usize, detail: &str) {
    object.place_of(&INPUTS).item(input).field(FIELD.name).fault(detail);
}

fn read_one(input: &Reader<'_>, request: &'static Object, tree: Option<&Node<'_>>) -> Option<Read> {
    let field = input.required(&FIELD).and_then(|pointer| varied_field(request, pointer, &input.place_of(&FIELD)));
    let number = field.as_ref().map(|(_, number)| number);
    if number.is_some_and(|number| number.is_whole()) {
        input.place_of(&FIELD).fault("is a whole number, which has no distribution here");
        return None;
    }
    let nominal = field.as_ref().zip(tree).and_then(|((path, _), tree)| nominal(tree, path));
    let value = nominal.as_ref().map(|(value, _)| *value);
    let given = distribution::read(input, number, value);
    let (path, number) = field?;
    let [lower, upper] = number.range();
    let assumed = nominal.and_then(|(_, assumed)| assumed).filter(|_| distribution::is_relative(input));
    Some(Read { path, given: given?, bounds: Bounds { lower, upper }, assumed })
}
