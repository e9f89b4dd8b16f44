//! Open chains.
