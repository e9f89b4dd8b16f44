//! README, documentation and `cases`: links, programs, numbers.

#![allow(clippy::disallowed_methods, reason = "tests make files of their own")]

mod case_folders;
mod cases;
mod file_pages;
mod film_tables;
mod key_tables;
mod limits;
mod readme;
mod site;
