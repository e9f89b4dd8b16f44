//! Detects a closed standard output.
//!
//! If a program is started without standard output (`loosepin ... >&-`), Rust opens `/dev/null` in its place before `main`, and
//! printed text is lost without an error. Only a function that the loader calls earlier can detect this.
#![allow(unsafe_code, reason = "an entry in the list of functions that the loader calls before `main`")]

use std::io;
#[cfg(any(target_os = "linux", target_os = "macos"))]
use std::os::fd::AsFd;
use std::sync::atomic::{AtomicBool, Ordering};

static WAS_CLOSED: AtomicBool = AtomicBool::new(false);

/// Error number when a descriptor that is not open is duplicated.
#[cfg(any(target_os = "linux", target_os = "macos"))]
const NOT_OPEN: i32 = 9; // EBADF

/// Sound: the list holds pointers to functions of this type, and this one takes nothing, gives nothing and does not unwind.
#[cfg(any(target_os = "linux", target_os = "macos"))]
#[used]
#[cfg_attr(target_os = "linux", unsafe(link_section = ".init_array"))]
#[cfg_attr(target_os = "macos", unsafe(link_section = "__DATA,__mod_init_func"))]
static LOOK: extern "C" fn() = look;

#[cfg(any(target_os = "linux", target_os = "macos"))]
extern "C" fn look() {
    let copy = io::stdout().as_fd().try_clone_to_owned();
    WAS_CLOSED.store(copy.is_err_and(|error| error.raw_os_error() == Some(NOT_OPEN)), Ordering::Relaxed);
}

/// Checks that standard output was open at the start.
///
/// # Errors
/// The program was started without standard output.
pub fn check() -> Result<(), io::Error> {
    if WAS_CLOSED.load(Ordering::Relaxed) { Err(io::Error::other("it is closed")) } else { Ok(()) }
}
