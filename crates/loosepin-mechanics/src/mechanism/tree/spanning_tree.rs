//! The spanning tree of a mechanism: which joint carries which body, and which ideal joints close loops.

use crate::mechanism::tree::beam::{BeamPlace, Sections, TreeBeam, sections_of};
use crate::mechanism::tree::nodal_beam::TreeNodalBeam;
use crate::model::{
    Beam, Body, BodyId, DriveId, Formulation, IdealRows, JointId, Model, PlayId, PointId, TreeAttachment, Values,
};
use loosepin_flexible::{Frame, Mesh, Station};
use loosepin_math::Envelope;
use std::sync::Arc;

/// How a body hangs on its parent. `forward` tells that the parent is the first body of the joint (bearing, guide,
/// first) and the child the second one (journal, slider, second).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Attachment {
    /// On nothing: coordinates `first` .. `first + 3` are x, y and angle of the body frame.
    Free {
        /// Index of the first of the three coordinates.
        first: usize,
    },
    /// By a revolute joint; the coordinate is the *absolute* angle of the body. In the plane angles need not be
    /// composed, and absolute ones leave no Coriolis terms and a constant diagonal inertia.
    Revolute {
        /// Index of the coordinate.
        coordinate: usize,
        /// The joint.
        joint: JointId,
        /// Direction of the joint along the tree.
        forward: bool,
    },
    /// By a driven revolute joint; the coordinate is the angle of the journal's body from the bearing's.
    DrivenRevolute {
        /// Index of the coordinate.
        coordinate: usize,
        /// The joint.
        joint: JointId,
        /// Direction of the joint along the tree.
        forward: bool,
    },
    /// By a prismatic joint; the coordinate is the displacement s of the slider point along the guide's line.
    Prismatic {
        /// Index of the coordinate.
        coordinate: usize,
        /// The joint.
        joint: JointId,
        /// Direction of the joint along the tree.
        forward: bool,
    },
    /// By a rigid joint.
    Rigid {
        /// The joint.
        joint: JointId,
        /// Direction of the joint along the tree.
        forward: bool,
    },
    /// The section of a beam at an end or at a point inside, on the frame of its body.
    Section {
        /// Index in [`Tree::beams`].
        beam: usize,
        /// Which one.
        place: BeamPlace,
    },
    /// The section at the tip of a beam in absolute nodal coordinates, on nothing: coordinates `first` .. `first + 3` are x and y of the tip
    /// and the angle of the body frame as this section carries it.
    Node {
        /// Index in [`Tree::nodal_beams`].
        beam: usize,
        /// Index of the first of the three coordinates.
        first: usize,
    },
}

impl Attachment {
    /// The joint by which a body hangs on its parent, and its direction along the tree; `None` for a body that hangs on nothing.
    pub fn joint(&self) -> Option<(JointId, bool)> {
        match *self {
            Self::Free { .. } | Self::Section { .. } | Self::Node { .. } => None,
            Self::Revolute { joint, forward, .. }
            | Self::DrivenRevolute { joint, forward, .. }
            | Self::Prismatic { joint, forward, .. }
            | Self::Rigid { joint, forward } => Some((joint, forward)),
        }
    }

    /// Whether the body may turn against its parent, so that its angle has a sine and cosine of its own.
    pub fn turns(&self) -> bool {
        !matches!(self, Self::Prismatic { .. } | Self::Rigid { .. })
    }

    /// Indices of the coordinates that this attachment adds.
    fn own_coordinates(&self) -> std::ops::Range<usize> {
        match *self {
            Self::Free { first } | Self::Node { first, .. } => first..first + 3,
            Self::Revolute { coordinate, .. }
            | Self::DrivenRevolute { coordinate, .. }
            | Self::Prismatic { coordinate, .. } => coordinate..coordinate + 1,
            // Those of the shapes are counted where the section is made.
            Self::Rigid { .. } | Self::Section { .. } => 0..0,
        }
    }
}

/// A coordinate on which the motion of a body depends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dependence {
    /// Index of the coordinate.
    pub coordinate: usize,
    /// Angular velocity of the body for unit rate of the coordinate: 0, 1 or -1 (0 for a displacement, whose
    /// rate is a length); at a point inside a beam, φ' of its lateral shapes there.
    pub turning: f64,
}

