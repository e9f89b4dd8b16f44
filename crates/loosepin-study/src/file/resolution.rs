//! Holds the tolerance of the runs against the smallest clearance that the inputs allow.

use super::StudyReader;
use super::description::EpistemicInput;
use super::sampling::SamplingTable;
use loosepin_mechanics::model::QuantityId;
use loosepin_simulate::{SmallestClearance, ToleranceProblem};
use loosepin_text::diagnostics::{Diagnostic, Place};
use loosepin_uncertainty::EpistemicVariable;

/// Probabilities at which a random input counts as small, the first at which there is play: a normal one has no smallest value.
const SMALL: [f64; 3] = [1e-3, 1e-2, 0.5];

impl StudyReader {
    /// Reports, at the tolerance, where it is too coarse for a clearance.
    pub(super) fn check_tolerance(&mut self, sampling: &SamplingTable<'_>, tolerance_m: f64) {
        let Some(smallest) = self.smallest_clearance() else { return };
        let diagnostic: fn(&ToleranceProblem, Option<Place>) -> Diagnostic;
        let problem = match smallest.check(tolerance_m) {
            Ok(None) => return,
            Ok(Some(warning)) => {
                diagnostic = |problem, place| Diagnostic::warning(problem, place);
                warning
            }
            Err(error) => {
                diagnostic = |problem, place| Diagnostic::error(problem, place);
                error
            }
        };
        let span = sampling.table.get("tolerance").map_or(sampling.table.span, |entry| entry.span);
        let place = Place::new(&self.reader.source, span);
        self.reader.diagnostics.push(diagnostic(&problem, Some(place)));
    }

    /// The smallest clearance of all joints and couplings, each with the inputs that it depends on where they make it smallest.
    fn smallest_clearance(&self) -> Option<SmallestClearance> {
        let smallest = self.model.integrated_clearances().into_iter().filter_map(|(play, clearance)| {
            let sizes = SMALL.into_iter().filter_map(|small| self.clearance_m(clearance, small));
            // The smallest of all inputs at once may be impossible where each of them alone is not.
            let clearance_m = sizes.chain(self.middle_clearance_m(clearance)).find(|size| *size > 0.0)?;
            Some(SmallestClearance { play, clearance_m })
        });
        smallest.min_by(|a, b| a.clearance_m.total_cmp(&b.clearance_m))
    }

    /// A clearance with random inputs at the probability `small` or one less that, intervals at an end: each input where it
    /// makes the clearance smaller, the others in the middle.
    fn clearance_m(&self, clearance: QuantityId, small: f64) -> Option<f64> {
        let roots = self.model.quantities().roots(clearance);
        let ends: Vec<(QuantityId, [f64; 2])> =
            self.input_ends(small).into_iter().filter(|(quantity, _)| roots.contains(quantity)).collect();
        let middle: Vec<(QuantityId, f64)> = ends.iter().map(|(id, [low, high])| (*id, 0.5 * (low + high))).collect();
        let with = |set: &[(QuantityId, f64)]| Some(self.model.quantities().evaluate(set).ok()?[clearance]);
        let mut chosen = middle.clone();
        for (index, (_, ends)) in ends.iter().enumerate() {
            let mut tried = middle.clone();
            let at_end = ends.map(|end| {
                tried[index].1 = end;
                with(&tried)
            });
            chosen[index].1 = if at_end[1]? < at_end[0]? { ends[1] } else { ends[0] };
        }
        with(&chosen)
    }

    /// A clearance with all inputs in the middle.
    fn middle_clearance_m(&self, clearance: QuantityId) -> Option<f64> {
        let middle = self.input_ends(0.5).into_iter().map(|(quantity, [low, high])| (quantity, 0.5 * (low + high)));
        Some(self.model.quantities().evaluate(&middle.collect::<Vec<_>>()).ok()?[clearance])
    }

    fn input_ends(&self, small: f64) -> Vec<(QuantityId, [f64; 2])> {
        let random = self.random.iter().filter_map(|input| {
            let corners = |known: &EpistemicVariable| known.ends().to_vec();
            let variables = input.variables(&self.epistemic, corners);
            let low = variables.iter().map(|variable| variable.quantile(small)).fold(f64::INFINITY, f64::min);
            let high =
                variables.iter().map(|variable| variable.quantile(1.0 - small)).fold(f64::NEG_INFINITY, f64::max);
            Some((input.quantity()?, [low, high]))
        });
        let known = |input: &EpistemicInput| Some((input.quantity()?, input.variable.ends()));
        random.chain(self.epistemic.iter().filter_map(known)).collect()
    }
}
