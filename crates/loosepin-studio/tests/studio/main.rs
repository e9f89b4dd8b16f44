//! The studio as its page meets it, and as somebody does who wants in.

mod client;
mod disk;
mod files;
mod hostile;
mod jobs;
mod looks;
mod results;
mod slow;
