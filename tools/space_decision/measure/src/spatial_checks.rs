//! What only space has: a torque-free body, a four-bar with balls and a contact, and Bricard's mechanism, whose rows repeat each other.

use generic::{Kernel, LinkNumbers, Numbers, PlayNumbers, Space, SpaceMount};
use loosepin_math::{Numbers as _, Real};
use loosepin_mechanics::contact::{NormalLaw, PlayState, PointContact};
use loosepin_tape::native::{OperationCounts, Program, Slot};
use loosepin_tape::trace::{Traced, record};
use parts::{Attachment, Counts, Matrix3, Tree, Vector3};
use std::hint::black_box;
use std::time::Instant;

type Link = LinkNumbers<f64, Space>;

/// Runs all checks and prints what they find beside what is known.
pub fn all() {
    torque_free_body();
    four_bar_with_balls();
    bricard();
}

fn unit_mount() -> SpaceMount<f64> {
    SpaceMount { parent: Matrix3::identity(), own: Matrix3::identity() }
}

fn diagonal([x, y, z]: [f64; 3]) -> Matrix3<f64> {
    Matrix3([Vector3([x, 0.0, 0.0]), Vector3([0.0, y, 0.0]), Vector3([0.0, 0.0, z])])
}

/// Axes of a marker by its x and z axes.
fn axes(x: [f64; 3], z: [f64; 3]) -> Matrix3<f64> {
    let (x, z) = (Vector3(x), Vector3(z));
    Matrix3([x, z.cross(x), z]).transposed()
}

/// A run in which coordinates and speeds follow each other in the state.
struct Run<'t> {
    tree: &'t Tree,
    kernel: Kernel<'t, f64, Space>,
    states: Vec<PlayState<f64>>,
    /// Driven coordinate, its rate and its acceleration.
    drive: fn(f64) -> [f64; 3],
}

impl<'t> Run<'t> {
    fn new(tree: &'t Tree, numbers: Numbers<f64, Space>, drive: fn(f64) -> [f64; 3]) -> Self {
        let states = vec![PlayState::flight(); tree.plays.len()];
        Self { tree, kernel: Kernel::new(tree, numbers), states, drive }
    }

    fn slope(&mut self, time: f64, state: &[f64]) -> Vec<f64> {
        let (mut coordinates, mut speeds) =
            (state[..self.tree.free_coordinates].to_vec(), state[self.tree.free_coordinates..].to_vec());
        let [at, rate, acceleration] = (self.drive)(time);
        let driven = vec![acceleration; self.tree.driven];
        coordinates.extend(vec![at; self.tree.driven]);
        speeds.extend(vec![rate; self.tree.driven]);
        self.kernel.evaluate(&coordinates, &speeds, &driven, &self.states);
        let mut slope = vec![0.0; self.tree.free_coordinates];
        self.kernel.coordinate_rates(&coordinates, &speeds, &mut slope);
        slope.extend(&self.kernel.accelerations);
        slope
    }

    /// A step of the classical method of fourth order.
    fn step(&mut self, time: f64, state: &[f64], length: f64) -> Vec<f64> {
        let plus = |slope: &[f64], share: f64| -> Vec<f64> {
            state.iter().zip(slope).map(|(at, slope)| at + share * length * slope).collect()
        };
        let a = self.slope(time, state);
        let b = self.slope(time + 0.5 * length, &plus(&a, 0.5));
        let c = self.slope(time + 0.5 * length, &plus(&b, 0.5));
        let d = self.slope(time + length, &plus(&c, 1.0));
        let sum = |k: usize| (a[k] + 2.0 * (b[k] + c[k]) + d[k]) / 6.0;
        (0..state.len()).map(|k| state[k] + length * sum(k)).collect()
    }
}

