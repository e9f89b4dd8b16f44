//! Progress of a study or an identification, on a terminal.

use std::fmt::Write;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle, WeakProgressBar};
use loosepin::report::draft_text;
use loosepin::study::Progress;
use loosepin::study::result::Draft;
use loosepin::units::duration_words;

use crate::console::message;

/// Interval between updates of the remaining time.
const TICK: Duration = Duration::from_millis(500);

/// A progress bar with the remaining time on standard error; it shows nothing if that is not a terminal.
pub struct Bar {
    bar: ProgressBar,
    pace: Arc<Mutex<Pace>>,
}

/// Number of finished runs over time. Runs are reported in batches, so a rate between two reports would fluctuate.
struct Pace {
    began: Instant,
    /// Runs of an earlier call; they took no time in this one.
    kept: usize,
    last: Option<(Instant, usize, usize)>,
}

impl Pace {
    /// Runs finished in this call.
    fn made(&self) -> usize {
        self.last.map_or(0, |(_, finished, _)| finished.saturating_sub(self.kept))
    }

    /// Remaining time at the mean rate up to the last report; `None` before the first runs are finished.
    fn remaining_s(&self) -> Option<f64> {
        let (reported, finished, most) = self.last.filter(|_| self.made() > 0)?;
        let seconds_a_run = (reported - self.began).as_secs_f64() / self.made() as f64;
        Some((seconds_a_run * most.saturating_sub(finished) as f64 - reported.elapsed().as_secs_f64()).max(0.0))
    }
}

impl Bar {
    /// A bar that is empty until the first report.
    pub fn new() -> Bar {
        Bar::resumed(0)
    }

    /// A bar of a study that continues with `kept` finished runs.
    pub fn resumed(kept: usize) -> Bar {
        Bar::of("runs", kept)
    }

    /// A bar that counts values of the unknowns; each value has many runs.
    pub fn of_values() -> Bar {
        Bar::of("values", 0)
    }

    /// A bar that counts `counted` and begins with `kept` of them.
    fn of(counted: &str, kept: usize) -> Bar {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
        let pace = Arc::new(Mutex::new(Pace { began: Instant::now(), kept, last: None }));
        let shown = Arc::clone(&pace);
        let remaining = move |_: &ProgressState, text: &mut dyn Write| {
            let remaining_s = shown.lock().ok().and_then(|pace| pace.remaining_s());
            let _ = match remaining_s {
                None => write!(text, "the first runs have started"),
                Some(remaining_s) => write!(text, "at most {} left", duration_words(remaining_s)),
            };
        };
        // The template is fixed, so that the plain bar is never needed.
        let template = format!("[{{bar:30}}] {{pos}} of at most {{len}} {counted}, {{remaining}}{{msg}}");
        let style = ProgressStyle::with_template(&template)
            .unwrap_or_else(|_| ProgressStyle::default_bar())
            .with_key("remaining", remaining);
        bar.set_style(style.progress_chars("=> "));
        Bar { bar, pace }
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// Updates the remaining time until the bar is removed. If the system provides no thread, the time is updated when runs are reported.
/// (The bar's own ticking would panic in this case.)
fn tick(bar: WeakProgressBar) {
    let ticks = move || {
        while let Some(bar) = bar.upgrade().filter(|bar| !bar.is_finished()) {
            bar.tick();
            drop(bar);
            thread::sleep(TICK);
        }
    };
    let _ = thread::Builder::new().name("loosepin-bar".to_owned()).spawn(ticks);
}

impl Progress for Bar {
    fn runs(&self, finished: usize, most: usize) {
        if let Ok(mut pace) = self.pace.lock() {
            pace.last = Some((Instant::now(), finished, most));
        }
        if self.bar.length().is_none() && !self.bar.is_hidden() {
            tick(self.bar.downgrade());
        }
        self.bar.set_length(most as u64);
        self.bar.set_position(finished as u64);
    }

    fn wants_drafts(&self) -> bool {
        !self.bar.is_hidden()
    }

    fn draft(&self, draft: &Draft) {
        let text = draft_text(draft);
        if !text.is_empty() {
            self.bar.set_message(format!("\n{text}"));
        }
    }

    fn note(&self, text: &str) {
        self.bar.suspend(|| message(&format!("note: {text}")));
    }
}

#[cfg(test)]
mod tests {
    use super::{Duration, Instant, Pace};

    #[test]
    fn kept_runs_have_taken_no_time_and_more_runs_than_foreseen_leave_none() {
        let began = Instant::now();
        let reported = began + Duration::from_secs(3600);
        let pace = |kept, finished, most| Pace { began, kept, last: Some((reported, finished, most)) };
        // 300 of 400 runs are from an earlier call: 100 runs took one hour, so 200 more take two.
        let remaining_s = pace(300, 400, 600).remaining_s().unwrap();
        assert_eq!(remaining_s, 7200.0, "the report is not yet behind");
        assert_eq!(pace(300, 400, 600).made(), 100);
        assert_eq!(pace(0, 700, 600).remaining_s(), Some(0.0));
        assert_eq!(pace(300, 300, 600).remaining_s(), None);
    }
}
