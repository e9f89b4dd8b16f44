//! Extremes that have been attained, with the models of their surroundings.

use super::parts::Element;
use super::search_box::Region;
use super::target::Target;
use crate::data::direction::{Direction, extreme_among};
use crate::search::models::of_points::{Branch, Modelled, Search};
use crate::search::models::target_model::TargetModel;

/// An extreme that may be looked around.
pub(super) struct Extreme<'a> {
    pub target: &'a Target,
    pub direction: Direction,
    pub point: usize,
    pub value: f64,
    pub region: &'a Region,
    pub resolution: f64,
    /// The model of its combination.
    pub model: &'a TargetModel<'a>,
}

impl Search<'_> {
    /// The extremes of targets in each of `elements`.
    pub(super) fn extremes<'e>(
        &self,
        Modelled { targets, branches }: Modelled<'e>,
        elements: &'e [Element],
    ) -> Vec<Extreme<'e>> {
        let members: Vec<Vec<usize>> = elements.iter().map(|element| element.region.members(self.points)).collect();
        let mut extremes = Vec::new();
        for ((target, directions), branches) in targets.iter().zip(branches) {
            for (element, members) in elements.iter().zip(&members) {
                for &direction in directions {
                    extremes.extend(self.extreme((target, branches), direction, element, members));
                }
            }
        }
        extremes
    }

    /// The extreme of `target` among `members` of `element`; `None` if there is none.
    fn extreme<'e>(
        &self,
        (target, branches): (&'e Target, &'e [Branch<'e>]),
        direction: Direction,
        element: &'e Element,
        members: &[usize],
    ) -> Option<Extreme<'e>> {
        let point = extreme_among(&target.values, members.iter().copied(), direction)?;
        let value = target.values[point];
        let resolution = target.resolution(direction, value) / element.mass;
        let model = branches[self.points[point].combination].model.as_ref()?;
        Some(Extreme { target, direction, point, value, region: &element.region, resolution, model })
    }
}
