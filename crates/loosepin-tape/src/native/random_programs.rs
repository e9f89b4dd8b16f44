//! Random programs as machine code and interpreted, compared bit for bit.

use super::translate::translate_interleaved;
use super::{BlockStart, Graph, Kernel, Level, MAX_BLOCKS, Mask, NativeError, Program, Routine, Sequence, Slot, Value};

/// Random numbers for tests: SplitMix64 (Steele, Lea and Flood 2014).
pub(super) struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^ (bits >> 31)
    }

    pub fn below(&mut self, limit: usize) -> usize {
        (self.bits() % limit as u64) as usize
    }

    /// Between -4 and 4.
    pub fn number(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (8.0 / (1_u64 << 53) as f64) - 4.0
    }

    /// Now and then one of the numbers that need care.
    pub fn operand(&mut self) -> f64 {
        const SPECIAL: [f64; 8] =
            [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, 5e-324, f64::MAX, f64::MIN_POSITIVE];
        if self.below(8) == 0 { SPECIAL[self.below(SPECIAL.len())] } else { self.number() }
    }
}

/// Operations and sizes of a random program.
pub(super) struct Shape {
    pub nodes: usize,
    pub inputs: usize,
    pub outputs: usize,
    /// Operands are taken from this number of the youngest values: more means more values alive.
    pub reach: usize,
    pub blocks: usize,
    /// Some outputs take the place of inputs.
    pub is_in_place: bool,
}

fn random_program(random: &mut Random, shape: &Shape) -> Program {
    let (graph, outputs) = random_graph(random, shape);
    Program::new(&graph, &outputs).expect("each output has its own slot")
}

/// Operations, and where some of the last ones go.
pub(super) fn random_graph(random: &mut Random, shape: &Shape) -> (Graph, Vec<(Slot, Value)>) {
    let mut graph = Graph::new();
    let slot = |number: usize| Slot { block: (number % shape.blocks) as u8, index: (number / shape.blocks) as u32 };
    let mut values: Vec<Value> = (0..shape.inputs).map(|number| graph.input(slot(number))).collect();
    let mut masks: Vec<Mask> = Vec::new();
    for _ in 0..shape.nodes {
        let oldest = values.len().saturating_sub(shape.reach);
        let reach = values.len() - oldest;
        let mut pick = || values[oldest + random.below(reach)];
        let (a, b, c) = (pick(), pick(), pick());
        let constant = match random.below(6) {
            0 => 1.0,
            1 => -1.0,
            2 => 0.5,
            _ => random.number(),
        };
        let value = match random.below(16) {
            0 => graph.add(a, b),
            1 => graph.subtract(a, b),
            2 => graph.multiply(a, b),
            3 => graph.divide(a, b),
            4 | 5 => graph.mul_add(a, b, c),
            6 => {
                let product = graph.negate(a);
                let addend = if random.below(2) == 0 { graph.negate(c) } else { c };
                graph.mul_add(product, b, addend)
            }
            7 => {
                let constant = graph.constant(constant);
                graph.mul_add(a, b, constant)
            }
            8 => {
                let constant = graph.constant(constant);
                if random.below(2) == 0 { graph.multiply(constant, a) } else { graph.subtract(constant, a) }
            }
            9 => graph.square_root(a),
            10 => graph.minimum(a, b),
            11 => graph.maximum(a, b),
            12 => {
                let zero = graph.constant(0.25);
                if random.below(2) == 0 { graph.minimum(zero, a) } else { graph.maximum(a, zero) }
            }
            13 => {
                if random.below(2) == 0 {
                    graph.absolute(a)
                } else {
                    let sum = graph.add(a, b);
                    graph.negate(sum)
                }
            }
            _ => {
                masks.push(graph.less_than(a, b));
                if random.below(2) == 0 {
                    let other = masks[random.below(masks.len())];
                    masks.push(graph.not(other));
                }
                let oldest = masks.len().saturating_sub(shape.reach);
                let mask = masks[oldest + random.below(masks.len() - oldest)];
                graph.select(mask, b, c)
            }
        };
        values.push(value);
    }
    let first_output = if shape.is_in_place { shape.inputs / 2 } else { shape.inputs };
    let outputs: Vec<(Slot, Value)> = (0..shape.outputs)
        .map(|number| {
            (slot(first_output + number), values[values.len() - 1 - random.below(values.len().min(2 * shape.outputs))])
        })
        .collect();
    (graph, outputs)
}

