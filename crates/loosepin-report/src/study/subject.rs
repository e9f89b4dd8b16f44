//! What the sentence on an output is about.

use crate::words::wording::{output_words, path_part};
use loosepin_result::study::{Deviation, PathError, StudyResult};

/// Subject of a sentence without its article, and from what an output stays within a limit: its ideal motion, or what the part of a path says. The limit of a
/// distance has no sign.
pub(super) struct Subject {
    pub name: String,
    pub from: &'static str,
    pub is_distance: bool,
}

pub(super) fn subject(result: &StudyResult, output: &str, of: Deviation) -> Subject {
    let part = path_part(output, &result.outputs);
    let name = part.map_or_else(|| output_words(output, &result.outputs), |(point, _)| point.to_owned());
    let from = match part.map(|(_, part)| part) {
        None => "of its ideal motion",
        Some(PathError::Magnitude) => "of where it should be",
        Some(PathError::Along) => "of where it should be, along its path,",
        Some(PathError::Normal) => "of its ideal path, across it,",
        Some(PathError::Contour) => "of its ideal path, whatever the timing,",
    };
    let name = of.cause().map_or_else(|| name.clone(), |cause| format!("{name}, as far as {cause} goes,"));
    Subject { name, from, is_distance: matches!(part, Some((_, PathError::Magnitude))) }
}
