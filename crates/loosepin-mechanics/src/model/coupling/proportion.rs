//! A coordinate that is a multiple of another one: f(q) = ratio · q + offset.

use super::kind::Curve;
use super::reading::CouplingReader;
use crate::model::ids::JointId;
use crate::model::words::part_names::Names;
use loosepin_math::{Real, numbers};
use loosepin_text::document::{Entry, Key, Kind, Table, optional, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::{Dimension as D, Rule};

/// Numbers of ratio · q + offset.
#[derive(Debug, Clone)]
pub struct Proportion<T> {
    /// Slope, rad/rad, m/rad, rad/m or m/m.
    pub ratio: T,
    /// Value at zero, rad or m.
    pub offset: T,
}

numbers!(struct Proportion { ratio, offset });

impl<T: Real> Curve<T> for Proportion<T> {
    #[inline(always)]
    fn at(&self, coordinate: T) -> [T; 3] {
        [self.ratio.mul_add(coordinate, self.offset), self.ratio, T::zero()]
    }

    fn offset(&self) -> Option<T> {
        Some(self.offset)
    }

    fn offset_mut(&mut self) -> Option<&mut T> {
        Some(&mut self.offset)
    }

    fn gain(&self, scale: T) -> T {
        self.ratio.abs() * scale
    }
}

/// The key of the offset.
pub(super) const OFFSET: Key = optional(
    "offset",
    Kind::AnyOf(&[quantity(D::ANGLE, Rule::Finite), quantity(D::LENGTH, Rule::Finite)]),
    "\"12 deg\"",
    "angle or position of the second joint when the first is at zero; zero if omitted",
);

/// The offset of a coordinate of the second joint, which stands at `entry` of `table`.
pub(super) fn offset(
    entry: &Option<Entry<'_>>,
    table: &Table<'_>,
    second: JointId,
    reader: &mut dyn CouplingReader,
) -> Option<QuantityId> {
    let dimension = reader.coordinate_of(second);
    match entry {
        Some(entry) => reader.quantity_of(entry, dimension, Rule::Finite),
        None => Some(reader.default_quantity(&table.path.join(OFFSET.name), dimension, Rule::Finite, 0.0)),
    }
}

/// `value`, against the other coordinate where it `is_reversed`.
pub(super) fn signed<T: Real>(value: T, is_reversed: bool) -> T {
    if is_reversed { -value } else { value }
}

/// Sign of a factor in words.
pub(super) fn sign(is_reversed: bool) -> &'static str {
    if is_reversed { "-" } else { "" }
}

/// `times 2.5, plus 12 deg`.
pub(super) fn words(factor: &str, offset: QuantityId, names: &dyn Names) -> String {
    if names.value_si(offset) == 0.0 {
        return format!("times {factor}");
    }
    format!("times {factor}, plus {}", names.quantity(offset))
}
