//! The bands of a request with uncertain fields.

use terramechanics_reading::{Assumption, Path};
use terramechanics_uncertainty::{PROBABILITIES, Probability, Sensitivity, Source, Summary, sensitivities};

use super::request::{Condition, Origin, Uncertainty};
use crate::compute::{Pace, Stop};
use crate::quantity::About;
use crate::varied::{RowStatus, Varied, tell_invalid};
use crate::warning::{Finding, Tally, Warning, of_assumptions};

/// What was found at one value of the axis, or at the point.
pub(super) struct FoundPoint {
    /// How many samples ended so, in the order of [`RowStatus::ALL`].
    pub(super) statuses: [u32; RowStatus::ALL.len()],
    /// Of each column.
    pub(super) bands: Vec<Option<Summary>>,
    /// Of each condition.
    pub(super) probabilities: Vec<Probability>,
    /// Of each column that has sensitivities, of each group of inputs.
    pub(super) sensitivities: Vec<Vec<Option<Sensitivity>>>,
}

/// What was found of all.
pub(super) struct FoundBands {
    pub(super) columns: Vec<&'static About>,
    /// Places of the columns that have bands: all but that of the axis.
    pub(super) banded: Vec<usize>,
    /// Places of the columns that have sensitivities.
    pub(super) sensitive: Vec<usize>,
    pub(super) points: Vec<FoundPoint>,
    pub(super) warnings: Vec<Warning>,
    pub(super) assumed: Option<Vec<Assumption>>,
}

/// The probabilities of the quantiles, in per cent, as in the names of the answer.
pub(super) const PER_CENT: [u32; PROBABILITIES.len()] = [5, 25, 50, 75, 95];

/// The bands at each value of the axis.
///
/// # Errors
/// [`Stop`], where the work is to end.
pub(super) fn bands<R: Varied>(case: &Uncertainty<R>, pace: &Pace) -> Result<FoundBands, Stop> {
    let columns = case.sample.columns();
    let on_axis = case.axis.as_ref().map(|axis| axis.path.dotted());
    let banded: Vec<usize> = (0..columns.len()).filter(|&i| on_axis.as_deref() != Some(columns[i].name)).collect();
    let sensitive = match case.sensitive {
        _ if !case.has_sensitivities => Vec::new(),
        Some(column) => vec![column],
        None => banded.clone(),
    };
    let mut template = case.template.clone();
    let mut tally = Tally::default();
    let mut points = Vec::new();
    for step in 0..case.axis.as_ref().map_or(1, |axis| axis.steps.len()) {
        let on_axis = case.axis.as_ref().map(|axis| axis.steps.at(step));
        let mut answers = Answers::of(columns.len(), case.design.rows());
        let mut statuses = [0; RowStatus::ALL.len()];
        let mut cells = Vec::with_capacity(columns.len());
        for row in 0..case.design.rows() {
            pace.glance()?;
            let mut values = case.design.row(row).unwrap_or_default();
            values.extend(on_axis);
            cells.clear();
            // Rows beyond the samples serve the sensitivities alone, and repeat what the samples have to say.
            let mut unheard = Tally::default();
            let is_sample = row < case.design.samples();
            let tally = if is_sample { &mut tally } else { &mut unheard };
            tally.begin_row();
            let status = match template.case(&values) {
                Ok(case) => case.row(&mut cells, tally, pace),
                Err(faults) => tell_invalid(faults, tally),
            };
            if is_sample && let Some(at) = RowStatus::ALL.iter().position(|known| *known == status) {
                statuses[at] += 1;
            }
            answers.push(&cells);
        }
        points.push(point(case, &answers, statuses, [&banded, &sensitive], pace)?);
    }
    let mut warnings: Vec<Warning> = truncated(case).collect();
    warnings.extend(unanswered(&points, case.design.samples()));
    warnings.extend(tally.into_warnings());
    let mut assumed = template.assumed().map(<[Assumption]>::to_vec);
    if !case.assumed.is_empty() {
        assumed.get_or_insert_default().extend(case.assumed.iter().cloned());
    }
    warnings.extend(of_assumptions(assumed.as_deref().unwrap_or_default()));
    Ok(FoundBands { columns, banded, sensitive, points, warnings, assumed })
}

/// The numbers of all rows by column; NaN where there is none.
struct Answers(Vec<Vec<f64>>);

impl Answers {
    fn of(columns: usize, rows: usize) -> Self {
        Self((0..columns).map(|_| Vec::with_capacity(rows)).collect())
    }

    fn push(&mut self, cells: &[f64]) {
        for (i, column) in self.0.iter_mut().enumerate() {
            column.push(cells.get(i).copied().unwrap_or(f64::NAN));
        }
    }

    /// The answers of a column, none where there is no number.
    fn of_column(&self, column: usize) -> Vec<Option<f64>> {
        self.0[column].iter().map(|answer| answer.is_finite().then_some(*answer)).collect()
    }
}

fn point<R: Varied>(
    case: &Uncertainty<R>,
    answers: &Answers,
    statuses: [u32; RowStatus::ALL.len()],
    [banded, sensitive]: [&[usize]; 2],
    pace: &Pace,
) -> Result<FoundPoint, Stop> {
    let samples = case.design.samples();
    let mut bands = Vec::with_capacity(banded.len());
    for &column in banded {
        pace.look()?;
        bands.push(Summary::of(&answers.of_column(column)[..samples]));
    }
    let mut probabilities = Vec::with_capacity(case.conditions.len());
    for condition in &case.conditions {
        pace.look()?;
        probabilities.push(probability(condition, &answers.of_column(condition.column)[..samples]));
    }
    let mut of_groups = Vec::with_capacity(sensitive.len());
    for &column in sensitive {
        pace.look()?;
        of_groups.push(sensitivities(&case.design, &answers.of_column(column)));
    }
    Ok(FoundPoint { statuses, bands, probabilities, sensitivities: of_groups })
}

fn probability(condition: &Condition, answers: &[Option<f64>]) -> Probability {
    let holds: Vec<Option<bool>> = answers.iter().map(|answer| answer.map(|answer| condition.holds(answer))).collect();
    Probability::of(&holds)
}

/// The distributions of which something was cut off.
fn truncated<R>(case: &Uncertainty<R>) -> impl Iterator<Item = Warning> {
    case.fields.iter().filter_map(|field| {
        let Source::One(marginal) = &case.design.inputs().sources()[field.source] else { return None };
        let pointer = match field.origin {
            Origin::Request(place) => format!("/inputs/{place}"),
            Origin::Posterior(estimate) => format!("/posterior/estimates/{estimate}"),
            Origin::Catalogue { .. } => return None,
        };
        let share = marginal.share_cut();
        // A tail that no sample would reach is not worth a word.
        let is_seen = share * case.design.samples() as f64 > 0.5;
        let bounds = marginal.bounds();
        is_seen.then(|| Finding::TruncatedDistribution { pointer, field: Path::pointer(&field.path), share, bounds }.into())
    })
}

/// The samples without an answer, which are in no band.
fn unanswered(points: &[FoundPoint], samples: usize) -> Option<Warning> {
    let ok = RowStatus::ALL.iter().position(|status| *status == RowStatus::Ok)?;
    let answered = points.iter().map(|point| u64::from(point.statuses[ok])).sum::<u64>();
    let all = (points.len() * samples) as u64;
    (answered < all).then(|| Finding::SamplesUnanswered { count: all - answered, all }.into())
}
