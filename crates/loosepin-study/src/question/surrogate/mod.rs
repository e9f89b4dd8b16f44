//! Surrogates: runs to learn from, direct runs at the witnesses, and what both say.
//! The functions themselves are learnt in `loosepin-surrogate`.

mod plan;
mod record;
mod saved;
mod steps;

pub use plan::{most_surrogate_runs, surrogate_plan};
pub use saved::{SavedInput, SavedOutput, SavedSurrogateError, SavedSurrogates};
pub use steps::LearnedBounds;
pub(crate) use steps::SurrogateSteps;

use super::found::{Found, StudyRun};
use super::kind::{Planned, Question, QuestionContext};
use super::steps::take_steps;
use crate::assemble::{Material, treatments_by_surrogates_alone};
use crate::error::StudyError;
use crate::runs::all_runs::Runs;
use loosepin_bounds::SurrogatePlan;

/// What surrogates say, beside direct bounds or alone.
struct SurrogateQuestion {
    plan: SurrogatePlan,
    most_runs: usize,
    is_alone: bool,
}

/// Planned where the study asks for surrogates.
pub fn planned(basis: &QuestionContext<'_>) -> Planned {
    let question = |plan: &SurrogatePlan| -> Box<dyn Question> {
        let is_alone = basis.is_surrogate_alone;
        Box::new(SurrogateQuestion { plan: plan.clone(), most_runs: most_surrogate_runs(basis.study, plan), is_alone })
    };
    Ok(basis.surrogate.map(question))
}

impl Question for SurrogateQuestion {
    fn most_runs(&self) -> usize {
        // Alone they give the bounds.
        if self.is_alone { 0 } else { self.most_runs }
    }

    fn run(&mut self, runs: &mut Runs<'_>, found: &mut Found) -> Result<(), StudyError> {
        if found.surrogate.is_none() {
            let (learned, _) = take_steps(SurrogateSteps::new(&self.plan, Vec::new(), None)?, runs, None)?;
            found.surrogate = Some(learned);
        }
        Ok(())
    }

    fn record(&self, material: &Material<'_>, found: &Found, run: &mut StudyRun) -> Result<(), StudyError> {
        let Some(LearnedBounds { plan, bounds }) = &found.surrogate else { return Ok(()) };
        run.surrogates = Some(record::saved_surrogates(material, &run.result.input_hash, plan, bounds));
        run.result.surrogate = Some(record::surrogate_record(material, plan, bounds));
        if self.is_alone {
            run.result.treatments = treatments_by_surrogates_alone(material, plan, bounds);
        }
        Ok(())
    }
}
