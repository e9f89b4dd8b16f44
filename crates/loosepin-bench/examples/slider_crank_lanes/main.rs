//! Runs of the slider-crank of `cases/slider_crank_5000` by a kernel written by hand for it, on one thread: how far the library, which
//! takes any mechanism, is from what can be had for one. A part of `tools/compare`, whose README has the comparison.
//!
//! `slider_crank_lanes --runs N` prints one line, `{"runs":N,"seconds":S,"evaluations_per_run":E,..}`, S the processor time of all
//! runs; `slider_crank_lanes --history` prints the nominal run as a table of `time_s,slider_x_m`; `slider_crank_lanes --accuracy` prints
//! errors over 41 clearances against a run with a far smaller tolerance. With `--bare` before it, `--runs` leaves readings and energy
//! accounts out; the motion is the same to the last bit.
//!
//! By hand are the equations (few operations, one reciprocal, no root, no sine: `equations.rs`), the order of the sums (`step.rs`), a
//! decision on all lanes at once wherever no contact begins or ends, and constants of the step control tuned for this case (`step.rs`,
//! `batch.rs`). As in the library are the method (DOP853 on the root of the penetration, events met by the end of a step), 1,000 readings
//! a turn by quintic polynomials, work of the drive and loss of the contact integrated along, the energy account closed at each step.
//!
//! Left out is what a library owes its users: any other mechanism, law, drive, friction or output; that a failed run is a result and not the
//! end of the program; records of penetration, force and impacts; equal bits on processors without AVX-512; an end of the run that is met
//! exactly (the last step goes beyond, and the last reading lies inside).

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

#[cfg(target_arch = "x86_64")]
mod batch;
#[cfg(target_arch = "x86_64")]
mod equations;
#[cfg(target_arch = "x86_64")]
mod event;
#[cfg(target_arch = "x86_64")]
mod model;
#[cfg(target_arch = "x86_64")]
mod program;
#[cfg(target_arch = "x86_64")]
mod step;
#[cfg(all(test, target_arch = "x86_64"))]
mod tests;
#[cfg(target_arch = "x86_64")]
mod vector;

use std::process::ExitCode;

fn main() -> ExitCode {
    #[cfg(target_arch = "x86_64")]
    {
        program::run()
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        eprintln!("error: this program needs a processor with AVX-512");
        ExitCode::FAILURE
    }
}
