//! The turns of a run that are looked at once each (Poincaré section).

use crate::settings::Window;

/// The turns that are looked at, and when they end.
#[derive(Debug, Clone, Copy)]
pub struct Turns {
    /// The recorded part of the run.
    pub window: Window,
    /// Duration of a turn, s.
    pub turn_s: f64,
    /// How many whole turns.
    pub count: usize,
}

impl Turns {
    /// The whole turns of `window`.
    pub fn within(window: Window, turn_s: f64) -> Self {
        /// Share of a turn that round-off may take from the last one.
        const ROUND_OFF: f64 = 1e-9;
        let turns = (window.end_s - window.start_s) / turn_s;
        Self { window, turn_s, count: (turns + ROUND_OFF).floor().max(0.0) as usize }
    }

    /// When turn `index` ends, s: never after the run.
    pub fn end_s(&self, index: usize) -> f64 {
        (self.window.start_s + (index + 1) as f64 * self.turn_s).min(self.window.end_s)
    }
}
