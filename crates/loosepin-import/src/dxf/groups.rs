//! The groups of a file, text or binary, one after the other.

use super::binary::{self, BinaryGroups};
use super::error::{DxfError, DxfProblem, FilePosition};
use super::group::Group;
use super::text::TextGroups;

/// The groups of a file, one after the other.
pub(super) enum Groups<'a> {
    Text(TextGroups<'a>),
    Binary(BinaryGroups<'a>),
}

impl<'a> Groups<'a> {
    /// The groups of a file, which is binary where it begins as such files do.
    pub fn of(bytes: &'a [u8]) -> Self {
        match bytes.strip_prefix(binary::SENTINEL) {
            Some(groups) => Groups::Binary(BinaryGroups::of(groups)),
            None => Groups::Text(TextGroups::of(bytes)),
        }
    }

    /// The next group that is not a comment; `None` at the end of the file.
    pub fn next(&mut self) -> Result<Option<Group<'a>>, DxfError> {
        const COMMENT: i32 = 999;
        loop {
            let group = match self {
                Groups::Text(groups) => groups.next()?,
                Groups::Binary(groups) => groups.next()?,
            };
            if group.as_ref().is_none_or(|group| group.code != COMMENT) {
                return Ok(group);
            }
        }
    }

    /// The next group of a section; `None` at its end.
    pub fn next_in_section(&mut self, section: &str) -> Result<Option<Group<'a>>, DxfError> {
        match self.next()? {
            Some(group) if group.code == 0 && group.text() == "ENDSEC" => Ok(None),
            Some(group) => Ok(Some(group)),
            None => Err(self.place().error(DxfProblem::EndsInSection { section: section.to_owned() })),
        }
    }

    fn place(&self) -> FilePosition {
        match self {
            Groups::Text(groups) => groups.place(),
            Groups::Binary(groups) => groups.place(),
        }
    }
}
