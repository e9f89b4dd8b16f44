//! A study file as a whole: the keys that questions share, then the tables of single questions.

use super::input::EpistemicTable;
use super::play::JOURNALS;
use super::sampling::{SamplingTable, StudyCycleTable};
use super::surrogate::SURROGATE;
use super::words::{READINGS, words};
use crate::file::measurements::measured::ReadingTable;
use crate::file::measurements::motion::MotionTable;
use crate::file::measurements::specimen::SpecimenTable;
use crate::file::questions::allow::{AllowTable, TogetherWord};
use crate::file::questions::ask::AskTable;
use crate::file::questions::promise::PromiseTable;
use crate::file::questions::requirement::RequireTable;
use crate::file::random_inputs::correlation::CorrelationTable;
use crate::file::random_inputs::random::RANDOM_KEYS;
use crate::question::question_keys;
use loosepin_text::document::{Entry, Keys, Kind, Reads, choice, count};
use loosepin_text::record;
use loosepin_text::units::Rule;
use std::sync::LazyLock;

/// What a double holds exactly, so that a seed survives every file format.
const MAX_SEED: u64 = (1 << 53) - 1;

record! {
    /// the uncertain inputs of a model, and the questions
    pub(super) lenient struct StudyTable for Reads;
    /// name of the study
    required name: String = Kind::Text, "\"worn pin at 5000 rpm\"";
    /// the model file, relative to the folder of this file
    required model: Entry<'t> = Kind::Text, "\"model.toml\"";
    /// seed of the random numbers; the same seed gives the same results
    optional seed: u64 = count(0, MAX_SEED), "1", or 1;
    /// the turns to simulate and to record, where they differ from the model
    optional cycle: Entry<'t> = Kind::Table(&StudyCycleTable::KEYS), "";
    /// the number of runs and their accuracy
    optional sampling: Entry<'t> = Kind::Table(&SamplingTable::KEYS), "";
    /// additional bounds from a surrogate (a function fitted to few runs); none if omitted
    optional surrogate: Entry<'t> = SURROGATE, "\"auto\"";
    /// settings of promised bounds, which hold in a share of the box of the intervals and need no model of the statistic; for questions
    /// with promise and requirements with decided_by = "promise"
    optional promise: Entry<'t> = Kind::Table(&PromiseTable::KEYS), "";
    /// quantities with known distributions, by their paths in the model
    optional random: Entry<'t> = Kind::Tables { keys: &RANDOM_KEYS, except: &[] }, "";
    /// unknown (epistemic) inputs: quantities known only as intervals, and quantities and laws known only as lists, by their paths in the
    /// model
    optional epistemic: Entry<'t> = Kind::Tables { keys: &EpistemicTable::KEYS, except: &[] }, "";
    /// where the journals of a model in space are in their play: anywhere at each position, or at places that are drawn for each mechanism and
    /// held over the turn, with all places in the play alike or all places on its rims alike (of balls on the surface); unknown if omitted
    optional journals: Entry<'t> = Kind::Choice(&words(&JOURNALS)), "\"uniform-in-play\"";
    /// correlated random inputs; all others are independent
    optional correlation: Entry<'t> = Kind::List(&Kind::Table(&CorrelationTable::KEYS)), "";
    /// a measured mechanism: rows of values instead of the distributions under `[random]`; if omitted, any mechanism of the series
    optional specimen: Entry<'t> = Kind::Table(&SpecimenTable::KEYS), "";
    /// meaning of an interval: one fixed but unknown value, an unknown distribution, or any value for each sample; fixed if omitted; with
    /// several readings, their bounds are shown side by side
    optional reading: Entry<'t> =
        Kind::AnyOf(&[Kind::Choice(&words(&READINGS)), Kind::List(&Kind::Choice(&words(&READINGS)))]), "\"fixed\"";
    /// percentiles of each statistic, if a parameter of a distribution has a distribution; 0.05, 0.5 and 0.95 if omitted
    optional percentiles: Entry<'t> = Kind::List(&Kind::Number { rule: Rule::Probability }), "[0.05, 0.5, 0.95]";
    /// questions
    optional ask: Entry<'t> = Kind::List(&Kind::Table(&AskTable::KEYS)), "";
    /// requirements
    optional require: Entry<'t> = Kind::List(&Kind::Table(&RequireTable::KEYS)), "";
    /// readings of a backlash test, or features of a motion, from which `loosepin identify` narrows intervals
    optional measured: Entry<'t> =
        Kind::List(&Kind::AnyOf(&[Kind::Table(&ReadingTable::KEYS), Kind::Table(&MotionTable::KEYS)])), "";
    /// uncertain inputs to loosen as far as the requirements permit, by their paths
    optional allow: Entry<'t> = Kind::Tables { keys: &AllowTable::KEYS, except: &[] }, "";
    /// loosens the inputs of `[allow]` together: each to the same share of its `up_to`, or two of them as a curve; one at a time if omitted
    optional allow_together: Entry<'t> = choice::<TogetherWord>(), "\"frontier\"";
}

/// Keys of a study file: those of [`StudyTable`], and the tables of single questions.
pub(super) static STUDY_KEYS: LazyLock<Keys> = LazyLock::new(|| {
    let keys = StudyTable::KEYS.keys.iter().copied().chain(question_keys()).collect::<Vec<_>>();
    // They live as long as the program.
    Keys { keys: keys.leak(), ..StudyTable::KEYS }
});

#[cfg(test)]
mod tests {
    use crate::file::evidence::FuzzyTable;
    use crate::file::questions::promise::PromiseTable;
    use crate::file::sampling::SamplingTable;
    use crate::file::study_table::StudyTable;
    use loosepin_bounds::{PERCENTILES, PromiseSettings, Sampling};
    use loosepin_text::document::{Keys, listed};
    use loosepin_text::units::format_number;
    use loosepin_uncertainty::USUAL_CUTS;

    #[test]
    fn what_a_file_leaves_out_is_told_as_the_library_has_it() {
        let Sampling { outer, inner, seed, .. } = Sampling::default();
        let promise = PromiseSettings::default();
        let words = |numbers: &[f64]| listed(&numbers.iter().copied().map(format_number).collect::<Vec<_>>(), "and");
        let told: [(&Keys, &str, String); 8] = [
            (&StudyTable::KEYS, "seed", seed.to_string()),
            (&StudyTable::KEYS, "percentiles", words(&PERCENTILES)),
            (&SamplingTable::KEYS, "outer", outer.to_string()),
            (&SamplingTable::KEYS, "inner", inner.to_string()),
            (&PromiseTable::KEYS, "share", promise.share.to_string()),
            (&PromiseTable::KEYS, "confidence", promise.confidence.to_string()),
            (&PromiseTable::KEYS, "inner", promise.inner.to_string()),
            (&FuzzyTable::KEYS, "degrees", words(&USUAL_CUTS)),
        ];
        for (keys, key, due) in told {
            let doc = keys.find(key).map_or("", |known| known.doc);
            assert!(doc.ends_with(&format!("; {due} if omitted")), "{key}: {doc}; {due}");
        }
    }
}
