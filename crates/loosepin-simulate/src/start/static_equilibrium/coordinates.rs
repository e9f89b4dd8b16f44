//! Coordinates that do not change while flexible bodies move as rigid ones.
//!
//! Shapes of the floating frame are such coordinates. The nodes of a beam in absolute nodal coordinates are seen from the ground; here each
//! of them is seen from the section of the node before it, so that the strains depend on few of them and Newton's method takes large
//! rotations in a step:
//!
//! ```text
//! p_k = p_(k-1) + A(β_(k-1)) c_k,  β_k = β_(k-1) + Δ_k        node k from the section at the root; coordinates c_k, Δ_k, s_k
//! r = R + A(φ + α) p,  r' = s (cos θ, sin θ),  θ = φ + α + β     R the root, φ the angle of the frame
//! ```
//!
//! The frame turns with the section at the root where that is held, α = 0; else it goes through root and tip, and its angle φ takes the place of
//! that of the section, φ + α. In the frame, d = A(α) p, nodes at rest have the accelerations
//!
//! ```text
//! d̈ = A(φ)ᵀ(r̈ - R̈) - φ̈ k×d + φ̇² d,   θ̈ - φ̈,   φ̈ = (k×d)·A(φ)ᵀ(r̈ - R̈)/|d|² of the frame through the tip
//! ```

use crate::stepping::motion::Motion;
use loosepin_math::{Vec2, arctangent};
use loosepin_mechanics::mechanism::{Mechanism, Sample, Tree, TreeNodalBeam, acceleration_at};

/// Coordinates of a mechanism in which beams in absolute nodal coordinates are seen from their frames. As many as those of the tree, each in
/// the place of one of these.
pub(super) struct Coordinates {
    beams: Vec<Carried>,
    /// Shapes and coordinates of nodes that settle.
    pub shapes: Vec<usize>,
    /// Whether each of them is a length.
    pub are_lengths: Vec<bool>,
    /// Coordinates that neither settle nor belong to a beam in absolute nodal coordinates.
    pub others: Vec<usize>,
}

/// A beam in absolute nodal coordinates.
struct Carried {
    /// Index of the angle of its frame, for a frame through root and tip; it takes the place of the angle of the section at its root.
    angle: Option<usize>,
    /// First coordinate of a root that hangs on nothing: place of the body's origin as if the section had the angle of the frame.
    origin: Option<usize>,
    settles: bool,
}

/// A node in the frame of its beam.
#[derive(Clone, Copy)]
struct Node {
    /// d, m, and its rate, m/s.
    place: Vec2<f64>,
    rate: Vec2<f64>,
    /// Angle of the section from the axis of the frame, rad, and its rate, rad/s.
    turn: f64,
    spin: f64,
    /// |r'| and its rate, 1/s.
    s: f64,
    growth_1_s: f64,
}

impl Coordinates {
    pub(super) fn new(mechanism: &Mechanism) -> Self {
        let tree = &mechanism.real;
        let settles = |body: usize| mechanism.model.bodies[body].beam.as_ref().is_some_and(|beam| beam.starts_settled);
        let carried = |beam: &TreeNodalBeam| {
            let link = &tree.links[beam.slot - 1];
            let origin = link.joint().is_none().then_some(link.coordinates.start);
            Carried { angle: link.angle(), origin, settles: settles(beam.body.0) }
        };
        let beams: Vec<Carried> = tree.nodal_beams.iter().map(carried).collect();
        let (mut shapes, mut are_lengths) = (Vec::new(), Vec::new());
        for beam in tree.beams.iter().filter(|beam| settles(beam.body.0)) {
            let axial = beam.axial();
            are_lengths.extend(beam.coordinates.clone().map(|shape| axial.contains(&shape)));
            shapes.extend(beam.coordinates.clone());
        }
        for (beam, _) in tree.nodal_beams.iter().zip(&beams).filter(|(_, carried)| carried.settles) {
            let is_length = |shape: usize| beam.lengths().any(|lengths| lengths.contains(&shape));
            are_lengths.extend(beam.coordinates.clone().map(is_length));
            shapes.extend(beam.coordinates.clone());
        }
        let of_nodes = |place: &usize| tree.nodal_beams.iter().any(|beam| beam.coordinates.contains(place));
        let others = (0..tree.free).filter(|place| !of_nodes(place) && !shapes.contains(place)).collect();
        Self { beams, shapes, are_lengths, others }
    }

    /// Whether a beam in absolute nodal coordinates settles: it may bend far.
    pub(super) fn has_nodes(&self) -> bool {
        self.beams.iter().any(|beam| beam.settles)
    }

    /// Largest sum of the changes by which the elements of a beam turn, rad.
    pub(super) fn turn_rad(&self, tree: &Tree, from: &[f64], to: &[f64]) -> f64 {
        let turns = tree.nodal_beams.iter().map(|beam| {
            let of_element = |node: usize| (to[beam.node(node) + 2] - from[beam.node(node) + 2]).abs();
            (1..beam.mesh.nodes()).map(of_element).sum::<f64>()
        });
        turns.fold(0.0, f64::max)
    }

