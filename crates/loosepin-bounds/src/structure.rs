//! Focal elements and cuts: the parts of the epistemic box whose bounds are put together.

use super::points::{candidates, corners};
use super::problem::Problem;
use super::search_box::{Place, Region, SearchBox};
use loosepin_uncertainty::{EpistemicVariable, Interval, SobolError};

/// Candidates of all parts together, about.
const CANDIDATES: usize = 1536;

/// Candidates of one part, at least.
const LEAST_CANDIDATES: usize = 12;

/// Two structural points nearer than this are one.
const SAME: f64 = 1e-9;

/// A part of the epistemic box and the mass that lies in it.
#[derive(Debug, Clone)]
pub(super) struct Element {
    /// Its mass; those of a level sum to 1.
    pub mass: f64,
    pub region: Region,
}

/// Everything that is possible to at least one degree.
#[derive(Debug, Clone)]
pub(super) struct Level {
    /// The degree, where an input is a fuzzy number.
    pub alpha: Option<f64>,
    pub elements: Vec<Element>,
}

/// The parts of a box, degree by degree: first what is possible at all.
#[derive(Debug, Clone)]
pub(super) struct Structure {
    pub levels: Vec<Level>,
    /// Whether values differ from sample to sample within an element.
    pub is_scattering: bool,
}

/// How many elements a level of `problem` has: those of all inputs combined.
pub(super) fn element_count(problem: &Problem) -> usize {
    let of_input = |input: &EpistemicVariable| match input {
        EpistemicVariable::Evidence(evidence) => evidence.elements().len(),
        _ => 1,
    };
    problem.epistemic.iter().map(of_input).fold(1, usize::saturating_mul)
}

impl Structure {
    /// The parts of `search_box`, which holds the epistemic inputs of `problem`. Masses of different inputs multiply: they are
    /// taken as independent. All fuzzy numbers are cut at the same degree (L. A. Zadeh's extension principle).
    pub fn new(problem: &Problem, search_box: &SearchBox) -> Self {
        let mut degrees: Vec<f64> = problem
            .epistemic
            .iter()
            .filter_map(|input| if let EpistemicVariable::Fuzzy(fuzzy) = input { Some(fuzzy) } else { None })
            .flat_map(|fuzzy| fuzzy.cuts().iter().map(|cut| cut.0))
            .collect();
        degrees.sort_by(f64::total_cmp);
        degrees.dedup();
        let degrees: Vec<Option<f64>> =
            if degrees.is_empty() { vec![None] } else { degrees.into_iter().map(Some).collect() };
        let level = |alpha: Option<f64>| Level { alpha, elements: elements(problem, search_box, alpha) };
        let is_scattering = problem
            .epistemic
            .iter()
            .any(|input| matches!(input, EpistemicVariable::Evidence(evidence) if evidence.is_scattering()));
        Self { levels: degrees.into_iter().map(level).collect(), is_scattering }
    }

    /// What is possible at all.
    pub fn widest(&self) -> &Level {
        &self.levels[0]
    }

    /// Whether there is more than one box.
    pub fn is_divided(&self) -> bool {
        self.levels.len() > 1 || self.levels[0].elements.len() > 1
    }

    /// Every different region.
    pub fn regions(&self) -> Vec<&Region> {
        let mut regions: Vec<&Region> = Vec::new();
        for element in self.levels.iter().flat_map(|level| &level.elements) {
            if !regions.contains(&&element.region) {
                regions.push(&element.region);
            }
        }
        regions
    }

    /// Corners and centre of the whole box, then of every part: without them no bound of the part is attained inside it.
    pub fn points(&self, dimensions: usize) -> Vec<Vec<f64>> {
        let unit = corners(dimensions).into_iter().chain(std::iter::once(vec![0.5; dimensions]));
        let unit: Vec<Vec<f64>> = unit.collect();
        let mut points = unit.clone();
        for region in self.regions() {
            for place in &unit {
                let point = region.at(place);
                let is_same =
                    |known: &Vec<f64>| known.iter().zip(&point).all(|(a, b): (&f64, &f64)| (a - b).abs() < SAME);
                if !points.iter().any(is_same) {
                    points.push(point);
                }
            }
        }
        points
    }

    /// Places inside every part at which models are asked where to look next.
    pub fn candidates(&self, dimensions: usize) -> Result<Vec<Vec<f64>>, SobolError> {
        let regions = self.regions();
        let count = (CANDIDATES / regions.len()).max(LEAST_CANDIDATES);
        let all = candidates(dimensions)?;
        let step = (all.len() / count).max(1);
        let unit: Vec<&Vec<f64>> = all.iter().step_by(step).collect();
        Ok(regions.iter().flat_map(|region| unit.iter().map(|place| region.at(place))).collect())
    }
}

/// The focal elements of the inputs at one degree, all combinations.
fn elements(problem: &Problem, search_box: &SearchBox, alpha: Option<f64>) -> Vec<Element> {
    let parts = |input: &EpistemicVariable| -> Vec<(f64, Option<Interval>)> {
        match input {
            EpistemicVariable::Evidence(evidence) => {
                evidence.elements().iter().map(|element| (element.mass, Some(element.interval))).collect()
            }
            EpistemicVariable::Fuzzy(fuzzy) => vec![(1.0, alpha.map(|alpha| fuzzy.cut(alpha)))],
            EpistemicVariable::Interval(interval) | EpistemicVariable::Periodic(interval) => {
                vec![(1.0, Some(*interval))]
            }
            EpistemicVariable::SecondOrder(parameter) => vec![(1.0, Some(parameter.range()))],
            EpistemicVariable::OneOf(_) => vec![(1.0, None)],
        }
    };
    let parts: Vec<Vec<(f64, Option<Interval>)>> = problem.epistemic.iter().map(parts).collect();
    (0..element_count(problem))
        .map(|index| {
            let (mut rest, mut mass) = (index, 1.0);
            let ranges: Vec<Option<Interval>> = parts
                .iter()
                .map(|parts| {
                    let (own, range) = parts[rest % parts.len()];
                    rest /= parts.len();
                    mass *= own;
                    range
                })
                .collect();
            Element { mass, region: search_box.region(&ranges) }
        })
        .collect()
}

impl Region {
    /// Which of `places` lie in it.
    pub fn members(&self, places: &[Place]) -> Vec<usize> {
        (0..places.len()).filter(|&point| self.holds(&places[point].at)).collect()
    }
}
