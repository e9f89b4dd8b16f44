//! A box of positions about one of them.

use crate::closure::loops::{Loops, first_column};
use crate::enclosure::jet::{Jet, Number, Variables};
use crate::enclosure::joint::{EnclosedJoint, FixedPose};
use crate::enclosure::row::residual;
use crate::enclosure::shift::{EnclosedShift, radii_m};
use crate::enclosure::step::{STEP_NUMBERS, Step};
use crate::enclosure::vector::{axes_of, exact};
use crate::mechanism::body_tree::{BodyTree, TreeJoint};
use loosepin_math::{Interval, Pose, Real, Vec3};

/// The position that boxes are about.
pub(crate) struct BoxCentre<'a> {
    pub loops: &'a Loops<'a>,
    drives: Vec<f64>,
    poses: Vec<FixedPose>,
    pub tree: BodyTree,
    /// The centre of each body's step: any point will do, and that of its joint is best.
    centres: Vec<Vec3<Interval>>,
    /// First number of the play of each joint, behind those of the steps.
    plays: Vec<usize>,
}

/// All positions that `numbers` take the bodies to: those of the steps, then the play.
pub(crate) struct PositionBox<'a> {
    pub centre: &'a BoxCentre<'a>,
    pub numbers: &'a [Interval],
    pub is_second_order: bool,
    /// Of the numbers of a joint or an output, that of the further derivative.
    pub direction: Option<usize>,
}

/// A number with its derivatives, and the numbers that these are by.
pub(crate) struct PlacedJet<T = Interval> {
    pub places: Vec<usize>,
    pub jet: Jet<T>,
}

impl<'a> BoxCentre<'a> {
    /// `None` if a body hangs on no other.
    pub(crate) fn new(loops: &'a Loops<'a>, poses: &[Pose], drives: Vec<f64>) -> Option<Self> {
        let fixed = |pose: &Pose| FixedPose { origin: exact(pose.position_m), axes: axes_of(&pose.orientation) };
        let poses: Vec<FixedPose> = poses.iter().map(fixed).collect();
        let tree = BodyTree::of_short_branches(loops.mechanism);
        if tree.unconnected().is_some() {
            return None;
        }
        let centre = |body: usize| {
            let Some(own) = tree.joint_of(body) else { return exact(Vec3::ZERO) };
            let marker = &loops.mechanism.joints()[own.joint].bearing;
            poses[marker.body].point(marker.point_m).map(|place| Interval::from_f64(place.middle()))
        };
        let centres = (0..poses.len()).map(centre).collect();
        let mut next = loops.unknowns();
        let plays = loops.mechanism.joints().iter().map(|joint| {
            let first = next;
            next += joint.play.as_ref().map_or(0, |play| radii_m(play).len());
            first
        });
        Some(Self { plays: plays.collect(), loops, drives, poses, tree, centres })
    }

    /// A body's pose there.
    pub(crate) fn pose(&self, body: usize) -> &FixedPose {
        &self.poses[body]
    }
}

