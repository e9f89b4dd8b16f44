//! One run: steps, events, contact states, outputs.
