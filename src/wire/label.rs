//! Names that a client gives.

use utoipa::openapi::schema::{ObjectBuilder, Type};
use utoipa::openapi::{RefOr, Schema};

use super::{Entry, Scope, Spec, Wire};

/// Characters of the longest label.
const LONGEST: usize = 60;

/// A text that stands on one line.
#[derive(Debug, Clone)]
pub(crate) struct Label(String);

/// What a label is for.
#[derive(Debug)]
pub(crate) struct LabelSpec {
    pub(crate) doc: &'static str,
}

impl Spec for LabelSpec {
    fn schema(&self) -> RefOr<Schema> {
        ObjectBuilder::new()
            .schema_type(Type::String)
            .description(Some(self.doc))
            .min_length(Some(1))
            .max_length(Some(LONGEST))
            .pattern(Some(r"^[^\u0000-\u001f\u007f-\u009f]+$"))
            .into()
    }

    fn is_required(&self) -> bool {
        true
    }
}

impl Wire for Label {
    type Spec = LabelSpec;
    const EXPECTED: &'static str = "a string";

    fn text(value: &str) -> Option<Self> {
        // One more than allowed, which the check refuses.
        Some(Self(value.chars().take(LONGEST + 1).collect()))
    }
}

impl Entry<'_, Label> {
    /// The label; that none was sent is reported.
    pub(crate) fn label(&self, object: &Scope<'_>) -> Option<String> {
        let Label(text) = self.required(object)?;
        if !(1..=LONGEST).contains(&text.chars().count()) || text.chars().any(char::is_control) {
            object
                .field(self.name)
                .fault(format_args!("must have from 1 to {LONGEST} characters, none of them a control character"));
            return None;
        }
        Some(text.clone())
    }
}
