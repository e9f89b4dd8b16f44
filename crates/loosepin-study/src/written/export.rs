//! Saved surrogates as files for other programs.

use std::io;
use std::path::{Path, PathBuf};

use crate::question::{SavedSurrogateError, SavedSurrogates};
use crate::written::tables::SURROGATES_FILE;
use loosepin_files::{io_error_words, read_named_text};
use loosepin_store::results::{
    Claim, Destination, FinishedResult, InputsHasher, ResultKind, ResultsError, ResultsFolder,
};
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::quoted;

problems! {
    /// Why surrogates are not written as ONNX.
    #[derive(Debug)]
    pub enum ExportError | Write(ResultsError) {
        /// No file of surrogates.
        NoSurrogates { folder: PathBuf } => Code::NoResults,
            says("the study in {} has no {SURROGATES_FILE}", folder.display()),
            hint("a study with surrogates writes this file: surrogate = \"network\"");
        /// No file of surrogates.
        Read { path: PathBuf, source: io::Error } => Code::NoResults,
            says("cannot read {}: {}", path.display(), io_error_words(source)),
            hint("a study with surrogates writes {SURROGATES_FILE} into the folder of its results: surrogate = \
                  \"network\"");
        /// The file, or one of its surrogates.
        Surrogate { path: PathBuf, source: SavedSurrogateError } => source.code(),
            says("{}: {source}", path.display());
        /// No output of that name.
        NoSuchOutput { asked: String, known: Vec<String> } => Code::SurrogateNotExported,
            says("no surrogate of '{asked}'; there are surrogates of {}", quoted(known));
    }
}

/// Writes the surrogates of `results`, a folder of results or its `surrogates.json`, as ONNX files into `folder`, which is made where there
/// is none; of the outputs with the names `only`, of all where that is empty. Another export there is replaced `with_force` alone. Gives
/// the paths of the files.
///
/// # Errors
/// [`ExportError`]; nothing is written where one of the surrogates has no form in ONNX.
pub fn export_networks(
    results: &Path,
    only: &[String],
    folder: &Path,
    with_force: bool,
) -> Result<Vec<PathBuf>, ExportError> {
    let (path, text) = surrogates_text(results)?;
    let of_file = |source: SavedSurrogateError| ExportError::Surrogate { path: path.clone(), source };
    let saved = SavedSurrogates::from_json(&text).map_err(of_file)?;
    if let Some(asked) = only.iter().find(|asked| saved.outputs.iter().all(|output| output.output != **asked)) {
        let mut known: Vec<String> = saved.outputs.iter().map(|output| output.output.clone()).collect();
        known.dedup();
        return Err(ExportError::NoSuchOutput { asked: asked.clone(), known });
    }
    let is_asked = |output: &usize| only.is_empty() || only.contains(&saved.outputs[*output].output);
    let file = |output: usize| -> Result<(String, Vec<u8>), ExportError> {
        Ok((saved.onnx_file_name(output), saved.to_onnx(output).map_err(of_file)?))
    };
    let files = (0..saved.outputs.len()).filter(is_asked).map(file).collect::<Result<Vec<_>, _>>()?;
    let mut inputs = InputsHasher::new(ResultKind::Networks);
    inputs.add("surrogates", &text);
    for output in only {
        inputs.add("output", output);
    }
    let claim = Claim {
        kind: ResultKind::Networks,
        name: saved.study.clone(),
        inputs: inputs.finish(),
        destination: Destination::Folder(folder.to_owned()),
        with_force,
    };
    let mut written = claim.take()?;
    if !written.is_finished()
        && let Err(error) = write(&mut written, &files)
    {
        if !written.is_finished() {
            written.abandon()?;
        }
        return Err(error.into());
    }
    Ok(files.into_iter().map(|(file_name, _)| folder.join(file_name)).collect())
}

/// Largest file of surrogates, bytes.
const MAX_SURROGATES_BYTES: u64 = 1 << 30;

/// The text of saved surrogates, and the path of its file.
fn surrogates_text(results: &Path) -> Result<(PathBuf, String), ExportError> {
    if !results.is_dir() {
        let text = read_named_text(results, MAX_SURROGATES_BYTES);
        let text = text.map_err(|source| ExportError::Read { path: results.to_owned(), source })?;
        return Ok((results.to_owned(), text));
    }
    let study = FinishedResult::open(results)?;
    match study.read_text(SURROGATES_FILE) {
        Err(ResultsError::NotListed { .. }) => Err(ExportError::NoSurrogates { folder: results.to_owned() }),
        text => Ok((results.join(SURROGATES_FILE), text?)),
    }
}

fn write(folder: &mut ResultsFolder, files: &[(String, Vec<u8>)]) -> Result<(), ResultsError> {
    for (file_name, bytes) in files {
        folder.write(file_name, bytes)?;
    }
    folder.finish()
}
