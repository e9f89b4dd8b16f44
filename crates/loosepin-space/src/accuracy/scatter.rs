//! What places and directions of markers do to an output: scatter of manufacture.

use crate::accuracy::gains::Gains;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use loosepin_math::{Rotation, Vec3};

/// Gains by the place and the turning of a marker on its body, along its own axes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MarkerGain {
    /// By a displacement of its point.
    pub by_displacement: Vec3,
    /// By a turning about its point; about x and y it tilts the axis of the joint.
    pub by_turning: Vec3,
}

/// Gains by both markers of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarkerGains {
    /// Number of the joint.
    pub joint: usize,
    /// By marker i.
    pub bearing: MarkerGain,
    /// By marker j.
    pub journal: MarkerGain,
}

/// Which marker of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MarkerSide {
    /// Marker i.
    Bearing,
    /// Marker j.
    Journal,
}

/// Standard deviations of a marker's place on its body and of its turning, all independent. A length of a part is the distance of two markers on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarkerScatter {
    /// Number of the joint.
    pub joint: usize,
    /// Which marker.
    pub side: MarkerSide,
    /// Of the place along each of its axes, m.
    pub displacement_m: Vec3,
    /// Of the angles about x and y, by which the axis of the joint tilts, and about z, rad.
    pub turning_rad: Vec3,
}

impl PoseAccuracy<'_> {
    /// Gains by all markers. With redundant rows they hold for changes that leave the loops closed, if any do.
    pub fn marker_gains(&self, gains: &Gains) -> Vec<MarkerGains> {
        let mut all: Vec<MarkerGains> = (0..self.mechanism().joints().len())
            .map(|joint| MarkerGains { joint, bearing: MarkerGain::default(), journal: MarkerGain::default() })
            .collect();
        for (row, weight) in self.loops.rows.iter().zip(&gains.by_rows) {
            let at = &self.frames[row.joint];
            let columns = row.row.columns(at);
            let factor = -weight / self.loops.scale(row);
            // A marker that moves on its body is for its row as if the body moved by δ - θ×ρ and turned by θ.
            let add = |gain: &mut MarkerGain, axes: &Rotation, arm: Vec3, v: Vec3, w: Vec3| {
                gain.by_displacement += axes.apply_transposed(v * factor);
                gain.by_turning += axes.apply_transposed((w - arm.cross(v)) * factor);
            };
            let own = &mut all[row.joint];
            add(&mut own.bearing, &at.bearing, at.arm_i, columns.v_i, columns.w_i);
            add(&mut own.journal, &at.journal, at.arm_j, columns.v_j, columns.w_j);
        }
        all
    }

    /// Standard deviation of an output to first order, m or rad, where markers scatter: √Σ (g σ)². Joints that are not there do not scatter.
    pub fn scatter(&self, gains: &Gains, scatter: &[MarkerScatter]) -> f64 {
        let all = self.marker_gains(gains);
        let part = |gain: Vec3, sigma: Vec3| {
            let products = Vec3::new(gain.x * sigma.x, gain.y * sigma.y, gain.z * sigma.z);
            products.dot(products)
        };
        let own = |scatter: &MarkerScatter| {
            all.get(scatter.joint).map(|gains| match scatter.side {
                MarkerSide::Bearing => gains.bearing,
                MarkerSide::Journal => gains.journal,
            })
        };
        let variance: f64 = scatter
            .iter()
            .filter_map(|scatter| own(scatter).map(|gain| (scatter, gain)))
            .map(|(own, gain)| part(gain.by_displacement, own.displacement_m) + part(gain.by_turning, own.turning_rad))
            .sum();
        variance.sqrt()
    }
}
