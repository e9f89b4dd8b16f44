//! Four-bar loops and slider-cranks through the ground, with their classes.

use loosepin_math::{Vec2, sort_ascending};
use loosepin_mechanics::mechanism::point_m;
use loosepin_mechanics::model::{Model, PointId, Prismatic, Values};
use loosepin_result::kinematics::{LoopClass, LoopProperties};

/// Lengths whose sums differ by a smaller share are equal: a change point is written with round numbers, and read with round-off.
const EQUAL: f64 = 1e-12;

/// A pin of a loop, with its points on the body before and behind it.
#[derive(Clone, Copy)]
pub struct Pin {
    /// Index of its joint in the model.
    joint: usize,
    points: [PointId; 2],
}

impl Pin {
    /// From `body` to another one; none if it is at neither end.
    fn from(self, body: usize) -> Option<Self> {
        let [first, second] = self.points;
        match () {
            () if first.body.0 == body => Some(self),
            () if second.body.0 == body => Some(Self { points: [second, first], ..self }),
            () => None,
        }
    }

    fn to(self) -> usize {
        self.points[1].body.0
    }
}

/// A loop through the ground, by its joints from the ground on.
pub enum GroundLoop {
    /// Ground to link, link to coupler, coupler to other link, other link to ground.
    FourBar([Pin; 4]),
    /// Ground to crank, crank to rod, rod to slider; the slider's guide.
    SliderCrank([Pin; 3], usize),
}

/// All loops of `model` of these kinds.
pub fn ground_loops(model: &Model) -> Vec<GroundLoop> {
    let pins: Vec<Pin> = model
        .joints
        .iter()
        .enumerate()
        .filter_map(|(joint, entry)| Some(Pin { joint, points: entry.kind.revolute_points()? }))
        .collect();
    let from = |body: usize| pins.iter().filter_map(move |pin| pin.from(body));
    let mut found = Vec::new();
    for first in from(0) {
        for second in from(first.to()).filter(|pin| pin.joint != first.joint && pin.to() != 0) {
            for third in from(second.to()).filter(|pin| pin.joint != second.joint && pin.to() != first.to()) {
                for last in from(third.to()).filter(|pin| pin.to() == 0 && pin.joint > first.joint) {
                    if third.to() != 0 {
                        found.push(GroundLoop::FourBar([first, second, third, last]));
                    }
                }
                for (guide, joint) in model.joints.iter().enumerate() {
                    let Some(line) = joint.kind.prismatic() else { continue };
                    let mut ends = [line.guide.body.0, line.slider.body.0];
                    ends.sort_unstable();
                    if third.to() != 0 && ends == [0, third.to()] {
                        found.push(GroundLoop::SliderCrank([first, second, third], guide));
                    }
                }
            }
        }
    }
    found
}

/// A body with the angle of a line in its frame, rad.
type Line = (usize, f64);

impl GroundLoop {
    /// Its lengths and its class.
    pub fn properties(&self, model: &Model, values: &Values) -> LoopProperties {
        let arm_m = |point: PointId| point_m(model, values, point);
        let between = |a: PointId, b: PointId| (arm_m(a) - arm_m(b)).length();
        let name = |body: usize| model.bodies[body].name.clone();
        match self {
            Self::FourBar(joints) => {
                let link = |before: usize, behind: usize| between(joints[before].points[1], joints[behind].points[0]);
                let lengths_m = [link(3, 0), link(0, 1), link(1, 2), link(2, 3)];
                let bodies: Vec<String> = (0..4).map(|k| name(joints[k].points[0].body.0)).collect();
                let shortest = shortest(lengths_m);
                LoopProperties {
                    shortest: Some(bodies[shortest].clone()),
                    bodies,
                    lengths_m: lengths_m.to_vec(),
                    class: grashof_class(lengths_m),
                }
            }
            Self::SliderCrank(joints, guide) => {
                let crank_m = between(joints[0].points[1], joints[1].points[0]);
                let rod_m = between(joints[1].points[1], joints[2].points[0]);
                let offset_m = guide_line(model, values, *guide).map_or(0.0, |[ground, slider]| {
                    let across = |(point, angle_rad): (PointId, f64), to: PointId| {
                        (arm_m(point) - arm_m(to)).dot(Vec2::new(-angle_rad.sin(), angle_rad.cos()))
                    };
                    (across(ground, joints[0].points[0]) - across(slider, joints[2].points[1])).abs()
                });
                LoopProperties {
                    bodies: joints.iter().map(|joint| name(joint.points[1].body.0)).collect(),
                    lengths_m: vec![crank_m, rod_m, offset_m],
                    class: slider_crank_class(crank_m, rod_m, offset_m),
                    shortest: None,
                }
            }
        }
    }

