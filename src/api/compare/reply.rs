//! The answer of `/v1/compare`.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Serialize;
use utoipa::ToSchema;

use super::difference::{Difference, Spread};
use super::found::{FoundComparison, FoundSeries};
use crate::quantity::{PointColumns, Values};
use crate::reply::Reply;
use crate::request::circles::words;
use crate::warning::Warning;

/// Forces over slip by several methods and laws, how far each is from the first and from the integral, and the spread of all.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Comparison)]
pub(crate) struct CompareReply {
    /// Slip ratio s (–).
    #[schema(value_type = Vec<f64>)]
    slip: Values,
    /// One per method in the order asked for, of the request as it stands and then of each variant.
    series: Vec<Series>,
    /// By column: the highest of all series minus the lowest, in the column's unit.
    spread: BTreeMap<&'static str, Spread>,
    /// The warnings; those of some series alone have the names of these in `series`: the method, after its variant and a comma.
    warnings: Vec<Warning>,
}

/// The result of one method.
#[derive(Debug, Serialize, ToSchema)]
struct Series {
    /// Name of the variant; null for the request as it stands.
    variant: Option<String>,
    method: &'static str,
    /// Circle on which the shear displacement was counted: shearing or rim; null where the method counts none.
    #[schema(required = true, example = "shearing")]
    shear_displacement_radius: Option<&'static str>,
    /// Circle on which the slip was counted: rim, shearing or lug_tip.
    #[schema(example = "rim")]
    slip_radius: &'static str,
    /// What the normal stress follows from: the pressure–sinkage law of the soil, or the load, which was known beside the sinkage.
    #[schema(example = "soil")]
    normal_stress_from: &'static str,
    columns: PointColumns,
    /// By column: the difference from the first series, in the column's unit.
    difference: BTreeMap<&'static str, Difference>,
    /// By column: the difference from the quadrature with the same laws, whether or not it was asked for.
    gap_to_quadrature: BTreeMap<&'static str, Difference>,
}

impl From<FoundSeries> for Series {
    fn from(
        FoundSeries { variant, method, circles, normal_stress_from, columns, difference, gap_to_quadrature }: FoundSeries,
    ) -> Self {
        let (shear_displacement_radius, slip_radius) = words(circles);
        Self {
            variant,
            method,
            shear_displacement_radius,
            slip_radius,
            normal_stress_from: normal_stress_from.name(),
            columns,
            difference,
            gap_to_quadrature,
        }
    }
}

impl From<FoundComparison> for CompareReply {
    fn from(FoundComparison { slips, series, spread, warnings }: FoundComparison) -> Self {
        let slip = Values::Numbers(slips.iter().map(|slip| slip.ratio()).collect());
        Self { slip, series: series.into_iter().map(Series::from).collect(), spread, warnings }
    }
}

impl Reply for CompareReply {
    /// The slip, then every column of every series as `method.column`, after its variant and a dot where it has one.
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let mut columns = vec![(Cow::from("slip"), self.slip.numbers())];
        for Series { variant, method, columns: of_series, .. } in &self.series {
            let around = variant.as_ref().map_or_else(String::new, |variant| format!("{variant}."));
            let named = of_series.named().skip(1);
            columns.extend(named.map(|(name, column)| (Cow::from(format!("{around}{method}.{name}")), column)));
        }
        columns
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    fn warn(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }
}
