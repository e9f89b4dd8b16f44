//! Reads who imports whom from the sources, so that the rules of `docs/architecture.md` can be held against them without
//! compiling them.

pub mod imports;
pub mod sources;
