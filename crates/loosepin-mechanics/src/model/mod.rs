//! The checked mechanism description: in SI, immutable, with every number in a numbered slot.
//!
//! `read` makes a [`Model`] of the tables of a `model.toml`. The keys of a table stand where it is read. A model knows nothing of
//! uncertainty and nothing of coordinates; [`crate::mechanism`] compiles it.

mod beam;
mod beam_problem;
mod contact;
mod control;
mod coupling;
mod cycle;
mod cycle_input;
mod drive;
mod entry_reader;
mod friction;
mod function;
mod ids;
mod initial;
mod joint;
mod law_choice;
mod load;
mod load_table;
mod names_of_model;
mod output;
mod part_names;
mod part_reader;
mod path_error;
mod path_hint;
mod plausible;
mod play;
mod problem;
mod quantity;
mod read;
mod set_values;
mod setting;
mod sizes;
mod spring;
mod table_curve;
mod topology;
mod wear;

pub use beam::{Beam, Formulation, Lump};
pub use contact::{Contact, ContactLaw, LawError, Lubrication, Materials, NormalDescription};
pub use control::{Control, FeedForward};
pub use coupling::{
    Belt, Cam, CamProfile, Coupled, Coupling, CouplingKind, CouplingNumbers, CouplingPlay, CouplingReader, Curve,
    Gears, KindOfCoupling, Mesh, Proportion, Rack, Ratio, Teeth, Wheels,
};
pub use cycle::{CYCLE_NUMBERS, Cycle, CycleSpan};
pub use cycle_input::CycleInput;
pub use drive::{
    AtTime, ConstantSpeed, ConstantSpeedMotion, Cycloidal, CycloidalMotion, Drive, DriveLaw, DriveMotion, DriveReader,
    Expression, ExpressionMotion, Harmonic, HarmonicMotion, KindOfDrive, MotionLaw, MotionTable, Period, Polynomial,
    PolynomialMotion, Steady, TableMotion, TablePiece, TimeDual, TimeTable, Written,
};
pub use friction::{Friction, SlidingVelocity};
pub use function::{Changing, Function};
pub use ids::{Actuator, Axis, BodyId, ContactId, ControlId, DriveId, JointId, PlayId, PointId};
pub use initial::{InitialNumber, InitialOf, InitialOffset, InitialValue, OffsetPlace};
pub use joint::{
    AtBeam, CircularSlot, CircularSlotClearance, Clearance, GuideClearance, Hanging, IdealRows, JointKind, JointPlay,
    Keeps, KindOfJoint, Line, NotDriven, PlayParts, Prismatic, Revolute, Rigid, Slot, SlotClearance,
};
pub use load::{
    ActsOn, Course, Direction, ForceLoad, KindOfLoad, Load, LoadKind, LoadPlace, Push, SizeKeys, TorqueLoad,
};
pub use load_table::{LoadTable, PeriodProblem, Piston};
pub use loosepin_text::document::describe_path;
pub use loosepin_text::units::Rule;
pub use output::{
    ActuatorFacts, BeamFacts, Component, Derivative, Effort, EffortMeasure, JointForce, KindOfOutput, KindOfReading,
    Measure, Motion, NoReading, Output, OutputKind, OutputReader, OutputState, PointPath, Position, Reading, Recorded,
    Relative, Stress, Wear, relative_words,
};
pub use part_names::{Names, PartNames};
pub use part_reader::{Later, PartReader};
pub use path_error::PathError;
pub use plausible::HardlyPossible;
pub use problem::ModelProblem;
pub use quantity::{Origin, Quantity, QuantityError, QuantityId, QuantityTable, Values};
pub use read::model_schema;
pub use set_values::{SetValues, measured_argument};
pub use setting::{Setting, SettingError, SettingRange};
pub use sizes::{MOST_BODIES, MOST_ENTRIES, MOST_JOINTS};
pub use spring::{Elasticity, Spring, SpringKind};
pub use table_curve::TableCurve;
pub use topology::{Body, Guess, Joint, Model, Point};
pub use wear::{
    FoundationChoice, JointWear, Jumps, LifeLimit, MOST_JUMPS, WearGeometry, WearLife, WearMeasure, WearPressure,
};
