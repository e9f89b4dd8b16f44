//! Writes pages of all kinds but one, and what a terminal shows, from made-up results, so that they can be looked at and tested in a browser:
//! `cargo run --example report_pages -- FOLDER`. NAME.figures beside NAME.html holds the figures of the page as they are saved.

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

#[path = "../tests/report/report_fixture/mod.rs"]
mod report_fixture;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::AtomicBool;
use std::{env, fs, io};

use loosepin::accuracy::record::MotionRecord;
use loosepin::report;
use loosepin::space::SpatialModel;
use loosepin::study::InputFile;

fn main() -> ExitCode {
    let Some(folder) = env::args_os().nth(1).map(PathBuf::from) else {
        eprintln!("report_pages: no folder given\nhint: cargo run --example report_pages -- target/report_pages");
        return ExitCode::from(2);
    };
    match write_pages(&folder) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("report_pages: cannot write into {}: {error}", folder.display());
            ExitCode::from(2)
        }
    }
}

fn write_pages(folder: &Path) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    write_page(folder, "study", &report::study_page(&report_fixture::study::worn_pin()))?;
    write_page(folder, "lists", &report::study_page(&report_fixture::study::with_list()))?;
    write_page(folder, "outputs", &report::study_page(&report_fixture::study::with_outputs(8)))?;
    write_page(folder, "simulation", &report::simulation_page(&report_fixture::simulation::worn_pin()))?;
    write_page(folder, "motion", &report::motion_page(&report_fixture::motion::worn_pin()))?;
    write_page(folder, "four_bar", &report::motion_page(&report_fixture::motion::four_bar()))?;
    write_page(folder, "coupler_path", &report::motion_page(&coupler_path()))?;
    write_page(folder, "space", &report::motion_page(&template_in_space("spatial-four-bar")))?;
    write_page(folder, "space_over_time", &report::motion_page(&template_in_space("steering-linkage")))?;
    write_page(folder, "sweep", &report::sweep_page(&report_fixture::sweep::windows()))?;
    fs::write(folder.join("study.txt"), report::study_text(&report_fixture::study::worn_pin()))?;
    fs::write(folder.join("simulation.txt"), report::simulation_text(&report_fixture::simulation::worn_pin()))?;
    fs::write(folder.join("motion.txt"), report::motion_text(&report_fixture::motion::worn_pin()))?;
    fs::write(folder.join("study_short.txt"), report::short_study_text(&report_fixture::study::worn_pin()))?;
    let simulation = report::short_simulation_text(&report_fixture::simulation::worn_pin());
    fs::write(folder.join("simulation_short.txt"), simulation)?;
    fs::write(folder.join("motion_short.txt"), report::short_motion_text(&report_fixture::motion::worn_pin()))
}

/// The motion of a four-bar with the paths of two points of its coupler, as the library computes it.
fn coupler_path() -> MotionRecord {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/four_bar_coupler_path/study.toml");
    let found = InputFile::from_path(&file)
        .and_then(|file| file.motion_answer(&[], &["coupler.head".to_owned()], &AtomicBool::new(false)));
    found.unwrap_or_else(|problems| panic!("{problems}"))
}

/// The motion of a template in space, as the library computes it.
fn template_in_space(name: &str) -> MotionRecord {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../loosepin-import/templates/{name}/model.toml"));
    let model = SpatialModel::from_path(&file).unwrap_or_else(|problems| panic!("{problems}"));
    model.motion_record(&model.quantities.nominal()).unwrap_or_else(|problems| panic!("{problems}"))
}

/// A page, and beside it a folder with its figures as the library saves them.
fn write_page(folder: &Path, name: &str, page: &str) -> io::Result<()> {
    fs::write(folder.join(format!("{name}.html")), page)?;
    let figures = folder.join(format!("{name}.figures"));
    fs::create_dir_all(&figures)?;
    for figure in report::figures(page) {
        fs::write(figures.join(format!("{}.svg", figure.name)), figure.to_svg(None))?;
        if let Some(csv) = figure.to_csv() {
            fs::write(figures.join(format!("{}.csv", figure.name)), csv)?;
        }
    }
    Ok(())
}
