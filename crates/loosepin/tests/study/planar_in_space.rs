//! Planar templates written in space: pins about z, guides across it. The planar part of the library, which shares nothing with the closure of
//! loops in space, gives the same positions and the same worst cases of play: with journals that do not lean, and in the plane also with those
//! that do.

use loosepin::result::motion::MotionRecord;
use loosepin::result::simulation::{Drawing, DrawnJoint, DrawnJointKind, PointReference};
use loosepin::space::{
    Body, Drive, DriveValue, Joint, JointCoordinate, Marker, PointOutput, Pose, PoseAccuracy, Prismatic, Quaternion,
    Revolute, RevolutePlay, RotationOutput, SpatialMechanism, SpatialOutput, SpatialPlay, UprightPlay, Vec3, cycle,
};
use loosepin::study::InputFile;
use loosepin::templates::{TEMPLATES, Template};
use std::sync::Arc;

const POSITIONS: usize = 72;
const BEARING_LENGTH_M: f64 = 0.02;

/// The mechanism with its bodies where the drawing has them at its first position, and the angle of its driven joint there.
fn in_space(drawing: &Drawing, play: fn(f64) -> SpatialPlay) -> Option<(SpatialMechanism, f64)> {
    let [drive] = &drawing.drives[..] else { return None };
    let poses = &drawing.poses;
    let body = |number: usize| {
        let name = drawing.bodies[number].name.clone();
        if drawing.bodies[number].is_ground {
            return Body::ground();
        }
        let (x, y, angle) = (poses.x_m[number][0], poses.y_m[number][0], poses.angle_rad[number][0]);
        Body::new(
            name,
            Pose { position_m: Vec3::new(x, y, 0.0), orientation: Quaternion::from_rotation_vector(Vec3::Z * angle) },
        )
    };
    let point = |end: PointReference| {
        let point = &drawing.bodies[end.body].points[end.point];
        Vec3::new(point.x_m, point.y_m, 0.0)
    };
    let joint = |joint: &DrawnJoint| -> Option<Joint> {
        let pair = [joint.first, joint.second];
        let made = match joint.kind {
            DrawnJointKind::Revolute | DrawnJointKind::RevoluteWithClearance => {
                let [first, second] = pair.map(|end| Marker::new(end.body, point(end), Vec3::Z, Vec3::X));
                let pin = Joint::new(&joint.name, Revolute, first?, second?);
                if joint.radial_clearance_m > 0.0 { pin.with_play(play(joint.radial_clearance_m)) } else { pin }
            }
            DrawnJointKind::Prismatic if joint.radial_clearance_m == 0.0 => {
                let angle = |end: PointReference| poses.angle_rad[end.body][0];
                let line = |angle: f64| Vec3::new(angle.cos(), angle.sin(), 0.0);
                let first = joint.guide_angle_rad;
                let second = first + angle(pair[0]) - angle(pair[1]);
                let marker = |end: PointReference, own: f64| Marker::new(end.body, point(end), line(own), Vec3::Z);
                let [first, second] = [marker(pair[0], first), marker(pair[1], second)];
                Joint::new(&joint.name, Prismatic, first?, second?)
            }
            _ => return None,
        };
        Some(made)
    };
    let joints = drawing.joints.iter().map(joint).collect::<Option<Vec<Joint>>>()?;
    let driven = &drawing.joints[drive.joint];
    if driven.kind != DrawnJointKind::Revolute {
        return None;
    }
    let start_rad = poses.angle_rad[driven.second.body][0] - poses.angle_rad[driven.first.body][0];
    let drives = vec![Drive { joint: drive.joint, coordinate: JointCoordinate::Angle }];
    let bodies = (0..drawing.bodies.len()).map(body).collect();
    Some((SpatialMechanism::new(bodies, joints, drives).unwrap(), start_rad))
}

