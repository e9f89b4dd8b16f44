//! The equations that hold a mechanism together.

use crate::kind::frames::{JointFrames, MarkerShift};
use crate::kind::row::{RowColumns, ScalarRow};
use crate::mechanism::drive::JointCoordinate;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use loosepin_math::{Frame, Pose, Vec3};

/// A row of the equations, with its joint and, where it is that of a drive, its drive.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PlacedRow {
    pub joint: usize,
    pub drive: Option<usize>,
    pub row: ScalarRow,
}

/// Entries of a row of the Jacobian for both bodies of its joint: the first column of six, and what they are. `None` of the ground.
pub(crate) type RowEntries = [Option<(usize, [f64; 6])>; 2];

/// All rows of a mechanism: those of its joints, then its drives.
#[derive(Debug, Clone)]
pub(crate) struct Loops<'a> {
    pub mechanism: &'a SpatialMechanism,
    pub rows: Vec<PlacedRow>,
    pub length_m: f64,
}

impl<'a> Loops<'a> {
    pub(crate) fn new(mechanism: &'a SpatialMechanism) -> Self {
        let of_joint = |(joint, kind): (usize, &crate::mechanism::joint::Joint)| {
            let scalars = kind.kind.rows().into_iter().flat_map(|row| row.scalars());
            scalars.map(move |row| PlacedRow { joint, drive: None, row }).collect::<Vec<_>>()
        };
        let mut rows: Vec<PlacedRow> = mechanism.joints().iter().enumerate().flat_map(of_joint).collect();
        rows.extend(mechanism.drives().iter().enumerate().map(|(number, drive)| PlacedRow {
            joint: drive.joint,
            drive: Some(number),
            row: match drive.coordinate {
                JointCoordinate::Angle => ScalarRow::DrivenAngle,
                JointCoordinate::Slide => ScalarRow::DrivenSlide,
            },
        }));
        Self { mechanism, rows, length_m: mechanism.characteristic_length_m() }
    }

    /// Number of unknowns.
    pub(crate) fn unknowns(&self) -> usize {
        6 * (self.mechanism.bodies().len() - 1)
    }

    /// Number of rows that are not those of drives: they come first.
    pub(crate) fn joint_rows(&self) -> usize {
        self.rows.len() - self.mechanism.drives().len()
    }

    /// What a row's residual is divided by.
    pub(crate) fn scale(&self, row: &PlacedRow) -> f64 {
        if row.row.is_length() { self.length_m } else { 1.0 }
    }

    /// All joints in ground axes; `shifts` has an entry for each joint, or none at all for ideal joints.
    pub(crate) fn frames(&self, poses: &[Pose], shifts: &[MarkerShift]) -> Vec<JointFrames> {
        let (mut bodies, mut frames) = (Vec::new(), Vec::new());
        self.frames_into(poses, shifts, &mut bodies, &mut frames);
        frames
    }

    /// The same without new memory; `bodies` is room for their axes.
    pub(crate) fn frames_into(
        &self,
        poses: &[Pose],
        shifts: &[MarkerShift],
        bodies: &mut Vec<Frame>,
        frames: &mut Vec<JointFrames>,
    ) {
        bodies.clear();
        bodies.extend(poses.iter().map(Frame::from));
        frames.clear();
        frames.extend(self.mechanism.joints().iter().enumerate().map(|(number, joint)| {
            let markers = [&joint.bearing, &joint.journal];
            let shift = shifts.get(number).copied().unwrap_or_default();
            JointFrames::new(
                markers.map(|marker| &bodies[marker.body]),
                markers.map(|marker| marker.point_m),
                markers.map(|marker| &marker.axes),
                &shift,
            )
        }));
    }

    /// Residuals of all rows, lengths over L.
    pub(crate) fn residual(&self, frames: &[JointFrames], drives: &[f64]) -> Vec<f64> {
        self.residuals(frames, drives).collect()
    }

