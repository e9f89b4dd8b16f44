//! A box of positions about one of them.

use crate::closure::loops::{Loops, first_column};
use crate::enclosure::jet::Jet;
use crate::enclosure::joint::{EnclosedJoint, FixedPose};
use crate::enclosure::moved_body::MovedBody;
use crate::enclosure::row::residual;
use crate::enclosure::shift::EnclosedShift;
use crate::enclosure::vector::{axes_of, exact};
use crate::geometry::pose::Pose;
use loosepin_math::Interval;

/// The position that boxes are about.
pub(crate) struct BoxCentre<'a> {
    pub loops: &'a Loops<'a>,
    drives: Vec<f64>,
    poses: Vec<FixedPose>,
}

impl<'a> BoxCentre<'a> {
    pub(crate) fn new(loops: &'a Loops<'a>, poses: &[Pose], drives: Vec<f64>) -> Self {
        let fixed = |pose: &Pose| FixedPose { origin: exact(pose.position_m), axes: axes_of(&pose.orientation) };
        Self { loops, drives, poses: poses.iter().map(fixed).collect() }
    }

    /// A body's pose there.
    pub(crate) fn pose(&self, body: usize) -> &FixedPose {
        &self.poses[body]
    }
}

/// All positions that `numbers`, as the unknowns of the loops, take the bodies to.
pub(crate) struct PositionBox<'a> {
    pub centre: &'a BoxCentre<'a>,
    pub numbers: &'a [Interval],
}

impl PositionBox<'_> {
    /// A body, its derivatives beginning at `first`.
    pub(crate) fn body<const C: usize>(&self, body: usize, first: usize) -> MovedBody<C> {
        let own = first_column(body).and_then(|column| self.numbers.get(column..column + 6)?.first_chunk::<6>());
        own.map_or_else(MovedBody::held, |own| MovedBody::new(own, first, self.centre.loops.length_m))
    }

    /// A joint; its play lies in `range`, in units of its radii, or does nothing.
    pub(crate) fn joint<const C: usize>(&self, number: usize, range: Option<Interval>) -> EnclosedJoint<C> {
        let joint = &self.centre.loops.mechanism.joints()[number];
        let shift = joint
            .play
            .as_ref()
            .zip(range)
            .map_or_else(EnclosedShift::none, |(play, range)| EnclosedShift::new(play, range));
        let pair = [joint.bearing.body, joint.journal.body];
        let bodies = [self.body(pair[0], 0), self.body(pair[1], crate::enclosure::jet::JOURNAL)];
        EnclosedJoint::new(joint, pair.map(|body| self.centre.pose(body)), &bodies, &shift)
    }

    /// All rows, those of a joint one after the other, each with its number.
    pub(crate) fn rows<const C: usize>(&self, range: Interval) -> Vec<(usize, Jet<C>)> {
        let loops = self.centre.loops;
        let mut found = Vec::with_capacity(loops.rows.len());
        for joint in 0..loops.mechanism.joints().len() {
            let mut at = None;
            for (number, row) in loops.rows.iter().enumerate().filter(|(_, row)| row.joint == joint) {
                let at = at.get_or_insert_with(|| self.joint::<C>(joint, Some(range)));
                let drive = row.drive.and_then(|drive| self.centre.drives.get(drive)).copied().unwrap_or(0.0);
                found.push((number, residual(row.row, at, drive, loops.length_m)));
            }
        }
        found
    }
}
