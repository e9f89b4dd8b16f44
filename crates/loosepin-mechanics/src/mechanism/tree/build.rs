//! Builds the spanning tree of a planar model.

use crate::mechanism::attachment::{
    FormOfAttachment, Free, Node, PlaneAttachment, Prismatic, Revolute, Rigid, Section,
};
use crate::mechanism::tree::beam::{BeamPlace, Sections, TreeBeam, sections_of};
use crate::mechanism::tree::nodal_beam::TreeNodalBeam;
use crate::mechanism::tree::spanning_tree::{Cut, DrivenLoop, Link, Tree};
use crate::model::{Beam, Body, BodyId, DriveId, Formulation, JointId, Model, PlayId, PointId, TreeAttachment, Values};
use core::ops::Range;
use loosepin_flexible::{Frame, Mesh};
use std::sync::Arc;

impl Tree {
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
            ..Self::empty()
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
            tree.push(body, 0, Free.into(), None);
            if let Some(values) = of_beams {
                tree.push_sections((model, values), body, None);
            }
            attached.push(body);
        }
        tree.number_driven_coordinates(driven_from);

        let hangs = |joint: JointId| tree.links.iter().any(|link| link.joint().is_some_and(|(own, _)| own == joint));
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
                let attachment = match kind.tree_attachment() {
                    TreeAttachment::Never => continue,
                    TreeAttachment::Fixed => Rigid { joint, forward }.into(),
                    TreeAttachment::Sliding => Prismatic { joint, forward }.into(),
                    // What a drive turns it turns from the other body.
                    TreeAttachment::Turning => Revolute { joint, forward, turns_alone: drive.is_none() }.into(),
                };
                let driven = drive.map(|drive| (drive, driven_from));
                self.push(child, self.slot_of_point(at_parent), attachment, driven);
                if let Some(values) = of_beams {
                    self.push_sections((model, values), child, Some(at_child));
                }
                attached.push(child);
            }
        }
    }

    /// Adds a body with coordinates of its own, which a drive holds where there is one: these are numbered from `driven_from` for now.
    fn push(
        &mut self,
        body: BodyId,
        parent_slot: usize,
        attachment: PlaneAttachment,
        driven: Option<(DriveId, usize)>,
    ) {
        let [count, _] = attachment.counts();
        let coordinates = match driven.filter(|_| count > 0) {
            Some((drive, driven_from)) => {
                let first = driven_from + self.drives.len();
                self.drives.push(drive);
                first..first + count
            }
            None => {
                let first = self.free;
                self.free += count;
                first..first + count
            }
        };
        self.push_link(body, parent_slot, attachment, coordinates, driven.is_some());
    }

    fn push_link(
        &mut self,
        body: BodyId,
        parent_slot: usize,
        attachment: PlaneAttachment,
        coordinates: Range<usize>,
        is_driven: bool,
    ) {
        let inherited = self.dependences(parent_slot);
        self.links.push(Link {
            body,
            parent_slot,
            attachment,
            speeds: coordinates.clone(),
            is_driven,
            dependences: inherited.iter().copied().chain(coordinates.clone()).collect(),
            inherited: inherited.len(),
            coordinates,
            beam: None,
            nodal_beam: None,
            has_own_mass: !attachment.is_section(),
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
        let mut push = |place: BeamPlace| {
            let mut dependences = self.links[slot - 1].dependences.clone();
            let inherited = dependences.len();
            if place != BeamPlace::Root {
                dependences.extend(coordinates.start..coordinates.start + shapes.axial());
            }
            dependences.extend(coordinates.start + shapes.axial()..coordinates.end);
            self.links.push(Link {
                body,
                parent_slot: slot,
                attachment: Section { beam: index, place }.into(),
                coordinates: 0..0,
                speeds: 0..0,
                is_driven: false,
                dependences,
                inherited,
                beam: None,
                nodal_beam: None,
                has_own_mass: beam.lumps.iter().any(|lump| places[lump.point] == place),
            });
            self.links.len()
        };
        // The section at the root of a tangent frame is the frame, beside which lumps there have a link of their own.
        let has_lumps_at_root = beam.lumps.iter().any(|lump| places[lump.point] == BeamPlace::Root);
        let pushed = (beam.frame == Frame::Secant || has_lumps_at_root).then(|| push(BeamPlace::Root));
        let root = pushed.filter(|_| beam.frame == Frame::Secant).unwrap_or(slot);
        let tip = push(BeamPlace::Tip);
        let inside = (0..shapes.inside.len()).map(|place| push(BeamPlace::Inside(place))).collect();
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
        self.push_link(body, 0, Node { beam: index }.into(), coordinates.end - 4..coordinates.end - 1, false);
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

    /// Moves the driven coordinates from their placeholders to directly after the free ones.
    fn number_driven_coordinates(&mut self, driven_from: usize) {
        let free = self.free;
        let renumbered = |coordinate: usize| {
            if coordinate >= driven_from { coordinate - driven_from + free } else { coordinate }
        };
        for link in &mut self.links {
            link.dependences.iter_mut().for_each(|coordinate| *coordinate = renumbered(*coordinate));
            for own in [&mut link.coordinates, &mut link.speeds] {
                *own = renumbered(own.start)..renumbered(own.start) + own.len();
            }
        }
        self.free_speeds = free;
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
