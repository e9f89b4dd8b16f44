//! The force of a joint.

use super::kind::{KindOfOutput, KindOfReading, Measure};
use super::reader::{NeededKey, OutputReader, needed_choice};
use super::state::OutputState;
use crate::model::ids::JointId;
use crate::model::words::part_names::PartNames;
use loosepin_math::Real;
use loosepin_text::document::{Kind, Table, optional};
use loosepin_text::units::Dimension;

/// Force of a joint on its journal's (slider's, second) body, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointForce {
    /// The joint.
    pub joint: JointId,
    /// Which component.
    pub component: Component,
}

/// A component of a force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Component {
    /// Along the ground's x axis.
    X,
    /// Along the ground's y axis.
    Y,
    /// The length of the vector.
    Magnitude,
}

impl KindOfOutput for JointForce {
    const MEASURES: &'static [Measure] = &[Measure {
        key: optional("force_in", Kind::Reference("joint"), "\"joint.gudgeon\"", "the force in a joint"),
        beside: &["component"],
    }];
    const COMPONENTS: &'static [&'static str] = &["x", "y", "magnitude"];
    type Reading = Self;

    fn read(measure: &'static str, table: &Table<'_>, reader: &mut dyn OutputReader) -> Option<Self> {
        const COMPONENT: NeededKey =
            NeededKey { key: "component", example: "\"magnitude\"", doc: "the component of the force" };
        let components = [("x", Component::X), ("y", Component::Y), ("magnitude", Component::Magnitude)];
        let component = needed_choice(reader, table, &COMPONENT, &components);
        let joint = reader.joint(&table.get(measure)?)?;
        Some(Self { joint, component: component? })
    }

    fn dimension(&self) -> Dimension {
        Dimension::FORCE
    }

    fn reading(&self) -> Option<Self> {
        Some(*self)
    }
}

impl KindOfReading for JointForce {
    fn words(&self, names: &dyn PartNames) -> String {
        let part = match self.component {
            Component::X => "x force",
            Component::Y => "y force",
            Component::Magnitude => "force",
        };
        format!("{part} in {}", names.joint(self.joint))
    }

    fn needs_forces(&self) -> bool {
        true
    }

    #[inline(always)]
    fn value<T: Real>(&self, state: &impl OutputState<T>) -> T {
        let force_n = state.joint_force_n(self.joint);
        match self.component {
            Component::X => force_n.x,
            Component::Y => force_n.y,
            Component::Magnitude => force_n.length(),
        }
    }

    fn force_in(&self) -> Option<JointId> {
        Some(self.joint)
    }

    fn is_never_negative(&self) -> bool {
        self.component == Component::Magnitude
    }
}
