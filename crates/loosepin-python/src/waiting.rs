//! Long work on a thread of its own, while the thread of Python listens to Ctrl-C.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use loosepin::study::Progress;
use pyo3::prelude::*;

/// Interval at which Python is asked for signals and given the progress.
const TICK: Duration = Duration::from_millis(100);

/// How far the work is, for a callable of Python.
#[derive(Default)]
pub struct RunCounts {
    finished: AtomicUsize,
    most: AtomicUsize,
}

impl Progress for RunCounts {
    fn runs(&self, finished: usize, most: usize) {
        self.most.store(most, Ordering::Relaxed);
        self.finished.fetch_max(finished, Ordering::Relaxed);
    }
}

impl RunCounts {
    /// What is said of runs that were interrupted and are not kept.
    pub fn interrupted(&self) -> String {
        let [finished, most] = [&self.finished, &self.most].map(|count| count.load(Ordering::Relaxed));
        format!("interrupted after {finished} of {most} runs; nothing is kept")
    }

    /// Tells `listener`, where there is one and runs are known of.
    pub fn tell(&self, py: Python<'_>, listener: Option<&Py<PyAny>>) -> PyResult<()> {
        let most = self.most.load(Ordering::Relaxed);
        match listener.filter(|_| most > 0) {
            Some(listener) => listener.call1(py, (self.finished.load(Ordering::Relaxed), most)).map(drop),
            None => Ok(()),
        }
    }
}

/// Does `work` on another thread without the lock of the interpreter. Meanwhile this thread lets Python handle signals and calls
/// `each_tick`; what either raises sets `stop`, and is given back when the work has ended.
pub fn wait_for<T: Send>(
    py: Python<'_>,
    stop: &AtomicBool,
    each_tick: impl Fn(Python<'_>) -> PyResult<()> + Send + Sync,
    work: impl FnOnce() -> T + Send,
) -> (T, Option<PyErr>) {
    py.detach(|| {
        thread::scope(|scope| {
            let (done, is_done) = channel();
            let worker = scope.spawn(move || {
                let result = work();
                // Nobody listens any more once this thread has been joined.
                let _ = done.send(());
                result
            });
            let mut raised = None;
            while is_done.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
                if raised.is_none() {
                    raised = Python::attach(|py| py.check_signals().and_then(|()| each_tick(py))).err();
                    stop.fetch_or(raised.is_some(), Ordering::Relaxed);
                }
            }
            let result = worker.join().unwrap_or_else(|panic| resume_unwind(panic));
            (result, raised)
        })
    })
}

/// `work` without the lock of the interpreter, with a flag that a signal sets: the work then ends soon, and what the signal raises comes.
pub fn until_interrupted<T: Send>(py: Python<'_>, work: impl FnOnce(&AtomicBool) -> T + Send) -> PyResult<T> {
    let stop = AtomicBool::new(false);
    let (result, raised) = wait_for(py, &stop, |_| Ok(()), || work(&stop));
    raised.map_or(Ok(result), Err)
}

/// `work` without the lock of the interpreter; what a signal raises comes when it has ended.
pub fn without_gil<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let (result, raised) = wait_for(py, &AtomicBool::new(false), |_| Ok(()), work);
    raised.map_or(Ok(result), Err)
}
