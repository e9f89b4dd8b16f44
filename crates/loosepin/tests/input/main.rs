//! What is read: model and study files, good, bad, mutated and endless, drawings, and the inputs that fuzzing found.

#![allow(clippy::disallowed_methods, reason = "tests make files of their own")]

mod bad_files;
mod diametral_clearance;
mod every_key_is_read;
mod fuzz_corpus;
mod implausible_numbers;
mod import;
mod model_file;
mod mutated_files;
mod output_units;
mod runaway_files;
mod study_file;
