//! What the values of uncertain inputs are for.

use crate::file::{EpistemicSubject, RandomSubject, Study};
use loosepin_text::numbers::{QuantityError, QuantityId, QuantityTable, Values};

/// Target of the value of a random input.
#[derive(Debug, Clone, Copy)]
enum RandomTarget {
    /// To a number of the model.
    Quantity(QuantityId),
    /// To the place of a journal in its play.
    Journal,
}

/// Target of the value of an epistemic input.
#[derive(Debug, Clone, Copy)]
enum EpistemicTarget {
    /// To a number of the model.
    Quantity(QuantityId),
    /// To the distribution of a random input: the mechanism does not see it.
    Parameter,
    /// To the choice of a mechanism: number of laws in the list.
    Law(usize),
    /// To the places of the journals in their play.
    Play,
}

/// What the values of uncertain inputs are for, in their order.
#[derive(Debug, Clone)]
pub(crate) struct InputTargets {
    random: Vec<RandomTarget>,
    epistemic: Vec<EpistemicTarget>,
}

impl InputTargets {
    /// The targets of the inputs of `study`.
    pub fn new(study: &Study) -> Self {
        let epistemic = study.epistemic.iter().map(|input| match &input.subject {
            EpistemicSubject::Quantity(quantity) => EpistemicTarget::Quantity(*quantity),
            EpistemicSubject::Parameter { .. } => EpistemicTarget::Parameter,
            EpistemicSubject::Law { laws, .. } => EpistemicTarget::Law(laws.len()),
            EpistemicSubject::Play => EpistemicTarget::Play,
        });
        let random = study.random.iter().map(|input| match input.subject {
            RandomSubject::Quantity(quantity) => RandomTarget::Quantity(quantity),
            RandomSubject::Journal { .. } => RandomTarget::Journal,
        });
        Self { random: random.collect(), epistemic: epistemic.collect() }
    }

    /// Which combination of laws these epistemic inputs choose, the law of the first contact changing fastest.
    pub fn variant(&self, epistemic: &[f64]) -> usize {
        let (mut variant, mut weight) = (0, 1);
        for (input, &value) in self.epistemic.iter().zip(epistemic) {
            if let EpistemicTarget::Law(laws) = *input {
                variant += weight * value as usize;
                weight *= laws;
            }
        }
        variant
    }

    /// Where the journals are: -1 at the lower end of what play makes, 1 at the upper one; the middle where there is no such input.
    pub fn play(&self, epistemic: &[f64]) -> f64 {
        let own = self.epistemic.iter().zip(epistemic);
        own.filter(|(input, _)| matches!(input, EpistemicTarget::Play)).map(|(_, &value)| value).next().unwrap_or(0.0)
    }

    /// The numbers that the places of the journals are drawn from; none where these are unknown, or `random` ends before them.
    pub fn journals(&self, random: &[f64]) -> Vec<f64> {
        let own = self.random.iter().zip(random);
        own.filter(|(input, _)| matches!(input, RandomTarget::Journal)).map(|(_, &value)| value).collect()
    }

    /// Whether the places of the journals are an unknown input.
    pub fn has_play(&self) -> bool {
        self.epistemic.iter().any(|input| matches!(input, EpistemicTarget::Play))
    }

    /// Those of these inputs that are numbers of the model.
    pub fn of_sample(&self, random: &[f64], epistemic: &[f64]) -> impl Iterator<Item = f64> {
        let own = self.epistemic.iter().zip(epistemic);
        let own = own.filter(|(input, _)| matches!(input, EpistemicTarget::Quantity(_))).map(|(_, &value)| value);
        random.iter().copied().chain(own)
    }

    /// The random inputs as these values have them; places of journals, which they do not have, in the middle.
    pub fn of_model(&self, values: &Values) -> Vec<f64> {
        let own = |input: &RandomTarget| match *input {
            RandomTarget::Quantity(quantity) => values[quantity],
            RandomTarget::Journal => 0.5,
        };
        self.random.iter().map(own).collect()
    }

    /// The values of a model for these inputs.
    ///
    /// # Errors
    /// A value breaks its rule.
    pub fn values(
        &self,
        quantities: &QuantityTable,
        random: &[f64],
        epistemic: &[f64],
    ) -> Result<Values, QuantityError> {
        let random = self.random.iter().zip(random).filter_map(|(input, &value)| match *input {
            RandomTarget::Quantity(quantity) => Some((quantity, value)),
            RandomTarget::Journal => None,
        });
        let epistemic = self.epistemic.iter().zip(epistemic).filter_map(|(input, &value)| match *input {
            EpistemicTarget::Quantity(quantity) => Some((quantity, value)),
            EpistemicTarget::Parameter | EpistemicTarget::Law(_) | EpistemicTarget::Play => None,
        });
        let set: Vec<(QuantityId, f64)> = random.chain(epistemic).collect();
        quantities.evaluate(&set)
    }
}

/// The epistemic inputs that are quantities, in the middle of their intervals.
pub(crate) fn in_the_middle(study: &Study) -> Vec<(QuantityId, f64)> {
    let middle = study.epistemic.iter().filter_map(|input| {
        let value = match input.variable.range() {
            Some(range) => 0.5 * (range.lower() + range.upper()),
            None => input.variable.middle(),
        };
        Some((input.quantity()?, value))
    });
    middle.collect()
}
