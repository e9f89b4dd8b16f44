//! The ideal motion, the quasi-static answer and the identities that hold the physics together, on the mechanisms of
//! `cases/` and on small ones written here.

mod curves;
mod efforts;
mod guide;
mod kinematics;
mod lean;
mod mechanics;
mod motion;
mod near_dead_centres;
mod oracle;
mod point_path;
mod redundant;
mod runs;
mod singular;
mod worst_case;
mod worst_case_of_cycle;

use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample};
use loosepin_mechanics::model::{CycleInput, Model, QuantityId, Values};
use std::path::{Path, PathBuf};

/// A compiled mechanism with its values.
pub(crate) struct Built {
    pub(crate) values: Values,
    pub(crate) mechanism: Mechanism,
}

impl Built {
    pub(crate) fn sample(&self) -> Sample<f64> {
        Sample::new(&self.mechanism, &self.values).expect("the values fit the mechanism")
    }
    pub(crate) fn input(&self) -> CycleInput {
        self.mechanism.model.cycle_input(&self.values)
    }
    pub(crate) fn quantity(&self, path: &str) -> QuantityId {
        self.mechanism.model.quantities.id(path).unwrap_or_else(|| panic!("no quantity {path}"))
    }
}

/// Compiles a model with the quantities in `set` (path and SI value) replaced.
pub(crate) fn build_model(model: &Model, set: &[(&str, f64)]) -> Built {
    let set: Vec<(QuantityId, f64)> = set
        .iter()
        .map(|(path, value)| (model.quantities.id(path).unwrap_or_else(|| panic!("no quantity {path}")), *value))
        .collect();
    let values = model.quantities.evaluate(&set).expect("the values are sound");
    let mechanism = Mechanism::new(model, &values).unwrap_or_else(|error| panic!("{}: {error}", model.name));
    Built { values, mechanism }
}

pub(crate) fn build_case_with(case: &str, set: &[(&str, f64)]) -> Built {
    let path = cases().join(case).join("model.toml");
    build_model(&Model::from_path(&path).unwrap_or_else(|diagnostics| panic!("{diagnostics}")), set)
}

pub(crate) fn build_case(case: &str) -> Built {
    build_case_with(case, &[])
}

pub(crate) fn build_text(text: &str) -> Built {
    build_model(&Model::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}")), &[])
}

pub(crate) fn cases() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases")
}

/// Names of all cases that drives move, sorted.
pub(crate) fn case_names() -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(cases())
        .expect("the cases are there")
        .map(|entry| entry.expect("readable").path())
        .filter(|path| std::fs::read_to_string(path.join("model.toml")).is_ok_and(|model| model.contains("\n[drive.")))
        .map(|path| path.file_name().expect("a folder has a name").to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert!(names.len() > 20, "the cases are missing");
    names
}

/// The ideal motion of `built` at `time_s`.
pub(crate) fn ideal_at<'a>(built: &'a Built, sample: &'a Sample<f64>, time_s: f64) -> IdealMotion<'a> {
    let mut motion = IdealMotion::new(&built.mechanism, &sample.ideal, &sample.drives).expect("the start closes");
    motion.move_to(time_s).expect("the loops close on the way");
    motion
}

/// Numbers between -1 and 1 that do not repeat: multiples of an irrational number.
pub(crate) fn spread(index: usize, salt: f64) -> f64 {
    2.0 * ((index as f64 + 1.0) * (0.618_033_988_749_895 + salt)).fract() - 1.0
}
