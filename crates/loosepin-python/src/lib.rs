//! The native part of the Python package `loosepin`: wrappers of the library's public API, no logic of its own. What people
//! use is `python/loosepin`; `_loosepin.pyi` describes what is here.

mod arguments;
mod column;
mod error;
mod evaluator;
mod function_bounds;
mod further_outputs;
mod growing_samples;
mod identification;
mod inputs;
mod laws;
mod mechanism;
mod model;
mod python_run_provider;
mod result;
mod results_folder;
mod run_rows;
mod stored_json;
mod study;
mod study_inputs;
mod surrogates;
mod waiting;
mod words_of_python;

use pyo3::prelude::*;

/// The compiled part of loosepin.
#[pymodule(name = "_loosepin")]
fn loosepin_python(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", loosepin::VERSION)?;
    module.add("LoosepinError", error::with_defaults(module.py())?)?;
    module.add_class::<error::Diagnostic>()?;
    module.add_class::<column::Column>()?;
    module.add_class::<model::Model>()?;
    module.add_class::<mechanism::simulation::Simulation>()?;
    module.add_class::<run_rows::RunRows>()?;
    module.add_class::<study::Study>()?;
    module.add_class::<evaluator::Evaluator>()?;
    module.add_class::<result::StudyResult>()?;
    module.add_class::<identification::Identification>()?;
    module.add_class::<surrogates::Surrogates>()?;
    module.add_class::<mechanism::motion::Motion>()?;
    module.add_class::<mechanism::sweep::Sweep>()?;
    module.add_class::<mechanism::check::Check>()?;
    module.add_function(wrap_pyfunction!(function_bounds::input_names, module)?)?;
    module.add_function(wrap_pyfunction!(error::refusal, module)?)?;
    module.add_function(wrap_pyfunction!(laws::law_cdf, module)?)?;
    module.add_function(wrap_pyfunction!(laws::law_ppf, module)?)?;
    module.add_function(wrap_pyfunction!(widget_script, module)?)?;
    module.add_function(wrap_pyfunction!(function_bounds::evaluate, module)?)
}

/// The JavaScript module of the widget that shows a run or a study in a notebook.
#[pyfunction]
fn widget_script() -> &'static str {
    loosepin::report::widget_script()
}
