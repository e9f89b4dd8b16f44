//! Writes the three kinds of page, and what a terminal shows, from made-up results, so that they can be looked at and tested in a browser:
//! `cargo run --example report_pages -- FOLDER`.

#[path = "../tests/report/report_fixture/mod.rs"]
mod report_fixture;

use std::path::PathBuf;
use std::process::ExitCode;
use std::{env, fs, io};

use loosepin::report;

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

fn write_pages(folder: &std::path::Path) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    fs::write(folder.join("study.html"), report::study_page(&report_fixture::study::worn_pin()))?;
    fs::write(folder.join("simulation.html"), report::simulation_page(&report_fixture::simulation::worn_pin()))?;
    fs::write(folder.join("motion.html"), report::motion_page(&report_fixture::motion::worn_pin()))?;
    fs::write(folder.join("four_bar.html"), report::motion_page(&report_fixture::motion::four_bar()))?;
    fs::write(folder.join("study.txt"), report::study_text(&report_fixture::study::worn_pin()))?;
    fs::write(folder.join("simulation.txt"), report::simulation_text(&report_fixture::simulation::worn_pin()))?;
    fs::write(folder.join("motion.txt"), report::motion_text(&report_fixture::motion::worn_pin()))
}
