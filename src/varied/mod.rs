//! Many requests out of one: some numeric fields of a request take other values, row by row.
//!
//! A [`Template`] is made once of a request and the fields that vary. It refuses a field that the request does not declare or that is
//! no number, and fields that exclude each other. From then on [`Template::case`] gives for a row of values the checked case, or its
//! faults, which are those of the operation itself: a row is the request in which these numbers stand.
//!
//! There are two ways to a case. The one writes the numbers into the tree of the request and reads that anew; it takes any field and is
//! the only one that refuses. The other replaces numbers in a case that was read before, by [`Setter`]s, and takes a fraction of the
//! time; where it cannot be sure of the same case, it leaves the row to the first.

mod faults;
mod row;
mod setter;
mod template;
mod templates;

pub(crate) use faults::{shared, varied_field};
pub(crate) use row::{RowStatus, Varied, tell_invalid};
pub(crate) use setter::{IsSent, Part, Setter, names};
pub(crate) use template::Template;
pub(crate) use templates::Templates;
