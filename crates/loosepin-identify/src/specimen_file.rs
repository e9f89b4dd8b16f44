//! The narrowed study of a specimen, with the mechanisms that agree with its measurement.

use super::error::IdentifyProblem;
use super::narrowed_interval::{NarrowedInterval, known_bounds, narrowed};
use loosepin_result::identification::Identification;
use loosepin_result::motion_identification::{MechanismRows, SpecimenLengths};
use loosepin_study::Study;
use loosepin_text::diagnostics::{Diagnostics, Source};
use loosepin_text::units::{ReadableUnit, counted};
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

/// A study narrowed to its specimen.
#[derive(Debug)]
pub struct SpecimenStudy {
    /// Its text.
    pub text: String,
    /// The intervals that became narrower.
    pub narrowed: Vec<NarrowedInterval>,
    /// Name and text of the file of mechanisms that stands beside it, where lengths were conditioned.
    pub mechanisms: Option<[String; 2]>,
    /// The study itself.
    pub study: Study,
}

impl SpecimenStudy {
    /// The study of the one specimen of `answer`, which is to be written as `file`: as [`narrowed`], and where mechanisms were drawn with
    /// `[specimen]`, whose file is named after `file`.
    ///
    /// # Errors
    /// Several specimens, or one that nothing explains; mechanisms were asked for and there are none; a study in which rows cannot take the
    /// place of distributions.
    pub fn new(study: &Study, answer: &Identification, file: &Path) -> Result<Self, Diagnostics> {
        let (mut text, narrowed) = narrowed(study, &known_bounds(answer)?);
        let lengths = answer.motion.iter().find_map(|specimen| specimen.lengths.as_ref());
        let mechanisms = match lengths {
            None => None,
            Some(SpecimenLengths::Refused(refusal)) => {
                let problem = IdentifyProblem::NoLengths { reason: refusal.to_string() };
                return Err(Diagnostics::one(&problem, None));
            }
            Some(SpecimenLengths::Given(rows)) => {
                let stem = file.file_stem().map_or_else(|| "narrowed".into(), |stem| stem.to_string_lossy());
                let name = format!("{stem}-specimen.csv");
                let quoted = name.replace('\\', "\\\\").replace('"', "\\\"");
                if !text.ends_with('\n') {
                    text.push('\n');
                }
                let _ = write!(
                    text,
                    "\n# {} that agree with the measurements: they replace the distributions under [random].\n\
                     [specimen]\nmechanisms = \"{quoted}\"\n",
                    counted(rows.rows_si.len(), "mechanism")
                );
                Some([name, csv(study, rows)])
            }
        };
        let own = study.source().name();
        let study = match &mechanisms {
            None => Study::from_text(own, &text, study.model.clone())?,
            Some([name, csv]) => {
                let path = Path::new(own).parent().unwrap_or(Path::new("")).join(name);
                let file = Source::new(path.display().to_string(), csv.as_str());
                let files: Vec<Arc<Source>> = study.tables().iter().cloned().chain([file]).collect();
                let source = Source::with_files(own, text.as_str(), files.into());
                Study::of_model(&source, study.model.clone(), &study.model_path)?
            }
        };
        Ok(Self { text, narrowed, mechanisms, study })
    }
}

/// The rows as a table with units.
fn csv(study: &Study, rows: &MechanismRows) -> String {
    let units: Vec<ReadableUnit> =
        study.random.iter().map(|input| ReadableUnit::default_for(input.dimension(&study.model))).collect();
    let head = rows
        .columns
        .iter()
        .zip(&units)
        .map(|(column, unit)| format!("{} [{}]", column.path, if unit.text.is_empty() { "1" } else { &unit.text }));
    let mut text = head.collect::<Vec<String>>().join(", ");
    text.push('\n');
    for row in &rows.rows_si {
        let cells = row.iter().zip(&units).map(|(value_si, unit)| unit.number(*value_si).to_string());
        text.push_str(&cells.collect::<Vec<String>>().join(", "));
        text.push('\n');
    }
    text
}
