//! Effects on outputs that are nothing but round-off.

use loosepin_result::motion::OutputMotion;
use loosepin_result::round_off::{drop_round_off, round_off_si};

/// Puts 0 in the place of effects of play and of dimensions that are round-off.
pub(super) fn drop_round_off_of(outputs: &mut [OutputMotion], size_m: f64) {
    for output in outputs {
        let threshold_si = round_off_si(&output.unit, size_m);
        output.clearance.drop_round_off(threshold_si);
        let of_dimensions = output.dimensional_contributors.iter_mut().map(|own| &mut own.standard_deviation_si);
        let of_scatter = std::iter::once(&mut output.dimensional_standard_deviation_si);
        drop_round_off(of_dimensions.chain(of_scatter).flatten(), threshold_si);
    }
}
