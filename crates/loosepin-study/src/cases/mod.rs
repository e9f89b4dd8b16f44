//! Reference cases: mechanisms with known answers, and the differences of the program from them.
//!
//! A case is a folder with `model.toml`, `expected.toml` and what these name. `expected.toml` says for every number how it is
//! obtained, so that a new case needs no code; `cases/README.md` describes its keys.

mod case;
mod compare;
mod dimension;
mod expected;
mod folder;
mod history;
mod ideal;
mod obtain;
mod problem;
pub use loosepin_result::cases as record;
mod reference;
mod script_file;
mod tables;

pub use case::Case;
pub use compare::{compare, compare_all};
pub use folder::case_names;
pub use problem::CaseProblem;
