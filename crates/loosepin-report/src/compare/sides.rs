//! Wording of a value of each study.

/// `3 in A, 4 in B`.
pub fn for_both<T: std::fmt::Display>([before, after]: [T; 2]) -> String {
    format!("{before} in A, {after} in B")
}