impl Run<'_> {
    /// Steps in flight to `until`, then to the next contact by bisection of one step. Its time and its rate.
    fn fly_to_contact(&mut self, time: &mut f64, state: &mut Vec<f64>, until: f64, length: f64) -> (f64, f64) {
        let steps = ((until - *time) / length).ceil();
        let length = (until - *time) / steps;
        for _ in 0..steps as usize {
            *state = self.step(*time, state, length);
            *time += length;
        }
        let (mut low, mut high) = (0.0, 2e-5);
        while high - low > 1e-16 {
            let middle = 0.5 * (low + high);
            let after = self.step(*time, state, middle);
            self.slope(*time + middle, &after);
            let is_before = self.kernel.contacts[0].penetration < 0.0;
            (low, high) = if is_before { (middle, high) } else { (low, middle) };
        }
        *state = self.step(*time, state, high);
        *time += high;
        self.slope(*time, state);
        (*time, self.kernel.contacts[0].rate)
    }
}

/// ω after 20 s against Jacobi's functions.
fn torque_free_body() {
    let tree = Tree::new(Counts::SPACE, &[(0, Attachment::Free, false)], Vec::new(), Vec::new());
    let link = Link {
        parent_arm: Vector3::zero(),
        own_arm: Vector3::zero(),
        mount: unit_mount(),
        centre_of_mass: Vector3::zero(),
        mass: 1.0,
        inertia: diagonal([1e-3, 2e-3, 3e-3]),
    };
    let numbers = Numbers { links: vec![link], cuts: Vec::new(), plays: Vec::new(), gravity: Vector3::zero() };
    let mut run = Run::new(&tree, numbers, |_| [0.0; 3]);
    let mut state = vec![0.0; 13];
    state[3] = 1.0;
    state[10..].copy_from_slice(&[2.0, 0.3, 6.0]);
    const STEPS: usize = 40_000;
    for step in 0..STEPS {
        let length = 20.0 / STEPS as f64;
        state = run.step(step as f64 * length, &state, length);
    }
    let known = [1.90969913, -0.66561943, 5.99018505];
    let worst = (0..3).map(|k| (state[10 + k] - known[k]).abs()).fold(0.0, f64::max);
    println!(
        "torque-free body: spin at 20 s {:?}, {worst:.1e} rad/s from the closed form, which has 8 digits",
        &state[10..]
    );
    assert!(worst < 1e-8);
}

/// The four-bar RSSR with play at its second ball.
fn balls() -> (Tree, Numbers<f64, Space>) {
    let revolute = Attachment::Revolute { forward: true, turns_alone: false };
    let bodies = [(0, revolute, true), (1, Attachment::Ball, false), (0, revolute, false)];
    let tree = Tree::new(Counts::SPACE, &bodies, Vec::new(), vec![[2, 3]]);
    let link = |parent_arm, own_arm, parent, mass, inertia| Link {
        parent_arm: Vector3(parent_arm),
        own_arm: Vector3(own_arm),
        mount: SpaceMount { parent, ..unit_mount() },
        centre_of_mass: Vector3::zero(),
        mass,
        inertia: diagonal(inertia),
    };
    let links = vec![
        link([0.0; 3], [-0.025, 0.0, 0.0], Matrix3::identity(), 0.3, [1e-4; 3]),
        link([0.025, 0.0, 0.0], [-0.125, 0.0, 0.0], Matrix3::identity(), 0.25, [2e-5, 1.4e-3, 1.4e-3]),
        link([0.22, 0.04, 0.06], [-0.06, 0.0, 0.0], pivot_axes(), 0.4, [1e-4, 5e-4, 5e-4]),
    ];
    let law = PointContact { stiffness_n_m_n: 84706159386.37863, exponent: 1.5, damping_factor: 0.20812500000000006 };
    let arms = [Vector3([0.125, 0.0, 0.0]), Vector3([0.06, 0.0, 0.0])];
    let plays = vec![PlayNumbers { arms, clearance: 2e-4, law: NormalLaw::Point(law) }];
    let numbers = Numbers { links, cuts: Vec::new(), plays, gravity: Vector3([0.0, 0.0, -9.81]) };
    (tree, numbers)
}

/// Axes of its pivot.
fn pivot_axes() -> Matrix3<f64> {
    axes([0.0, 0.0, 1.0], [0.6, 0.8, 0.0])
}

