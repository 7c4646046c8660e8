//! What the rows of a batch have in common.

use std::sync::Arc;

use terramechanics_reading::Node;

use super::reply::Writer;
use crate::quantity::PointValue;
use crate::rows::Columns;

/// What the rows of a batch have in common.
pub(super) struct Plan {
    pub(super) constants: Node<'static>,
    pub(super) columns: Arc<Columns>,
    /// The columns of the answer.
    pub(super) values: Vec<PointValue>,
    pub(super) writer: Writer,
}
