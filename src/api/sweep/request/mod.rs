//! The request of `/v1/sweep`.

pub(in crate::api) mod axes;

use terramechanics_reading::{Field, FieldFault, Nested, Object, Path, Reader, Word};

use super::grid::Grid;
use crate::api::either::{self, Of};
use crate::api::forces::ForcesCase;
use crate::api::vehicle::VehicleCase;
use crate::compute::Cost;
use crate::problem::Problem;
use crate::reply::MOST_IN_COLUMNS;
use crate::request::{Documented, Request};
use crate::varied::{Template, Varied};

const OF: Field<Word<Of>> =
    either::of("What is computed at each point: forces, as by /v1/forces, or vehicle, a rover on one slope, as by /v1/vehicle.");
const REQUEST: Field<Nested> = Field::required(
    "request",
    "The request that is asked at each point, as that operation takes it; a varied field may be left out.",
    either::REQUESTS,
);

/// A sweep, checked.
pub(crate) enum GridCase {
    Forces(Box<Sweep<ForcesCase>>),
    Vehicle(Box<Sweep<VehicleCase>>),
}

/// A request over a grid.
pub(crate) struct Sweep<R> {
    pub(crate) template: Template<R>,
    pub(crate) grid: Grid,
    /// A case of the grid, for what all have in common.
    pub(crate) sample: Box<R>,
}

impl<R: Varied> Sweep<R> {
    /// What all its points cost.
    pub(super) fn cost(&self) -> Cost {
        self.sample.cost_of_rows(self.grid.len())
    }
}

pub(super) type GridRequest = Documented<GridCase>;

impl Request for GridCase {
    const OBJECT: &'static Object = &Object {
        name: "SweepRequest",
        doc: "A request for forces or of a rover, asked at every point of a grid of one to three of its numeric fields.",
        groups: &[&[&OF, &REQUEST, &axes::AXES]],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        match object.required(&OF) {
            Some(Of::Forces) => sweep(object).map(Box::new).map(Self::Forces),
            Some(Of::Vehicle) => sweep(object).map(Box::new).map(Self::Vehicle),
            None => {
                let _ = object.required(&REQUEST);
                None
            }
        }
    }
}

impl GridCase {
    fn len(&self) -> usize {
        match self {
            Self::Forces(sweep) => sweep.grid.len(),
            Self::Vehicle(sweep) => sweep.grid.len(),
        }
    }

    /// Whether an answer in columns may have so many rows.
    ///
    /// # Errors
    /// [`Problem::Invalid`] where it may not.
    pub(crate) fn fits_in_columns(&self) -> Result<(), Problem> {
        if self.len() <= MOST_IN_COLUMNS {
            return Ok(());
        }
        let detail = format!(
            "make {} points; an answer in JSON has at most {MOST_IN_COLUMNS} rows; accept text/csv, application/x-ndjson or application/vnd.apache.arrow.stream",
            self.len()
        );
        Err(Problem::Invalid(vec![FieldFault::new(format!("/{}", axes::AXES.name), detail)]))
    }
}

/// The sweep of one kind of request.
fn sweep<R: Varied>(object: &Reader<'_>) -> Option<Sweep<R>> {
    let request = object.required(&REQUEST);
    let axes = axes::read(object, R::OBJECT);
    let (request, axes) = (request?, axes?);
    let paths: Vec<Path> = axes.iter().map(|axis| axis.path.clone()).collect();
    let grid = Grid::of(axes);
    let found = Template::new(request, &paths).and_then(|mut template| {
        let sample = template.first_case(grid.samples().iter().map(Vec::as_slice))?;
        Ok((template, sample))
    });
    match found {
        Ok((template, sample)) => {
            if sample.is_none() {
                object.place_of(&REQUEST).fault("makes no valid request at any corner of the grid");
            }
            if let Some(fault) = sample.as_ref().and_then(Varied::refusal) {
                object.place_of(&REQUEST).pass_on(fault);
            }
            Some(Sweep { template, grid, sample: Box::new(sample?) })
        }
        Err(faults) => {
            for fault in faults {
                match fault.field {
                    Some(axis) => axes::fault_of_field(object, axis, &fault.fault.detail),
                    None => object.place_of(&REQUEST).pass_on(fault.fault),
                }
            }
            None
        }
    }
}
