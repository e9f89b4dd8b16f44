//! A polynomial over time.

use super::kind::{KindOfDrive, MotionLaw, MotionTable, TimeDual, Written};
use super::reading::DriveReader;
use super::table_motion::{AtTime, polynomial_at};
use crate::model::problem::ModelProblem;
use crate::model::words::part_names::Names;
use loosepin_math::{Real, numbers};
use loosepin_text::document::{Entry, Keys, Kind, Table};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};

/// Σ c_k t^k.
#[derive(Debug, Clone)]
pub struct Polynomial {
    /// c_0, c_1, ...
    pub coefficients: Vec<QuantityId>,
}

/// Numbers of Σ c_k (t - t0)^k.
#[derive(Debug, Clone)]
pub struct PolynomialMotion<T> {
    /// t0, s.
    origin_s: T,
    /// c_0, c_1, ...
    coefficients: Vec<T>,
}

numbers!(struct PolynomialMotion { origin_s, coefficients });

impl KindOfDrive for Polynomial {
    type Motion<T: Real> = PolynomialMotion<T>;

    const WORD: &'static str = PolynomialTable::WORD;

    fn quantities(&self) -> Vec<QuantityId> {
        self.coefficients.clone()
    }

    fn motion<T: AtTime>(&self, number: &dyn Fn(QuantityId) -> T, _time_s: f64) -> PolynomialMotion<T> {
        let coefficients = self.coefficients.iter().map(|id| number(*id)).collect();
        PolynomialMotion { origin_s: T::zero(), coefficients }
    }

    fn words(&self, _names: &dyn Names) -> String {
        format!("by a polynomial of degree {}", self.coefficients.len() - 1)
    }
}

impl<T: Real> MotionLaw<T> for PolynomialMotion<T> {
    #[inline(always)]
    fn at(&self, time_s: T, _workspace: &mut [TimeDual<T>]) -> [T; 3] {
        polynomial_at(self.origin_s, &self.coefficients, time_s)
    }
}

impl MotionTable for Polynomial {
    const KEYS: &'static Keys = &PolynomialTable::KEYS;

    fn read(table: &Table<'_>, dimension: Dimension, reader: &mut dyn DriveReader) -> Option<Written<Self>> {
        let list = PolynomialTable::of(reader, table.clone())?.coefficients;
        let elements = reader.document().list(&list)?;
        if elements.is_empty() {
            let problem = ModelProblem::TooFewPoints { entry: list.path.describe(), least: 1 };
            return reader.document().refuse(&problem, list.span);
        }
        let mut due = dimension;
        let mut coefficients = Vec::new();
        for element in &elements {
            coefficients.push(reader.quantity_of(element, due, Rule::Finite));
            due = due.over(Dimension::TIME);
        }
        let coefficients: Option<Vec<QuantityId>> = coefficients.into_iter().collect();
        Some(Written::Motion(Self { coefficients: coefficients? }))
    }
}

record! {
    /// c0 + c1 time + c2 time^2 + ...
    struct PolynomialTable for DriveReader, kind "polynomial" of motion;
    /// c0, c1, c2, ... with their units
    required coefficients: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"10 deg\", \"5 rad/s\", \"20 rad/s^2\"]";
}
