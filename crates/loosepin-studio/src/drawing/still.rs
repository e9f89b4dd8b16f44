//! The picture of a mechanism that does not move yet: its bodies where they were drawn.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap, HashMap};

use loosepin::model::{Drive, Model, PointId, Values};
use loosepin::result::simulation::{Drawing, PoseTable};
use loosepin::simulate::parts;

const M_PER_MM: f64 = 1e-3;
/// Largest coordinate of a drawing, mm.
const FURTHEST_MM: f64 = 1e9;

/// Poses of bodies by their names: x and y of the origin, mm, and the angle, degrees.
pub type NamedPoses = BTreeMap<String, [f64; 3]>;

/// Pose of a body: position of its origin, m, and angle of its x axis, rad.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Pose {
    /// Origin, m.
    pub origin_m: [f64; 2],
    /// Angle, rad.
    pub angle_rad: f64,
}

impl Pose {
    /// From mm and degrees; `None` if it is none, or far away.
    pub fn of_page([x, y, degrees]: [f64; 3]) -> Option<Self> {
        let is_near = [x, y, degrees].iter().all(|value| value.is_finite() && value.abs() < FURTHEST_MM);
        is_near.then(|| Self { origin_m: [x * M_PER_MM, y * M_PER_MM], angle_rad: degrees.to_radians() })
    }

    /// In mm and degrees.
    pub fn for_page(&self) -> [f64; 3] {
        [self.origin_m[0] / M_PER_MM, self.origin_m[1] / M_PER_MM, self.angle_rad.to_degrees()]
    }

    /// From the frame of the body to that of the ground.
    pub fn world_m(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sine, cosine) = self.angle_rad.sin_cos();
        [self.origin_m[0] + cosine * x - sine * y, self.origin_m[1] + sine * x + cosine * y]
    }

    /// From the frame of the ground to that of the body.
    pub fn local_m(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (dx, dy) = (x - self.origin_m[0], y - self.origin_m[1]);
        let (sine, cosine) = self.angle_rad.sin_cos();
        [cosine * dx + sine * dy, cosine * dy - sine * dx]
    }
}

/// Position of a point in its body, m.
pub fn in_body_m(model: &Model, values: &Values, point: PointId) -> [f64; 2] {
    model.bodies[point.body.0].points[point.point].position_m.map(|id| values[id])
}

/// Poses of all bodies, in their order: as given, or else joined to those that are placed, at the angle that the model guesses.
pub fn placed(model: &Model, given: &NamedPoses) -> Vec<Pose> {
    let values = model.quantities.nominal();
    let mut poses: Vec<Option<Pose>> =
        model.bodies.iter().map(|body| given.get(&body.name).and_then(|pose| Pose::of_page(*pose))).collect();
    if let Some(ground) = poses.first_mut() {
        *ground = Some(Pose::default());
    }
    let mut guesses_rad: HashMap<usize, f64> = HashMap::new();
    for guess in &model.guesses {
        guesses_rad.entry(guess.body.0).or_insert(values[guess.angle_rad]);
    }
    let guess_rad = |body: usize| guesses_rad.get(&body).copied();
    let mut drives: HashMap<usize, &Drive> = HashMap::new();
    for drive in &model.drives {
        drives.entry(drive.joint.0).or_insert(drive);
    }
    let mut joints_of: Vec<Vec<usize>> = vec![Vec::new(); model.bodies.len()];
    for (index, joint) in model.joints.iter().enumerate() {
        joint.kind.points().iter().for_each(|point| joints_of[point.body.0].push(index));
    }
    // Joints of what is placed, the first of the model first.
    let mut open: BinaryHeap<Reverse<usize>> = BinaryHeap::new();
    let placed_first = (0..poses.len()).filter(|body| poses[*body].is_some());
    open.extend(placed_first.flat_map(|body| &joints_of[body]).map(|joint| Reverse(*joint)));
    let mut lost = 0;
    // Each round places what is joined to something that is placed; where nothing is, the next body lies at the origin.
    loop {
        let Some(Reverse(next)) = open.pop() else {
            while poses.get(lost).is_some_and(Option::is_some) {
                lost += 1;
            }
            if lost == poses.len() {
                break;
            }
            poses[lost] = Some(Pose { angle_rad: guess_rad(lost).unwrap_or(0.0), ..Pose::default() });
            open.extend(joints_of[lost].iter().map(|joint| Reverse(*joint)));
            continue;
        };
        let joint = &model.joints[next];
        let [first, second] = joint.kind.points();
        let (held, pose, point, sense) = match (poses[first.body.0], poses[second.body.0]) {
            (Some(pose), None) => (first, pose, second, 1.0),
            (None, Some(pose)) => (second, pose, first, -1.0),
            _ => continue,
        };
        let angle_rad = match joint.kind.held_turn_rad(&|id| values[id]) {
            Some(turned_rad) => pose.angle_rad + sense * turned_rad,
            None => {
                let drive = drives.get(&next);
                let start = drive.and_then(|drive| model.quantities.id(&format!("drive.{}.start_angle", drive.name)));
                let driven = start.map(|start| pose.angle_rad + sense * values[start]);
                driven.or_else(|| guess_rad(point.body.0)).unwrap_or(pose.angle_rad)
            }
        };
        let at_m = pose.world_m(in_body_m(model, &values, held));
        let turned = Pose { angle_rad, ..Pose::default() }.world_m(in_body_m(model, &values, point));
        poses[point.body.0] = Some(Pose { origin_m: [at_m[0] - turned[0], at_m[1] - turned[1]], angle_rad });
        open.extend(joints_of[point.body.0].iter().map(|joint| Reverse(*joint)));
    }
    poses.into_iter().map(Option::unwrap_or_default).collect()
}

/// The drawing of a model at one pose.
pub fn still_drawing(model: &Model, poses: &[Pose]) -> Drawing {
    let column = |number: fn(&Pose) -> f64| poses.iter().map(|pose| vec![number(pose)]).collect::<Vec<_>>();
    let mut drawing = parts(model, &model.quantities.nominal());
    drawing.poses = PoseTable {
        drive_angle_rad: vec![0.0],
        x_m: column(|pose| pose.origin_m[0]),
        y_m: column(|pose| pose.origin_m[1]),
        angle_rad: column(|pose| pose.angle_rad),
    };
    drawing
}
