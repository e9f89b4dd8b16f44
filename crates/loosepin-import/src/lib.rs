//! Models from drawings, from robot descriptions and from templates; and robot descriptions of models in space.
//!
//! Robot descriptions are URDF and MJCF: [`import_robot`], [`export_robot`]. Of a drawing comes the skeleton of a model: lines are links,
//! circles are joints.
//!
//! | drawn | becomes |
//! |---|---|
//! | a line | a link |
//! | a polyline, open or closed | one rigid link |
//! | lines that share an end where no circle is | one rigid link |
//! | a circle where two or more links meet, at an end or on the way | a revolute joint; more links: one joint each to the first |
//! | a circle on the layer `ground` | a revolute joint of its links to the ground |
//! | a circle that one link meets, not on the layer `ground` | a named point of the link, whose path is an output |
//! | lines and polylines on the layer `ground` | parts of the ground |
//! | anything else | nothing; it is counted |
//!
//! Numbers that no drawing has (masses, inertias, gravity, speed) stands in the model as `"?"`, which is refused until it is filled
//! in. Play is not drawn: the radius of a circle is that of the pin, and every joint begins as an ideal one.

pub mod templates;

mod dxf;
mod error;
mod export;
mod file_kind;
mod imported;
mod links;
mod options;
mod robot;
mod skeleton;
mod sketch;
mod toml_text;

use std::io;
use std::path::{Path, PathBuf};

use loosepin_files::{read_stream, write_new_files};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::document::not_readable;

pub use error::ImportError;
pub use export::{ExportProblem, Exported, RobotFormat, export_robot, write_robot};
pub use file_kind::{FileKind, KnownBy};
pub use imported::Imported;
pub use options::ImportOptions;
pub use robot::{RobotProblem, import_robot};

/// Reads a DXF drawing (ASCII or binary); `name` becomes the name of the model.
///
/// # Errors
/// See [`ImportError`].
pub fn import_dxf(name: &str, drawing: &[u8], options: &ImportOptions) -> Result<Imported, ImportError> {
    let sketch = sketch::Sketch::read(drawing, options)?;
    let links = links::Links::new(&sketch)?;
    Ok(Imported { model: skeleton::model(name, &sketch, &links), notes: skeleton::notes(&sketch, &links) })
}

/// Largest drawing, and largest robot description, bytes.
const MAX_DRAWING_BYTES: u64 = 256 << 20;

/// Reads the bytes of a drawing, or of a robot description.
///
/// # Errors
/// The file cannot be read, with the name that was probably meant.
pub fn read_drawing(path: &Path) -> Result<Vec<u8>, Diagnostics> {
    read_stream(path, MAX_DRAWING_BYTES).map_err(|error| not_readable(path, &error))
}

/// Writes `model.toml` into a folder, which is made where there is none; gives its path.
///
/// # Errors
/// The file is there already, or the file system refuses.
pub fn write_model(folder: &Path, model: &str) -> Result<PathBuf, ImportError> {
    let path = folder.join("model.toml");
    match write_new_files(folder, &[("model.toml", model.as_bytes())]) {
        Ok(()) => Ok(path),
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Err(ImportError::Exists { path }),
        Err(source) => Err(ImportError::Write { path, source }),
    }
}