/// The bits, the same for all NaN.
pub(super) fn comparable(number: f64) -> u64 {
    if number.is_nan() { f64::NAN.to_bits() } else { number.to_bits() }
}

/// Level, lanes, vectors side by side.
const ARRANGEMENTS: [(Level, usize, usize); 7] = [
    (Level::Avx2, 8, 1),
    (Level::Avx2, 8, 2),
    (Level::Avx2, 16, 1),
    (Level::Avx2, 16, 2),
    (Level::Avx512, 8, 1),
    (Level::Avx512, 16, 1),
    (Level::Avx512, 16, 2),
];

/// Runs `program` both ways on the same random numbers.
fn check_agreement(random: &mut Random, program: &Program, level: Level, lanes: usize, interleaved: usize) {
    let (code, size) = translate_interleaved(program, level, lanes, interleaved).expect("a program within the limits");
    let kernel = Kernel::new(&code, size, program.values_per_block().to_vec(), level, lanes);
    if !level.is_supported() {
        assert!(matches!(kernel, Err(NativeError::NotSupported { .. })));
        return;
    }
    let kernel = kernel.expect("executable memory");
    let start: Vec<Vec<f64>> = program
        .values_per_block()
        .iter()
        .map(|values| (0..values * lanes).map(|_| random.operand()).collect())
        .collect();
    let (mut native, mut plain) = (start.clone(), start);
    let mut native_blocks: Vec<&mut [f64]> = native.iter_mut().map(Vec::as_mut_slice).collect();
    kernel.run(&mut native_blocks).expect("blocks of the right length");
    let mut plain_blocks: Vec<&mut [f64]> = plain.iter_mut().map(Vec::as_mut_slice).collect();
    program.evaluate(lanes, &mut plain_blocks).expect("blocks of the right length");
    for (block, (native, plain)) in native.iter().zip(&plain).enumerate() {
        for (place, (native, plain)) in native.iter().zip(plain).enumerate() {
            assert_eq!(
                comparable(*native),
                comparable(*plain),
                "block {block} place {place}: {native} by {level}, {plain} interpreted\n{program:?}"
            );
        }
    }
}

#[test]
fn identity_machine_code_and_interpreter_give_the_same_bits() {
    let mut random = Random(20);
    for trial in 0..3000 {
        let shape = Shape {
            nodes: 1 + random.below(if trial % 10 == 0 { 400 } else { 100 }),
            inputs: 1 + random.below(30),
            outputs: 1 + random.below(20),
            reach: 2 + random.below(80),
            blocks: 1 + random.below(8),
            is_in_place: random.below(2) == 0,
        };
        let program = random_program(&mut random, &shape);
        for (level, lanes, interleaved) in ARRANGEMENTS {
            check_agreement(&mut random, &program, level, lanes, interleaved);
        }
    }
}

#[test]
fn identity_inputs_change_places_although_they_find_no_registers() {
    const VALUES: u32 = 45;
    let mut graph = Graph::new();
    let slot = |index: u32| Slot { block: 0, index: index % VALUES };
    // Each value goes one slot on; some are used for a sum as well.
    let mut sum = graph.constant(0.25);
    let mut outputs = Vec::new();
    for index in 0..VALUES {
        let value = graph.input(slot(index));
        sum = graph.mul_add(value, sum, value);
        outputs.push((slot(index + 1), value));
    }
    outputs.push((Slot { block: 1, index: 0 }, sum));
    let constant = graph.constant(7.5);
    outputs.push((Slot { block: 1, index: 1 }, constant));
    outputs.push((Slot { block: 1, index: 2 }, constant));
    let program = Program::new(&graph, &outputs).expect("each output has its own slot");
    let mut random = Random(5);
    for (level, lanes, interleaved) in ARRANGEMENTS {
        check_agreement(&mut random, &program, level, lanes, interleaved);
    }
}

