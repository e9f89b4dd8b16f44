//! A joint that is dragged at a shown pose: its centre moves, all other centres stay, and the links at it change their shape.
//!
//! With the centre to be at P, a link with one other centre at Q keeps the direction between both in its own frame, and their distance
//! becomes |P - Q|: its length changes, and it turns. A plate, with two other centres or more, keeps its place, and the point moves in it.
//! The origin of a link keeps (0, 0), and its other points move instead. A block keeps its guide: P is dropped onto its line. So it is
//! with a link whose angle a slot or a guide on it gives: P is dropped onto the line from its other centre.

use std::collections::{HashMap, HashSet};

use loosepin::model::{BodyId, JointKind, Model, PointId, QuantityId, Values};

use crate::drawing::centres::{Centres, SAME_CENTRE_M};
use crate::drawing::still::{Pose, in_body_m};

/// A coordinate of a point and the value that it is to have, m.
pub type Coordinate = (QuantityId, f64);

/// A mechanism at a pose.
pub struct PosedMechanism<'a> {
    model: &'a Model,
    values: Values,
    poses: &'a [Pose],
}

impl<'a> PosedMechanism<'a> {
    /// `poses` in the order of the bodies.
    pub fn new(model: &'a Model, poses: &'a [Pose]) -> Self {
        Self { model, values: model.quantities.nominal(), poses }
    }

    /// Position of a point in its body, m.
    fn in_body_m(&self, point: PointId) -> [f64; 2] {
        in_body_m(self.model, &self.values, point)
    }

    /// Position of a point, m.
    pub fn at_m(&self, point: PointId) -> [f64; 2] {
        self.poses[point.body.0].world_m(self.in_body_m(point))
    }

    /// The points that a revolute joint holds together, with those of the other revolute joints at the same place of a body.
    pub fn together(&self, joint: usize) -> Vec<PointId> {
        let mut ends_of: HashMap<BodyId, Vec<[PointId; 2]>> = HashMap::new();
        for joint in self.model.joints.iter().filter(|joint| joint.kind.turns()) {
            let [one, other] = joint.kind.points();
            ends_of.entry(one.body).or_default().push([one, other]);
            ends_of.entry(other.body).or_default().push([other, one]);
        }
        let mut held = self.model.joints[joint].kind.points().to_vec();
        let mut known: HashSet<PointId> = held.iter().copied().collect();
        let mut centres = Centres::default();
        let mut next = 0;
        while let Some(at) = held.get(next).copied() {
            next += 1;
            // Other names of a place have the same joints.
            if !centres.is_new(at.body.0, self.in_body_m(at)) {
                continue;
            }
            let ends = ends_of.get(&at.body).into_iter().flatten();
            for point in ends.filter(|[own, _]| self.is_same(*own, at)).flatten() {
                if known.insert(*point) {
                    held.push(*point);
                }
            }
        }
        held
    }

    /// Whether two points are one place of one body.
    fn is_same(&self, a: PointId, b: PointId) -> bool {
        a.body == b.body && length(minus(self.in_body_m(a), self.in_body_m(b))) < SAME_CENTRE_M
    }

    /// Allowed position of the centre at `from_m` when it is dragged to `to_m`: anywhere, or along the line of a body that does not turn
    /// with it.
    pub fn allowed_m(&self, held: &[PointId], from_m: [f64; 2], to_m: [f64; 2]) -> [f64; 2] {
        let Some([x, y]) = held.iter().find_map(|point| self.line_of(*point)) else { return to_m };
        let way = minus(to_m, from_m);
        let along = (way[0] * x + way[1] * y) / (x * x + y * y);
        [from_m[0] + along * x, from_m[1] + along * y]
    }

    /// The direction in which a point can go where its body is a block in a guide, or a link whose angle is given by a slot or guide on
    /// it.
    fn line_of(&self, at: PointId) -> Option<[f64; 2]> {
        let kinds = || self.model.joints.iter().map(|joint| &joint.kind);
        let in_guide = kinds().filter(|kind| is_block_of(kind, at.body)).find_map(|kind| {
            let line = kind.line()?;
            let angle_rad = self.poses[line.point.body.0].angle_rad + self.model.quantities.nominal()[line.angle_rad];
            Some([angle_rad.cos(), angle_rad.sin()])
        });
        // A link that another drive, an actuator or a coupling turns does not turn with the pin.
        let is_driven = || {
            let driven = self.model.drives.iter().map(|drive| self.model.joints[drive.joint.0].kind.bodies());
            let on_ground =
                || kinds().any(|kind| kind.bodies().contains(&at.body) && kind.bodies().contains(&BodyId(0)));
            self.model.drives.len() > 1 && driven.flatten().any(|body| body == at.body)
                || !self.model.controls.is_empty()
                || !self.model.couplings.is_empty() && on_ground()
        };
        let is_turned =
            || at.body.0 != 0 && (is_driven() || kinds().any(|kind| !kind.turns() && kind.points()[0].body == at.body));
        in_guide.or_else(|| match self.other_centres(at)[..] {
            [other] if is_turned() => Some(minus(self.at_m(at), self.at_m(other))),
            _ => None,
        })
    }

    /// New coordinates of the bodies at a centre when it moves to `to_m`.
    pub fn moved(&self, held: &[PointId], to_m: [f64; 2]) -> Vec<Coordinate> {
        let mut bodies: Vec<BodyId> = Vec::new();
        let mut changed = Vec::new();
        for point in held.iter().filter(|point| !self.slides(point.body)) {
            if !bodies.contains(&point.body) {
                bodies.push(point.body);
                changed.extend(self.reshaped(*point, held, to_m));
            }
        }
        changed
    }

