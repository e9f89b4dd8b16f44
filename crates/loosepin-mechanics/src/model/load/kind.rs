//! The interface of a kind of load, and its terms.

use super::size::{SizeKeys, SizeTable};
use crate::model::ids::{BodyId, PointId};
use crate::model::part_reader::PartReader;
use crate::model::words::part_names::Names;
use loosepin_math::{Real, Vec2};
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::QuantityId;

/// A kind of force or torque from outside.
///
/// The rest of the program asks these questions, and knows no kind by its name. Constants are what all loads of a kind have in common,
/// methods what one of them states.
pub trait KindOfLoad: Sized {
    /// Word in files.
    const WORD: &'static str;
    /// Keys of its table.
    const KEYS: &'static Keys;
    /// How its size is written, where it has one that is constant or changes with time or with the motion of a joint.
    const SIZE: Option<SizeKeys>;

    /// Reads it from its table, but for its size, which is handed on as it stands there; `None` of either after a diagnostic.
    fn read<'t>(table: Table<'t>, reader: &mut dyn PartReader) -> (Option<Self>, Option<SizeTable<'t>>);

    /// What it acts on.
    fn acts_on(&self) -> ActsOn;

    /// The direction in which drawings show it, where it has one that does not depend on the motion.
    fn direction(&self) -> Option<Direction> {
        None
    }

    /// Its numbers beside its size and the point that it acts on, SI, in an order of its own; `number` is the value of a quantity.
    fn numbers(&self, number: &dyn Fn(QuantityId) -> f64) -> Vec<f64> {
        let _ = number;
        Vec::new()
    }

    /// What it does at a state: `numbers` are those of [`Self::numbers`], `size` is zero where it has none.
    fn push<T: Real>(&self, numbers: &[T], size: T, place: &impl LoadPlace<T>) -> Push<T>;

    /// What it is, in words: `size` is its size in words, empty where it has none.
    fn words(&self, names: &dyn Names, size: &str) -> String;
}

/// The target of a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ActsOn {
    /// A point of a body: a force.
    Point(PointId),
    /// A whole body: a torque.
    Body(BodyId),
}

impl ActsOn {
    /// The body.
    pub fn body(self) -> BodyId {
        match self {
            Self::Point(point) => point.body,
            Self::Body(body) => body,
        }
    }
}

/// A direction from the x axis of the ground or of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Direction {
    /// Its angle, rad.
    pub angle_rad: QuantityId,
    /// Whether it counts from the x axis of the body and turns with it.
    pub follows_body: bool,
}

/// Place of a load at one state, over any kind of number.
///
/// Kinds of load stand in the model, which knows no equations of motion; `dynamics/load.rs` answers these questions.
pub trait LoadPlace<T: Real> {
    /// A vector of the body's frame in the frame of the ground.
    fn turned(&self, vector: Vec2<T>) -> Vec2<T>;

    /// From the origin of the body to the point that it acts on, m, in the frame of the ground.
    fn arm_m(&self) -> Vec2<T>;

    /// Velocity of the body at the end of such an arm, m/s, in the frame of the ground.
    fn velocity_m_s(&self, arm_m: Vec2<T>) -> Vec2<T>;
}

/// Force and torque of a load on its body.
#[derive(Debug, Clone, Copy)]
pub struct Push<T> {
    /// From the origin of the body to the point of attack, m, in the frame of the ground; zero for a torque alone.
    pub arm_m: Vec2<T>,
    /// Force, N, in the frame of the ground.
    pub force_n: Vec2<T>,
    /// Torque, N m.
    pub torque_n_m: T,
}