#[test]
fn identity_more_values_and_masks_alive_than_registers() {
    const VALUES: u32 = 120;
    let mut graph = Graph::new();
    let inputs: Vec<Value> = (0..VALUES).map(|index| graph.input(Slot { block: 0, index })).collect();
    let masks: Vec<Mask> = inputs.windows(2).map(|pair| graph.less_than(pair[0], pair[1])).collect();
    let products: Vec<Value> = inputs.windows(2).map(|pair| graph.multiply(pair[0], pair[1])).collect();
    // Each output needs a mask and two products from far apart, so that all of them are alive together.
    let outputs: Vec<(Slot, Value)> = (0..products.len())
        .map(|index| {
            let far = (index * 37 + 11) % products.len();
            let (mask, other) = (masks[(index * 53 + 5) % masks.len()], masks[far]);
            let inner = graph.select(other, products[index], products[far]);
            let value = graph.select(mask, inner, products[far]);
            (Slot { block: 1, index: index as u32 }, value)
        })
        .collect();
    let program = Program::new(&graph, &outputs).expect("each output has its own slot");
    let mut random = Random(6);
    for (level, lanes, interleaved) in ARRANGEMENTS {
        let (_, size) =
            translate_interleaved(&program, level, lanes, interleaved).expect("a program within the limits");
        assert!(size.spills > 0, "{level}: {size:?}");
        check_agreement(&mut random, &program, level, lanes, interleaved);
    }
}

#[test]
fn identity_lanes_evaluated_together_and_alone_give_the_same_bits() {
    // 32 together, eight, and three more.
    const LANES: usize = 43;
    let mut random = Random(9);
    for _ in 0..50 {
        let shape = Shape { nodes: 80, inputs: 9, outputs: 8, reach: 25, blocks: 3, is_in_place: true };
        let program = random_program(&mut random, &shape);
        let mut together: Vec<Vec<f64>> = program
            .values_per_block()
            .iter()
            .map(|values| (0..values * LANES).map(|_| random.operand()).collect())
            .collect();
        let start = together.clone();
        let evaluate = |lanes: usize, blocks: &mut [Vec<f64>]| {
            let mut blocks: Vec<&mut [f64]> = blocks.iter_mut().map(Vec::as_mut_slice).collect();
            program.evaluate(lanes, &mut blocks).expect("blocks of the right length");
        };
        evaluate(LANES, &mut together);
        for lane in 0..LANES {
            let of_lane = |blocks: &[Vec<f64>]| -> Vec<Vec<f64>> {
                blocks.iter().map(|block| block.iter().skip(lane).step_by(LANES).copied().collect()).collect()
            };
            let mut alone = of_lane(&start);
            evaluate(1, &mut alone);
            let bits = |blocks: Vec<Vec<f64>>| blocks.concat().into_iter().map(comparable).collect::<Vec<u64>>();
            assert_eq!(bits(of_lane(&together)), bits(alone), "lane {lane}");
        }
    }
}

