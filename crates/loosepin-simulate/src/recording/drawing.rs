//! Points, joints and poses of a mechanism, for drawings.

use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{
    BeamGeometry, Drives, Kinematics, Mechanism, Sample, Tree, TreeBeam, TreeNodalBeam,
};
use loosepin_mechanics::model::{Drive, DriveId, Joint, Model, Output, PointId, Values};
use loosepin_result::simulation::{
    Drawing, DrawnBeam, DrawnBody, DrawnDrive, DrawnJoint, DrawnJointKind, DrawnOutput, DrawnPoint, DriveSense,
    PointReference, PoseTable,
};

/// Instants of a cycle at which a drive is asked which way it goes.
const SENSE_LOOKS: u32 = 64;

/// Places along a flexible body at which its deflection is drawn.
const BEAM_PLACES: usize = 25;

/// Bodies, points, joints and drives of `model`: what is drawn of it before it is known to move. The poses are still empty, and drives stand still.
pub fn parts(model: &Model, values: &Values) -> Drawing {
    let bodies = model.bodies.iter().enumerate().map(|(index, body)| DrawnBody {
        name: body.name.clone(),
        is_ground: index == 0,
        points: body
            .points
            .iter()
            .map(|point| DrawnPoint {
                name: point.name.clone(),
                x_m: values[point.position_m[0]],
                y_m: values[point.position_m[1]],
            })
            .collect(),
    });
    let still = |drive: &Drive| DrawnDrive { name: drive.name.clone(), joint: drive.joint.0, sense: DriveSense::Still };
    let output =
        |output: &Output| Some(DrawnOutput { name: output.name.clone(), point: reference(output.kind.drawn_point()?) });
    Drawing {
        bodies: bodies.collect(),
        joints: model.joints.iter().map(|joint| drawn_joint(joint, values)).collect(),
        drives: model.drives.iter().map(still).collect(),
        output_points: model.outputs.iter().filter_map(output).collect(),
        poses: PoseTable::default(),
        ideal_poses: PoseTable::default(),
        beams: Vec::new(),
    }
}

/// [`parts`] of a mechanism that moves, with the way that its drives go and its flexible bodies.
pub fn skeleton(mechanism: &Mechanism, values: &Values) -> Drawing {
    let mut drawing = parts(&mechanism.model, values);
    let senses = drive_senses(&mechanism.model, values);
    drawing.drives.iter_mut().zip(senses).for_each(|(drive, sense)| drive.sense = sense);
    drawing.poses = empty_poses(mechanism);
    drawing.ideal_poses = empty_poses(mechanism);
    drawing.beams = beams(mechanism, values);
    drawing
}

/// Flexible bodies, still without the coordinates of their shapes.
fn beams(mechanism: &Mechanism, values: &Values) -> Vec<DrawnBeam> {
    let Ok(sample) = Sample::<f64>::new(mechanism, values) else { return Vec::new() };
    let drawn = |(index, (place, numbers)): (usize, (&TreeBeam, &BeamGeometry<f64>))| {
        let mut deflections_m = place.lateral_shapes(BEAM_PLACES);
        deflections_m.iter_mut().flatten().for_each(|deflection| *deflection *= numbers.beam.length_m);
        let [axial_hz, lateral_hz] = match place.has_lumps {
            true => sample.real.held_beam(&mechanism.real, index).frequencies_hz(),
            false => numbers.beam.frequencies_hz(&place.shapes),
        };
        let turns_rad = vec![Vec::new(); place.shapes.lateral()];
        DrawnBeam {
            body: place.body.0,
            ends: place.points(),
            deflections_m,
            turns_rad,
            lateral_hz,
            axial_hz,
            axis_x_m: Vec::new(),
            axis_y_m: Vec::new(),
        }
    };
    let nodal = |place: &TreeNodalBeam| DrawnBeam {
        body: place.body.0,
        ends: place.points(),
        deflections_m: Vec::new(),
        turns_rad: Vec::new(),
        lateral_hz: Vec::new(),
        axial_hz: Vec::new(),
        axis_x_m: vec![Vec::new(); BEAM_PLACES],
        axis_y_m: vec![Vec::new(); BEAM_PLACES],
    };
    let floating = mechanism.real.beams.iter().zip(&sample.real.beams).enumerate().map(drawn);
    floating.chain(mechanism.real.nodal_beams.iter().map(nodal)).collect()
}

