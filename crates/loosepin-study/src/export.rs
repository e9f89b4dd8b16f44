//! Saved surrogates as files for other programs.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::files::SURROGATES_FILE;
use super::saved_surrogates::{SavedSurrogateError, SavedSurrogates};
use loosepin_store::results::{ResultsError, write_whole};
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::quoted;

problems! {
    /// Why surrogates are not written as ONNX.
    #[derive(Debug)]
    pub enum ExportError | Write(ResultsError) {
        /// No file of surrogates.
        Read { path: PathBuf, source: io::Error } => Code::NoResults,
            says("cannot read {}: {source}", path.display()),
            hint("a study that asks for surrogates leaves {SURROGATES_FILE} in the folder of its results: surrogate = \
                  \"network\"");
        /// The file, or one of its surrogates.
        Surrogate { path: PathBuf, source: SavedSurrogateError } => source.code(),
            says("{}: {source}", path.display());
        /// No output of that name.
        NoSuchOutput { asked: String, known: Vec<String> } => Code::SurrogateNotExported,
            says("no surrogate of '{asked}'; there are surrogates of {}", quoted(known));
        /// Another file of that name is there.
        Exists { path: PathBuf } => Code::FileExists,
            says("{} is there already, and holds something else; it is not overwritten", path.display()),
            hint("give another folder");
    }
}

/// Writes the surrogates of `results`, a folder of results or its `surrogates.json`, as ONNX files into `folder`, which is made where there
/// is none; of the outputs with the names `only`, of all where that is empty. Gives the paths of the files.
///
/// # Errors
/// [`ExportError`]; nothing is written where one of the surrogates has no form in ONNX.
pub fn export_networks(results: &Path, only: &[String], folder: &Path) -> Result<Vec<PathBuf>, ExportError> {
    let path = if results.is_dir() { results.join(SURROGATES_FILE) } else { results.to_owned() };
    let text = fs::read_to_string(&path).map_err(|source| ExportError::Read { path: path.clone(), source })?;
    let of_file = |source: SavedSurrogateError| ExportError::Surrogate { path: path.clone(), source };
    let saved = SavedSurrogates::from_json(&text).map_err(of_file)?;
    if let Some(asked) = only.iter().find(|asked| saved.outputs.iter().all(|output| output.output != **asked)) {
        let mut known: Vec<String> = saved.outputs.iter().map(|output| output.output.clone()).collect();
        known.dedup();
        return Err(ExportError::NoSuchOutput { asked: asked.clone(), known });
    }
    let is_asked = |output: &usize| only.is_empty() || only.contains(&saved.outputs[*output].output);
    let file = |output: usize| -> Result<(PathBuf, Vec<u8>), ExportError> {
        Ok((folder.join(saved.onnx_file_name(output)), saved.to_onnx(output).map_err(of_file)?))
    };
    let files = (0..saved.outputs.len()).filter(is_asked).map(file).collect::<Result<Vec<_>, _>>()?;
    // The same export again writes the same bytes.
    let is_other = |(path, bytes): &&(PathBuf, Vec<u8>)| path.exists() && fs::read(path).ok().as_ref() != Some(bytes);
    if let Some((path, _)) = files.iter().find(is_other) {
        return Err(ExportError::Exists { path: path.clone() });
    }
    fs::create_dir_all(folder).map_err(|source| ResultsError::Write { path: folder.to_owned(), source })?;
    for (path, bytes) in &files {
        write_whole(path, bytes)?;
    }
    Ok(files.into_iter().map(|(path, _)| path).collect())
}
