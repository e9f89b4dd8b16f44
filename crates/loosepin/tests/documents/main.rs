//! README, documentation and `cases`: links, programs, numbers.

mod case_folders;
mod cases;
mod readme;
mod site;
