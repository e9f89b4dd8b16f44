//! Limits of the operating system for the process: its memory, its stack, and the size of its files.
//!
//! When a limit is reached, the program prints a message and ends with a defined exit status. Without this file, Rust would abort when
//! memory runs out or where the stack is small, and the system would kill the process when a file grows too large.
#![allow(
    unsafe_code,
    reason = "an allocator, a signal and an option of the C library are set by functions that nothing checks"
)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Exit status after a failed allocation.
pub const OUT_OF_MEMORY_STATUS: u8 = 4;

/// The message after a failed allocation: the text before and after the amount refused.
const MESSAGE: [&[u8]; 2] = [
    b"error: out of memory: the system refused ",
    b"\n\
      hint: raise the memory limit (ulimit -v, ulimit -d, or the limit of the container), or use fewer --threads or samples; \
      saved runs of a study are kept: --resume continues with them\n",
];
/// Digits of the largest number of bytes.
const MAX_DIGITS: usize = 20;

#[global_allocator]
static ALLOCATOR: EndingAllocator = EndingAllocator;

/// The allocator of the system. If it fails, the process ends.
struct EndingAllocator;

// SAFETY: each function is that of `System`, with the same arguments, and gives what that gives; `end_without_memory` does not return,
// does not unwind and does not allocate.
unsafe impl GlobalAlloc for EndingAllocator {
    #[inline]
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller keeps the rules of `GlobalAlloc`, which are those of `System`.
        found(unsafe { System.alloc(layout) }, layout.size())
    }

    #[inline]
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as in `alloc`.
        found(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    #[inline]
    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, new_size: usize) -> *mut u8 {
        // SAFETY: as in `alloc`; `pointer` came from here, and so from `System`.
        found(unsafe { System.realloc(pointer, layout, new_size) }, new_size)
    }

    #[inline]
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as in `realloc`.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[inline(always)]
fn found(pointer: *mut u8, bytes: usize) -> *mut u8 {
    if pointer.is_null() {
        end_without_memory(bytes);
    }
    pointer
}

#[cold]
#[inline(never)]
fn end_without_memory(bytes: usize) -> ! {
    end([decimal(bytes, &mut [0; MAX_DIGITS]), b" bytes"])
}

/// Prints the amount refused, and ends the process. Nothing is allocated, unwound or flushed: finished runs are in the store, and an
/// unfinished result is marked as unfinished.
fn end(refused: [&[u8]; 2]) -> ! {
    static IS_ENDING: AtomicBool = AtomicBool::new(false);
    if IS_ENDING.swap(true, Ordering::Relaxed) {
        // Another thread is writing the message, and ends the process.
        loop {
            std::thread::sleep(Duration::from_secs(1));
        }
    }
    system::end([MESSAGE[0], refused[0], refused[1], MESSAGE[1]], OUT_OF_MEMORY_STATUS)
}

/// Whether a panic means that the standard library found no memory for a new thread. This panic aborts the process. The caller that
/// starts the thread cannot prevent it, because the thread already exists.
fn is_about_memory_of_a_thread(panic: &str) -> bool {
    panic.starts_with("failed to allocate an alternative stack")
        || panic.starts_with("failed to set up alternative stack guard page")
}

/// Ends the process with a message if a new thread finds no memory; any other panic is reported as usual.
fn tell_threads_without_memory() {
    let otherwise = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if panic.payload_as_str().is_some_and(is_about_memory_of_a_thread) {
            end([b"the stack ", b"of a thread"]);
        }
        otherwise(panic);
    }));
}

/// `number` in decimal digits, at the end of `digits`.
fn decimal(mut number: usize, digits: &mut [u8; MAX_DIGITS]) -> &[u8] {
    let mut begin = MAX_DIGITS;
    loop {
        begin -= 1;
        digits[begin] = b'0' + (number % 10) as u8;
        number /= 10;
        if number == 0 {
            return &digits[begin..];
        }
    }
}

/// Smallest stack of the main thread on which the program works, bytes: all other threads have this one, whatever `ulimit -s` says.
const MIN_STACK_BYTES: u64 = 2 << 20;
/// Stack of the thread that takes its place, bytes: what systems usually give the main thread.
const STACK_BYTES: usize = 8 << 20;

/// Calls `work` on the main thread, or on a thread of its own where the stack of the main thread is limited to less (`ulimit -s`).
pub fn with_enough_stack(work: fn() -> ExitCode) -> ExitCode {
    if system::stack_limit_bytes().is_none_or(|limit| limit >= MIN_STACK_BYTES) {
        return work();
    }
    match std::thread::Builder::new().name("main".to_owned()).stack_size(STACK_BYTES).spawn(work) {
        Ok(thread) => thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
        // No thread: the stack of this one may be large enough.
        Err(_) => work(),
    }
}

