//! The CSV file of a motion in space, SI.

use crate::recording::tables::{self, table, unit_suffix};
use loosepin_result::spatial_motion::SpatialMotionRecord;

/// `motion.csv` of a motion in space: the input, then for each output its ideal value, its worst case of first order and its standard deviation,
/// one row for each position. What a record does not have has no column.
pub fn spatial_motion_csv(record: &SpatialMotionRecord) -> String {
    let mut columns = Vec::new();
    let mut add = |name: &str, what: &str, unit, values_si| {
        let name = format!("{}{what}{}", name.replace(' ', "_"), unit_suffix(unit));
        tables::add(&mut columns, name, unit, values_si);
    };
    add(&record.input, "", record.input_unit.symbol(), &record.inputs_si);
    for output in &record.outputs {
        for (what, values_si) in [
            ("", &output.ideal_si),
            ("_first_order_worst_case", &output.first_order_si),
            ("_standard_deviation", &output.standard_deviation_si),
            ("_scatter_standard_deviation", &output.scatter.standard_deviation_si),
        ] {
            if values_si.len() == record.inputs_si.len() {
                add(&output.name, what, output.unit.symbol(), values_si);
            }
        }
    }
    table(&columns, record.inputs_si.len())
}
