//! The surroundings of what has been attained, looked at where the models promise nothing more.

use super::{Direction, LEAST_DISTANCE, MOST_LOCATED_TARGETS, Search, defined, extreme_among};
use crate::search_box::{Place, Region};
use crate::structure::Element;
use crate::target::{Target, TargetModel};
use loosepin_uncertainty::{hash, normal};

/// Where the models promise nothing more, the surroundings of each extreme are looked at: at these distances along each axis, in
/// units of the box, the largest first.
const CONFIRMING_DISTANCES: [f64; 3] = [0.02, 0.004, 0.0008];

/// At these distances nothing changes around an extreme that is rounded. Where something does, slopes meet, maybe in a ridge that leads on
/// between the axes: then the directions are turned, each time otherwise (C. Audet and J. E. Dennis, "Mesh adaptive direct search
/// algorithms for constrained optimization", SIAM Journal on Optimization 17 (2006) 188-217).
const TURNED_DISTANCES: [f64; 3] = [1.6e-4, 3.2e-5, 6.4e-6];

/// The stream of the directions.
const TURNS: u64 = 0x7475_726e;

/// A quadratic falls off from its extreme 16 times as far at four times the distance, a slope 4 times: below this ratio an extreme
/// on a face is taken for the end of a slope.
const SLOPE_RATIO: f64 = 8.0;

/// Slopes that differ by less than this share belong to a straight line.
const STRAIGHTNESS: f64 = 0.25;

/// An extreme that may be looked around.
pub(super) struct Extreme<'a> {
    pub target: &'a Target,
    pub direction: Direction,
    pub point: usize,
    pub value: f64,
    pub region: &'a Region,
    pub resolution: f64,
    /// The model of its combination.
    pub model: TargetModel<'a>,
}

