//! The inputs of a surrogate, and where its runs are made.

use std::ops::Range;

use crate::data::direction::range_of;
use crate::data::problem::Problem;
use crate::search::design::corners;
use crate::search::search_box::{BoxPoint, SearchBox};
use loosepin_surrogate::Input;
use loosepin_uncertainty::{Interval, QuantileLevel, ScrambledSobol, SobolError, hash, normal_quantile};

/// Values of the random inputs and of the epistemic ones.
type RunValues = (Vec<f64>, Vec<f64>);

/// Standard deviations of the random inputs in the training runs, over their own: the tails that the inner runs reach are learned
/// too.
const SPREAD: f64 = 1.3;
/// The corners of the epistemic box are among the training runs where they are at most this share of them.
const CORNER_SHARE: f64 = 0.25;
/// By this share of its width an input whose distribution is uncertain may lie beyond its training runs.
const MARGIN: f64 = 0.25;
/// Separates the stream of random numbers.
const TRAINING: u64 = 0x7472_6169_6e21;

/// An input of the problem that a surrogate sees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SurrogateInput {
    /// This random input.
    Random(usize),
    /// This epistemic input.
    Epistemic(usize),
}

/// The inputs that a response depends on and that vary: random ones, and epistemic intervals that are more than a point and no
/// parameter of a distribution. The members of lists are kept apart: each combination has surrogates of its own.
#[derive(Debug, Clone)]
pub(crate) struct TrainingSpace {
    coordinates: Vec<SurrogateInput>,
    epistemic_box: SearchBox,
    /// Random inputs whose distributions have uncertain parameters.
    moving: Vec<usize>,
}

impl TrainingSpace {
    pub fn new(problem: &Problem) -> Self {
        let is_wide = |&index: &usize| {
            let range = problem.epistemic[index].range();
            !problem.is_parameter(index) && range.is_some_and(|range| range.lower() < range.upper())
        };
        let random = (0..problem.random.len()).map(SurrogateInput::Random);
        let epistemic = (0..problem.epistemic.len()).filter(is_wide).map(SurrogateInput::Epistemic);
        Self {
            coordinates: random.chain(epistemic).collect(),
            epistemic_box: SearchBox::new(problem.epistemic.clone()),
            moving: problem.inputs_with_parameters(),
        }
    }

    /// Inputs of the surrogate, in their order.
    pub fn coordinates(&self) -> &[SurrogateInput] {
        &self.coordinates
    }

    /// Combinations of the members of lists.
    pub fn combinations(&self) -> usize {
        self.epistemic_box.combinations()
    }

    /// Position and value of the lists among the epistemic inputs, in one combination of their members.
    pub fn members(&self, combination: usize) -> Vec<(usize, f64)> {
        let at = vec![0.0; self.epistemic_box.dimensions()];
        let values = self.epistemic_box.values_at(&BoxPoint { combination, at });
        let lists = self.epistemic_box.inputs().iter().enumerate().filter(|(_, input)| input.choices() > 1);
        lists.map(|(index, _)| (index, values[index])).collect()
    }

    /// The combination that these epistemic inputs belong to.
    pub fn combination(&self, epistemic: &[f64]) -> usize {
        self.epistemic_box.place_of(epistemic).combination
    }

    /// The numbers that the surrogate sees.
    pub fn point(&self, random: &[f64], epistemic: &[f64]) -> Vec<f64> {
        let value = |coordinate: &SurrogateInput| match *coordinate {
            SurrogateInput::Random(index) => random[index],
            SurrogateInput::Epistemic(index) => epistemic[index],
        };
        self.coordinates.iter().map(value).collect()
    }

    /// A number in [0, 1) that belongs to these random inputs, the same at every u: which share of the rest a run draws. Inputs
    /// that move with u do not take part, unless all do.
    pub fn share(&self, random: &[f64]) -> f64 {
        let all_move = self.moving.len() == random.len();
        let kept = (0..random.len()).filter(|input| all_move || !self.moving.contains(input));
        let key = kept.fold(TRAINING, |key, input| hash(key, random[input].to_bits()));
        (hash(key, 1) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// The inputs as the surrogate has them, for training runs at `points`.
    pub fn inputs(&self, problem: &Problem, points: &[Vec<f64>]) -> Vec<Input> {
        let input = |(axis, coordinate): (usize, &SurrogateInput)| match *coordinate {
            SurrogateInput::Random(index) if !self.moving.contains(&index) => {
                Some(Input::Random(problem.random[index].clone()))
            }
            SurrogateInput::Random(_) => {
                let values = points.iter().map(|point| point[axis]);
                let (low, high) = range_of(values);
                let margin = MARGIN * (high - low);
                Interval::try_new(low - margin, high + margin).ok().map(Input::Epistemic)
            }
            SurrogateInput::Epistemic(index) => problem.epistemic[index].range().map(Input::Epistemic),
        };
        self.coordinates.iter().enumerate().filter_map(input).collect()
    }

    /// Places number `numbers` of a sequence for each combination, values of the random inputs and of the epistemic ones: low-discrepancy
    /// points, the epistemic ones denser towards their ends (the distribution under which Chebyshev's polynomials are orthogonal), the
    /// random ones SPREAD times as wide; the corners of the epistemic box among the first. Every other place has epistemic inputs of `near`
    /// in turn, where there are any of its combination.
    pub fn places(
        &self,
        problem: &Problem,
        numbers: Range<usize>,
        near: &[Vec<f64>],
    ) -> Result<Vec<RunValues>, SobolError> {
        let (randoms, wide) = (problem.random.len(), self.epistemic_box.dimensions());
        let sobol = ScrambledSobol::try_new(hash(problem.sampling.seed, TRAINING), randoms + wide)?;
        let corners = corners(wide);
        let is_first = numbers.start == 0;
        let has_corners = is_first && wide > 0 && corners.len() as f64 <= CORNER_SHARE * numbers.end as f64;
        let mut places = Vec::new();
        for combination in 0..self.combinations() {
            let near: Vec<&Vec<f64>> = near.iter().filter(|of| self.combination(of) == combination).collect();
            for index in numbers.clone() {
                let mut point = vec![0.0; randoms + wide];
                sobol.write_point(combination as u32, index as u32, &mut point);
                let (random, share) = point.split_at(randoms);
                let at = match corners.get(index) {
                    Some(corner) if has_corners => corner.clone(),
                    _ => share.iter().map(|x| 0.5 - 0.5 * libm::cos(core::f64::consts::PI * x)).collect(),
                };
                let epistemic = match near.get((index / 2) % near.len().max(1)) {
                    Some(&near) if index % 2 == 1 => near.clone(),
                    _ => self.epistemic_box.values_at(&BoxPoint { combination, at }),
                };
                let levels: Vec<QuantileLevel> = problem.levels(random).into_iter().map(spread).collect();
                places.push((problem.random_at(&epistemic, &levels), epistemic));
            }
        }
        Ok(places)
    }
}

/// The level as many times as far from the median.
fn spread(level: QuantileLevel) -> QuantileLevel {
    QuantileLevel::StandardNormal(
        SPREAD
            * match level {
                QuantileLevel::Probability(probability) => normal_quantile(probability),
                QuantileLevel::StandardNormal(z) => z,
            },
    )
}
