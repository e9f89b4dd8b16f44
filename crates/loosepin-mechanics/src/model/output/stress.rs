//! The stress of a flexible body.

use super::kind::{KindOfOutput, KindOfReading, Measure};
use super::reader::{BeamFacts, OutputReader};
use super::state::OutputState;
use crate::model::ids::BodyId;
use crate::model::parts::beam_problem::BeamProblem;
use crate::model::words::part_names::PartNames;
use loosepin_math::Real;
use loosepin_text::document::{Kind, Table, optional};
use loosepin_text::units::Dimension;

/// Largest stress along a flexible body, Pa: bending and axial force at the outer fibre, |N|/A + |M| c/I.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stress {
    /// The body.
    pub body: BodyId,
}

impl KindOfOutput for Stress {
    const MEASURES: &'static [Measure] = &[Measure {
        key: optional(
            "stress_in",
            Kind::Reference("body"),
            "\"rod\"",
            "the largest stress along a flexible body: bending and axial force at its outer fibre",
        ),
        beside: &[],
    }];
    // Pressures are read in GPa otherwise, as moduli.
    const USUAL_UNIT: Option<&'static str> = Some("MPa");
    type Reading = Self;

    fn read(measure: &'static str, table: &Table<'_>, reader: &mut dyn OutputReader) -> Option<Self> {
        let entry = table.get(measure)?;
        let body = reader.body(&entry)?;
        let (entry_words, name) = (entry.path.describe(), reader.body_name(body));
        let problem = match reader.beam_facts(body) {
            Some(BeamFacts { is_nodal_between_sections: true, .. }) => {
                BeamProblem::StressHeldAtBothEnds { entry: entry_words, body: name }
            }
            Some(BeamFacts { has_height: true, .. }) => return Some(Self { body }),
            Some(_) => BeamProblem::NoHeight { entry: entry_words, body: name },
            // The diagnostic about its beam is enough.
            None if !reader.document().diagnostics.is_empty() => return None,
            None => BeamProblem::IsRigid { entry: entry_words, body: name },
        };
        reader.document().refuse(&problem, entry.span)
    }

    fn dimension(&self) -> Dimension {
        Dimension::PRESSURE
    }

    fn reading(&self) -> Option<Self> {
        Some(*self)
    }

    fn stressed_body(&self) -> Option<BodyId> {
        Some(self.body)
    }
}

impl KindOfReading for Stress {
    // Sections of flexible bodies are no numbers of the lanes.
    const IS_ON_LANES: bool = false;

    fn words(&self, names: &dyn PartNames) -> String {
        format!("largest stress in {}", names.body(self.body))
    }

    fn needs_forces(&self) -> bool {
        true
    }

    #[inline(always)]
    fn value<T: Real>(&self, state: &impl OutputState<T>) -> T {
        state.largest_stress_pa(self.body)
    }

    fn is_never_negative(&self) -> bool {
        true
    }
}
