//! The name that was probably meant.

use crate::work;

/// The candidate nearest to `name` by edits of single characters, if it is near enough to be meant: at most one edit
/// in three characters.
pub fn nearest_name<'c>(name: &str, candidates: impl IntoIterator<Item = &'c str>) -> Option<&'c str> {
    // Longer names are no slips of a known key, and the distance costs their square.
    const LONGEST_NAME_CHARS: usize = 100;
    // Enough for any model; a file of thousands of wrong names must not cost thousands squared.
    const MAX_CANDIDATES: usize = 500;
    // Entries of the tables that distances are worked out in: 200 candidates of 16 characters, which all have the letters of the name.
    const MAX_ENTRIES: usize = 50_000;
    let length_chars = name.chars().count();
    if length_chars > LONGEST_NAME_CHARS {
        return None;
    }
    let allowed_edits = (length_chars / 3).max(1);
    let name = name.to_lowercase();
    let letters = letters(&name);
    let mut entries = 0;
    let mut nearest: Option<(usize, &str)> = None;
    for candidate in candidates.into_iter().take(MAX_CANDIDATES) {
        let candidate_chars = candidate.chars().count();
        work::add(candidate_chars);
        let lowercase = candidate.to_lowercase();
        if candidate_chars.abs_diff(length_chars) > allowed_edits || unshared(&letters, &lowercase) > allowed_edits {
            continue;
        }
        entries += length_chars * candidate_chars;
        if entries > MAX_ENTRIES {
            break;
        }
        work::add(length_chars * candidate_chars);
        let edits = strsim::osa_distance(&name, &lowercase);
        let is_near = edits <= allowed_edits && edits < candidate_chars;
        if is_near && nearest.is_none_or(|(fewest, _)| edits < fewest) {
            nearest = Some((edits, candidate));
        }
    }
    nearest.map(|(_, candidate)| candidate)
}

/// How often each letter stands in a name, letters that share the last five bits of their numbers counted together.
fn letters(name: &str) -> [usize; 32] {
    name.chars().fold([0; 32], |mut counts, letter| {
        counts[letter as usize % 32] += 1;
        counts
    })
}

/// Letters of `name` beyond those of the other: an edit takes one of them away at most, so that there are as many edits at least.
fn unshared(others: &[usize; 32], name: &str) -> usize {
    letters(name).iter().zip(others).map(|(own, other)| own.saturating_sub(*other)).sum()
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
        assert_eq!(nearest_name("bearing_raduis", keys), Some("bearing_radius"));
    }
}
