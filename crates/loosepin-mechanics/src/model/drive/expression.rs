//! An expression over time.

use super::kind::{COORDINATE, KindOfDrive, MotionLaw, MotionTable, TimeDual, Written};
use super::reading::DriveReader;
use super::table_motion::AtTime;
use crate::model::values::function::{Changing, Function};
use crate::model::words::part_names::Names;
use loosepin_math::{Dual, Real, numbers};
use loosepin_text::document::{Entry, Keys, Table};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::Dimension;
use std::sync::Arc;

/// A function of the time.
#[derive(Debug, Clone)]
pub struct Expression {
    /// The function.
    pub function: Arc<Function>,
}

/// A function with its parameters.
#[derive(Debug, Clone)]
pub struct ExpressionMotion<T> {
    parameters: Vec<T>,
    function: Arc<Function>,
}

numbers!(struct ExpressionMotion { parameters; function });

impl KindOfDrive for Expression {
    type Motion<T: Real> = ExpressionMotion<T>;

    const WORD: &'static str = ExpressionTable::WORD;

    fn quantities(&self) -> Vec<QuantityId> {
        self.function.parameters.clone()
    }

    fn motion<T: AtTime>(&self, number: &dyn Fn(QuantityId) -> T, _time_s: f64) -> ExpressionMotion<T> {
        let parameters = self.function.parameters.iter().map(|id| number(*id)).collect();
        ExpressionMotion { parameters, function: Arc::clone(&self.function) }
    }

    fn words(&self, _names: &dyn Names) -> String {
        "by an expression over time".to_owned()
    }

    fn workspace_length(&self) -> usize {
        self.function.steps()
    }
}

impl<T: Real> MotionLaw<T> for ExpressionMotion<T> {
    #[inline(always)]
    fn at(&self, time_s: T, workspace: &mut [TimeDual<T>]) -> [T; 3] {
        let time = Dual { value: Dual::variable(time_s), derivative: Dual::constant(T::one()) };
        let found = self.function.value(
            &self.parameters,
            &[time],
            #[inline(always)]
            |number| Dual::constant(Dual::constant(number)),
            workspace,
        );
        [found.value.value, found.value.derivative, found.derivative.derivative]
    }
}

impl MotionTable for Expression {
    const KEYS: &'static Keys = &ExpressionTable::KEYS;

    fn read(table: &Table<'_>, dimension: Dimension, reader: &mut dyn DriveReader) -> Option<Written<Self>> {
        let own = ExpressionTable::of(reader, table.clone())?;
        Some(match reader.over_time(&own.position, dimension)? {
            Changing::Function(function) => Written::Motion(Self { function: Arc::new(function) }),
            Changing::Constant(id) => Written::Standstill(id),
        })
    }
}

record! {
    /// an expression over time
    struct ExpressionTable for DriveReader, kind "expression" of motion;
    /// the angle or position as a function of time
    required position: Entry<'t> = COORDINATE, "\"30 deg * sin(3 rad/s * time)\"";
}
