//! The right-hand side of a slider-crank with play in the gudgeon joint, as machine code: nanoseconds per call and lane.
//!
//! Coordinates are the rod's angle φ and the slider's position x; u is the square root of the penetration and
//! dt = u dσ, so that the contact force K u³ (1 + χ δ̇/v0) is smooth. The angles are carried as sine and cosine at the start
//! of the step and the small increments since, which is how a batch of runs would do it.
//!
//! Two programs: the right-hand side alone, whose calls may overlap in the processor, and a step of Euler's method in
//! place, whose calls must wait for each other.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use loosepin::native::{Graph, Kernel, Level, Program, Slot, Value};
use std::hint::black_box;

const STATE: u8 = 0;
const PARAMETERS: u8 = 1;
const DERIVATIVE: u8 = 2;

/// State in slot order: increment of φ, x, φ̇, ẋ, u, increment of the crank's angle.
const STATE_SI: [f64; 6] = [1e-3, 0.42, 3.0, 2.0, 0.01, 2e-3];

/// Parameters in slot order: sine and cosine of the crank's angle and of φ at the start of the step, crank length, rod
/// length, K, χ/v0, m l/2 and 1/J of the rod, 1/m of the slider, speed of the crank, 1/2 in contact and 0 else, m g l/2,
/// length of Euler's step.
const PARAMETERS_SI: [f64; 15] =
    [0.5, 0.866, 0.1, 0.995, 0.05, 0.12, 6.6e10, 0.3, 0.0126, 1e3, 7.14, 523.6, 0.5, 0.12, 1e-15];

/// Coefficients of sine over x and of cosine in powers of x².
const SINE: [f64; 4] = [-1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0, 1.0 / 362_880.0];
const COSINE: [f64; 6] = [1.0, -0.5, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40_320.0, -1.0 / 3_628_800.0];

/// Sum of `coefficients` times powers of `x`, by Horner's rule.
fn polynomial(graph: &mut Graph, x: Value, coefficients: &[f64]) -> Value {
    let mut sum = graph.constant(0.0);
    for &coefficient in coefficients.iter().rev() {
        let coefficient = graph.constant(coefficient);
        sum = graph.mul_add(sum, x, coefficient);
    }
    sum
}

/// a·b - c·d, the first product fused.
fn difference_of_products(graph: &mut Graph, [a, b, c, d]: [Value; 4]) -> Value {
    let product = graph.multiply(c, d);
    let product = graph.negate(product);
    graph.mul_add(a, b, product)
}

/// a·b + c·d, the first product fused.
fn sum_of_products(graph: &mut Graph, [a, b, c, d]: [Value; 4]) -> Value {
    let product = graph.multiply(c, d);
    graph.mul_add(a, b, product)
}

/// Sine and cosine of an angle that is `increment` further than one with the given sine and cosine.
fn turned(graph: &mut Graph, increment: Value, sine: Value, cosine: Value) -> (Value, Value) {
    let square = graph.multiply(increment, increment);
    let cube = graph.multiply(square, increment);
    let series = polynomial(graph, square, &SINE);
    let increment_sine = graph.mul_add(cube, series, increment);
    let increment_cosine = polynomial(graph, square, &COSINE);
    (
        sum_of_products(graph, [sine, increment_cosine, cosine, increment_sine]),
        difference_of_products(graph, [cosine, increment_cosine, sine, increment_sine]),
    )
}

