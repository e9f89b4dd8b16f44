//! Inputs of a study or of a run of a model, for its hash.

use crate::file::Study;
use crate::model::StudyModel;
use loosepin_mechanics::model::Model;
use loosepin_result::repeat::{InputRole, Repeat};
use loosepin_store::results::{InputsHash, InputsHasher, ResultKind};
use loosepin_text::diagnostics::Source;
use std::sync::Arc;

/// Adds a model file, and the tables that it names, to what a result is computed from.
pub fn add_model(hasher: &mut InputsHasher, model: &StudyModel) {
    add_texts(hasher, model.source(), model.tables());
}

/// The same for a planar model.
pub fn add_planar_model(hasher: &mut InputsHasher, model: &Model) {
    add_texts(hasher, model.source(), model.tables());
}

fn add_texts(hasher: &mut InputsHasher, model: &Source, tables: &[Arc<Source>]) {
    hasher.add("model", model.text());
    for table in tables {
        hasher.add("table", table.text());
    }
}

/// Adds a study file, and the tables that it names, to what a result is computed from; its model is added by itself.
pub fn add_study(hasher: &mut InputsHasher, study: &Study) {
    hasher.add("study", study.source().text());
    for table in study.tables() {
        hasher.add("table", table.text());
    }
}

/// How the result of `study` is made again.
pub(crate) fn repeat(study: &Study) -> Repeat {
    Repeat::new("study", study.stated(), study.input_files())
}

impl Study {
    /// The files of the study, and those of its model.
    pub fn input_files(&self) -> impl Iterator<Item = (InputRole, &Source)> {
        let tables = self.tables().iter().map(|table| (InputRole::Table, &**table));
        std::iter::once((InputRole::Study, &**self.source())).chain(tables).chain(self.model.input_files())
    }
}

/// The hash of everything that the result of `study` is computed from: its files, those of its model, and what is stated beside them.
pub fn study_inputs(study: &Study, accuracy: &[String], budget: Option<&str>) -> InputsHash {
    let mut hasher = InputsHasher::new(ResultKind::Study);
    add_study(&mut hasher, study);
    add_model(&mut hasher, &study.model);
    for setting in study.settings() {
        hasher.add("set", setting);
    }
    for accuracy in accuracy {
        hasher.add("accuracy", accuracy);
    }
    if let Some(budget) = budget {
        hasher.add("budget", budget);
    }
    for point in study.paths() {
        hasher.add("path", point);
    }
    hasher.finish()
}
