//! What a check does with each kind of model. Which one a file has is asked here alone.

use std::sync::atomic::{AtomicBool, Ordering};

use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{Model, Values};
use loosepin_simulate::bodies_that_move;
use loosepin_space::{IsStopped, SpatialModel};
use loosepin_study::{Study, StudyModel};
use loosepin_text::article::Article;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics};
use loosepin_text::plausible::JudgedModel;

use super::trial::TrialResult;
use super::{mechanism, space, study, trial};

/// A model that can be checked, by itself or with a study of it.
pub trait CheckedModel {
    /// Warnings of outputs whose bodies stand still over the whole cycle; none of a mechanism that cannot be moved, which is refused elsewhere.
    fn standing_still(&self, values: &Values, is_stopped: IsStopped) -> Vec<Diagnostic>;

    /// Moves it for the first time, and describes it.
    ///
    /// # Errors
    /// What keeps it from running; that it was stopped.
    fn describe(&self, stop: &AtomicBool) -> Result<Article, Diagnostics>;

    /// The errors of [`Self::describe`] that are found in a moment; without any, warnings of outputs that never move.
    ///
    /// # Errors
    /// As for [`Self::describe`].
    fn try_alone(&self, stop: &AtomicBool) -> Result<Vec<Diagnostic>, Diagnostics>;

    /// Moves it for the first time with the values of `study`, and describes that.
    ///
    /// # Errors
    /// What keeps the study from running; that it was stopped.
    fn describe_study(&self, study: &Study, stop: &AtomicBool) -> Result<Article, Diagnostics>;

    /// The errors of [`Self::describe_study`] without those of its plan; without any, warnings of outputs that never move.
    ///
    /// # Errors
    /// As for [`Self::describe_study`].
    fn try_study(&self, study: &Study, stop: &AtomicBool) -> Result<Vec<Diagnostic>, Diagnostics>;
}

/// `model` as it is checked.
pub fn checked(model: &StudyModel) -> &dyn CheckedModel {
    match model {
        StudyModel::Planar(model) => &**model,
        StudyModel::Spatial(model) => &**model,
    }
}

/// Warnings of outputs whose bodies stand still over the whole cycle.
pub fn never_moving(mechanism: &Mechanism, values: &Values) -> Vec<Diagnostic> {
    bodies_that_move(mechanism, values).map_or_else(Vec::new, |moved| mechanism.model.never_moving(moved))
}

impl CheckedModel for Model {
    fn standing_still(&self, values: &Values, _is_stopped: IsStopped) -> Vec<Diagnostic> {
        Mechanism::new(self, values).map_or_else(|_| Vec::new(), |mechanism| never_moving(&mechanism, values))
    }

    fn describe(&self, stop: &AtomicBool) -> Result<Article, Diagnostics> {
        let Tried { mechanism, values, result } = try_model(self, stop)?;
        Ok(mechanism::article(&mechanism, &values, &result))
    }

    fn try_alone(&self, stop: &AtomicBool) -> Result<Vec<Diagnostic>, Diagnostics> {
        try_model(self, stop).map(|tried| never_moving(&tried.mechanism, &tried.values))
    }

    fn describe_study(&self, study: &Study, stop: &AtomicBool) -> Result<Article, Diagnostics> {
        let Tried { values, result, .. } = try_with_study(self, study, stop)?;
        study::article(study, self, &values, &result)
    }

    fn try_study(&self, study: &Study, stop: &AtomicBool) -> Result<Vec<Diagnostic>, Diagnostics> {
        try_with_study(self, study, stop).map(|tried| never_moving(&tried.mechanism, &tried.values))
    }
}

impl CheckedModel for SpatialModel {
    fn standing_still(&self, values: &Values, is_stopped: IsStopped) -> Vec<Diagnostic> {
        let moved = self.bodies_that_move(values, is_stopped);
        moved.map_or_else(Vec::new, |moved| self.never_moving(moved))
    }

    fn describe(&self, stop: &AtomicBool) -> Result<Article, Diagnostics> {
        space::check_space(self, &|| stop.load(Ordering::Relaxed))
    }

    /// Without a study there are no errors but those of its motion.
    fn try_alone(&self, stop: &AtomicBool) -> Result<Vec<Diagnostic>, Diagnostics> {
        let is_stopped = || stop.load(Ordering::Relaxed);
        Ok(self.standing_still(&self.quantities.nominal(), &is_stopped))
    }

    fn describe_study(&self, study: &Study, _stop: &AtomicBool) -> Result<Article, Diagnostics> {
        study::middle_values(study)?;
        study::article_in_space(study)
    }

    fn try_study(&self, study: &Study, stop: &AtomicBool) -> Result<Vec<Diagnostic>, Diagnostics> {
        let is_stopped = || stop.load(Ordering::Relaxed);
        Ok(self.standing_still(&study::middle_values(study)?, &is_stopped))
    }
}

/// A mechanism that has moved for the first time.
struct Tried {
    mechanism: Mechanism,
    values: Values,
    result: TrialResult,
}

fn try_model(model: &Model, stop: &AtomicBool) -> Result<Tried, Diagnostics> {
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(model, &values).map_err(|error| error.diagnostic(model))?;
    if !mechanism.is_driven() {
        // Forces decide where it goes: without them nothing is known of it.
        model.demand_dynamics()?;
    }
    // A study has a cycle of its own, with limits of its own.
    trial::check_run(&mechanism, &values).map_err(|failure| failure.diagnostic(model))?;
    let result = trial::run_trial(&mechanism, &values, stop).map_err(|failure| failure.diagnostic(model))?;
    Ok(Tried { mechanism, values, result })
}

fn try_with_study(model: &Model, study: &Study, stop: &AtomicBool) -> Result<Tried, Diagnostics> {
    let values = study::middle_values(study)?;
    let mechanism = Mechanism::new(model, &values).map_err(|error| error.diagnostic(model))?;
    if study.needs_runs() || !mechanism.is_driven() {
        model.demand_dynamics()?;
    }
    let result = trial::run_trial(&mechanism, &values, stop).map_err(|failure| failure.diagnostic(model))?;
    Ok(Tried { mechanism, values, result })
}
