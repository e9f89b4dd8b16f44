//! The Python module `loosepin`: wrappers of the library's public API, no logic of its own.

use pyo3::prelude::*;

/// Uncertainty-aware motion accuracy of planar mechanisms with joint play.
#[pymodule]
fn loosepin_python(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", loosepin::VERSION)
}
