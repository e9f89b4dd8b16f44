//! How work in space is stopped.

/// Whether the work is to end where it is: asked at each step of it, and cheap.
pub type IsStopped<'a> = &'a dyn Fn() -> bool;

/// Of work that nobody stops.
pub(crate) const NEVER: IsStopped<'static> = &|| false;