impl Search<'_> {
    /// At most `count` places near the extremes of `targets` in each of `elements`, where their models promise nothing more than has
    /// been attained: the summits that are expected beside them; where there are none, [`Self::confirming_points`]. None where there
    /// are many targets: the poses of a curve.
    pub fn surroundings(
        &self,
        targets: &[(Target, Vec<Direction>)],
        elements: &[Element],
        count: usize,
        most_points: usize,
    ) -> Vec<Place> {
        if self.targets > MOST_LOCATED_TARGETS {
            return Vec::new();
        }
        let members: Vec<Vec<usize>> = elements.iter().map(|element| element.region.members(self.points)).collect();
        let mut extremes: Vec<Extreme<'_>> = Vec::new();
        for (target, directions) in targets {
            for (element, members) in elements.iter().zip(&members) {
                for &direction in directions {
                    extremes.extend(self.extreme(target, direction, element, members, most_points));
                }
            }
        }
        let summits = self.summits(&extremes, count);
        if summits.is_empty() { self.confirming_points(&extremes, count) } else { summits }
    }

    /// At most `count` places around `extremes`: a model can be wrong about its own error, and what is found there tells it so.
    ///
    /// Left out is what would show nothing: a place beside which there is a point already, one at which the model expects no change
    /// above the resolution, and the way down a slope from a face.
    fn confirming_points(&self, extremes: &[Extreme<'_>], count: usize) -> Vec<Place> {
        let along_axes = CONFIRMING_DISTANCES.map(|distance| (distance, false));
        let turned = TURNED_DISTANCES.map(|distance| (distance, true));
        for (distance, is_turned) in along_axes.into_iter().chain(turned) {
            let mut chosen: Vec<Place> = Vec::new();
            for extreme in extremes {
                self.confirm(extreme, distance, is_turned, &mut chosen);
            }
            chosen.truncate(count);
            if !chosen.is_empty() {
                return chosen;
            }
        }
        Vec::new()
    }

    /// At most `count` places where two slopes meet that lead to an extreme of `targets` from either side along an axis: a model that
    /// takes the response for smooth sees no kink, and expects nothing there.
    ///
    /// On each side the three nearest points on the line must lie on a straight line nearly; that of a smooth response is bent.
    pub fn kinks(
        &self,
        targets: &[(Target, Vec<Direction>)],
        elements: &[Element],
        count: usize,
        most_points: usize,
    ) -> Vec<Place> {
        let mut chosen: Vec<Place> = Vec::new();
        if self.targets > MOST_LOCATED_TARGETS {
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
                    if self.groups[at.combination].len() >= most_points {
                        continue;
                    }
                    for axis in 0..at.at.len() {
                        let Some((place, value)) = self.kink(target, extreme, axis) else { continue };
                        let gain = element.mass * direction.sign() * (value - target.values[extreme]);
                        let is_new = self
                            .points
                            .iter()
                            .chain(&chosen)
                            .all(|point| self.axes.distance(point, &place) > LEAST_DISTANCE);
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

    /// Where the straight lines through the points beside `extreme` along `axis` meet, and their value there.
    fn kink(&self, target: &Target, extreme: usize, axis: usize) -> Option<(Place, f64)> {
        let centre = &self.points[extreme];
        let is_on_line = |point: &Place| {
            point.combination == centre.combination
                && point
                    .at
                    .iter()
                    .zip(&centre.at)
                    .enumerate()
                    .all(|(k, (a, b))| k == axis || self.axes.step(k, *a, *b).abs() < LEAST_DISTANCE)
        };
        let on_line = || self.groups[centre.combination].iter().filter(|&&point| is_on_line(&self.points[point]));
        let side = |sign: f64| -> Option<(f64, f64, f64)> {
            let offset = |point: usize| sign * self.axes.step(axis, centre.at[axis], self.points[point].at[axis]);
            let mut nearest: Vec<(f64, f64)> = on_line()
                .map(|&point| (offset(point), target.values[point]))
                .filter(|(offset, value)| *offset > 0.0 && value.is_finite())
                .collect();
            nearest.sort_by(|a, b| a.0.total_cmp(&b.0));
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
        Some((Place { combination: centre.combination, at }, at_left + falling * (offset - left)))
    }

    /// The extreme of `target` among `members` of `element`; nothing where there is none, and where its combination has `most_points`
    /// already.
    fn extreme<'e>(
        &'e self,
        target: &'e Target,
        direction: Direction,
        element: &'e Element,
        members: &[usize],
        most_points: usize,
    ) -> Option<Extreme<'e>> {
        let point = extreme_among(&target.values, members.iter().copied(), direction)?;
        let group = &self.groups[self.points[point].combination];
        if group.len() >= most_points {
            return None;
        }
        let value = target.values[point];
        let resolution = target.resolution(direction, value) / element.mass;
        let model = self.model(target, &defined(target, group))?;
        Some(Extreme { target, direction, point, value, region: &element.region, resolution, model })
    }

    /// Adds the places at `distance` around one extreme that tell something.
    fn confirm(&self, extreme: &Extreme<'_>, distance: f64, is_turned: bool, chosen: &mut Vec<Place>) {
        let &Extreme { point, value, region, resolution, ref model, .. } = extreme;
        let Place { combination, at } = &self.points[point];
        // What a model takes for noise does not end however near it looks.
        if is_turned && model.is_smoothed() {
            return;
        }
        let fall = |place: &[f64]| (model.at(place).mean() - value).abs();
        let on_face = region.faces(self.axes, at);
        let turn = is_turned.then_some(self.points.len());
        for (axis, direction) in frame(at.len(), &on_face, turn).iter().enumerate() {
            for signed in [distance, -distance] {
                let moved = |by: f64| -> Vec<f64> {
                    let ends = |axis: usize| [region.lower[axis], region.upper[axis]];
                    let shifted = at.iter().zip(direction).enumerate();
                    shifted.map(|(axis, (x, share))| self.axes.inside(axis, x + by * share, ends(axis))).collect()
                };
                let place = Place { combination: *combination, at: moved(signed) };
                let is_taken = |point: &Place| self.axes.distance(point, &place) < 0.5 * distance;
                let falls_by = fall(&place.at);
                let is_slope = on_face.contains(&axis) && falls_by < SLOPE_RATIO * fall(&moved(0.25 * signed));
                let shows_nothing = falls_by <= resolution || is_slope;
                if place.at != *at
                    && !shows_nothing
                    && !self.points.iter().any(is_taken)
                    && !chosen.iter().any(is_taken)
                {
                    chosen.push(place);
                }
            }
        }
    }
}

/// Directions at right angles to each other: those of the axes or, for `turn`, mirrored by another plane for each number of points,
/// 1 - 2 v vᵀ with v a random direction that leaves the axes `on_face` as they are.
fn frame(dimensions: usize, on_face: &[usize], turn: Option<usize>) -> Vec<Vec<f64>> {
    let mut normal_of_plane = vec![0.0; dimensions];
    if let Some(turn) = turn {
        for axis in (0..dimensions).filter(|axis| !on_face.contains(axis)) {
            normal_of_plane[axis] = normal(hash(TURNS, turn as u64), axis as u64);
        }
        let length = normal_of_plane.iter().map(|v| v * v).sum::<f64>().sqrt();
        normal_of_plane.iter_mut().for_each(|v| *v /= length.max(f64::MIN_POSITIVE));
    }
    let mirrored = |axis: usize| -> Vec<f64> {
        let mut direction: Vec<f64> = normal_of_plane.iter().map(|v| -2.0 * v * normal_of_plane[axis]).collect();
        direction[axis] += 1.0;
        direction
    };
    (0..dimensions).map(mirrored).collect()
}

#[cfg(test)]
mod tests {
    use super::frame;

    #[test]
    fn identity_turned_directions_are_at_right_angles_and_leave_faces_alone() {
        const ROUND_OFF: f64 = 1e-14;
        for turn in 0..50 {
            let frame = frame(4, &[2], Some(turn));
            for (i, a) in frame.iter().enumerate() {
                for (j, b) in frame.iter().enumerate() {
                    let product: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
                    assert!((product - f64::from(u8::from(i == j))).abs() < ROUND_OFF, "{turn}: {a:?} {b:?}");
                }
            }
            assert_eq!(frame[2], [0.0, 0.0, 1.0, 0.0]);
            assert!(frame[0][0] < 0.999, "turn {turn} turns nothing");
        }
        assert_eq!(frame(2, &[], None), [[1.0, 0.0], [0.0, 1.0]]);
        assert_eq!(frame(2, &[0, 1], Some(7)), [[1.0, 0.0], [0.0, 1.0]]);
    }
}
