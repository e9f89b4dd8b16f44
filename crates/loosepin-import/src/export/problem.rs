//! Why a model in space is no robot description.

use loosepin_text::diagnostics::{Code, problems};
use std::path::PathBuf;

problems! {
    /// Why a model in space is no robot description.
    #[derive(Debug, Clone, PartialEq)]
    pub enum ExportProblem {
        Kind { joint: String, kind: &'static str, format: &'static str, other: bool } => Code::NotExportable,
            says("joint '{joint}' is {kind}, which {format} does not know"),
            hint_of(other.then(|| "export to MJCF: --to mjcf".to_owned()));
        ClosesLoop { joint: String, other: bool } => Code::NotExportable,
            says("joint '{joint}' closes a loop, which URDF does not know"),
            hint_of(other.then(|| "export to MJCF: --to mjcf".to_owned()));
        LoopKind { joint: String, kind: &'static str } => Code::NotExportable,
            says("joint '{joint}' is {kind} and closes a loop, which MJCF does not know"),
            hint("MJCF closes loops by balls, pins and rigid joints");
        NotInSpace { file: String } => Code::WrongKindOfFile,
            says("{file} is not a model in space; robot descriptions are made of these alone"),
            hint("a model in space has geometry = \"space\" at its top");
        Exists { path: PathBuf } => Code::FileExists,
            says("{} already exists; it is not overwritten", path.display()),
            hint("give another folder, or replace it with --force");
        NotWritten { path: PathBuf, why: String } => Code::FolderNotUsable,
            says("cannot write {}: {why}", path.display());
        NotConnected { body: String } => Code::NotExportable,
            says("body '{body}' is connected with the ground by no joint");
    }
}
