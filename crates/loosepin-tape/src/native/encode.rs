//! Instructions to bytes, with the prefixes VEX (256 bits, AVX2) and EVEX (512 bits, AVX-512).
//!
//! Numbers of opcodes and the layout of the prefixes: Intel 64 and IA-32 Architectures Software Developer's Manual,
//! volume 2, sections 2.3 (VEX), 2.7 (EVEX) and the pages of the instructions.

use super::Level;
use super::instruction::{Arithmetic, FusedForm, Instruction, Memory, Operand, Predicate};
use super::node::{BinaryOperation, FusedSigns};

/// General registers by their number in an instruction.
const STACK_POINTER: u8 = 4;

/// The registers that hold the addresses of the blocks: rcx, rdx, rsi, r8 to r11, rdi. None of them belongs to the caller
/// in the System V convention; rdi comes last because it holds the table of addresses at entry.
pub(super) const BLOCK_REGISTERS: [u8; super::MAX_BLOCKS] = [1, 2, 6, 8, 9, 10, 11, 7];

/// Prefix bits "pp": the operand-size prefix that most vector instructions carry, or none.
const PREFIX_NONE: u8 = 0;
const PREFIX_66: u8 = 1;

/// Opcode maps "mm": after 0F, 0F 38 and 0F 3A.
const MAP_0F: u8 = 1;
const MAP_0F38: u8 = 2;
const MAP_0F3A: u8 = 3;

/// An opcode with what its prefix says; `is_wide_vex` is the bit W under VEX (under EVEX it is set for all doubles).
#[derive(Clone, Copy)]
struct Opcode {
    prefix: u8,
    map: u8,
    byte: u8,
    is_wide_vex: bool,
}

/// Map 0F with the prefix 66: most operations on doubles.
const fn double(byte: u8) -> Opcode {
    Opcode { prefix: PREFIX_66, map: MAP_0F, byte, is_wide_vex: false }
}

const LOAD: Opcode = double(0x10);
const STORE: Opcode = double(0x11);
const MOVE: Opcode = double(0x28);
const SQUARE_ROOT: Opcode = double(0x51);
const AND: Opcode = double(0x54);
const EXCLUSIVE_OR: Opcode = double(0x57);
const ADD: Opcode = double(0x58);
const MULTIPLY: Opcode = double(0x59);
const SUBTRACT: Opcode = double(0x5C);
const MINIMUM: Opcode = double(0x5D);
const DIVIDE: Opcode = double(0x5E);
const MAXIMUM: Opcode = double(0x5F);
const COMPARE: Opcode = double(0xC2);
/// EVEX only: one double to all lanes.
const BROADCAST: Opcode = Opcode { prefix: PREFIX_66, map: MAP_0F38, byte: 0x19, is_wide_vex: false };
/// EVEX only: chooses by a mask register.
const BLEND_BY_MASK: Opcode = Opcode { prefix: PREFIX_66, map: MAP_0F38, byte: 0x65, is_wide_vex: false };
/// VEX only: chooses by the sign bits of a vector.
const BLEND_BY_SIGN: Opcode = Opcode { prefix: PREFIX_66, map: MAP_0F3A, byte: 0x4B, is_wide_vex: false };

const MASK_NOT: Opcode = Opcode { prefix: PREFIX_NONE, map: MAP_0F, byte: 0x44, is_wide_vex: false };
const MASK_LOAD: Opcode = Opcode { prefix: PREFIX_NONE, map: MAP_0F, byte: 0x90, is_wide_vex: false };
const MASK_STORE: Opcode = Opcode { prefix: PREFIX_NONE, map: MAP_0F, byte: 0x91, is_wide_vex: false };

fn arithmetic_opcode(operation: Arithmetic) -> Opcode {
    match operation {
        Arithmetic::Binary(BinaryOperation::Add) => ADD,
        Arithmetic::Binary(BinaryOperation::Subtract) => SUBTRACT,
        Arithmetic::Binary(BinaryOperation::Multiply) => MULTIPLY,
        Arithmetic::Binary(BinaryOperation::Divide) => DIVIDE,
        Arithmetic::Binary(BinaryOperation::Minimum) => MINIMUM,
        Arithmetic::Binary(BinaryOperation::Maximum) => MAXIMUM,
        Arithmetic::And => AND,
        Arithmetic::ExclusiveOr => EXCLUSIVE_OR,
    }
}

/// Rows of the opcode table: 98, A8, B8 for 132, 213, 231; then +2 for "sub", +4 for "nmadd", +6 for "nmsub".
fn fused_opcode(form: FusedForm, signs: FusedSigns) -> Opcode {
    let row = match form {
        FusedForm::Form132 => 0x98,
        FusedForm::Form213 => 0xA8,
        FusedForm::Form231 => 0xB8,
    };
    let byte = row + 2 * u8::from(signs.negates_addend) + 4 * u8::from(signs.negates_product);
    Opcode { prefix: PREFIX_66, map: MAP_0F38, byte, is_wide_vex: true }
}

