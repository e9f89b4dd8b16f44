//! Kinematic accuracy of mechanisms in space: where their bodies are, how they can move, and how far play in their joints takes an output,
//! without dynamics.
//!
//! A [`SpatialMechanism`] is made of bodies, joints between markers on them, and drives. [`assemble`] closes its loops at given values of the
//! drives, [`cycle`] along a turn of them; [`mobility`] counts freedoms, redundant rows and idle parts; [`motion`] gives velocities and
//! accelerations. [`PoseAccuracy`] then says what play does in such a position: gains, worst cases of first order and exact ones with the places of
//! the journals that make them, standard deviations. [`OpenChain`] evaluates arms without loops for very many samples.
//!
//! Lengths in m, angles in rad. Bodies, joints and drives are numbered from 0 in the order in which they were given; body 0 is the ground.

mod accuracy;
mod chain;
mod closure;
mod geometry;
mod kind;
mod mechanism;
mod mobility;
mod motion;
mod output;
mod play;

pub use accuracy::{
    AccuracyError, AssemblyReserve, DisplacedPosition, Extreme, FirstOrder, Gains, JournalGain, LargestNorm, MarkerError, MarkerGain, MarkerGains, MarkerSide, SampledDeviation,
    MarkerScatter, PlacedBlock, PlayDistribution, PlaySet, PoseAccuracy, SearchOptions, WorstCase,
};
pub use chain::{ChainError, ChainPose, ChainSample, EndPose, OpenChain};
pub use closure::error::{ClosureError, DrivePlace};
pub use closure::position::Position;
pub use closure::{Cycle, RANK_THRESHOLD, assemble, cycle};
pub use geometry::pose::Pose;
pub use geometry::quaternion::Quaternion;
pub use geometry::rotation::Rotation;
pub use geometry::vector::Vec3;
pub use kind::frames::{Axis, MarkerShift};
pub use kind::kind_of_joint::KindOfJoint;
pub use kind::row::Row;
pub use kind::{Cylindrical, Planar, Prismatic, Revolute, Rigid, Screw, SpatialKind, Spherical, Universal};
pub use mechanism::body::Body;
pub use mechanism::drive::{Drive, DriveValue, JointCoordinate};
pub use mechanism::error::MechanismError;
pub use mechanism::joint::Joint;
pub use mechanism::marker::Marker;
pub use mechanism::spatial_mechanism::SpatialMechanism;
pub use mobility::{IdleKind, IdleMotion, Mobility, RedundantDirection, RedundantShare, mobility};
pub use motion::{BodyRates, Motion, PathFrame, motion};
pub use output::kind_of_output::{BodyGradient, KindOfOutput, OutputState};
pub use output::{JointOutput, PointOutput, RotationOutput, RotationSineOutput, SpatialOutput};
pub use play::block::{Block, PlayPart};
pub use play::kind_of_play::KindOfPlay;
pub use play::{CylindricalPlay, RevolutePlay, SpatialPlay, SphericalPlay, UprightPlay};
