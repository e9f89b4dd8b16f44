//! Effects on outputs that are nothing but round-off.

use loosepin_result::motion::OutputMotion;
use loosepin_result::round_off::round_off_si;

/// Puts 0 in the place of effects of play and of dimensions that are round-off. Proven ends stay as they are: they are never narrowed.
pub(super) fn drop_round_off(outputs: &mut [OutputMotion], size_m: f64) {
    for output in outputs {
        let threshold_si = round_off_si(&output.unit, size_m);
        let answer = &mut output.clearance;
        let of_play = [
            &mut answer.first_order_si,
            &mut answer.worst_case_si,
            &mut answer.lowest_si,
            &mut answer.highest_si,
            &mut answer.disc_standard_deviation_si,
            &mut answer.rim_standard_deviation_si,
        ];
        let of_joints = answer.contributors.iter_mut().map(|joint| &mut joint.first_order_si);
        let of_dimensions = output.dimensional_contributors.iter_mut().map(|own| &mut own.standard_deviation_si);
        let of_scatter = std::iter::once(&mut output.dimensional_standard_deviation_si);
        for effects in of_play.into_iter().chain(of_joints).chain(of_dimensions).chain(of_scatter) {
            effects.iter_mut().filter(|effect| effect.abs() < threshold_si).for_each(|effect| *effect = 0.0);
        }
        answer.witness.take_if(|witness| witness.deviation_si.abs() < threshold_si);
    }
}
