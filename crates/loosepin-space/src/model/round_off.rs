//! Numbers of outputs that are nothing but round-off.

use loosepin_result::motion::OutputMotion;
use loosepin_result::point_path::PointPath;
use loosepin_result::round_off::{drop_round_off, round_off_si};
use loosepin_text::units::SiUnit;

/// Puts 0 in the place of values and effects of play that are round-off.
pub(super) fn drop_round_off_of_output(output: &mut OutputMotion, size_m: f64) {
    let threshold_si = round_off_si(&output.unit, size_m);
    drop_round_off(&mut output.value_si, threshold_si);
    output.clearance.drop_round_off(threshold_si);
}

/// The same of a path: of its positions and of what play does to them.
pub(super) fn drop_round_off_of_path(path: &mut PointPath, size_m: f64) {
    let positions = [&mut path.x_m, &mut path.y_m, &mut path.z_m];
    let reaches = [&mut path.play_along_m, &mut path.play_across_m, &mut path.play_longest_m];
    drop_round_off(positions.into_iter().chain(reaches).flatten(), round_off_si(&SiUnit::LENGTH, size_m));
}