fn program(is_euler_step: bool) -> Program {
    let g = &mut Graph::new();
    let state: [Value; 6] = std::array::from_fn(|index| g.input(Slot { block: STATE, index: index as u32 }));
    let [phi_increment, x, phi_dot, x_dot, u, crank_increment] = state;
    let parameters = std::array::from_fn(|index| g.input(Slot { block: PARAMETERS, index: index as u32 }));
    let [sa0, ca0, sp0, cp0, r, l, k, chi_v0, m_l2, inv_j, inv_m, omega, half, m_g_l2, step]: [Value; 15] = parameters;

    let (sa, ca) = turned(g, crank_increment, sa0, ca0);
    let (sp, cp) = turned(g, phi_increment, sp0, cp0);
    // The crank pin and its velocity and acceleration, then the rod's end.
    let (pin_x, pin_y) = (g.multiply(r, ca), g.multiply(r, sa));
    let (pin_vx, pin_vy) = (g.multiply(pin_y, omega), g.multiply(pin_x, omega));
    let pin_vx = g.negate(pin_vx);
    let (pin_ax, pin_ay) = (g.multiply(pin_vy, omega), g.multiply(pin_vx, omega));
    let (end_x, e_y) = (g.mul_add(l, cp, pin_x), g.mul_add(l, sp, pin_y));
    let speed = g.multiply(l, phi_dot);
    let minus_speed = g.negate(speed);
    let (end_vx, end_vy) = (g.mul_add(minus_speed, sp, pin_vx), g.mul_add(speed, cp, pin_vy));
    // Eccentricity, normal, penetration speed, force.
    let e_x = g.subtract(end_x, x);
    let square = sum_of_products(g, [e_x, e_x, e_y, e_y]);
    let distance = g.square_root(square);
    let one = g.constant(1.0);
    let inverse = g.divide(one, distance);
    let (n_x, n_y) = (g.multiply(e_x, inverse), g.multiply(e_y, inverse));
    let relative_vx = g.subtract(end_vx, x_dot);
    let delta_dot = sum_of_products(g, [n_x, relative_vx, n_y, end_vy]);
    let u_squared = g.multiply(u, u);
    let u_cubed = g.multiply(u_squared, u);
    let elastic = g.multiply(k, u_cubed);
    let factor = g.mul_add(chi_v0, delta_dot, one);
    let force = g.multiply(elastic, factor);
    let zero = g.constant(0.0);
    let force = g.maximum(force, zero);
    let (f_x, f_y) = (g.multiply(force, n_x), g.multiply(force, n_y));
    // Moments about the crank pin: of the pin's acceleration (-pin_ax), of the force, of gravity.
    let minus_sp = g.negate(sp);
    let inertia_arm = difference_of_products(g, [pin_ax, minus_sp, pin_ay, cp]);
    let inertia_moment = g.multiply(m_l2, inertia_arm);
    let force_arm = difference_of_products(g, [f_x, sp, f_y, cp]);
    let moment = g.mul_add(l, force_arm, inertia_moment);
    let minus_cp = g.negate(cp);
    let moment = g.mul_add(m_g_l2, minus_cp, moment);
    let phi_dot_dot = g.multiply(moment, inv_j);
    let x_dot_dot = g.multiply(f_x, inv_m);
    let derivative = [
        g.multiply(u, phi_dot),
        g.multiply(u, x_dot),
        g.multiply(u, phi_dot_dot),
        g.multiply(u, x_dot_dot),
        g.multiply(half, delta_dot),
        g.multiply(u, omega),
    ];
    let outputs: Vec<(Slot, Value)> = (0..6)
        .map(|index| {
            let slot = |block| Slot { block, index: index as u32 };
            if is_euler_step {
                (slot(STATE), g.mul_add(step, derivative[index], state[index]))
            } else {
                (slot(DERIVATIVE), derivative[index])
            }
        })
        .collect();
    Program::new(g, &outputs).expect("each output has its own slot")
}

/// Numbers for all lanes, a little different in each, with the position from which on they lie on a cache line.
fn spread(values: &[f64], lanes: usize) -> (Vec<f64>, usize) {
    let mut numbers = vec![0.0; values.len() * lanes + 8];
    let start = numbers.as_ptr().align_offset(64);
    for (place, number) in numbers[start..start + values.len() * lanes].iter_mut().enumerate() {
        *number = values[place / lanes] * (1.0 + 1e-3 * (place % lanes) as f64);
    }
    (numbers, start)
}

fn right_hand_side(criterion: &mut Criterion) {
    for (name, is_euler_step) in [("slider_crank", false), ("slider_crank_euler_step", true)] {
        let program = program(is_euler_step);
        let mut group = criterion.benchmark_group(format!("{name}/{}_operations", program.operations()));
        for lanes in [8, 16] {
            group.throughput(Throughput::Elements(lanes as u64));
            let (mut state, state_at) = spread(&STATE_SI, lanes);
            let (mut parameters, parameters_at) = spread(&PARAMETERS_SI, lanes);
            let (mut derivative, derivative_at) = spread(&[f64::NAN; 6], lanes);
            let blocks: &mut [&mut [f64]] =
                &mut [&mut state[state_at..], &mut parameters[parameters_at..], &mut derivative[derivative_at..]];
            for level in Level::ALL.into_iter().filter(|level| level.is_supported()) {
                let kernel = Kernel::compile(&program, level, lanes).expect("executable memory");
                group.bench_function(format!("{level}/{lanes}_lanes"), |bencher| {
                    bencher.iter(|| kernel.run(black_box(blocks)));
                });
            }
        }
        group.finish();
    }
}

criterion_group!(benches, right_hand_side);
criterion_main!(benches);
