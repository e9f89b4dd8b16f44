//! A file with the tables that it names, in one run of bytes.

/// Begins a line that names a table; the lines after it are the table. It is a comment of TOML, so that a file with no tables
/// is an input as it stands.
pub const TABLE: &str = "#= ";

/// A file and its tables, by the names that the file has for them.
pub struct Files {
    /// The file.
    pub text: String,
    /// The tables.
    pub tables: Vec<(String, String)>,
}

impl Files {
    /// The files of an input; nothing where it is not UTF-8.
    pub fn of(bytes: &[u8]) -> Option<Files> {
        let text = std::str::from_utf8(bytes).ok()?;
        let mut files = Files { text: String::new(), tables: Vec::new() };
        for line in text.split_inclusive('\n') {
            match (line.strip_prefix(TABLE), files.tables.last_mut()) {
                (Some(name), _) => files.tables.push((name.trim_end().to_owned(), String::new())),
                (None, Some((_, table))) => table.push_str(line),
                (None, None) => files.text.push_str(line),
            }
        }
        Some(files)
    }
}
