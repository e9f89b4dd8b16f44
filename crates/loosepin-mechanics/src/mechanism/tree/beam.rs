//! Flexible links in the tree.
//!
//! The frame of a flexible body is a link like that of a rigid one. The sections at its ends and at its points inside are links of their own
//! that hang on it: each is the frame of the body as that section carries it, so that a point of the body is where it was in a rigid body,
//! off the axis too. Joints, springs and forces act on the link of the section; that a force on it bends the beam follows from its partial
//! velocities.

use crate::model::{ActsOn, BodyId, LumpedMass, Model, PointId, Values};
use loosepin_flexible::{Basis, Shapes, Station, even_shares};
use std::ops::Range;
use std::sync::Arc;

/// Points nearer to each other or to an end than this share of the length are held by one section: beyond it their deflections
/// differ by some millionths.
pub(in crate::mechanism) const SAME_SECTION: f64 = 1e-3;

/// A place along a beam, counted from where it hangs on its parent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BeamPlace {
    /// x = 0.
    Root,
    /// x = L.
    Tip,
    /// A section inside: its index in [`Shapes::inside`].
    Inside(usize),
}

/// A flexible body in the tree.
#[derive(Debug, Clone)]
pub struct TreeBeam {
    /// The body.
    pub body: BodyId,
    /// Indices of its `from` and its `to` among the points of the body.
    pub ends: [usize; 2],
    /// Slot of its frame.
    pub slot: usize,
    /// Slots of the sections at its `from` and at its `to`; of a tangent frame the section at the root is the frame itself.
    pub sections: [usize; 2],
    /// Slots of the sections inside, as [`Shapes::inside`] counts them.
    pub inside: Vec<usize>,
    /// The section of each point of the body.
    pub places: Vec<BeamPlace>,
    /// Whether its root is its `to`: it hangs on its parent there.
    pub is_reversed: bool,
    /// Coordinates of the shapes: axial ones, m, then lateral ones, rad.
    pub coordinates: Range<usize>,
    /// The functions of the shapes.
    pub basis: Arc<Basis>,
    /// The shapes.
    pub shapes: Arc<Shapes>,
    /// Whether it has damping.
    pub is_damped: bool,
    /// Whether it carries lumps.
    pub has_lumps: bool,
}

impl TreeBeam {
    /// The shapes at a place.
    pub fn station(&self, place: BeamPlace) -> &Station {
        match place {
            BeamPlace::Root => &self.shapes.root,
            BeamPlace::Tip => &self.shapes.tip,
            BeamPlace::Inside(index) => &self.shapes.inside[index],
        }
    }

    /// Both ends, and the sections inside.
    pub fn all_places(&self) -> impl Iterator<Item = BeamPlace> {
        [BeamPlace::Root, BeamPlace::Tip].into_iter().chain((0..self.inside.len()).map(BeamPlace::Inside))
    }

    /// Slot of the section that carries a point of the body.
    pub fn slot_of(&self, point: usize) -> usize {
        match self.places[point] {
            BeamPlace::Root => self.sections[usize::from(self.is_reversed)],
            BeamPlace::Tip => self.sections[usize::from(!self.is_reversed)],
            BeamPlace::Inside(index) => self.inside[index],
        }
    }

    /// Indices of the points inside that have static shapes.
    pub fn points_with_static_shapes(&self) -> Vec<usize> {
        let is_held = |place: &BeamPlace| match place {
            BeamPlace::Root | BeamPlace::Tip => false,
            BeamPlace::Inside(_) => self.basis.inside().contains(&self.station(*place).share),
        };
        self.places.iter().enumerate().filter(|(_, place)| is_held(place)).map(|(point, _)| point).collect()
    }

