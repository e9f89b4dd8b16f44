//! What a core can do at most: multiply-adds, choices, divisions and square roots a nanosecond, with vectors of 128, 256 and
//! 512 bits of the kind that the lanes of a batch are made of. `docs/performance.md` holds the time of a run against it.
//!
//! Twelve chains that do not wait for each other keep all units busy; a single chain of multiply-adds shows how long a result
//! takes. Whoever else uses the machine can only lengthen a round, so the shortest one counts.

use fearless_simd::{Level, Select, Simd, SimdFloat, f64x2, f64x4, f64x8};
use std::hint::black_box;
use std::time::Instant;

/// Operations in flight: units times cycles until a result, 8 to 10 on the processors of our day, and some to spare; as many
/// as fit into 16 registers with what else is needed.
const CHAINS: usize = 12;
/// Operations of a chain in a round.
const STEPS: usize = 10_000;
/// Rounds, of which the shortest counts.
const ROUNDS: usize = 200;

/// Cycles of a step of [`chain_of_integers`]: one for the exclusive or, three for the product.
const INTEGER_STEP_CYCLES: f64 = 4.0;

fn main() {
    let clock_ghz = INTEGER_STEP_CYCLES * STEPS as f64 / shortest_ns(chain_of_integers);
    println!("clock: {clock_ghz:.2} GHz, from a chain of integer products");
    println!("vectors, operation: instructions a cycle, numbers a ns; cycles until a result of a multiply-add");
    let level = Level::new();
    #[cfg(target_arch = "x86_64")]
    {
        if let Some(token) = level.as_avx2() {
            measure::<_, f64x2<_>>(token, clock_ghz);
            measure::<_, f64x4<_>>(token, clock_ghz);
        }
        if let Some(token) = level.as_avx512() {
            measure::<_, f64x8<_>>(token, clock_ghz);
        }
    }
    #[cfg(target_arch = "aarch64")]
    if let Some(token) = level.as_neon() {
        measure::<_, f64x2<_>>(token, clock_ghz);
    }
    let _ = level;
}

/// Prints the peak of vectors `V`.
fn measure<S: Simd, V: SimdFloat<S, Element = f64>>(token: S, clock_ghz: f64) {
    let bits = 64 * V::LEN;
    let print = |operation: &str, instructions: usize, shortest_ns: f64| {
        let a_ns = instructions as f64 / shortest_ns;
        println!("{bits} bits, {operation}: {:.2}, {:.2}", a_ns / clock_ghz, a_ns * V::LEN as f64);
    };
    let all = CHAINS * STEPS;
    print("multiply-add", all, chains_ns::<S, V, CHAINS>(token, |x, a, b| x.mul_add_precise(a, b)));
    print("multiply", all, chains_ns::<S, V, CHAINS>(token, |x, a, _| x * a));
    // The comparison is an instruction of its own.
    print("compare and choose", 2 * all, chains_ns::<S, V, CHAINS>(token, |x, a, b| x.simd_lt(a).select(b, x)));
    print("divide", all, chains_ns::<S, V, CHAINS>(token, |x, a, _| a / x));
    // The sum keeps the numbers from becoming one; its unit is idle anyway.
    print("square root", all, chains_ns::<S, V, CHAINS>(token, |x, _, b| (x + b).sqrt()));
    let one_ns = chains_ns::<S, V, 1>(token, |x, a, b| x.mul_add_precise(a, b)) / STEPS as f64;
    println!("{bits} bits, a multiply-add after the other: {:.2} cycles", one_ns * clock_ghz);
}

/// Nanoseconds of `STEPS` operations in each of `N` chains.
#[inline(always)]
fn chains_ns<S: Simd, V: SimdFloat<S, Element = f64>, const N: usize>(
    token: S,
    operation: impl Fn(V, V, V) -> V + Copy,
) -> f64 {
    shortest_ns(|| {
        token.vectorize(
            #[inline(always)]
            || {
                let [a, b] = black_box([0.998_7, 0.013_1]).map(|number| V::splat(token, number));
                let mut chains: [V; N] = std::array::from_fn(|k| V::splat(token, 0.71 + 0.01 * k as f64));
                for _ in 0..STEPS {
                    for chain in &mut chains {
                        *chain = operation(*chain, a, b);
                    }
                }
                black_box(chains);
            },
        );
    })
}

/// Integer products that wait for each other; the exclusive or keeps the compiler from taking them together.
fn chain_of_integers() {
    let [start, mask, factor] = black_box([1_u64, 0x9e37_79b9_7f4a_7c15, 0xd134_2543_de82_ef95]);
    let mut chain = start;
    for _ in 0..STEPS {
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
