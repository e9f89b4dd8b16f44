//! Reference cases: mechanisms whose answer is known, and how near the program comes to it.
//!
//! A case is a folder with `model.toml`, `expected.toml` and what these name. `expected.toml` says for every number how it is
//! obtained, so that a new case needs no code; `cases/README.md` describes its keys.
#![allow(dead_code, reason = "what is read is compared in the next commit")]

mod case;
mod expected;
mod keys;
mod problem;
mod reference;
mod script_file;

pub use case::{Case, case_names};
pub use problem::CaseProblem;
