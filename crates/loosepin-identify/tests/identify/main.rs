//! Readings whose consistent plays are known: closed forms, and an independent calculation by brute force.

#![allow(clippy::disallowed_methods, reason = "tests make files of their own")]

mod closed_forms;
mod lengths;
mod misfits;
mod motion;
mod motion_repetitions;
mod posterior;
mod repetitions;
mod uncertain;
mod written;

use loosepin_identify::record::{ConsistentPlays, Misfit, Outcome, Specimen};
use loosepin_identify::{NO_CALLBACK, Options, identify};
use loosepin_mechanics::model::Model;
use loosepin_study::Study;
use std::path::{Path, PathBuf};

pub(crate) fn case() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/backlash_test")
}

pub(crate) fn text_of(file: &str) -> String {
    std::fs::read_to_string(case().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// A study of a model, both from text.
pub(crate) fn study(model: &str, study: &str) -> Study {
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    Study::from_text("study.toml", study, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// What the readings of the only specimen say; further readings are not looked for.
pub(crate) fn answer(study: &Study) -> Specimen {
    let options = Options { looks_further: false, ..Options::default() };
    let mut answer = identify(study, &options, NO_CALLBACK).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    assert_eq!(answer.specimens.len(), 1);
    answer.specimens.remove(0)
}

pub(crate) fn known(specimen: &Specimen) -> &ConsistentPlays {
    match &specimen.outcome {
        Outcome::Consistent(known) => known,
        Outcome::Misfit(misfit) => panic!("{misfit:?}"),
    }
}

pub(crate) fn misfit(specimen: &Specimen) -> &Misfit {
    match &specimen.outcome {
        Outcome::Misfit(misfit) => misfit,
        Outcome::Consistent(known) => panic!("{known:?}"),
    }
}
