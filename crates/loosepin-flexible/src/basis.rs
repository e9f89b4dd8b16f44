//! The functions in which a beam bends and stretches.

use super::functions::{self, Frame};
use super::point_shapes::{PointShape, point_shapes, span_rule};
use super::station::Station;

/// The shapes of a beam in a frame, with static shapes at points inside where it has such points.
#[derive(Debug, Clone, PartialEq)]
pub struct Basis {
    axial: Vec<AxialShape>,
    lateral: LateralShapes,
    /// Shares of the length at which spans meet, with 0 and 1.
    nodes: Vec<f64>,
}

/// A stretch of a beam on which all its functions are smooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Share of the length at which it begins.
    pub start: f64,
    /// Share of the length at which it ends.
    pub end: f64,
    /// Points of Gauss on it.
    pub points: usize,
}

impl Span {
    /// Place on the span, from -1 to 1.
    pub(crate) fn local(&self, share: f64) -> f64 {
        (2.0 * share - self.start - self.end) / (self.end - self.start)
    }
}

/// An axial shape.
#[derive(Debug, Clone, Copy, PartialEq)]
enum AxialShape {
    /// s: the static shape of the tip.
    Ramp,
    /// One at a node and zero at its neighbours: the static shape of a point inside.
    Hat { node: usize },
    /// A sine with this number of half waves on the span after a node.
    Sine { node: usize, half_waves: usize },
}

/// The lateral shapes.
#[derive(Debug, Clone, PartialEq)]
enum LateralShapes {
    /// Those of [`functions::lateral`].
    OfFrame { frame: Frame, count: usize },
    /// With static shapes at the points inside.
    OfPoints(Vec<PointShape>),
}

impl Basis {
    /// `axial` and `lateral` shapes of a frame, and one more of each kind at each of the shares `inside`, ascending and within 0 and 1.
    ///
    /// Without points inside the axial shapes are s, sin(πs), sin(2πs), …, and the lateral ones those of [`Frame`]. With points inside there are
    /// static shapes for a force at each of them, and the lowest modes with these points held (generalised Craig-Bampton). Kinds
    /// without any shape stay without.
    pub fn new(frame: Frame, [axial, lateral]: [usize; 2], inside: &[f64]) -> Self {
        if inside.is_empty() || lateral == 0 {
            let nodes = [&[0.0], inside, &[1.0]].concat();
            let lateral = LateralShapes::OfFrame { frame, count: lateral };
            return Self { axial: axial_shapes(axial, &nodes), lateral, nodes };
        }
        Self::with_modes(frame, [axial, lateral], inside)
    }

    /// As [`Basis::new`] with points inside, and static lateral shapes even without modes beside them.
    pub(crate) fn with_modes(frame: Frame, [axial, modes]: [usize; 2], inside: &[f64]) -> Self {
        let nodes = [&[0.0], inside, &[1.0]].concat();
        let lateral = LateralShapes::OfPoints(point_shapes(frame, &nodes, modes));
        Self { axial: axial_shapes(axial, &nodes), lateral, nodes }
    }

    /// Shares of the length at which there are static shapes.
    pub fn inside(&self) -> &[f64] {
        &self.nodes[1..self.nodes.len() - 1]
    }

    /// Number of axial shapes.
    pub fn axial_count(&self) -> usize {
        self.axial.len()
    }

    /// Number of lateral shapes.
    pub fn lateral_count(&self) -> usize {
        match &self.lateral {
            LateralShapes::OfFrame { count, .. } => *count,
            LateralShapes::OfPoints(shapes) => shapes.len(),
        }
    }

    /// Stretches on which all functions are smooth, and points of Gauss on each: 8 and four for each further shape of the kind that has more of
    /// them, which leaves 1e-10 of the integrals for one shape and round-off from two on. With points inside: 6 on each span and four for
    /// each shape that falls on it.
    pub fn spans(&self) -> Vec<Span> {
        let most = self.axial_count().max(self.lateral_count());
        let points = |length: f64| match self.nodes.len() {
            2 => 8 + 4 * most,
            _ => 6 + (4.0 * most as f64 * length).ceil() as usize,
        };
        self.nodes
            .windows(2)
            .map(|ends| Span { start: ends[0], end: ends[1], points: points(ends[1] - ends[0]) })
            .collect()
    }

    /// The shapes at places along the beam.
    pub fn stations(&self, shares: &[f64]) -> Vec<Station> {
        let spans = self.spans();
        shares.iter().map(|share| self.station(*share, &spans)).collect()
    }

    /// ψ and dψ/ds of the axial shape `index` at s.
    pub(crate) fn axial(&self, index: usize, s: f64) -> [f64; 2] {
        match self.axial[index] {
            AxialShape::Ramp => functions::axial(0, s),
            AxialShape::Hat { node } => {
                let [before, at, after] = [node - 1, node, node + 1].map(|node| self.nodes[node]);
                if s <= before || s >= after {
                    [0.0, 0.0]
                } else if s < at {
                    [(s - before) / (at - before), 1.0 / (at - before)]
                } else {
                    [(after - s) / (after - at), -1.0 / (after - at)]
                }
            }
            AxialShape::Sine { node, half_waves } => {
                let (start, end) = (self.nodes[node], self.nodes[node + 1]);
                if s < start || s > end {
                    return [0.0, 0.0];
                }
                let length = end - start;
                let [value, slope] = functions::axial(half_waves, (s - start) / length);
                [value, slope / length]
            }
        }
    }

    /// φ/L, φ' and dφ'/ds of the lateral shape `index` at s.
    pub(crate) fn lateral(&self, index: usize, s: f64) -> [f64; 3] {
        match &self.lateral {
            LateralShapes::OfFrame { frame, .. } => functions::lateral(*frame, index, s),
            LateralShapes::OfPoints(shapes) => {
                let span = self.inside().iter().filter(|node| **node <= s).count();
                shapes[index].values(&self.nodes, span, s)
            }
        }
    }

    /// The shapes at `share`; H is integrated span by span.
    pub(crate) fn station(&self, share: f64, spans: &[Span]) -> Station {
        let up_to = spans
            .iter()
            .filter(|span| span.start < share || span.start == 0.0)
            .flat_map(|span| span_rule(span.start, span.end.min(share), span.points));
        Station::at(
            share,
            (self.axial_count(), &|index, s| self.axial(index, s)),
            (self.lateral_count(), &|index, s| self.lateral(index, s)),
            up_to,
        )
    }
}

/// The ramp, a hat at each node inside, and the sines of the spans by frequency.
fn axial_shapes(count: usize, nodes: &[f64]) -> Vec<AxialShape> {
    if count == 0 {
        return Vec::new();
    }
    let mut shapes = vec![AxialShape::Ramp];
    shapes.extend((1..nodes.len() - 1).map(|node| AxialShape::Hat { node }));
    let mut sines: Vec<(f64, usize, usize)> = nodes
        .windows(2)
        .enumerate()
        .flat_map(|(node, ends)| (1..count).map(move |waves| (waves as f64 / (ends[1] - ends[0]), node, waves)))
        .collect();
    sines.sort_by(|one, other| one.0.total_cmp(&other.0));
    let lowest = sines.into_iter().take(count - 1);
    shapes.extend(lowest.map(|(_, node, half_waves)| AxialShape::Sine { node, half_waves }));
    shapes
}
