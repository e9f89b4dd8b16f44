//! What the page and the server say to each other over the live connection, as JSON. `front/src/messages.ts` has the same types, and
//! `just studio-messages` writes them there.
//!
//! | What | File |
//! |---|---|
//! | the messages themselves, looks and drags | `live.rs` |
//! | places, changes and complaints | `complaints.rs` |
//! | the mechanism: drawing, outline, numbers | `view.rs` |
//! | jobs | `jobs.rs` |

mod complaints;
mod jobs;
mod live;
mod view;

pub use complaints::{Change, Document, Fix, SeenComplaint, SeenLabel, Stretch};
pub use jobs::{Job, JobDraft, JobKind, JobState};
pub use live::{FromPage, Grip, Held, Look, Reshaped, Seen, SentText, Shown, ToPage};
pub use view::{
    DimensionKind, ForceTable, Outline, QuantityKind, SeenBody, SeenDimension, SeenForce, SeenJoint, SeenLimit,
    SeenOutput, SeenPin, SeenPoint, SeenQuantity, View,
};
