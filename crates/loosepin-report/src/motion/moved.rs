//! Whether play and scatter move an output, and what it is called where they do.

use loosepin_result::motion::{OutputMotion, PathMotion};
use loosepin_result::study::PathError;

/// Whether play moves an output.
pub(super) fn has_clearance(output: &OutputMotion) -> bool {
    let answer = &output.clearance;
    let found = answer.searched.iter().flat_map(|searched| &searched.found_si);
    answer.first_order_si.iter().chain(&answer.worst_case_si).chain(found).any(|value| *value != 0.0)
}

/// Whether the scatter of a part moves an output.
pub(super) fn has_scatter(output: &OutputMotion) -> bool {
    output.dimensional_standard_deviation_si.iter().any(|value| *value != 0.0)
}

/// Words for the moving object: the output, or for an error of a path the point along or across it.
pub(crate) fn moved_words(output: &OutputMotion) -> String {
    let Some(PathMotion { path, part }) = &output.path_error else { return output.name.clone() };
    match part {
        PathError::Along => format!("{path} along its path"),
        PathError::Normal => format!("{path} across its path"),
        // The quasi-static answer has no other parts.
        PathError::Magnitude | PathError::Contour => output.name.clone(),
    }
}
