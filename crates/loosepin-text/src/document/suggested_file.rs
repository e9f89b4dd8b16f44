//! The file that was probably meant, where one cannot be read.

use std::path::Path;

use loosepin_files::Folder;

use crate::diagnostics::nearest_name;
use crate::units::listed;

/// The names in a folder, in their order.
fn names_in(folder: &Path) -> Vec<String> {
    // A hint is not worth more.
    const MAX_ENTRIES: usize = 10_000;
    let entries = Folder::open(folder).and_then(|folder| folder.entries(MAX_ENTRIES)).unwrap_or_default();
    let mut names: Vec<String> = entries.into_iter().filter_map(|entry| entry.name.into_string().ok()).collect();
    names.sort();
    names
}

/// The file of the same kind beside `path` that has nearly its name, in words.
pub(super) fn file_of_like_name(path: &Path) -> Option<String> {
    let (stem, kind) = path.file_name()?.to_str()?.rsplit_once('.')?;
    let names = names_in(path.parent()?);
    let stems = names.iter().filter_map(|name| name.strip_suffix(kind)?.strip_suffix('.'));
    nearest_name(stem, stems).map(|nearest| format!("did you mean '{nearest}.{kind}'?"))
}

/// The models and studies in the folder `path`, in words.
pub(super) fn files_inside(path: &Path) -> Option<String> {
    let mut names = names_in(path);
    names.retain(|name| name.ends_with(".toml"));
    match names.as_slice() {
        [] => None,
        [first, _, _, _, ..] => Some(format!("name a file in it, for example {first}")),
        few => Some(format!("name a file in it: {}", listed(few, "or"))),
    }
}
