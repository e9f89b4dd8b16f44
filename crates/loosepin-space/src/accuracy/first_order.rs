//! The worst case of first order.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::gains::Gains;
use crate::accuracy::linear::slice::{Largest, largest};
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::pose_accuracy::PoseAccuracy;

/// The largest g·p over all plays that close the loops to first order; by symmetry -g·p is as large.
///
/// Without redundant rows, with u1 and u2 in both end planes (g_1 = g_e/2 - g_w/l, g_2 = g_e/2 + g_w/l):
///
/// ```text
/// Σ revolute c (|g_1| + |g_2|) + c_a |g_α|  +  Σ cylindrical c (|g_1| + |g_2|)  +  Σ spherical c |g|
/// ```
///
/// With them the plays also satisfy h·p = 0, and the worst case is the smallest of these sums with g + λ·h in place of g: any λ gives an
/// upper bound, and the place is where it is reached.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstOrder {
    /// The worst case, m or rad: the sum with the multipliers below.
    pub worst: f64,
    /// g·p at the place below, m or rad; it is as large but for round-off.
    pub reached: f64,
    /// Variables of play at the largest value, m, the tangent of a lean without a unit; their negatives give the smallest.
    pub variables_m: Vec<f64>,
    /// λ of each redundant row, in the scale of the loop equations (lengths over the characteristic length).
    pub multipliers: Vec<f64>,
    /// The part of each joint in the worst case.
    pub by_joint: Vec<f64>,
}

impl PoseAccuracy<'_> {
    /// The worst case of first order of an output.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::NoPlace`] if the search for the multipliers does not come to an end, [`AccuracyError::PartsDoNotFit`] if the loops close
    /// by play alone, so that nothing is symmetric.
    pub fn first_order(&self, gains: &Gains) -> Result<FirstOrder, AccuracyError> {
        if self.is_open() {
            return Err(AccuracyError::PartsDoNotFit);
        }
        let scaled = self.scaled_gains(gains);
        let Largest { place, multipliers, rest } =
            largest(&self.set, &scaled, None, &self.planes, &vec![0.0; self.redundant.len()])
                .ok_or(AccuracyError::NoPlace)?;
        let parts = self.set.support(&rest);
        let mut by_joint = vec![0.0; self.mechanism().joints().len()];
        for (block, part) in self.set.blocks().iter().zip(&parts) {
            by_joint[block.joint] += part;
        }
        Ok(FirstOrder {
            worst: parts.iter().sum(),
            reached: dot(&scaled, &place),
            variables_m: self.set.in_metres(&place),
            multipliers: multipliers.iter().map(|value| -value).collect(),
            by_joint,
        })
    }

    /// The sum of all joints as if the plays did not have to close redundant rows: an upper bound that may be far too large.
    pub fn unconditioned_worst(&self, gains: &Gains) -> f64 {
        self.set.support(&self.scaled_gains(gains)).iter().sum()
    }

    /// Gains by the variables in units of their radii.
    pub(crate) fn scaled_gains(&self, gains: &Gains) -> Vec<f64> {
        gains.by_play.iter().zip(&self.plays.radii_m).map(|(gain, radius)| gain * radius).collect()
    }
}