/// The quiet predicates: ordered where the answer is no for NaN, unordered where it is yes.
fn predicate_byte(predicate: Predicate) -> u8 {
    match predicate {
        Predicate::Less => 0x11,
        Predicate::NotLess => 0x15,
        Predicate::Greater => 0x1E,
        Predicate::NotGreater => 0x1A,
    }
}

/// A place in the code that waits for the address of a constant.
#[derive(Debug, Clone, Copy)]
struct Fixup {
    /// Position of four bytes.
    at: usize,
    /// End of the instruction, from which the address counts.
    end: usize,
    constant: u32,
}

/// Bytes of machine code while they are written.
#[derive(Debug)]
pub(super) struct Encoder {
    level: Level,
    bytes: Vec<u8>,
    fixups: Vec<Fixup>,
}

impl Encoder {
    pub fn new(level: Level) -> Self {
        Self { level, bytes: Vec::new(), fixups: Vec::new() }
    }

    /// The code so far; addresses of constants are still zero.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Raw bytes, for the few instructions that are not vector instructions.
    pub fn raw(&mut self, bytes: &[u8]) {
        self.bytes.extend_from_slice(bytes);
    }

    /// Appends `constants`, sets the addresses that point to them, and gives the whole code.
    pub fn finish(mut self, constants: &[u64]) -> Vec<u8> {
        // A processor may read ahead: what follows the return is a trap.
        while !self.bytes.len().is_multiple_of(64) {
            self.bytes.push(0xCC);
        }
        let pool = self.bytes.len();
        let copies = self.copies_of_a_constant();
        for constant in constants {
            for _ in 0..copies {
                self.bytes.extend_from_slice(&constant.to_le_bytes());
            }
        }
        for fixup in &self.fixups {
            let target = pool + fixup.constant as usize * copies * size_of::<u64>();
            // Code of 2 GiB would not have fitted into memory on its way here.
            let distance = (target - fixup.end) as u32;
            self.bytes[fixup.at..fixup.at + 4].copy_from_slice(&distance.to_le_bytes());
        }
        self.bytes
    }

    /// AVX-512 spreads one number over the lanes while it reads; AVX2 wants it written out.
    fn copies_of_a_constant(&self) -> usize {
        match self.level {
            Level::Avx2 => self.level.vector_lanes(),
            Level::Avx512 => 1,
        }
    }

    /// Appends one instruction.
    pub fn instruction(&mut self, instruction: Instruction) {
        use Operand::Register;
        match instruction {
            Instruction::Load { to, from: from @ Memory::Constant(_) } if self.level == Level::Avx512 => {
                self.evex(BROADCAST, to, 0, Operand::Memory(from), 0, false, None);
            }
            Instruction::Load { to, from } => self.vector(LOAD, to, 0, Operand::Memory(from), None),
            Instruction::Store { from, to } => self.vector(STORE, from, 0, Operand::Memory(to), None),
            Instruction::Move { to, from } => self.vector(MOVE, to, 0, Register(from), None),
            Instruction::Arithmetic { operation, to, left, right } => {
                self.vector(arithmetic_opcode(operation), to, left, right, None);
            }
            Instruction::SquareRoot { to, from } => self.vector(SQUARE_ROOT, to, 0, from, None),
            Instruction::MulAdd { form, signs, accumulator, second, third } => {
                self.vector(fused_opcode(form, signs), accumulator, second, third, None);
            }
            Instruction::Compare { predicate, to, left, right } => {
                self.vector(COMPARE, to, left, right, Some(predicate_byte(predicate)));
            }
            Instruction::Blend { to, mask, otherwise, chosen } => match self.level {
                Level::Avx2 => self.vex(BLEND_BY_SIGN, to, otherwise, chosen, true, Some(mask << 4)),
                Level::Avx512 => self.evex(BLEND_BY_MASK, to, otherwise, chosen, mask, true, None),
            },
            Instruction::MaskNot { to, from } => self.vex(MASK_NOT, to, 0, Register(from), false, None),
            Instruction::MaskLoad { to, from } => self.vex(MASK_LOAD, to, 0, Operand::Memory(from), false, None),
            Instruction::MaskStore { from, to } => self.vex(MASK_STORE, from, 0, Operand::Memory(to), false, None),
        }
    }

    /// One vector instruction of the level's width.
    fn vector(&mut self, opcode: Opcode, register: u8, second: u8, last: Operand, immediate: Option<u8>) {
        match self.level {
            Level::Avx2 => self.vex(opcode, register, second, last, true, immediate),
            Level::Avx512 => self.evex(opcode, register, second, last, 0, true, immediate),
        }
    }

