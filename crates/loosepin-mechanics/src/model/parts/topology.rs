//! Bodies, joints, contacts and drives of a model, referring to numbers by [`QuantityId`].

use crate::model::contact::Contact;
use crate::model::coupling::Coupling;
use crate::model::drive::Drive;
use crate::model::ids::{BodyId, PlayId, PointId};
use crate::model::joint::{AtBeam, JointKind};
use crate::model::load::Load;
use crate::model::output::Output;
use crate::model::parts::beam::Beam;
use crate::model::parts::control::Control;
use crate::model::parts::cycle::Cycle;
use crate::model::parts::friction::Friction;
use crate::model::parts::initial::{InitialOffset, InitialValue};
use crate::model::parts::spring::Spring;
use crate::model::parts::wear::{JointWear, WearGeometry, WearLife};
use crate::model::problem::ModelProblem;
use loosepin_text::numbers::{QuantityId, QuantityTable};
use std::collections::HashMap;
use std::sync::Arc;

use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source, Span};
use loosepin_text::units::{Dimension, DisplayUnits, ReadableUnit};

/// Whether a rigid joint or a drive holds the section of a flexible body at a point: a couple acts there.
pub(crate) fn holds_section(joints: &[Joint], drives: &[Drive], point: PointId) -> bool {
    let is_at = |joint: &Joint| joint.kind.points().into_iter().any(|held| held == point);
    (0..joints.len()).any(|index| is_at(&joints[index]) && holds_sections(joints, drives, index))
}

/// Whether the joint with this index is rigid or driven, and so holds the sections at its points.
fn holds_sections(joints: &[Joint], drives: &[Drive], index: usize) -> bool {
    joints[index].kind.at_beam() == AtBeam::Section || drives.iter().any(|drive| drive.joint.0 == index)
}

/// A planar mechanism with its nominal values, checked and in SI.
#[derive(Debug, Clone)]
pub struct Model {
    /// Name of the mechanism.
    pub name: String,
    /// Every number of the model, settable ones and those given by expressions.
    pub quantities: QuantityTable,
    /// Acceleration of gravity along -y, m/s².
    pub gravity_m_s2: QuantityId,
    /// Whether pins with play lean in their bearings, out of the plane; runs stay in it.
    pub leans: bool,
    /// Bodies; index 0 is the ground, which has points and no mass.
    pub bodies: Vec<Body>,
    /// Contact descriptions, shared by any number of joints.
    pub contacts: Vec<Contact>,
    /// Joints in file order.
    pub joints: Vec<Joint>,
    /// Couplings in file order.
    pub couplings: Vec<Coupling>,
    /// Springs in file order.
    pub springs: Vec<Spring>,
    /// Loads in file order.
    pub loads: Vec<Load>,
    /// Drives in file order.
    pub drives: Vec<Drive>,
    /// Controls in file order.
    pub controls: Vec<Control>,
    /// Hints for the assembly, at the start of the cycle.
    pub guesses: Vec<Guess>,
    /// The initial state of what the drives do not move alone.
    pub initial: Vec<InitialValue>,
    /// Places of journals in their bearings at time zero, in file order.
    pub initial_offsets: Vec<InitialOffset>,
    /// The part of the motion that is run and recorded.
    pub cycle: Cycle,
    /// For how long wear is stated; `None` if no joint wears.
    pub wear: Option<WearLife>,
    /// Outputs in file order; behind them those of [`Self::asked_paths`].
    pub outputs: Vec<Output>,
    /// Points that a command named, whose paths and rates are among the outputs.
    pub asked_paths: Vec<PointId>,
    /// Entries that runs need and the file lacks: masses, inertias, contacts, gravity. The motion without dynamics needs none of it, and
    /// the numbers that stand for it are not to be used.
    pub missing_for_runs: Vec<Diagnostic>,
    /// Warnings: entries that are allowed and yet look like an oversight.
    pub warnings: Vec<Diagnostic>,
    /// The file.
    pub(in crate::model) source: Arc<Source>,
    /// The CSV files that it names, in the order of the file.
    pub(in crate::model) tables: Vec<Arc<Source>>,
    /// Places of its tables by dotted path, for diagnostics about what they mean together.
    pub(in crate::model) places: HashMap<String, Span>,
}

impl Model {
    /// Says what runs need and the file does not say.
    ///
    /// # Errors
    /// Each missing entry, at its place.
    pub fn demand_dynamics(&self) -> Result<(), Diagnostics> {
        match self.missing_for_runs.as_slice() {
            [] => Ok(()),
            missing => Err(missing.iter().cloned().collect()),
        }
    }

    /// Checks that a joint wears.
    ///
    /// # Errors
    /// None does.
    pub fn demand_wear(&self) -> Result<(), Diagnostics> {
        if self.wear.is_some() {
            return Ok(());
        }
        let place = self.joints.first().and_then(|joint| self.place(&format!("joint.{}", joint.name)));
        Err(Diagnostics::one(&ModelProblem::NoJointWears, place))
    }

