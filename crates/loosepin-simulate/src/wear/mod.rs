//! Wear of joints by Archard's law, dV = k F_N |v_T| dt on each surface, with the unworn geometry (`docs/theory/wear.md`).

mod joint;
mod profile;
mod recorder;
mod result;

pub use joint::WearingJoint;
pub use profile::WearProfile;
pub use recorder::WearRecorder;
pub use result::{wear_csv, wear_value};
