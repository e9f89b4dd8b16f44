//! Whether runs at few values of the parameters of distributions are weighted for all others.

use super::StudyReader;
use super::description::{Ask, RandomInput, StudySurrogate};
use super::keys::SAMPLING_KEYS;
use super::problem::StudyProblem;
use crate::bounds::{NotReweighted, Reading, Reweightable};
use crate::document::Table;
use crate::uncertainty::{EpistemicParameter, EpistemicVariable, RandomVariable};

/// When runs are weighted.
#[derive(Clone, Copy, PartialEq)]
enum When {
    Possible,
    Always,
    Never,
}

impl StudyReader {
    /// Reads whether runs are weighted; where the file leaves it open, they are where that is possible.
    pub fn read_reweighting(
        &mut self,
        root: &Table<'_>,
        is_correlated: bool,
        asks: &[Ask],
        surrogate: Option<&StudySurrogate>,
    ) -> bool {
        let table = root.get("sampling").and_then(|entry| self.reader.table(&entry, &SAMPLING_KEYS));
        let entry = table.as_ref().and_then(|table| table.get("reweighting"));
        let choices = [("automatic", When::Possible), ("always", When::Always), ("never", When::Never)];
        let when = entry.as_ref().and_then(|entry| self.reader.choice(entry, &choices)).unwrap_or(When::Possible);
        if when == When::Never {
            return false;
        }
        match (self.against_reweighting(is_correlated, asks, surrogate), &entry) {
            (None, _) => true,
            (Some(reason), Some(entry)) if when == When::Always => {
                self.complain(&StudyProblem::NotReweighted { entry: entry.path.describe(), reason }, entry);
                false
            }
            (Some(_), _) => false,
        }
    }

    /// What speaks against it, in words.
    fn against_reweighting(
        &self,
        is_correlated: bool,
        asks: &[Ask],
        surrogate: Option<&StudySurrogate>,
    ) -> Option<String> {
        let random: Vec<RandomVariable> = self.random.iter().map(|input| input.variable.clone()).collect();
        let epistemic: Vec<EpistemicVariable> = self.epistemic.iter().map(|input| input.variable.clone()).collect();
        let parameters: Vec<EpistemicParameter> = RandomInput::epistemic_parameters(&self.random);
        let is_fixed = self.readings[..] == [Reading::FixedButUnknown];
        let possible =
            Reweightable { random: &random, epistemic: &epistemic, parameters: &parameters, is_correlated, is_fixed };
        let words = |index: usize| format!("'{}'", self.epistemic[index].path);
        Some(match possible.check() {
            Err(NotReweighted::NothingEpistemic) => "no parameter of a distribution is uncertain".to_owned(),
            Err(NotReweighted::NoParameter { epistemic }) => {
                format!("{} is no parameter of a distribution: the runs know it", words(epistemic))
            }
            Err(NotReweighted::OtherKnowledge { epistemic }) => {
                format!("{} is neither an interval nor a list", words(epistemic))
            }
            Err(NotReweighted::Correlated) => "random inputs are correlated".to_owned(),
            Err(NotReweighted::OtherReading) => "intervals are not read as fixed alone".to_owned(),
            Err(NotReweighted::NoDensity { random }) => {
                format!("the distribution of '{}' has no density", self.random[random].path)
            }
            Ok(()) if asks.iter().any(|ask| ask.contributors) => {
                "contributors are told by a model of the response over all points".to_owned()
            }
            Ok(()) if surrogate.is_some_and(|surrogate| surrogate.is_alone) => {
                "a surrogate stands in place of the double loop".to_owned()
            }
            Ok(()) => return None,
        })
    }
}
