//! The spanning tree of a mechanism: which joint carries which body, and which ideal joints close loops. [`build`](super::build) builds it.

use crate::mechanism::attachment::{FormOfAttachment, TreeGeometry};
use crate::mechanism::tree::beam::TreeBeam;
use crate::mechanism::tree::nodal_beam::TreeNodalBeam;
use crate::model::{BodyId, DriveId, JointId, Model, PointId, Row};
use core::ops::Range;
use loosepin_flexible::Frame;
use loosepin_math::{Envelope, Plane};

/// A moving body in the tree.
#[derive(Debug, Clone)]
pub struct Link<G: TreeGeometry = Plane> {
    /// The body.
    pub body: BodyId,
    /// Slot of the parent; 0 is the ground.
    pub parent_slot: usize,
    /// How it hangs on the parent.
    pub attachment: G::Attachment,
    /// Its own coordinates.
    pub coordinates: Range<usize>,
    /// Its own speeds; in the plane they are the rates of its coordinates, with the same numbers.
    pub speeds: Range<usize>,
    /// Whether a drive holds its coordinate.
    pub is_driven: bool,
    /// Speeds on which its motion depends: those of the parent first, then its own, or those of the shapes of its beam.
    pub dependences: Vec<usize>,
    /// How many of them are the parent's.
    pub inherited: usize,
    /// Index in [`Tree::beams`] where it is the frame of a flexible body.
    pub beam: Option<usize>,
    /// Index in [`Tree::nodal_beams`] where it is the frame of a flexible body in absolute nodal coordinates.
    pub nodal_beam: Option<usize>,
    /// Whether it has mass of its own: a rigid body, or a section that carries lumps. The mass of the frame of a flexible body is that of the
    /// beam.
    pub has_own_mass: bool,
}

impl<G: TreeGeometry> Link<G> {
    /// The joint by which it hangs on its parent, and whether the parent is the joint's first body; `None` of a body that hangs on nothing.
    pub fn joint(&self) -> Option<(JointId, bool)> {
        self.attachment.joint()
    }

    /// Which of its own coordinates are lengths.
    pub fn lengths(&self) -> Range<usize> {
        let own = self.attachment.lengths();
        self.coordinates.start + own.start..self.coordinates.start + own.end
    }

    /// The coordinate that is its angle from the ground, where one is.
    pub fn angle(&self) -> Option<usize> {
        self.attachment.angle().map(|own| self.coordinates.start + own)
    }

    /// The same of a body that hangs by a joint.
    pub fn joint_angle(&self) -> Option<usize> {
        self.angle().filter(|_| self.joint().is_some())
    }
}

/// An ideal joint that closes a loop: a constraint between two bodies of the tree.
#[derive(Debug, Clone, Copy)]
pub struct Cut<G: TreeGeometry = Plane> {
    /// The joint.
    pub joint: JointId,
    /// Slots of its first and second body.
    pub slots: [usize; 2],
    /// The conditions that it is.
    pub rows: &'static [G::Row],
}

impl<G: TreeGeometry> Cut<G> {
    /// Number of scalar constraints.
    #[inline(always)]
    pub fn count(&self) -> usize {
        self.rows.iter().map(|row| row.count()).sum()
    }

    /// The condition that scalar constraint `number` belongs to.
    fn row(&self, mut number: usize) -> Option<G::Row> {
        self.rows.iter().copied().find(|row| {
            let is_it = number < row.count();
            number = number.wrapping_sub(row.count());
            is_it
        })
    }

    /// Whether scalar constraint `number` is an angle; the others are lengths.
    pub fn is_angle(&self, number: usize) -> bool {
        self.row(number).is_some_and(Row::is_angle)
    }
}

/// Place of a joint in a tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct JointPlace {
    /// Slots of bearing and journal, or of guide and slider.
    pub slots: [usize; 2],
    /// Whether its coordinate is a position along a line: of a prismatic joint or a slot.
    pub is_prismatic: bool,
}

impl JointPlace {
    /// The place of `joint` in `tree`.
    pub fn new(model: &Model, tree: &Tree, joint: JointId) -> Self {
        let kind = &model.joints[joint.0].kind;
        Self { slots: kind.points().map(|point| tree.slot_of_point(point)), is_prismatic: kind.slides() }
    }
}

/// Places of the first and the second joint of a coupling.
pub type CouplingPlace = [JointPlace; 2];

/// The spanning tree. Slot 0 is the ground, slot i + 1 is `links[i]`; a parent comes before its children.
///
/// Coordinates are numbered `0..free` for the state and `free..free + drives.len()` for the driven ones.
#[derive(Debug, Clone)]
pub struct Tree<G: TreeGeometry = Plane> {
    /// Moving bodies, parents first.
    pub links: Vec<Link<G>>,
    /// Slot of each body of the model.
    pub slot_of_body: Vec<usize>,
    /// Number of free coordinates.
    pub free: usize,
    /// Number of free speeds; in the plane as many as coordinates.
    pub free_speeds: usize,
    /// The drive of each driven coordinate.
    pub drives: Vec<DriveId>,
    /// Ideal joints that close loops, in file order.
    pub cuts: Vec<Cut<G>>,
    /// Places of the ideal couplings, in file order.
    pub couplings: Vec<CouplingPlace>,
    /// Indices of the couplings in the model.
    pub coupling_indices: Vec<usize>,
    /// Bodies that no ideal joint connects with the ground: each root has three coordinates of its own.
    pub floating_roots: Vec<BodyId>,
    /// Flexible bodies; empty in a tree of rigid ones.
    pub beams: Vec<TreeBeam>,
    /// Flexible bodies in absolute nodal coordinates.
    pub nodal_beams: Vec<TreeNodalBeam>,
}