#[test]
fn identity_a_sequence_gives_the_same_bits_as_its_programs_one_by_one() {
    const LANES: usize = 40;
    const LENGTHS: [usize; MAX_BLOCKS] = [12, 12, 12, 12, 0, 0, 0, 0];
    let mut random = Random(10);
    for _ in 0..20 {
        let shape = Shape { nodes: 60, inputs: 4, outputs: 4, reach: 20, blocks: 2, is_in_place: true };
        let programs: Vec<Program> = (0..3).map(|_| random_program(&mut random, &shape)).collect();
        let at = |block, first| BlockStart { block, first };
        let calls = [
            (0, [at(0, 0), at(1, 1)]),
            (1, [at(2, 3), at(3, 2)]),
            // Once more elsewhere, both blocks in one; and with blocks exchanged.
            (0, [at(2, 0), at(2, 6)]),
            (2, [at(1, 1), at(0, 2)]),
        ];
        let start: Vec<Vec<f64>> =
            LENGTHS.iter().map(|values| (0..values * LANES).map(|_| random.operand()).collect()).collect();
        let mut expected = start.clone();
        for (program, places) in &calls {
            let mut blocks: Vec<&mut [f64]> = expected.iter_mut().map(Vec::as_mut_slice).collect();
            programs[*program].placed(places).evaluate(LANES, &mut blocks).expect("blocks of the right length");
        }
        let expected: Vec<u64> = expected.concat().into_iter().map(comparable).collect();
        for level in Level::ALL.into_iter().filter(|level| level.is_supported()).map(Some).chain([None]) {
            let routines = Routine::all(programs.clone(), level, LANES);
            let calls: Vec<_> = calls.iter().map(|(program, places)| (&routines[*program], &places[..])).collect();
            let sequence = Sequence::new(&calls).expect("places of the right size");
            let mut found = start.clone();
            let [a, b, c, d, e, f, g, h] = &mut found[..] else { unreachable!("eight blocks") };
            sequence.run(&mut [a, b, c, d, e, f, g, h], &mut Vec::new()).expect("blocks of the right length");
            let found: Vec<u64> = found.concat().into_iter().map(comparable).collect();
            assert!(found == expected, "{level:?}");
            // Some lanes: the same there.
            for lanes in [0..1, 0..8, 7..9, 24..40, 39..40, 0..40] {
                let mut found = start.clone();
                let [a, b, c, d, e, f, g, h] = &mut found[..] else { unreachable!("eight blocks") };
                let blocks = &mut [&mut a[..], b, c, d, e, f, g, h];
                sequence.run_on(lanes.clone(), blocks, &mut Vec::new()).expect("blocks of the right length");
                let found: Vec<u64> = found.concat().into_iter().map(comparable).collect();
                let is_same = |(place, (found, expected)): (usize, (&u64, &u64))| {
                    !lanes.contains(&(place % LANES)) || found == expected
                };
                assert!(found.iter().zip(&expected).enumerate().all(is_same), "{level:?} {lanes:?}");
            }
        }
    }
}

#[test]
fn identity_a_kernel_gives_the_same_bits_in_all_threads() {
    let mut random = Random(8);
    let shape = Shape { nodes: 200, inputs: 12, outputs: 10, reach: 30, blocks: 2, is_in_place: false };
    let program = random_program(&mut random, &shape);
    let Some(level) = Level::best() else {
        assert!(matches!(Kernel::compile(&program, Level::Avx2, 8), Err(NativeError::NotSupported { .. })));
        return;
    };
    let kernel = Kernel::compile(&program, level, 8).expect("executable memory");
    let start: Vec<Vec<f64>> = kernel
        .values_per_block()
        .iter()
        .map(|values| (0..values * kernel.lanes()).map(|_| random.number()).collect())
        .collect();
    let run = || {
        let mut blocks = start.clone();
        kernel.run(&mut blocks.iter_mut().map(Vec::as_mut_slice).collect::<Vec<_>>()).expect("long enough");
        blocks.concat().into_iter().map(comparable).collect::<Vec<u64>>()
    };
    let expected = run();
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4).map(|_| scope.spawn(run)).collect();
        for thread in threads {
            assert_eq!(thread.join().expect("no panic"), expected);
        }
    });
}

