//! A model compiled for computing: the spanning tree, its loops, numbered coordinates and slots, and the closed start.
//!
//! Two trees share the model: the *ideal* one, in which every joint is ideal, gives the ideal motion, the start and the
//! quasi-static answer; in the *real* one joints with play are force elements and leave their loops open.

mod attachment;
mod beginning;
mod compile;
mod diagnostic;
mod error;
mod ideal;
mod lane_sample;
mod loops;
mod parts;
mod play_shape;
mod position;
mod row;
mod sample;
mod tree;

pub use crate::model::TimeDual;
pub use attachment::{
    Ball, FormOfAttachment, Free, KindOfAttachment, MovingGeometry, PlaneAttachment, Prismatic, Revolute, Rigid,
    SpaceAttachment, TreeGeometry,
};
pub use beginning::offset::StartOffset;
pub use compile::Mechanism;
pub use error::{DrivePlace, MechanismError, SampleError};
pub use ideal::IdealMotion;
pub use loops::constraints::{self, LargestResidual, RowOwner, largest_relative_residual};
pub use loops::contact_place::{ContactPlace, is_front_corner, is_upper_corner};
pub use loops::coupling_geometry::CouplingGeometry;
pub use loops::gap_measure::GapMeasure;
pub use loops::joint_geometry::JointGeometry;
pub use loops::tooth_geometry::ToothForce;
pub use parts::arms::Arms;
pub use parts::control::{ControlGeometry, KnownChain};
pub use parts::drive::{Drives, workspace_length};
pub use parts::flanks::Flanks;
pub use parts::joint_friction::JointFriction;
pub use parts::load::{CourseNumbers, LoadGeometry};
pub use parts::load_table::TableNumbers;
pub use parts::nodal_geometry::NodalGeometry;
pub use parts::pin_pair::{pin_clearance, pin_pair};
pub use parts::spring::{ElasticNumbers, SpringGeometry};
pub use parts::stressed::{SectionNumbers, StressedBody};
pub(crate) use play_shape::ask_shape;
pub use play_shape::{CircularSlotShape, PinShape, PlayForm, PlayFreedom, PlayShape, SliderBlock, SlotShape};
pub use row::{
    CutColumns, CutMotion, CutState, RowAt, RowGeometry, cut_biases, cut_forces_n, cut_jacobian, cut_residuals,
};
pub use sample::{PlayGeometry, Sample};
pub use tree::beam::{BeamPlace, TreeBeam};
pub use tree::cut_numbers::CutNumbers;

pub use tree::kinematics::{Column, Kinematics, Pose, Twist, acceleration_at};
pub use tree::motion_branches::MotionBranches;
pub use tree::nodal_beam::TreeNodalBeam;
pub use tree::numbers::{BeamGeometry, Condensed, LinkNumbers, TreeNumbers};
pub use tree::points::{numbered_point_m, point_m};
pub use tree::spanning_tree::{CouplingPlace, Cut, DrivenLoop, JointPlace, Link, Tree};
