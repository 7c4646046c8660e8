//! Numbers of an operating point that can be replaced without reading its request anew.

use terramechanics::Parameter;
use terramechanics_reading::Path;

use crate::request::laws::number;

/// Where a number stands in what a request became.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    Wheel,
    Soil,
    PressureSinkage,
    Shear,
    /// The rule for the peak of a contact.
    Rule,
    /// The exit of a contact.
    Exit,
    Slip,
    Sinkage,
    StaticSinkage,
    NormalLoad,
}

/// A number that can be replaced: its part, its place there and what is declared of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Setter {
    pub(crate) part: Part,
    pub(crate) place: usize,
    parameter: &'static Parameter,
}

impl Setter {
    /// The setter of the parameter of that name in a table.
    pub(crate) fn of(part: Part, name: &str, table: &'static [Parameter]) -> Option<Self> {
        let place = table.iter().position(|parameter| parameter.name == name)?;
        Some(Self { part, place, parameter: &table[place] })
    }

    /// Whether a request may have the value: the bounds are those of the field, which come from the same parameter.
    pub(crate) fn allows(&self, value: f64) -> bool {
        number(self.parameter).allows(value)
    }
}

/// What a request has beside the fields that vary, by which is told whether a number stands for itself alone.
pub(crate) type IsSent<'s> = &'s dyn Fn(&[&str]) -> bool;

/// The names of a path, to be matched.
pub(crate) fn names(path: &Path) -> Vec<&str> {
    path.names().iter().map(String::as_str).collect()
}