    /// Whether a play is that of a pin that leans out of the plane.
    pub fn has_leaning_pin(&self, play: PlayId) -> bool {
        self.leans && matches!(play, PlayId::Joint(joint) if self.joints[joint.0].kind.pin_clearance().is_some())
    }

    /// Whether a quantity decides how far pins lean, or how far a body stands off: it does nothing in the plane.
    pub fn decides_lean(&self, id: QuantityId) -> bool {
        let pins = self.joints.iter().filter_map(|joint| joint.kind.pin_clearance());
        let of_pins = pins.flat_map(|pin| [pin.bearing_length_m, pin.axial_clearance_m]);
        let all = of_pins.chain(self.bodies.iter().map(|body| body.offset_m)).flatten();
        self.leans && all.into_iter().any(|own| self.quantities.depends_on(own, id))
    }

    /// Whether a rigid joint or a drive holds the section of a flexible body at a point: a couple acts there.
    pub fn holds_section(&self, point: PointId) -> bool {
        holds_section(&self.joints, &self.drives, point)
    }

    /// Whether the joint with this index does so at its points.
    pub fn holds_sections(&self, index: usize) -> bool {
        holds_sections(&self.joints, &self.drives, index)
    }

    /// Whether the worn shape of joints acts back.
    pub fn has_worn_geometry(&self) -> bool {
        self.wear.is_some_and(|life| life.geometry != WearGeometry::Fixed)
    }

    /// How numbers are shown to people: as usual, but those of the dimension of an output in the unit that it states; of several
    /// outputs of a dimension the first one that states another unit than the usual one decides.
    pub fn shown_in(&self, usual: DisplayUnits) -> DisplayUnits {
        let mut units = usual;
        if self.wear.is_some() {
            units.set(Dimension::VOLUME, &ReadableUnit::default_for(Dimension::VOLUME));
        }
        for output in self.outputs.iter().rev() {
            let dimension = output.kind.dimension();
            if output.unit != ReadableUnit::default_for(dimension) {
                units.set(dimension, &output.unit);
            }
        }
        units
    }

    /// The file that the model was read from.
    pub fn source(&self) -> &Arc<Source> {
        &self.source
    }

    /// The CSV files that were read with it: inputs like the file itself.
    pub fn tables(&self) -> &[Arc<Source>] {
        &self.tables
    }

    /// Place of an entry of the file, by its dotted path: `joint.gudgeon`, `body.crank`, `cycle`, `joint.gudgeon.radial_clearance`. The
    /// place of the table above it where it is not written.
    pub fn place(&self, path: &str) -> Option<Place> {
        let written = self.quantities.id(path).and_then(|id| self.quantities[id].span);
        if let Some(span) = written.or_else(|| self.places.get(path).copied()) {
            return Some(Place::new(&self.source, span));
        }
        path.rsplit_once('.').and_then(|(table, _)| self.place(table))
    }
}

/// A body, rigid unless it has a beam. The body frame is where its points are given; its origin need not be the centre of mass.
#[derive(Debug, Clone)]
pub struct Body {
    /// Name in the file; `ground` for the ground.
    pub name: String,
    /// Mass, kg, > 0; absent for the ground.
    pub mass_kg: Option<QuantityId>,
    /// Moment of inertia about the centre of mass, kg m², > 0; absent for the ground.
    pub inertia_kg_m2: Option<QuantityId>,
    /// Centre of mass in the body frame, m; absent for the ground.
    pub centre_of_mass_m: Option<[QuantityId; 2]>,
    /// How far its plane lies above that of the drawing, along z, m; in that of the drawing if absent.
    pub offset_m: Option<QuantityId>,
    /// Named points in the body frame.
    pub points: Vec<Point>,
    /// Flexible properties; its mass, inertia and centre of mass are then those of the straight beam with its lumps.
    pub beam: Option<Beam>,
}

/// A named point of a body.
#[derive(Debug, Clone)]
pub struct Point {
    /// Name in the file.
    pub name: String,
    /// Coordinates in the body frame, m.
    pub position_m: [QuantityId; 2],
}

/// A joint.
#[derive(Debug, Clone)]
pub struct Joint {
    /// Name in the file.
    pub name: String,
    /// Its kind, with the points that it connects.
    pub kind: JointKind,
    /// Friction of an ideal revolute or prismatic joint.
    pub friction: Option<JointFriction>,
    /// Wear of a revolute joint.
    pub wear: Option<JointWear>,
}

/// Friction of an ideal joint.
#[derive(Debug, Clone)]
pub struct JointFriction {
    /// The law with its numbers.
    pub friction: Friction,
    /// Radius of the pin, or length over which the guide holds the slider, m, > 0.
    pub size_m: QuantityId,
}

/// A hint for the assembly at the start of the cycle.
#[derive(Debug, Clone)]
pub struct Guess {
    /// The body.
    pub body: BodyId,
    /// Angle of its x axis from the ground's, rad.
    pub angle_rad: QuantityId,
}
