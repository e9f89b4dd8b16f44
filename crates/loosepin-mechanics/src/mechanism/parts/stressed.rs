//! Links whose stress is an output.

use crate::mechanism::tree::beam::{BeamPlace, SAME_SECTION, share_of};
use crate::mechanism::tree::points::point_m;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::{Body, BodyId, Model, PointId, QuantityId, Values};
use loosepin_flexible::{Basis, Cuts, Frame, even_shares};
use loosepin_math::Vec2;
use std::sync::Arc;

/// Cuts at which the stress is summed up, besides those at points inside: between two of them the largest of n half waves is missed by at
/// most n²/3300 of it.
const CUTS: usize = 65;

/// A link whose stress is an output.
#[derive(Debug, Clone)]
pub struct StressedBody {
    /// The body, which has a beam.
    pub body: BodyId,
    /// Indices of the points at root and tip of its beam: forces are summed up from the tip.
    pub ends: [usize; 2],
    /// Whether this root is the tip in the tree: where only the section there is held, the couple on it is not needed.
    pub is_turned: bool,
    /// Points of the body beyond the root, with the share of the length at which they act.
    pub points: Vec<(usize, f64)>,
    /// Cuts of the beam.
    pub cuts: Arc<Cuts>,
}

impl StressedBody {
    /// Every body of which an output asks for the stress, once.
    pub(in crate::mechanism) fn all(model: &Model, real: &Tree) -> Vec<Self> {
        let mut found: Vec<Self> = Vec::new();
        for output in &model.outputs {
            let Some(body) = output.kind.stressed_body() else { continue };
            if found.iter().any(|stressed| stressed.body == body) {
                continue;
            }
            if let Some(in_tree) = real.beams.iter().find(|in_tree| in_tree.body == body) {
                let acting = |(point, place): (usize, &BeamPlace)| {
                    (*place != BeamPlace::Root).then(|| (point, in_tree.station(*place).share))
                };
                let points: Vec<(usize, f64)> = in_tree.places.iter().enumerate().filter_map(acting).collect();
                let shares = cut_shares(in_tree.shapes.inside.iter().map(|station| station.share));
                let cuts = Arc::new(Cuts::new(&in_tree.basis, &shares));
                found.push(Self { body, ends: in_tree.points(), is_turned: false, points, cuts });
            } else if let Some(in_tree) = real.nodal_beams.iter().find(|in_tree| in_tree.body == body) {
                let own = in_tree.points();
                let is_turned = model.holds_section(PointId { body, point: own[1] });
                let [root, tip] = if is_turned { [own[1], own[0]] } else { own };
                let cuts = Arc::new(Cuts::of_elements(in_tree.mesh.elements(), &cut_shares(std::iter::empty())));
                found.push(Self { body, ends: [root, tip], is_turned, points: vec![(tip, 1.0)], cuts });
            }
        }
        found
    }

    /// Every body with a beam as a rigid link, whatever its formulation: from its `from` on, or from its `to` where only the section there is held.
    pub(in crate::mechanism) fn rigid(model: &Model, values: &Values) -> Vec<Self> {
        let flexible = (0..model.bodies.len()).map(BodyId);
        let cut = |body: BodyId| {
            let Body { points, beam, .. } = &model.bodies[body.0];
            let beam = beam.as_ref()?;
            let [holds_from, holds_to] = beam.ends.map(|point| model.holds_section(PointId { body, point }));
            let is_turned = holds_to && !holds_from;
            let [from, to] = beam.ends;
            let ends = if is_turned { [to, from] } else { [from, to] };
            let share = |point: usize| {
                let share = share_of(model, PointId { body, point }, values).clamp(0.0, 1.0);
                if is_turned { 1.0 - share } else { share }
            };
            let beyond: Vec<(usize, f64)> = (0..points.len())
                .map(|point| (point, share(point)))
                .filter(|(_, share)| *share > SAME_SECTION)
                .collect();
            let shares = cut_shares(beyond.iter().map(|(_, share)| *share));
            let cuts = Arc::new(Cuts::new(&Basis::new(Frame::Secant, [0, 0], &[]), &shares));
            Some(Self { body, ends, is_turned, points: beyond, cuts })
        };
        flexible.filter_map(cut).collect()
    }
}

/// Shares of the length at which a link is cut: evenly, and at its points.
fn cut_shares(points: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut shares = even_shares(CUTS);
    shares.extend(points);
    shares.sort_by(f64::total_cmp);
    shares.dedup();
    shares
}

/// Numbers of a link whose stress is an output. They are no numbers of the lanes: stress is read off plain states.
#[derive(Debug, Clone)]
pub struct SectionNumbers {
    /// Root and tip of the beam in the frame of the body, m.
    pub ends_m: [Vec2<f64>; 2],
    /// The points of [`StressedBody::points`] in the frame of the body, m.
    pub arms_m: Vec<Vec2<f64>>,
    /// Mass, kg, and moment of inertia, kg m², of the lumps at each of these points.
    pub lumps: Vec<[f64; 2]>,
    /// Length L, m.
    pub length_m: f64,
    /// Mass without lumps, kg.
    pub mass_kg: f64,
    /// Area A of the section, m².
    pub area_m2: f64,
    /// Section modulus W = I/c, c half the height of the section, m³.
    pub modulus_m3: f64,
}

impl SectionNumbers {
    /// The numbers of a link; not numbers where a value is missing, which reading a model excludes.
    pub(in crate::mechanism) fn new(model: &Model, stressed: &StressedBody, values: &Values) -> Self {
        let body = &model.bodies[stressed.body.0];
        let number = |id: Option<QuantityId>| id.map_or(f64::NAN, |id| values[id]);
        let beam = body.beam.as_ref();
        let at = |point: usize| point_m(model, values, PointId { body: stressed.body, point });
        let height_m = number(beam.and_then(|beam| beam.height_m));
        let lumps_at = |point: usize| {
            let own = beam.iter().flat_map(|beam| &beam.lumps).filter(|lump| lump.point == point);
            own.fold([0.0; 2], |[mass, inertia], lump| {
                [mass + values[lump.mass_kg], inertia + lump.inertia_kg_m2.map_or(0.0, |id| values[id])]
            })
        };
        Self {
            ends_m: stressed.ends.map(at),
            arms_m: stressed.points.iter().map(|(point, _)| at(*point)).collect(),
            lumps: stressed.points.iter().map(|(point, _)| lumps_at(*point)).collect(),
            length_m: number(beam.map(|beam| beam.length_m)),
            mass_kg: number(beam.map(|beam| beam.mass_kg)),
            area_m2: number(beam.map(|beam| beam.area_m2)),
            modulus_m3: number(beam.map(|beam| beam.second_moment_m4)) / (0.5 * height_m),
        }
    }
}
