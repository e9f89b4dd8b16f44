//! The places of the journals of a mechanism in space.

use super::description::{Deviation, EpistemicInput, EpistemicSubject, RandomInput, RandomSubject};
use super::problem::StudyProblem;
use super::questions::ask::Asked;
use super::reader::StudyReader;
use crate::file::measurements::specimen_problem::SpecimenProblem;
use crate::model::PLAY;
use crate::places::Where;
use loosepin_space::PlayDistribution;
use loosepin_text::document::Entry;
use loosepin_uncertainty::{Distribution, Members, RandomVariable};

/// Where the journals are, as a file says it; `None` where it is not known.
pub(super) const JOURNALS: [(&str, Option<PlayDistribution>); 3] = [
    ("unknown", None),
    ("uniform-in-play", Some(PlayDistribution::Inside)),
    ("uniform-on-rims", Some(PlayDistribution::OnTheRim)),
];

/// What is assumed of journals that are drawn, in words.
pub fn journal_words(distribution: PlayDistribution) -> &'static str {
    match distribution {
        PlayDistribution::Inside => "journals anywhere in their play, all places alike, held over the turn",
        PlayDistribution::OnTheRim => {
            "journals at the edge of their play, balls on its surface, all places there alike, held over the turn"
        }
    }
}

impl StudyReader {
    /// Reads where the journals are. Runs in the plane have contact forces that decide it.
    pub fn read_journals(&mut self, written: Option<&Entry<'_>>) {
        let Some(entry) = written else { return };
        let Some(journals) = self.reader.choice(entry, &JOURNALS) else {
            // No question is refused for what a word that cannot be read may have said.
            self.journals = Some(PlayDistribution::Inside);
            return;
        };
        let problem = if self.model.decides_journals() {
            StudyProblem::JournalsInPlane
        } else if !self.model.has_play() {
            StudyProblem::JournalsWithoutPlay
        } else {
            if journals.is_some() && self.has_rows {
                let what = "journals at places that are drawn";
                self.reader.report(&SpecimenProblem::Beside { what }, entry.span);
            }
            self.journals = journals;
            return;
        };
        self.reader.report(&problem, entry.key_span);
    }

    /// Adds the places of the journals, where a model in space has play: drawn as the file says, or else anything between what they make
    /// smallest and largest, at each position.
    pub fn add_play(&mut self) {
        if self.model.decides_journals() || !self.model.has_play() {
            return;
        }
        if let Some(distribution) = self.journals {
            let Ok(variable) = RandomVariable::try_new(Distribution::Uniform { lower: 0.0, upper: 1.0 }) else {
                return;
            };
            let numbers = self.model.uniforms_of_joints(distribution).into_iter().flat_map(|(joint, count)| {
                let place = format!("joint.{joint}.journal");
                (1..=count).map(move |number| (place.clone(), number))
            });
            let drawn = numbers.map(|(place, number)| RandomInput {
                path: format!("{place}.{number}"),
                subject: RandomSubject::Journal { place },
                variable: variable.clone(),
                origin: Some("the place of a journal in its play is drawn from it".to_owned()),
                parameters: Vec::new(),
            });
            self.random.extend(drawn);
            return;
        }
        // The middle stands for nominal parts. Everything that is asked is largest and smallest at the ends (`check_sides`), so that nothing between
        // them has to be searched.
        if let Ok(members) = Members::try_new(vec![0.0, -1.0, 1.0]) {
            let variable = members.into();
            self.epistemic.push(EpistemicInput { path: PLAY.to_owned(), subject: EpistemicSubject::Play, variable });
        }
    }

    /// Whether a deviation depends on places of journals that nothing decides.
    fn has_unknown_play(&self, deviation: Deviation) -> bool {
        let is_unknown = !self.model.decides_journals() && self.model.has_play() && self.journals.is_none();
        is_unknown && deviation.has_play()
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
        let is_magnitude = location.and_then(Where::reduction).is_some_and(|reduction| reduction.is_never_negative());
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
        location.is_cycle() || !self.has_unknown_play(deviation)
    }
}
