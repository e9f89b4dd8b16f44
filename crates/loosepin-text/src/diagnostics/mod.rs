//! Diagnostics about files: place, code, rule, hint.
//!
//! A module that checks something has its own error enum; each of its errors is a [`Problem`], which knows its stable
//! [`Code`], its text and the way out. Together with a [`Place`] it becomes a [`Diagnostic`]; all diagnostics of a file
//! are collected in [`Diagnostics`] and reported at once.

mod code;
mod diagnostic;
mod problems;
mod render;
mod source;
mod suggestion;
mod visible;

pub use code::{CODES, Code, CodeEntry};
pub use diagnostic::{Diagnostic, Diagnostics, Label, Problem, RefusedFile, Severity};
pub use problems::problems;
pub use render::Colour;
pub use source::{Place, Source, Span};
pub use suggestion::nearest_name;
pub use visible::{first_control_character, visible};
