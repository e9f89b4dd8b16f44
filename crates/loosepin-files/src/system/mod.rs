//! The calls of the operating system: files and folders by their names in an open directory.
//!
//! On Unix these are the `*at` calls on a directory handle, without following links. Elsewhere the folder is a path, and links are looked
//! for before each call: that leaves a moment between the look and the call.

#[cfg(any(not(unix), test))]
#[cfg_attr(unix, allow(dead_code, reason = "tested on Unix, used elsewhere"))]
mod portable;
#[cfg(unix)]
mod unix;

#[cfg(not(unix))]
pub use portable::{Directory, file_info, is_file_size_limited, keep_owner_and_mode, open_named};
#[cfg(unix)]
pub use unix::{Directory, file_info, is_file_size_limited, keep_owner_and_mode, open_named};
