//! `loosepin report`.

use std::path::Path;

use loosepin::accuracy::record::MotionRecord;
use loosepin::diagnostics::{Code, nearest_name, problems};
use loosepin::identify::record::Identification;
use loosepin::model::{Rule, measured_argument};
use loosepin::report::{Figure, figures};
use loosepin::results::{ResultKind, ResultsError, ResultsFolder, write_whole};
use loosepin::simulate::record::SimulationRecord;
use loosepin::study::result::StudyResult;
use loosepin::sweep::record::SweepRecord;
use loosepin::units::Dimension;

use super::stored::{StoredResult, show_stored};
use crate::arguments::ReportArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Millimetres in a metre.
const MM_PER_M: f64 = 1e3;

problems! {
    /// Why a figure cannot be saved.
    #[derive(Debug)]
    pub enum FigureProblem {
        /// The page has no such figure.
        NoSuchFigure { name: String, nearest: Option<String>, known: Vec<String> } => Code::UnknownReference,
            says("the page has no figure '{name}'"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None if known.is_empty() => "the page has no figures".to_owned(),
                None => format!("its figures are {}", known.join(", ")),
            }));
        /// The figure stands for no numbers.
        NoNumbers { name: String } => Code::UnknownReference,
            says("figure '{name}' has no table of numbers"),
            hint("save it as a picture, with --svg");
    }
}

/// Writes the page of stored results again, lists its figures, or saves one.
pub fn run(arguments: &ReportArguments) -> Ending {
    if arguments.list || arguments.figure.is_some() {
        return of_figures(arguments);
    }
    let mut folder = ResultsFolder::reopen(&arguments.folder)?;
    match folder.kind() {
        ResultKind::Simulation => show_stored::<SimulationRecord>(&mut folder, arguments.shown),
        ResultKind::Study => show_stored::<StudyResult>(&mut folder, arguments.shown),
        ResultKind::Sweep => show_stored::<SweepRecord>(&mut folder, arguments.shown),
        ResultKind::Motion => show_stored::<MotionRecord>(&mut folder, arguments.shown),
        ResultKind::Identification => show_stored::<Identification>(&mut folder, arguments.shown),
        ResultKind::Networks => Err(ResultsError::NoPage { folder: folder.path().to_owned() }.into()),
    }
}

fn of_figures(arguments: &ReportArguments) -> Ending {
    let figures = figures(&page(&arguments.folder)?);
    let Some(name) = &arguments.figure else {
        let widest = figures.iter().map(|figure| figure.name.chars().count()).max().unwrap_or(0);
        let line = |figure: &Figure| format!("{:widest$}  {}\n", figure.name, figure.title());
        console::print(&figures.iter().map(line).collect::<String>())?;
        return Ok(Done::Well);
    };
    let known = || figures.iter().map(|figure| figure.name.as_str());
    let figure = figures.iter().find(|figure| figure.name == *name).ok_or_else(|| {
        Failure::of(&FigureProblem::NoSuchFigure {
            name: name.clone(),
            nearest: nearest_name(name, known()).map(str::to_owned),
            known: known().map(str::to_owned).collect(),
        })
    })?;
    if let Some(path) = &arguments.svg {
        let width_m = measured_argument("--width", &arguments.width, Dimension::LENGTH, Rule::Positive)?;
        save(path, &figure.to_svg(Some(width_m * MM_PER_M)))?;
    }
    if let Some(path) = &arguments.csv {
        let numbers = figure.to_csv().ok_or_else(|| Failure::of(&FigureProblem::NoNumbers { name: name.clone() }))?;
        save(path, &numbers)?;
    }
    Ok(Done::Well)
}

fn save(path: &Path, text: &str) -> Result<(), Failure> {
    write_whole(path, text.as_bytes())?;
    console::message(&format!("wrote {}", path.display()));
    Ok(())
}

/// The page of a finished result, written again, so that figures are saved as this version draws them.
fn page(folder: &Path) -> Result<String, Failure> {
    let folder = ResultsFolder::reopen(folder)?;
    match folder.kind() {
        ResultKind::Simulation => page_of::<SimulationRecord>(&folder),
        ResultKind::Study => page_of::<StudyResult>(&folder),
        ResultKind::Sweep => page_of::<SweepRecord>(&folder),
        ResultKind::Motion => page_of::<MotionRecord>(&folder),
        ResultKind::Identification => page_of::<Identification>(&folder),
        ResultKind::Networks => Err(ResultsError::NoPage { folder: folder.path().to_owned() }.into()),
    }
}

fn page_of<R: StoredResult>(folder: &ResultsFolder) -> Result<String, Failure> {
    R::read(folder).map(|record| R::PAGE(&record))
}
