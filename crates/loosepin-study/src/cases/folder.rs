//! Folders of cases.

use super::case::Case;
use super::expected::read_expected;
use super::problem::CaseProblem;
use crate::Study;
use loosepin_files::Folder;
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::Model;
use loosepin_simulate::accuracy::Scatter;
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::document::read_source;
use std::path::Path;

impl Case {
    /// Reads the case in a folder.
    ///
    /// # Errors
    /// Everything that is wrong with its files, each with its place.
    pub fn from_folder(folder: &Path) -> Result<Case, Diagnostics> {
        let model = Model::from_path(&folder.join("model.toml"))?;
        let values = model.quantities.nominal();
        let mechanism = Mechanism::new(&model, &values).map_err(|error| error.diagnostic(&model))?;
        let sample = Sample::new(&mechanism, &values).map_err(|error| error.diagnostic(&model))?;
        let study_path = folder.join("study.toml");
        let study = if study_path.is_file() { Some(Study::from_path(&study_path)?) } else { None };
        let of_study = |study: &Study| -> Vec<Scatter> {
            let random = study.random.iter().filter_map(|input| {
                let standard_deviation_si = input.largest_standard_deviation(&study.epistemic);
                Some(Scatter { quantity: input.quantity()?, standard_deviation_si })
            });
            random.collect()
        };
        let scatter = study.iter().flat_map(of_study).collect();
        let correlations = study.iter().flat_map(Study::linear_correlations).collect();
        let name = folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let mut case = Case { name, model, mechanism, values, sample, scatter, correlations, checks: Vec::new() };
        let source = read_source(&folder.join("expected.toml"))?;
        case.checks = read_expected(&source, folder, &case)?;
        Ok(case)
    }
}

/// Names of the cases in a folder, sorted: its folders with a `model.toml` and an `expected.toml`.
///
/// # Errors
/// The folder cannot be read or holds no case.
pub fn case_names(folder: &Path) -> Result<Vec<String>, Diagnostics> {
    let no_cases = || Diagnostics::one(&CaseProblem::NoCases { folder: folder.display().to_string() }, None);
    const MAX_ENTRIES: usize = 10_000;
    let entries = Folder::open(folder).and_then(|folder| folder.entries(MAX_ENTRIES)).map_err(|_| no_cases())?;
    let is_case = |path: &Path| path.join("model.toml").is_file() && path.join("expected.toml").is_file();
    let mut names: Vec<String> = entries
        .into_iter()
        .filter(|entry| is_case(&folder.join(&entry.name)))
        .map(|entry| entry.name.to_string_lossy().into_owned())
        .collect();
    names.sort();
    if names.is_empty() { Err(no_cases()) } else { Ok(names) }
}
