//! How work in space is stopped.

use std::cell::Cell;

/// Whether the work is to end where it is: asked at each step of it, and cheap.
pub type IsStopped<'a> = &'a dyn Fn() -> bool;

/// Of work that nobody stops.
pub(crate) const NEVER: IsStopped<'static> = &|| false;

/// Stops after `most` questions, or where `is_stopped` does: of work that may cost no more.
pub fn stop_after(most: u64, is_stopped: IsStopped) -> impl Fn() -> bool {
    let asked = Cell::new(0_u64);
    move || {
        asked.set(asked.get() + 1);
        asked.get() > most || is_stopped()
    }
}
