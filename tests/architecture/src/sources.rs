//! The source files of a folder.

use std::path::Path;

/// A source file.
pub struct Source {
    /// Below the folder, with `/`.
    pub path: String,
    /// Its content.
    pub text: String,
}

impl Source {
    /// The module path, `["model", "quantity"]` for `model/quantity.rs`; empty for the crate root.
    pub fn module_path(&self) -> Vec<String> {
        let mut parts: Vec<String> = self.path.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
        if parts.last().is_some_and(|last| last == "mod" || last == "lib") {
            parts.pop();
        }
        parts
    }

    /// Lines before the test module that ends the file.
    pub fn lines_before_tests(&self) -> usize {
        let lines: Vec<&str> = self.text.lines().collect();
        lines
            .windows(2)
            .position(|pair| pair[0] == "#[cfg(test)]" && pair[1].starts_with("mod "))
            .unwrap_or(lines.len())
    }
}

/// A text file of the repository.
pub fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All Rust files below `folder`, with paths relative to it.
pub fn sources_below(folder: &Path) -> Vec<Source> {
    files_below(folder, &["rs"])
}

/// All files below `folder` with these extensions, with paths relative to it.
pub fn files_below(folder: &Path, extensions: &[&str]) -> Vec<Source> {
    let mut sources = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in std::fs::read_dir(&next).unwrap_or_else(|error| panic!("{}: {error}", next.display())) {
            let path = entry.expect("a folder entry can be read").path();
            if path.is_dir() {
                // What npm has installed there is not ours.
                if path.file_name().is_none_or(|name| name != "node_modules") {
                    open.push(path);
                }
            } else if path.extension().is_some_and(|own| extensions.iter().any(|extension| own == *extension)) {
                let relative = path.strip_prefix(folder).expect("the file lies below the folder");
                let parts: Vec<_> = relative.iter().map(|part| part.to_string_lossy()).collect();
                sources.push(Source { path: parts.join("/"), text: read(&path) });
            }
        }
    }
    sources
}