    /// Coupler and output with their lines, from the joint between both on, and whether a pressure angle is between them; none if no
    /// drive turns a link at the ground.
    pub fn transmission(
        &self,
        model: &Model,
        values: &Values,
        is_driven: &dyn Fn(usize) -> bool,
    ) -> Option<(Line, Line, bool)> {
        let line = |from: PointId, to: PointId| {
            let along_m: Vec2<f64> = point_m(model, values, to) - point_m(model, values, from);
            (from.body.0, along_m.y.atan2(along_m.x))
        };
        match self {
            Self::FourBar([first, second, third, last]) => {
                if is_driven(first.joint) {
                    let coupler = line(third.points[0], second.points[1]);
                    return Some((coupler, line(third.points[1], last.points[0]), false));
                }
                let coupler = line(second.points[1], third.points[0]);
                is_driven(last.joint).then(|| (coupler, line(second.points[0], first.points[1]), false))
            }
            Self::SliderCrank([first, second, third], guide) if is_driven(first.joint) => {
                let [_, (point, angle_rad)] = guide_line(model, values, *guide)?;
                Some((line(second.points[1], third.points[0]), (point.body.0, angle_rad), true))
            }
            Self::SliderCrank(..) => None,
        }
    }
}

/// A point of the line of a guide and its direction on the ground, then on the slider.
fn guide_line(model: &Model, values: &Values, joint: usize) -> Option<[(PointId, f64); 2]> {
    let line = model.joints[joint].kind.prismatic()?;
    let Prismatic { guide, slider, guide_angle_rad, slider_angle_rad, .. } = line;
    let mut ends = [(*guide, values[*guide_angle_rad]), (*slider, values[*slider_angle_rad])];
    if slider.body.0 == 0 {
        ends.reverse();
    }
    Some(ends)
}

/// Place of the shortest length; the first of equal ones.
fn shortest(lengths_m: [f64; 4]) -> usize {
    (1..4).fold(0, |least, place| if lengths_m[place] < lengths_m[least] { place } else { least })
}

/// Grashof's class of a four-bar: lengths of ground, link, coupler, other link, m.
pub fn grashof_class(lengths_m: [f64; 4]) -> LoopClass {
    let mut sorted = lengths_m;
    sort_ascending(&mut sorted);
    let [least, second, third, most] = sorted;
    let margin_m = second + third - least - most;
    match shortest(lengths_m) {
        _ if margin_m.abs() <= EQUAL * (second + third) => LoopClass::ChangePoint,
        _ if margin_m < 0.0 => LoopClass::TripleRocker,
        0 => LoopClass::DoubleCrank,
        2 => LoopClass::DoubleRocker,
        _ => LoopClass::CrankRocker,
    }
}

/// Class of a slider-crank: its crank turns fully where crank + |offset| <= rod.
pub fn slider_crank_class(crank_m: f64, rod_m: f64, offset_m: f64) -> LoopClass {
    let margin_m = rod_m - crank_m - offset_m.abs();
    match () {
        () if margin_m.abs() <= EQUAL * rod_m => LoopClass::TurningCrankAtLimit,
        () if margin_m > 0.0 => LoopClass::TurningCrank,
        () => LoopClass::RockingCrank,
    }
}
