//! README, documentation and `cases`: links, programs, numbers.

mod case_folders;
mod cases;
mod file_pages;
mod key_tables;
mod limits;
mod readme;
mod site;
