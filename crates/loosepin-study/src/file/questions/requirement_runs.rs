//! Whether the runs at each value of the epistemic inputs suffice for the requirements.

use crate::file::description::Sampling;
use crate::file::problem::StudyProblem;
use crate::file::questions::requirement::Requirement;
use crate::file::reader::StudyReader;
use crate::file::sampling::SamplingTable;
use loosepin_bounds::least_counted_runs;
use loosepin_text::diagnostics::{Diagnostic, Place};
use loosepin_text::document::Entry;

/// `inner` is raised to this at most where the file leaves it out: more runs than that are somebody's decision.
const MAX_RAISED: usize = 1 << 14;

impl StudyReader {
    /// Raises `inner`, where it is left out, to the runs without which the largest required share cannot be shown by counting; warns where it
    /// is written and smaller, or where that would be too many.
    ///
    /// A share p counts as shown where N runs, all inside the limit, leave no more than 1 - p outside: p^N <= γ, with γ the chance that the
    /// upper limit of Clopper and Pearson is missed. Where the response is smooth in the random inputs, fewer runs may show it.
    pub(crate) fn suffice_for_requirements(
        &mut self,
        written: Option<&Entry<'_>>,
        table: &SamplingTable<'_>,
        requirements: &[Requirement],
        sampling: &mut Sampling,
    ) {
        // A share without random inputs is 0 or 1, and known from one run.
        let entries = self.double_brackets(written);
        let is_read = entries.len() == requirements.len();
        if self.random.is_empty() || !is_read {
            return;
        }
        let is_inner_written = table.table.has("inner");
        // With an accuracy or a budget the samples grow, or are limited on purpose.
        if table.accuracy.is_some() || table.budget.is_some() {
            return;
        }
        let counted: Vec<usize> = requirements
            .iter()
            .map(|requirement| match requirement.probability_at_least {
                share if share < 1.0 && !requirement.is_promised => least_counted_runs(share, sampling.replicates),
                _ => 0,
            })
            .collect();
        if !is_inner_written {
            let most = counted.iter().copied().filter(|&runs| runs <= MAX_RAISED).max().unwrap_or(0);
            sampling.inner = sampling.inner.max(most.next_power_of_two());
        }
        for (entry, (requirement, least)) in entries.iter().zip(requirements.iter().zip(counted)) {
            if least <= sampling.inner {
                continue;
            }
            let entry = entry.get("probability_at_least").unwrap_or_else(|| entry.clone());
            let problem = StudyProblem::RequirementRuns {
                entry: entry.path.describe(),
                share: requirement.probability_at_least,
                inner: sampling.inner,
                least,
                is_written: is_inner_written,
            };
            let place = Place::new(&self.reader.source, entry.span);
            self.reader.diagnostics.push(Diagnostic::warning(&problem, Some(place)));
        }
    }
}
