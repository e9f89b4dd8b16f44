//! Lists as they are said.

use std::fmt::Display;

/// `a`, `a and b`, `a, b and c`.
pub fn listed(items: &[String], conjunction: &str) -> String {
    match items {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} {conjunction} {last}", first.join(", ")),
    }
}

/// `1 run`, `3 runs`: a count with its noun, whose plural ends in s.
pub fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// `'a'`, `'a' and 'b'`, `'a', 'b' and 'c'`: names as they stand in a file.
pub fn quoted(names: &[impl Display]) -> String {
    listed(&names.iter().map(|name| format!("'{name}'")).collect::<Vec<_>>(), "and")
}
