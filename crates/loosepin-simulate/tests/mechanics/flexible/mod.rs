//! Mechanisms with flexible links: against histories of another program, energy, and other formulations.

mod histories;