/// A moving body in the tree.
#[derive(Debug, Clone)]
pub struct Link {
    /// The body.
    pub body: BodyId,
    /// Slot of the parent; 0 is the ground.
    pub parent_slot: usize,
    /// How it hangs on the parent.
    pub attachment: Attachment,
    /// Coordinates on which its motion depends: those of the parent first, then its own.
    pub dependences: Vec<Dependence>,
    /// Index in [`Tree::beams`] where it is the frame of a flexible body.
    pub beam: Option<usize>,
    /// Index in [`Tree::nodal_beams`] where it is the frame of a flexible body in absolute nodal coordinates.
    pub nodal_beam: Option<usize>,
    /// Whether it has mass of its own: a rigid body, or a section that carries lumps. The mass of the frame of a flexible body is that of the
    /// beam.
    pub has_own_mass: bool,
}

/// An ideal joint that closes a loop: a constraint between two bodies of the tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cut {
    /// The joint.
    pub joint: JointId,
    /// Slots of its first and second body.
    pub slots: [usize; 2],
    /// The constraints that it is.
    pub rows: IdealRows,
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
#[derive(Debug, Clone, Default)]
pub struct Tree {
    /// Moving bodies, parents first.
    pub links: Vec<Link>,
    /// Slot of each body of the model.
    pub slot_of_body: Vec<usize>,
    /// Number of free coordinates.
    pub free: usize,
    /// The drive of each driven coordinate.
    pub drives: Vec<DriveId>,
    /// Ideal joints that close loops, in file order.
    pub cuts: Vec<Cut>,
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

impl Tree {
    /// Slots of the bodies whose angles have sines and cosines of their own: [`Attachment::turns`].
    pub fn turning_slots(&self) -> impl Iterator<Item = usize> + '_ {
        self.links.iter().enumerate().filter(|(_, link)| link.attachment.turns()).map(|(index, _)| index + 1)
    }

    /// Builds the tree over the joints and couplings for which `is_ideal` holds; the others (with play) leave their loops
    /// open.
    ///
    /// Driven joints are always in the tree, so that their coordinates leave the state; rigid joints come next since
    /// cutting one costs three constraints instead of two; then the others in file order. A joint that never
    /// hangs, such as a slot, is always cut.
    ///
    /// # Errors
    /// A loop of driven joints alone.
    pub fn new(model: &Model, is_ideal: impl Fn(PlayId) -> bool) -> Result<Self, DrivenLoop> {
        let driven: Vec<JointId> = model.drives.iter().map(|drive| drive.joint).collect();
        Self::with_driven(model, is_ideal, &driven)
    }

    /// As [`Tree::new`], with flexible bodies where the model has beams, whose points lie where `values` put them. [`Tree::new`] takes all
    /// bodies for rigid.
    ///
    /// # Errors
    /// A loop of driven joints alone.
    pub fn flexible(model: &Model, values: &Values, is_ideal: impl Fn(PlayId) -> bool) -> Result<Self, DrivenLoop> {
        let driven: Vec<JointId> = model.drives.iter().map(|drive| drive.joint).collect();
        Self::build(model, is_ideal, &driven, Some(values))
    }

    /// As [`Tree::new`], as if there were drives of the joints `driven`.
    ///
    /// # Errors
    /// A loop of driven joints alone.
    pub fn with_driven(
        model: &Model,
        is_ideal: impl Fn(PlayId) -> bool,
        driven: &[JointId],
    ) -> Result<Self, DrivenLoop> {
        Self::build(model, is_ideal, driven, None)
    }

