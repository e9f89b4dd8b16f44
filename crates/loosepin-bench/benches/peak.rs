//! What a core can do at most: multiply-adds, choices, divisions and square roots a nanosecond, as machine code of the kind that
//! batches run. `measured/performance.md` holds the time of a run against it.
//!
//! Twelve chains that do not wait for each other keep all units busy; a single chain of multiply-adds shows how long a result
//! takes. Whoever else uses the machine can only lengthen a round, so the shortest one counts.

use loosepin::native::{Graph, Kernel, Level, Program, Slot, Value};
use std::hint::black_box;
use std::time::Instant;

/// Operations in flight: units times cycles until a result, 8 to 10 on the processors of our day, and some to spare; as many
/// as fit into 16 registers with what else is needed.
const CHAINS: usize = 12;
/// Operations of a chain in a trip, and trips of a call, each over one vector: the code of all chains stays in the first cache.
const STEPS: usize = 100;
const TRIPS: usize = 64;
/// Operations of a chain that is alone, in one trip: those of the next one would not wait.
const STEPS_ALONE: usize = 3_000;
/// Rounds, of which the shortest counts.
const ROUNDS: usize = 400;

/// Cycles of a step of [`chain_of_integers`]: one for the exclusive or, three for the product.
const INTEGER_STEP_CYCLES: f64 = 4.0;
const INTEGER_STEPS: usize = 10_000;

fn main() {
    let clock_ghz = INTEGER_STEP_CYCLES * INTEGER_STEPS as f64 / shortest_ns(chain_of_integers);
    println!("clock: {clock_ghz:.2} GHz, from a chain of integer products");
    println!("vectors, operation: instructions a cycle, numbers a ns; cycles until a result of a multiply-add");
    for level in Level::ALL.into_iter().filter(|level| level.is_supported()) {
        measure(level, clock_ghz);
    }
}

/// One more operation of a chain at `x`, with two constants.
type Step = fn(&mut Graph, Value, [Value; 2]) -> Value;

/// Prints the peak of vectors of `level`.
fn measure(level: Level, clock_ghz: f64) {
    let width = level.vector_lanes();
    // An operation, its instructions, and how it is written down.
    let operations: [(&str, usize, Step); 5] = [
        ("multiply-add", 1, |graph, x, [a, b]| graph.mul_add(x, a, b)),
        ("multiply", 1, |graph, x, [a, _]| graph.multiply(x, a)),
        // The comparison is an instruction of its own.
        ("compare and choose", 2, |graph, x, [a, b]| {
            let mask = graph.less_than(x, a);
            graph.select(mask, b, x)
        }),
        ("divide", 1, |graph, x, [a, _]| graph.divide(a, x)),
        // The sum keeps the numbers from becoming one; its unit is idle anyway.
        ("square root", 1, |graph, x, [_, b]| {
            let sum = graph.add(x, b);
            graph.square_root(sum)
        }),
    ];
    for (name, instructions, step) in operations {
        let steps = (CHAINS * STEPS * TRIPS) as f64;
        let a_ns = instructions as f64 * steps / chains_ns(level, [CHAINS, STEPS, TRIPS], step);
        println!("{level}, {name}: {:.2}, {:.2}", a_ns / clock_ghz, a_ns * width as f64);
    }
    let one_ns = chains_ns(level, [1, STEPS_ALONE, 1], operations[0].2) / STEPS_ALONE as f64;
    println!("{level}, a multiply-add after the other: {:.2} cycles", one_ns * clock_ghz);
}

/// Shortest time of a call that does so many steps in each of so many chains, and that so many times, ns.
fn chains_ns(level: Level, [chains, steps, trips]: [usize; 3], step: Step) -> f64 {
    let slot = |block: u8, index: usize| Slot { block, index: index as u32 };
    let mut graph = Graph::new();
    let constants = [0, 1].map(|index| graph.input(slot(1, index)));
    let outputs: Vec<(Slot, Value)> = (0..chains)
        .map(|chain| {
            let mut x = graph.input(slot(0, chain));
            for _ in 0..steps {
                x = step(&mut graph, x, constants);
            }
            (slot(0, chain), x)
        })
        .collect();
    let program = Program::new(&graph, &outputs).expect("each chain has its own slot");
    let lanes = trips * level.vector_lanes();
    let kernel = Kernel::compile(&program, level, lanes).expect("executable memory");
    let start: Vec<f64> = (0..chains * lanes).map(|place| 0.71 + 0.01 * (place / lanes) as f64).collect();
    let mut numbers = start.clone();
    let mut both: Vec<f64> = [0.998_7, 0.013_1].into_iter().flat_map(|number| vec![number; lanes]).collect();
    let mut shortest_s = f64::INFINITY;
    for _ in 0..ROUNDS {
        // Numbers that shrink from call to call would slow the processor down.
        numbers.copy_from_slice(&start);
        let started = Instant::now();
        kernel.run(&mut [&mut numbers, &mut both]).expect("the blocks are those of the program");
        shortest_s = shortest_s.min(started.elapsed().as_secs_f64());
    }
    black_box(numbers);
    shortest_s * 1e9
}

/// Integer products that wait for each other; the exclusive or keeps the compiler from taking them together.
fn chain_of_integers() {
    let [start, mask, factor] = black_box([1_u64, 0x9e37_79b9_7f4a_7c15, 0xd134_2543_de82_ef95]);
    let mut chain = start;
    for _ in 0..INTEGER_STEPS {
        chain = (chain ^ mask).wrapping_mul(factor);
    }
    black_box(chain);
}

fn shortest_ns(work: impl Fn()) -> f64 {
    let mut shortest_s = f64::INFINITY;
    for _ in 0..ROUNDS {
        let started = Instant::now();
        work();
        shortest_s = shortest_s.min(started.elapsed().as_secs_f64());
    }
    shortest_s * 1e9
}
