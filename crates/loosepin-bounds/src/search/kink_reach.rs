//! How far a target may go where slopes meet at an extreme: a model that takes a target for rounded there trusts itself too much.
//!
//! Around a rounded extreme the values fall with the square of the distance d, where slopes meet with d itself: then fall/d² grows without
//! end towards the extreme. Where the points around it say so, the target may go on beyond the extreme by twice as much as they fall.

use super::search_box::{Axes, Place, Region};
use crate::data::direction::{Direction, extreme_among};

/// Only points so near to the extreme are its neighbours, in units of the box: a rounded extreme changes by a few resolutions of the
/// search there, so that where it is taken for a kink little is conceded.
const LARGEST_DISTANCE: f64 = 1e-3;

/// The largest fall/d² of the neighbours, over the largest one further away, from which slopes are taken to meet. It is 3 where a rounded
/// extreme lies as far from the summit as from its neighbour on the other side.
const LEAST_STEEPENING: f64 = 3.0;

/// Least distance of points that count as further away, over that of the steepest neighbour.
const FURTHER: f64 = 10.0;

/// Reach beyond the extreme, over the largest fall of the nearest points. From a cusp like √d they fall by less than what is beyond them.
const MARGIN: f64 = 2.0;

/// How far a target of these `values` may go where slopes meet at its extreme among `members` in `region`; nothing where the surroundings
/// of the extreme are rounded or not known, or it lies at a vertex. Of an extreme on a face only the points on this face count.
pub(crate) fn reach_of_kink(
    axes: &Axes,
    points: &[Place],
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
        let steps = (0..centre.len()).map(|axis| axes.step(axis, centre[axis], at[axis]));
        let distance = steps.map(|step| step * step).sum::<f64>().sqrt();
        let on_face = region.faces(axes, at);
        if distance > 0.0 && faces.iter().all(|axis| on_face.contains(axis)) {
            let fall = direction.sign() * (values[extreme] - values[point]);
            beside.push(Neighbour { distance, fall });
        }
    }
    beside.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    let (nearest, others) = beside.split_at_checked(2 * (centre.len() - faces.len()))?;
    if nearest.last()?.distance > LARGEST_DISTANCE {
        return None;
    }
    let steepest = nearest.iter().max_by(|a, b| a.curvature().total_cmp(&b.curvature()))?;
    let is_further = |other: &&Neighbour| other.distance > FURTHER * steepest.distance;
    let further = others.iter().filter(is_further).map(Neighbour::curvature);
    let meets = steepest.curvature() > LEAST_STEEPENING * further.reduce(f64::max)?;
    let fall = nearest.iter().map(|neighbour| neighbour.fall).fold(0.0, f64::max);
    meets.then_some(values[extreme] + direction.sign() * MARGIN * fall)
}

/// A point near an extreme.
struct Neighbour {
    distance: f64,
    fall: f64,
}

impl Neighbour {
    /// fall/d²
    fn curvature(&self) -> f64 {
        self.fall / (self.distance * self.distance)
    }
}

#[cfg(test)]
mod tests {
    use super::{MARGIN, reach_of_kink};
    use crate::data::direction::Direction;
    use crate::search::search_box::{Axes, Place, Region};

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
        let points: Vec<Place> = points.into_iter().map(|at| Place { combination: 0, at: at.to_vec() }).collect();
        let members: Vec<usize> = (0..points.len()).collect();
        let (axes, region) = (Axes::open(2), Region::whole(2));
        let most = reach_of_kink(&axes, &points, &values, &members, Direction::Maximum, &region);
        // The least of the opposite is the same.
        let opposite: Vec<f64> = values.iter().map(|value| -value).collect();
        let least = reach_of_kink(&axes, &points, &opposite, &members, Direction::Minimum, &region);
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
}
