//! Every instruction on random operands: executed beside a model of the processor, and its bytes beside those of GNU as.

use super::allocate::Allocated;
use super::assemble::{Layout, assemble};
use super::encode::{BLOCK_REGISTERS, Encoder};
use super::instruction::{Arithmetic, FusedForm, Instruction, Memory, Operand, Predicate};
use super::node::{BinaryOperation, FusedSigns};
use super::random_programs::{Random, comparable};
use super::translate::KernelSize;
use super::{Kernel, Level, MAX_BLOCKS, NativeError};

const SIGN_BIT: u64 = 1 << 63;

/// Constants behind the code: what And and ExclusiveOr take, what a mask of AVX2 is turned round with, and two numbers.
const CONSTANTS: [u64; 5] = [SIGN_BIT, !SIGN_BIT, u64::MAX, 0x3FF8_0000_0000_0000, 0xC004_0000_0000_0000];

/// Vectors of a block: more than a short displacement reaches, which is 127 vectors of AVX-512.
const BLOCK_VECTORS: usize = 140;

/// Vectors of the stack frame: more than four pages.
const FRAME_VECTORS: u32 = 300;

/// In AVX2 the last registers are kept for masks, so that no other number is taken for one.
const MASK_REGISTERS: u8 = 4;

fn registers(level: Level) -> u8 {
    match level {
        Level::Avx2 => 16 - MASK_REGISTERS,
        Level::Avx512 => 32,
    }
}

fn pick<T: Copy>(random: &mut Random, from: &[T]) -> T {
    from[random.below(from.len())]
}

/// Instructions on random registers and places.
struct Generator<'a> {
    random: &'a mut Random,
    level: Level,
}

impl Generator<'_> {
    fn vector(&mut self) -> u8 {
        self.random.below(usize::from(registers(self.level))) as u8
    }

    fn mask(&mut self) -> u8 {
        match self.level {
            Level::Avx2 => registers(self.level) + self.random.below(usize::from(MASK_REGISTERS)) as u8,
            Level::Avx512 => 1 + self.random.below(7) as u8,
        }
    }

    fn place(&mut self) -> Memory {
        if self.random.below(3) == 0 {
            // The first quarter holds vectors, the rest masks.
            return Memory::Spill(self.random.below(FRAME_VECTORS as usize / 4) as u32);
        }
        let vector = pick(self.random, &[0, 1, 3, 4, 126, 127, 128, 139]);
        let offset_bytes = (vector * self.level.vector_bytes()) as i32;
        Memory::Slot { block: self.random.below(MAX_BLOCKS) as u8, offset_bytes }
    }

    fn mask_place(&mut self) -> Memory {
        Memory::Spill((FRAME_VECTORS as usize / 4 + self.random.below(FRAME_VECTORS as usize * 3 / 4)) as u32)
    }

    fn operand(&mut self) -> Operand {
        match self.random.below(4) {
            0 => Operand::Memory(Memory::Constant(3 + self.random.below(2) as u32)),
            1 => Operand::Memory(self.place()),
            _ => Operand::Register(self.vector()),
        }
    }

    fn instruction(&mut self) -> Instruction {
        use BinaryOperation::{Add, Divide, Maximum, Minimum, Multiply, Subtract};
        match self.random.below(12) {
            0 => Instruction::Load {
                to: self.vector(),
                from: if self.random.below(3) == 0 { Memory::Constant(3) } else { self.place() },
            },
            1 => Instruction::Store { from: self.vector(), to: self.place() },
            2 => Instruction::Move { to: self.vector(), from: self.vector() },
            3 | 4 => Instruction::Arithmetic {
                operation: Arithmetic::Binary(pick(self.random, &[Add, Subtract, Multiply, Divide, Minimum, Maximum])),
                to: self.vector(),
                left: self.vector(),
                right: self.operand(),
            },
            5 => {
                let (operation, constant) = pick(self.random, &[(Arithmetic::ExclusiveOr, 0), (Arithmetic::And, 1)]);
                let right = Operand::Memory(Memory::Constant(constant));
                Instruction::Arithmetic { operation, to: self.vector(), left: self.vector(), right }
            }
            6 => Instruction::SquareRoot { to: self.vector(), from: self.operand() },
            7 | 8 => Instruction::MulAdd {
                form: pick(self.random, &[FusedForm::Form132, FusedForm::Form213, FusedForm::Form231]),
                signs: FusedSigns {
                    negates_product: self.random.below(2) == 0,
                    negates_addend: self.random.below(2) == 0,
                },
                accumulator: self.vector(),
                second: self.vector(),
                third: self.operand(),
            },
            9 => Instruction::Compare {
                predicate: pick(
                    self.random,
                    &[Predicate::Less, Predicate::NotLess, Predicate::Greater, Predicate::NotGreater],
                ),
                to: self.mask(),
                left: self.vector(),
                right: self.operand(),
            },
            10 => Instruction::Blend {
                to: self.vector(),
                mask: self.mask(),
                otherwise: self.vector(),
                chosen: self.operand(),
            },
            _ => self.mask_instruction(),
        }
    }

    fn mask_instruction(&mut self) -> Instruction {
        match (self.random.below(3), self.level) {
            (0, Level::Avx2) => Instruction::Arithmetic {
                operation: Arithmetic::ExclusiveOr,
                to: self.mask(),
                left: self.mask(),
                right: Operand::Memory(Memory::Constant(2)),
            },
            (0, Level::Avx512) => Instruction::MaskNot { to: self.mask(), from: self.mask() },
            (1, Level::Avx2) => Instruction::Store { from: self.mask(), to: self.mask_place() },
            (1, Level::Avx512) => Instruction::MaskStore { from: self.mask(), to: self.mask_place() },
            (_, Level::Avx2) => Instruction::Load { to: self.mask(), from: self.mask_place() },
            (_, Level::Avx512) => Instruction::MaskLoad { to: self.mask(), from: self.mask_place() },
        }
    }
}