/// Adds how all flexible bodies of `mechanism` bend at present, behind [`add_pose`]: coordinates of lateral shapes; of bodies in absolute
/// nodal coordinates their axes, in a frame through both ends, in which such a body is drawn.
pub fn add_bending(drawing: &mut Drawing, mechanism: &Mechanism, dynamics: &Dynamics<'_, f64>) {
    let coordinates = dynamics.free_state().0;
    let floating = mechanism.real.beams.len();
    for (index, (drawn, place)) in drawing.beams.iter_mut().skip(floating).zip(&mechanism.real.nodal_beams).enumerate()
    {
        let frame = dynamics.nodal_secant(index);
        let body = place.body.0;
        let poses = &mut drawing.poses;
        for (list, value) in [
            (&mut poses.x_m[body], frame.position_m.x),
            (&mut poses.y_m[body], frame.position_m.y),
            (&mut poses.angle_rad[body], frame.angle_rad()),
        ] {
            list.last_mut().into_iter().for_each(|last| *last = value);
        }
        let axis = dynamics.nodal_axis_m(index, BEAM_PLACES);
        for ((x_m, y_m), point_m) in drawn.axis_x_m.iter_mut().zip(&mut drawn.axis_y_m).zip(axis) {
            let own_m = frame.turn_back(point_m - frame.position_m);
            x_m.push(own_m.x);
            y_m.push(own_m.y);
        }
    }
    for (drawn, place) in drawing.beams.iter_mut().zip(&mechanism.real.beams) {
        let lateral = &coordinates[place.axial().end..place.coordinates.end];
        drawn.turns_rad.iter_mut().zip(lateral).for_each(|(turns_rad, turn_rad)| turns_rad.push(*turn_rad));
    }
}

fn reference(point: PointId) -> PointReference {
    PointReference { body: point.body.0, point: point.point }
}

fn drive_senses(model: &Model, values: &Values) -> Vec<DriveSense> {
    let turn_s = model.cycle_input(values).turn_s();
    // A cycle that stands still has no end: the drives are then asked at its start.
    let end_s = if turn_s.is_finite() { turn_s } else { 0.0 };
    let mut motions = Drives::new(model, values);
    let mut speeds = vec![Vec::new(); model.drives.len()];
    for look in 0..=SENSE_LOOKS {
        let time_s = end_s * f64::from(look) / f64::from(SENSE_LOOKS);
        motions.take_pieces_at(time_s);
        for (index, speeds) in speeds.iter_mut().enumerate() {
            speeds.push(motions.at(model, DriveId(index), time_s)[1]);
        }
    }
    speeds.iter().map(|speeds| sense(speeds)).collect()
}

/// Which way a drive with these speeds goes; what is a billionth of the largest is round-off.
fn sense(speeds: &[f64]) -> DriveSense {
    let least = 1e-9 * speeds.iter().fold(0.0_f64, |largest, speed| largest.max(speed.abs()));
    match (speeds.iter().any(|speed| *speed > least), speeds.iter().any(|speed| *speed < -least)) {
        (true, true) => DriveSense::ToAndFro,
        (true, false) => DriveSense::Forward,
        (false, true) => DriveSense::Backward,
        (false, false) => DriveSense::Still,
    }
}

fn empty_poses(mechanism: &Mechanism) -> PoseTable {
    let bodies = mechanism.model.bodies.len();
    PoseTable {
        drive_angle_rad: Vec::new(),
        x_m: vec![Vec::new(); bodies],
        y_m: vec![Vec::new(); bodies],
        angle_rad: vec![Vec::new(); bodies],
    }
}

/// Adds the present poses of all bodies.
pub fn add_pose(poses: &mut PoseTable, tree: &Tree, kinematics: &Kinematics<f64>, drive_angle_rad: f64) {
    poses.drive_angle_rad.push(drive_angle_rad);
    for (body, &slot) in tree.slot_of_body.iter().enumerate() {
        let pose = &kinematics.poses[slot];
        poses.x_m[body].push(pose.position_m.x);
        poses.y_m[body].push(pose.position_m.y);
        poses.angle_rad[body].push(pose.angle_rad());
    }
}

/// A joint as it is drawn between its two points.
fn drawn_joint(joint: &Joint, values: &Values) -> DrawnJoint {
    let [first, second] = joint.kind.points().map(reference);
    // Only in a hole does the clearance leave room to draw it in.
    let radial_clearance_m = joint.kind.pin_clearance().map_or(0.0, |pin| values[pin.radial_clearance_m]);
    let guide_angle_rad = joint.kind.line().map_or(0.0, |line| values[line.angle_rad]);
    let kind = DrawnJointKind::of(joint.kind.word(), radial_clearance_m > 0.0);
    DrawnJoint { name: joint.name.clone(), kind, first, second, guide_angle_rad, radial_clearance_m }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_sense_of_a_drive_is_that_of_its_speeds() {
        assert_eq!(sense(&[0.0, 2.0, 3.0]), DriveSense::Forward);
        assert_eq!(sense(&[-2.0, 1e-12]), DriveSense::Backward);
        assert_eq!(sense(&[-2.0, 0.0, 1.0]), DriveSense::ToAndFro);
        assert_eq!(sense(&[0.0, f64::NAN]), DriveSense::Still);
    }
}
