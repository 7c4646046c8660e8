//! The answer of `/v1/uncertainty`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics_uncertainty::{Marginal, Source};
use utoipa::ToSchema;

use super::columns::{BandColumns, IndexColumns, ProbabilityColumns, StatusColumns, band, index, probability, status};
use super::found::FoundBands;
use super::request::{Origin, Side, UncertainField, Uncertainty, form_of, form_of_samples};
use crate::catalogue::Held;
use crate::quantity::{About, Columns};
use crate::reply::{AssumedReply, Reply};
use crate::warning::Warning;

/// What the uncertain fields make of the answers of an operation.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Uncertainty)]
pub(crate) struct UncertaintyReply {
    /// Number of samples.
    samples: usize,
    /// Number of evaluations at each value of the axis, with those for the sensitivities.
    evaluations: usize,
    /// The seed: the same gives the same samples.
    seed: u32,
    /// The uncertain fields and their distributions.
    inputs: Vec<InputReply>,
    /// What of a soil with a spread keeps its value; absent without a spread.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(required = false)]
    held: Vec<HeldReply>,
    /// The axis; absent where there is none, and each column then has one value.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    axis: Option<AxisReply>,
    /// How the samples ended.
    status: StatusColumns,
    /// Mean, deviation and quantiles of each quantity.
    bands: Vec<BandReply>,
    /// The probabilities of the conditions, in their order.
    conditions: Vec<ConditionReply>,
    /// Which inputs decide, for each quantity; none where `sensitivity` is false.
    sensitivities: Vec<SensitivityReply>,
    warnings: Vec<Warning>,
    /// What was assumed; absent where the request did not allow it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    assumed: Option<Vec<AssumedReply>>,
}

/// An uncertain field.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = UncertainInputFound)]
struct InputReply {
    /// Its JSON pointer.
    field: String,
    /// The form of its distribution.
    distribution: &'static str,
    /// Mean of the distribution, before anything is cut off.
    mean: f64,
    /// Its standard deviation, before anything is cut off.
    standard_deviation: f64,
    /// The quantiles or samples that were taken; absent where the distribution has none, and where the request has them.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    values: Option<Vec<f64>>,
    /// Share of the distribution outside the bounds of the field, which is cut off.
    share_cut: f64,
    /// Where it comes from: `request`, `posterior` or `catalogue`.
    from: &'static str,
    /// Why these values were taken from the catalogue; absent for what the request has.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    reason: Option<String>,
    /// The soils of the catalogue that have the values, in their order.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(required = false)]
    soils: Vec<&'static str>,
}

/// What keeps its value.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = UncertainHeld)]
struct HeldReply {
    /// The field of the soil.
    field: &'static str,
    /// Why.
    reason: String,
}

/// The axis of the bands.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = UncertainAxis)]
struct AxisReply {
    /// Its JSON pointer.
    field: String,
    /// Its values.
    values: Vec<f64>,
}

/// The bands of a quantity.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = UncertainBand)]
struct BandReply {
    /// The quantity.
    quantity: &'static str,
    columns: BandColumns,
}

/// The probability of a condition.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = UncertainProbability)]
struct ConditionReply {
    /// The quantity.
    quantity: &'static str,
    /// The condition holds below this value.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    below: Option<f64>,
    /// It holds above this value.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    above: Option<f64>,
    columns: ProbabilityColumns,
}

/// How far inputs decide a quantity.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = UncertainSensitivity)]
struct SensitivityReply {
    /// The quantity.
    quantity: &'static str,
    /// The field, or the fields that belong together by correlation or joint samples: only together do they have a share.
    fields: Vec<String>,
    columns: IndexColumns,
}