/// Operations of its evaluation, its numbers as constants, and how long one takes on plain numbers, ns.
pub fn count_balls() -> (OperationCounts, f64) {
    let (tree, plain) = balls();
    let (graph, outputs) = record(|| {
        let vector = |vector: Vector3<f64>| Vector3(vector.0.map(Traced::from_f64));
        let matrix = |matrix: Matrix3<f64>| Matrix3(matrix.0.map(vector));
        let links = plain.links.iter().map(|link| LinkNumbers::<Traced, Space> {
            parent_arm: vector(link.parent_arm),
            own_arm: vector(link.own_arm),
            mount: SpaceMount { parent: matrix(link.mount.parent), own: matrix(link.mount.own) },
            centre_of_mass: vector(link.centre_of_mass),
            mass: Traced::from_f64(link.mass),
            inertia: matrix(link.inertia),
        });
        let plays = plain.plays.iter().map(|play| PlayNumbers {
            arms: play.arms.map(vector),
            clearance: Traced::from_f64(play.clearance),
            law: NormalLaw::broadcast(&play.law),
        });
        let (links, plays, gravity) = (links.collect(), plays.collect(), vector(plain.gravity));
        let mut kernel = Kernel::new(&tree, Numbers { links, plays, cuts: Vec::new(), gravity });
        let input = |index: u32| Traced::input(Slot { block: 0, index });
        let numbers: Vec<Traced> = (0..13).map(input).collect();
        let state = PlayState {
            contact: numbers[11],
            inverse_impact_speed_s_m: numbers[12],
            effective_mass_kg: Traced::zero(),
        };
        generic::space_traced(&mut kernel, &numbers[..6], &numbers[6..11], &[Traced::zero()], &[state]);
        let slot = |index: usize| Slot { block: 1, index: index as u32 };
        let of_kernel = kernel.accelerations.iter().enumerate();
        of_kernel.map(|(index, number)| (slot(index), number.value())).collect::<Vec<_>>()
    });
    let program = Program::new(&graph, &outputs).expect("one slot each");

    let mut kernel = Kernel::new(&tree, plain);
    let state = [PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.0, effective_mass_kg: 0.0 }];
    let mut times_ns: Vec<f64> = (0..201)
        .map(|_| {
            let started = Instant::now();
            for _ in 0..1000 {
                let coordinates = black_box([0.97, 0.21, 0.1, -0.05, 1.2, 0.4]);
                generic::space_plain(&mut kernel, &coordinates, &[1.0, 2.0, 3.0, 4.0, 5.0], &[0.0], &state);
            }
            started.elapsed().as_secs_f64() * 1e6
        })
        .collect();
    times_ns.sort_by(f64::total_cmp);
    (program.counts(), times_ns[100])
}

/// The same through its first contact to the second one.
fn four_bar_with_balls() {
    let (tree, numbers) = balls();
    let pivot = pivot_axes();
    let mut run = Run::new(&tree, numbers, |time| [0.3 + 31.41592653589793 * time, 31.41592653589793, 0.0]);

    let coupler = [0.9748215445983072, 0.21203741342300184, 0.014668770809969069, -0.06743825812384392];
    let spin = Vector3([0.28627521898609914, 4.137024216681809, -4.102523228134192]);
    let rocker = [0.7070551295681634, -0.5605161654250668, 0.43107032871351664, 0.008546563715773314];
    let along = Matrix3::of_quaternion(rocker).column(0);
    let angle = along.dot(pivot.column(1)).atan2(along.dot(pivot.column(0)));
    let rate = Vector3([6.57975621228646, 8.773008283048615, 0.0]).dot(pivot.column(2));
    let mut state = coupler.to_vec();
    state.push(angle);
    state.extend(Matrix3::of_quaternion(coupler).turn_back(spin).0);
    state.push(rate);

    let mut time = 0.0;
    let (onset, speed) = run.fly_to_contact(&mut time, &mut state, 0.00322, 1e-5);
    run.states[0] = PlayState { contact: 1.0, inverse_impact_speed_s_m: 1.0 / speed, effective_mass_kg: 0.0 };
    loop {
        state = run.step(time, &state, 1e-8);
        time += 1e-8;
        run.slope(time, &state);
        if run.kernel.contacts[0].penetration < 0.0 {
            break;
        }
    }
    let contact = run.kernel.contacts[0];
    let end = time - contact.penetration / contact.rate;
    run.states[0] = PlayState::flight();
    let (next_onset, next_speed) = run.fly_to_contact(&mut time, &mut state, 0.00364, 1e-6);
    println!("four-bar with balls: found, known");
    for (name, found, known, tolerance) in [
        ("first onset, s", onset, 0.00322999688147708, 1e-13),
        ("its speed, m/s", speed, 0.122142074844329, 1e-11),
        ("its end, s", end, 0.00334389867737423, 1e-11),
        ("second onset, s", next_onset, 0.00364728016628639, 1e-10),
        ("its speed, m/s", next_speed, 0.0828901374723689, 1e-7),
    ] {
        println!("  {name}: {found:.15}, {known:.15}: {:.1e} apart", found - known);
        assert!((found - known).abs() < tolerance, "{name}");
    }
}

