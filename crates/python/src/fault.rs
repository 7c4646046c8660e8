//! Refusals and defects as exceptions.

use std::panic::{AssertUnwindSafe, catch_unwind};

use pyo3::exceptions::{PyException, PyRuntimeError};
use pyo3::prelude::*;
use terramechanics_server::in_process::Refused;

pyo3::create_exception!(
    terramechanics._native,
    Problem,
    PyException,
    "A request without an answer: the problem document of the service, as JSON."
);

/// A refusal as an exception.
pub(crate) fn told(Refused(document): Refused) -> PyErr {
    Problem::new_err(document)
}

/// What `work` returns; a panic in it is an exception that `except Exception` catches.
pub(crate) fn guarded<T>(work: impl FnOnce() -> T) -> PyResult<T> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|cause| {
        let text = cause.downcast_ref::<&str>().copied().or_else(|| cause.downcast_ref::<String>().map(String::as_str));
        PyRuntimeError::new_err(format!("a defect of terramechanics: {}", text.unwrap_or("of unknown cause")))
    })
}
