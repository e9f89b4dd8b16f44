//! The mobility of a mechanism in a position.

use crate::closure::loops::Loops;
use crate::closure::position::Position;
use crate::closure::singular::{RANK_THRESHOLD, ratio};
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::mobility::idle::{IdleMotion, idle_motions};
use loosepin_math::SingularValues;
use loosepin_text::units::counted_or_no;

/// The part of a joint in a combination of rows that is always met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RedundantShare {
    /// Number of the joint; a drive counts with its joint.
    pub joint: usize,
    /// Sum of squares of the rows that are lengths: what the joint holds by forces.
    pub of_forces: f64,
    /// Sum of squares of the rows that are angles: what it holds by moments.
    pub of_moments: f64,
}

/// A combination of rows that is always met: a state of stress without loads. Its squares add up to 1.
#[derive(Debug, Clone, PartialEq)]
pub struct RedundantDirection {
    /// The joints that take part, largest share first.
    pub shares: Vec<RedundantShare>,
}

/// How a mechanism can move in a position, from the ranks of its loop equations there.
#[derive(Debug, Clone, PartialEq)]
pub struct Mobility {
    /// Rows of all joints, without drives.
    pub rows: usize,
    /// Rank of these rows.
    pub rank: usize,
    /// Smallest singular value of these rows that counts, over the largest.
    pub smallest_counted: f64,
    /// Largest singular value of these rows that does not count, over the largest; 0 if all count. Parts that are only nearly redundant have one
    /// that counts and is small: numbers with few digits do that.
    pub largest_uncounted: f64,
    /// 6 × bodies - rank: degrees of freedom of the mechanism, idle ones among them.
    pub degrees_of_freedom: usize,
    /// 6 × bodies - rows, which may be negative: what is left where no row repeats another (Grübler).
    pub counted_freedoms: isize,
    /// rows - rank, a basis of the combinations that are always met. Which single row is redundant has no answer where there are several.
    pub redundant: Vec<RedundantDirection>,
    /// Drives.
    pub drives: usize,
    /// Drives that repeat others or what the joints hold.
    pub repeated_drives: usize,
    /// Freedoms left with all drives held, idle ones of single parts not counted.
    pub undriven_freedoms: usize,
    /// Parts that move alone with all drives held.
    pub idle: Vec<IdleMotion>,
}

impl Mobility {
    /// Degrees of freedom, drives, and whether they determine the motion: `1 degree of freedom, 1 drive: the motion is determined`.
    pub fn words(&self) -> String {
        format!(
            "{}, {}: {}",
            counted_or_no(self.degrees_of_freedom, "degree of freedom", "degrees of freedom"),
            counted_or_no(self.drives, "drive", "drives"),
            self.determined()
        )
    }

    fn determined(&self) -> String {
        let repeated = self.repeated_drives;
        match (self.undriven_freedoms, repeated) {
            (0, 0) => "the motion is determined".to_owned(),
            (0, _) => format!(
                "{} what the joints or other drives hold",
                if repeated == 1 { "a drive repeats" } else { "drives repeat" }
            ),
            (free, _) => format!("{} without a drive", counted_or_no(free, "freedom is left", "freedoms are left")),
        }
    }
}

/// Mobility in a closed position.
pub fn mobility(mechanism: &SpatialMechanism, position: &Position) -> Mobility {
    let loops = Loops::new(mechanism);
    let jacobian = loops.jacobian(&loops.frames(&position.poses, &[]));
    let (unknowns, rows) = (loops.unknowns(), loops.joint_rows());
    let of_joints = SingularValues::new(&jacobian[..rows * unknowns], rows, unknowns);
    let rank = of_joints.rank(RANK_THRESHOLD);
    let drives = mechanism.drives().len();
    let idle = idle_motions(&loops, &jacobian, &position.poses);
    let left = unknowns - position.rank;
    let largest_and_next = of_joints.values().first().zip(of_joints.values().get(rank));
    let largest_uncounted = largest_and_next.map_or(0.0, |(largest, next)| next / largest);
    Mobility {
        rows,
        rank,
        smallest_counted: ratio(&of_joints, rank),
        largest_uncounted,
        degrees_of_freedom: unknowns - rank,
        counted_freedoms: unknowns as isize - rows as isize,
        redundant: of_joints.left_null_space(rank).iter().map(|null| direction(&loops, null)).collect(),
        drives,
        repeated_drives: (drives + rank).saturating_sub(position.rank),
        undriven_freedoms: left.saturating_sub(idle.len()),
        idle,
    }
}

fn direction(loops: &Loops, null: &[f64]) -> RedundantDirection {
    let joints = 0..loops.mechanism.joints().len();
    let mut shares: Vec<RedundantShare> =
        joints.map(|joint| RedundantShare { joint, of_forces: 0.0, of_moments: 0.0 }).collect();
    for (row, entry) in loops.rows.iter().zip(null) {
        let share = &mut shares[row.joint];
        if row.row.is_length() {
            share.of_forces += entry * entry;
        } else {
            share.of_moments += entry * entry;
        }
    }
    shares.retain(|share| share.of_forces + share.of_moments > RANK_THRESHOLD);
    shares.sort_by(|a, b| (b.of_forces + b.of_moments).total_cmp(&(a.of_forces + a.of_moments)));
    RedundantDirection { shares }
}
