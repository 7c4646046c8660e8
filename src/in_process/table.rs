//! Rows in columns, answered piece by piece on several threads.

use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use terramechanics_reading::{Assumption, FieldFault, Unread, json, shortened};

use super::Refused;
use super::rovers::{RoverPlan, RoverRows};
use crate::api::batch::{Answers, ForcesPlan, ForcesRows, STATUS, shared_faults};
use crate::api::forces::ForcesCase;
use crate::api::vehicle::VehicleCase;
use crate::problem::Problem;
use crate::quantity::About;
use crate::reply::{AssumedReply, End};
use crate::request::Request;
use crate::rows::{Block, Cells, Columns, Echo, Wanted, columns_of, fill, unfit};
use crate::series::ExtraColumns;
use crate::warning::{Tally, of_assumptions};
use crate::words::nearest;

/// Fewest rows of a block, where a row may take long.
const FEWEST: usize = 16;

/// Blocks for each thread where rows may take long, so that no thread waits long for another.
const BLOCKS_PER_THREAD: usize = 8;

/// A column of an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Column {
    /// Its name on the wire.
    pub name: &'static str,
    /// Its unit by the Unified Code for Units of Measure; 1 for a ratio.
    pub unit: &'static str,
    /// What it is.
    pub meaning: &'static str,
}

/// What rows gave.
#[derive(Debug, Default)]
pub struct Answered {
    /// By column, then by row; NaN where there is no number.
    pub columns: Vec<Vec<f64>>,
    /// The rows without an answer, ascending, and why: `invalid: …`, `no_solution: …` or `not_climbed: …`.
    pub faults: Vec<(usize, Box<str>)>,
}

/// Rows of one operation that have a part of their request in common. They come in pieces.
pub struct Table {
    columns: Arc<Columns>,
    kind: Kind,
    rows: u64,
    tally: Tally,
    assumed: Vec<Assumption>,
}

enum Kind {
    Forces(ForcesPlan),
    Rovers(Arc<RoverPlan>),
}

enum Worker {
    Forces(Box<ForcesRows>),
    Rovers(Box<RoverRows>),
}

impl Kind {
    fn of(wanted: &Wanted, columns: &Arc<Columns>, is_asked: &dyn Fn(&About) -> bool) -> Self {
        if std::ptr::eq(wanted.object, ForcesCase::OBJECT) {
            Self::Forces(ForcesPlan::new(wanted, columns.clone(), is_asked))
        } else {
            Self::Rovers(Arc::new(RoverPlan::new(wanted.constants.clone(), columns.clone(), is_asked)))
        }
    }

    fn columns(&self) -> &[&'static About] {
        match self {
            Self::Forces(plan) => plan.columns(),
            Self::Rovers(plan) => plan.columns(),
        }
    }

    fn worker(&self) -> Worker {
        match self {
            Self::Forces(plan) => Worker::Forces(Box::new(plan.worker())),
            Self::Rovers(plan) => Worker::Rovers(Box::new(plan.worker())),
        }
    }

    /// Rows of a block.
    fn block_rows(&self, rows: usize, threads: usize) -> usize {
        match self {
            // A batch over HTTP looks at so many rows for what all of them lack.
            Self::Forces(_) => Block::ROWS,
            Self::Rovers(_) => rows.div_ceil(threads * BLOCKS_PER_THREAD).clamp(FEWEST, Block::ROWS),
        }
    }
}

impl Worker {
    fn answer(&mut self, block: Block) -> (Answers, Block) {
        match self {
            Self::Forces(rows) => rows.answer(block),
            Self::Rovers(rows) => rows.answer(block),
        }
    }
}

impl Table {
    /// Rows of `of`, which is `forces` or `vehicle`. The JSON object `constants` is what they have in common, `names` are their
    /// columns with a dot between an object and its field. With `ignores_extra` columns that are no field are left out, else they
    /// are refused. The answer has the columns of `asked`, or all.
    ///
    /// # Errors
    /// All that is wrong with the columns, and what is no JSON.
    pub fn new(
        of: &str,
        constants: &[u8],
        names: &[String],
        ignores_extra: bool,
        asked: Option<&[String]>,
    ) -> Result<Self, Refused> {
        let unread = |unread: Unread| Problem::Invalid(vec![FieldFault::new("", unread)]);
        let constants = json(constants).map_err(unread)?.detached();
        let object = match of {
            "forces" => ForcesCase::OBJECT,
            "vehicle" => VehicleCase::OBJECT,
            _ => return Err(refused("/of", format!("unknown name `{of}`; known are forces, vehicle"))),
        };
        let extra = if ignores_extra { ExtraColumns::Ignore } else { ExtraColumns::Refuse };
        let echo = Echo::Names(Vec::new());
        let wanted = Wanted { object, constants, echo, extra, keeps_arrays: false, answered: Vec::new() };
        let columns = Arc::new(columns_of(&wanted, names).map_err(Problem::Invalid)?);
        let is_asked = |about: &About| asked.is_none_or(|asked| asked.iter().any(|name| name == about.name));
        let kind = Kind::of(&wanted, &columns, &is_asked);
        if let Some(absent) =
            asked.unwrap_or_default().iter().find(|name| !kind.columns().iter().any(|about| about.name == *name))
        {
            let all = Kind::of(&wanted, &columns, &|_| true);
            let known: Vec<&str> = all.columns().iter().map(|about| about.name).collect();
            let meant = nearest(absent, &known);
            let meant = meant.map_or_else(|| format!("it has {}", known.join(", ")), |near| format!("did you mean `{near}`?"));
            let absent = shortened(absent);
            return Err(refused("/columns", format!("the answer has no column `{absent}`; {meant}")));
        }
        Ok(Self { columns, kind, rows: 0, tally: Tally::default(), assumed: Vec::new() })
    }

