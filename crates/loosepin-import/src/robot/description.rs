//! A robot as its description has it: links on the ground, joints between frames of them. The frame of a link is that of its file.

use super::turns::about;
use loosepin_space::{Frame, Rotation, Vec3};

/// The number of the link that is the ground.
pub(super) const GROUND: usize = 0;

/// A robot. Link 0 is the ground; joints of the tree come first, each after that of its parent.
#[derive(Debug, Clone)]
pub(super) struct Robot {
    /// Its name.
    pub name: String,
    /// What its file is, for comments.
    pub format: &'static str,
    /// Its links, the ground first.
    pub links: Vec<Link>,
    /// Joints, those of the tree first.
    pub joints: Vec<RobotJoint>,
    /// Acceleration of gravity, m/s².
    pub gravity_m_s2: Option<[f64; 3]>,
    /// Findings in words, one sentence each.
    pub notes: Vec<String>,
}

/// A link.
#[derive(Debug, Clone)]
pub(super) struct Link {
    /// Its name in its file.
    pub name: String,
    /// Its mass, if it has any.
    pub inertial: Option<Inertial>,
    /// Named points, m.
    pub points: Vec<(String, Vec3)>,
}

/// Mass and moments of inertia of a link, in its frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Inertial {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Centre of mass, m.
    pub centre_m: Vec3,
    /// Inertia about the centre of mass, xx, yy, zz, xy, xz, yz, kg m².
    pub inertia_kg_m2: [f64; 6],
}

/// What a joint leaves free.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum RobotJointKind {
    /// Nothing.
    Fixed,
    /// A turn about its axis.
    Hinge,
    /// A displacement along its axis.
    Slide,
    /// All turns.
    Ball,
    /// A turn about its axis, and displacements across it.
    Planar,
}

/// A joint.
#[derive(Debug, Clone)]
pub(super) struct RobotJoint {
    /// Its name in its file.
    pub name: String,
    /// What it leaves free.
    pub kind: RobotJointKind,
    /// The link that carries it, and where it is there.
    pub parent: JointSide,
    /// The link that it moves, and where it is there.
    pub child: JointSide,
    /// Its coordinate in the pose of the description, rad or m.
    pub reference: f64,
    /// Limits of its coordinate, rad or m.
    pub limits: Option<[f64; 2]>,
    /// Whether a motor of the description drives it, or nothing is said about motors.
    pub is_actuated: bool,
    /// Whether it closes a loop.
    pub closes_loop: bool,
    /// What else is said of it, for a comment.
    pub comments: Vec<String>,
}

/// Where a joint is on a link: its coordinate leads from the frame of the parent's side to that of the child's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct JointSide {
    /// The link.
    pub link: usize,
    /// Its point, m.
    pub point_m: Vec3,
    /// Its axis; the length does not matter.
    pub axis: Vec3,
    /// A direction across its axis, as far as it is across; equal on both sides.
    pub across: Vec3,
}

impl JointSide {
    /// A side at a point, with the axis and the direction across it that a file leaves open.
    pub fn new(link: usize, point_m: Vec3, axis: Vec3) -> JointSide {
        JointSide { link, point_m, axis, across: most_across(axis) }
    }

    /// The same side of another link, in whose frame the frame of this one is `frame`.
    pub fn seen_from(&self, link: usize, frame: &Frame) -> JointSide {
        JointSide {
            link,
            point_m: frame.point_m(self.point_m),
            axis: frame.axes.apply(self.axis),
            across: frame.axes.apply(self.across),
        }
    }

    /// Its frame in that of the link: z along the axis, x across it.
    pub fn frame(&self) -> Frame {
        let z = self.axis.normalised().unwrap_or(Vec3::Z);
        let x = (self.across - z * self.across.dot(z)).normalised().unwrap_or(Vec3::X);
        Frame { origin_m: self.point_m, axes: Rotation { x, y: z.cross(x), z } }
    }
}

/// The coordinate axis that is most across a direction: y of x, x of y and z.
pub(super) fn most_across(axis: Vec3) -> Vec3 {
    let [x, y, z] = axis.to_array().map(f64::abs);
    if x <= y && x <= z {
        Vec3::X
    } else if y <= z {
        Vec3::Y
    } else {
        Vec3::Z
    }
}

impl RobotJoint {
    /// The frame of the child's side in that of the parent's with a coordinate.
    fn moved(&self, coordinate: f64) -> Frame {
        match self.kind {
            RobotJointKind::Hinge => Frame { origin_m: Vec3::ZERO, axes: about(2, coordinate) },
            RobotJointKind::Slide => Frame { origin_m: Vec3::Z * coordinate, axes: Rotation::IDENTITY },
            RobotJointKind::Fixed | RobotJointKind::Ball | RobotJointKind::Planar => Frame::IDENTITY,
        }
    }

    /// The joint with its coordinate in the pose of the description, in which both sides are together so far.
    pub fn with_reference(mut self, reference: f64) -> RobotJoint {
        let moves = matches!(self.kind, RobotJointKind::Hinge | RobotJointKind::Slide);
        // Without one no number changes.
        if reference == 0.0 || !moves {
            return self;
        }
        self.reference = reference;
        let frame = self.parent.frame().compose(&self.moved(-reference));
        self.parent.point_m = frame.origin_m;
        self.parent.across = frame.axes.x;
        self
    }
}

impl Robot {
    /// Frames of all links in that of the ground in the pose of the description.
    pub fn frames(&self) -> Vec<Frame> {
        let mut frames = vec![Frame::IDENTITY; self.links.len()];
        for joint in self.joints.iter().filter(|joint| !joint.closes_loop) {
            let at = frames[joint.parent.link].compose(&joint.parent.frame()).compose(&joint.moved(joint.reference));
            frames[joint.child.link] = at.compose(&joint.child.frame().inverse());
        }
        frames
    }

    /// The moving link at the end of the longest chain of joints; of several the last one.
    pub fn tool(&self) -> Option<usize> {
        let mut depths = vec![0_usize; self.links.len()];
        for joint in self.joints.iter().filter(|joint| !joint.closes_loop) {
            depths[joint.child.link] = depths[joint.parent.link] + 1;
        }
        (1..self.links.len()).max_by_key(|link| depths[*link])
    }

    /// Joints of the tree between the ground and the tool.
    pub fn way_to_tool(&self) -> Vec<usize> {
        let mut way = Vec::new();
        let mut link = self.tool().unwrap_or(GROUND);
        // From the tool on: the joint of a parent comes before those of its children.
        for (number, joint) in self.joints.iter().enumerate().rev() {
            if !joint.closes_loop && joint.child.link == link && link != GROUND {
                way.push(number);
                link = joint.parent.link;
            }
        }
        way
    }
}
