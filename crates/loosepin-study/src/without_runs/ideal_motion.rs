//! The ideal motion of a file, with what its play and its scatter do to it without dynamics.

use crate::model::MotionRequest;
use crate::without_runs::judge::judge;
use crate::without_runs::judge_by_play::judge_by_play;
use crate::without_runs::judged::Judgement;
use crate::written::input_file::InputFile;
use loosepin_mechanics::model::Setting;
use loosepin_result::motion::MotionRecord;
use loosepin_result::simulation::Drawing;
use loosepin_simulate::accuracy::{AskedPose, Scatter, ScatterCorrelation};
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
        self.model().drawn_motion(&self.request(positions, &[], &[], &AtomicBool::new(false)))
    }

    /// Whether the mechanism moves, looked at in `positions` steps of the turn or as shortly as that can be known.
    ///
    /// # Errors
    /// As for [`Self::ideal_motion`].
    pub fn try_to_move(&self, positions: usize) -> Result<(), Diagnostics> {
        self.model().try_to_move(&self.request(positions, &[], &[], &AtomicBool::new(false)))
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
        self.model().motion(&self.request(positions, set, paths, stop))
    }

    /// The same, and what is wrong although there is a motion: it is without what scatters, where that alone has no answer.
    pub fn ideal_motion_with_findings(
        &self,
        positions: usize,
        paths: &[String],
        stop: &AtomicBool,
    ) -> (Option<MotionRecord>, Diagnostics) {
        self.model().motion_with_findings(&self.request(positions, &[], paths, stop))
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
        let request = MotionRequest { has_worst_cases: true, ..self.request(positions, set, paths, stop) };
        let mut record = self.model().motion(&request)?;
        if let InputFile::Study(study) = self {
            let Judgement { requirements, allowances } = match study.model.play_proofs() {
                Some(proofs) => judge_by_play(study, proofs, set, &|| stop.load(Ordering::Relaxed))?,
                None => judge(study, positions, set, stop)?,
            };
            (record.requirements, record.allowances) = (requirements, allowances);
        }
        Ok(record)
    }

    /// What is asked of the motion, without worst cases.
    fn request<'r>(
        &self,
        positions: usize,
        set: &[String],
        paths: &'r [String],
        stop: &'r AtomicBool,
    ) -> MotionRequest<'r> {
        MotionRequest {
            positions,
            settings: self.with_widest_play(set),
            paths,
            scatter: self.scatter(),
            correlations: self.linear_correlations(),
            asked: self.asked_poses(),
            asked_span: match self {
                InputFile::Model(model) => model.cycle().span,
                InputFile::Study(study) => study.cycle.span,
            },
            has_worst_cases: false,
            stop,
        }
    }

    /// The mechanism over one cycle where actuators move it, so that it has no ideal motion; `None` if drives alone do, or where it
    /// cannot be followed.
    pub fn controlled_drawing(&self, positions: usize) -> Option<Drawing> {
        self.model().controlled_drawing(&self.with_widest_play(&[]), positions)
    }

    /// Settings of the most play, if play is uncertain in a study: the worst case is taken there; `set` has priority.
    pub fn with_widest_play(&self, set: &[String]) -> Vec<String> {
        let InputFile::Study(study) = self else { return set.to_vec() };
        let is_set = |path: &str| set.iter().any(|text| Setting::is_of(text, path));
        let widest = study.widest_play().into_iter().filter(|(path, _)| !is_set(path)).map(|(_, setting)| setting);
        widest.chain(set.iter().cloned()).collect()
    }

    /// Poses that are asked about, where the file is a study.
    fn asked_poses(&self) -> Vec<AskedPose> {
        match self {
            InputFile::Model(_) => Vec::new(),
            InputFile::Study(study) => study.asked_poses(),
        }
    }

    /// Linear correlations of random inputs, where the file is a study.
    fn linear_correlations(&self) -> Vec<ScatterCorrelation> {
        match self {
            InputFile::Model(_) => Vec::new(),
            InputFile::Study(study) => study.linear_correlations(),
        }
    }

    /// Random inputs, where the file is a study.
    fn scatter(&self) -> Vec<Scatter> {
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
