//! Whether the tolerance of a run resolves the play in the joints.

use loosepin_mechanics::model::{Model, Values};
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::{Dimension, format_value};

/// Share of the smallest clearance above which a tolerance is warned of: a hundred steps of it across the play.
const WARNED_SHARE: f64 = 0.01;

problems! {
    /// A tolerance that is large beside the smallest clearance.
    #[derive(Debug, Clone, PartialEq)]
    pub enum ToleranceProblem {
        /// Above a hundredth of it.
        Coarse { tolerance_m: f64, clearance: SmallestClearance } => Code::ToleranceTooLarge,
            says("the tolerance {} is more than a hundredth of {}", length(*tolerance_m), clearance.words()),
            hint("a tolerance of at most {} resolves it", length(WARNED_SHARE * clearance.clearance_m));
        /// Above it.
        Beyond { tolerance_m: f64, clearance: SmallestClearance } => Code::ToleranceTooLarge,
            says("the tolerance {} is larger than {}", length(*tolerance_m), clearance.words()),
            hint("a tolerance of at most {} resolves it", length(WARNED_SHARE * clearance.clearance_m));
    }
}

/// The smallest play of a mechanism.
#[derive(Debug, Clone, PartialEq)]
pub struct SmallestClearance {
    /// The joint or coupling in words: `joint 'gudgeon'`.
    pub play: String,
    /// Clearance, m: above zero.
    pub clearance_m: f64,
}

impl SmallestClearance {
    /// The smallest clearance of `model` with `values`; `None` if nothing has play.
    pub fn of(model: &Model, values: &Values) -> Option<Self> {
        let plays = model.play_clearances();
        plays
            .map(|(play, clearance)| Self { play: model.play_words(play), clearance_m: values[clearance] })
            .filter(|smallest| smallest.clearance_m > 0.0)
            .min_by(|a, b| a.clearance_m.total_cmp(&b.clearance_m))
    }

    /// Holds a tolerance against it; gives a warning.
    ///
    /// # Errors
    /// The tolerance is larger than the clearance.
    pub fn check(self, tolerance_m: f64) -> Result<Option<ToleranceProblem>, ToleranceProblem> {
        if tolerance_m > self.clearance_m {
            return Err(ToleranceProblem::Beyond { tolerance_m, clearance: self });
        }
        let is_coarse = tolerance_m > WARNED_SHARE * self.clearance_m;
        Ok(is_coarse.then_some(ToleranceProblem::Coarse { tolerance_m, clearance: self }))
    }

    fn words(&self) -> String {
        format!("the smallest clearance, {} in {}", length(self.clearance_m), self.play)
    }
}

fn length(length_m: f64) -> String {
    format_value(length_m, Dimension::LENGTH)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_warned_of_from_a_hundredth_of_the_clearance_and_refused_from_the_whole() {
        let clearance = SmallestClearance { play: "joint 'gudgeon'".to_owned(), clearance_m: 2e-6 };
        let check = |tolerance_m| clearance.clone().check(tolerance_m);
        assert_eq!(check(2e-8), Ok(None));
        assert_eq!(
            check(2.1e-8).map(|warning| warning.map(|warning| warning.to_string())),
            Ok(Some(
                "the tolerance 2.1e-5 mm is more than a hundredth of the smallest clearance, 0.002 mm in joint 'gudgeon'"
                    .to_owned()
            ))
        );
        assert!(matches!(check(2e-6), Ok(Some(ToleranceProblem::Coarse { .. }))));
        assert!(matches!(check(2.1e-6), Err(ToleranceProblem::Beyond { .. })));
    }
}