impl UncertaintyReply {
    /// What was found of a case.
    pub(super) fn of<R>(case: &Uncertainty<R>, found: FoundBands) -> Self {
        let FoundBands { columns, banded, sensitive, points, warnings, assumed } = found;
        let name = |column: usize| -> &'static str { columns.get(column).map_or("", |about: &&'static About| about.name) };
        let bands = banded.iter().enumerate().map(|(i, &column)| BandReply {
            quantity: name(column),
            columns: band(points.iter().map(|point| point.bands[i].as_ref())),
        });
        let conditions = case.conditions.iter().enumerate().map(|(i, condition)| ConditionReply {
            quantity: name(condition.column),
            below: (condition.side == Side::Below).then_some(condition.limit),
            above: (condition.side == Side::Above).then_some(condition.limit),
            columns: probability(points.iter().map(|point| point.probabilities[i])),
        });
        let groups = case.design.inputs().groups();
        let of_group = |group: &[usize]| -> Vec<String> {
            case.fields.iter().filter(|field| group.contains(&field.source)).map(|field| field.path.pointer()).collect()
        };
        let sensitivities = sensitive.iter().enumerate().flat_map(|(i, &column)| {
            let points = &points;
            let of_group = &of_group;
            groups.iter().enumerate().map(move |(group, sources)| SensitivityReply {
                quantity: name(column),
                fields: of_group(sources),
                columns: index(points.iter().map(|point| point.sensitivities[i].get(group)?.as_ref())),
            })
        });
        Self {
            samples: case.design.samples(),
            evaluations: case.design.rows(),
            seed: case.seed,
            inputs: case
                .fields
                .iter()
                .map(|field| InputReply::of(field, &case.design.inputs().sources()[field.source]))
                .collect(),
            held: case.held.iter().cloned().map(|Held { field, reason }| HeldReply { field, reason }).collect(),
            axis: case.axis.as_ref().map(|axis| AxisReply {
                field: axis.path.pointer(),
                values: (0..axis.steps.len()).map(|i| axis.steps.at(i)).collect(),
            }),
            bands: bands.collect(),
            conditions: conditions.collect(),
            sensitivities: sensitivities.collect(),
            status: status(points.iter().map(|point| point.statuses)),
            warnings,
            assumed: assumed.map(|assumed| assumed.into_iter().map(AssumedReply::from).collect()),
        }
    }
}

impl InputReply {
    fn of(field: &UncertainField, source: &Source) -> Self {
        let (reason, soils) = match &field.origin {
            Origin::Request(_) | Origin::Posterior(_) => (None, Vec::new()),
            Origin::Catalogue { reason, soils } => (Some(reason.clone()), soils.clone()),
        };
        let is_of_catalogue = reason.is_some();
        let (distribution, [mean, standard_deviation], share_cut, values) = match source {
            Source::One(marginal) => {
                let whole: &Marginal = marginal;
                let distribution = whole.distribution();
                let moments = [distribution.mean(), distribution.deviation()];
                (form_of(distribution), moments, whole.share_cut(), distribution.values())
            }
            Source::Joint(joint) => {
                let (mean, deviation) = (joint.mean(field.column), joint.deviation(field.column));
                (form_of_samples(), [mean, deviation], 0.0, joint.column(field.column))
            }
        };
        Self {
            field: field.path.pointer(),
            distribution,
            mean,
            standard_deviation,
            values: values.filter(|_| is_of_catalogue).map(<[f64]>::to_vec),
            share_cut,
            from: match field.origin {
                Origin::Request(_) => "request",
                Origin::Posterior(_) => "posterior",
                Origin::Catalogue { .. } => "catalogue",
            },
            reason,
            soils,
        }
    }
}

/// The name of a field in a table.
fn dotted(pointer: &str) -> String {
    pointer.trim_start_matches('/').replace('/', ".")
}

/// Columns under the name of what they are about.
fn under<'r, S>(around: &str, columns: &'r Columns<S>) -> impl Iterator<Item = (Cow<'static, str>, &'r [f64])> {
    columns.named().map(move |(name, column)| (format!("{around}.{name}").into(), column))
}

impl Reply for UncertaintyReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let mut table: Vec<(Cow<'static, str>, &[f64])> = Vec::new();
        table.extend(self.axis.iter().map(|axis| (dotted(&axis.field).into(), axis.values.as_slice())));
        table.extend(under("status", &self.status));
        for BandReply { quantity, columns } in &self.bands {
            table.extend(under(quantity, columns));
        }
        for ConditionReply { quantity, below, above, columns } in &self.conditions {
            let sides = [("below", below), ("above", above)];
            for (side, limit) in sides.into_iter().filter_map(|(side, limit)| Some((side, (*limit)?))) {
                table.extend(under(&format!("{quantity}.{side}.{limit}"), columns));
            }
        }
        for SensitivityReply { quantity, fields, columns } in &self.sensitivities {
            let fields: Vec<String> = fields.iter().map(|field| dotted(field)).collect();
            table.extend(under(&format!("{quantity}.{}", fields.join("+")), columns));
        }
        table
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    fn warn(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }
}