    /// The same one by one.
    pub(crate) fn residuals<'b>(
        &'b self,
        frames: &'b [JointFrames],
        drives: &'b [f64],
    ) -> impl Iterator<Item = f64> + 'b {
        let rows = self.rows.iter();
        rows.map(|row| {
            let drive = row.drive.and_then(|drive| drives.get(drive)).copied().unwrap_or(0.0);
            row.row.residual(&frames[row.joint], drive) / self.scale(row)
        })
    }

    /// The Jacobian, row by row, over the scaled unknowns.
    pub(crate) fn jacobian(&self, frames: &[JointFrames]) -> Vec<f64> {
        let columns = self.unknowns();
        let mut matrix = vec![0.0; self.rows.len() * columns];
        for (row, entries) in self.rows.iter().zip(matrix.chunks_mut(columns.max(1))) {
            for (first, values) in self.row_entries(row, frames).into_iter().flatten() {
                entries[first..first + 6].iter_mut().zip(values).for_each(|(entry, value)| *entry += value);
            }
        }
        matrix
    }

    /// The entries of a row of the Jacobian.
    pub(crate) fn row_entries(&self, row: &PlacedRow, frames: &[JointFrames]) -> RowEntries {
        let RowColumns { v_i, w_i, v_j, w_j } = row.row.columns(&frames[row.joint]);
        let joint = &self.mechanism.joints()[row.joint];
        let scale = 1.0 / self.scale(row);
        [(joint.bearing.body, v_i, w_i), (joint.journal.body, v_j, w_j)].map(|(body, v, w)| {
            let [v, w] = [v * (self.length_m * scale), w * scale];
            first_column(body).map(|first| (first, [v.x, v.y, v.z, w.x, w.y, w.z]))
        })
    }

    /// yᵀJ of a combination y of the rows.
    pub(crate) fn combined(&self, frames: &[JointFrames], combination: &[f64]) -> Vec<f64> {
        let mut combined = vec![0.0; self.unknowns()];
        for (row, share) in self.rows.iter().zip(combination) {
            for (first, values) in self.row_entries(row, frames).into_iter().flatten() {
                combined[first..first + 6].iter_mut().zip(values).for_each(|(sum, value)| *sum += share * value);
            }
        }
        combined
    }

    /// A gradient by (v, ω) of one body, over the scaled unknowns.
    pub(crate) fn add_gradient(&self, gradient: &mut [f64], body: usize, by_v: Vec3, by_w: Vec3) {
        let Some(first) = first_column(body) else { return };
        let values = [by_v * self.length_m, by_w].into_iter().flat_map(Vec3::to_array);
        gradient[first..first + 6].iter_mut().zip(values).for_each(|(entry, value)| *entry += value);
    }

    /// The velocity and the turning of a body in a vector of scaled unknowns, SI.
    pub(crate) fn velocities(&self, unknowns: &[f64], body: usize) -> (Vec3, Vec3) {
        let Some(first) = first_column(body) else { return (Vec3::ZERO, Vec3::ZERO) };
        let part = |k: usize| Vec3::new(unknowns[first + k], unknowns[first + k + 1], unknowns[first + k + 2]);
        (part(0) * self.length_m, part(3))
    }

    /// Poses moved by a vector of scaled unknowns.
    pub(crate) fn moved(&self, poses: &[Pose], unknowns: &[f64]) -> Vec<Pose> {
        let mut poses = poses.to_vec();
        self.move_poses(&mut poses, unknowns);
        poses
    }

    /// Moves poses by a vector of scaled unknowns.
    pub(crate) fn move_poses(&self, poses: &mut [Pose], unknowns: &[f64]) {
        for (body, pose) in poses.iter_mut().enumerate().skip(1) {
            let (displacement_m, rotation_rad) = self.velocities(unknowns, body);
            *pose = pose.moved(displacement_m, rotation_rad);
        }
    }

    /// The coordinates of all drives as they are in these frames.
    pub(crate) fn driven_coordinates(&self, frames: &[JointFrames]) -> Vec<f64> {
        let drives = self.mechanism.drives().iter();
        drives.map(|drive| coordinate(drive.coordinate, &frames[drive.joint])).collect()
    }

    /// The joint whose bodies move most against each other where all bodies move by `unknowns`.
    pub(crate) fn most_moving_joint(&self, frames: &[JointFrames], unknowns: &[f64]) -> usize {
        let motion = |number: usize| {
            let (joint, at) = (&self.mechanism.joints()[number], &frames[number]);
            let (v_i, w_i) = self.velocities(unknowns, joint.bearing.body);
            let (v_j, w_j) = self.velocities(unknowns, joint.journal.body);
            let apart = (v_j + w_j.cross(at.arm_j) - v_i - w_i.cross(at.arm_i)) / self.length_m;
            let turning = w_j - w_i;
            apart.dot(apart) + turning.dot(turning)
        };
        let joints = 0..self.mechanism.joints().len();
        joints.max_by(|&a, &b| motion(a).total_cmp(&motion(b))).unwrap_or(0)
    }
}

/// A coordinate of a joint.
pub(crate) fn coordinate(coordinate: JointCoordinate, at: &JointFrames) -> f64 {
    match coordinate {
        JointCoordinate::Angle => at.angle_rad(),
        JointCoordinate::Slide => at.slide_m(),
    }
}

/// The first column of a body; `None` for the ground.
pub(crate) fn first_column(body: usize) -> Option<usize> {
    body.checked_sub(1).map(|moving| 6 * moving)
}
