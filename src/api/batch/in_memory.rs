//! A batch of rows that are in memory already, for a caller in the same process.

use std::sync::Arc;

use super::answers::Answers;
use super::evaluate::Rows;
use super::plan::Plan;
use super::reply::Writer;
use super::request::answered;
use crate::quantity::About;
use crate::rows::{Block, Columns, Wanted};
use crate::stream::Job;

/// What the rows of a batch in memory have in common.
pub(crate) struct ForcesPlan {
    plan: Arc<Plan>,
    about: Vec<&'static About>,
}

impl ForcesPlan {
    /// The plan of rows with these columns, whose answers have those columns that `is_asked` names.
    pub(crate) fn new(wanted: &Wanted, columns: Arc<Columns>, is_asked: impl Fn(&About) -> bool) -> Self {
        let (about, values) = answered(wanted, &columns.fields).filter(|(about, _)| is_asked(about)).unzip();
        Self { plan: Arc::new(Plan { constants: wanted.constants.clone(), columns, values, writer: Writer::Memory }), about }
    }

    /// The columns of the answer.
    pub(crate) fn columns(&self) -> &[&'static About] {
        &self.about
    }

    /// What answers one block after the other.
    pub(crate) fn worker(&self) -> ForcesRows {
        ForcesRows(Rows::new(self.plan.clone()))
    }
}

/// Answers one block after the other.
pub(crate) struct ForcesRows(Rows);

impl ForcesRows {
    /// What the rows of the block give, and the block with its room.
    pub(crate) fn answer(&mut self, block: Block) -> (Answers, Block) {
        self.0.begin(block);
        while !self.0.slice() {}
        (std::mem::take(&mut self.0.answers), std::mem::take(&mut self.0.block))
    }
}