    /// The columns of the answer.
    pub fn columns(&self) -> impl Iterator<Item = Column> {
        self.kind.columns().iter().map(|about| Column { name: about.name, unit: about.unit, meaning: about.meaning })
    }

    /// Name of the column that says how a row went, which every answer has beside its numbers.
    pub const STATUS: &str = STATUS;

    /// What the next rows give, found on so many threads. There are cells for each column, of one length. The numbers do not depend
    /// on the threads, nor on the pieces in which rows come.
    ///
    /// # Errors
    /// What no row can mend, such as a field that is missing, where these are the first rows and all of them have it; texts in
    /// place of numbers; and cells that are not those of the columns.
    ///
    /// # Panics
    /// Where a row does, which none should.
    pub fn rows(&mut self, cells: &[Cells<'_>], threads: usize) -> Result<Answered, Refused> {
        let rows = cells.first().map_or(Some(0), Cells::rows);
        let Some(rows) =
            rows.filter(|rows| cells.len() == self.columns.len() && cells.iter().all(|column| column.rows() == Some(*rows)))
        else {
            return Err(refused(
                "",
                "there have to be as many cells in each column, and as many columns as were named".to_owned(),
            ));
        };
        let unfit = unfit(&self.columns, cells);
        if !unfit.is_empty() {
            return Err(Problem::Invalid(unfit).into());
        }
        let parts = self.parts(cells, rows, threads.max(1));
        if let (0, Some(first)) = (self.rows, parts.first()) {
            let faults = shared_faults(first, &self.columns);
            if !faults.is_empty() {
                return Err(Problem::Invalid(faults).into());
            }
        }
        let mut found = Answered::default();
        found.columns.resize_with(self.kind.columns().len(), || Vec::with_capacity(rows));
        let mut next = 0;
        for Answers { numbers, faults, tally, assumed, .. } in parts {
            for (column, part) in found.columns.iter_mut().zip(numbers) {
                column.extend(part);
            }
            let count = faults.len();
            found.faults.extend(faults.into_iter().enumerate().filter_map(|(row, fault)| Some((next + row, fault?))));
            next += count;
            self.tally.follow(tally);
            for assumption in assumed {
                if !self.assumed.contains(&assumption) {
                    self.assumed.push(assumption);
                }
            }
        }
        self.rows += rows as u64;
        Ok(found)
    }

    /// The blocks of some rows, in their order.
    fn parts(&self, cells: &[Cells<'_>], rows: usize, threads: usize) -> Vec<Answers> {
        let size = self.kind.block_rows(rows, threads);
        let next = AtomicUsize::new(0);
        let work = || {
            let (mut worker, mut room, mut found) = (self.kind.worker(), Block::default(), Vec::new());
            loop {
                let block = next.fetch_add(1, Ordering::Relaxed);
                let start = block * size;
                if start >= rows {
                    return found;
                }
                room.clear(self.rows + start as u64);
                fill(&self.columns, cells, start..rows.min(start + size), &mut room);
                let (answers, used) = worker.answer(room);
                room = used;
                found.push((block, answers));
            }
        };
        let mut parts = std::thread::scope(|scope| {
            let others: Vec<_> = (1..threads.min(rows.div_ceil(size))).map(|_| scope.spawn(work)).collect();
            let mut parts = work();
            for other in others {
                parts.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
            }
            parts
        });
        parts.sort_by_key(|(block, _)| *block);
        parts.into_iter().map(|(_, answers)| answers).collect()
    }

    /// What is to be said of all rows so far, as JSON: `rows`, `warnings` and, where something was, `assumed`, as at the end of a
    /// batch.
    #[must_use]
    pub fn end(&self) -> String {
        let mut warnings = self.tally.clone().into_warnings();
        warnings.extend(of_assumptions(&self.assumed));
        let assumed: Vec<_> = self.assumed.iter().cloned().map(AssumedReply::from).collect();
        let assumed = (!assumed.is_empty()).then_some(assumed);
        serde_json::to_string(&End { end: true, rows: self.rows, warnings, assumed }).unwrap_or_default()
    }
}

fn refused(pointer: &str, detail: String) -> Refused {
    Problem::Invalid(vec![FieldFault::new(pointer.to_owned(), detail)]).into()
}
