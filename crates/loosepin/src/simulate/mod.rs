//! One run: steps, events, contact states, outputs.

pub mod record;
