//! The same band of an output of a mechanism in space.

use super::live_band::{BandSource, LiveBand, LiveLimit, Part, PartKind, PlacedParts, dimension_parts, widest_place};
use crate::charts::figure::name_of;
use crate::motion::spatial::{motion_chart, sorted, within_turn};
use crate::numbers::number::NumberWriter;
use crate::words::wording::named_words;
use loosepin_result::spatial_motion::{SpatialMotionRecord, SpatialOutputRecord};
use loosepin_text::units::DisplayUnits;

/// The bands of all outputs that have one, each with its limits; empty where nothing has play and nothing scatters.
pub fn live_spatial_bands(record: &SpatialMotionRecord, limits: &[LiveLimit]) -> Vec<LiveBand> {
    let units = DisplayUnits::default();
    let writer = NumberWriter::for_page(&units);
    let limits_of = |output: &SpatialOutputRecord| -> Vec<f64> {
        let name = banded_name(output);
        limits.iter().filter(|limit| limit.output == name).map(|limit| limit.within_si).collect()
    };
    record.outputs.iter().filter_map(|output| band(record, output, &limits_of(output), &writer)).collect()
}

/// The number whose band it is, as studies call it: of a path the magnitude of its displacement.
fn banded_name(output: &SpatialOutputRecord) -> String {
    // A displacement has no ideal value.
    if output.ideal_si.is_empty() { format!("{} magnitude", output.name) } else { output.name.clone() }
}

fn band(
    record: &SpatialMotionRecord,
    output: &SpatialOutputRecord,
    limits_si: &[f64],
    writer: &NumberWriter,
) -> Option<LiveBand> {
    let name = banded_name(output);
    let source = BandSource {
        name: &name,
        words: named_words(&output.name, &output.words),
        moved: output.name.clone(),
        is_length: output.ideal_si.is_empty(),
        unit: &output.unit,
        first_order_si: &output.first_order_si,
        play_deviation_si: &output.standard_deviation_si,
        scatter_si: &output.scatter.standard_deviation_si,
    };
    let (position, _) = source.largest_si()?;
    let at = within_turn(record, position);
    let chart = motion_chart(record, name_of("band", &output.name));
    let parts = PlacedParts { place: widest_place(&at), parts: parts(output, position) };
    source.band(chart, &at, &|values| sorted(record, values), (limits_si, parts), writer)
}

/// Parts of the outer band at a position. Joints share their worst case there as they share the largest one.
fn parts(output: &SpatialOutputRecord, position: usize) -> Vec<Part> {
    let at = |list: &[f64]| list.get(position).copied().unwrap_or(0.0);
    let whole_si = output.worst_case_si();
    let play_si = at(&output.first_order_si);
    let plays = output.worst.contributors.iter().filter(|_| whole_si > 0.0);
    let plays = plays.map(|own| (own.joint.clone(), PartKind::Play, own.part_si / whole_si * play_si));
    let all_si = at(&output.scatter.standard_deviation_si);
    plays.chain(dimension_parts(&output.scatter.contributors, all_si, position)).collect()
}
