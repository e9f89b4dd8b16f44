//! Records of simulations, sweeps and motions in folders of results: as the commands write them, read and written by the library.

use std::path::PathBuf;

use crate::written::tables::{FilesError, SUMMARY_FILE};
use loosepin_result::json::Stored;
use loosepin_result::simulation::SimulationRecord;
use loosepin_simulate::{
    BodyStates, body_states_of_csv, history_csv, impacts_csv, spectrum_csv, wear_csv, wear_life_csv, wear_profiles_csv,
};
use loosepin_store::results::{
    Claim, Destination, FinishedResult, HISTORY_FILE, IMPACTS_FILE, InputsHasher, REPORT_FILE, ResultKind,
    ResultsError, ResultsFolder, SPECTRUM_FILE, WEAR_FILE, WEAR_LIFE_FILE, WEAR_PROFILES_FILE,
};
use loosepin_text::diagnostics::{Diagnostics, Problem};

/// The tables of a run beside its summary, by file name.
pub fn run_tables(record: &SimulationRecord, states: Option<&BodyStates>) -> Vec<(&'static str, String)> {
    let mut tables = vec![(HISTORY_FILE, history_csv(record, states)), (IMPACTS_FILE, impacts_csv(record))];
    tables.extend(spectrum_csv(record).map(|text| (SPECTRUM_FILE, text)));
    tables.extend(wear_csv(&record.wear).map(|text| (WEAR_FILE, text)));
    if let Some(life) = &record.life {
        tables.push((WEAR_LIFE_FILE, wear_life_csv(life)));
        tables.push((WEAR_PROFILES_FILE, wear_profiles_csv(life)));
    }
    tables
}

/// A record for a folder of its own, with the files beside its summary.
#[derive(Debug, Clone)]
pub struct RecordFiles {
    /// Kind of result.
    pub kind: ResultKind,
    /// Name of the model.
    pub name: String,
    /// Text of `summary.json`.
    pub summary: String,
    /// Further files by name.
    pub tables: Vec<(&'static str, String)>,
    /// Text of `report.html`.
    pub page: String,
}

impl RecordFiles {
    /// Writes all files into `folder`, as the command of this kind does; its summary counts as its inputs. A folder that holds the same
    /// record stays as it is; with force, other results in it are replaced.
    ///
    /// # Errors
    /// The folder holds something else, is in use, or cannot be written.
    pub fn save(&self, folder: PathBuf, with_force: bool) -> Result<(), Diagnostics> {
        let inputs = InputsHasher::new(self.kind).add("record", &self.summary).finish();
        let destination = Destination::Folder(folder);
        let claim = Claim { kind: self.kind, name: self.name.clone(), inputs, destination, with_force };
        let mut folder = claim.take().map_err(report)?;
        if folder.is_finished() {
            return Ok(());
        }
        match self.write(&mut folder) {
            Ok(()) => Ok(()),
            Err(error) => {
                // What is there already goes; why it could not be written matters more than why it could not be removed.
                let _ = folder.abandon();
                Err(report(error))
            }
        }
    }

    fn write(&self, folder: &mut ResultsFolder) -> Result<(), ResultsError> {
        for (name, text) in &self.tables {
            folder.write(name, text.as_bytes())?;
        }
        folder.write(SUMMARY_FILE, self.summary.as_bytes())?;
        folder.write(REPORT_FILE, self.page.as_bytes())?;
        folder.finish()
    }
}

/// The record of the finished result that `folder` holds.
///
/// # Errors
/// It holds another kind of result; a file that is not as it was written, or that another version wrote.
pub fn read_record<R: Stored>(folder: &FinishedResult, kind: ResultKind) -> Result<R, Diagnostics> {
    folder.demand(kind).map_err(report)?;
    let text = folder.read_text(SUMMARY_FILE).map_err(report)?;
    R::from_json(&text).map_err(|source| report(FilesError::Layout { what: SUMMARY_FILE.to_owned(), source }))
}

/// The run that `folder` holds, with the states of its bodies if they were recorded.
///
/// # Errors
/// As for [`read_record`].
pub fn read_run(folder: &FinishedResult) -> Result<(SimulationRecord, Option<BodyStates>), Diagnostics> {
    let record: SimulationRecord = read_record(folder, ResultKind::Simulation)?;
    let history = folder.read_text(HISTORY_FILE).map_err(report)?;
    let states = body_states_of_csv(&history, &record).map_err(|reason| {
        report(ResultsError::ForeignFile { path: folder.path().join(HISTORY_FILE), reason: reason.to_string() })
    })?;
    Ok((record, states))
}

fn report(problem: impl Problem) -> Diagnostics {
    Diagnostics::one(&problem, None)
}
