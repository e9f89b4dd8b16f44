//! The surrogate of a study: which kind, and from how many runs.

use super::ask::Ask;
use super::description::{EpistemicInput, StudySurrogate};
use super::keys::SURROGATE_KEYS;
use super::problem::StudyProblem;
use super::reader::StudyReader;
use super::words::{DIRECT_RUNS, SURROGATES};
use loosepin_text::document::Table;

impl StudyReader {
    /// Reads what stands behind `surrogate`: a kind, or a table.
    pub fn read_surrogate(
        &mut self,
        root: &Table<'_>,
        (replicates, inner): (usize, usize),
        asks: &[Ask],
    ) -> Option<StudySurrogate> {
        let entry = root.get("surrogate")?;
        let inputs = self.random.len() + self.epistemic.len();
        let mut surrogate = StudySurrogate::usual(inputs, replicates, inner);
        if entry.is_text() {
            surrogate.choice = self.reader.choice(&entry, &SURROGATES)??;
            return Some(surrogate);
        }
        let table = self.reader.table(&entry, &SURROGATE_KEYS)?;
        if let Some(kind) = table.get("kind") {
            let Some(choice) = self.reader.choice(&kind, &SURROGATES)? else {
                self.check_nothing_to_confirm(&table);
                return None;
            };
            surrogate.choice = choice;
        }
        for (key, count) in
            [("training_runs", &mut surrogate.training_runs), ("confirming_runs", &mut surrogate.confirming_runs)]
        {
            *count = self.reader.count(&table, key).map_or(*count, |written| written as usize);
        }
        if let Some(entry) = table.get("direct") {
            surrogate.is_alone = self.reader.choice(&entry, &DIRECT_RUNS)?;
            if surrogate.is_alone {
                for of in self.direct_questions(asks) {
                    self.complain(&StudyProblem::NeedsDirectRuns { entry: entry.path.describe(), of }, &entry);
                }
            }
        }
        Some(surrogate)
    }

    /// Without a surrogate the double loop is all there is.
    fn check_nothing_to_confirm(&mut self, table: &Table<'_>) {
        let Some(entry) = table.get("direct") else { return };
        if self.reader.choice(&entry, &DIRECT_RUNS) == Some(true) {
            self.complain(&StudyProblem::NothingToConfirm { entry: entry.path.describe() }, &entry);
        }
    }

    /// What is asked that the runs of the double loop alone answer.
    fn direct_questions(&self, asks: &[Ask]) -> Vec<&'static str> {
        let is_asked = |of: fn(&Ask) -> bool| asks.iter().any(of);
        let is_second_order = |input: &EpistemicInput| input.variable.is_second_order();
        let questions = [
            ("contributors", is_asked(Ask::is_for_contributors)),
            ("small probabilities by a method", is_asked(|ask| ask.by_method().next().is_some())),
            ("simultaneous bands", is_asked(|ask| ask.bands().next().is_some())),
            ("bounds by a second reading of intervals", self.readings.len() > 1),
            ("percentiles over a parameter with a distribution", self.epistemic.iter().any(is_second_order)),
        ];
        questions.into_iter().filter_map(|(of, is_there)| is_there.then_some(of)).collect()
    }
}
