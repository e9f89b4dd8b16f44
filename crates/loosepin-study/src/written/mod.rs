//! Input and output files of a study: its inputs, its folder of results, commands that repeat a run. How a study file is read stands in
//! `file`.

pub(crate) mod export;
pub(crate) mod folder;
pub(crate) mod input_file;
pub(crate) mod inputs;
pub(crate) mod motion_answer;
pub(crate) mod simulate_command;
pub(crate) mod single_run;
pub(crate) mod stored_records;
pub mod tables;
pub(crate) mod texts;
