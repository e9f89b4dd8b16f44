//! The ideal motion of a file, with what its play and its scatter do to it without dynamics.

use crate::without_runs::judge::{Judgement, judge};
use crate::written::input_file::InputFile;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_result::motion::MotionRecord;
use loosepin_result::simulation::Drawing;
use loosepin_simulate::accuracy::{
    AskedPose, MotionPlan, Scatter, ScatterCorrelation, motion_until, motion_with_worst_cases_until,
};
use loosepin_simulate::controlled_drawing;
use loosepin_simulate::record::Override;
use loosepin_text::diagnostics::Diagnostics;
use std::sync::atomic::{AtomicBool, Ordering};

impl InputFile {
    /// The ideal motion over one turn in `positions` steps, in space in those of its file, with the quasi-static answer to first order; `set` are settings `path=value`. Clearances
    /// that are uncertain in a study are taken where there is most play, other random inputs by their standard deviation.
    ///
    /// # Errors
    /// A setting that the model does not take; a mechanism that cannot be assembled, or is not driven.
    pub fn ideal_motion(&self, positions: usize, set: &[String]) -> Result<MotionRecord, Diagnostics> {
        self.ideal_motion_until(positions, set, &[], &AtomicBool::new(false))
    }

    /// The same to be drawn: in space without outputs and what play does to them.
    ///
    /// # Errors
    /// As for [`Self::ideal_motion`].
    pub fn drawn_motion(&self, positions: usize) -> Result<MotionRecord, Diagnostics> {
        match self.model().spatial() {
            Some(model) => model.drawn_motion_until(&model.quantities.nominal(), &|| false),
            None => self.ideal_motion(positions, &[]),
        }
    }

    /// As [`Self::ideal_motion`], with the paths of the points called `paths`.
    ///
    /// # Errors
    /// As for [`Self::ideal_motion`]; a path of a point that the model does not have.
    pub fn ideal_motion_with_paths(&self, positions: usize, paths: &[String]) -> Result<MotionRecord, Diagnostics> {
        self.ideal_motion_until(positions, &[], paths, &AtomicBool::new(false))
    }

    /// As [`Self::ideal_motion_with_paths`] with settings, until `stop` is set.
    ///
    /// # Errors
    /// As for [`Self::ideal_motion`]; a path of a point that the model does not have; that it was stopped.
    pub fn ideal_motion_until(
        &self,
        positions: usize,
        set: &[String],
        paths: &[String],
        stop: &AtomicBool,
    ) -> Result<MotionRecord, Diagnostics> {
        self.moved(positions, set, paths, false, stop)
    }

    /// As [`Self::ideal_motion`], with worst cases of the play, the largest found and proven ends, with the requirements of a study
    /// judged by them, and with the paths of the points called `paths`, until `stop` is set.
    ///
    /// # Errors
    /// As for [`Self::ideal_motion`]; a path of a point that the model does not have; that it was stopped.
    pub fn ideal_motion_with_worst_cases(
        &self,
        positions: usize,
        set: &[String],
        paths: &[String],
        stop: &AtomicBool,
    ) -> Result<MotionRecord, Diagnostics> {
        self.moved(positions, set, paths, true, stop)
    }

    fn moved(
        &self,
        positions: usize,
        given: &[String],
        paths: &[String],
        has_worst_cases: bool,
        stop: &AtomicBool,
    ) -> Result<MotionRecord, Diagnostics> {
        if let Some(model) = self.model().spatial() {
            let is_stopped = || stop.load(Ordering::Relaxed);
            return self.moved_in_space(model, given, paths, has_worst_cases, &is_stopped);
        }
        let model = self.model().demand_planar()?;
        let settings = self.with_widest_play(given);
        let set = model.set_values(&settings)?;
        let paths = model.points_of_paths(paths)?;
        let mechanism = Mechanism::new(&set.model, &set.values).map_err(|error| error.diagnostic(model))?;
        let plan = MotionPlan {
            span: model.cycle.span,
            positions,
            scatter: self.scatter(),
            correlations: self.linear_correlations(),
            paths,
            asked: self.asked_poses(),
            overrides: Override::from_settings(&settings),
        };
        let motion = if has_worst_cases { motion_with_worst_cases_until } else { motion_until };
        let mut record = motion(&mechanism, &set.values, &plan, stop).map_err(|error| error.diagnostic(model))?;
        if let InputFile::Study(study) = self
            && has_worst_cases
        {
            let Judgement { requirements, allowances } = judge(study, model, positions, given, stop)?;
            (record.requirements, record.allowances) = (requirements, allowances);
        }
        Ok(record)
    }

    /// The mechanism over one cycle where actuators move it, so that it has no ideal motion; `None` if drives alone do, or where it
    /// cannot be followed.
    pub fn controlled_drawing(&self, positions: usize) -> Option<Drawing> {
        let model = self.model().planar()?;
        let set = model.set_values(&self.with_widest_play(&[])).ok()?;
        let mechanism = Mechanism::new(&set.model, &set.values).ok()?;
        if mechanism.is_driven() {
            return None;
        }
        controlled_drawing(&mechanism, &set.values, positions).ok()
    }

    /// Settings of the most play, if play is uncertain in a study: the worst case is taken there; `set` has priority.
    pub fn with_widest_play(&self, set: &[String]) -> Vec<String> {
        let InputFile::Study(study) = self else { return set.to_vec() };
        let is_set =
            |path: &str| set.iter().any(|text| text.split_once('=').is_some_and(|(own, _)| own.trim() == path));
        let widest = study.widest_play().into_iter().filter(|(path, _)| !is_set(path)).map(|(_, setting)| setting);
        widest.chain(set.iter().cloned()).collect()
    }

    /// Poses that are asked about, where the file is a study.
    pub(super) fn asked_poses(&self) -> Vec<AskedPose> {
        match self {
            InputFile::Model(_) => Vec::new(),
            InputFile::Study(study) => study.asked_poses(),
        }
    }

    /// Linear correlations of random inputs, where the file is a study.
    pub(super) fn linear_correlations(&self) -> Vec<ScatterCorrelation> {
        match self {
            InputFile::Model(_) => Vec::new(),
            InputFile::Study(study) => study.linear_correlations(),
        }
    }

    /// Random inputs, where the file is a study.
    pub(super) fn scatter(&self) -> Vec<Scatter> {
        match self {
            InputFile::Model(_) => Vec::new(),
            InputFile::Study(study) => study
                .random
                .iter()
                .filter_map(|input| {
                    let standard_deviation_si = input.largest_standard_deviation(&study.epistemic);
                    Some(Scatter { quantity: input.quantity()?, standard_deviation_si })
                })
                .collect(),
        }
    }
}
