//! Beams at rest under a load, by Newton's method with load steps.

use super::beam::NodalBeam;
use super::mesh::{Mesh, Nodal};
use loosepin_math::{Envelope, Vec2};

/// Newton steps for each share of the load.
const NEWTON_STEPS: usize = 40;
/// Change of slopes, or of positions over the length, after which one more step reaches round-off.
const NEARLY_BALANCED: f64 = 1e-8;
/// Change that is far: the step of the load was too long.
const FAR: f64 = 10.0;
/// Least share of the load that is added at once.
const MIN_SHARE: f64 = 1e-4;

/// A root whose section is held: position and direction of r' are given, its length |r'| is free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClampedRoot {
    /// r at the root, m.
    pub root_m: Vec2<f64>,
    /// Direction of r' there, a unit vector.
    pub axis: Vec2<f64>,
}

/// A load on the tip whose direction does not turn with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TipLoad {
    /// Force, N.
    pub force_n: Vec2<f64>,
    /// Couple, N m, anticlockwise.
    pub couple_n_m: f64,
}

/// No balance was found up to the whole load, or none that is stable: the beam buckles or snaps through before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NoStableEquilibrium {
    /// Share of the load at which the last balance was found.
    pub share: f64,
}

impl std::fmt::Display for NoStableEquilibrium {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "no stable balance beyond {} of the load", self.share)
    }
}

impl std::error::Error for NoStableEquilibrium {}

impl NodalBeam<f64> {
    /// Nodes of the beam at rest, clamped at its root, under its weight by `gravity_m_s2` and a load on its tip. The load grows in
    /// `steps` >= 1 steps, shorter ones where Newton's method does not find the balance.
    ///
    /// # Errors
    /// There is no balance, or it is not stable.
    pub fn at_rest(
        &self,
        mesh: &Mesh,
        clamped: &ClampedRoot,
        gravity_m_s2: Vec2<f64>,
        load: &TipLoad,
        steps: usize,
    ) -> Result<Vec<Nodal<f64>>, NoStableEquilibrium> {
        let mut balance = Balance::new(self, mesh, clamped, gravity_m_s2, load);
        let mut nodes = self.straight(mesh, clamped.root_m, clamped.axis);
        let (mut share, mut growth) = (0.0, 1.0 / steps.max(1) as f64);
        while share < 1.0 {
            let next = (share + growth).min(1.0);
            let mut tried = nodes.clone();
            if balance.find(next, &mut tried) {
                (nodes, share) = (tried, next);
            } else {
                growth *= 0.5;
                if growth < MIN_SHARE {
                    return Err(NoStableEquilibrium { share });
                }
            }
        }
        Ok(nodes)
    }
}

/// The equations of balance. Unknowns: |r'| of the root, then position and slope of each further node.
struct Balance<'b> {
    beam: &'b NodalBeam<f64>,
    mesh: &'b Mesh,
    axis: Vec2<f64>,
    gravity_m_s2: Vec2<f64>,
    load: &'b TipLoad,
    envelope: Envelope,
    tangent: Vec<f64>,
    change: Vec<f64>,
}

impl<'b> Balance<'b> {
    fn new(
        beam: &'b NodalBeam<f64>,
        mesh: &'b Mesh,
        clamped: &ClampedRoot,
        gravity_m_s2: Vec2<f64>,
        load: &'b TipLoad,
    ) -> Self {
        let unknowns = 1 + 4 * mesh.elements();
        // An unknown of node k meets those of node k - 1 on.
        let first = |unknown: usize| match unknown {
            0..=4 => 0,
            _ => 1 + 4 * ((unknown - 1) / 4 - 1),
        };
        Self {
            beam,
            mesh,
            axis: clamped.axis,
            gravity_m_s2,
            load,
            envelope: Envelope::new((0..unknowns).map(first).collect()),
            tangent: vec![0.0; unknowns * unknowns],
            change: vec![0.0; unknowns],
        }
    }

