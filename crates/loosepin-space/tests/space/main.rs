//! Mechanisms in space against closed forms, independent programs and identities. A test's name says where its numbers come from.

mod build;
mod chains;
mod closed_forms;
mod identities;
mod known;
mod model_files;
mod model_motions;
mod pictures;
mod quasi_static;
mod refusals;
mod searches;
mod stops;
