//! Instructions with registers: one pass over the units in their order.
//!
//! An operand in memory is read by the instruction itself where its format allows: loading what is read again into a
//! register was measured to gain nothing.

use super::Level;
use super::instruction::{Arithmetic, FusedForm, Instruction, Memory, Operand, Predicate};
use super::lower::{Lowered, Unit, UnitOperation, ValueIndex};
use super::node::FusedSigns;
use super::registers::{Allocator, VECTORS};

/// Instructions with registers, and how many vectors of stack they need.
#[derive(Debug)]
pub(super) struct Allocated {
    pub instructions: Vec<Instruction>,
    pub frame_vectors: u32,
}

/// Assigns registers to all units of `lowered` and writes the instructions.
pub(super) fn allocate(lowered: &Lowered, level: Level) -> Allocated {
    let mut allocator = Allocator::new(lowered, level);
    for (position, unit) in lowered.units.iter().enumerate() {
        allocator.position = position;
        allocator.unit(unit);
    }
    allocator.position = lowered.units.len();
    allocator.late_stores();
    Allocated { instructions: allocator.instructions, frame_vectors: allocator.frame_vectors }
}

impl Allocator<'_> {
    /// Which of `operands` the instruction shall read from memory itself: at most one, that is in no register and does not
    /// occur twice; the one that is needed again last.
    fn folded(&self, operands: &[ValueIndex]) -> Option<usize> {
        let can_fold = |&place: &usize| {
            let value = operands[place];
            self.register_of(value).is_none()
                && self.places[value as usize].memory.is_some()
                && operands.iter().filter(|&&other| other == value).count() == 1
        };
        (0..operands.len()).filter(can_fold).max_by_key(|&place| self.next_use(operands[place]).unwrap_or(usize::MAX))
    }

    /// `value` as a last operand.
    fn operand(&mut self, value: ValueIndex, is_folded: bool) -> Operand {
        match self.places[value as usize].memory {
            Some(memory) if is_folded => Operand::Memory(memory),
            _ => Operand::Register(self.ensure_in_register(value)),
        }
    }

    /// After all operands are where they are read: frees the registers of those that nobody reads again.
    fn release_operands(&mut self, unit: &Unit) {
        for operand in unit.operands() {
            if self.is_dead(operand) {
                self.release_register(operand);
            }
        }
        self.unpin_all();
    }

    fn result_register(&mut self, unit: &Unit) -> u8 {
        self.release_operands(unit);
        let register = self.take_register(self.file_of(unit.result));
        self.set_register(unit.result, register);
        register
    }

    fn unit(&mut self, unit: &Unit) {
        for operand in unit.operands() {
            let uses = &mut self.uses[operand as usize];
            if uses.last() == Some(&self.position) {
                uses.pop();
            }
            // Loading one operand must not push out another.
            self.pin(operand);
        }
        let instruction = match (unit.operation, unit.operands) {
            (UnitOperation::Arithmetic(operation), [Some(left), Some(right), _]) => {
                self.arithmetic(unit, operation, left, right)
            }
            (UnitOperation::SquareRoot, [Some(operand), ..]) => {
                let is_folded = self.folded(&[operand]).is_some();
                let from = self.operand(operand, is_folded);
                Instruction::SquareRoot { to: self.result_register(unit), from }
            }
            (UnitOperation::MulAdd(signs), [Some(first), Some(second), Some(addend)]) => {
                self.mul_add(unit, signs, [first, second, addend])
            }
            (UnitOperation::LessThan { is_negated }, [Some(left), Some(right), _]) => {
                self.less_than(unit, is_negated, left, right)
            }
            (UnitOperation::MaskNot, [Some(operand), ..]) => {
                let from = self.ensure_in_register(operand);
                Instruction::MaskNot { to: self.result_register(unit), from }
            }
            (UnitOperation::Select, [Some(mask), Some(chosen), Some(otherwise)]) => {
                let is_folded = self.folded(&[chosen]).is_some();
                let (mask, otherwise) = (self.ensure_in_register(mask), self.ensure_in_register(otherwise));
                let chosen = self.operand(chosen, is_folded);
                Instruction::Blend { to: self.result_register(unit), mask, otherwise, chosen }
            }
            _ => unreachable!("lowering gives each operation its operands"),
        };
        self.instructions.push(instruction);
        for operand in unit.operands() {
            // Not before the instruction has read it.
            if self.is_dead(operand) {
                self.release_frame(operand);
            }
        }
        self.store_result(unit.result);
    }

    fn store_result(&mut self, result: ValueIndex) {
        for &memory in self.lowered.early_stores.get(&result).into_iter().flatten() {
            if let Some(from) = self.register_of(result) {
                self.instructions.push(Instruction::Store { from, to: memory });
            }
            // The output can be read again from where it is.
            self.places[result as usize].memory = Some(memory);
        }
        if self.is_dead(result) {
            self.release_register(result);
        }
    }

    fn arithmetic(&mut self, unit: &Unit, operation: Arithmetic, left: ValueIndex, right: ValueIndex) -> Instruction {
        let (left, right, is_folded) = if left == right {
            (left, right, false)
        } else if operation.is_commutative() {
            match self.folded(&[left, right]) {
                Some(0) => (right, left, true),
                Some(_) => (left, right, true),
                None => (left, right, false),
            }
        } else {
            (left, right, self.folded(&[right]).is_some())
        };
        let left = self.ensure_in_register(left);
        let right = self.operand(right, is_folded);
        Instruction::Arithmetic { operation, to: self.result_register(unit), left, right }
    }

    fn less_than(&mut self, unit: &Unit, is_negated: bool, left: ValueIndex, right: ValueIndex) -> Instruction {
        let folded = self.folded(&[left, right]);
        // `left < right` is `right > left`.
        let (predicate, left, right) = match (folded, is_negated) {
            (Some(0), false) => (Predicate::Greater, right, left),
            (Some(0), true) => (Predicate::NotGreater, right, left),
            (_, false) => (Predicate::Less, left, right),
            (_, true) => (Predicate::NotLess, left, right),
        };
        let left = self.ensure_in_register(left);
        let right = self.operand(right, folded.is_some());
        Instruction::Compare { predicate, to: self.result_register(unit), left, right }
    }

    /// A fused multiply-add overwrites one of its operands: one that nobody reads again, or else a copy.
    fn mul_add(&mut self, unit: &Unit, signs: FusedSigns, operands: [ValueIndex; 3]) -> Instruction {
        let folded = self.folded(&operands);
        let mut registers = [0; 3];
        for place in 0..3 {
            if folded != Some(place) {
                registers[place] = self.ensure_in_register(operands[place]);
            }
        }
        let memory = folded.and_then(|place| self.places[operands[place] as usize].memory);
        let in_registers = (0..3).rev().filter(|&place| folded != Some(place));
        let dead = in_registers.clone().find(|&place| self.is_dead(operands[place]));
        self.release_operands(unit);
        let accumulator = match dead {
            Some(place) => registers[place],
            None => self.take_register(VECTORS),
        };
        self.set_register(unit.result, accumulator);
        // The register may be that of an operand that was moved to memory for it: then its number is still there.
        let overwritten = dead.or_else(|| in_registers.clone().find(|&place| registers[place] == accumulator));
        let overwritten = overwritten.unwrap_or_else(|| {
            let place = if folded == Some(2) { 0 } else { 2 };
            self.instructions.push(Instruction::Move { to: accumulator, from: registers[place] });
            place
        });
        // The factor that is not overwritten.
        let factor = if overwritten == 0 { 1 } else { 0 };
        let (form, second, third) = match (overwritten, folded) {
            (2, Some(0)) => (FusedForm::Form231, 1, 0),
            (2, _) => (FusedForm::Form231, 0, 1),
            (_, Some(2) | None) => (FusedForm::Form213, factor, 2),
            (_, Some(_)) => (FusedForm::Form132, 2, factor),
        };
        let third = memory.map_or(Operand::Register(registers[third]), Operand::Memory);
        Instruction::MulAdd { form, signs, accumulator, second: registers[second], third }
    }

    /// A store over inputs goes last; an input that is itself an output elsewhere is taken to safety before.
    fn late_stores(&mut self) {
        let lowered = self.lowered;
        for &(value, _) in &lowered.late_stores {
            let is_safe = !matches!(self.places[value as usize].memory, Some(Memory::Slot { .. }));
            if lowered.values[value as usize].is_overwritten && !is_safe {
                let register = self.ensure_in_register(value);
                self.spill(value, register);
                self.unpin_all();
            }
        }
        for stores in lowered.late_stores.chunk_by(|one, other| one.0 == other.0) {
            let value = stores[0].0;
            let from = self.ensure_in_register(value);
            for &(_, to) in stores {
                self.instructions.push(Instruction::Store { from, to });
            }
            self.uses[value as usize].clear();
            self.release_register(value);
            self.release_frame(value);
            self.unpin_all();
        }
    }
}
