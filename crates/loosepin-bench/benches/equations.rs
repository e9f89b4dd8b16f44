//! What an evaluation of the equations consists of and how long it takes as machine code, part by part; and the integrator's
//! own arithmetic in a step. Counts are those of the programs; times are of calls for 32 lanes, as a batch makes them, and the
//! shortest of many rounds counts, since others on the machine can only lengthen one.
//!
//! `cargo bench --package loosepin-bench --bench equations` for the reference case of `measured/performance.md`; case names as arguments choose others.

use loosepin::native::{Kernel, Level, Program};
use loosepin_bench::batch::Case;
use loosepin_bench::equations::{blocks, parts};
use loosepin_bench::named_cases;
use std::time::Instant;

/// Lanes of a batch: four vectors of eight.
const LANES: usize = 32;
/// Calls of a kernel in a round.
const CALLS: usize = 2_000;
/// Rounds, of which the shortest counts; kernels take turns.
const ROUNDS: usize = 300;

fn main() {
    for name in named_cases(&["slider_crank_5000"]) {
        measure(&Case::read(&name));
    }
}

fn measure(case: &Case) {
    let inputs = blocks(case, LANES);
    let parts = parts(case);
    println!("{}: each line of the equations holds those before it, the others stand alone", case.name);
    for part in &parts {
        for program in &part.programs {
            println!("  {}: {}", part.name, program.counts());
        }
    }
    let programs: Vec<(&str, &Program)> =
        parts.iter().flat_map(|part| part.programs.iter().map(|program| (part.name, program))).collect();
    for level in Level::ALL.into_iter().filter(|level| level.is_supported()) {
        let compile = |program: &Program| Kernel::compile(program, level, LANES).expect("executable memory");
        let kernels: Vec<Kernel> = programs.iter().map(|(_, program)| compile(program)).collect();
        println!("{level}, {LANES} lanes");
        for ((name, _), (kernel, shortest_ns)) in programs.iter().zip(kernels.iter().zip(times_ns(&kernels, &inputs))) {
            let size = kernel.size();
            println!(
                "  {name}: {shortest_ns:.1} ns a call, {:.2} ns a lane; {} × {} instructions ({} loads, {} more read \
                 memory, {} stores, {} spills, {} copies), {} bytes",
                shortest_ns / LANES as f64,
                size.trips,
                size.instructions,
                size.loads,
                size.reading,
                size.stores,
                size.spills,
                size.copies,
                size.bytes,
            );
        }
    }
}

/// Shortest time of a call of each kernel, ns.
fn times_ns(kernels: &[Kernel], inputs: &[Vec<f64>]) -> Vec<f64> {
    let mut data: Vec<Vec<Aligned>> = kernels.iter().map(|kernel| aligned(kernel, inputs)).collect();
    let mut shortest_s = vec![f64::INFINITY; kernels.len()];
    for _ in 0..ROUNDS {
        for ((kernel, data), shortest_s) in kernels.iter().zip(&mut data).zip(&mut shortest_s) {
            let mut blocks: Vec<&mut [f64]> = data.iter_mut().map(Aligned::numbers).collect();
            let started = Instant::now();
            for _ in 0..CALLS {
                kernel.run(&mut blocks).expect("the blocks are those of the program");
            }
            *shortest_s = shortest_s.min(started.elapsed().as_secs_f64());
        }
    }
    shortest_s.into_iter().map(|seconds| seconds * 1e9 / CALLS as f64).collect()
}

/// Numbers that begin on a cache line, as those of lanes do.
struct Aligned {
    numbers: Vec<f64>,
    start: usize,
    length: usize,
}

impl Aligned {
    fn numbers(&mut self) -> &mut [f64] {
        &mut self.numbers[self.start..self.start + self.length]
    }
}

/// The blocks of `kernel`, with `inputs` in the first ones and ordinary numbers behind them.
fn aligned(kernel: &Kernel, inputs: &[Vec<f64>]) -> Vec<Aligned> {
    let filled = |block: usize, values: usize| {
        let length = values * kernel.lanes();
        let mut numbers = vec![0.3; length + 8];
        let start = numbers.as_ptr().align_offset(64);
        if let Some(input) = inputs.get(block) {
            let count = input.len().min(length);
            numbers[start..start + count].copy_from_slice(&input[..count]);
        }
        Aligned { numbers, start, length }
    };
    kernel.values_per_block().iter().enumerate().map(|(block, &values)| filled(block, values)).collect()
}
