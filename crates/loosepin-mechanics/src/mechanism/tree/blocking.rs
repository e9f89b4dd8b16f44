//! Reasons why a mechanism cannot close or move whatever its lengths are: drives that move one freedom, joints that block one another.
//!
//! Away from special positions the loop equations J q̇ = 0 of a sound mechanism are independent of one another, also where the drives
//! stand still. A combination λ of them with λᵀJ = 0 in the columns of the free coordinates says what the drives alone must keep: where it
//! holds two drives, these move one freedom; where it holds none, the joints of its loops contradict one another.

use crate::mechanism::loops::constraints::{self, RowOwner};
use crate::mechanism::tree::kinematics::Kinematics;
use crate::mechanism::tree::mobility::{RANK_TOLERANCE, Scale};
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::{DriveId, JointId, Model};
use loosepin_math::Elimination;
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::{counted, quoted};

/// Positions that are tried: one may be special by chance.
const POSITIONS: usize = 3;
/// Entries of a combination below this share of its largest are round-off of the elimination.
const ROUND_OFF: f64 = 1e-9;
/// Coordinates of mechanisms that are looked at: the combinations of larger ones take too long for a message.
const MAX_COORDINATES: usize = 300;

problems! {
    /// The reason why a mechanism cannot close or move.
    #[derive(Debug, Clone, PartialEq)]
    pub enum Blocking {
        Drives { drives: Vec<String> } => Code::DrivesOnOneFreedom,
            says("the drives {} move the same degree of freedom: one of them already determines the position of the links",
                quoted(drives)),
            hint("keep one of them, and use the other for a joint with another degree of freedom");
        Joints { joints: Vec<String> } => Code::JointsBlock,
            says("the joints {} block one another: with general lengths, their bodies cannot move",
                quoted(joints)),
            hint("remove one of the {}, or use a joint with more freedom, such as a slot; redundant joints, such as those of a third \
                  parallel crank, need lengths that agree to all digits", counted(joints.len(), "joint"));
    }
}

/// The reason why `model` cannot close or move at general lengths, if there is one.
pub(in crate::mechanism) fn blocking(model: &Model) -> Option<Blocking> {
    let values = model.quantities.nominal();
    let tree = Tree::new(model, |_| true).ok()?;
    let (rows, columns) = (tree.constraint_rows(), tree.coordinates());
    if rows == 0 || columns > MAX_COORDINATES {
        return None;
    }
    let geometry = TreeNumbers::new(model, &tree, &values);
    let size_m = model.largest_extent_m(&values);
    let scale = Scale::new(&tree, size_m);
    let looks = (1..=POSITIONS).map(|position| {
        let mut kinematics = Kinematics::new(&tree);
        kinematics.set_positions(&tree, &geometry, &general_position(&tree, size_m, position));
        let mut jacobian = vec![0.0; rows * columns];
        constraints::jacobian(&tree, &geometry, &kinematics, &mut jacobian);
        let mut residuals = vec![0.0; rows];
        constraints::residuals(&tree, &geometry, &kinematics, &mut residuals);
        let jacobian = scale.dimensionless(&jacobian);
        // Columns of the transposed matrix are rows of the loops.
        let transposed: Vec<f64> = (0..tree.free)
            .flat_map(|column| (0..rows).map(move |row| (row, column)))
            .map(|(row, column)| jacobian[row * columns + column])
            .collect();
        (Elimination::new(&transposed, tree.free, rows, RANK_TOLERANCE), jacobian, residuals)
    });
    let (free, jacobian, residuals) = looks.max_by_key(|(free, ..)| free.rank())?;
    let combinations: Vec<Vec<f64>> =
        free.free_columns().into_iter().map(|row| cleaned(free.null_direction(row))).collect();
    let holds = |combination: &[f64], column: usize| {
        let sum: f64 = (0..rows).map(|row| combination[row] * jacobian[row * columns + column]).sum();
        sum.abs() > ROUND_OFF
    };
    for combination in &combinations {
        let driven: Vec<usize> = (0..tree.drives.len()).filter(|k| holds(combination, tree.free + k)).collect();
        // What repeats itself at every position contradicts nothing.
        let gap: f64 = (0..rows).map(|row| combination[row] * residuals[row]).sum();
        if driven.len() >= 2 {
            let mut ids: Vec<DriveId> = driven.iter().map(|k| tree.drives[*k]).collect();
            ids.sort();
            let drives = ids.iter().map(|id| model.drives[id.0].name.clone()).collect();
            return Some(Blocking::Drives { drives });
        }
        if !driven.is_empty() || gap.abs() > ROUND_OFF * size_m {
            let joints = joints_of(model, &tree, combination);
            return Some(Blocking::Joints { joints });
        }
    }
    None
}

/// Coordinates that no two bodies share: multiples of irrational numbers.
fn general_position(tree: &Tree, size_m: f64, position: usize) -> Vec<f64> {
    let spread = |coordinate: usize| {
        (position as f64 * 0.618_033_988_749_895 + coordinate as f64 * 0.414_213_562_373_095).fract()
    };
    let mut z: Vec<f64> =
        (0..tree.coordinates()).map(|coordinate| std::f64::consts::TAU * spread(coordinate)).collect();
    for link in &tree.links {
        link.lengths().for_each(|coordinate| z[coordinate] = size_m * (2.0 * spread(coordinate) - 1.0));
    }
    z
}

/// A combination without round-off, its largest entry 1.
fn cleaned(mut combination: Vec<f64>) -> Vec<f64> {
    let largest = combination.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
    combination
        .iter_mut()
        .for_each(|entry| *entry = if entry.abs() > ROUND_OFF * largest { *entry / largest } else { 0.0 });
    combination
}

/// Names of the joints of the loops that a combination of their equations holds, in file order.
fn joints_of(model: &Model, tree: &Tree, combination: &[f64]) -> Vec<String> {
    let mut holds = vec![false; model.joints.len()];
    for row in (0..combination.len()).filter(|row| combination[*row] != 0.0) {
        let ends = match RowOwner::of(tree, row) {
            RowOwner::Joint(joint) => vec![joint],
            RowOwner::Coupling(index) => vec![model.couplings[index].first, model.couplings[index].second],
        };
        for joint in ends {
            holds[joint.0] = true;
            on_the_way(model, tree, joint).into_iter().for_each(|joint| holds[joint.0] = true);
        }
    }
    model.joints.iter().zip(holds).filter(|(_, holds)| *holds).map(|(joint, _)| joint.name.clone()).collect()
}

/// The joints of the tree on the way from one body of `joint` to the other.
fn on_the_way(model: &Model, tree: &Tree, joint: JointId) -> Vec<JointId> {
    let to_ground = |mut slot: usize| {
        let mut slots = Vec::new();
        while slot > 0 {
            slots.push(slot);
            slot = tree.links[slot - 1].parent_slot;
        }
        slots
    };
    let [first, second] = model.joints[joint.0].kind.bodies().map(|body| to_ground(tree.slot_of_body[body.0]));
    let own =
        first.iter().filter(|slot| !second.contains(slot)).chain(second.iter().filter(|slot| !first.contains(slot)));
    own.filter_map(|slot| tree.links[slot - 1].joint()).map(|(joint, _)| joint).collect()
}