/// The drives of these joints turn a closed loop against itself: no joint of the loop is free.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DrivenLoop {
    /// The driven joint that closes the loop.
    pub joint: JointId,
}

impl<G: TreeGeometry> Tree<G> {
    /// A tree without bodies.
    pub fn empty() -> Self {
        Self {
            links: Vec::new(),
            slot_of_body: Vec::new(),
            free: 0,
            free_speeds: 0,
            drives: Vec::new(),
            cuts: Vec::new(),
            couplings: Vec::new(),
            coupling_indices: Vec::new(),
            floating_roots: Vec::new(),
            beams: Vec::new(),
            nodal_beams: Vec::new(),
        }
    }

    /// Speeds on which the motion of the body in a slot depends; none of the ground.
    #[inline(always)]
    pub fn dependences(&self, slot: usize) -> &[usize] {
        if slot == 0 { &[] } else { &self.links[slot - 1].dependences }
    }

    /// Number of coordinates, free and driven.
    pub fn coordinates(&self) -> usize {
        self.free + self.drives.len()
    }

    /// Number of scalar constraints: those of the cut joints, then one for each ideal coupling.
    pub fn constraint_rows(&self) -> usize {
        self.cut_rows() + self.couplings.len()
    }

    /// Whether constraints repeat each other: there are more of them than coordinates that they can determine.
    pub fn is_redundant(&self) -> bool {
        self.free < self.constraint_rows()
    }

    /// Number of scalar constraints of the cut joints.
    pub fn cut_rows(&self) -> usize {
        self.cuts.iter().map(Cut::count).sum()
    }

    /// For each scalar constraint, the constraints with the same scale: those of points that coincide together, others alone.
    pub fn constraint_scales(&self) -> Vec<Range<usize>> {
        let mut scales: Vec<Range<usize>> = Vec::new();
        for row in self.cuts.iter().flat_map(|cut| cut.rows) {
            let own = scales.len()..scales.len() + row.count();
            scales.extend(core::iter::repeat_n(own, row.count()));
        }
        scales.extend((scales.len()..self.constraint_rows()).map(|row| row..row + 1));
        scales
    }

    /// Number of speeds, free and driven.
    pub fn speeds(&self) -> usize {
        self.free_speeds + self.drives.len()
    }

    /// The possibly non-zero entries of the mass matrix of the free coordinates: between coordinates that move the same body.
    pub fn mass_envelope(&self) -> Envelope {
        let mut first: Vec<usize> = (0..self.free_speeds).collect();
        for link in &self.links {
            let coordinates = || link.dependences.iter().copied().filter(|c| *c < self.free_speeds);
            let least = coordinates().min().unwrap_or(0);
            coordinates().for_each(|coordinate| first[coordinate] = first[coordinate].min(least));
        }
        for beam in &self.nodal_beams {
            beam.widen(self.dependences(beam.slot).iter().copied(), &mut first);
        }
        Envelope::new(first)
    }

    /// Slots of the bodies whose angles have sines and cosines of their own: [`FormOfAttachment::turns`].
    pub fn turning_slots(&self) -> impl Iterator<Item = usize> + '_ {
        self.links.iter().enumerate().filter(|(_, link)| link.attachment.turns()).map(|(index, _)| index + 1)
    }
}

impl Tree {
    /// Places of the two joints of a coupling of the model.
    pub fn coupling_place(&self, model: &Model, index: usize) -> CouplingPlace {
        let coupling = &model.couplings[index];
        [coupling.first, coupling.second].map(|joint| JointPlace::new(model, self, joint))
    }

    /// Bodies that bend, in whatever formulation.
    pub fn flexible_bodies(&self) -> impl Iterator<Item = BodyId> {
        self.beams.iter().map(|beam| beam.body).chain(self.nodal_beams.iter().map(|beam| beam.body))
    }

    /// Slot of the frame that carries a point: of a flexible body that of the section there.
    pub fn slot_of_point(&self, point: PointId) -> usize {
        let beam = self.beams.iter().find(|beam| beam.body == point.body);
        let section = beam.map(|beam| beam.slot_of(point.point));
        let nodal = self.nodal_beams.iter().find(|beam| beam.body == point.body);
        let section = section.or_else(|| nodal.and_then(|beam| beam.section(point.point)));
        section.unwrap_or(self.slot_of_body[point.body.0])
    }

    /// The first flexible body whose frame does not fit how it hangs: a tangent frame touches the beam at its `from`.
    pub fn misattached_beam(&self, model: &Model) -> Option<BodyId> {
        let is_wrong = |beam: &&TreeBeam| {
            let is_tangent = model.bodies[beam.body.0].beam.as_ref().is_some_and(|beam| beam.frame == Frame::Tangent);
            is_tangent && (beam.is_reversed || self.floating_roots.contains(&beam.body))
        };
        self.beams.iter().find(is_wrong).map(|beam| beam.body)
    }
}
