//! The requests of the service as a Python module: bytes and buffers in and out. What a user sees of it is the package around it,
//! in `python/`.
//!
//! Buffers are copied while the interpreter waits, and rows are computed while it does not: other threads of Python run meanwhile,
//! and nobody can change a buffer that is read.

mod cells;
mod fault;

use pyo3::prelude::*;

/// The native part of the package.
#[pymodule]
mod _native {
    use pyo3::buffer::PyBuffer;
    use pyo3::exceptions::{PyIndexError, PyValueError};
    use pyo3::prelude::*;
    use pyo3::types::PyBytes;
    use terramechanics_server::in_process::{self, Answered, Column};

    use crate::cells::OwnCells;
    #[pymodule_export]
    use crate::fault::Problem;
    use crate::fault::{guarded, told};

    /// The names of the operations that `answer` knows.
    #[pyfunction]
    fn operations() -> Vec<&'static str> {
        in_process::operations().collect()
    }

    /// The answer of an operation to a JSON body, as JSON.
    #[pyfunction]
    fn answer<'py>(py: Python<'py>, operation: &str, body: &[u8]) -> PyResult<Bound<'py, PyBytes>> {
        let answered = py.detach(|| guarded(|| in_process::answer(operation, body)))?;
        Ok(PyBytes::new(py, &answered.map_err(told)?))
    }

    /// Fails as a defect of the package would, so that its tests see that the interpreter goes on.
    #[pyfunction]
    fn fail(py: Python<'_>) -> PyResult<()> {
        py.detach(|| guarded(|| panic!("on purpose")))
    }

    /// Rows of one operation that have a part of their request in common.
    #[pyclass(module = "terramechanics._native")]
    struct Table(in_process::Table);

    #[pymethods]
    impl Table {
        #[new]
        #[pyo3(signature = (of, constants, names, ignores_extra, asked))]
        fn new(
            py: Python<'_>,
            of: &str,
            constants: &[u8],
            names: Vec<String>,
            ignores_extra: bool,
            asked: Option<Vec<String>>,
        ) -> PyResult<Self> {
            let table = || in_process::Table::new(of, constants, &names, ignores_extra, asked.as_deref());
            py.detach(|| guarded(table))?.map(Self).map_err(told)
        }

        /// Name, unit and meaning of each column of the answer.
        fn columns(&self) -> Vec<(&'static str, &'static str, &'static str)> {
            self.0.columns().map(|Column { name, unit, meaning }| (name, unit, meaning)).collect()
        }

        /// What the next rows give, found on so many threads.
        fn rows(&mut self, py: Python<'_>, cells: Vec<OwnCells>, threads: usize) -> PyResult<Rows> {
            let table = &mut self.0;
            let answered = py.detach(|| {
                guarded(|| {
                    let cells: Vec<_> = cells.iter().map(OwnCells::borrowed).collect();
                    table.rows(&cells, threads)
                })
            })?;
            answered.map(Rows).map_err(told)
        }

        /// What is to be said of all rows so far, as JSON.
        fn end(&self) -> String {
            self.0.end()
        }
    }

    /// What rows gave.
    #[pyclass(frozen, module = "terramechanics._native")]
    struct Rows(Answered);

    #[pymethods]
    impl Rows {
        /// Copies a column into a buffer of as many numbers.
        fn copy(&self, py: Python<'_>, column: usize, into: PyBuffer<f64>) -> PyResult<()> {
            let values = self.0.columns.get(column).ok_or_else(|| PyIndexError::new_err("there is no such column"))?;
            if into.item_count() != values.len() {
                return Err(PyValueError::new_err(format!(
                    "the buffer has {} places for {} rows",
                    into.item_count(),
                    values.len()
                )));
            }
            into.copy_from_slice(py, values)
        }

        /// The rows without an answer, and why.
        fn faults(&self) -> Vec<(usize, &str)> {
            self.0.faults.iter().map(|(row, fault)| (*row, &**fault)).collect()
        }
    }
}
