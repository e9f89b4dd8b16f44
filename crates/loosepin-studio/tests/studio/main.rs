//! The studio as its page meets it, and as somebody does who wants in.

#![allow(clippy::disallowed_methods, reason = "tests make files of their own")]

mod client;
mod curves;
mod disk;
mod drafts;
mod files;
mod hostile;
mod jobs;
mod looks;
mod obstacles;
mod results;
mod shelf;
mod slow;
mod space;
