//! Clearances as files give them.

use crate::kind::joint_reader::JointReader;
use loosepin_text::document::Table;
use loosepin_text::numbers::QuantityId;

/// Whether a clearance is smaller than the radius of its bearing, where that is stated; reports if not, and a radius without clearance.
pub(crate) fn fits_in_radius(
    reader: &mut dyn JointReader,
    table: &Table<'_>,
    clearance: Option<QuantityId>,
    radius: Option<QuantityId>,
) -> bool {
    let Some(radius) = radius else { return true };
    let Some(clearance) = clearance else {
        if !table.has("radial_clearance") {
            reader.report_missing(table, "bearing_radius", vec!["radial_clearance"]);
        }
        return false;
    };
    let span = table.get("radial_clearance").map_or(table.span, |entry| entry.span);
    reader.demand_order(clearance, radius, span)
}
