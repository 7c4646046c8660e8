//! What can be wrong with an input, as data: which one, what value, what was required.

use std::fmt;

use crate::parameter::Parameter;

/// One input that does not satisfy its requirement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fault {
    /// The input at fault, with what it has to satisfy.
    pub parameter: &'static Parameter,
    /// The value that was given.
    pub value: f64,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}, not {}", self.parameter.name, self.parameter.requirement, self.value)
    }
}

impl Parameter {
    /// The value, if it satisfies the requirement.
    ///
    /// # Errors
    /// The fault, where it does not.
    pub fn check(&'static self, value: f64) -> Result<f64, Fault> {
        if self.requirement.holds(value) { Ok(value) } else { Err(Fault { parameter: self, value }) }
    }
}

/// Parameters that describe no wheel, soil, contact or slip: every fault found, never empty.
#[derive(Debug, Clone, PartialEq)]
pub struct InvalidInput {
    /// The faults, in the order of the fields.
    pub faults: Vec<Fault>,
}

impl InvalidInput {
    /// `Ok` where every value satisfies its requirement, else all that do not.
    pub(crate) fn check(values: impl IntoIterator<Item = (&'static Parameter, f64)>) -> Result<(), Self> {
        let faults: Vec<Fault> = values.into_iter().filter_map(|(parameter, value)| parameter.check(value).err()).collect();
        if faults.is_empty() { Ok(()) } else { Err(Self { faults }) }
    }
}

impl fmt::Display for InvalidInput {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, fault) in self.faults.iter().enumerate() {
            write!(f, "{}{fault}", if i == 0 { "" } else { "; " })?;
        }
        Ok(())
    }
}

impl std::error::Error for InvalidInput {}

/// Required parameters of a law that have no value, never empty.
#[derive(Debug, Clone, PartialEq)]
pub struct MissingParameters {
    /// The parameters, in the order of the table.
    pub parameters: Vec<&'static Parameter>,
}

impl fmt::Display for MissingParameters {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, parameter) in self.parameters.iter().enumerate() {
            write!(f, "{}{}", if i == 0 { "" } else { ", " }, parameter.name)?;
        }
        f.write_str(if self.parameters.len() == 1 { " is required" } else { " are required" })
    }
}

impl std::error::Error for MissingParameters {}

/// The values of a table with the defaults put in.
///
/// # Errors
/// All required parameters that have no value.
pub(crate) fn completed(
    parameters: &'static [Parameter],
    value: impl Fn(usize, &'static Parameter) -> Option<f64>,
) -> Result<Vec<Option<f64>>, MissingParameters> {
    let values: Vec<_> =
        parameters.iter().enumerate().map(|(i, parameter)| value(i, parameter).or(parameter.default())).collect();
    let is_missing = |(parameter, value): &(&Parameter, &Option<f64>)| parameter.is_required() && value.is_none();
    let missing: Vec<_> = parameters.iter().zip(&values).filter(is_missing).map(|(parameter, _)| parameter).collect();
    if missing.is_empty() { Ok(values) } else { Err(MissingParameters { parameters: missing }) }
}
