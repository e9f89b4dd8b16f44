//! How far a target may go where slopes meet at an extreme, or where it ends at an edge: a model that takes a target for rounded there
//! trusts itself too much.
//!
//! Around a rounded extreme the values fall with the square of the distance d, where slopes meet with d itself: then fall/d² grows without
//! end towards the extreme. Where the points around it say so, the target may go on beyond the extreme by twice as much as they fall.
//!
//! At an edge the values fall by as much, however near they come to each other. Up to the other side of it the target may go on as
//! steeply as it does on this side, and as steeply again.

use crate::data::direction::{Direction, extreme_among};
use crate::search::search_box::{Axes, BoxPoint, Region};
use loosepin_math::dense::dot;
use loosepin_math::sort_by_number;

/// Largest distance of the neighbours of an extreme between two slopes, in units of the box: a rounded extreme changes by a few resolutions
/// of the search there, so that where it is taken for a kink the allowance is small.
const MAX_DISTANCE: f64 = 1e-3;

/// The largest fall/d² of the neighbours, over the largest one further away, from which slopes are taken to meet. It is 3 where a rounded
/// extreme lies as far from the summit as from its neighbour on the other side.
const MIN_STEEPENING: f64 = 3.0;

/// Least distance of points that count as further away, over that of the steepest neighbour.
const FURTHER: f64 = 10.0;

/// Fall/d² across an edge, over the largest one on this side of it, from which it is one. Around a rounded extreme it does not grow.
const MIN_BREAK: f64 = 10.0;

/// Share of the fall across an edge: a neighbour that falls by less than the first share lies on this side of it, one that falls by more,
/// up to the second, on the other.
const THIS_SIDE: f64 = 0.5;
const OTHER_SIDE: f64 = 1.5;

/// Least distance of a point beyond an edge, over that of the nearest one, and the least cosine between the ways to both.
const FURTHER_ACROSS: f64 = 1.2;
const SAME_WAY: f64 = 0.7;

/// Reach beyond the extreme: over the largest fall of the nearest points at a kink (from a cusp like √d they fall by less than what is
/// beyond them), over the climb at the slope of this side as far as the nearest point beyond an edge.
const MARGIN: f64 = 2.0;

/// The surroundings of the extreme of a target among some points.
struct Surroundings {
    /// Dimensions along which it is free: those of the face on which it lies.
    dimensions: usize,
    /// The others on the same face, the nearest first.
    beside: Vec<Neighbour>,
}

/// A point near an extreme.
struct Neighbour {
    /// How far it is along each axis.
    steps: Vec<f64>,
    distance: f64,
    fall: f64,
}

/// How far a target of these `values` may go beyond its extreme among `members` in `region`; `None` if the surroundings of the
/// extreme are rounded or not known, or it lies at a vertex. Of an extreme on a face only the points on this face count.
pub(crate) fn reach_of_break(
    axes: &Axes,
    points: &[BoxPoint],
    values: &[f64],
    members: &[usize],
    direction: Direction,
    region: &Region,
) -> Option<f64> {
    let inside = || members.iter().copied().filter(|&point| region.holds(&points[point].at));
    let extreme = extreme_among(values, inside(), direction)?;
    let centre = &points[extreme].at;
    let faces = region.faces(axes, centre);
    let mut beside: Vec<Neighbour> = Vec::new();
    for point in inside() {
        let at = &points[point].at;
        let steps: Vec<f64> = (0..centre.len()).map(|axis| axes.step(axis, centre[axis], at[axis])).collect();
        let distance = dot(&steps, &steps).sqrt();
        let on_face = region.faces(axes, at);
        if distance > 0.0 && faces.iter().all(|axis| on_face.contains(axis)) {
            let fall = direction.sign() * (values[extreme] - values[point]);
            beside.push(Neighbour { steps, distance, fall });
        }
    }
    sort_by_number(&mut beside, |a| a.distance);
    let surroundings = Surroundings { dimensions: centre.len() - faces.len(), beside };
    let further = [surroundings.beyond_kink(), surroundings.beyond_edge()].into_iter().flatten().reduce(f64::max)?;
    Some(values[extreme] + direction.sign() * further)
}

impl Surroundings {
    /// How far beyond the extreme where slopes meet there.
    fn beyond_kink(&self) -> Option<f64> {
        let (nearest, others) = self.beside.split_at_checked(2 * self.dimensions)?;
        if nearest.last()?.distance > MAX_DISTANCE {
            return None;
        }
        let steepest = nearest.iter().max_by(|a, b| a.curvature().total_cmp(&b.curvature()))?;
        let is_further = |other: &&Neighbour| other.distance > FURTHER * steepest.distance;
        let further = others.iter().filter(is_further).map(Neighbour::curvature);
        let meets = steepest.curvature() > MIN_STEEPENING * further.reduce(f64::max)?;
        let fall = nearest.iter().map(|neighbour| neighbour.fall).fold(0.0, f64::max);
        meets.then_some(MARGIN * fall)
    }