    /// Lumps of the body that the section at a place carries.
    pub fn lumps_at<'m>(&self, model: &'m Model, place: BeamPlace) -> Vec<&'m LumpedMass> {
        let lumps = model.bodies[self.body.0].beam.iter().flat_map(|beam| &beam.lumps);
        lumps.filter(|lump| self.places[lump.point] == place).collect()
    }

    /// The coordinates that are lengths.
    pub fn axial(&self) -> Range<usize> {
        self.coordinates.start..self.coordinates.start + self.shapes.axial()
    }

    /// φ/L of each lateral shape at `count` >= 2 places evenly from root to tip.
    pub fn lateral_shapes(&self, count: usize) -> Vec<Vec<f64>> {
        let places = self.basis.stations(&even_shares(count));
        (0..self.shapes.lateral()).map(|shape| places.iter().map(|place| place.lateral[shape]).collect()).collect()
    }

    /// Indices of the points at root and tip.
    pub fn points(&self) -> [usize; 2] {
        if self.is_reversed { [self.ends[1], self.ends[0]] } else { self.ends }
    }
}

/// The sections of a beam, and its functions.
pub(in crate::mechanism) struct Sections {
    /// The section of each point of the body.
    pub(in crate::mechanism) places: Vec<BeamPlace>,
    pub(in crate::mechanism) basis: Basis,
    pub(in crate::mechanism) shapes: Shapes,
}

/// The sections of the flexible `body`, from its `from` or, `is_reversed`, from its `to`; `None` for a rigid body.
pub(in crate::mechanism) fn sections_of(
    model: &Model,
    body: BodyId,
    values: &Values,
    is_reversed: bool,
) -> Option<Sections> {
    let beam = model.bodies[body.0].beam.as_ref()?;
    let count = model.bodies[body.0].points.len();
    let shares: Vec<f64> = (0..count)
        .map(|point| share_of(model, PointId { body, point }, values))
        .map(|share| if is_reversed { 1.0 - share } else { share })
        .collect();
    let ends = if is_reversed { [beam.ends[1], beam.ends[0]] } else { beam.ends };
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|one, other| shares[*one].total_cmp(&shares[*other]));
    let mut places = vec![BeamPlace::Root; count];
    let (mut inside, mut held): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    for point in order {
        let share = shares[point];
        places[point] = if point == ends[0] || share < SAME_SECTION {
            BeamPlace::Root
        } else if point == ends[1] || share > 1.0 - SAME_SECTION {
            BeamPlace::Tip
        } else {
            if inside.last().is_none_or(|last| share - last > SAME_SECTION) {
                inside.push(share);
            }
            let index = inside.len() - 1;
            if beam.has_static_shapes
                && is_pushed(model, PointId { body, point })
                && held.last() != Some(&inside[index])
            {
                held.push(inside[index]);
            }
            BeamPlace::Inside(index)
        };
    }
    let basis = Basis::new(beam.frame, [beam.axial_shapes, beam.lateral_shapes], &held);
    let shapes = Shapes::of(&basis, &inside);
    Some(Sections { places, basis, shapes })
}

/// Place of a point of a flexible body along its axis from `from`, as a share of the length; NaN if the body is rigid.
pub(in crate::mechanism) fn share_of(model: &Model, point: PointId, values: &Values) -> f64 {
    let body = &model.bodies[point.body.0];
    let Some(beam) = &body.beam else { return f64::NAN };
    let at = |point: usize| body.points[point].position_m.map(|id| values[id]);
    let ([from, to], own) = (beam.ends.map(at), at(point.point));
    let along = [to[0] - from[0], to[1] - from[1]];
    let product = (own[0] - from[0]) * along[0] + (own[1] - from[1]) * along[1];
    product / (along[0] * along[0] + along[1] * along[1])
}

/// Whether a joint, a spring or a load acts on a point, or the inertia of a lump.
fn is_pushed(model: &Model, point: PointId) -> bool {
    let by_joint = model.joints.iter().any(|joint| joint.kind.points().contains(&point));
    let mut of_springs = model.springs.iter().filter_map(|spring| spring.kind.points());
    let by_spring = of_springs.any(|points| points.contains(&point));
    let by_load = model.loads.iter().any(|load| load.kind.acts_on() == ActsOn::Point(point));
    let is_heavy = model.bodies[point.body.0]
        .beam
        .as_ref()
        .is_some_and(|beam| beam.lumps.iter().any(|lump| lump.point == point.point));
    by_joint || by_spring || by_load || is_heavy
}
