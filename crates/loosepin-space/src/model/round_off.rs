//! Numbers of outputs that are nothing but round-off.

use loosepin_result::motion::OutputMotion;
use loosepin_result::point_path::PointPath;
use loosepin_result::round_off::round_off_si;
use loosepin_text::units::SiUnit;

/// Puts 0 in the place of values and effects of play that are round-off. Proven ends stay as they are: they are never narrowed.
pub(super) fn drop_round_off(output: &mut OutputMotion, size_m: f64) {
    let threshold_si = round_off_si(&output.unit, size_m);
    let drop = |number: &mut f64| {
        if number.abs() < threshold_si {
            *number = 0.0;
        }
    };
    let answer = &mut output.clearance;
    let histories = [&mut output.value_si, &mut answer.first_order_si, &mut answer.disc_standard_deviation_si];
    histories.into_iter().flatten().for_each(drop);
    answer.searched.iter_mut().flat_map(|searched| &mut searched.found_si).for_each(drop);
    for joint in &mut answer.contributors {
        let effects = [&mut joint.first_order_si, &mut joint.offset_si, &mut joint.lean_si, &mut joint.axial_si];
        effects.into_iter().flatten().for_each(drop);
    }
}

/// The same of a path: of its positions and of what play does to them.
pub(super) fn drop_round_off_of_path(path: &mut PointPath, size_m: f64) {
    let threshold_m = round_off_si(&SiUnit::LENGTH, size_m);
    let positions = [&mut path.x_m, &mut path.y_m, &mut path.z_m];
    let reaches = [&mut path.play_along_m, &mut path.play_across_m, &mut path.play_longest_m];
    for number in positions.into_iter().chain(reaches).flatten().filter(|number| number.abs() < threshold_m) {
        *number = 0.0;
    }
}