    /// How far beyond the extreme where the target ends at an edge.
    fn beyond_edge(&self) -> Option<f64> {
        let across = self.beside.iter().max_by(|a, b| a.slope().total_cmp(&b.slope()))?;
        // What falls by as much further away shows that it is no steep hill.
        let confirms = |other: &&Neighbour| {
            let cosine = dot(&other.steps, &across.steps) / (other.distance * across.distance);
            let ratio = other.fall / across.fall;
            cosine > SAME_WAY
                && other.distance > FURTHER_ACROSS * across.distance
                && ratio > THIS_SIDE
                && ratio < OTHER_SIDE
        };
        self.beside.iter().find(confirms)?;
        let this_side = || self.beside.iter().filter(|neighbour| neighbour.fall < THIS_SIDE * across.fall);
        let breaks = across.curvature() > MIN_BREAK * this_side().map(Neighbour::curvature).reduce(f64::max)?;
        let slope = this_side().take(2 * self.dimensions).map(Neighbour::slope).fold(0.0, f64::max);
        breaks.then_some(MARGIN * slope * across.distance)
    }
}

impl Neighbour {
    /// fall/d²
    fn curvature(&self) -> f64 {
        self.slope() / self.distance
    }

    /// fall/d
    fn slope(&self) -> f64 {
        self.fall / self.distance
    }
}

#[cfg(test)]
mod tests {
    use super::{MARGIN, reach_of_break};
    use crate::data::direction::Direction;
    use crate::search::search_box::{Axes, BoxPoint, Region};

    /// Reach beyond the greatest value of `function` at `centre`, 1e-4 to the sides of it, and further away.
    fn reach(function: impl Fn(f64, f64) -> f64, centre: [f64; 2], distances: [f64; 3]) -> Option<f64> {
        let mut points = vec![centre];
        for distance in distances {
            for (x, y) in [(distance, 0.0), (-distance, 0.0), (0.0, distance), (0.0, -distance)] {
                let at = [centre[0] + x, centre[1] + y];
                if at.iter().all(|x| (0.0..=1.0).contains(x)) {
                    points.push(at);
                }
            }
        }
        let values: Vec<f64> = points.iter().map(|&[x, y]| function(x - centre[0], y - centre[1])).collect();
        let points: Vec<BoxPoint> = points.into_iter().map(|at| BoxPoint { combination: 0, at: at.to_vec() }).collect();
        let members: Vec<usize> = (0..points.len()).collect();
        let (axes, region) = (Axes::open(2), Region::whole(2));
        let most = reach_of_break(&axes, &points, &values, &members, Direction::Maximum, &region);
        // The least of the opposite is the same.
        let opposite: Vec<f64> = values.iter().map(|value| -value).collect();
        let least = reach_of_break(&axes, &points, &opposite, &members, Direction::Minimum, &region);
        assert_eq!(most, least.map(|least| -least));
        most
    }

    const INSIDE: [f64; 2] = [0.5, 0.5];
    const NEAR: [f64; 3] = [1e-4, 2e-3, 0.04];

    #[test]
    fn analytic_slopes_that_meet_leave_open_twice_the_fall_of_the_nearest_points() {
        let cone = |x: f64, y: f64| 3.0 - (x * x + 4.0 * y * y).sqrt();
        let expected = 3.0 + MARGIN * 2e-4;
        assert!(reach(cone, INSIDE, NEAR).is_some_and(|reach| (reach - expected).abs() < 1e-12));
        // On a face the slope away from it is no kink, a roof along it is one.
        let slope = |x: f64, y: f64| -x - y * y;
        let roof = |x: f64, y: f64| -x - y.abs();
        assert_eq!(reach(slope, [0.0, 0.5], NEAR), None);
        assert!(reach(roof, [0.0, 0.5], NEAR).is_some_and(|reach| (reach - MARGIN * 1e-4).abs() < 1e-12));
    }

    #[test]
    fn analytic_what_is_rounded_or_not_known_leaves_nothing_open() {
        // With the summit beside the extreme, at four tenths of the way to its neighbour.
        let bowl = |x: f64, y: f64| -(x - 4e-5) * (x - 4e-5) - 0.5 * y * y + 0.2 * x * x * x;
        assert_eq!(reach(bowl, INSIDE, NEAR), None);
        let cone = |x: f64, y: f64| -(x * x + y * y).sqrt();
        assert_eq!(reach(cone, INSIDE, [0.01, 0.1, 0.4]), None, "its neighbours are far");
        assert_eq!(reach(cone, [0.0, 1.0], NEAR), None, "a vertex");
    }

    #[test]
    fn analytic_an_edge_leaves_open_what_the_slope_of_its_side_may_still_reach() {
        // The edge lies before the neighbour on the right, and the slope leads up to it. These are too far for a kink.
        let step = |x: f64, y: f64| if x < 1e-3 { 3.0 + 0.5 * x - y * y } else { 1.0 };
        let found = reach(step, INSIDE, [5e-3, 2e-2, 0.04]).unwrap();
        assert!((found - (3.0 + MARGIN * 0.5 * 5e-3)).abs() < 1e-12, "{found}");
    }

    #[test]
    fn analytic_a_hill_beside_a_point_and_a_flattening_roof_are_no_edges() {
        // Beyond the pit it is as high as before: nothing says that it goes on being low.
        let pit = |x: f64, y: f64| -x * x - y * y - if (x - 2e-3).abs() < 1e-4 { 1.0 } else { 0.0 };
        assert_eq!(reach(pit, INSIDE, NEAR), None);
        // Its slopes meet, whatever they do further away.
        let roof = |x: f64, y: f64| (-2e4 * x.abs()).exp() - y * y;
        assert!(reach(roof, INSIDE, NEAR).is_some_and(|reach| reach > 1.0 + 1.7), "{:?}", reach(roof, INSIDE, NEAR));
    }
}
