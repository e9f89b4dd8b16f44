//! What slopes that meet at an extreme leave open: a model that takes a target for rounded there trusts itself too much.
//!
//! Around a rounded extreme the values fall with the square of the distance d, where slopes meet with d itself: then fall/d² grows without
//! end towards the extreme. Where the points around it say so, the target may go on beyond the extreme by twice as much as they fall.

use super::{Direction, extreme_among};
use crate::bounds::search_box::{Axes, Place, Region};

/// Only points so near to the extreme are its neighbours, in units of the box: a rounded extreme changes by no more than the search
/// resolves there, so that where it is taken for a kink little is conceded.
const LARGEST_DISTANCE: f64 = 1e-3;

/// The largest fall/d² of the neighbours, over the largest one further away, from which slopes are taken to meet. It is up to 3 where a
/// rounded extreme lies as far from the summit as from its neighbours.
const LEAST_STEEPENING: f64 = 3.0;

/// What is further away: the distance over that of the steepest neighbour.
const FURTHER: [f64; 2] = [10.0, 100.0];

/// What is left open, over the largest fall of the nearest points. From a cusp like √d they fall by less than what is beyond them.
const MARGIN: f64 = 2.0;

/// A coordinate nearer to a face than this lies on it, in units of the box.
const FACE_THICKNESS: f64 = 1e-6;

/// How far a target of these `values` may go where slopes meet at its extreme among `members` in `region`; nothing where the surroundings
/// of the extreme are rounded or not known, or it lies at a vertex. Of an extreme on a face only the points on this face count.
pub(super) fn reach_of_kink(
    axes: &Axes,
    points: &[Place],
    values: &[f64],
    members: &[usize],
    direction: Direction,
    region: &Region,
) -> Option<f64> {
    let inside = members.iter().copied().filter(|&point| region.holds(&points[point].at));
    let extreme = extreme_among(values, inside, direction)?;
    let centre = &points[extreme].at;
    let is_on_face = |axis: usize| {
        let is_near = |face: &[f64]| (centre[axis] - face[axis]).abs() < FACE_THICKNESS;
        !axes.is_periodic(axis) && (is_near(&region.lower) || is_near(&region.upper))
    };
    let faces: Vec<usize> = (0..centre.len()).filter(|&axis| is_on_face(axis)).collect();
    let mut beside: Vec<Neighbour> = Vec::new();
    for &point in members.iter().filter(|&&point| point != extreme) {
        let steps: Vec<f64> =
            (0..centre.len()).map(|axis| axes.step(axis, centre[axis], points[point].at[axis])).collect();
        let distance = steps.iter().map(|step| step * step).sum::<f64>().sqrt();
        if distance > 0.0 && faces.iter().all(|&axis| steps[axis].abs() < FACE_THICKNESS) {
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
    let [from, to] = FURTHER.map(|ratio| ratio * steepest.distance);
    let further = others.iter().filter(|other| (from..to).contains(&other.distance)).map(Neighbour::curvature);
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
