//! Two gears in mesh.

use super::kind::{Coupled, KindOfCoupling, PitchCircles};
use super::play::{Backlash, BacklashTable};
use super::proportion::{OFFSET, Proportion};
use super::reading::CouplingReader;
use super::teeth::{Mesh, PRESSURE_ANGLE, Teeth};
use super::wheels::{Wheels, WheelsTable};
use crate::model::problem::ModelProblem;
use crate::model::words::part_names::Names;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Kind, Table, choice};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::Dimension;
use loosepin_text::{choices, record};

/// Two gears in mesh.
#[derive(Debug, Clone)]
pub struct Gears {
    /// Both wheels.
    pub wheels: Wheels,
    /// Their pitch circles, where radii are stated.
    pub pitch_circles: Option<PitchCircles>,
}

impl KindOfCoupling for Gears {
    type Curve<T: Real> = Proportion<T>;

    const WORD: &'static str = GearsTable::WORD;
    const KEYS: &'static Keys = &GearsTable::KEYS;

    fn read(entry: &Entry<'_>, table: &Table<'_>, reader: &mut dyn CouplingReader) -> Option<Coupled<Self>> {
        let own = GearsTable::of(reader, table.clone())?;
        let mut backlash = Backlash::read(&own.play, reader);
        if let Some(entry) = own.play.backlash.as_ref().filter(|_| backlash.is_stated() && own.wheels.teeth.is_some()) {
            let problem = ModelProblem::BacklashNeedsRadii { entry: table.path.describe() };
            reader.document().report(&problem, entry.key_span);
            backlash = backlash.refused();
        }
        let joints = reader.two_joints(table, [&own.first, &own.second], [Some(Dimension::ANGLE); 2])?;
        let are_opposed = own.mesh.map(|mesh| mesh == Mesh::External);
        let wheels = Wheels::read((entry, &own.wheels, &own.offset), joints, are_opposed, reader)?;
        let play = backlash.between_flanks(table, Some(wheels.sizes[1]), reader)?;
        let radii_m = wheels.sizes.map(|size| own.wheels.teeth.is_none().then_some(size));
        let teeth = Teeth::read((table, &own.pressure_angle, &own.second), joints, radii_m, own.mesh?, reader)?;
        let has_radii = own.wheels.radii.is_some();
        let pitch_circles = own.mesh.filter(|_| has_radii).map(|mesh| PitchCircles { radii_m: wheels.sizes, mesh });
        Some(Coupled { joints, kind: Self { wheels, pitch_circles }, play, teeth })
    }

    fn quantities(&self) -> Vec<QuantityId> {
        self.wheels.quantities()
    }

    fn curve<T: Real>(&self, number: &dyn Fn(QuantityId) -> T) -> Proportion<T> {
        self.wheels.proportion(number)
    }

    fn pitch_circles(&self) -> Option<PitchCircles> {
        self.pitch_circles
    }

    fn words(&self, names: &dyn Names) -> String {
        self.wheels.words(names)
    }
}

choices!(Mesh: "external" => Self::External, "internal" => Self::Internal);

record! {
    /// two gears in mesh; each gear is on a revolute joint, and one body carries both joints
    struct GearsTable for CouplingReader, kind "gears" of coupling, exactly one of [radii, teeth];
    /// revolute joint of the first gear
    required first: Option<Entry<'t>> = Kind::Reference("joint"), "\"input\"";
    /// revolute joint of the second gear
    required second: Option<Entry<'t>> = Kind::Reference("joint"), "\"output\"";
    /// external: the gears turn in opposite directions on their carrier; internal: in the same direction
    required mesh: Option<Mesh> = choice::<Mesh>(), "\"external\"";
    include wheels: WheelsTable<'t>;
    optional pressure_angle: Entry<'t> as PRESSURE_ANGLE;
    optional offset: Entry<'t> as OFFSET;
    include play: BacklashTable<'t>;
}
