//! The spanning tree: how bodies hang on each other, and which joints close loops.

use core::ops::Range;
use loosepin_mechanics::mechanism::{self, Mechanism};

/// How a body hangs on its parent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Attachment {
    /// By a revolute joint. Where it `turns_alone`, its coordinate is the angle from the ground: the axes of all joints that turn its
    /// parent are parallel to its own. Else it is the angle from the parent.
    Revolute { forward: bool, turns_alone: bool },
    /// By a prismatic joint.
    Prismatic { forward: bool },
    /// By a rigid joint.
    Rigid,
    /// By a ball: its orientation is its own.
    Ball,
    /// On nothing: a position and an orientation.
    Free,
}

impl Attachment {
    /// Whether the angular velocity of the body does not depend on that of its parent.
    pub fn turns_alone(self) -> bool {
        match self {
            Self::Revolute { turns_alone, .. } => turns_alone,
            Self::Ball | Self::Free => true,
            Self::Prismatic { .. } | Self::Rigid => false,
        }
    }
}

/// How many coordinates and speeds a geometry has for a position and for an orientation.
#[derive(Debug, Clone, Copy)]
pub struct Counts {
    pub position: usize,
    pub orientation_coordinates: usize,
    pub orientation_speeds: usize,
}

impl Counts {
    pub const PLANE: Self = Self { position: 2, orientation_coordinates: 1, orientation_speeds: 1 };
    pub const SPACE: Self = Self { position: 3, orientation_coordinates: 4, orientation_speeds: 3 };

    fn of(&self, attachment: Attachment) -> [usize; 2] {
        match attachment {
            Attachment::Revolute { .. } | Attachment::Prismatic { .. } => [1, 1],
            Attachment::Rigid => [0, 0],
            Attachment::Ball => [self.orientation_coordinates, self.orientation_speeds],
            Attachment::Free => [self.orientation_coordinates, self.orientation_speeds].map(|n| n + self.position),
        }
    }
}

/// A moving body.
#[derive(Debug, Clone)]
pub struct Link {
    /// Slot of the parent; 0 is the ground.
    pub parent: usize,
    pub attachment: Attachment,
    pub is_driven: bool,
    /// Its own coordinates and speeds.
    pub coordinates: Range<usize>,
    pub speeds: Range<usize>,
    /// Speeds on which its motion depends: those of the parent, then its own.
    pub dependences: Vec<usize>,
    /// How many of them are the parent's.
    pub inherited: usize,
}

/// Slot i + 1 is `links[i]`. Driven coordinates and speeds stand behind the free ones.
#[derive(Debug, Clone)]
pub struct Tree {
    pub links: Vec<Link>,
    pub free_coordinates: usize,
    pub free_speeds: usize,
    pub driven: usize,
    /// Slots of revolute joints that close loops.
    pub cuts: Vec<[usize; 2]>,
    /// Slots of the joints with play.
    pub plays: Vec<[usize; 2]>,
}

impl Tree {
    /// A tree of `(parent's slot, attachment, whether it is driven)`, parents first.
    pub fn new(
        counts: Counts,
        bodies: &[(usize, Attachment, bool)],
        cuts: Vec<[usize; 2]>,
        plays: Vec<[usize; 2]>,
    ) -> Self {
        let free = |place: usize| bodies.iter().filter(|body| !body.2).map(|body| counts.of(body.1)[place]).sum();
        let (free_coordinates, free_speeds) = (free(0), free(1));
        let (mut next, mut next_driven) = ([0, 0], 0);
        let mut links: Vec<Link> = Vec::new();
        for &(parent, attachment, is_driven) in bodies {
            let [coordinates, speeds] = counts.of(attachment);
            let [coordinate, speed] =
                if is_driven { [free_coordinates + next_driven, free_speeds + next_driven] } else { next };
            if is_driven {
                next_driven += 1;
            } else {
                next = [next[0] + coordinates, next[1] + speeds];
            }
            let mut dependences = if parent == 0 { Vec::new() } else { links[parent - 1].dependences.clone() };
            let inherited = dependences.len();
            dependences.extend(speed..speed + speeds);
            let (coordinates, speeds) = (coordinate..coordinate + coordinates, speed..speed + speeds);
            links.push(Link { parent, attachment, is_driven, coordinates, speeds, dependences, inherited });
        }
        Self { links, free_coordinates, free_speeds, driven: next_driven, cuts, plays }
    }

    /// The tree of a planar mechanism; with angles from the ground, as the program has them, or from the parents.
    pub fn of(mechanism: &Mechanism, counts: Counts, absolute_angles: bool) -> Self {
        use mechanism::Attachment as Planar;
        let real = &mechanism.real;
        let body = |link: &mechanism::Link| {
            let (attachment, coordinate) = match link.attachment {
                Planar::Revolute { coordinate, forward, .. } => {
                    (Attachment::Revolute { forward, turns_alone: absolute_angles }, coordinate)
                }
                Planar::DrivenRevolute { coordinate, forward, .. } => {
                    (Attachment::Revolute { forward, turns_alone: false }, coordinate)
                }
                Planar::Prismatic { coordinate, forward, .. } => (Attachment::Prismatic { forward }, coordinate),
                Planar::Rigid { .. } => (Attachment::Rigid, 0),
                other => panic!("the prototypes have no {other:?}"),
            };
            (link.parent_slot, attachment, coordinate >= real.free)
        };
        let bodies: Vec<_> = real.links.iter().map(body).collect();
        let plays = mechanism.plays.iter().map(|play| match play {
            loosepin_mechanics::model::PlayId::Joint(joint) => {
                mechanism.model.joints[joint.0].kind.points().map(|point| real.slot_of_point(point))
            }
            other => panic!("the prototypes have no {other:?}"),
        });
        Self::new(counts, &bodies, real.cuts.iter().map(|cut| cut.slots).collect(), plays.collect())
    }

    /// First column of each row of the mass matrix that may not be zero.
    pub fn mass_rows(&self) -> Vec<usize> {
        let mut first: Vec<usize> = (0..self.free_speeds).collect();
        for link in &self.links {
            let free = || link.dependences.iter().copied().filter(|speed| *speed < self.free_speeds);
            let least = free().min().unwrap_or(0);
            free().for_each(|speed| first[speed] = first[speed].min(least));
        }
        first
    }

    /// Where the partial velocities of each slot begin, and their number.
    pub fn offsets(&self) -> (Vec<usize>, usize) {
        let (mut offsets, mut next) = (vec![0], 0);
        for link in &self.links {
            offsets.push(next);
            next += link.dependences.len();
        }
        (offsets, next)
    }
}
