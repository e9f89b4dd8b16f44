//! Flexible links: bodies that bend and stretch between two of their points.

use loosepin_flexible::{Frame, Rule};
use loosepin_text::numbers::QuantityId;

/// The flexible properties of a body. Its mass, its inertia and its centre of mass follow from it.
#[derive(Debug, Clone)]
pub struct Beam {
    /// Indices of its ends in [`crate::model::Body::points`]: `from`, then `to`.
    pub ends: [usize; 2],
    /// Mass ρAL without lumps, kg, > 0.
    pub mass_kg: QuantityId,
    /// Masses that it carries.
    pub lumps: Vec<LumpedMass>,
    /// Length L between them, m, > 0.
    pub length_m: QuantityId,
    /// Area A of the section, m², > 0.
    pub area_m2: QuantityId,
    /// Second moment I of the section, m⁴, > 0.
    pub second_moment_m4: QuantityId,
    /// Height of the section in the plane of motion, m, > 0; absent where it is given by its area and second moment.
    pub height_m: Option<QuantityId>,
    /// EA/L, N/m, > 0.
    pub axial_stiffness_n_m: QuantityId,
    /// EI/L, N m/rad, > 0.
    pub bending_stiffness_n_m: QuantityId,
    /// Damping ratio of every shape, >= 0; absent for a beam without damping.
    pub damping_ratio: Option<QuantityId>,
    /// Frequency above which a shape is condensed, Hz, > 0; absent where none is.
    pub condense_above_hz: Option<QuantityId>,
    /// The frame in which it is described.
    pub frame: Frame,
    /// Number of axial shapes.
    pub axial_shapes: usize,
    /// Number of lateral shapes.
    pub lateral_shapes: usize,
    /// Whether it has static shapes at points inside on which joints, springs or loads act.
    pub has_static_shapes: bool,
    /// Whether it becomes shorter where it bends.
    pub foreshortening: bool,
    /// How its motion is described; shapes, frame, foreshortening and damping ratio belong to the floating frame.
    pub formulation: Formulation,
    /// Retardation time τ of its material in absolute nodal coordinates, s, >= 0; absent for a beam without damping.
    pub retardation_s: Option<QuantityId>,
    /// Whether it starts bent and stretched as inertia and loads ask for at the start, without ringing; else undeformed.
    pub starts_settled: bool,
}

/// A mass at a point of a flexible body, which moves and turns with the section there.
#[derive(Debug, Clone)]
pub struct LumpedMass {
    /// Name in the file.
    pub name: String,
    /// Index in [`crate::model::Body::points`] of its centre of mass.
    pub point: usize,
    /// Mass, kg, >= 0.
    pub mass_kg: QuantityId,
    /// Moment of inertia about its centre of mass, kg m², >= 0; absent for a point mass.
    pub inertia_kg_m2: Option<QuantityId>,
}

/// How the motion of a beam is described.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Formulation {
    /// By few shapes in a floating frame.
    FloatingFrame,
    /// By positions and slopes of the nodes of a mesh, seen from the ground.
    AbsoluteNodal {
        /// Number of elements, >= 1.
        elements: usize,
        /// Points of integration.
        rule: Rule,
    },
}

impl Beam {
    /// Number of coordinates beside those that the body would have as a rigid one, without static shapes of points inside.
    pub fn own_coordinates(&self) -> usize {
        match self.formulation {
            Formulation::FloatingFrame => self.axial_shapes + self.lateral_shapes,
            Formulation::AbsoluteNodal { elements, .. } => 4 * elements + 1,
        }
    }

    /// Whether its frame turns with its section at `from`.
    pub fn has_tangent_frame(&self) -> bool {
        self.frame == Frame::Tangent && !self.is_nodal()
    }

    /// Whether it is described in absolute nodal coordinates.
    pub fn is_nodal(&self) -> bool {
        matches!(self.formulation, Formulation::AbsoluteNodal { .. })
    }
}
