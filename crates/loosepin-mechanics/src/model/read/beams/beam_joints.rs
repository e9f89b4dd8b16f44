//! Joints that hold flexible links, and what cannot be combined with them.

use crate::model::ids::{BodyId, JointId, PointId};
use crate::model::joint::AtBeam;
use crate::model::load::ActsOn;
use crate::model::parts::beam_problem::BeamProblem;
use crate::model::parts::topology::Body;
use crate::model::read::reader::ModelReader;
use loosepin_flexible::Frame;
use loosepin_text::diagnostics::Span;
use loosepin_text::document::describe_path;

impl ModelReader {
    /// Reports what a mechanism with flexible bodies cannot have.
    pub(in crate::model) fn refuse_beside_beams(&mut self) {
        let flexible: Vec<BodyId> =
            (1..self.bodies.len()).map(BodyId).filter(|body| self.bodies[body.0].beam.is_some()).collect();
        let Some(first) = flexible.first().map(|body| self.bodies[body.0].name.clone()) else { return };
        let mut found: Vec<(String, BeamProblem)> = Vec::new();
        for body in flexible {
            self.refuse_of_beam(body, &mut found);
        }
        let beside = |path: String| {
            let entry = describe_path(&path);
            (path, BeamProblem::Beside { entry, body: first.clone() })
        };
        let with_friction = self.joints.iter().filter(|joint| joint.friction.is_some());
        found.extend(with_friction.map(|joint| beside(format!("joint.{}", joint.name))));
        found.extend(self.couplings.iter().map(|coupling| beside(coupling.path.clone())));
        found.extend(self.controls.iter().map(|control| beside(format!("control.{}", control.name))));
        for (path, problem) in found {
            let span = self.span_of(&path);
            self.numbers.reader.report(&problem, span);
        }
    }

    fn refuse_of_beam(&self, id: BodyId, found: &mut Vec<(String, BeamProblem)>) {
        let Body { name, points, beam: Some(beam), .. } = &self.bodies[id.0] else { return };
        let body = name.clone();
        let is_between = |index: &usize| beam.is_nodal() && !beam.ends.contains(index);
        for index in (0..points.len()).filter(is_between) {
            let path = format!("body.{name}.points.{}", points[index].name);
            found.push((path.clone(), BeamProblem::NodalPointBetween { entry: describe_path(&path) }));
        }
        let mut is_held = false;
        for (index, joint) in self.joints.iter().enumerate() {
            let Some(PointId { point, .. }) = joint.kind.points().into_iter().find(|point| point.body == id) else {
                continue;
            };
            let (path, body) = (format!("joint.{}", joint.name), body.clone());
            let entry = describe_path(&path);
            let is_driven = self.drives.iter().any(|drive| drive.joint == JointId(index));
            let holds = match joint.kind.at_beam() {
                AtBeam::Refused(kind) => {
                    found.push((path, BeamProblem::WrongJoint { entry, body, kind }));
                    continue;
                }
                AtBeam::Section => true,
                AtBeam::Point => is_driven,
            };
            if beam.is_nodal() {
                // Its sections have angles of their own at both ends.
                continue;
            }
            let is_at_from = point == beam.ends[0];
            match (holds, is_at_from, beam.frame) {
                (true, false, _) if point != beam.ends[1] => {
                    found.push((path, BeamProblem::HeldInside { entry, body }))
                }
                (true, false, _) => found.push((path, BeamProblem::HeldAtTo { entry, body })),
                (true, true, Frame::Secant) => found.push((path, BeamProblem::NeedsTangent { entry, body })),
                (true, true, Frame::Tangent) => is_held = true,
                (false, true, Frame::Tangent) => found.push((path, BeamProblem::NeedsSecant { entry, body })),
                (false, ..) => {}
            }
        }
        if beam.frame == Frame::Tangent && !is_held && found.is_empty() {
            let path = format!("body.{name}.beam");
            found.push((path.clone(), BeamProblem::NotHeld { entry: describe_path(&path) }));
        }
        let turn_of = |path: String| {
            let entry = describe_path(&path);
            (path, BeamProblem::TurnOf { entry, body: body.clone() })
        };
        for spring in &self.springs {
            if spring.kind.points().is_none() && spring.kind.bodies().contains(&id) {
                found.push(turn_of(format!("spring.{}", spring.name)));
            }
        }
        for load in &self.loads {
            let is_torque = load.kind.acts_on() == ActsOn::Body(id);
            let reads = load.joint.is_some_and(|joint| self.joints[joint.0].kind.bodies().contains(&id));
            if is_torque || reads {
                found.push(turn_of(format!("load.{}", load.name)));
            }
        }
    }

    /// Span of an entry, or of the table above it.
    fn span_of(&self, path: &str) -> Span {
        let mut path = path;
        loop {
            if let Some(span) = self.numbers.places.get(path) {
                return *span;
            }
            match path.rsplit_once('.') {
                Some((table, _)) => path = table,
                None => return Span::default(),
            }
        }
    }
}