/// Prepares the process, before anything is written and before a second thread is started.
pub fn prepare() {
    system::prepare();
    tell_threads_without_memory();
}

#[cfg(unix)]
mod system {
    /// Writes `parts` to standard error and ends the process with `status`.
    pub fn end(parts: [&[u8]; 4], status: u8) -> ! {
        // SAFETY: it takes a number and gives one.
        let is_terminal = unsafe { libc::isatty(libc::STDERR_FILENO) } == 1;
        // A progress bar may be on the current line of the terminal.
        let begin: &[u8] = if is_terminal { b"\n" } else { b"" };
        for part in std::iter::once(begin).chain(parts) {
            // SAFETY: the pointer and the length are those of a slice. A failed write is ignored.
            let _ = unsafe { libc::write(libc::STDERR_FILENO, part.as_ptr().cast(), part.len()) };
        }
        // SAFETY: it ends the process at once and runs nothing of ours.
        unsafe { libc::_exit(i32::from(status)) }
    }

    /// Makes a write beyond the file size limit (`ulimit -f`) fail like a write to a full disk, and limits the address space that the C
    /// library reserves.
    pub fn prepare() {
        // SAFETY: no function of ours is set as a handler, and no other thread sets this one.
        unsafe { libc::signal(libc::SIGXFSZ, libc::SIG_IGN) };
        #[cfg(all(target_os = "linux", target_env = "gnu"))]
        bound_arenas();
    }

    /// The limit of the main thread's stack, bytes (`ulimit -s`); `None` if there is none.
    pub fn stack_limit_bytes() -> Option<u64> {
        let mut limit = libc::rlimit { rlim_cur: libc::RLIM_INFINITY, rlim_max: libc::RLIM_INFINITY };
        // SAFETY: the pointer is that of a value of the type that is asked for.
        let is_known = unsafe { libc::getrlimit(libc::RLIMIT_STACK, &raw mut limit) } == 0;
        (is_known && limit.rlim_cur != libc::RLIM_INFINITY).then_some(limit.rlim_cur)
    }

    /// If the address space is limited, lets glibc reserve only a part of it for threads.
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    fn bound_arenas() {
        use loosepin::study::{ARENA_BYTES, ARENAS_PART, MAX_ARENAS};
        let mut limit = libc::rlimit { rlim_cur: libc::RLIM_INFINITY, rlim_max: libc::RLIM_INFINITY };
        // SAFETY: the pointer is that of a value of the type that is asked for.
        let is_known = unsafe { libc::getrlimit(libc::RLIMIT_AS, &raw mut limit) } == 0;
        if is_known && limit.rlim_cur != libc::RLIM_INFINITY {
            let arenas = (limit.rlim_cur / ARENAS_PART / ARENA_BYTES).clamp(1, MAX_ARENAS);
            // SAFETY: an option of the allocator, set before a second thread is started.
            unsafe { libc::mallopt(libc::M_ARENA_MAX, arenas as i32) };
        }
    }
}

#[cfg(not(unix))]
mod system {
    /// Writes `parts` to standard error and ends the process with `status`.
    pub fn end(parts: [&[u8]; 4], status: u8) -> ! {
        use std::io::Write;
        for part in parts {
            let _ = std::io::stderr().write_all(part);
        }
        std::process::exit(i32::from(status))
    }

    /// Does nothing: other systems have no such limits.
    pub fn prepare() {}

    /// Other systems have none that can be set.
    pub fn stack_limit_bytes() -> Option<u64> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{MAX_DIGITS, decimal, is_about_memory_of_a_thread};

    #[test]
    fn a_number_of_bytes_is_written_without_memory() {
        for (number, text) in [(0, "0"), (7, "7"), (983_268, "983268"), (usize::MAX, "18446744073709551615")] {
            assert_eq!(decimal(number, &mut [0; MAX_DIGITS]), text.as_bytes());
        }
    }

    /// The messages of the standard library. If it changes them, such a thread aborts the process again.
    #[test]
    fn a_thread_without_memory_is_told_from_other_panics() {
        let words = "failed to allocate an alternative stack: Cannot allocate memory (os error 12)";
        assert!(is_about_memory_of_a_thread(words));
        assert!(!is_about_memory_of_a_thread("index out of bounds"));
    }
}
