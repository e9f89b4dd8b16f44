//! The Python module `loosepin`: wrappers of the library's public API, no logic of its own.

use pyo3::prelude::*;

/// How accurately a planar mechanism moves when its parts scatter and its joints have play.
#[pymodule(name = "loosepin")]
fn loosepin_python(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", loosepin::VERSION)
}
