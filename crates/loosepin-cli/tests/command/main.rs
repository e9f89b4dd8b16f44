//! The command as people type it: what it prints, writes and refuses.

#![allow(clippy::disallowed_methods, reason = "tests make files of their own")]

mod bad_input;
mod cases;
mod cluster_page;
mod command_line;
mod curves;
mod failed_runs;
mod figures;
mod forces;
mod identify;
mod import;
mod motion_verdicts;
mod pages;
mod paths;
mod repeat;
mod resume;
mod serve;
mod shards;
mod simulate;
mod space;
mod space_studies;
mod study;
mod study_queries;
mod sweep;
mod system_limits;
mod templates;
mod wear;
mod without_masses;
mod words;
