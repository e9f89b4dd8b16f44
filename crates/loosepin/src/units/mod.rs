//! Text with units to SI numbers and back.
