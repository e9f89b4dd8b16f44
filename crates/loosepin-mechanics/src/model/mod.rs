//! The checked mechanism description: in SI, immutable, with every number in a numbered slot.
//!
//! `read` makes a [`Model`] of the tables of a `model.toml`. The keys of a table stand where it is read. A model knows nothing of
//! uncertainty and nothing of coordinates; [`crate::mechanism`] compiles it.

mod contact;
mod coupling;
mod cycle_input;
mod drive;
mod entry_reader;
mod ids;
mod joint;
mod load;
mod output;
mod part_reader;
mod parts;
mod plausible;
mod problem;
mod read;
mod values;
mod words;

pub use contact::{Contact, ContactLaw, LawError, Lubrication, Materials, NormalDescription};
pub use coupling::{
    Belt, Cam, CamProfile, Coupled, Coupling, CouplingKind, CouplingNumbers, CouplingPlay, CouplingReader, Curve,
    Gears, KindOfCoupling, Mesh, Proportion, Rack, Ratio, Teeth, Wheels,
};
pub use cycle_input::CycleInput;
pub use drive::{
    AtTime, ConstantSpeed, ConstantSpeedMotion, Cycloidal, CycloidalMotion, Drive, DriveLaw, DriveMotion, DriveReader,
    Expression, ExpressionMotion, Harmonic, HarmonicMotion, KindOfDrive, MotionLaw, MotionTable, Period, Polynomial,
    PolynomialMotion, Steady, TableMotion, TablePiece, TimeDual, TimeTable, Written,
};
pub use ids::{Actuator, Axis, BodyId, ContactId, ControlId, DriveId, JointId, PlayId, PointId};
pub use joint::{
    AtBeam, CircularSlot, CircularSlotClearance, Clearance, GuideClearance, JointKind, JointPlay, KindOfJoint, Line,
    MarkerAxis, NotDriven, PlaneRow, PlayParts, Prismatic, Revolute, Rigid, Row, Slot, SlotClearance, SpaceRow,
    TreeAttachment,
};
pub use load::{
    ActsOn, Direction, ForceLoad, KindOfLoad, Load, LoadKind, LoadPlace, Push, SizeKeys, TimeCourse, TorqueLoad,
};
pub use loosepin_text::document::describe_path;
pub use loosepin_text::numbers::{Origin, Quantity, QuantityError, QuantityId, QuantityTable, Values};
pub use loosepin_text::units::Rule;
pub use output::{
    ActuatorFacts, BeamFacts, Component, Derivative, Effort, EffortMeasure, JointForce, KindOfOutput, KindOfReading,
    Measure, Motion, NoReading, Output, OutputKind, OutputReader, OutputState, PointPath, Position, Reading, Relative,
    Stress, Wear, relative_words,
};
pub use part_reader::{DeferredQuantity, PartReader};
pub use parts::beam::{Beam, Formulation, LumpedMass};
pub use parts::control::{Control, FeedForward};
pub use parts::cycle::{CYCLE_NUMBERS, Cycle, CycleSpan};
pub use parts::friction::{Friction, SlidingVelocity};
pub use parts::initial::{InitialNumber, InitialOf, InitialOffset, InitialValue, OffsetPlace};
pub use parts::load_table::{LoadTable, PeriodProblem, Piston};
pub use parts::spring::{Elasticity, Spring, SpringKind};
pub use parts::table_curve::TableCurve;
pub use parts::topology::{Body, Guess, Joint, Model, Point};
pub use parts::wear::{
    CycleJumps, FoundationChoice, JointWear, LifeLimit, MAX_JUMPS, WearGeometry, WearLife, WearMeasure, WearPressure,
};
pub use problem::ModelProblem;
pub use read::model_schema;
pub use values::function::{Changing, Function};
pub use values::path_error::PathError;
pub use values::set_values::{SetValues, measured_argument};
pub use values::setting::{Setting, SettingError, SettingRange};
pub use values::sizes::{MAX_BODIES, MAX_ENTRIES, MAX_JOINTS};
pub use words::part_names::{Names, PartNames};
