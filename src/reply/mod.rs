//! Answers as they stand on the wire: what several operations share.

pub(crate) mod arrow;
mod assuming;
mod estimate;
mod method;
mod rows;
pub(crate) mod soil;

pub(crate) use assuming::{AssumedReply, Assuming};
pub(crate) use estimate::EstimateReply;
pub(crate) use method::method_name;
pub(crate) use rows::{End, RowFormat, comment, object};

use std::borrow::Cow;

use serde::{Serialize, Serializer};
use terramechanics::Angles;
use utoipa::ToSchema;

use crate::warning::Warning;

/// Rows of an answer in columns, and samples that a JSON body may have; there is no limit to those of the other forms.
pub(crate) const MOST_IN_COLUMNS: usize = 100_000;

/// An answer that can also be written as a table.
pub(crate) trait Reply: Serialize {
    /// The columns by name, all of one length; NaN where there is no value.
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])>;

    /// What else there is to say.
    fn warnings(&self) -> &[Warning];

    /// Adds a warning.
    fn warn(&mut self, warning: Warning);
}

/// The fields of an answer of single numbers as columns of one row, each under its own name.
macro_rules! one_row {
    ($of:expr; $($field:ident),+) => {
        vec![$((::std::borrow::Cow::from(stringify!($field)), ::std::slice::from_ref(&$of.$field))),+]
    };
}

pub(crate) use one_row;

/// An answer whose table is its columns, as they are.
macro_rules! in_columns {
    ($reply:ty) => {
        impl $crate::reply::Reply for $reply {
            fn columns(&self) -> Vec<(::std::borrow::Cow<'static, str>, &[f64])> {
                self.columns.as_table()
            }

            fn warnings(&self) -> &[$crate::warning::Warning] {
                &self.warnings
            }

            fn warn(&mut self, warning: $crate::warning::Warning) {
                self.warnings.push(warning);
            }
        }
    };
}

pub(crate) use in_columns;

/// A number; null where it is NaN.
pub(crate) fn or_null<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    value.is_finite().then_some(value).serialize(serializer)
}

/// The characteristic angles of the contact, from straight down, positive towards the front.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Angles)]
pub(crate) struct AnglesReply {
    /// Entry angle θ1 (rad).
    pub(crate) entry_rad: f64,
    /// Angle of maximum stress θm (rad).
    pub(crate) maximum_stress_rad: f64,
    /// Exit angle θ2 (rad).
    pub(crate) exit_rad: f64,
}

impl From<Angles> for AnglesReply {
    fn from(angles: Angles) -> Self {
        Self { entry_rad: angles.entry, maximum_stress_rad: angles.peak, exit_rad: angles.exit }
    }
}
