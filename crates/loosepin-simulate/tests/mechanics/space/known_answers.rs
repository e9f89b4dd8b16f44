//! What only space has, against answers of others.

use super::{Body, Loop, Run, axes, link, tree_of, unturned, vector};
use loosepin_math::{Geometry, Space, SpaceMount, Vec3, Vector};
use loosepin_mechanics::mechanism::{Ball, CutNumbers, Free, Revolute};
use loosepin_mechanics::model::MarkerAxis::{X, Y, Z};
use loosepin_mechanics::model::{JointId, SpaceRow};

/// Jacobi's closed form of a free body (1, 2, 3)e-3 kg m² that begins to spin with (2, 0.3, 6) rad/s: its spin after 20 s in its own axes, to
/// eight digits.
#[test]
fn known_answer_a_torque_free_body_spins_as_jacobi_says() {
    let numbers = link([[0.0; 3]; 2], unturned(), 1.0, [1e-3, 2e-3, 3e-3]);
    let body = Body { parent_slot: 0, attachment: Free.into(), is_driven: false, numbers };
    let (tree, numbers) = tree_of(&[body], &[], vector([0.0; 3]));
    let mut run = Run::new(&tree, &numbers, |_| [0.0; 3]);
    let mut state = vec![0.0; 13];
    state[3] = 1.0;
    state[10..].copy_from_slice(&[2.0, 0.3, 6.0]);
    const STEPS: usize = 40_000;
    let length_s = 20.0 / STEPS as f64;
    for step in 0..STEPS {
        state = run.step(step as f64 * length_s, &state, length_s);
    }
    for (found, known) in state[10..].iter().zip([1.909_699_13, -0.665_619_43, 5.990_185_05]) {
        assert!((found - known).abs() < 1e-8, "{:?}", &state[10..]);
    }
}

/// A four-bar with a ball at each end of its coupler and play at the second one, whose ball flies until it first touches its socket. Known are
/// time and speed of that touch from a program that shares nothing with this one, see `measured/plane-and-space.md`.
#[test]
fn known_answer_the_ball_of_a_four_bar_touches_its_socket_when_another_program_says() {
    const CLEARANCE_M: f64 = 2e-4;
    let pivot = axes([0.0, 0.0, 1.0], [0.6, 0.8, 0.0]);
    let revolute = |joint| Revolute { joint: JointId(joint), forward: true, turns_alone: false }.into();
    let bodies = [
        Body {
            parent_slot: 0,
            attachment: revolute(0),
            is_driven: true,
            numbers: link([[0.0; 3], [-0.025, 0.0, 0.0]], unturned(), 0.3, [1e-4; 3]),
        },
        Body {
            parent_slot: 1,
            attachment: Ball { joint: JointId(1), forward: true }.into(),
            is_driven: false,
            numbers: link([[0.025, 0.0, 0.0], [-0.125, 0.0, 0.0]], unturned(), 0.25, [2e-5, 1.4e-3, 1.4e-3]),
        },
        Body {
            parent_slot: 0,
            attachment: revolute(2),
            is_driven: false,
            numbers: link([[0.22, 0.04, 0.06], [-0.06, 0.0, 0.0]], pivot, 0.4, [1e-4, 5e-4, 5e-4]),
        },
    ];
    let (tree, numbers) = tree_of(&bodies, &[], vector([0.0, 0.0, -9.81]));
    const SPEED_RAD_S: f64 = 31.41592653589793;
    let mut run = Run::new(&tree, &numbers, |time_s| [0.3 + SPEED_RAD_S * time_s, SPEED_RAD_S, 0.0]);

    // Where the reference begins: unit quaternions and spins of coupler and rocker.
    let coupler = [0.9748215445983072, 0.21203741342300184, 0.014668770809969069, -0.06743825812384392];
    let coupler_spin = vector([0.28627521898609914, 4.137024216681809, -4.102523228134192]);
    let rocker = [0.7070551295681634, -0.5605161654250668, 0.43107032871351664, 0.008546563715773314];
    let rocker_spin = vector([6.57975621228646, 8.773008283048615, 0.0]);
    let turned = |quaternion: &[f64]| Space::oriented(quaternion, None);
    let rotations = [&unturned(), &turned(&rocker)];
    let spins = [vector([0.0; 3]), rocker_spin];
    let [angle_rad, rate_rad_s] = Space::angle_between(rotations, spins, &numbers.links[2].mount, false);
    let own_spin = Space::turn_back(&turned(&coupler), coupler_spin);
    let mut state = coupler.to_vec();
    state.push(angle_rad);
    state.extend([own_spin.x, own_spin.y, own_spin.z, rate_rad_s]);

    let depth = |run: &mut Run<'_>, time_s: f64, state: &[f64]| {
        run.slope(time_s, state);
        let [coupler, rocker] = [2, 3].map(|slot| (&run.kinematics.poses[slot], &run.kinematics.twists[slot]));
        let arms = [coupler.0.turn(vector([0.125, 0.0, 0.0])), rocker.0.turn(vector([0.06, 0.0, 0.0]))];
        let gap_m = coupler.0.position_m + arms[0] - rocker.0.position_m - arms[1];
        let gap_rate_m_s = coupler.1.at(arms[0]) - rocker.1.at(arms[1]);
        let distance_m = gap_m.inner(gap_m).sqrt();
        [distance_m - CLEARANCE_M, gap_m.inner(gap_rate_m_s) / distance_m]
    };
    const STEPS: usize = 322;
    let length_s = 0.00322 / STEPS as f64;
    for step in 0..STEPS {
        state = run.step(step as f64 * length_s, &state, length_s);
    }
    let [mut low_s, mut high_s] = [0.0, 2e-5];
    while high_s - low_s > 1e-16 {
        let middle_s = 0.5 * (low_s + high_s);
        let after = run.step(0.00322, &state, middle_s);
        let is_before = depth(&mut run, 0.00322 + middle_s, &after)[0] < 0.0;
        [low_s, high_s] = if is_before { [middle_s, high_s] } else { [low_s, middle_s] };
    }
    let touch = run.step(0.00322, &state, high_s);
    let [_, speed_m_s] = depth(&mut run, 0.00322 + high_s, &touch);
    assert!((0.00322 + high_s - 0.003_229_996_881_477_08).abs() < 1e-13, "{}", 0.00322 + high_s);
    assert!((speed_m_s - 0.122_142_074_844_329).abs() < 1e-11, "{speed_m_s}");
}