#[test]
fn refusals_say_what_is_wrong_and_what_the_rule_is() {
    let mut graph = Graph::new();
    let far = graph.input(Slot { block: 8, index: 0 });
    let near = graph.input(Slot { block: 0, index: 1 });
    let output = Slot { block: 1, index: 3 };
    let text = |result: Result<(), NativeError>| result.expect_err("a refusal").to_string();
    let compile = |program: &Program, level, lanes| text(Kernel::compile(program, level, lanes).map(|_| ()));

    assert_eq!(
        text(Program::new(&graph, &[(output, near), (output, far)]).map(|_| ())),
        "value 3 of block 1 is written twice; each output must have its own slot"
    );
    let many_blocks = Program::new(&graph, &[(output, far)]).expect("one output");
    assert_eq!(compile(&many_blocks, Level::Avx2, 8), "the program uses 9 blocks; must be at most 8");
    let program = Program::new(&graph, &[(output, near)]).expect("one output");
    for lanes in [0, 12, 1032] {
        assert_eq!(
            compile(&program, Level::Avx512, lanes),
            format!("{lanes} lanes for AVX-512; must be a positive multiple of 8 up to 1024")
        );
    }
    let high = graph.input(Slot { block: 0, index: 1 << 25 });
    let large = Program::new(&graph, &[(output, high)]).expect("one output");
    assert_eq!(compile(&large, Level::Avx2, 8), "block 0 has 33554433 values of 8 lanes; must be below 2 GiB");

    // All inputs go one slot on: each needs a place in the frame.
    const VALUES: u32 = 5000;
    let slots = (0..VALUES).map(|index| Slot { block: 0, index: (index + 1) % VALUES });
    let moved: Vec<(Slot, Value)> =
        slots.enumerate().map(|(index, slot)| (slot, graph.input(Slot { block: 0, index: index as u32 }))).collect();
    let wide = Program::new(&graph, &moved).expect("each output has its own slot");
    assert_eq!(
        compile(&wide, Level::Avx512, 8),
        "the machine code needs a stack frame of 320000 bytes; must be at most 262144\nhint: interpret the program instead"
    );

    let (mut inputs, mut outputs) = (vec![1.5; 16], vec![f64::NAN; 31]);
    assert_eq!(text(program.evaluate(8, &mut [&mut inputs])), "called with 1 blocks; must be at least 2");
    assert_eq!(
        text(program.evaluate(8, &mut [&mut inputs, &mut outputs])),
        "block 1 holds 31 numbers; must hold at least 32"
    );
    for level in [Level::best(), None] {
        let routine = &Routine::all(vec![program.clone()], level, 8)[0];
        let sequence = |places: &[BlockStart]| Sequence::new(&[(routine, places)]);
        let refused = |places: &[BlockStart]| text(sequence(places).map(|_| ()));
        let at = |block, first| BlockStart { block, first };
        assert_eq!(refused(&[at(0, 0)]), "called with 1 blocks; must be at least 2");
        assert_eq!(refused(&[at(0, 0), at(8, 0)]), "the program uses 9 blocks; must be at most 8");
        // Values 2 and 3 of the block, and 3 to 6.
        assert_eq!(
            refused(&[at(0, 2), at(0, 3)]),
            "two blocks of the program overlap in block 0; each must have numbers of its own"
        );
        let mut short = vec![0.0; 47];
        let [a, b, c, d, e, f, g]: [&mut [f64]; 7] = std::array::from_fn(|_| Default::default());
        let sequence = sequence(&[at(0, 0), at(0, 2)]).expect("next to each other");
        assert_eq!(
            text(sequence.run(&mut [&mut short, a, b, c, d, e, f, g], &mut Vec::new())),
            "block 0 holds 47 numbers; must hold at least 48"
        );
    }
    if let Some(level) = Level::best() {
        let kernel = Kernel::compile(&program, level, 8).expect("executable memory");
        assert_eq!(
            text(kernel.run(&mut [&mut inputs, &mut outputs])),
            "block 1 holds 31 numbers; must hold at least 32"
        );
    }
    assert_eq!(
        NativeError::NotSupported { level: Level::Avx512 }.to_string(),
        "machine code for AVX-512 cannot run on this processor\nhint: interpret the program instead"
    );
    let source = std::io::Error::other("not permitted");
    assert_eq!(
        NativeError::ExecutableMemoryRefused { bytes: 4096, source }.to_string(),
        "the operating system refused 4096 bytes of executable memory: not permitted\nhint: interpret the program instead"
    );
}
