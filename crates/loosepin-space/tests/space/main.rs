//! Mechanisms in space against closed forms, independent programs and identities. A test's name says where its numbers come from.

mod assembly_search;
mod build;
mod chains;
mod closed_forms;
mod dead_centres;
mod identities;
mod known;
mod least_play;
mod manufacture;
mod model_files;
mod model_motions;
mod orientations;
mod pictures;
mod proven_ends;
mod quasi_static;
mod random;
mod random_mechanisms;
mod refusals;
mod sampled_play;
mod sampling;
mod scatter;
mod searches;
mod stopped;
mod stops;