/// Expected results of the instructions, one lane at a time.
struct Model {
    /// Registers, bits of a lane.
    vectors: [u64; 32],
    /// Registers of masks of AVX-512.
    masks: [bool; 8],
    blocks: Vec<Vec<u64>>,
    frame: Vec<u64>,
}

impl Model {
    fn read(&self, memory: Memory, level: Level) -> u64 {
        match memory {
            Memory::Constant(number) => CONSTANTS[number as usize],
            Memory::Spill(number) => self.frame[number as usize],
            Memory::Slot { block, offset_bytes } => {
                self.blocks[usize::from(block)][offset_bytes as usize / level.vector_bytes()]
            }
        }
    }

    fn write(&mut self, memory: Memory, level: Level, bits: u64) {
        match memory {
            Memory::Constant(_) => unreachable!("constants are not written"),
            Memory::Spill(number) => self.frame[number as usize] = bits,
            Memory::Slot { block, offset_bytes } => {
                self.blocks[usize::from(block)][offset_bytes as usize / level.vector_bytes()] = bits;
            }
        }
    }

    fn operand(&self, operand: Operand, level: Level) -> u64 {
        match operand {
            Operand::Register(register) => self.vectors[usize::from(register)],
            Operand::Memory(memory) => self.read(memory, level),
        }
    }

    fn mask(&self, register: u8, level: Level) -> bool {
        match level {
            Level::Avx2 => self.vectors[usize::from(register)] >> 63 == 1,
            Level::Avx512 => self.masks[usize::from(register)],
        }
    }

    fn set_mask(&mut self, register: u8, level: Level, holds: bool) {
        match level {
            Level::Avx2 => self.vectors[usize::from(register)] = if holds { u64::MAX } else { 0 },
            Level::Avx512 => self.masks[usize::from(register)] = holds,
        }
    }

