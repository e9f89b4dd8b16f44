//! Runs to learn from, direct runs at the witnesses, and what both say.

use crate::error::StudyError;
use crate::file::Budget;
use crate::planning::goals::RoundsEnd;
use crate::question::steps::{Next, Steps};
use loosepin_bounds::{Confirmation, Goal, Learned, SampleTable, SurrogateBounds, SurrogatePlan, SurrogateRounds};

/// Step by step towards goals where surrogates stand alone, in one step beside direct bounds.
pub(crate) struct SurrogateSteps {
    rounds: SurrogateRounds,
    budget: Option<Budget>,
    stage: Stage,
    /// Steps that were made.
    steps: u32,
    /// Runs of the step that the budget did not allow.
    left: Option<usize>,
    /// What the last step learned and found.
    learned: Option<Learned>,
    found: Option<(SurrogatePlan, SurrogateBounds)>,
}

/// Answer of the surrogates.
pub struct LearnedBounds {
    /// The plan of the last step.
    pub plan: SurrogatePlan,
    /// Its bounds.
    pub bounds: SurrogateBounds,
}

/// What comes next.
enum Stage {
    /// A step begins with runs to learn from.
    Train,
    /// These are made; `is_new` is true if there were any.
    Learn { is_new: bool },
    /// Direct runs at the witnesses are made.
    Judge(Learned, Confirmation),
    /// All steps are made, or refused.
    Compare,
    /// Runs at the extremes of treatments are made, the first of them at this place of the table.
    Hold(Box<(SurrogatePlan, SurrogateBounds)>, usize),
}

impl SurrogateSteps {
    /// The steps of `plan` towards `goals`.
    ///
    /// # Errors
    /// The plan is not possible.
    pub fn new(plan: &SurrogatePlan, goals: Vec<Goal>, budget: Option<Budget>) -> Result<Self, StudyError> {
        let rounds = SurrogateRounds::new(plan.clone(), goals)?;
        Ok(Self { rounds, budget, stage: Stage::Train, steps: 0, left: None, learned: None, found: None })
    }
}

impl Steps for SurrogateSteps {
    /// With how the steps ended.
    type Answer = (LearnedBounds, RoundsEnd);

    fn next(&mut self, runs: &SampleTable) -> Result<Next<Self::Answer>, StudyError> {
        loop {
            match std::mem::replace(&mut self.stage, Stage::Compare) {
                Stage::Train => {
                    let training = self.rounds.training_round(runs.rounds())?;
                    let most = training.len() + self.rounds.plan().most_confirming();
                    self.stage = Stage::Learn { is_new: !training.is_empty() };
                    return Ok(Next::Step(training, most));
                }
                Stage::Learn { is_new } => {
                    let known = match self.learned.take().filter(|_| !is_new) {
                        Some(known) => known,
                        None => self.rounds.plan().learn(runs),
                    };
                    let confirmation = self.rounds.plan().confirmation(&known, runs.rounds(), runs)?;
                    let round = confirmation.round.clone();
                    self.stage = Stage::Judge(known, confirmation);
                    return Ok(Next::Further(round));
                }
                Stage::Judge(known, confirmation) => {
                    let bounds = self.rounds.plan().results(known.clone(), &confirmation, runs)?;
                    self.steps += 1;
                    let plan = self.rounds.plan().clone();
                    if self.rounds.advance(&bounds, runs)? {
                        self.stage = Stage::Train;
                    }
                    self.found = Some((plan, bounds));
                    self.learned = Some(known);
                }
                Stage::Compare => {
                    let (plan, bounds) = self.found.take().expect("a step is refused only after one that was made");
                    let bounds = bounds.with_treatments(&plan)?;
                    let round = bounds.extreme_round(runs.rounds());
                    self.stage = Stage::Hold(Box::new((plan, bounds)), runs.len());
                    return Ok(Next::Beside(round));
                }
                Stage::Hold(held, first) => {
                    let (plan, bounds) = *held;
                    let bounds = bounds.checked_against_extremes(&plan, runs, first)?;
                    let ended =
                        RoundsEnd::of_surrogates(&self.rounds, self.left, (self.steps, runs.len()), self.budget);
                    return Ok(Next::Answer((LearnedBounds { plan, bounds }, ended)));
                }
            }
        }
    }

    fn refuse(&mut self, runs: usize) {
        self.left = Some(runs);
        self.stage = Stage::Compare;
    }
}