    fn reshaped(&self, at: PointId, held: &[PointId], to_m: [f64; 2]) -> Vec<Coordinate> {
        let others = self.other_centres(at);
        let own_m = self.in_body_m(at);
        let pose = &self.poses[at.body.0];
        let is_origin = own_m == [0.0, 0.0] && at.body.0 != 0;
        // All names of the centre move with it.
        let own: Vec<PointId> = held.iter().copied().filter(|point| point.body == at.body).collect();
        match others[..] {
            [] if at.body.0 != 0 => Vec::new(),
            [other] if at.body.0 != 0 => {
                let other_m = self.in_body_m(other);
                let distance_m = length(minus(to_m, pose.world_m(other_m)));
                let (fixed_m, end_m) = if is_origin { (own_m, other_m) } else { (other_m, own_m) };
                let old_m = length(minus(end_m, fixed_m));
                let share = distance_m / old_m;
                let new_m = [0, 1].map(|axis| fixed_m[axis] + share * (end_m[axis] - fixed_m[axis]));
                let moving: Vec<PointId> = if is_origin { self.at_same_place(other) } else { own };
                moving.into_iter().flat_map(|point| self.placed(point, new_m)).collect()
            }
            _ if is_origin => {
                let shift_m = pose.local_m(to_m);
                let body = &self.model.bodies[at.body.0];
                let points = (0..body.points.len()).map(|point| PointId { body: at.body, point });
                let others = points.filter(|point| !self.is_same(*point, at));
                others.flat_map(|point| self.placed(point, minus(self.in_body_m(point), shift_m))).collect()
            }
            _ => own.into_iter().flat_map(|point| self.placed(point, pose.local_m(to_m))).collect(),
        }
    }

    /// Poses of all bodies when a centre has gone to `to_m`, as far as the centre says: a link with one other centre turns about that, a
    /// plate keeps its place, and what nothing else holds goes along.
    pub fn poses_after(&self, held: &[PointId], to_m: [f64; 2]) -> Vec<Pose> {
        let mut poses = self.poses.to_vec();
        for at in held.iter().filter(|point| point.body.0 != 0) {
            let own_m = self.in_body_m(*at);
            let pose = self.poses[at.body.0];
            let from_m = pose.world_m(own_m);
            let is_origin = own_m == [0.0, 0.0];
            poses[at.body.0] = match self.other_centres(*at)[..] {
                _ if self.slides(at.body) => moved_along(pose, from_m, to_m),
                [] => moved_along(pose, from_m, to_m),
                [other] => {
                    let fixed_m = pose.world_m(self.in_body_m(other));
                    let turn_rad = direction_rad(fixed_m, to_m) - direction_rad(fixed_m, from_m);
                    let angle_rad = pose.angle_rad + turn_rad;
                    // The other centre stays, and so does what is written of it in the body, unless this one is the origin.
                    let turned = Pose { origin_m: [0.0; 2], angle_rad };
                    let other_m = turned.world_m(self.in_body_m(other));
                    let origin_m = if is_origin { to_m } else { minus(fixed_m, other_m) };
                    Pose { origin_m, angle_rad }
                }
                _ if is_origin => Pose { origin_m: to_m, ..pose },
                _ => pose,
            };
        }
        poses
    }

    /// Whether a body is the block of a guide.
    fn slides(&self, body: BodyId) -> bool {
        let mut kinds = self.model.joints.iter().map(|joint| &joint.kind);
        kinds.any(|kind| is_block_of(kind, body))
    }

    fn placed(&self, point: PointId, [x, y]: [f64; 2]) -> Vec<Coordinate> {
        let coordinates = self.model.bodies[point.body.0].points[point.point].position_m;
        let now = self.in_body_m(point);
        // What does not change is not written, so that a zero stays one.
        let changes = [(coordinates[0], x, now[0]), (coordinates[1], y, now[1])].into_iter();
        changes.filter(|(_, new, old)| (new - old).abs() > SAME_CENTRE_M).map(|(id, new, _)| (id, new)).collect()
    }

    /// One point of each other place of a body that a joint holds.
    fn other_centres(&self, at: PointId) -> Vec<PointId> {
        let mut centres = Centres::default();
        centres.is_new(at.body.0, self.in_body_m(at));
        let points = self.model.joints.iter().flat_map(|joint| joint.kind.points());
        points.filter(|point| point.body == at.body && centres.is_new(at.body.0, self.in_body_m(*point))).collect()
    }

    fn at_same_place(&self, at: PointId) -> Vec<PointId> {
        let body = &self.model.bodies[at.body.0];
        let points = (0..body.points.len()).map(|point| PointId { body: at.body, point });
        points.filter(|point| self.is_same(*point, at)).collect()
    }
}

fn moved_along(pose: Pose, from_m: [f64; 2], to_m: [f64; 2]) -> Pose {
    let way = minus(to_m, from_m);
    Pose { origin_m: [pose.origin_m[0] + way[0], pose.origin_m[1] + way[1]], ..pose }
}

/// The direction from one place to another, rad.
fn direction_rad(from: [f64; 2], to: [f64; 2]) -> f64 {
    let [x, y] = minus(to, from);
    y.atan2(x)
}

pub fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

pub fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// Whether `body` slides along a line of another one and does not turn against it.
fn is_block_of(kind: &JointKind, body: BodyId) -> bool {
    kind.line().is_some() && kind.holds_angle() && kind.bodies()[1] == body
}
