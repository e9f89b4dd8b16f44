//! The name that was probably meant.

/// The candidate nearest to `name` by edits of single characters, if it is near enough to be meant: at most one edit
/// in three characters.
pub fn nearest_name<'c>(name: &str, candidates: impl IntoIterator<Item = &'c str>) -> Option<&'c str> {
    // Longer names are no slips of a known key, and the distance costs their square.
    const LONGEST_NAME_CHARS: usize = 100;
    // Enough for any model; a file of thousands of wrong names must not cost thousands squared.
    const MOST_CANDIDATES: usize = 500;
    let length_chars = name.chars().count();
    if length_chars > LONGEST_NAME_CHARS {
        return None;
    }
    let allowed_edits = (length_chars / 3).max(1);
    candidates
        .into_iter()
        .take(MOST_CANDIDATES)
        .filter(|candidate| candidate.chars().count().abs_diff(length_chars) <= allowed_edits)
        .map(|candidate| (strsim::osa_distance(&name.to_lowercase(), &candidate.to_lowercase()), candidate))
        .filter(|(edits, candidate)| *edits <= allowed_edits && *edits < candidate.chars().count())
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest_name;

    #[test]
    fn slips_are_recognised_and_other_words_are_not() {
        let keys = ["radial_clearance", "bearing_radius", "mass", "inertia"];
        assert_eq!(nearest_name("radial_clearence", keys), Some("radial_clearance"));
        assert_eq!(nearest_name("Mass", keys), Some("mass"));
        assert_eq!(nearest_name("colour", keys), None);
        assert_eq!(nearest_name("x", ["y"]), None);
    }
}