    /// Divides the stiffness of the beams in absolute nodal coordinates that settle, which is that of `sample`, by the share of the loads that they
    /// are to bear: the static shape is that under this share of all forces and accelerations.
    pub(super) fn bear(&self, motion: &mut Motion<'_, f64>, sample: &Sample<f64>, share: f64) {
        let numbers = motion.dynamics.sample_mut().real.nodal_beams.iter_mut().zip(&sample.real.nodal_beams);
        for ((numbers, own), _) in numbers.zip(&self.beams).filter(|(_, carried)| carried.settles) {
            numbers.beam.axial_stiffness_n_m = own.beam.axial_stiffness_n_m / share;
            numbers.beam.bending_stiffness_n_m = own.beam.bending_stiffness_n_m / share;
        }
    }

    /// Coordinates and rates of a mechanism whose beams in absolute nodal coordinates are undeformed, where those of the tree are `state`.
    pub(super) fn undeformed(&self, motion: &Motion<'_, f64>, state: &[f64]) -> Vec<f64> {
        let (dynamics, n) = (&motion.dynamics, motion.freedoms());
        let tree = &dynamics.mechanism().real;
        let mut relative = state[..2 * n].to_vec();
        for (beam, numbers) in tree.nodal_beams.iter().zip(&dynamics.sample().real.nodal_beams) {
            let last = beam.mesh.elements();
            relative[beam.root_stretch()] = 1.0;
            for node in 1..=last {
                let first = beam.node(node);
                let length_m = numbers.beam.length_m / last as f64;
                relative[first..first + 4].copy_from_slice(&[length_m, 0.0, 0.0, 1.0]);
            }
            relative[n + beam.coordinates.start..n + beam.coordinates.end].fill(0.0);
        }
        relative
    }

    /// The nodes of a beam in its frame, from the root on.
    fn nodes(&self, index: usize, beam: &TreeNodalBeam, relative: &[f64], n: usize) -> Vec<Node> {
        let (s, growth_1_s) = (relative[beam.root_stretch()], relative[n + beam.root_stretch()]);
        let mut at = Node { place: Vec2::zero(), rate: Vec2::zero(), turn: 0.0, spin: 0.0, s, growth_1_s };
        let mut nodes = vec![at];
        for node in 1..beam.mesh.nodes() {
            let first = beam.node(node);
            let (own, rates) = (&relative[first..first + 4], &relative[n + first..n + first + 4]);
            let (sine, cosine) = loosepin_math::sin_cos(at.turn);
            let step = Vec2::new(own[0], own[1]).rotated(sine, cosine);
            let step_rate = Vec2::new(rates[0], rates[1]).rotated(sine, cosine).plus(step.turned(), at.spin);
            at = Node {
                place: at.place + step,
                rate: at.rate + step_rate,
                turn: at.turn + own[2],
                spin: at.spin + rates[2],
                s: own[3],
                growth_1_s: rates[3],
            };
            nodes.push(at);
        }
        if self.beams[index].angle.is_some() {
            // The tip lies on the axis of the frame.
            let (turn, spin) = (
                2.0 * arctangent(at.place.y / (at.place.length() + at.place.x)),
                at.place.cross(at.rate) / at.place.length_squared(),
            );
            let (sine, cosine) = loosepin_math::sin_cos(-turn);
            for node in &mut nodes {
                node.rate = node.rate.plus(node.place.turned(), -spin).rotated(sine, cosine);
                node.place = node.place.rotated(sine, cosine);
                node.turn -= turn;
                node.spin -= spin;
            }
        }
        nodes
    }

