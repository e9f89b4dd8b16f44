//! Position of a drive in the message of a failure.

use crate::mechanism::error::DrivePlace;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::{CycleSpan, Model};

/// The drive that the cycle counts, or else the first one, at the `coordinates` of the tree. `None` without drives.
pub fn drive_place(model: &Model, tree: &Tree, coordinates: &[f64]) -> Option<Box<DrivePlace>> {
    let counted = match model.cycle.span {
        CycleSpan::Turns(drive) | CycleSpan::Periods(drive) => Some(drive),
        CycleSpan::Duration(_) => None,
    };
    let k = counted.and_then(|drive| tree.drives.iter().position(|own| *own == drive)).unwrap_or(0);
    let drive = &model.drives[tree.drives.get(k)?.0];
    let dimension = model.joints[drive.joint.0].kind.coordinate()?;
    let position_si = *coordinates.get(tree.free + k)?;
    Some(Box::new(DrivePlace { drive: drive.name.clone(), position_si, dimension }))
}
