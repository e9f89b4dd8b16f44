//! Messages between the page and the server over the live connection, as JSON. `front/src/messages.ts` has the same types, and `just
//! studio-messages` writes them there.
//!
//! | What | File |
//! |---|---|
//! | the messages themselves, looks and drags | `live.rs` |
//! | places, changes and diagnostics | `diagnostics.rs` |
//! | the mechanism: drawing, outline, numbers | `view.rs` |
//! | jobs | `jobs.rs` |

mod diagnostics;
mod jobs;
mod live;
mod view;

pub use diagnostics::{Change, DiagnosticView, Document, Fix, LabelView, Stretch};
pub use jobs::{Job, JobDraft, JobKind, JobState};
pub use live::{CheckAnswer, DragResult, FromPage, Grip, Held, Look, LookAnswer, SentText, Shown, ToPage};
pub use view::{
    BodyView, DimensionKind, DimensionView, ForceTable, ForceView, JointView, LimitView, Outline, OutputView, PinView,
    PointView, QuantityKind, QuantityView, View,
};
