//! How far a study is, on a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use loosepin::study::Progress;

/// How often the remaining time is shown anew.
const TICK: Duration = Duration::from_millis(500);

/// A bar with the remaining time on standard error; nothing where that is no terminal.
pub struct Bar(ProgressBar);

impl Bar {
    /// A bar that shows nothing before it hears of runs.
    pub fn new() -> Bar {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
        // The template is fixed, so that the plain bar is never needed.
        let style = ProgressStyle::with_template("{bar:30} {pos} of at most {len} runs, {eta} left")
            .unwrap_or_else(|_| ProgressStyle::default_bar());
        bar.set_style(style.progress_chars("=> "));
        Bar(bar)
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.0.finish_and_clear();
    }
}

impl Progress for Bar {
    fn runs(&self, finished: usize, most: usize) {
        if self.0.length().is_none() {
            self.0.enable_steady_tick(TICK);
        }
        self.0.set_length(most as u64);
        self.0.set_position(finished as u64);
    }
}
