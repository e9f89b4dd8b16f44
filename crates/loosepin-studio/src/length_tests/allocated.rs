//! The allocator of the unit tests: that of the system, which counts the bytes that each thread asks for.
#![allow(unsafe_code, reason = "an allocator is made of functions that nothing checks")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    static BYTES: Cell<u64> = const { Cell::new(0) };
}

/// Bytes that this thread has asked for so far; memory that grows counts with its whole new size.
pub fn allocated_bytes() -> u64 {
    BYTES.get()
}

struct CountingAllocator;

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator;

fn count(bytes: usize) {
    // A thread that ends has no count any more.
    let _ = BYTES.try_with(|counted| counted.set(counted.get().wrapping_add(bytes as u64)));
}

// SAFETY: each function is that of `System`, with the same arguments, and gives what that gives; `count` changes a number of the thread,
// which needs no memory and no destructor, and does not unwind.
unsafe impl GlobalAlloc for CountingAllocator {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size());
        // SAFETY: the caller keeps the rules of `GlobalAlloc`, which are those of `System`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(layout.size());
        // SAFETY: as in `alloc`.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, new_size: usize) -> *mut u8 {
        count(new_size);
        // SAFETY: as in `alloc`; `pointer` came from here, and so from `System`.
        unsafe { System.realloc(pointer, layout, new_size) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as in `realloc`.
        unsafe { System.dealloc(pointer, layout) }
    }
}
