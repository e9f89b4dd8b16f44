//! Equations of motion of a compiled mechanism.
