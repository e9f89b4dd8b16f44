//! What the benches print beside criterion's own lines: work per run, runs per second, nanoseconds per right-hand side.
//!
//! Seconds vary with the machine, counts do not: a change of the work per run shows in
//! [`Throughput::evaluations_per_run`] even where the clock is noisy.

pub mod batch;
pub mod diagram;
pub mod equations;
pub mod known_bounds;
pub mod known_case;
pub mod known_pairings;
pub mod precision;

use std::fmt;
use std::time::Instant;

/// Work and time of a number of equal or similar runs on one thread.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Throughput {
    /// Number of runs.
    pub runs: usize,
    /// Right-hand sides evaluated in all runs together, repeated and rejected steps included.
    pub evaluations: u64,
    /// Wall-clock time of all runs together, s.
    pub elapsed_s: f64,
}

impl Throughput {
    /// Calls `run` for the indices `0..runs`; it gives the number of right-hand sides that the run evaluated. Set-up
    /// belongs outside of it.
    pub fn measure(runs: usize, mut run: impl FnMut(usize) -> u64) -> Self {
        let started = Instant::now();
        let evaluations = (0..runs).map(&mut run).sum();
        Self { runs, evaluations, elapsed_s: started.elapsed().as_secs_f64() }
    }

    /// Runs per second and thread, 1/s.
    pub fn runs_per_second(&self) -> f64 {
        self.runs as f64 / self.elapsed_s
    }

    /// Right-hand sides per run, the mean of all runs.
    pub fn evaluations_per_run(&self) -> f64 {
        self.evaluations as f64 / self.runs as f64
    }

    /// Time per right-hand side, ns.
    pub fn nanoseconds_per_evaluation(&self) -> f64 {
        self.elapsed_s * 1e9 / self.evaluations as f64
    }
}

impl fmt::Display for Throughput {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "{:.0} simulations/s, {:.0} right-hand sides each, {:.1} ns per right-hand side ({} runs, {:.2} s)",
            self.runs_per_second(),
            self.evaluations_per_run(),
            self.nanoseconds_per_evaluation(),
            self.runs,
            self.elapsed_s,
        )
    }
}

/// Processor time of all threads of this process so far, s; none where the system does not tell.
pub fn processor_time_s() -> Option<f64> {
    let mut nanoseconds = 0;
    for thread in std::fs::read_dir("/proc/self/task").ok()? {
        let text = std::fs::read_to_string(thread.ok()?.path().join("schedstat")).ok()?;
        nanoseconds += text.split_whitespace().next()?.parse::<u64>().ok()?;
    }
    Some(nanoseconds as f64 * 1e-9)
}
