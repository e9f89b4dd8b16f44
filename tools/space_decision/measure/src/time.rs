//! Times of an evaluation on plain numbers and on lanes.

use crate::case::{Case, Generic, Random, Spatial, State, Today, Way};
use generic::{Plane, Space};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_tape::native::{Kernel, Level, Program};
use std::hint::black_box;
use std::time::Instant;

const STATES: usize = 64;
/// Passes over the states in a round: a round is shorter than a slice of time on a machine that others use, too.
const PASSES: usize = 2;
const ROUNDS: usize = 2001;
const LANES: usize = 32;
const KERNEL_CALLS: usize = 200;

/// The blocks of [`crate::counts::program`] for one state in every lane. What is taken out of the program is filled in by its own.
fn blocks(case: &Case, state: &State<f64>, program: &Program, lanes: usize) -> Vec<Vec<f64>> {
    let mut blocks = vec![case.sample.numbers(), vec![state.time_s], Vec::new(), Vec::new()];
    blocks[1].extend(&state.coordinates);
    blocks[1].extend(&state.rates);
    for contact in &state.states {
        blocks[2].extend([contact.contact, contact.inverse_impact_speed_s_m]);
    }
    let lengths = program.values_per_block();
    let spread = |(index, block): (usize, Vec<f64>)| {
        let mut numbers: Vec<f64> = block.into_iter().flat_map(|value| vec![value; lanes]).collect();
        numbers.resize(lanes * lengths.get(index).copied().unwrap_or(0).max(numbers.len() / lanes), 0.3);
        numbers
    };
    blocks.into_iter().enumerate().map(spread).collect()
}

/// Accelerations by a program.
pub fn run(case: &Case, program: &(Program, Program), state: &State<f64>) -> Vec<f64> {
    let mut blocks = blocks(case, state, &program.0, 1);
    let own_length = program.1.values_per_block().first().copied().unwrap_or(0);
    if blocks[0].len() < own_length {
        blocks[0].resize(own_length, 0.3);
    }
    let mut borrowed: Vec<&mut [f64]> = blocks.iter_mut().map(Vec::as_mut_slice).collect();
    program.1.evaluate(1, &mut borrowed).expect("blocks fit");
    program.0.evaluate(1, &mut borrowed).expect("blocks fit");
    blocks[3][..state.coordinates.len()].to_vec()
}

/// Prints the median over rounds in which the ways take turns.
pub fn measure(case: &Case) {
    let mut random = Random(7);
    let states: Vec<State<f64>> = (0..STATES).map(|_| case.state(&mut random)).collect();
    let sample = &case.sample;
    let mut ways: Vec<(&str, Box<dyn Way<f64> + '_>)> = vec![
        ("today", Box::new(Today(Dynamics::new(&case.mechanism, sample), today::plain))),
        ("(a) space", Box::new(Spatial::new(case, sample, false, spatial::plain))),
        ("(a) angles from parents", Box::new(Spatial::new(case, sample, true, spatial::plain))),
        ("(b) plane", Box::new(Generic::<_, Plane>::new(case, &case.plane, sample, generic::plane_plain))),
        ("(b) space", Box::new(Generic::<_, Space>::new(case, &case.space, sample, generic::space_plain))),
    ];
    let mut times_ns = vec![Vec::new(); ways.len()];
    for _ in 0..ROUNDS {
        for ((_, way), times_ns) in ways.iter_mut().zip(&mut times_ns) {
            let started = Instant::now();
            for _ in 0..PASSES {
                for state in &states {
                    black_box(way.evaluate(black_box(state)));
                }
            }
            times_ns.push(started.elapsed().as_secs_f64() * 1e9 / (PASSES * STATES) as f64);
        }
    }
    println!("{}, one evaluation on plain numbers: median and shortest of {ROUNDS} rounds", case.name);
    for ((name, _), times_ns) in ways.iter().zip(&mut times_ns) {
        println!("  {name}: {:.0} ns, {:.0} ns", median(times_ns), times_ns[0]);
    }
    tracing(case);
    lanes(case, &states[0]);
}

/// How long it takes to write the programs down.
fn tracing(case: &Case) {
    let mut times_us: Vec<(&str, Vec<f64>)> = Vec::new();
    for _ in 0..101 {
        for (way, (name, make)) in crate::tracings().into_iter().enumerate() {
            let started = Instant::now();
            black_box(make(case, true));
            let elapsed_us = started.elapsed().as_secs_f64() * 1e6;
            match times_us.get_mut(way) {
                Some(times_us) => times_us.1.push(elapsed_us),
                None => times_us.push((name, vec![elapsed_us])),
            }
        }
    }
    println!("{}, writing the program down", case.name);
    for (name, times_us) in &mut times_us {
        println!("  {name}: {:.0} µs, {:.0} µs", median(times_us), times_us[0]);
    }
}

fn lanes(case: &Case, state: &State<f64>) {
    let Some(level) = Level::best() else { return };
    let programs = crate::programs(case, true);
    let compile = |program: &Program| Kernel::compile(program, level, LANES).expect("executable memory");
    let kernels: Vec<Kernel> = programs.iter().map(|(_, program)| compile(&program.0)).collect();
    let mut data: Vec<Vec<Vec<f64>>> =
        programs.iter().map(|(_, program)| blocks(case, state, &program.0, LANES)).collect();
    let mut times_ns = vec![Vec::new(); kernels.len()];
    for _ in 0..ROUNDS {
        for ((kernel, data), times_ns) in kernels.iter().zip(&mut data).zip(&mut times_ns) {
            let mut borrowed: Vec<&mut [f64]> = data.iter_mut().map(Vec::as_mut_slice).collect();
            let started = Instant::now();
            for _ in 0..KERNEL_CALLS {
                kernel.run(&mut borrowed).expect("blocks fit");
            }
            times_ns.push(started.elapsed().as_secs_f64() * 1e9 / (KERNEL_CALLS * LANES) as f64);
        }
    }
    println!("{}, machine code ({level}, {LANES} lanes), for each lane", case.name);
    for ((name, _), times_ns) in programs.iter().zip(&mut times_ns) {
        println!("  {name}: {:.1} ns, {:.1} ns", median(times_ns), times_ns[0]);
    }
}

/// The median; sorts.
fn median(times_ns: &mut [f64]) -> f64 {
    times_ns.sort_by(f64::total_cmp);
    times_ns[times_ns.len() / 2]
}
