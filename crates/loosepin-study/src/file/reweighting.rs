//! Whether runs at few values of the parameters of distributions are weighted for all others.

use super::StudyReader;
use super::description::{Ask, RandomInput, StudySurrogate};
use super::problem::StudyProblem;
use super::words::REWEIGHTING;
use loosepin_bounds::{NotReweighted, Reading, Reweightable};
use loosepin_text::diagnostics::Span;
use loosepin_text::document::Table;
use loosepin_uncertainty::{EpistemicParameter, EpistemicVariable, RandomVariable};

/// When runs are weighted.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum When {
    Possible,
    Always,
    Never,
}

/// What is written, and where.
pub(super) struct WrittenReweighting {
    when: When,
    entry: String,
    span: Span,
}

impl StudyReader {
    /// Reads what the table of the sampling says.
    pub(super) fn written_reweighting(&mut self, table: &Table<'_>) -> Option<WrittenReweighting> {
        let entry = table.get("reweighting")?;
        let when = self.reader.choice(&entry, &REWEIGHTING)?;
        Some(WrittenReweighting { when, entry: entry.path.describe(), span: entry.span })
    }

    /// Whether runs are weighted; where the file says nothing of it, none are.
    pub(super) fn is_reweighted(
        &mut self,
        written: Option<WrittenReweighting>,
        is_correlated: bool,
        asks: &[Ask],
        surrogate: Option<&StudySurrogate>,
    ) -> bool {
        if written.as_ref().is_none_or(|written| written.when == When::Never) {
            return false;
        }
        let Some(reason) = self.against_reweighting(is_correlated, asks, surrogate) else { return true };
        if let Some(WrittenReweighting { when: When::Always, entry, span }) = written {
            self.reader.complain(&StudyProblem::NotReweighted { entry, reason }, span);
        }
        false
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
