//! Files that go into a study and come out of it: what it is computed from, its folder of results, commands that repeat a run.
//! How a study file is read stands in `file`.

pub(crate) mod export;
pub(crate) mod folder;
pub(crate) mod input_file;
pub(crate) mod inputs;
pub(crate) mod simulate_command;
pub(crate) mod single_run;
pub mod tables;
pub(crate) mod texts;
