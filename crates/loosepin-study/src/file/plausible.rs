//! Warns of scatter that no manufacture has: a length that varies by a thirtieth of itself, or a sample that holds the other sign.

use super::check::entry_of;
use super::description::RandomInput;
use super::problem::StudyProblem;
use super::reader::StudyReader;
use super::study_table::StudyTable;
use loosepin_text::diagnostics::{Diagnostic, Place};
use loosepin_text::units::{Dimension, format_value};
use loosepin_uncertainty::Distribution;

/// Standard deviation over the length from which it is warned of; the scatter of parts is below a hundredth, that of castings a little above.
const MAX_SCATTER: f64 = 0.03;
/// Scatter below this share of the largest body is one of a small offset, which may be as large as the offset.
const SMALL_OFFSET: f64 = 0.01;

impl StudyReader {
    /// Warns, at the input, of lengths whose scatter is hardly possible. A clearance may scatter as much as it is large.
    pub(super) fn check_scatter(&mut self, root: &StudyTable<'_>) {
        let found: Vec<(String, StudyProblem)> =
            self.random.iter().filter_map(|input| Some((input.path.clone(), self.wild_scatter(input)?))).collect();
        for (path, problem) in found {
            let span = entry_of(&root.random, &path).map_or(root.table.span, |entry| entry.key_span);
            let place = Place::new(&self.reader.source, span);
            self.reader.diagnostics.push(Diagnostic::warning(&problem, Some(place)));
        }
    }

    fn wild_scatter(&self, input: &RandomInput) -> Option<StudyProblem> {
        let quantity = input.quantity()?;
        let quantities = &self.model.quantities();
        let values = quantities.nominal();
        let (nominal_m, least_m) = (values[quantity], SMALL_OFFSET * self.model.largest_extent_m(&values));
        let is_length = quantities[quantity].dimension == Dimension::LENGTH;
        if !is_length || nominal_m == 0.0 || self.model.has_play_from(quantity) {
            return None;
        }
        let (path, length) = (input.path.clone(), |value_m: f64| format_value(value_m, Dimension::LENGTH));
        if let Distribution::Empirical { values: sample } = input.variable.distribution() {
            let is_turned = |value_m: f64| value_m * nominal_m < 0.0 && (value_m - nominal_m).abs() >= least_m;
            if let Some(turned_m) = sample.iter().copied().find(|value_m| is_turned(*value_m)) {
                return Some(StudyProblem::OtherSign { path, found: length(turned_m), nominal: length(nominal_m) });
            }
        }
        let deviation_m = input.variable.standard_deviation();
        let is_wild = deviation_m >= MAX_SCATTER * nominal_m.abs() && deviation_m >= least_m;
        is_wild.then(|| StudyProblem::WildScatter { path, found: length(deviation_m), nominal: length(nominal_m) })
    }
}
