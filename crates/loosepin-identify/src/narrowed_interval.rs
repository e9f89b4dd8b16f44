//! From the answer back to the input: the study file with narrower intervals.

use super::error::IdentifyProblem;
use loosepin_files::{io_error_words, write_new_files};
use loosepin_result::identification::{Identification, Outcome, PlayBounds};
use loosepin_study::{Study, number_and_unit};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::document::parse_toml;
use loosepin_text::units::{Dimension, ReadableUnit, decimal_exponent, parse_quantity};
use std::io;
use std::ops::Range;
use std::path::Path;

/// Digits of a written end, rounded outwards.
const DIGITS: i32 = 6;

/// An interval that became narrower.
#[derive(Debug, Clone, PartialEq)]
pub struct NarrowedInterval {
    /// Path in the model.
    pub path: String,
    /// The old text: lower and upper end.
    pub before: [String; 2],
    /// The new text.
    pub after: [String; 2],
}

/// The text of `study` with every plain interval as narrow as `known` proves, everything else as it was written; and which these are.
///
/// Ends are rounded outwards. An end that the readings do not narrow stays as it is written, and so does everything that is not stated as
/// `interval = [...]`.
pub fn narrowed(study: &Study, known: &[PlayBounds]) -> (String, Vec<NarrowedInterval>) {
    let text = study.source().text();
    let mut changes: Vec<(Range<usize>, String)> = Vec::new();
    let mut all = Vec::new();
    for play in known.iter().filter(|play| play.is_interval) {
        let Some(written) = written_ends(study, &play.path) else { continue };
        let Some(dimension) = study.model.dimension_of(&play.path) else { continue };
        let before = written.clone().map(|(text, _)| text);
        let mut after = before.clone();
        for (end, is_narrowed) in play.is_narrowed().into_iter().enumerate() {
            if !is_narrowed {
                continue;
            }
            let rounded = outwards(play.after_si[end], end == 1, &before[end], dimension);
            // What rounding takes back is no narrowing.
            let is_narrower = parse_quantity(&rounded).is_ok_and(|read| match end {
                0 => read.value_si > play.before_si[0],
                _ => read.value_si < play.before_si[1],
            });
            if is_narrower {
                changes.push((written[end].1.clone(), format!("\"{rounded}\"")));
                after[end] = rounded;
            }
        }
        if after != before {
            all.push(NarrowedInterval { path: play.path.clone(), before, after });
        }
    }
    changes.sort_by_key(|(range, _)| range.start);
    let mut changed = String::with_capacity(text.len());
    let mut from = 0;
    for (range, new) in changes {
        changed.push_str(&text[from..range.start]);
        changed.push_str(&new);
        from = range.end;
    }
    changed.push_str(&text[from..]);
    (changed, all)
}

/// Bounds of the inputs of the one specimen of `answer`: by its dead travels, by its motion, or by both together.
///
/// # Errors
/// Several specimens, or one that nothing explains.
pub fn known_bounds(answer: &Identification) -> Result<Vec<PlayBounds>, Diagnostics> {
    let all = answer.specimens.iter().map(|specimen| &specimen.name);
    let mut names: Vec<&Option<String>> = all.chain(answer.motion.iter().map(|specimen| &specimen.name)).collect();
    names.sort_unstable();
    names.dedup();
    if names.len() != 1 {
        return Err(Diagnostics::one(&IdentifyProblem::SeveralSpecimens { found: names.len() }, None));
    }
    let mut known: Vec<PlayBounds> = Vec::new();
    for specimen in &answer.specimens {
        match &specimen.outcome {
            Outcome::Consistent(consistent) => known.extend(consistent.plays.iter().cloned()),
            Outcome::Misfit(_) => return Err(unexplained(&specimen.name)),
        }
    }
    if let Some(specimen) = answer.motion.iter().find(|specimen| specimen.misfit.is_some()) {
        return Err(unexplained(&specimen.name));
    }
    for bounds in answer.motion.iter().flat_map(|specimen| &specimen.unknowns) {
        let Some(same) = known.iter_mut().find(|same| same.path == bounds.path) else {
            known.push(bounds.clone());
            continue;
        };
        let both = [same.after_si[0].max(bounds.after_si[0]), same.after_si[1].min(bounds.after_si[1])];
        if both[0] > both[1] {
            return Err(Diagnostics::one(&IdentifyProblem::Contradiction { path: same.path.clone() }, None));
        }
        same.after_si = both;
    }
    Ok(known)
}

