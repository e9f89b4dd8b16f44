//! Zones about paths as numbers, for a page that draws them itself while a mechanism is edited.

use serde::Serialize;

use crate::mechanism::figure::pose_step;
use crate::mechanism::shapes::MM_PER_M;
use loosepin_result::motion::MotionRecord;
use loosepin_result::point_path::{PointPath, REACH_DIRECTIONS};

/// Digits of the largest reach; smaller ones have its decimals.
const REACH_DIGITS: i32 = 5;
/// Steps of the angle of an ellipse in a degree.
const STEPS_PER_DEGREE: f64 = 100.0;

/// The path of a point and the zone about it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LivePath {
    /// The output that is this path, if any.
    pub output: Option<String>,
    /// The point: `coupler.tip`.
    pub point: String,
    /// Reach of the play, mm: 16 numbers for each pose of the drawing, for the directions 0°, 11.25°, ... 168.75° from the x axis. Empty if
    /// play does not move the point.
    pub play_reach_mm: Vec<f64>,
    /// The 95 % ellipse of the scatter at each pose: larger and smaller semi-axis, mm, and the angle of the larger one from the x axis,
    /// degrees. Empty if nothing scatters.
    pub scatter: Vec<[f64; 3]>,
}

/// All paths of a record in the plane. The words of a path relative to another point name no point of the drawing, which therefore shows no zone of it.
pub fn live_paths(record: &MotionRecord) -> Vec<LivePath> {
    let step = pose_step(record.drive_angle_rad.len());
    record
        .paths
        .iter()
        .filter(|path| path.is_complete() && !path.is_in_space())
        .map(|path| live_path(path, step))
        .collect()
}

fn live_path(path: &PointPath, step: usize) -> LivePath {
    let reaches_m = || path.play_reach_m.iter().chain(&path.scatter_major_m).copied();
    let largest_mm = MM_PER_M * reaches_m().fold(0.0, f64::max);
    let is_known = reaches_m().all(f64::is_finite) && largest_mm > 0.0;
    let per_mm = 10_f64.powi(REACH_DIGITS - 1 - largest_mm.max(f64::MIN_POSITIVE).log10().floor() as i32);
    let rounded = |value_m: f64| (value_m * MM_PER_M * per_mm).round() / per_mm;
    let has_play = is_known && path.has_play();
    let has_scatter = is_known && path.has_scatter();
    let poses = || (0..path.positions()).step_by(step);
    let plays = poses().flat_map(|k| &path.play_reach_m[k * REACH_DIRECTIONS..][..REACH_DIRECTIONS]);
    let ellipse = |k: usize| {
        let turn_deg = (path.scatter_angle_rad[k].to_degrees() * STEPS_PER_DEGREE).round() / STEPS_PER_DEGREE;
        [rounded(path.scatter_major_m[k]), rounded(path.scatter_minor_m[k]), turn_deg]
    };
    LivePath {
        output: path.output.clone(),
        point: path.point.clone(),
        play_reach_mm: if has_play { plays.map(|reach_m| rounded(*reach_m)).collect() } else { Vec::new() },
        scatter: if has_scatter { poses().map(ellipse).collect() } else { Vec::new() },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_reaches(play_m: f64, scatter_m: Option<[f64; 2]>) -> PointPath {
        let axis = |which: usize| scatter_m.map(|axes_m| vec![axes_m[which]; 2]).unwrap_or_default();
        PointPath {
            point: "coupler.tip".to_owned(),
            x_m: vec![0.1, 0.2],
            y_m: vec![0.3, 0.3],
            tangent_x: vec![1.0; 2],
            tangent_y: vec![0.0; 2],
            play_reach_m: vec![play_m; 2 * REACH_DIRECTIONS],
            play_along_m: vec![play_m; 2],
            play_across_m: vec![play_m; 2],
            scatter_major_m: axis(0),
            scatter_minor_m: axis(1),
            scatter_angle_rad: axis(0).iter().map(|_| std::f64::consts::FRAC_PI_4).collect(),
            ..PointPath::default()
        }
    }

    #[test]
    fn analytic_reaches_are_in_millimetres_with_five_digits() {
        let path = live_path(&of_reaches(1.234_567_8e-4, Some([2e-5, 1e-5])), 1);
        assert_eq!(path.play_reach_mm, [0.123_46; 2 * REACH_DIRECTIONS]);
        assert_eq!(path.scatter, [[0.02, 0.01, 45.0]; 2]);
        assert_eq!(live_path(&of_reaches(1e-4, None), 2).play_reach_mm, [0.1; REACH_DIRECTIONS]);
    }

    #[test]
    fn what_nothing_moves_has_no_zone() {
        let still = live_path(&of_reaches(0.0, Some([0.0; 2])), 1);
        assert!(still.play_reach_mm.is_empty() && still.scatter.is_empty());
        let unknown = live_path(&of_reaches(f64::NAN, None), 1);
        assert!(unknown.play_reach_mm.is_empty());
    }
}
