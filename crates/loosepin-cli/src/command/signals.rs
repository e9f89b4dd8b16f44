//! Ctrl-C.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::console;

/// A flag set by the first Ctrl-C; the second ends the program at once. `without` is the warning if no handler can be installed.
pub fn stop_on_signals(without: &str) -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&stop);
    let handler = move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    };
    if let Err(error) = ctrlc::set_handler(handler) {
        console::message(&format!("warning: {without}: {error}"));
    }
    stop
}