fn unexplained(specimen: &Option<String>) -> Diagnostics {
    Diagnostics::one(&IdentifyProblem::Unexplained { specimen: specimen.clone() }, None)
}

/// Both ends of `interval` as written, with their spans.
fn written_ends(study: &Study, path: &str) -> Option<[(String, Range<usize>); 2]> {
    let toml = parse_toml(study.source()).ok()?;
    let inputs = toml.get_ref().get("epistemic")?.get_ref().as_table()?;
    let (_, input) = inputs.iter().find(|(key, _)| key.get_ref() == path)?;
    let ends = input.get_ref().as_table()?.get("interval")?.get_ref().as_array()?;
    let mut written = ends.iter().map(|end| {
        let range = end.span();
        let raw = &study.source().text()[range.clone()];
        (end.get_ref().as_str().map_or_else(|| raw.to_owned(), str::to_owned), range)
    });
    Some([written.next()?, written.next()?])
}

/// A value in the unit of `like`, rounded down or up to [`DIGITS`] digits, so that it does not cut off what is possible.
fn outwards(value_si: f64, is_upper: bool, like: &str, dimension: Dimension) -> String {
    let symbol = number_and_unit(like).map_or("", |(_, unit)| unit);
    let unit = ReadableUnit::of_dimension(symbol, dimension).unwrap_or_else(|| ReadableUnit::default_for(dimension));
    let number = unit.number(value_si);
    let decimals = (DIGITS - 1 - decimal_exponent(number).unwrap_or(0)).clamp(0, 15);
    let step = 10.0_f64.powi(-decimals);
    let sign = if is_upper { 1.0 } else { -1.0 };
    let mut steps = if is_upper { (number / step).ceil() } else { (number / step).floor() };
    loop {
        let digits = format!("{:.*}", decimals as usize, steps * step);
        let text = format!("{digits} {}", unit.text).trim_end().to_owned();
        // Reading it back decides: decimal fractions have no exact binary form.
        let is_outside = parse_quantity(&text).is_ok_and(|read| sign * (read.value_si - value_si) >= 0.0);
        if is_outside || !steps.is_finite() {
            return text;
        }
        steps += sign;
    }
}

/// Writes files beside the study that they come from, all of them or none: a narrowed study, and what it names.
///
/// # Errors
/// A path in another folder, from which the model would not be found; a file that is there already; one that cannot be written.
pub fn write_narrowed(study: &Study, files: &[(&Path, &str)]) -> Result<(), Diagnostics> {
    let refused = |problem: IdentifyProblem| Diagnostics::one(&problem, None);
    let folder_of = |path: &Path| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        folder.canonicalize()
    };
    let own = Path::new(study.source().name());
    let own_folder = folder_of(own).ok();
    for (path, _) in files {
        if own_folder.is_none() || folder_of(path).ok() != own_folder {
            let folder = own.parent().map_or_else(String::new, |folder| folder.display().to_string());
            let folder = if folder.is_empty() { ".".to_owned() } else { folder };
            return Err(refused(IdentifyProblem::NotBeside { file: path.display().to_string(), folder }));
        }
        if path.symlink_metadata().is_ok() {
            return Err(refused(IdentifyProblem::Exists { file: path.display().to_string() }));
        }
    }
    let Some((folder, (first, _))) = own_folder.zip(files.first()) else { return Ok(()) };
    let named = files.iter().map(|(path, text)| Some((path.file_name()?.to_str()?, text.as_bytes())));
    let named = named.collect::<Option<Vec<_>>>().ok_or(io::Error::from(io::ErrorKind::InvalidFilename));
    let written = named.and_then(|named| write_new_files(&folder, &named));
    written.map_err(|error| {
        let file = first.display().to_string();
        refused(match error.kind() {
            io::ErrorKind::AlreadyExists => IdentifyProblem::Exists { file },
            _ => IdentifyProblem::NotWritten { file, reason: io_error_words(&error) },
        })
    })
}
