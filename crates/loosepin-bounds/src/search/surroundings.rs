//! The neighbourhood of the best points, searched when the models predict no further improvement.

use super::extremes::Extreme;
use super::parts::Element;
use super::search_box::BoxPoint;
use crate::search::models::of_points::{Modelled, Search};
use crate::search::models::prediction::Allowance;
use loosepin_uncertainty::{hash, normal};

/// Distances along each axis, in units of the box, the largest first, at which the surroundings of each extreme are examined where the
/// models promise nothing more.
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

impl Search<'_> {
    /// At most `count` places near the extremes of targets in each of `elements`, where their models promise nothing more than has
    /// been attained: the summits that are expected beside them; where there are none, [`Self::confirming_points`]. Empty if there
    /// are many targets: the poses of a curve.
    pub(super) fn surroundings(&self, modelled: Modelled<'_>, elements: &[Element], count: usize) -> Vec<BoxPoint> {
        if self.is_of_curves() {
            return Vec::new();
        }
        let extremes = self.extremes(modelled, elements);
        let summits = self.summits(&extremes, count);
        if summits.is_empty() { self.confirming_points(&extremes, count) } else { summits }
    }

    /// At most `count` places around `extremes`: values there correct a model that is wrong about its own error.
    ///
    /// Left out is what would show nothing: a place beside which there is a point already, one at which the model expects no change
    /// above the resolution, and the way down a slope from a face.
    fn confirming_points(&self, extremes: &[Extreme<'_>], count: usize) -> Vec<BoxPoint> {
        let along_axes = CONFIRMING_DISTANCES.map(|distance| (distance, false));
        let turned = TURNED_DISTANCES.map(|distance| (distance, true));
        for (distance, is_turned) in along_axes.into_iter().chain(turned) {
            let mut chosen: Vec<BoxPoint> = Vec::new();
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

    /// Adds the informative places at `distance` around one extreme.
    fn confirm(&self, extreme: &Extreme<'_>, distance: f64, is_turned: bool, chosen: &mut Vec<BoxPoint>) {
        let &Extreme { point, value, region, resolution, model, .. } = extreme;
        let BoxPoint { combination, at } = &self.points[point];
        // What a model takes for noise does not end however near it looks.
        if is_turned && model.is_regressing() {
            return;
        }
        let fall = |place: &[f64]| (model.at(place, Allowance::NONE).mean() - value).abs();
        let on_face = region.faces(self.axes, at);
        let turn = is_turned.then_some(self.points.len());
        for (axis, direction) in frame(at.len(), &on_face, turn).iter().enumerate() {
            for signed in [distance, -distance] {
                let moved = |by: f64| -> Vec<f64> {
                    let ends = |axis: usize| [region.lower[axis], region.upper[axis]];
                    let shifted = at.iter().zip(direction).enumerate();
                    shifted.map(|(axis, (x, share))| self.axes.inside(axis, x + by * share, ends(axis))).collect()
                };
                let place = BoxPoint { combination: *combination, at: moved(signed) };
                let is_taken = |point: &BoxPoint| self.axes.distance(point, &place) < 0.5 * distance;
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
