//! Many requests out of one: some numeric fields of a request take other values, row by row.
//!
//! A [`Template`] is made once of a request and the fields that vary. It refuses a field that the request does not declare or that is
//! no number, and fields that exclude each other. From then on [`Template::case`] gives for a row of values the checked case, or its
//! faults, which are those of the operation itself: a row is the request in which these numbers stand.

mod faults;
mod row;
mod template;

pub(crate) use faults::varied_field;
pub(crate) use row::{RowStatus, Varied, tell_invalid};
pub(crate) use template::Template;
