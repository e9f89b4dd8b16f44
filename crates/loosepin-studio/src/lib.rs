//! The studio: a page on loopback in which a mechanism and its study are edited, with the band under the drawing at every change.
//!
//! The two text files are the only truth. The page sends texts, the server answers with what it reads in them (`look.rs`), and runs
//! studies as the command does (`jobs.rs`). No mechanics is computed in the page: the pictures are those of the report.
//!
//! | What | File |
//! |---|---|
//! | the server, what connections share, its routes | `server.rs`, `studio.rs`, `routes.rs` |
//! | connections: who may stay, for how long, how many bytes | `connections.rs`, `visitors.rs`, `stream.rs`, `times.rs` |
//! | who may ask: token, host, origin, policy of contents | `guard.rs`, `token.rs` |
//! | the served folder: which paths, reading and writing | `folder.rs` |
//! | texts that are not saved yet, and whose they are | `drafts.rs`, `draft_routes.rs`, `tabs.rs` |
//! | what is listed of it; results as pages | `listing.rs`, `listed.rs`, `tickets.rs` |
//! | results read again: compared, run at a witness, taken into the model | `result_routes.rs`, `stored.rs`, `adopt.rs` |
//! | a mechanism in space as the page shows it | `space_view.rs` |
//! | texts to diagnostics, drawing, bands, quantities | `texts.rs`, `look.rs`, `diagnostics.rs`, `fixes.rs`, `limits.rs`, `places.rs`, `quantities.rs`, `dimensions.rs`, `centres.rs`, `forces.rs` |
//! | a drawing from nothing to texts; the picture of what does not move yet | `drawn.rs`, `still.rs` |
//! | gestures to changes of the texts | `edit` |
//! | a connection: newest look first | `socket.rs`, `mailbox.rs`, `time_limit.rs` |
//! | what `check` finds once nothing changes | `check.rs`, `checker.rs` |
//! | studies and single runs in the background | `jobs.rs`, `job.rs` |
//! | messages, over the live connection and of plain requests | `messages`, `requests.rs` |
//!
//! The front end stands in `front`, written in TypeScript and Svelte; its built files in `assets` are checked in.

#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]

mod drawing;
mod edit;
mod files;
mod jobs;
#[cfg(test)]
mod length_tests;
mod messages;
mod network;
mod studio;
mod view;

pub use network::server::{Serving, StudioError, serve, serve_within};
pub use network::times::Timeouts;
pub use network::token::Token;