    fn execute(&mut self, instruction: Instruction, level: Level) {
        let vector = |register: u8| self.vectors[usize::from(register)];
        let number = |register: u8| f64::from_bits(vector(register));
        let result = match instruction {
            Instruction::Load { to, from } => (to, self.read(from, level)),
            Instruction::Store { from, to } => return self.write(to, level, vector(from)),
            Instruction::Move { to, from } => (to, vector(from)),
            Instruction::Arithmetic { operation, to, left, right } => {
                let right = self.operand(right, level);
                let bits = match operation {
                    Arithmetic::Binary(operation) => operation.apply(number(left), f64::from_bits(right)).to_bits(),
                    Arithmetic::And => vector(left) & right,
                    Arithmetic::ExclusiveOr => vector(left) ^ right,
                };
                (to, bits)
            }
            Instruction::SquareRoot { to, from } => (to, f64::from_bits(self.operand(from, level)).sqrt().to_bits()),
            Instruction::MulAdd { form, signs, accumulator, second, third } => {
                let third = f64::from_bits(self.operand(third, level));
                let (first, second) = (number(accumulator), number(second));
                let sum = match form {
                    FusedForm::Form132 => signs.apply(first, third, second),
                    FusedForm::Form213 => signs.apply(second, first, third),
                    FusedForm::Form231 => signs.apply(second, third, first),
                };
                (accumulator, sum.to_bits())
            }
            Instruction::Compare { predicate, to, left, right } => {
                let (left, right) = (number(left), f64::from_bits(self.operand(right, level)));
                let holds = match predicate {
                    Predicate::Less => left < right,
                    Predicate::NotLess => !(left < right),
                    Predicate::Greater => left > right,
                    Predicate::NotGreater => !(left > right),
                };
                return self.set_mask(to, level, holds);
            }
            Instruction::Blend { to, mask, otherwise, chosen } => {
                let chosen = self.operand(chosen, level);
                (to, if self.mask(mask, level) { chosen } else { vector(otherwise) })
            }
            Instruction::MaskNot { to, from } => return self.set_mask(to, level, !self.mask(from, level)),
            Instruction::MaskLoad { to, from } => {
                let holds = self.read(from, level) != 0;
                return self.set_mask(to, level, holds);
            }
            Instruction::MaskStore { from, to } => {
                let holds = self.mask(from, level);
                return self.write(to, level, u64::from(holds));
            }
        };
        self.vectors[usize::from(result.0)] = result.1;
    }
}

/// Loads all registers, sets all masks, fills the frame, does `random` instructions, stores all registers.
fn sequence(generator: &mut Generator, length: usize) -> Vec<Instruction> {
    let level = generator.level;
    let slot = |vector: usize| Memory::Slot { block: 7, offset_bytes: (vector * level.vector_bytes()) as i32 };
    let mut sequence: Vec<Instruction> = Vec::new();
    for register in 0..registers(level) {
        sequence.push(Instruction::Load { to: register, from: slot(usize::from(register)) });
    }
    let masks = match level {
        Level::Avx2 => registers(level)..16,
        Level::Avx512 => 1..8,
    };
    for to in masks {
        let (left, right) = (generator.vector(), Operand::Register(generator.vector()));
        sequence.push(Instruction::Compare { predicate: Predicate::Less, to, left, right });
    }
    for number in 0..FRAME_VECTORS {
        sequence.push(if number < FRAME_VECTORS / 4 {
            Instruction::Store { from: generator.vector(), to: Memory::Spill(number) }
        } else if level == Level::Avx2 {
            Instruction::Store { from: generator.mask(), to: Memory::Spill(number) }
        } else {
            Instruction::MaskStore { from: generator.mask(), to: Memory::Spill(number) }
        });
    }
    for _ in 0..length {
        sequence.push(generator.instruction());
    }
    for register in 0..registers(level) {
        sequence.push(Instruction::Store { from: register, to: slot(usize::from(register)) });
    }
    sequence
}

