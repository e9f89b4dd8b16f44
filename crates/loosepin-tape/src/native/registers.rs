//! Which value is in which register, and where it is when there is none for it.
//!
//! When no register is free, the one goes whose value is needed last (Belady's rule, which is optimal for loads alone;
//! L. A. Belady, A study of replacement algorithms for a virtual-storage computer, IBM Systems Journal 5 (1966) 78-101). A
//! value that also lies in memory (an input, a constant, an output already stored, a value spilled before) goes for nothing;
//! others are stored in the frame of the kernel first, so they go less readily.

use super::Level;
use super::instruction::{Instruction, Memory};
use super::lower::{Lowered, ValueIndex};

/// Current location of a value.
#[derive(Debug, Clone, Copy)]
pub(super) struct ValueLocation {
    register: Option<u8>,
    pub memory: Option<Memory>,
}

/// Registers of one kind.
struct RegisterFile {
    contents: Vec<Option<ValueIndex>>,
    /// The number of the first register.
    first: u8,
    /// One bit a register: holds an operand of the present unit.
    pinned: u32,
}

impl RegisterFile {
    fn new(first: u8, registers: usize) -> Self {
        Self { contents: vec![None; registers], first, pinned: 0 }
    }
}

/// Weight of a store: a value that must be stored first gives up its register only if it is needed this many times later than one that need
/// not.
const STORE_WEIGHT: usize = 4;

/// Position of the vector registers in [`Allocator::files`].
pub(super) const VECTORS: usize = 0;
/// Position of the mask registers of AVX-512 in [`Allocator::files`].
const MASKS: usize = 1;

/// The state of the allocation between two instructions.
pub(super) struct Allocator<'a> {
    pub lowered: &'a Lowered,
    level: Level,
    /// Vectors, and masks where they have registers of their own.
    files: [RegisterFile; 2],
    pub places: Vec<ValueLocation>,
    /// Positions of the units to come that read a value, last first, so that the next one is at the end.
    pub uses: Vec<Vec<usize>>,
    /// The current unit.
    pub position: usize,
    free_frame_vectors: Vec<u32>,
    pub frame_vectors: u32,
    pub instructions: Vec<Instruction>,
}

impl<'a> Allocator<'a> {
    pub fn new(lowered: &'a Lowered, level: Level) -> Self {
        let mut uses: Vec<Vec<usize>> = vec![Vec::new(); lowered.values.len()];
        let mut add_use = |value: ValueIndex, position: usize| {
            let uses = &mut uses[value as usize];
            if uses.last() != Some(&position) {
                uses.push(position);
            }
        };
        for &(value, _) in &lowered.late_stores {
            add_use(value, lowered.units.len());
        }
        for (position, unit) in lowered.units.iter().enumerate().rev() {
            unit.operands().for_each(|operand| add_use(operand, position));
        }
        Self {
            lowered,
            level,
            // k0 cannot choose lanes.
            files: [RegisterFile::new(0, level.vector_registers()), RegisterFile::new(1, 7)],
            places: lowered.values.iter().map(|value| ValueLocation { register: None, memory: value.memory }).collect(),
            uses,
            position: 0,
            free_frame_vectors: Vec::new(),
            frame_vectors: 0,
            instructions: Vec::new(),
        }
    }

    pub fn file_of(&self, value: ValueIndex) -> usize {
        let has_mask_register = self.level == Level::Avx512 && self.lowered.values[value as usize].is_mask;
        if has_mask_register { MASKS } else { VECTORS }
    }

    /// The next unit that reads `value`, as a position.
    pub fn next_use(&self, value: ValueIndex) -> Option<usize> {
        self.uses[value as usize].last().copied()
    }

    pub fn is_dead(&self, value: ValueIndex) -> bool {
        self.uses[value as usize].is_empty()
    }

    pub fn register_of(&self, value: ValueIndex) -> Option<u8> {
        self.places[value as usize].register
    }

    pub fn set_register(&mut self, value: ValueIndex, register: u8) {
        let file = &mut self.files[self.file_of(value)];
        file.contents[usize::from(register - file.first)] = Some(value);
        self.places[value as usize].register = Some(register);
    }

    pub fn release_register(&mut self, value: ValueIndex) {
        if let Some(register) = self.places[value as usize].register.take() {
            let file = &mut self.files[self.file_of(value)];
            file.contents[usize::from(register - file.first)] = None;
        }
    }

    pub fn release_frame(&mut self, value: ValueIndex) {
        if let Some(Memory::Spill(number)) = self.places[value as usize].memory {
            self.places[value as usize].memory = None;
            self.free_frame_vectors.push(number);
        }
    }

    /// A register of the file that holds nothing any more.
    pub fn take_register(&mut self, file: usize) -> u8 {
        let RegisterFile { contents, first, pinned } = &self.files[file];
        let first = *first;
        if let Some(free) = contents.iter().position(Option::is_none) {
            return free as u8 + first;
        }
        let mut best: Option<(usize, usize, ValueIndex)> = None;
        for (register, &value) in contents.iter().enumerate() {
            let Some(value) = value.filter(|_| pinned >> register & 1 == 0) else { continue };
            let distance = self.next_use(value).map_or(usize::MAX / STORE_WEIGHT, |next| next - self.position);
            let weight = if self.places[value as usize].memory.is_some() { STORE_WEIGHT } else { 1 };
            if best.is_none_or(|(score, ..)| distance * weight > score) {
                best = Some((distance * weight, register, value));
            }
        }
        // At most three registers are pinned at a time.
        let (_, register, value) = best.expect("a register that is not an operand");
        if self.places[value as usize].memory.is_none() {
            self.spill(value, register as u8 + first);
        }
        self.release_register(value);
        register as u8 + first
    }

    /// Stores `value` in the frame.
    pub fn spill(&mut self, value: ValueIndex, register: u8) {
        let number = self.free_frame_vectors.pop().unwrap_or_else(|| {
            self.frame_vectors += 1;
            self.frame_vectors - 1
        });
        let to = Memory::Spill(number);
        self.places[value as usize].memory = Some(to);
        self.instructions.push(if self.file_of(value) == MASKS {
            Instruction::MaskStore { from: register, to }
        } else {
            Instruction::Store { from: register, to }
        });
    }

    /// The register of `value`, which is loaded if it is in none, and stays there for the present unit.
    pub fn ensure_in_register(&mut self, value: ValueIndex) -> u8 {
        let file = self.file_of(value);
        let register = match (self.register_of(value), self.places[value as usize].memory) {
            (None, Some(from)) => {
                let to = self.take_register(file);
                self.instructions.push(if file == MASKS {
                    Instruction::MaskLoad { to, from }
                } else {
                    Instruction::Load { to, from }
                });
                self.set_register(value, to);
                to
            }
            (register, _) => register.expect("a value is computed before it is used"),
        };
        self.pin(value);
        register
    }

    /// Keeps `value` in its register, if it is in one, until [`Allocator::unpin_all`].
    pub fn pin(&mut self, value: ValueIndex) {
        if let Some(register) = self.register_of(value) {
            let file = &mut self.files[self.file_of(value)];
            file.pinned |= 1 << (register - file.first);
        }
    }

    /// Makes all registers available again.
    pub fn unpin_all(&mut self) {
        for file in &mut self.files {
            file.pinned = 0;
        }
    }
}
