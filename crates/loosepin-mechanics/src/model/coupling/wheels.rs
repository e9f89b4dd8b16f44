//! The sizes of two wheels, and which way they turn.

use super::proportion::{Proportion, offset, sign, signed, words};
use super::reading::CouplingReader;
use crate::model::ids::{BodyId, JointId};
use crate::model::problem::ModelProblem;
use crate::model::words::part_names::Names;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Kind, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

/// Two wheels: size of the first over that of the second, with a sign, and the angle between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Wheels {
    /// Pitch radii, m, or numbers of teeth.
    pub sizes: [QuantityId; 2],
    /// Whether the coordinates of the joints go against each other.
    pub is_reversed: bool,
    /// Angle of the second where the first is at zero, rad.
    pub offset_rad: QuantityId,
}

record! {
    /// the sizes of two wheels
    pub(super) struct WheelsTable for CouplingReader;
    /// pitch radii of the wheels on the first and second joint
    optional radii: Entry<'t> = Kind::List(&quantity(D::LENGTH, Rule::Positive)), "[\"20 mm\", \"45 mm\"]";
    /// numbers of teeth of the wheels on the first and second joint, instead of radii
    optional teeth: Entry<'t> = Kind::List(&quantity(D::NUMBER, Rule::Positive)), "[20, 45]";
}

impl Wheels {
    /// Reads them from `own`, the table at `entry`, with the offset there; `are_opposed`: whether they turn against each other on the body
    /// that carries both, nothing after a diagnostic.
    pub(super) fn read(
        (entry, own, at_offset): (&Entry<'_>, &WheelsTable<'_>, &Option<Entry<'_>>),
        joints: [JointId; 2],
        are_opposed: Option<bool>,
        reader: &mut dyn CouplingReader,
    ) -> Option<Self> {
        let sizes = sizes(own, reader);
        let is_turned = is_turned(entry, joints, reader);
        let (sizes, is_reversed) = (sizes?, are_opposed? != is_turned?);
        Some(Self { sizes, is_reversed, offset_rad: offset(at_offset, &own.table, joints[1], reader)? })
    }

    /// Quantities that define the coordinate of the second by that of the first.
    pub(super) fn quantities(&self) -> Vec<QuantityId> {
        self.sizes.into_iter().chain([self.offset_rad]).collect()
    }

    /// Ratio and offset of the wheels.
    pub(super) fn proportion<T: Real>(&self, number: &dyn Fn(QuantityId) -> T) -> Proportion<T> {
        let [first, second] = self.sizes;
        let ratio = signed(number(first) / number(second), self.is_reversed);
        Proportion { ratio, offset: number(self.offset_rad) }
    }

    /// `times -20 mm / 45 mm, plus 12 deg`.
    pub(super) fn words(&self, names: &dyn Names) -> String {
        let [first, second] = self.sizes.map(|id| names.quantity(id));
        words(&format!("{}{first} / {second}", sign(self.is_reversed)), self.offset_rad, names)
    }
}

/// Radii or teeth of two wheels.
fn sizes(own: &WheelsTable<'_>, reader: &mut dyn CouplingReader) -> Option<[QuantityId; 2]> {
    let (entry, dimension) = match (&own.radii, &own.teeth) {
        (Some(radii), _) => (radii, D::LENGTH),
        (None, teeth) => (teeth.as_ref()?, D::NUMBER),
    };
    let pair = reader.document().pair(entry)?;
    let mut ids = [None; 2];
    for ((mut element, name), id) in pair.into_iter().zip(["first", "second"]).zip(&mut ids) {
        element.path = entry.path.join(name);
        *id = reader.quantity_of(&element, dimension, Rule::Positive);
    }
    let [first, second] = ids;
    Some([first?, second?])
}

/// Whether seen from the body that carries both wheels the coordinate of exactly one of the joints counts backwards: where
/// that body is the bearing's in one joint and the journal's in the other.
pub(super) fn is_turned(entry: &Entry<'_>, joints: [JointId; 2], reader: &mut dyn CouplingReader) -> Option<bool> {
    let [a, b] = joints.map(|joint| reader.joint_kind(joint).bodies());
    let sides = |body: BodyId, [bearing, _]: [BodyId; 2]| body == bearing;
    let common: Vec<BodyId> = a.into_iter().filter(|body| b.contains(body)).collect();
    let [carrier] = common[..] else {
        let [first, second] = joints.map(|joint| reader.joint_name(joint));
        let problem = ModelProblem::NoCarrier { entry: entry.path.describe(), first, second };
        return reader.document().refuse(&problem, entry.key_span);
    };
    Some(sides(carrier, a) != sides(carrier, b))
}
