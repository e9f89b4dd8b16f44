//! Reads who imports whom, and who names which variants, from the sources, so that the rules of `docs/architecture.md` can be held against them without
//! compiling them.

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

pub mod imports;
pub mod mentions;
pub mod scripts;
pub mod sources;
pub mod typescript;