    fn build(
        model: &Model,
        is_ideal: impl Fn(PlayId) -> bool,
        driven: &[JointId],
        of_beams: Option<&Values>,
    ) -> Result<Self, DrivenLoop> {
        let is_coupled = |index: usize| is_ideal(PlayId::Coupling(index));
        let is_ideal = |joint: JointId| is_ideal(PlayId::Joint(joint));
        let mut drives = vec![None; model.joints.len()];
        for (index, joint) in driven.iter().enumerate() {
            drives[joint.0].get_or_insert(DriveId(index));
        }
        let drive_of = |joint: JointId| drives[joint.0];
        let mut order: Vec<JointId> = (0..model.joints.len()).map(JointId).filter(|&joint| is_ideal(joint)).collect();
        let is_inside = |joint: JointId| {
            of_beams.is_some()
                && model.joints[joint.0].kind.points().into_iter().any(|point| is_inside_beam(model, point))
        };
        order.sort_by_key(|&joint| match (drive_of(joint), &model.joints[joint.0].kind) {
            (Some(_), _) => 0,
            (None, kind) if kind.tree_attachment() == TreeAttachment::Fixed => 1,
            // A beam cannot hang by a point inside.
            (None, _) => 2 + usize::from(is_inside(joint)),
        });

        let mut groups = Groups::new(model.bodies.len());
        let mut in_tree = vec![false; model.joints.len()];
        for &joint in order.iter().filter(|joint| model.joints[joint.0].kind.tree_attachment() != TreeAttachment::Never)
        {
            if groups.join(model.joints[joint.0].kind.bodies()) {
                in_tree[joint.0] = true;
            } else if drive_of(joint).is_some() {
                return Err(DrivenLoop { joint });
            }
        }

        let mut tree = Self {
            slot_of_body: vec![usize::MAX; model.bodies.len()],
            coupling_indices: (0..model.couplings.len()).filter(|&index| is_coupled(index)).collect(),
            ..Self::default()
        };
        tree.slot_of_body[0] = 0;
        // Placeholders beyond every free coordinate mark driven ones until the number of free ones is known.
        let own = |body: &Body| {
            let with_points = |beam: &Beam| beam.own_coordinates() + 2 * body.points.len();
            body.beam.as_ref().map_or(0, with_points)
        };
        let of_all: usize = model.bodies.iter().map(own).sum();
        let driven_from = 3 * model.bodies.len() + of_all;
        let mut attached: Vec<BodyId> = vec![BodyId(0)];
        let mut next_root = 1;
        let mut tree_joints = vec![Vec::new(); model.bodies.len()];
        for joint in (0..model.joints.len()).map(JointId).filter(|joint| in_tree[joint.0]) {
            for body in model.joints[joint.0].kind.bodies() {
                tree_joints[body.0].push(joint);
            }
        }
        loop {
            tree.attach_descendants((model, of_beams), &tree_joints, &drive_of, driven_from, &mut attached);
            while next_root < model.bodies.len() && tree.slot_of_body[next_root] != usize::MAX {
                next_root += 1;
            }
            if next_root == model.bodies.len() {
                break;
            }
            let body = BodyId(next_root);
            tree.floating_roots.push(body);
            let attachment = Attachment::Free { first: tree.free };
            tree.free += 3;
            tree.push(body, 0, attachment);
            if let Some(values) = of_beams {
                tree.push_sections((model, values), body, None);
            }
            attached.push(body);
        }
        tree.number_driven_coordinates(driven_from);

        let hangs =
            |joint: JointId| tree.links.iter().any(|link| link.attachment.joint().is_some_and(|(own, _)| own == joint));
        let cut: Vec<JointId> = (0..model.joints.len()).map(JointId).filter(|&j| is_ideal(j) && !hangs(j)).collect();
        for joint in cut {
            let kind = &model.joints[joint.0].kind;
            tree.cuts.push(Cut {
                joint,
                slots: kind.points().map(|point| tree.slot_of_point(point)),
                rows: kind.rows(),
            });
        }
        tree.couplings = tree.coupling_indices.iter().map(|&index| tree.coupling_place(model, index)).collect();
        Ok(tree)
    }

    /// Places of the two joints of a coupling of the model.
    pub fn coupling_place(&self, model: &Model, index: usize) -> CouplingPlace {
        let coupling = &model.couplings[index];
        [coupling.first, coupling.second].map(|joint| JointPlace::new(model, self, joint))
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
        self.cuts.iter().map(|cut| cut.rows.count()).sum()
    }

    /// The possibly non-zero entries of the mass matrix of the free coordinates: between coordinates that move the same body.
    pub fn mass_envelope(&self) -> Envelope {
        let mut first: Vec<usize> = (0..self.free).collect();
        for link in &self.links {
            let coordinates = || link.dependences.iter().map(|d| d.coordinate).filter(|c| *c < self.free);
            let least = coordinates().min().unwrap_or(0);
            coordinates().for_each(|coordinate| first[coordinate] = first[coordinate].min(least));
        }
        for beam in &self.nodal_beams {
            let of_root = self.links[beam.slot - 1].dependences.iter().map(|dependence| dependence.coordinate);
            beam.widen(of_root, &mut first);
        }
        Envelope::new(first)
    }

    /// For each constraint row, the rows that have the same scale: x and y of a point, or the row itself twice.
    pub fn constraint_scales(&self) -> Vec<[usize; 2]> {
        let mut scales = Vec::new();
        for cut in &self.cuts {
            let first = scales.len();
            scales.extend((first..first + cut.rows.count()).map(|row| [row, row]));
            if cut.rows.keeps.count() == 2 {
                scales[first] = [first, first + 1];
                scales[first + 1] = [first, first + 1];
            }
        }
        scales.extend((scales.len()..self.constraint_rows()).map(|row| [row, row]));
        scales
    }

