//! Places at which two slopes meet.

use crate::data::direction::{Direction, extreme_among};
use crate::search::models::of_points::{MIN_DISTANCE, Search};
use crate::search::parts::Element;
use crate::search::search_box::BoxPoint;
use crate::search::target::Target;
use loosepin_math::sort_by_number;

/// Slopes that differ by less than this share belong to a straight line.
const STRAIGHTNESS: f64 = 0.25;

impl Search<'_> {
    /// At most `count` places where two slopes meet that lead to an extreme of `targets` from either side along an axis: a model that
    /// takes the response for smooth sees no kink, and expects nothing there.
    ///
    /// On each side the three nearest points on the line must lie on a straight line nearly; that of a smooth response is bent.
    pub fn kinks(&self, targets: &[(Target, Vec<Direction>)], elements: &[Element], count: usize) -> Vec<BoxPoint> {
        let mut chosen: Vec<BoxPoint> = Vec::new();
        if self.is_of_curves() {
            return chosen;
        }
        for element in elements {
            let members = element.region.members(self.points);
            for (target, directions) in targets {
                for &direction in directions {
                    let Some(extreme) = extreme_among(&target.values, members.iter().copied(), direction) else {
                        continue;
                    };
                    let at = &self.points[extreme];
                    for axis in 0..at.at.len() {
                        let Some((place, value)) = self.kink(target, extreme, axis) else { continue };
                        let gain = element.mass * direction.sign() * (value - target.values[extreme]);
                        let is_new = self
                            .points
                            .iter()
                            .chain(&chosen)
                            .all(|point| self.axes.distance(point, &place) > MIN_DISTANCE);
                        let is_inside = element.region.holds(&place.at);
                        if gain > target.resolution(direction, target.values[extreme])
                            && is_inside
                            && is_new
                            && chosen.len() < count
                        {
                            chosen.push(place);
                        }
                    }
                }
            }
        }
        chosen
    }

    /// Intersection of the straight lines through the points beside `extreme` along `axis`, and the value there.
    fn kink(&self, target: &Target, extreme: usize, axis: usize) -> Option<(BoxPoint, f64)> {
        let centre = &self.points[extreme];
        let is_on_line = |point: &BoxPoint| {
            point.combination == centre.combination
                && point
                    .at
                    .iter()
                    .zip(&centre.at)
                    .enumerate()
                    .all(|(k, (a, b))| k == axis || self.axes.step(k, *a, *b).abs() < MIN_DISTANCE)
        };
        let on_line = || self.groups[centre.combination].iter().filter(|&&point| is_on_line(&self.points[point]));
        let side = |sign: f64| -> Option<(f64, f64, f64)> {
            let offset = |point: usize| sign * self.axes.step(axis, centre.at[axis], self.points[point].at[axis]);
            let mut nearest: Vec<(f64, f64)> = on_line()
                .map(|&point| (offset(point), target.values[point]))
                .filter(|(offset, value)| *offset > 0.0 && value.is_finite())
                .collect();
            sort_by_number(&mut nearest, |a| a.0);
            let [first, second, third] = nearest.get(..3)?.try_into().ok()?;
            let slope = |a: (f64, f64), b: (f64, f64)| (b.1 - a.1) / (b.0 - a.0);
            let (near, far) = (slope(first, second), slope(second, third));
            let is_straight = (near - far).abs() < STRAIGHTNESS * near.abs();
            is_straight.then_some((sign * first.0, first.1, sign * near))
        };
        let ((left, at_left, falling), (right, at_right, rising)) = (side(-1.0)?, side(1.0)?);
        // at_left + falling (x - left) = at_right + rising (x - right)
        let offset = (at_right - at_left + falling * left - rising * right) / (falling - rising);
        if !(offset > left && offset < right) {
            return None;
        }
        let mut at = centre.at.clone();
        at[axis] = self.axes.inside(axis, at[axis] + offset, [0.0, 1.0]);
        Some((BoxPoint { combination: centre.combination, at }, at_left + falling * (offset - left)))
    }
}
