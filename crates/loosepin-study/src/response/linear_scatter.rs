//! What random inputs do to the numbers of a mechanism in space, one by one: to first order and without play.

use super::input_targets::in_the_middle;
use crate::file::Study;
use loosepin_space::{PartOfOutput, SampledPart, SpatialModel, SpatialScatterPlan};

/// Effects of a standard deviation of each random quantity.
#[derive(Debug)]
pub struct LinearScatter {
    /// Paths of the quantities.
    pub paths: Vec<String>,
    /// The numbers that have effects; lengths of displacements are made of them.
    parts: Vec<SampledPart>,
    places: usize,
    /// By quantity: that on a part at a place is at part × places + place.
    effects: Vec<Vec<f64>>,
}

impl LinearScatter {
    /// The effects at `turns`, unknown values in the middle; `None` where nothing scatters, and where values beside those of the model have no
    /// answer: a study that is finished is not lost for it.
    pub fn new(study: &Study, model: &SpatialModel, turns: &[f64], asked: &[SampledPart]) -> Option<Self> {
        let mut parts: Vec<SampledPart> = Vec::new();
        for part in asked.iter().flat_map(|own| components(*own)).map(|(part, _)| part) {
            if !parts.contains(&part) {
                parts.push(part);
            }
        }
        let random: Vec<_> = study.random.iter().filter_map(|input| Some((input, input.quantity()?))).collect();
        let quantities = random.iter().map(|(input, quantity)| (*quantity, input.variable.standard_deviation()));
        let plan = SpatialScatterPlan {
            set: in_the_middle(study),
            quantities: quantities.collect(),
            correlations: Vec::new(),
        };
        let effects =
            model.effects_on_parts(&plan, turns, &parts, &|| false).ok().filter(|effects| !effects.is_empty())?;
        let paths = random.iter().map(|(input, _)| input.path.clone()).collect();
        Some(Self { paths, parts, places: turns.len(), effects })
    }

    /// The variance of a part at a place by a quantity; of a length its mean square.
    pub fn variance(&self, quantity: usize, part: SampledPart, place: usize) -> f64 {
        let square = |part: SampledPart| {
            let number = self.parts.iter().position(|known| *known == part);
            number.map_or(0.0, |number| self.effects[quantity][number * self.places + place].powi(2))
        };
        let sum: f64 = components(part).map(|(part, factor)| factor * square(part)).sum();
        // What cancels in full leaves round-off, of either sign.
        sum.max(0.0)
    }
}

fn components(own: SampledPart) -> impl Iterator<Item = (SampledPart, f64)> {
    let of = move |&(part, factor): &(PartOfOutput, f64)| (SampledPart { part, ..own }, factor);
    own.part.mean_square_of().iter().map(of)
}