    /// Breadth first over the joints of the tree, listed for each body, from the bodies in `attached` on.
    fn attach_descendants(
        &mut self,
        (model, of_beams): (&Model, Option<&Values>),
        tree_joints: &[Vec<JointId>],
        drive_of: &impl Fn(JointId) -> Option<DriveId>,
        driven_from: usize,
        attached: &mut Vec<BodyId>,
    ) {
        let mut next = attached.len() - 1;
        while next < attached.len() {
            let parent = attached[next];
            next += 1;
            for &joint in &tree_joints[parent.0] {
                let kind = &model.joints[joint.0].kind;
                let [first, second] = kind.points();
                let forward = first.body == parent;
                let (at_parent, at_child) = if forward { (first, second) } else { (second, first) };
                let child = at_child.body;
                let cannot_hang = of_beams.is_some() && is_inside_beam(model, at_child);
                if self.slot_of_body[child.0] != usize::MAX || cannot_hang {
                    continue;
                }
                let drive = drive_of(joint);
                let coordinate = match drive {
                    Some(_) => driven_from + self.drives.len(),
                    None => self.free,
                };
                let attachment = match (kind.tree_attachment(), drive) {
                    (TreeAttachment::Never, _) => continue,
                    (TreeAttachment::Fixed, _) => Attachment::Rigid { joint, forward },
                    (TreeAttachment::Sliding, _) => Attachment::Prismatic { coordinate, joint, forward },
                    (TreeAttachment::Turning, Some(_)) => Attachment::DrivenRevolute { coordinate, joint, forward },
                    (TreeAttachment::Turning, None) => Attachment::Revolute { coordinate, joint, forward },
                };
                if !matches!(attachment, Attachment::Rigid { .. }) {
                    match drive {
                        Some(drive) => self.drives.push(drive),
                        None => self.free += 1,
                    }
                }
                self.push(child, self.slot_of_point(at_parent), attachment);
                if let Some(values) = of_beams {
                    self.push_sections((model, values), child, Some(at_child));
                }
                attached.push(child);
            }
        }
    }

    fn push(&mut self, body: BodyId, parent_slot: usize, attachment: Attachment) {
        let inherited: &[Dependence] = if parent_slot == 0 { &[] } else { &self.links[parent_slot - 1].dependences };
        let mut dependences: Vec<Dependence> = inherited
            .iter()
            .map(|dependence| match attachment {
                Attachment::Revolute { .. } => Dependence { turning: 0.0, ..*dependence },
                _ => *dependence,
            })
            .collect();
        dependences.extend(attachment.own_coordinates().map(|coordinate| Dependence {
            coordinate,
            turning: match attachment {
                Attachment::Free { first } | Attachment::Node { first, .. } if coordinate < first + 2 => 0.0,
                Attachment::Prismatic { .. } => 0.0,
                Attachment::DrivenRevolute { forward: false, .. } => -1.0,
                _ => 1.0,
            },
        }));
        let has_own_mass = !matches!(attachment, Attachment::Node { .. });
        self.links.push(Link {
            body,
            parent_slot,
            attachment,
            dependences,
            beam: None,
            nodal_beam: None,
            has_own_mass,
        });
        self.slot_of_body[body.0] = self.links.len();
    }

