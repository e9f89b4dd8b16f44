//! The next points of a search.

use super::parts::Element;
use super::search_box::BoxPoint;
use super::target::Target;
use crate::data::direction::Direction;
use crate::search::models::of_points::{Modelled, Search};
use crate::search::models::prediction::Allowance;

impl Search<'_> {
    /// At most `count` places: intersections of two slopes and places where models promise more than was attained; without any, the
    /// surroundings of the attained extremes and the places with the largest allowance.
    pub fn next_places(
        &self,
        targets: &[(Target, Vec<Direction>)],
        elements: &[Element],
        count: usize,
    ) -> Vec<BoxPoint> {
        self.places(targets, elements, count, false)
    }

    /// [`Self::next_places`]; where these are fewer than `count`, [`Self::further_points`] too. A model of each target promises most at two places
    /// for each end, so that a few targets would come to many small rounds.
    pub fn filled_places(
        &self,
        targets: &[(Target, Vec<Direction>)],
        elements: &[Element],
        count: usize,
    ) -> Vec<BoxPoint> {
        self.places(targets, elements, count, true)
    }

    fn places(
        &self,
        targets: &[(Target, Vec<Direction>)],
        elements: &[Element],
        count: usize,
        is_filled: bool,
    ) -> Vec<BoxPoint> {
        let mut places = self.kinks(targets, elements, count);
        if places.len() == count {
            return places;
        }
        // Targets are modelled once for all that follows.
        let branches = self.branches_of_targets(targets);
        let modelled = Modelled { targets, branches: &branches };
        places.extend(self.next_points(modelled, elements, count - places.len(), Allowance::HOPED));
        if !places.is_empty() {
            return if is_filled { self.further_points(modelled, elements, places, count) } else { places };
        }
        // Half each: points that are all far apart do not show what is rough, and points near an extreme nothing of the rest.
        let near = self.surroundings(modelled, elements, count.div_ceil(2));
        let conceded = self.next_points(modelled, elements, count - near.len(), Allowance::CONCEDED_TREND);
        self.new_places(near.into_iter().chain(conceded), count)
    }
}
