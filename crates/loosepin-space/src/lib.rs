//! Kinematic accuracy of mechanisms in space: where their bodies are, how they can move, and how far play in their joints takes an output,
//! without dynamics.
//!
//! A [`SpatialMechanism`] is made of bodies, joints between markers on them, and drives. [`assemble`] closes its loops at given values of the
//! drives, [`cycle`] along a turn of them; [`mobility`] counts freedoms, redundant rows and idle parts; [`motion`] gives velocities and
//! accelerations. [`PoseAccuracy`] then says what play does in such a position: gains, worst cases of first order and exact ones with the places of
//! the journals that make them, standard deviations. [`TurnSampler`] evaluates a model with many sets of values over its turn, [`OpenChain`] arms
//! without loops for very many samples. [`PictureSource`] says what is drawn of a mechanism.
//!
//! ```
//! use loosepin_space::{
//!     Body, Drive, DriveValue, Joint, JointCoordinate, Marker, Pose, PoseAccuracy, Revolute, RevolutePlay, SearchOptions, SpatialMechanism,
//!     SpatialOutput, Vec3, assemble,
//! };
//!
//! // An arm of 0.3 m on a driven pin with play.
//! let marker = |body| Marker::new(body, Vec3::ZERO, Vec3::Z, Vec3::X).expect("axes at a right angle");
//! let play = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 1e-4, axial_clearance_m: 0.0 };
//! let pin = Joint::new("pin", Revolute, marker(0), marker(1)).with_play(play);
//! let arm = SpatialMechanism::new(
//!     vec![Body::ground(), Body::new("arm", Pose::GROUND)],
//!     vec![pin],
//!     vec![Drive { joint: 0, coordinate: JointCoordinate::Angle }],
//! )?;
//! let position = assemble(&arm, &[DriveValue::held(0.5)])?;
//! let accuracy = PoseAccuracy::new(&arm, &position)?;
//! let [_, _, height] = SpatialOutput::displacement(1, Vec3::new(0.3, 0.0, 0.0));
//! // The pin leans by 2c/l: 3 mm at the end of the arm, though no journal is off by more than 0.1 mm.
//! let worst = accuracy.worst_case(&height, &SearchOptions::default())?;
//! assert!((worst.largest.deviation - 3e-3).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Lengths in m, angles in rad. Bodies, joints and drives are numbered from 0 in the order in which they were given; body 0 is the ground.

mod accuracy;
mod chain;
mod closure;
mod enclosure;
mod kind;
mod mechanism;
mod mobility;
mod model;
mod motion;
mod output;
mod picture;
mod play;
mod random;
mod sampling;
mod stop;

pub use accuracy::{
    AccuracyError, AssemblyReserve, ClosedByPlay, DeadCentreNearness, DisplacedPosition, Extreme, FirstOrder, Gains,
    JournalGain, LargestNorm, LeastPlay, MarkerError, MarkerGain, MarkerGains, MarkerScatter, MarkerSide, PlacedBlock,
    PlayDistribution, PlaySet, PoseAccuracy, ProvenEnds, SampledDeviation, SearchOptions, Worst, WorstCase,
    WorstPlaces,
};
pub use chain::{ChainError, ChainPose, ChainSample, OpenChain};
pub use closure::error::{ClosureError, DrivePlace, OpenJoint};
pub use closure::position::Position;
pub use closure::{Cycle, RANK_THRESHOLD, assemble, cycle};
pub use kind::frames::{Axis, MarkerShift};
pub use kind::row::Row;
pub use kind::{
    Cylindrical, CylindricalPlay, Planar, Prismatic, Revolute, RevolutePlay, Rigid, Screw, SpatialKind, SpatialPlay,
    Spherical, SphericalPlay, Universal, UprightPlay,
};
pub use loosepin_math::{Frame, Pose, Quaternion, Rotation, Vec3};
pub use mechanism::body::Body;
pub use mechanism::body_tree::{BodyTree, TreeJoint};
pub use mechanism::drive::{Drive, DriveValue, JointCoordinate};
pub use mechanism::error::MechanismError;
pub use mechanism::joint::Joint;
pub use mechanism::marker::Marker;
pub use mechanism::spatial_mechanism::SpatialMechanism;
pub use mobility::{IdleKind, IdleMotion, Mobility, RedundantDirection, RedundantShare, mobility};
pub use model::{
    CycleInput, Direction, ModelAssembly, ModelBody, ModelCycle, ModelCycleSpan, ModelDrive, ModelGuess, ModelJoint,
    ModelMarker, ModelMisalignment, ModelOutput, ModelOutputKind, ModelPoint, PlayEnds, PlayQuestion, PointId,
    SpatialModel, SpatialModelError, SpatialModelProblem, SpatialMotionProblem, SpatialScatter, SpatialScatterPlan,
    dead_centre_spans, is_inertia, is_spatial, refuse_without_geometry, spatial_model_schema,
};
pub use motion::{BodyRates, Motion, PathFrame, motion};
pub use output::kind_of_output::{BodyGradient, KindOfOutput, OutputState};
pub use output::{JointOutput, PointOutput, RotationOutput, RotationSineOutput, SpatialOutput};
pub use picture::PictureSource;
pub use play::block::{Block, PlayPart};
pub use sampling::{PartOfOutput, PlaySide, SampledPart, SamplingError, TurnSample, TurnSampler};
pub use stop::{IsStopped, stop_after};