    /// Adds the sections of `body`, the link pushed last, if it is flexible, seen from the point at which it hangs on its parent.
    fn push_sections(&mut self, (model, values): (&Model, &Values), body: BodyId, hangs_at: Option<PointId>) {
        let Some(beam) = &model.bodies[body.0].beam else { return };
        let slot = self.links.len();
        let is_reversed = hangs_at.is_some_and(|point| point.point == beam.ends[1]);
        if let Formulation::AbsoluteNodal { elements, rule } = beam.formulation {
            self.push_nodes(beam, body, Mesh::new(elements, rule), is_reversed);
            return;
        }
        let Some(Sections { places, basis, shapes }) = sections_of(model, body, values, is_reversed) else { return };
        let index = self.beams.len();
        let coordinates = self.free..self.free + shapes.count();
        self.free = coordinates.end;
        (self.links[slot - 1].beam, self.links[slot - 1].has_own_mass) = (Some(index), false);
        let mut push = |place: BeamPlace, station: &Station| {
            let mut dependences = self.links[slot - 1].dependences.clone();
            if place != BeamPlace::Root {
                let axial = coordinates.start..coordinates.start + shapes.axial();
                dependences.extend(axial.map(|coordinate| Dependence { coordinate, turning: 0.0 }));
            }
            let lateral = coordinates.start + shapes.axial()..coordinates.end;
            dependences.extend(
                lateral.zip(&station.slopes).map(|(coordinate, turning)| Dependence { coordinate, turning: *turning }),
            );
            let attachment = Attachment::Section { beam: index, place };
            let has_own_mass = beam.lumps.iter().any(|lump| places[lump.point] == place);
            self.links.push(Link {
                body,
                parent_slot: slot,
                attachment,
                dependences,
                beam: None,
                nodal_beam: None,
                has_own_mass,
            });
            self.links.len()
        };
        // The section at the root of a tangent frame is the frame, beside which lumps there have a link of their own.
        let has_lumps_at_root = beam.lumps.iter().any(|lump| places[lump.point] == BeamPlace::Root);
        let pushed = (beam.frame == Frame::Secant || has_lumps_at_root).then(|| push(BeamPlace::Root, &shapes.root));
        let root = pushed.filter(|_| beam.frame == Frame::Secant).unwrap_or(slot);
        let tip = push(BeamPlace::Tip, &shapes.tip);
        let inside =
            shapes.inside.iter().enumerate().map(|(place, station)| push(BeamPlace::Inside(place), station)).collect();
        self.beams.push(TreeBeam {
            body,
            ends: beam.ends,
            slot,
            sections: if is_reversed { [tip, root] } else { [root, tip] },
            inside,
            places,
            is_reversed,
            coordinates,
            basis: Arc::new(basis),
            shapes: Arc::new(shapes),
            is_damped: beam.damping_ratio.is_some(),
            has_lumps: !beam.lumps.is_empty(),
        });
    }

    /// As [`Self::push_sections`], for a body in absolute nodal coordinates.
    fn push_nodes(&mut self, beam: &Beam, body: BodyId, mesh: Mesh, is_reversed: bool) {
        let (slot, index) = (self.links.len(), self.nodal_beams.len());
        let coordinates = self.free..self.free + beam.own_coordinates();
        self.free = coordinates.end;
        (self.links[slot - 1].nodal_beam, self.links[slot - 1].has_own_mass) = (Some(index), false);
        // The last four are x, y, θ and s of the tip.
        let attachment = Attachment::Node { beam: index, first: coordinates.end - 4 };
        self.push(body, 0, attachment);
        // It does not move with the root, but is part of what hangs there.
        self.links[slot].parent_slot = slot;
        let tip_slot = self.links.len();
        // The angle of the body is that of its section at `from`, wherever it hangs.
        self.slot_of_body[body.0] = if is_reversed { tip_slot } else { slot };
        self.nodal_beams.push(TreeNodalBeam {
            body,
            ends: beam.ends,
            slot,
            tip_slot,
            is_reversed,
            coordinates,
            mesh: Arc::new(mesh),
            is_damped: beam.retardation_s.is_some(),
        });
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

    /// Moves the driven coordinates from their placeholders to directly after the free ones.
    fn number_driven_coordinates(&mut self, driven_from: usize) {
        let free = self.free;
        let renumbered = |coordinate: usize| {
            if coordinate >= driven_from { coordinate - driven_from + free } else { coordinate }
        };
        for link in &mut self.links {
            for dependence in &mut link.dependences {
                dependence.coordinate = renumbered(dependence.coordinate);
            }
            match &mut link.attachment {
                Attachment::DrivenRevolute { coordinate, .. } | Attachment::Prismatic { coordinate, .. } => {
                    *coordinate = renumbered(*coordinate);
                }
                Attachment::Revolute { .. }
                | Attachment::Free { .. }
                | Attachment::Rigid { .. }
                | Attachment::Section { .. }
                | Attachment::Node { .. } => {}
            }
        }
    }
}

/// Whether a point belongs to a flexible body and is not one of its ends.
fn is_inside_beam(model: &Model, point: PointId) -> bool {
    model.bodies[point.body.0].beam.as_ref().is_some_and(|beam| !beam.ends.contains(&point.point))
}

/// Bodies that joints connect, by the way to a body that stands for all of its group.
struct Groups(Vec<usize>);

impl Groups {
    fn new(bodies: usize) -> Self {
        Self((0..bodies).collect())
    }

    fn of(&mut self, mut body: usize) -> usize {
        while self.0[body] != body {
            self.0[body] = self.0[self.0[body]];
            body = self.0[body];
        }
        body
    }

    /// Connects two bodies; false where they were connected already.
    fn join(&mut self, bodies: [BodyId; 2]) -> bool {
        let [first, second] = bodies.map(|body| self.of(body.0));
        self.0[second] = first;
        first != second
    }
}
