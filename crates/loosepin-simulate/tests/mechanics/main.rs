//! Mechanics on whole runs: contact laws, elements, guides and slots with play, the quasi-static answer, and the same bits on
//! any lane.

#![allow(clippy::disallowed_methods, reason = "tests make files of their own")]

mod accuracy;
mod balance;
mod case;
mod circular_slot;
mod contact_laws;
mod elements;
mod films;
mod flexible;
mod guide_ends;
mod guide_play;
mod lanes;
mod outputs;
mod power_balance;
mod slot_ends;
mod slot_play;
mod space;
mod spectra;
mod trust;
mod wear;
