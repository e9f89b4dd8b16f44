//! Focal elements and cuts: the parts of the epistemic box whose bounds are put together.

use super::design::{candidates, corners};
use super::search_box::{Region, SearchBox};
use loosepin_math::sort_ascending;
use loosepin_uncertainty::{EpistemicVariable, Interval, SobolError};

/// Candidates of all parts together, about.
const CANDIDATES: usize = 1536;

/// Candidates of one part, at least.
const MIN_CANDIDATES: usize = 12;

/// Two structural points nearer than this are one.
const SAME: f64 = 1e-9;

/// A part of the epistemic box and the mass that lies in it.
#[derive(Debug, Clone)]
pub(crate) struct Element {
    /// Its mass; those of a cut sum to 1.
    pub mass: f64,
    pub region: Region,
}

/// α-cut: everything that is possible to at least one degree.
#[derive(Debug, Clone)]
pub(crate) struct Cut {
    /// The degree, where an input is a fuzzy number.
    pub alpha: Option<f64>,
    pub elements: Vec<Element>,
}

/// The parts of a box, degree by degree: first what is possible at all.
#[derive(Debug, Clone)]
pub(crate) struct Structure {
    pub cuts: Vec<Cut>,
    /// Whether values differ from sample to sample within an element.
    pub is_scattering: bool,
}

/// Number of elements of a cut: those of all inputs combined.
pub(crate) fn element_count(epistemic: &[EpistemicVariable]) -> usize {
    let of_input = |input: &EpistemicVariable| match input {
        EpistemicVariable::Evidence(evidence) => evidence.elements().len(),
        _ => 1,
    };
    epistemic.iter().map(of_input).fold(1, usize::saturating_mul)
}

impl Structure {
    /// The parts of `search_box`. Masses of different inputs multiply: they are
    /// taken as independent. All fuzzy numbers are cut at the same degree (L. A. Zadeh's extension principle).
    pub fn new(search_box: &SearchBox) -> Self {
        let epistemic = search_box.inputs();
        let mut degrees: Vec<f64> = epistemic
            .iter()
            .filter_map(|input| if let EpistemicVariable::Fuzzy(fuzzy) = input { Some(fuzzy) } else { None })
            .flat_map(|fuzzy| fuzzy.cuts().iter().map(|cut| cut.0))
            .collect();
        sort_ascending(&mut degrees);
        degrees.dedup();
        let degrees: Vec<Option<f64>> =
            if degrees.is_empty() { vec![None] } else { degrees.into_iter().map(Some).collect() };
        let cut = |alpha: Option<f64>| Cut { alpha, elements: elements(search_box, alpha) };
        let is_scattering = epistemic
            .iter()
            .any(|input| matches!(input, EpistemicVariable::Evidence(evidence) if evidence.is_scattering()));
        Self { cuts: degrees.into_iter().map(cut).collect(), is_scattering }
    }

    /// The cut that holds all that is possible.
    pub fn widest(&self) -> &Cut {
        &self.cuts[0]
    }

    /// The elements of all cuts.
    pub fn elements(&self) -> impl Iterator<Item = &Element> {
        self.cuts.iter().flat_map(|cut| &cut.elements)
    }

    /// Whether there is more than one box.
    pub fn is_divided(&self) -> bool {
        self.cuts.len() > 1 || self.widest().elements.len() > 1
    }

    /// Every different region.
    pub fn regions(&self) -> Vec<&Region> {
        let mut regions: Vec<&Region> = Vec::new();
        for element in self.elements() {
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
        let count = (CANDIDATES / regions.len()).max(MIN_CANDIDATES);
        let all = candidates(dimensions)?;
        let step = (all.len() / count).max(1);
        let unit: Vec<&Vec<f64>> = all.iter().step_by(step).collect();
        Ok(regions.iter().flat_map(|region| unit.iter().map(|place| region.at(place))).collect())
    }
}

/// The focal elements of the inputs at one degree, all combinations.
fn elements(search_box: &SearchBox, alpha: Option<f64>) -> Vec<Element> {
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
    let parts: Vec<Vec<(f64, Option<Interval>)>> = search_box.inputs().iter().map(parts).collect();
    (0..element_count(search_box.inputs()))
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
