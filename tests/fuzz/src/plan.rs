//! Does with a model file or a study file what `loosepin check` does once it is read: compiles the mechanism, plans the runs.

use loosepin::mechanism::{Mechanism, Sample};
use loosepin::model::Model;
use loosepin::study::{Study, plan_runs};

use super::model::show_one;

/// Reads a file, a model where it has bodies, and plans what it says.
pub fn read(bytes: &[u8]) {
    if bytes.windows(BODY.len()).any(|window| window == BODY) {
        super::model::read(bytes).iter().for_each(compile);
    } else {
        super::study::read(bytes).iter().for_each(plan);
    }
}

/// Only models have them.
const BODY: &[u8] = b"[body.";

/// The mechanism is compiled or reported.
pub fn compile(model: &Model) {
    let values = model.quantities.nominal();
    match Mechanism::new(model, &values) {
        Err(error) => show_one(error.diagnostic(model)),
        Ok(mechanism) => {
            if let Err(failure) = Sample::<f64>::new(&mechanism, &values) {
                assert!(!failure.to_string().is_empty());
            }
        }
    }
}

/// The runs are counted, or the study is reported.
pub fn plan(study: &Study) {
    if let Err(error) = plan_runs(study) {
        show_one(error.diagnostic(study));
    }
}