/// The output of the same words in space; `None` of one that is no coordinate or angle.
fn output(drawing: &Drawing, words: &str) -> Option<SpatialOutput> {
    let (what, of) = words.split_once(" of ")?;
    let body = |name: &str| drawing.bodies.iter().position(|body| body.name == name);
    let direction = match what {
        "x" => Vec3::X,
        "y" => Vec3::Y,
        "angle" => return Some(RotationOutput { body: body(of)?, axis: Vec3::Z }.into()),
        _ => return None,
    };
    let (name, point) = of.split_once('.')?;
    let body = body(name)?;
    let point = drawing.bodies[body].points.iter().find(|own| own.name == point)?;
    Some(PointOutput { body, point_m: Vec3::new(point.x_m, point.y_m, 0.0), direction }.into())
}

fn planar(template: &Template) -> Option<MotionRecord> {
    let model = loosepin::diagnostics::Source::new("model.toml", template.model);
    let model = loosepin::model::Model::from_source(Arc::clone(&model)).ok()?;
    InputFile::Model(model.into()).ideal_motion(POSITIONS, &[]).ok()
}

/// Largest distance of a point of a body from where it is in the plane, m, and largest difference of a worst case over the larger of its largest
/// value and the clearance.
fn compared(record: &MotionRecord, play: fn(f64) -> SpatialPlay) -> Option<(f64, f64, usize)> {
    let drawing = &record.drawing;
    let (mechanism, start_rad) = in_space(drawing, play)?;
    let turned: Vec<f64> =
        drawing.poses.drive_angle_rad.iter().map(|own| own - drawing.poses.drive_angle_rad[0]).collect();
    let found = cycle(&mechanism, &turned, &|angle| vec![DriveValue::at_rate(start_rad + angle, 1.0)]);
    assert_eq!(found.stopped, None);
    let clearance_m = drawing.joints.iter().map(|joint| joint.radial_clearance_m).fold(0.0, f64::max);
    if clearance_m == 0.0 {
        return None;
    }
    let (mut farthest_m, mut worst, mut outputs) = (0.0_f64, 0.0_f64, 0);
    for (position, closed) in found.positions.iter().enumerate() {
        let poses = &drawing.poses;
        for (number, body) in drawing.bodies.iter().enumerate().skip(1) {
            let (sine, cosine) = poses.angle_rad[number][position].sin_cos();
            for point in &body.points {
                let due = Vec3::new(
                    poses.x_m[number][position] + cosine * point.x_m - sine * point.y_m,
                    poses.y_m[number][position] + sine * point.x_m + cosine * point.y_m,
                    0.0,
                );
                let own = closed.poses[number].point_m(Vec3::new(point.x_m, point.y_m, 0.0));
                farthest_m = farthest_m.max((own - due).length());
            }
        }
        let accuracy = PoseAccuracy::new(&mechanism, closed).unwrap();
        for own in &record.outputs {
            let Some(output) = output(drawing, &own.words) else { continue };
            let due = own.clearance.first_order_si[position];
            let largest = own.clearance.first_order_si.iter().copied().fold(0.0, f64::max);
            let gains = accuracy.gains(&output).unwrap();
            let found = accuracy.first_order(&gains).unwrap().worst;
            // What play does not move has round-off of the size of the clearance.
            worst = worst.max((found - due).abs() / largest.max(clearance_m));
            outputs += usize::from(position == 0);
        }
    }
    Some((farthest_m, worst, outputs))
}

#[test]
fn known_planar_templates_written_in_space_move_and_stray_as_in_the_plane() {
    let upright = |c: f64| UprightPlay { radial_clearance_m: c, axial_clearance_m: 0.0 }.into();
    let leaning = |c: f64| {
        RevolutePlay { radial_clearance_m: c, bearing_length_m: BEARING_LENGTH_M, axial_clearance_m: 0.0 }.into()
    };
    let mut names = Vec::new();
    for template in TEMPLATES {
        let Some(record) = planar(template) else { continue };
        for play in [upright as fn(f64) -> SpatialPlay, leaning] {
            let Some((farthest_m, worst, outputs)) = compared(&record, play) else { continue };
            println!("{}: {farthest_m:e} m, {worst:e}, {outputs} outputs", template.name);
            assert!(farthest_m < 1e-11, "{}: {farthest_m:e} m", template.name);
            assert!(worst < 1e-9, "{}: {worst:e}", template.name);
            names.push(template.name);
        }
    }
    names.dedup();
    assert!(names.len() >= 6, "{names:?}");
}
