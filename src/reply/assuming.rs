//! Answers to requests of which something was or might have been assumed.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics_reading::Assumption;
use utoipa::ToSchema;

use super::Reply;
use crate::warning::{Warning, of_assumptions};

/// A value that the service took where none was published.
#[derive(Debug, Clone, Serialize, ToSchema)]
#[schema(as = Assumed)]
pub(crate) struct AssumedReply {
    /// The field of the request, with a dot between an object and its field.
    #[schema(example = "soil.shear_modulus_m")]
    field: String,
    /// The preset that has no published value of it.
    #[schema(example = "jsc1a-proxy")]
    preset: String,
    /// The value, in SI units.
    value: f64,
    /// Where it comes from.
    reason: String,
}

impl From<Assumption> for AssumedReply {
    fn from(Assumption { field, preset, value, reason }: Assumption) -> Self {
        Self { field, preset, value, reason }
    }
}

/// An answer, with what was assumed for it.
#[derive(Serialize)]
pub(crate) struct Assuming<R> {
    #[serde(flatten)]
    reply: R,
    assumed: Vec<AssumedReply>,
}

impl<R: Reply> Assuming<R> {
    pub(crate) fn of(mut reply: R, assumptions: Vec<Assumption>) -> Self {
        of_assumptions(&assumptions).into_iter().for_each(|warning| reply.warn(warning));
        Self { reply, assumed: assumptions.into_iter().map(AssumedReply::from).collect() }
    }
}

impl<R: Reply> Reply for Assuming<R> {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        self.reply.columns()
    }

    fn warnings(&self) -> &[Warning] {
        self.reply.warnings()
    }

    fn warn(&mut self, warning: Warning) {
        self.reply.warn(warning);
    }
}