/// Five rods on six revolute joints at right angles: the five rows of the joint that closes the loop have rank four.
fn bricard() {
    let points =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, -1.0, 0.0], [1.0, -1.0, 1.0], [0.0, -1.0, 1.0], [0.0, 0.0, 1.0]];
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // Markers of the joint at each point, all bodies along the ground at the start.
    let markers = [y, z, x, y, z, x].map(|axis| {
        let across = if axis == x { y } else { x };
        axes(across, axis)
    });
    let revolute = Attachment::Revolute { forward: true, turns_alone: false };
    let bodies: Vec<_> = (0..5).map(|parent| (parent, revolute, false)).collect();
    let tree = Tree::new(Counts::SPACE, &bodies, vec![[5, 0]], Vec::new());
    let width = 0.1;
    let link = |body: usize| {
        let [from, to] = [body, body + 1].map(|point| Vector3(points[point]));
        let middle = (from + to) * 0.5;
        let along = (to - from).0;
        let moments =
            along.map(|share| if share == 0.0 { 1.0 / 12.0 + width * width / 12.0 } else { width * width / 6.0 });
        let before = if body == 0 { Vector3::zero() } else { (Vector3(points[body - 1]) + from) * 0.5 };
        Link {
            parent_arm: from - before,
            own_arm: from - middle,
            mount: SpaceMount { parent: markers[body], own: markers[body] },
            centre_of_mass: Vector3::zero(),
            mass: 1.0,
            inertia: diagonal(moments),
        }
    };
    let last = (Vector3(points[5]) - Vector3(points[4])) * 0.5;
    let cuts = vec![([last, Vector3(points[5])], SpaceMount { parent: markers[5], own: markers[5] })];
    let gravity = Vector3([0.0, -9.81, 0.0]);
    let numbers = Numbers { links: (0..5).map(link).collect(), cuts, plays: Vec::new(), gravity };
    let mut run = Run::new(&tree, numbers, |_| [0.0; 3]);
    let mut state = vec![0.0; 10];
    let known = [
        (0.5, [0.9682836791, -1.2246251594, 0.7501466094]),
        (1.0, [0.5105014612, -1.6491675994, 0.1401231146]),
        (2.0, [-0.9693403448, -1.2212468950, 0.7542780108]),
    ];
    let (steps_per_s, mut step) = (16_000, 0);
    for (at, known) in known {
        while step < (at * steps_per_s as f64) as usize {
            let length = 1.0 / steps_per_s as f64;
            state = run.step(step as f64 * length, &state, length);
            step += 1;
        }
        run.slope(at, &state);
        let pose = run.kernel.bodies[3].pose;
        let found = (pose.position + pose.rotation.turn(Vector3([0.0, 0.0, 0.5]))).0;
        let worst = (0..3).map(|k| (found[k] - known[k]).abs()).fold(0.0, f64::max);
        let tip = run.kernel.bodies[5].pose;
        let gap = tip.position + tip.rotation.turn(last) - Vector3(points[5]);
        println!(
            "Bricard at {at} s: P3 {found:.10?}, {worst:.1e} m from the known one; loop open by {:.1e} m",
            gap.dot(gap).sqrt()
        );
        assert!(worst < 1e-9);
    }
}
