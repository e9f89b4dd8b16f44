//! A journal that may lean in its bearing: one section. Checked at one pose, and counted.

use loosepin_math::Real;
use loosepin_mechanics::contact::{NormalContact, NormalLaw, PlayState, PointContact};
use loosepin_tape::native::{OperationCounts, Program, Slot};
use loosepin_tape::trace::{Traced, record};
use parts::{Matrix3, Vector3};

/// A body's part of a joint: the point, its velocity, the spin and the axis.
#[derive(Debug, Clone, Copy)]
pub struct Side<T> {
    pub point: Vector3<T>,
    pub velocity: Vector3<T>,
    pub spin: Vector3<T>,
    pub axis: Vector3<T>,
}

/// What a section of the bearing feels.
#[derive(Debug, Clone, Copy)]
pub struct Section<T> {
    pub penetration: T,
    pub rate: T,
    /// Where the force acts on the journal's body, from the bearing's point.
    pub place: Vector3<T>,
    /// Force on the journal.
    pub force: Vector3<T>,
}

/// The section at `height` on the axis of the bearing, with a share of the stiffness.
#[inline(always)]
pub fn section<T: Real>(
    [bearing, journal]: &[Side<T>; 2],
    [height, clearance, share]: [T; 3],
    law: &NormalLaw<T>,
    state: &PlayState<T>,
) -> Section<T> {
    let (a, b, apart) = (bearing.axis, journal.axis, journal.point - bearing.point);
    let inverse = T::one() / a.dot(b);
    let along = (height - a.dot(apart)) * inverse;
    let pierced = apart.plus(b, along);
    let eccentricity = pierced.plus(a, -height);
    let squared = eccentricity.dot(eccentricity);
    let length = squared.sqrt();
    let n = eccentricity * (T::one() / length.max(T::from_f64(f64::MIN_POSITIVE)));
    // The gradient of the penetration: it is normal to the surface of the pin.
    let normal = n.plus(a, -(n.dot(b) * inverse));
    let velocity = |side: &Side<T>, arm: Vector3<T>| side.velocity.plus_cross(side.spin, arm);
    let rate = normal.dot(velocity(journal, b * along) - velocity(bearing, pierced));
    let penetration = (squared - clearance.squared()) / (length + clearance);
    let force = law.force(penetration * state.contact, rate, state).total_n * share;
    Section { penetration, rate, place: pierced, force: normal * -force }
}

/// Penetrations, rates and force of both ends at one pose, against known ones.
pub fn one_pose() {
    let journal = Matrix3::of_quaternion(quaternion([0.003, -0.002, 0.4]));
    let z = Vector3([0.0, 0.0, 1.0]);
    let sides = [
        Side { point: Vector3::zero(), velocity: Vector3::zero(), spin: Vector3([0.5, -1.0, 4.0]), axis: z },
        Side {
            point: Vector3([0.17e-3, 0.12e-3, 0.105e-3]),
            velocity: Vector3([0.3, -0.2, 0.1]),
            spin: Vector3([1.0, 2.0, -3.0]),
            axis: journal.turn(z),
        },
    ];
    let law =
        NormalLaw::Point(PointContact { stiffness_n_m_n: 1.061538462e11, exponent: 1.5, damping_factor: 0.75 * 0.19 });
    let known =
        [(-0.01, 3.938627541569e-5, 0.08241718136864, 14989.229784), (0.01, -2.076864686e-5, 0.1886654470794, 0.0)];
    for (height, penetration, rate, force) in known {
        let state = PlayState { contact: 1.0, inverse_impact_speed_s_m: 1.0 / rate, effective_mass_kg: 0.0 };
        let found = section(&sides, [height, 0.2e-3, 0.5], &law, &state);
        let of_force = found.force.dot(found.force).sqrt() / slope(&sides, &found);
        println!(
            "leaning journal at {height} m: penetration {:e} m, rate {} m/s, force {of_force} N",
            found.penetration, found.rate
        );
        assert!((found.penetration - penetration).abs() < 1e-14 && (found.rate - rate).abs() < 1e-12);
        assert!((of_force - force).abs() < 1e-4);
    }
}

/// |N|, which is not quite one.
fn slope([bearing, journal]: &[Side<f64>; 2], section: &Section<f64>) -> f64 {
    let across = section.place.plus(bearing.axis, -bearing.axis.dot(section.place));
    let n = across * (1.0 / across.dot(across).sqrt());
    (1.0 + (n.dot(journal.axis) / bearing.axis.dot(journal.axis)).powi(2)).sqrt()
}

fn quaternion(rotation: [f64; 3]) -> [f64; 4] {
    let vector = Vector3(rotation);
    let angle = vector.dot(vector).sqrt();
    let (sine, cosine) = (0.5 * angle).sin_cos();
    let [x, y, z] = (vector * (sine / angle)).0;
    [cosine, x, y, z]
}

/// Operations of `sections` sections, as forces on the journal and moments about its point and the bearing's; where all is in a plane, with
/// axes along z.
pub fn operations(sections: usize, is_planar: bool) -> OperationCounts {
    let (graph, outputs) = record(|| {
        let mut next = 0;
        let mut input = || {
            next += 1;
            Traced::input(Slot { block: 0, index: next - 1 })
        };
        let [zero, one] = [Traced::zero(), Traced::one()];
        let mut side = || {
            let mut vector = |planar: [bool; 3], known: [Traced; 3]| {
                Vector3([0, 1, 2].map(|k| if is_planar && !planar[k] { known[k] } else { input() }))
            };
            let flat = [true, true, false];
            Side {
                point: vector(flat, [zero; 3]),
                velocity: vector(flat, [zero; 3]),
                spin: vector([false, false, true], [zero; 3]),
                axis: vector([false; 3], [zero, zero, one]),
            }
        };
        let sides = [side(), side()];
        let law = NormalLaw::Point(PointContact { stiffness_n_m_n: input(), exponent: 1.5, damping_factor: input() });
        let (clearance, length) = (input(), input());
        let zero3 = Vector3::zero();
        let (mut force, mut moments) = (zero3, [zero3; 2]);
        for k in 0..sections {
            let state = PlayState { contact: input(), inverse_impact_speed_s_m: input(), effective_mass_kg: zero };
            let height = if k == 0 { -length } else { length };
            let share = Traced::from_f64(1.0 / sections as f64);
            let height = if sections == 1 { zero } else { height };
            let found = section(&sides, [height, clearance, share], &law, &state);
            force = force + found.force;
            moments[0] = moments[0].plus_cross(found.force, found.place);
            let arm = found.place - (sides[1].point - sides[0].point);
            moments[1] = moments[1].plus_cross(arm, found.force);
        }
        let numbers = [force, moments[0], moments[1]].into_iter().flat_map(|vector| vector.0);
        let slot = |index: usize| Slot { block: 1, index: index as u32 };
        // In the plane nothing else is asked for: the force, and moments about z.
        let asked = |index: &usize| !is_planar || [0, 1, 5, 8].contains(index);
        let outputs = numbers.enumerate().filter(|(index, _)| asked(index));
        outputs.map(|(index, number)| (slot(index), number.value())).collect::<Vec<_>>()
    });
    Program::new(&graph, &outputs).expect("one slot each").counts()
}
