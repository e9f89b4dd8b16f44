//! The names of a model: of bodies, joints and points.

use super::description::{JointSide, Robot};
use super::names::Names;
use loosepin_space::Vec3;

/// Names of bodies, joints and outputs, and the points of each body.
#[derive(Debug)]
pub(super) struct ModelNames {
    bodies: Vec<String>,
    joints: Vec<String>,
    points: Vec<Vec<(String, Vec3)>>,
    turn_output: String,
    /// Names that had to be changed.
    pub changed: Vec<(String, String)>,
}

impl ModelNames {
    /// Names for all that a model of the robot has.
    pub fn new(robot: &Robot) -> ModelNames {
        let mut bodies = Names::without(&["ground"]);
        let mut own: Vec<String> = robot.links.iter().skip(1).map(|link| bodies.claim(&link.name)).collect();
        own.insert(0, "ground".to_owned());
        let mut joints = Names::default();
        let joint_names: Vec<String> = robot.joints.iter().map(|joint| joints.claim(&joint.name)).collect();
        let mut points: Vec<(Names, Vec<(String, Vec3)>)> =
            robot.links.iter().map(|_| (Names::default(), Vec::new())).collect();
        for (number, joint) in robot.joints.iter().enumerate() {
            for JointSide { link, point_m, .. } in [joint.parent, joint.child] {
                let wanted = if point_m == Vec3::ZERO { "o" } else { joint_names[number].as_str() };
                add(&mut points[link], wanted, point_m);
            }
        }
        if let Some(tool) = robot.tool() {
            add(&mut points[tool], "o", Vec3::ZERO);
        }
        for (link, points) in robot.links.iter().zip(&mut points) {
            for (name, point_m) in &link.points {
                let name = points.0.claim(name);
                points.1.push((name, *point_m));
            }
        }
        let mut outputs = Names::without(&own.iter().map(String::as_str).collect::<Vec<_>>());
        let turn_output = outputs.claim(&format!("turn_of_{}", robot.tool().map_or("", |tool| own[tool].as_str())));
        let mut changed = bodies.changed;
        changed.extend(joints.changed);
        changed.extend(points.iter_mut().flat_map(|(names, _)| std::mem::take(&mut names.changed)));
        ModelNames {
            bodies: own,
            joints: joint_names,
            points: points.into_iter().map(|(_, points)| points).collect(),
            turn_output,
            changed,
        }
    }

    /// The name of a body.
    pub fn body(&self, link: usize) -> &str {
        self.bodies.get(link).map_or("", String::as_str)
    }

    /// The name of a joint.
    pub fn joint(&self, joint: usize) -> &str {
        self.joints.get(joint).map_or("", String::as_str)
    }

    /// The points of a body.
    pub fn points(&self, link: usize) -> &[(String, Vec3)] {
        self.points.get(link).map_or(&[], Vec::as_slice)
    }

    /// The point of a body at a place, as a model refers to it.
    pub fn point(&self, link: usize, point_m: Vec3) -> String {
        let own = self.points(link).iter().find(|(_, at_m)| *at_m == point_m);
        format!("{}.{}", self.body(link), own.map_or("o", |(name, _)| name.as_str()))
    }

    /// The name of the output of a turn.
    pub fn turn_output(&self) -> &str {
        &self.turn_output
    }
}

/// Adds a point, unless there is one at its place.
fn add((names, points): &mut (Names, Vec<(String, Vec3)>), wanted: &str, point_m: Vec3) {
    if !points.iter().any(|(_, at_m)| *at_m == point_m) {
        points.push((names.claim(wanted), point_m));
    }
}
