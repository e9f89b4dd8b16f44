//! Numbers of outputs that are nothing but round-off.

use loosepin_result::round_off::round_off_si;
use loosepin_result::spatial_motion::SpatialOutputRecord;

/// Puts 0 in the place of values and effects of play that are round-off. Proven ends stay as they are: they are never narrowed.
pub(super) fn drop_round_off(output: &mut SpatialOutputRecord, size_m: f64) {
    let threshold_si = round_off_si(&output.unit, size_m);
    let drop = |number: &mut f64| {
        if number.abs() < threshold_si {
            *number = 0.0;
        }
    };
    let SpatialOutputRecord { ideal_si, first_order_si, standard_deviation_si, worst, worst_regular, .. } = output;
    [ideal_si, first_order_si, standard_deviation_si].into_iter().flatten().for_each(drop);
    for own in [worst].into_iter().chain(worst_regular) {
        drop(&mut own.largest_si);
        drop(&mut own.smallest_si);
        for joint in &mut own.contributors {
            let numbers = [&mut joint.part_si, &mut joint.offset_si].into_iter();
            numbers.chain(&mut joint.lean_si).chain(&mut joint.axial_si).for_each(drop);
        }
    }
}