fn check_sequence(random: &mut Random, level: Level, length: usize) {
    let instructions = sequence(&mut Generator { random, level }, length);
    let lanes = level.vector_lanes();
    let layout = Layout { level, blocks: MAX_BLOCKS, trips: 1, step_bytes: 0 };
    let allocated = Allocated { instructions, frame_vectors: FRAME_VECTORS };
    let code = assemble(&allocated, &CONSTANTS, layout);
    let size = KernelSize { interleaved: 1, trips: 1, ..KernelSize::default() };
    let kernel = Kernel::new(&code, size, vec![BLOCK_VECTORS; MAX_BLOCKS], level, lanes);
    if !level.is_supported() {
        assert!(matches!(kernel, Err(NativeError::NotSupported { .. })));
        return;
    }
    let start: Vec<Vec<f64>> =
        (0..MAX_BLOCKS).map(|_| (0..BLOCK_VECTORS * lanes).map(|_| random.operand()).collect()).collect();
    let mut native = start.clone();
    let mut blocks: Vec<&mut [f64]> = native.iter_mut().map(Vec::as_mut_slice).collect();
    kernel.expect("executable memory").run(&mut blocks).expect("blocks of the right length");
    for lane in 0..lanes {
        let of_lane = |block: &Vec<f64>| -> Vec<u64> {
            block.iter().skip(lane).step_by(lanes).map(|number| number.to_bits()).collect()
        };
        let mut model = Model {
            vectors: [0; 32],
            masks: [false; 8],
            blocks: start.iter().map(of_lane).collect(),
            frame: vec![0; FRAME_VECTORS as usize],
        };
        for &instruction in &allocated.instructions {
            model.execute(instruction, level);
        }
        for (block, (native, model)) in native.iter().zip(&model.blocks).enumerate() {
            for (vector, (native, model)) in of_lane(native).into_iter().zip(model).enumerate() {
                let (native, model) = (f64::from_bits(native), f64::from_bits(*model));
                assert_eq!(
                    comparable(native),
                    comparable(model),
                    "{level}, block {block}, vector {vector}, lane {lane}: {native}, not {model}\n{:?}",
                    allocated.instructions
                );
            }
        }
    }
}

#[test]
fn identity_instructions_do_in_all_registers_what_the_model_does() {
    let mut random = Random(7);
    for _ in 0..400 {
        for level in Level::ALL {
            check_sequence(&mut random, level, 60);
        }
    }
}

