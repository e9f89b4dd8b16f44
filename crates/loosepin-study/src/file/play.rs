//! The places of the journals of a mechanism in space.

use super::description::{Deviation, EpistemicInput, EpistemicSubject};
use super::problem::StudyProblem;
use super::questions::ask::Asked;
use super::questions::location::Where;
use super::reader::StudyReader;
use loosepin_text::document::Entry;
use loosepin_uncertainty::Members;

/// Path of the input that stands for the places of all journals.
pub(crate) const PLAY: &str = "play";

impl StudyReader {
    /// Adds the places of the journals, where a model in space has play: anything between what they make smallest and largest, at each position.
    /// Runs in the plane have contact forces that decide where a journal is.
    pub fn add_play(&mut self) {
        if self.model.spatial().is_none() || !self.model.has_play() {
            return;
        }
        // The middle stands for nominal parts. Everything that is asked is largest and smallest at the ends (`check_sides`), so that nothing between
        // them has to be searched.
        if let Ok(members) = Members::try_new(vec![0.0, -1.0, 1.0]) {
            let variable = members.into();
            self.epistemic.push(EpistemicInput { path: PLAY.to_owned(), subject: EpistemicSubject::Play, variable });
        }
    }

    /// Whether a deviation depends on places of journals that no force decides.
    fn has_unknown_play(&self, deviation: Deviation) -> bool {
        self.model.spatial().is_some() && self.model.has_play() && deviation != Deviation::Dimensional
    }

    /// Refuses statistics whose largest value is not where all mechanisms have their journals on one side: what is monotone in a number has its
    /// ends there, a standard deviation or a probability of leaving to either side has not.
    pub(crate) fn check_sides(
        &mut self,
        entries: &[(Entry<'_>, Asked)],
        deviation: Option<Deviation>,
        location: Option<&Where>,
    ) {
        if !deviation.is_some_and(|deviation| self.has_unknown_play(deviation)) {
            return;
        }
        let is_magnitude = matches!(location, Some(Where::Reduced(reduction)) if reduction.is_never_negative());
        for (entry, asked) in entries {
            let is_of_one_side = match asked {
                Asked::Contributors => true,
                Asked::SimultaneousBand(_) => false,
                Asked::Statistic(statistic) | Asked::Rare(statistic, _) => {
                    statistic.is_monotone() || is_magnitude && statistic.is_by_shares()
                }
            };
            if !is_of_one_side {
                self.report(&StudyProblem::NotOfOneSide { entry: entry.path.describe() }, entry);
            }
        }
    }

    /// Whether a limit to both sides at poses can be judged: over the cycle the largest magnitude decides.
    pub(crate) fn can_judge_both_sides(&self, deviation: Deviation, location: &Where) -> bool {
        *location == Where::Cycle || !self.has_unknown_play(deviation)
    }
}
