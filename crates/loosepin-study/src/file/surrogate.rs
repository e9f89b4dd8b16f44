//! The surrogate of a study: which kind, and from how many runs.

use super::description::{EpistemicInput, StudySurrogate};
use super::problem::StudyProblem;
use super::reader::StudyReader;
use super::sampling::MAX_INNER;
use crate::file::questions::ask::Ask;
use loosepin_surrogate::{Choice, Kind as Only};
use loosepin_text::document::{Entry, Kind, Reads, Value, choice, count};
use loosepin_text::{choices, record};

choices!(
    /// Which surrogate; nothing stands for none.
    pub(super) struct SurrogateWord(Option<Choice>):
    "auto" => Some(Choice::Auto),
    "chaos" => Some(Choice::Only(Only::Chaos)),
    "kriging" => Some(Choice::Only(Only::Kriging)),
    "network" => Some(Choice::Only(Only::Network)),
    "none" => None,
);
choices!(
    /// Which direct runs are made beside a surrogate, and whether it is then alone.
    pub(super) struct DirectRuns(bool): "double-loop" => false, "confirming" => true
);

record! {
    /// additional bounds from a surrogate (a function fitted to few runs)
    pub(super) lenient struct SurrogateTable for Reads;
    /// kind of surrogate; auto selects for each output the kind with the smallest error on held-out runs
    optional kind: SurrogateWord = choice::<SurrogateWord>(), "\"auto\"", or "auto";
    /// number of training runs; if omitted, 25 for each uncertain input and at least 100
    optional training_runs: usize = count(4, MAX_TRAINING), "100";
    /// number of direct runs at each witness, a multiple of replicates; if omitted, 16 in each replicate
    optional confirming_runs: usize = count(2, MAX_INNER), "64";
    /// double-loop: the direct bounds are also computed; confirming: the only direct runs are those at the witnesses
    optional direct: DirectRuns = choice::<DirectRuns>(), "\"confirming\"", or "double-loop";
}

/// Kind of the value of `surrogate`.
pub(super) const SURROGATE: Kind = Kind::AnyOf(&[choice::<SurrogateWord>(), Kind::Table(&SurrogateTable::KEYS)]);

/// Runs that a surrogate learns from, at most: its training takes a time that grows with their third power.
const MAX_TRAINING: u64 = 2000;
/// Training runs for each uncertain input, and at least.
const TRAINING_PER_INPUT: usize = 25;
const MIN_TRAINING: usize = 100;
/// Direct runs at a witness in each replicate.
const CONFIRMING_PER_REPLICATE: usize = 16;

impl StudyReader {
    /// Reads the value of `surrogate`: a kind, or a table.
    pub fn read_surrogate(
        &mut self,
        written: Option<&Entry<'_>>,
        (replicates, inner): (usize, usize),
        asks: &[Ask],
    ) -> Option<StudySurrogate> {
        let entry = written?;
        let inputs = self.random.len() + self.epistemic.len();
        let by_word = if entry.is_text() { Some(SurrogateWord::read(self, entry)?) } else { None };
        let table = match by_word {
            Some(kind) => SurrogateTable { kind, ..SurrogateTable::read_or_usual(self, None) },
            None => SurrogateTable::read(self, entry)?,
        };
        let alone = table.table.get("direct").filter(|_| table.direct.0);
        let Some(choice) = table.kind.0 else {
            // Without a surrogate the double loop is all there is.
            if let Some(entry) = alone {
                self.report(&StudyProblem::NothingToConfirm { entry: entry.path.describe() }, &entry);
            }
            return None;
        };
        if let Some(entry) = &alone {
            for of in self.direct_questions(asks) {
                self.report(&StudyProblem::NeedsDirectRuns { entry: entry.path.describe(), of }, entry);
            }
        }
        Some(StudySurrogate {
            choice,
            training_runs: table.training_runs.unwrap_or((TRAINING_PER_INPUT * inputs).max(MIN_TRAINING)),
            confirming_runs: table.confirming_runs.unwrap_or((CONFIRMING_PER_REPLICATE * replicates).min(inner)),
            is_alone: alone.is_some(),
        })
    }

    /// Questions that the runs of the double loop alone answer.
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