    /// Replaces the coordinates and rates in `state`, which is that of a run, by those of the tree for `relative` ones.
    pub(super) fn place(&self, motion: &mut Motion<'_, f64>, time_s: f64, relative: &[f64], state: &mut [f64]) {
        let n = motion.freedoms();
        state[..2 * n].copy_from_slice(&relative[..2 * n]);
        for (index, carried) in self.beams.iter().enumerate() {
            // Beams come after what they hang on, which is in its place by now.
            motion.set_state(time_s, state);
            let beam = &motion.dynamics.mechanism().real.nodal_beams[index];
            let numbers = &motion.dynamics.sample().real.nodal_beams[index];
            let (pose, twist) =
                (&motion.dynamics.kinematics.poses[beam.slot], &motion.dynamics.kinematics.twists[beam.slot]);
            let (arm_m, axis, spin) = (pose.turn(numbers.root_m), pose.turn(numbers.axis), twist.angular);
            let (root_m, root_m_s) = (pose.position_m + arm_m, twist.at(arm_m));
            let nodes = self.nodes(index, beam, relative, n);
            let last = beam.mesh.elements();
            for (k, node) in nodes.iter().enumerate().skip(1) {
                let reach_m = node.place.rotated(axis.y, axis.x);
                let reach_m_s = node.rate.rotated(axis.y, axis.x).plus(reach_m.turned(), spin);
                let (place_m, place_m_s) = (root_m + reach_m, root_m_s + reach_m_s);
                let (sine, cosine) = loosepin_math::sin_cos(node.turn);
                let (direction, turning) = (axis.rotated(sine, cosine), spin + node.spin);
                let slope_rate = (direction * node.growth_1_s).plus(direction.turned(), node.s * turning);
                let [slope, slope_rate] = match k == last {
                    true => [[pose.angle_rad() + node.turn, node.s], [turning, node.growth_1_s]],
                    false => [[direction.x * node.s, direction.y * node.s], [slope_rate.x, slope_rate.y]],
                };
                let first = beam.node(k);
                state[first..first + 2].copy_from_slice(&[place_m.x, place_m.y]);
                state[first + 2..first + 4].copy_from_slice(&slope);
                state[n + first..n + first + 2].copy_from_slice(&[place_m_s.x, place_m_s.y]);
                state[n + first + 2..n + first + 4].copy_from_slice(&slope_rate);
            }
            let Some(angle) = carried.angle else { continue };
            state[angle] += nodes[0].turn;
            state[n + angle] += nodes[0].spin;
            if let Some(first) = carried.origin {
                let (sine, cosine) = loosepin_math::sin_cos(nodes[0].turn);
                let own_m = arm_m.rotated(sine, cosine);
                let (origin_m, origin_m_s) = (root_m - own_m, root_m_s - own_m.turned() * (spin + nodes[0].spin));
                state[first..first + 2].copy_from_slice(&[origin_m.x, origin_m.y]);
                state[n + first..n + first + 2].copy_from_slice(&[origin_m_s.x, origin_m_s.y]);
            }
        }
    }

    /// Accelerations at the last evaluation, at which nodes are at rest in their frames: of the others, and, in the places of the coordinates
    /// of each beam in absolute nodal coordinates, as many of its nodes in its frame, which vanish where its coordinates have none.
    pub(super) fn accelerations(&self, motion: &Motion<'_, f64>, relative: &[f64]) -> Vec<f64> {
        let dynamics = &motion.dynamics;
        let (tree, numbers) = (&dynamics.mechanism().real, &dynamics.sample().real.nodal_beams);
        let mut changes = dynamics.accelerations().to_vec();
        let n = changes.len();
        for (index, (beam, numbers)) in tree.nodal_beams.iter().zip(numbers).enumerate() {
            let carried = &self.beams[index];
            let (pose, twist) = (&dynamics.kinematics.poses[beam.slot], &dynamics.kinematics.twists[beam.slot]);
            let change = dynamics.acceleration(beam.slot);
            let root_m_s2 = acceleration_at(&change, twist, pose.turn(numbers.root_m));
            let nodes = self.nodes(index, beam, relative, n);
            let (sine, cosine) = loosepin_math::sin_cos(-nodes[0].turn);
            let axis = pose.turn(numbers.axis).rotated(sine, cosine);
            let of = |first: usize, less: Vec2<f64>| {
                let found = Vec2::new(dynamics.accelerations()[first], dynamics.accelerations()[first + 1]);
                (found - less).rotated(-axis.y, axis.x)
            };
            let last = beam.mesh.elements();
            let tip = beam.node(last);
            let tip_m_s2 = of(tip, root_m_s2);
            let (spin, spin_change) = match carried.angle {
                Some(angle) => (relative[n + angle], tip_m_s2.y / nodes[last].place.x),
                None => (twist.angular, change.angular),
            };
            let carry =
                |found: Vec2<f64>, own: Vec2<f64>| found.plus(own.turned(), -spin_change).plus(own, spin * spin);
            for (k, node) in nodes.iter().enumerate().take(last).skip(1) {
                let first = beam.node(k);
                let (sine, cosine) = loosepin_math::sin_cos(node.turn);
                let place = carry(of(first, root_m_s2), node.place);
                let slope = carry(of(first + 2, Vec2::zero()), Vec2::new(cosine, sine) * node.s);
                changes[first..first + 4].copy_from_slice(&[place.x, place.y, slope.x, slope.y]);
            }
            let place = carry(tip_m_s2, nodes[last].place);
            changes[tip] = place.x;
            changes[tip + 1] = place.y;
            changes[tip + 2] -= spin_change;
            let Some(angle) = carried.angle else { continue };
            // The tip stays on the axis: the section at the root has an acceleration in place of that across.
            changes[tip + 1] = changes[angle] - spin_change;
            changes[angle] = spin_change;
            if let Some(first) = carried.origin {
                let arm_m = pose.turn(numbers.root_m).rotated(sine, cosine);
                let origin_m_s2 = root_m_s2.plus(arm_m.turned(), -spin_change).plus(arm_m, spin * spin);
                changes[first..first + 2].copy_from_slice(&[origin_m_s2.x, origin_m_s2.y]);
            }
        }
        changes
    }
}