impl PositionBox<'_> {
    /// The numbers of the steps of some bodies.
    fn places(branch: &[TreeJoint]) -> Vec<usize> {
        branch
            .iter()
            .filter_map(|joint| first_column(joint.child))
            .flat_map(|first| first..first + STEP_NUMBERS)
            .collect()
    }

    fn steps<T: Number>(&self, branch: &[TreeJoint], first: usize, variables: Variables) -> Vec<Step<T>> {
        let places = branch.iter().enumerate();
        places
            .filter_map(|(k, joint)| {
                let column = first_column(joint.child)?;
                let own = &self.numbers[column..column + STEP_NUMBERS];
                let centre = self.centre.centres[joint.child];
                Some(Step::new(centre, own, first + STEP_NUMBERS * k, variables, self.centre.loops.length_m))
            })
            .collect()
    }

    /// The steps from the ground to a body, and the numbers that they are by.
    pub(crate) fn branch<T: Number>(&self, body: usize) -> (Vec<usize>, Vec<Step<T>>) {
        let branch = self.centre.tree.branch(body);
        let variables = Variables {
            count: STEP_NUMBERS * branch.len(),
            is_second_order: self.is_second_order,
            direction: self.direction,
        };
        (Self::places(&branch), self.steps(&branch, 0, variables))
    }

    /// A joint, and the numbers that it depends on; without its play where that `is_ideal`.
    pub(crate) fn joint<T: Number>(&self, number: usize, is_ideal: bool) -> (Vec<usize>, EnclosedJoint<T>) {
        let joint = &self.centre.loops.mechanism.joints()[number];
        let pair = [joint.bearing.body, joint.journal.body];
        let branches = self.centre.tree.apart(pair);
        let mut places: Vec<usize> = branches.iter().flat_map(|branch| Self::places(branch)).collect();
        let first_of_play = places.len();
        let play = joint.play.as_ref().filter(|_| !is_ideal);
        if let Some(play) = play {
            let first = self.centre.plays[number];
            places.extend(first..first + radii_m(play).len());
        }
        let variables =
            Variables { count: places.len(), is_second_order: self.is_second_order, direction: self.direction };
        let shift = play.map_or_else(EnclosedShift::none, |play| {
            let ranges = self.numbers.get(self.centre.plays[number]..).unwrap_or_default();
            EnclosedShift::new(play, ranges, first_of_play, variables)
        });
        let steps = [
            self.steps(&branches[0], 0, variables),
            self.steps(&branches[1], STEP_NUMBERS * branches[0].len(), variables),
        ];
        (places, EnclosedJoint::new(joint, pair.map(|body| self.centre.pose(body)), &steps, &shift))
    }

    /// All rows, in their order.
    pub(crate) fn rows(&self) -> Vec<PlacedJet> {
        let mut found: Vec<(usize, PlacedJet)> =
            (0..self.centre.loops.mechanism.joints().len()).flat_map(|joint| self.rows_of(joint)).collect();
        found.sort_by_key(|(number, _)| *number);
        found.into_iter().map(|(_, row)| row).collect()
    }

    /// The rows of a joint, each with its number.
    pub(crate) fn rows_of<T: Number>(&self, joint: usize) -> Vec<(usize, PlacedJet<T>)> {
        let loops = self.centre.loops;
        let (places, at) = self.joint::<T>(joint, false);
        let rows = loops.rows.iter().enumerate().filter(|(_, row)| row.joint == joint);
        rows.map(|(number, row)| {
            let drive = row.drive.and_then(|drive| self.centre.drives.get(drive)).copied().unwrap_or(0.0);
            (number, PlacedJet { places: places.clone(), jet: residual(row.row, &at, drive, loops.length_m) })
        })
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::play_set::PlaySet;
    use crate::kind::row::ScalarRow;
    use crate::kind::{Cylindrical, Revolute, Screw};
    use crate::kind::{CylindricalPlay, RevolutePlay};
    use crate::mechanism::body::Body;
    use crate::mechanism::drive::{Drive, JointCoordinate};
    use crate::mechanism::joint::Joint;
    use crate::mechanism::marker::Marker;
    use crate::mechanism::spatial_mechanism::SpatialMechanism;
    use loosepin_math::Quaternion;

    /// So long that the nut is on the branch of its turn.
    const PITCH_M: f64 = 4.0;

    fn mechanism() -> SpatialMechanism {
        let marker = |body, point: [f64; 3], z: [f64; 3]| Marker::new(body, point.into(), z.into(), Vec3::X).unwrap();
        let pair = |k: f64| {
            [marker(0, [0.1 * k, 0.2, -0.1], [0.3, 1.0, 0.2 * k]), marker(1, [0.2, 0.1, 0.05 * k], [0.2, 1.0, 0.1])]
        };
        let [[a, b], [c, d], [e, f]] = [1.0, 2.0, 3.0].map(pair);
        let revolute = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 1e-3, axial_clearance_m: 2e-3 };
        let cylindrical = CylindricalPlay { bearing_length_m: 0.03, radial_clearance_m: 2e-3 };
        let joints = vec![
            Joint::new("pin", Revolute, a, b).with_play(revolute),
            Joint::new("shaft", Cylindrical, c, d).with_play(cylindrical),
            Joint::new("nut", Screw { pitch_m: PITCH_M }, e, f),
        ];
        let drives = vec![
            Drive { joint: 0, coordinate: JointCoordinate::Angle },
            Drive { joint: 1, coordinate: JointCoordinate::Slide },
        ];
        SpatialMechanism::new(vec![Body::ground(), Body::new("nut", Pose::GROUND)], joints, drives).unwrap()
    }

    #[test]
    fn identity_rows_are_those_of_the_loops() {
        let mechanism = mechanism();
        let loops = Loops::new(&mechanism);
        let set = PlaySet::new(&mechanism);
        let turn = Quaternion::from_rotation_vector(Vec3::new(0.1, -0.3, 0.2));
        let poses = [Pose::GROUND, Pose::new(Vec3::new(0.05, -0.02, 0.1), turn)];
        let drives = vec![0.4, 0.03];
        let places: Vec<f64> = (0..set.variables()).map(|k| 0.9 * (1.0 + k as f64).sin()).collect();
        let frames = loops.frames(&poses, &set.shifts(&mechanism, &set.in_metres(&places)));
        let centre = BoxCentre::new(&loops, &poses, drives.clone()).unwrap();
        let mut numbers = vec![Interval::ZERO; loops.unknowns()];
        numbers.extend(places.iter().map(|place| Interval::from_f64(*place)));
        let at = PositionBox { centre: &centre, numbers: &numbers, is_second_order: false, direction: None };
        // From the centre of the step, the bearing of the pin, to the origin of the body.
        let arm = poses[1].position_m - mechanism.joints()[0].bearing.point_m;
        for ((row, expected), found) in loops.rows.iter().zip(loops.residual(&frames, &drives)).zip(at.rows()) {
            let frame = &frames[row.joint];
            let columns = row.row.columns(frame);
            let (mut value, mut by_step) = (expected, Vec::new());
            let add_columns = |by_step: &mut Vec<f64>, v: Vec3, w: Vec3| {
                by_step.extend(Vec3::AXES.map(|axis| v.dot(axis) * loops.length_m / loops.scale(row)));
                by_step.extend(Vec3::AXES.map(|axis| (w.dot(axis) + v.dot(axis.cross(arm))) / loops.scale(row)));
            };
            match row.row {
                ScalarRow::Coincident(direction) => {
                    let axis = frame.bearing.apply(direction);
                    value = axis.dot(frame.separation) / loops.length_m;
                    add_columns(&mut by_step, axis, frame.arm_j.cross(axis));
                }
                ScalarRow::DrivenAngle | ScalarRow::Helix { .. } => {
                    let [x, y] = [frame.bearing.x, frame.bearing.y].map(|axis| axis.dot(frame.journal.x));
                    let slope = match row.row {
                        ScalarRow::Helix { pitch_m } => -pitch_m / std::f64::consts::TAU / loops.length_m,
                        _ => 1.0,
                    };
                    value = slope * (expected / slope).sin() * x.hypot(y);
                    // More than a quarter of a turn away: nothing is known there.
                    if (expected / slope).cos() <= 0.0 {
                        assert_eq!(found.jet.value, Interval::WHOLE);
                        continue;
                    }
                }
                _ => add_columns(&mut by_step, columns.v_j, columns.w_j),
            }
            let is_near = |found: Interval, expected: f64| {
                (found.middle() - expected).abs() < 1e-14 && found.high() - found.low() < 1e-13
            };
            assert!(is_near(found.jet.value, value), "{row:?} {:?} {value}", found.jet.value);
            for (slope, expected) in found.jet.slopes.iter().zip(&by_step) {
                assert!(is_near(*slope, *expected), "{row:?} {slope:?} {expected}");
            }
        }
    }
}
