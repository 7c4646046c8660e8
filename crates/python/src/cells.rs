//! The cells of columns, out of the buffers of Python.

use pyo3::buffer::PyBuffer;
use pyo3::prelude::*;
use terramechanics_server::in_process::Cells;

/// A column as it was copied: numbers, numbers with a flag for each, places among texts, or flags.
pub(crate) enum OwnCells {
    Numbers(Vec<f64>),
    SomeNumbers(Vec<f64>, Vec<u8>),
    Texts(Vec<i32>, Vec<String>),
    Flags(Vec<u8>),
}

impl OwnCells {
    pub(crate) fn borrowed(&self) -> Cells<'_> {
        match self {
            Self::Numbers(values) => Cells::Numbers(values),
            Self::SomeNumbers(values, there) => Cells::SomeNumbers(values, there),
            Self::Texts(places, texts) => Cells::Texts { places, texts },
            Self::Flags(flags) => Cells::Flags(flags),
        }
    }
}

/// A tuple of a buffer, of flags that say which numbers are there, and of texts; the last two may be None. A buffer that is not
/// aligned to its numbers, or not of this machine's order, is refused by [`PyBuffer`].
impl<'py> FromPyObject<'_, 'py> for OwnCells {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let py = object.py();
        let (values, there, texts): (Bound<'py, PyAny>, Option<PyBuffer<u8>>, Option<Vec<String>>) = object.extract()?;
        if let Some(texts) = texts {
            return Ok(Self::Texts(PyBuffer::<i32>::get(&values)?.to_vec(py)?, texts));
        }
        if let Ok(flags) = PyBuffer::<u8>::get(&values) {
            return Ok(Self::Flags(flags.to_vec(py)?));
        }
        let values = PyBuffer::<f64>::get(&values)?.to_vec(py)?;
        Ok(match there {
            Some(there) => Self::SomeNumbers(values, there.to_vec(py)?),
            None => Self::Numbers(values),
        })
    }
}
