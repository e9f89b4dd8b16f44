//! A model compiled for computing: the spanning tree, its loops, numbered coordinates and slots, and the closed start.
//!
//! Two trees share the model: the *ideal* one, in which every joint is ideal, gives the ideal motion, the start and the
//! quasi-static answer; in the *real* one joints with play are force elements and leave their loops open.

mod assembly;
mod blocking;
mod cam;
mod compile;
mod complaint;
pub mod constraints;
mod contact_place;
mod control;
mod coupling;
mod coupling_geometry;
mod drive;
mod effort;
mod error;
mod flanks;
mod gap_measure;
mod geometry;
mod ideal;
mod initial;
mod joint_coordinate;
mod joint_friction;
mod joint_geometry;
mod kinematics;
mod lane_sample;
mod load;
mod load_table;
mod mobility;
mod pieces;
mod points;
mod position;
mod sample;
mod spring;
mod start;
mod stressed;
mod table;
mod tooth_force;
mod tooth_geometry;
mod tree;
mod tree_beam;
mod ways_on;

pub use compile::Mechanism;
pub use constraints::RowOwner;
pub use contact_place::{ContactPlace, PlayShape, SliderBlock, SlotShape, is_front_corner, is_upper_corner};
pub use control::{ControlGeometry, KnownChain};
pub use coupling_geometry::{CouplingGeometry, CouplingNumbers};
pub use drive::{DriveMotion, Drives, TimeDual, room};
pub use error::{MechanismError, SampleError};
pub use flanks::Flanks;
pub use gap_measure::GapMeasure;
pub use geometry::{BeamGeometry, CutGeometry, Geometry, LinkGeometry};
pub use ideal::IdealMotion;
pub use joint_friction::JointFriction;
pub use joint_geometry::JointGeometry;
pub use kinematics::{Kinematics, Pose, Twist, acceleration_at, moved, turned_by};
pub use load::{CourseNumbers, LoadGeometry};
pub use load_table::TableNumbers;
pub use points::{numbered_point_m, point_m};
pub use sample::{PlayGeometry, Sample};
pub use spring::{ElasticNumbers, SpringGeometry};
pub use stressed::{SectionNumbers, StressedBody};
pub use tooth_geometry::ToothForce;
pub use tree::{Attachment, CouplingPlace, Cut, CutKind, Dependence, DrivenLoop, JointPlace, Link, Tree};
pub use tree_beam::{BeamEnd, TreeBeam};
pub use ways_on::WaysOn;
