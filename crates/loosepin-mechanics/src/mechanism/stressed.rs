//! Links whose stress is an output.

use super::points::point_m;
use super::tree::Tree;
use crate::model::{BodyId, Model, OutputKind, PointId, QuantityId, Values};
use loosepin_flexible::Cuts;
use loosepin_math::Vec2;
use std::sync::Arc;

/// Cuts at which the stress is summed up: between two of them the largest of n half waves is missed by at most n²/3300 of it.
const CUTS: usize = 65;

/// A link whose stress is an output.
#[derive(Debug, Clone)]
pub struct StressedBody {
    /// The body, which has a beam.
    pub body: BodyId,
    /// Indices of the points at root and tip of its beam.
    pub ends: [usize; 2],
    /// Where it is cut.
    pub cuts: Arc<Cuts>,
}

impl StressedBody {
    /// Every body of which an output asks for the stress, once.
    pub(super) fn all(model: &Model, real: &Tree) -> Vec<Self> {
        let mut found: Vec<Self> = Vec::new();
        for output in &model.outputs {
            let OutputKind::Stress(body) = output.kind else { continue };
            let Some(beam) = &model.bodies[body.0].beam else { continue };
            if found.iter().any(|stressed| stressed.body == body) {
                continue;
            }
            let in_tree = real.beams.iter().find(|in_tree| in_tree.body == body);
            let cuts = Cuts::new(beam.frame, beam.axial_shapes, beam.lateral_shapes, CUTS);
            let ends = in_tree.map_or(beam.ends, |in_tree| in_tree.points());
            found.push(Self { body, ends, cuts: Arc::new(cuts) });
        }
        found
    }
}

/// Numbers of a link whose stress is an output. They are no numbers of the lanes: stress is read off plain states.
#[derive(Debug, Clone, Copy)]
pub struct SectionNumbers {
    /// Root and tip of the beam in the frame of the body, m.
    pub ends_m: [Vec2<f64>; 2],
    /// Length L, m.
    pub length_m: f64,
    /// Mass, kg.
    pub mass_kg: f64,
    /// Area A of the section, m².
    pub area_m2: f64,
    /// Section modulus W = I/c, c half the height of the section, m³.
    pub modulus_m3: f64,
}

impl SectionNumbers {
    /// The numbers of a link; not numbers where a value is missing, which reading a model excludes.
    pub(super) fn new(model: &Model, stressed: &StressedBody, values: &Values) -> Self {
        let body = &model.bodies[stressed.body.0];
        let number = |id: Option<QuantityId>| id.map_or(f64::NAN, |id| values[id]);
        let beam = body.beam.as_ref();
        let height_m = number(beam.and_then(|beam| beam.height_m));
        Self {
            ends_m: stressed.ends.map(|point| point_m(model, values, PointId { body: stressed.body, point })),
            length_m: number(beam.map(|beam| beam.length_m)),
            mass_kg: number(body.mass_kg),
            area_m2: number(beam.map(|beam| beam.area_m2)),
            modulus_m3: number(beam.map(|beam| beam.second_moment_m4)) / (0.5 * height_m),
        }
    }
}
