//! Lists, counts and durations in words.

use std::fmt::Display;

/// Each of the values once, in the order in which they come first.
pub fn distinct<T: PartialEq>(values: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut found = Vec::new();
    for value in values {
        if !found.contains(&value) {
            found.push(value);
        }
    }
    found
}

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

/// `1 joint`, `4 joints`, `no joint`: a count with its noun, for whose plural the caller stands.
pub fn counted_or_no(count: usize, singular: &str, plural: &str) -> String {
    match count {
        0 => format!("no {singular}"),
        1 => format!("1 {singular}"),
        _ => format!("{count} {plural}"),
    }
}

/// `'a'`, `'a' and 'b'`, `'a', 'b' and 'c'`: names as they stand in a file.
pub fn quoted(names: &[impl Display]) -> String {
    listed(&names.iter().map(|name| format!("'{name}'")).collect::<Vec<_>>(), "and")
}

/// A duration as one would say it: `less than a second`, `40 s`, `3 min`, `2.5 h`.
pub fn duration_words(seconds: f64) -> String {
    match seconds {
        s if s < 1.0 => "less than a second".to_owned(),
        s if s < 90.0 => format!("{s:.0} s"),
        s if s < 5400.0 => format!("{:.0} min", s / 60.0),
        s => format!("{:.1} h", s / 3600.0),
    }
}