/// Bricard's mechanism: five rods of 1 kg on six revolute joints at right angles, which falls under gravity. The five constraints of the joint that
/// closes the loop have rank four: one repeats the others. Known are places of a point to ten digits, from a program
/// that shares nothing with this one, see `measured/plane-and-space.md`.
#[test]
fn known_answer_bricards_mechanism_falls_as_another_program_says() {
    const WIDTH_M: f64 = 0.1;
    let points =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, -1.0, 0.0], [1.0, -1.0, 1.0], [0.0, -1.0, 1.0], [0.0, 0.0, 1.0]];
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // All bodies begin along the ground.
    let markers = [y, z, x, y, z, x].map(|axis| axes(if axis == x { y } else { x }, axis));
    let middle = |body: usize| (vector(points[body]) + vector(points[body + 1])) * 0.5;
    let body = |index: usize| {
        let before = if index == 0 { vector([0.0; 3]) } else { middle(index - 1) };
        let along = (vector(points[index + 1]) - vector(points[index])).to_array();
        let moments =
            along.map(|share| if share == 0.0 { (1.0 + WIDTH_M * WIDTH_M) / 12.0 } else { WIDTH_M * WIDTH_M / 6.0 });
        let arms = [vector(points[index]) - before, vector(points[index]) - middle(index)].map(Vec3::to_array);
        let mut numbers = link(arms, markers[index], 1.0, moments);
        numbers.mount = SpaceMount::new(markers[index], markers[index]);
        let attachment = Revolute { joint: JointId(index), forward: true, turns_alone: false }.into();
        Body { parent_slot: index, attachment, is_driven: false, numbers }
    };
    const HINGE: &[SpaceRow] = &[SpaceRow::Coincident, SpaceRow::Perpendicular(X, Z), SpaceRow::Perpendicular(Y, Z)];
    let closing = CutNumbers {
        arms_m: [vector(points[5]) - middle(4), vector(points[5])],
        markers: [markers[5]; 2],
        eccentricity_m: vector([0.0; 3]),
        radius_m: 0.0,
    };
    let closing = Loop { slots: [5, 0], rows: HINGE, numbers: closing };
    let bodies: Vec<Body> = (0..5).map(body).collect();
    let (tree, numbers) = tree_of(&bodies, &[closing], vector([0.0, -9.81, 0.0]));
    let mut run = Run::new(&tree, &numbers, |_| [0.0; 3]);
    let mut state = vec![0.0; 10];
    let known = [
        (0.5, [0.968_283_679_1, -1.224_625_159_4, 0.750_146_609_4]),
        (1.0, [0.510_501_461_2, -1.649_167_599_4, 0.140_123_114_6]),
        (2.0, [-0.969_340_344_8, -1.221_246_895_0, 0.754_278_010_8]),
    ];
    const STEPS_PER_S: usize = 16_000;
    let mut step = 0;
    for (at_s, known) in known {
        while step < (at_s * STEPS_PER_S as f64) as usize {
            let length_s = 1.0 / STEPS_PER_S as f64;
            state = run.step(step as f64 * length_s, &state, length_s);
            step += 1;
        }
        run.slope(at_s, &state);
        let found = run.kinematics.poses[3].point_m(vector([0.0, 0.0, 0.5]));
        let apart_m = (found - vector(known)).length();
        assert!(apart_m < 1e-9, "{apart_m:e} m at {at_s} s");
    }
}
