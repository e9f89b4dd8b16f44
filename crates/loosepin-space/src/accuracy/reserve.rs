//! Whether plays are large enough for errors of manufacture.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::multiple::largest_multiple;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::accuracy::scatter::MarkerSide;
use loosepin_math::{Rotation, Vec3};

/// A marker that is not where it should be on its body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarkerError {
    /// Number of the joint.
    pub joint: usize,
    /// Which marker.
    pub side: MarkerSide,
    /// Displacement of its point along its axes, m.
    pub displacement_m: Vec3,
    /// Turning about its point, along its axes, rad.
    pub turning_rad: Vec3,
}

/// How far plays are from the least with which a mechanism can be put together.
#[derive(Debug, Clone, PartialEq)]
pub struct AssemblyReserve {
    /// By how much the errors could be multiplied, or all plays divided, until the mechanism could no more be put together; at most 1e6. Below
    /// 1 it cannot be put together.
    pub factor: f64,
    /// The same from the multipliers: the smallest worst case of λ·h over all λ with λ·h0 = 1. Equal to `factor` but for round-off.
    pub bound: f64,
    /// Places of the journals with the errors multiplied by the factor, m.
    pub variables_m: Vec<f64>,
}

impl PoseAccuracy<'_> {
    /// Whether the mechanism can be put together in this position though its markers have these errors, to first order: whether plays with
    /// h·p = h0 are admissible. They are if and only if λ·h0 is at most the worst case of λ·h for every λ (separation of convex sets).
    ///
    /// Found as the largest factor θ with h·p = θ h0: both sides, the place and the multipliers, are computed.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::NoPlace`] if the errors break a redundant row that no play reaches, so that no play helps;
    /// [`AccuracyError::BadMarkerError`].
    pub fn assembly_reserve(&self, errors: &[MarkerError]) -> Result<AssemblyReserve, AccuracyError> {
        let is_good = |error: &MarkerError| {
            let is_finite = error.displacement_m.is_finite() && error.turning_rad.is_finite();
            is_finite && error.joint < self.mechanism().joints().len()
        };
        if !errors.iter().all(is_good) {
            return Err(AccuracyError::BadMarkerError);
        }
        let change = self.changes(errors);
        let right: Vec<f64> = self.system.redundant_rows().iter().map(|row| dot(row, &change)).collect();
        self.reserve_of(&right)
    }

    /// The largest θ for which plays with h·p = θ h0 are admissible; `right` is h0 of each redundant row.
    pub(crate) fn reserve_of(&self, right: &[f64]) -> Result<AssemblyReserve, AccuracyError> {
        let found = largest_multiple(&self.set, &self.redundant, right, 0.0).ok_or(AccuracyError::NoPlace)?;
        let variables_m = self.set.in_metres(&found.place);
        Ok(AssemblyReserve { factor: found.factor, bound: found.bound, variables_m })
    }

    /// Changes of all rows by errors of markers, lengths over L.
    fn changes(&self, errors: &[MarkerError]) -> Vec<f64> {
        let mut changes = vec![0.0; self.loops.rows.len()];
        for (row, change) in self.loops.rows.iter().zip(&mut changes) {
            let at = &self.frames[row.joint];
            let columns = row.row.columns(at);
            for error in errors.iter().filter(|error| error.joint == row.joint) {
                let (axes, arm, v, w): (&Rotation, Vec3, Vec3, Vec3) = match error.side {
                    MarkerSide::Bearing => (&at.bearing, at.arm_i, columns.v_i, columns.w_i),
                    MarkerSide::Journal => (&at.journal, at.arm_j, columns.v_j, columns.w_j),
                };
                let displacement = axes.apply(error.displacement_m);
                let turning = axes.apply(error.turning_rad);
                *change += (v.dot(displacement) + (w - arm.cross(v)).dot(turning)) / self.loops.scale(row);
            }
        }
        changes
    }
}
