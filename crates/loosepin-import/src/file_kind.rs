//! What a file is that is imported.

use std::path::Path;

/// What a file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// A DXF drawing.
    Drawing,
    /// A robot description: URDF or MJCF, which its root element says.
    Robot,
}

/// What says so.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum KnownBy {
    /// The extension of its name.
    Name,
    /// Its content, where the extension says nothing.
    Content,
}

/// Extensions in lower case, and what they stand for.
const EXTENSIONS: [(&str, FileKind); 4] =
    [("dxf", FileKind::Drawing), ("urdf", FileKind::Robot), ("xml", FileKind::Robot), ("mjcf", FileKind::Robot)];

impl FileKind {
    /// What a file is by the extension of its name, upper or lower case. Where that says nothing: a robot description if its first character is
    /// `<`, apart from a byte order mark and blanks, as in XML and in no drawing; otherwise a drawing.
    pub fn of(path: &Path, bytes: &[u8]) -> (FileKind, KnownBy) {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        let known = extension.and_then(|own| EXTENSIONS.into_iter().find(|(extension, _)| *extension == own));
        match known {
            Some((_, kind)) => (kind, KnownBy::Name),
            None => (Self::of_content(bytes), KnownBy::Content),
        }
    }

    fn of_content(bytes: &[u8]) -> FileKind {
        let text = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
        if text.trim_ascii_start().starts_with(b"<") { Self::Robot } else { Self::Drawing }
    }

    /// A note for a file whose content alone says what it is.
    pub fn note_of_content(self) -> &'static str {
        match self {
            Self::Drawing => {
                "read as a DXF drawing: the name does not say what the file is (.dxf, .urdf, .xml or .mjcf would), and its first character is no <"
            }
            Self::Robot => {
                "read as a robot description: the name does not say what the file is (.dxf, .urdf, .xml or .mjcf would), and its first character is <"
            }
        }
    }
}
