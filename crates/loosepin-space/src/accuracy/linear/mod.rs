//! The largest value of a linear function over all places of journals within their play.
//!
//! | What | File |
//! |---|---|
//! | over balls, and over those of their places that meet conditions together, by inner points | `slice.rs` |
//! | one condition: its multiplier directly | `one_plane.rs` |
//! | the conditions | `planes.rs` |
//! | of places that are equally good the nearest one | `near.rs` |
//! | sums of components | `vectors.rs` |

pub(crate) mod near;
mod one_plane;
pub(crate) mod planes;
pub(crate) mod slice;
pub(crate) mod vectors;
