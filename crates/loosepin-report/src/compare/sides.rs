//! Wording of a value of each study.

/// `3 in A, 4 in B`.
pub fn for_both<T: std::fmt::Display>([before, after]: [T; 2]) -> String {
    format!("{before} in A, {after} in B")
}

/// `3` if both are the same, else `3 in A, 4 in B`.
pub fn same_or_both<T: std::fmt::Display + PartialEq>([before, after]: [T; 2]) -> String {
    if before == after { before.to_string() } else { for_both([before, after]) }
}
