//! Warns of what a distribution reaches with a small probability, and of quantiles that the samples do not reach.

use crate::file::check::entry_of;
use crate::file::description::{RandomInput, Sampling};
use crate::file::problem::StudyProblem;
use crate::file::questions::ask::Ask;
use crate::file::reader::StudyReader;
use crate::file::study_table::StudyTable;
use loosepin_bounds::Statistic;
use loosepin_mechanics::model::QuantityError;
use loosepin_text::diagnostics::{Diagnostic, Place};
use loosepin_uncertainty::RandomVariable;

/// Probability of impossible values below which nothing is said: a thousandth of a run among a thousand.
const MIN_TOLD: f64 = 1e-6;
/// Bisections of the logarithm of a probability: to 1e-6 of it.
const BISECTIONS: usize = 24;
/// Confidence that is left of each end of a bound: n samples hold a quantile at p with pⁿ at most this.
const BEYOND: f64 = 0.005;

impl StudyReader {
    /// Warns, at the input, of values that break a rule of the model although too seldom to be refused.
    pub(crate) fn warn_of_tails(&mut self, root: &StudyTable<'_>) {
        // Rows of a specimen were looked at whole.
        if root.specimen.is_some() {
            return;
        }
        let found: Vec<(String, StudyProblem)> =
            self.random.iter().filter_map(|input| Some((input.path.clone(), self.impossible_tail(input)?))).collect();
        for (path, problem) in found {
            let span = entry_of(&root.random, &path).map_or(root.table.span, |entry| entry.span);
            let place = Place::new(&self.reader.source, span);
            self.reader.diagnostics.push(Diagnostic::warning(&problem, Some(place)));
        }
    }

    /// The probability that the lower or upper tail of an input is impossible, all other values being those of the file.
    fn impossible_tail(&self, input: &RandomInput) -> Option<StudyProblem> {
        let quantity = input.quantity()?;
        let quantities = &self.model.quantities();
        let mut values = quantities.nominal();
        let mut wrong = |value_si: f64| quantities.evaluate_into(&[(quantity, value_si)], &mut values).err();
        let tails: [fn(&RandomVariable, f64) -> f64; 2] =
            [|variable, p| variable.quantile(p), |variable, p| variable.quantile(1.0 - p)];
        let mut probability = 0.0;
        let mut first: Option<QuantityError> = None;
        for at in tails {
            let Some(error) = wrong(at(&input.variable, MIN_TOLD)) else { continue };
            // What is impossible at half of all values was refused.
            let (mut inside, mut outside) = (MIN_TOLD.ln(), 0.5_f64.ln());
            for _ in 0..BISECTIONS {
                let middle = 0.5 * (inside + outside);
                if wrong(at(&input.variable, middle.exp())).is_some() { inside = middle } else { outside = middle }
            }
            probability += inside.exp();
            first.get_or_insert(error);
        }
        first.map(|error| StudyProblem::ImpossibleTail { path: input.path.clone(), probability, error })
    }

    /// Warns of quantiles beyond which more likely than not no sample lies: pⁿ > ½ for one at p of n samples.
    pub(crate) fn warn_of_quantiles(&mut self, root: &StudyTable<'_>, asks: &[Ask], sampling: &Sampling) {
        let Some(written) = &root.ask else { return };
        let far = |ask: &Ask| {
            let mut quantiles = ask.statistics().filter_map(Statistic::probability_of_quantile);
            quantiles.find(|p| none_beyond(*p, sampling.inner) > 0.5)
        };
        for p in asks.iter().filter_map(far) {
            let inside = p.max(1.0 - p);
            let needed = ((BEYOND.ln() / inside.ln()).ceil() as u64).next_power_of_two();
            let none_percent = 100.0 * none_beyond(p, sampling.inner);
            let problem =
                StudyProblem::QuantileBeyondSamples { percent: 100.0 * p, inner: sampling.inner, none_percent, needed };
            let place = Place::new(&self.reader.source, written.key_span);
            self.reader.diagnostics.push(Diagnostic::warning(&problem, Some(place)));
        }
    }
}

/// Probability that none of `samples` lies beyond the quantile at `p`, on its nearer side.
fn none_beyond(p: f64, samples: usize) -> f64 {
    (samples as f64 * p.max(1.0 - p).ln()).exp()
}
