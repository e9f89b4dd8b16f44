//! Questions that are asked twice: the results would name two numbers alike.

use crate::file::problem::StudyProblem;
use crate::file::questions::ask::{Asked, furthest};
use crate::file::reader::StudyReader;
use crate::places::Where;
use loosepin_result::study::Deviation;
use loosepin_text::document::Entry;

impl StudyReader {
    /// Reports questions `of` an output and a deviation that were already asked at the same place. `statistics` are the entries of the
    /// list, and what they ask.
    pub(crate) fn check_new(&mut self, statistics: &[(Entry<'_>, Asked)], of: (usize, Deviation), location: &Where) {
        for (entry, asked) in statistics {
            // However it is estimated, a probability has one place in the results; of the cycle it is that of a magnitude.
            let (asked, location) = match *asked {
                Asked::Rare(statistic, _) if location.is_cycle() => {
                    (Asked::Statistic(statistic), Where::reduced(furthest(statistic)))
                }
                Asked::Rare(statistic, _) => (Asked::Statistic(statistic), location.clone()),
                asked => (asked, location.clone()),
            };
            // Two questions of the same name are the same question.
            let name = |location: Where| format!("{of:?} {location:?} {asked:?}");
            let questions: Vec<String> = location.angle_by_angle().into_iter().map(name).collect();
            if questions.iter().any(|question| self.questions.contains(question)) {
                let what = self.reader.source.text()[self.reader.source.clamp(entry.span)].to_owned();
                self.report(&StudyProblem::AskedTwice { entry: entry.path.describe(), what }, entry);
            }
            self.questions.extend(questions);
        }
    }
}
