//! Wear of joints by Archard's law, dV = k F_N |v_T| dt on each surface, with the unworn geometry or with the worn one
//! (`docs/theory/wear.md`).

mod joint;
mod jumps;
mod life;
mod life_record;
mod profile;
mod recorder;
mod result;

pub use joint::WearingJoint;
pub use jumps::{Cycle, Depths, JumpLength, Life, LifePoint, life};
pub use life::{LifePlan, worn_life};
pub use life_record::{wear_life_csv, wear_profiles_csv};
pub use profile::WearProfile;
pub use recorder::WearRecorder;
pub use result::wear_csv;