    /// Moves `nodes` to the balance under `share` of the load; false where it is not found or not stable.
    fn find(&mut self, share: f64, nodes: &mut [Nodal<f64>]) -> bool {
        let mut is_near = false;
        for _ in 0..NEWTON_STEPS {
            self.set(share, nodes);
            self.envelope.factor_ldl(&mut self.tangent);
            self.envelope.solve_ldl(&self.tangent, &mut self.change);
            let largest = self.take(nodes);
            if !(largest < FAR) {
                return false;
            }
            if is_near {
                let unknowns = self.change.len();
                return (0..unknowns).all(|row| self.tangent[row * unknowns + row] > 0.0);
            }
            is_near = largest < NEARLY_BALANCED;
        }
        false
    }

    /// Forces that are left, and their slopes.
    fn set(&mut self, share: f64, nodes: &[Nodal<f64>]) {
        let Self { beam, mesh, axis, gravity_m_s2, load, tangent, change, .. } = self;
        let (unknowns, last) = (change.len(), mesh.elements());
        let mut forces = vec![Nodal::zero(); nodes.len()];
        beam.add_elastic(mesh, nodes, &mut forces);
        beam.add_weight(mesh, *gravity_m_s2 * share, &mut forces);
        // A couple T turns the section: its force on r' is T k × r'/|r'|².
        let slope = nodes[last].slope;
        let inverse = 1.0 / slope.length_squared();
        let couple_n_m = share * load.couple_n_m;
        forces[last].position += load.force_n * share;
        forces[last].slope += slope.turned() * (couple_n_m * inverse);
        change[0] = axis.dot(forces[0].slope);
        for (force, rows) in forces[1..].iter().zip(change[1..].chunks_exact_mut(4)) {
            rows.copy_from_slice(&[force.position.x, force.position.y, force.slope.x, force.slope.y]);
        }

        tangent.fill(0.0);
        for element in 0..last {
            let matrix = beam.tangent(mesh, &[nodes[element], nodes[element + 1]]);
            // Each coordinate of the element as a share of an unknown; those of the root's position are held.
            let unknown = |coordinate: usize| -> Option<(usize, f64)> {
                match (4 * element + coordinate).checked_sub(4) {
                    Some(free) => Some((1 + free, 1.0)),
                    None if coordinate == 2 => Some((0, axis.x)),
                    None if coordinate == 3 => Some((0, axis.y)),
                    None => None,
                }
            };
            for (i, row_of) in matrix.iter().enumerate() {
                let Some((row, of_row)) = unknown(i) else { continue };
                for (j, entry) in row_of.iter().enumerate() {
                    let Some((column, of_column)) = unknown(j) else { continue };
                    tangent[row * unknowns + column] += of_row * of_column * entry;
                }
            }
        }
        // -∂(T k × r'/|r'|²)/∂r' = T (r' (k × r')ᵀ + (k × r') r'ᵀ)/|r'|⁴.
        let (turned, factor) = (slope.turned(), couple_n_m * inverse * inverse);
        let at = unknowns - 2;
        tangent[at * unknowns + at] += factor * 2.0 * slope.x * turned.x;
        tangent[(at + 1) * unknowns + at + 1] += factor * 2.0 * slope.y * turned.y;
        let mixed = factor * (slope.x * turned.y + slope.y * turned.x);
        tangent[at * unknowns + at + 1] += mixed;
        tangent[(at + 1) * unknowns + at] += mixed;
    }

    /// Adds the change to `nodes`. The largest change of a slope, or of a position over the length.
    fn take(&self, nodes: &mut [Nodal<f64>]) -> f64 {
        nodes[0].slope = nodes[0].slope.plus(self.axis, self.change[0]);
        let mut largest = self.change[0].abs();
        for (node, change) in nodes[1..].iter_mut().zip(self.change[1..].chunks_exact(4)) {
            node.position += Vec2::new(change[0], change[1]);
            node.slope += Vec2::new(change[2], change[3]);
            let way = change[0].abs().max(change[1].abs()) / self.beam.length_m;
            let share = way.max(change[2].abs()).max(change[3].abs());
            largest = if share.is_finite() { largest.max(share) } else { f64::INFINITY };
        }
        largest
    }
}