    /// C4, then ~R ~X ~B map, then W ~vvvv L pp, each a byte; the opcode; the operand.
    fn vex(&mut self, opcode: Opcode, register: u8, second: u8, last: Operand, is_long: bool, immediate: Option<u8>) {
        let not_r = !(register >> 3) & 1;
        let not_b = !(base_number(last) >> 3) & 1;
        self.bytes.push(0xC4);
        self.bytes.push(not_r << 7 | 1 << 6 | not_b << 5 | opcode.map);
        let wide = u8::from(opcode.is_wide_vex);
        self.bytes.push(wide << 7 | (!second & 15) << 3 | u8::from(is_long) << 2 | opcode.prefix);
        self.bytes.push(opcode.byte);
        self.operand(register, last, 1, immediate);
    }

    /// 62, then ~R ~X ~B ~R' 0 map, then W ~vvvv 1 pp, then z L'L b ~V' aaa, each a byte; the opcode; the operand.
    ///
    /// A constant is spread over the lanes by the bit b; `spreads` is false for the instruction that does so by itself.
    #[allow(clippy::too_many_arguments, reason = "one argument for each field of the prefix")]
    fn evex(
        &mut self,
        opcode: Opcode,
        register: u8,
        second: u8,
        last: Operand,
        mask: u8,
        spreads: bool,
        immediate: Option<u8>,
    ) {
        let not_r = !(register >> 3) & 1;
        let not_r_high = !(register >> 4) & 1;
        let not_b = !(base_number(last) >> 3) & 1;
        // A register operand has its fifth bit in X, which otherwise belongs to an index register.
        let not_x = match last {
            Operand::Register(number) => !(number >> 4) & 1,
            Operand::Memory(_) => 1,
        };
        let broadcast = u8::from(spreads && matches!(last, Operand::Memory(Memory::Constant(_))));
        self.bytes.push(0x62);
        self.bytes.push(not_r << 7 | not_x << 6 | not_b << 5 | not_r_high << 4 | opcode.map);
        self.bytes.push(1 << 7 | (!second & 15) << 3 | 1 << 2 | opcode.prefix);
        self.bytes.push(0b10 << 5 | broadcast << 4 | (!(second >> 4) & 1) << 3 | mask);
        self.bytes.push(opcode.byte);
        self.operand(register, last, 64, immediate);
    }

    /// The byte ModRM with what follows it. Short displacements count in `unit` bytes.
    fn operand(&mut self, register: u8, last: Operand, unit: i32, immediate: Option<u8>) {
        let register = (register & 7) << 3;
        match last {
            Operand::Register(number) => self.bytes.push(0b11 << 6 | register | number & 7),
            Operand::Memory(Memory::Constant(constant)) => {
                self.bytes.push(register | 0b101);
                let at = self.bytes.len();
                let end = at + 4 + usize::from(immediate.is_some());
                self.fixups.push(Fixup { at, end, constant });
                self.bytes.extend_from_slice(&[0; 4]);
            }
            Operand::Memory(Memory::Slot { block, offset_bytes }) => {
                self.based(register, BLOCK_REGISTERS[usize::from(block)], offset_bytes, unit);
            }
            Operand::Memory(Memory::Spill(number)) => {
                let offset_bytes = number as i32 * self.level.vector_bytes() as i32;
                self.based(register, STACK_POINTER, offset_bytes, unit);
            }
        }
        self.bytes.extend(immediate);
    }

    /// `[base + offset]`, where `base` is none of those that need a displacement (rbp, r13).
    fn based(&mut self, register: u8, base: u8, offset_bytes: i32, unit: i32) {
        let short = i8::try_from(offset_bytes / unit).ok().filter(|_| offset_bytes % unit == 0);
        let mode = match short {
            Some(0) => 0b00,
            Some(_) => 0b01,
            None => 0b10,
        };
        self.bytes.push(mode << 6 | register | base & 7);
        if base == STACK_POINTER {
            // No index register.
            self.bytes.push(0x24);
        }
        match short {
            Some(0) => {}
            Some(short) => self.bytes.extend_from_slice(&short.to_le_bytes()),
            None => self.bytes.extend_from_slice(&offset_bytes.to_le_bytes()),
        }
    }
}

/// The number whose fourth bit goes into the prefix as B.
fn base_number(last: Operand) -> u8 {
    match last {
        Operand::Register(number) => number,
        Operand::Memory(Memory::Slot { block, .. }) => BLOCK_REGISTERS[usize::from(block)],
        Operand::Memory(Memory::Constant(_) | Memory::Spill(_)) => 0,
    }
}