/// The text of an instruction as GNU as reads it, in Intel's syntax.
fn assembler_text(instruction: Instruction, level: Level) -> String {
    let vector = |register: u8| format!("{}{register}", if level == Level::Avx2 { "ymm" } else { "zmm" });
    let mask = |register: u8| if level == Level::Avx2 { vector(register) } else { format!("k{register}") };
    let address = |memory: Memory| match memory {
        Memory::Constant(_) => "[rip]".to_owned(),
        Memory::Spill(number) => format!("[rsp+{}]", number as usize * level.vector_bytes()),
        Memory::Slot { block, offset_bytes } => {
            let names = ["rax", "rcx", "rdx", "rbx", "rsp", "rbp", "rsi", "rdi", "r8", "r9", "r10", "r11"];
            format!("[{}+{offset_bytes}]", names[usize::from(BLOCK_REGISTERS[usize::from(block)])])
        }
    };
    let memory = |memory: Memory| match (memory, level) {
        (Memory::Constant(_), Level::Avx512) => "qword ptr [rip]{1to8}".to_owned(),
        (_, Level::Avx512) => format!("zmmword ptr {}", address(memory)),
        (_, Level::Avx2) => format!("ymmword ptr {}", address(memory)),
    };
    let operand = |operand: Operand| match operand {
        Operand::Register(register) => vector(register),
        Operand::Memory(place) => memory(place),
    };
    let text = match instruction {
        Instruction::Load { to, from: Memory::Constant(_) } if level == Level::Avx512 => {
            format!("vbroadcastsd {}, qword ptr [rip]", vector(to))
        }
        Instruction::Load { to, from } => format!("vmovupd {}, {}", vector(to), memory(from)),
        Instruction::Store { from, to } => format!("vmovupd {}, {}", memory(to), vector(from)),
        Instruction::Move { to, from } => format!("vmovapd {}, {}", vector(to), vector(from)),
        Instruction::Arithmetic { operation, to, left, right } => {
            let name = match operation {
                Arithmetic::Binary(BinaryOperation::Add) => "vaddpd",
                Arithmetic::Binary(BinaryOperation::Subtract) => "vsubpd",
                Arithmetic::Binary(BinaryOperation::Multiply) => "vmulpd",
                Arithmetic::Binary(BinaryOperation::Divide) => "vdivpd",
                Arithmetic::Binary(BinaryOperation::Minimum) => "vminpd",
                Arithmetic::Binary(BinaryOperation::Maximum) => "vmaxpd",
                Arithmetic::And => "vandpd",
                Arithmetic::ExclusiveOr => "vxorpd",
            };
            format!("{name} {}, {}, {}", vector(to), vector(left), operand(right))
        }
        Instruction::SquareRoot { to, from } => format!("vsqrtpd {}, {}", vector(to), operand(from)),
        Instruction::MulAdd { form, signs, accumulator, second, third } => {
            let name = match (signs.negates_product, signs.negates_addend) {
                (false, false) => "vfmadd",
                (false, true) => "vfmsub",
                (true, false) => "vfnmadd",
                (true, true) => "vfnmsub",
            };
            let form = match form {
                FusedForm::Form132 => "132pd",
                FusedForm::Form213 => "213pd",
                FusedForm::Form231 => "231pd",
            };
            format!("{name}{form} {}, {}, {}", vector(accumulator), vector(second), operand(third))
        }
        Instruction::Compare { predicate, to, left, right } => {
            let name = match predicate {
                Predicate::Less => "lt_oq",
                Predicate::NotLess => "nlt_uq",
                Predicate::Greater => "gt_oq",
                Predicate::NotGreater => "ngt_uq",
            };
            format!("vcmp{name}pd {}, {}, {}", mask(to), vector(left), operand(right))
        }
        Instruction::Blend { to, mask: by, otherwise, chosen } => match level {
            Level::Avx2 => {
                format!("vblendvpd {}, {}, {}, {}", vector(to), vector(otherwise), operand(chosen), mask(by))
            }
            Level::Avx512 => {
                format!("vblendmpd {}{{{}}}, {}, {}", vector(to), mask(by), vector(otherwise), operand(chosen))
            }
        },
        Instruction::MaskNot { to, from } => format!("knotw {}, {}", mask(to), mask(from)),
        Instruction::MaskLoad { to, from } => format!("kmovw {}, word ptr {}", mask(to), address(from)),
        Instruction::MaskStore { from, to } => format!("kmovw word ptr {}, {}", address(to), mask(from)),
    };
    // Of the two lengths of a VEX prefix the encoder writes the longer one alone.
    let is_vex = level == Level::Avx2 || text.starts_with('k');
    if is_vex { format!("{{vex3}} {text}") } else { text }
}

/// Lines `bytes in hexadecimal digits, tab, text`, as `gnu_as_encodings.sh` writes them.
const GNU_AS_ENCODINGS: &str = include_str!("gnu_as_encodings.txt");

/// With other numbers here the file must be written again.
const GNU_AS_SEED: u64 = 11;
const GNU_AS_INSTRUCTIONS: usize = 250;

#[test]
fn peer_gnu_as_encodes_the_same_bytes() {
    let mut random = Random(GNU_AS_SEED);
    let mut lines = Vec::new();
    for level in Level::ALL {
        for _ in 0..GNU_AS_INSTRUCTIONS {
            let instruction = Generator { random: &mut random, level }.instruction();
            let mut encoder = Encoder::new(level);
            encoder.instruction(instruction);
            let bytes: String = encoder.bytes().iter().map(|byte| format!("{byte:02x}")).collect();
            lines.push(format!("{bytes}\t{}", assembler_text(instruction, level)));
        }
    }
    let peer: Vec<&str> = GNU_AS_ENCODINGS.lines().collect();
    let difference = lines.iter().zip(&peer).find(|(ours, peer)| ours != *peer);
    assert!(
        difference.is_none() && lines.len() == peer.len(),
        "ours and GNU as: {difference:#?}\nour lines, input of gnu_as_encodings.sh:\n{}",
        lines.join("\n")
    );
}
