//! The whole kernel as bytes: entry, loop over the lanes, return.

use super::Level;
use super::allocate::Allocated;
use super::encode::{BLOCK_REGISTERS, Encoder};

/// A stack frame is touched in steps of this size, so that the page that guards the stack is met and not jumped.
const PAGE_BYTES: usize = 4096;

/// The shape of a kernel around its instructions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Layout {
    pub level: Level,
    /// How many blocks the caller gives the addresses of.
    pub blocks: usize,
    /// How often the instructions run at most.
    pub trips: usize,
    /// How much further in all blocks each time.
    pub step_bytes: usize,
}

/// Bytes of a function `extern "sysv64" fn(*const *mut f64, u32)`; only [`assemble`] makes them.
#[derive(Debug)]
pub(super) struct Code {
    bytes: Vec<u8>,
}

impl Code {
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

/// Machine code that runs the instructions of `allocated`, with the `constants` behind it.
///
/// The code is called by the System V convention with the table of the addresses of the blocks and how often the instructions are to run:
/// once at least, and once where there is one trip alone. It keeps the registers
/// that belong to the caller and leaves the upper halves of the vector registers empty.
pub(super) fn assemble(allocated: &Allocated, constants: &[u64], layout: Layout) -> Code {
    let Layout { level, blocks, trips, step_bytes } = layout;
    let mut encoder = Encoder::new(level);
    if trips > 1 {
        // mov eax, esi, before the register is that of a block
        encoder.raw(&[0x89, 0xF0]);
    }
    let frame_bytes = allocated.frame_vectors as usize * level.vector_bytes();
    if frame_bytes > 0 {
        enter_frame(&mut encoder, frame_bytes, level.vector_bytes());
    }
    for (block, register) in BLOCK_REGISTERS.iter().copied().enumerate().take(blocks) {
        load_address(&mut encoder, register, block);
    }
    let start = encoder.bytes().len();
    for &instruction in &allocated.instructions {
        encoder.instruction(instruction);
    }
    if trips > 1 {
        for register in BLOCK_REGISTERS.iter().copied().take(blocks) {
            add_to_address(&mut encoder, register, step_bytes);
        }
        // sub eax, 1
        encoder.raw(&[0x83, 0xE8, 0x01]);
        // jnz start
        let distance = start as i64 - (encoder.bytes().len() as i64 + 6);
        encoder.raw(&[0x0F, 0x85]);
        encoder.raw(&(distance as i32).to_le_bytes());
    }
    // vzeroupper
    encoder.raw(&[0xC5, 0xF8, 0x77]);
    if frame_bytes > 0 {
        // leave
        encoder.raw(&[0xC9]);
    }
    // ret
    encoder.raw(&[0xC3]);
    Code { bytes: encoder.finish(constants) }
}

/// `push rbp; mov rbp, rsp`, then room for the frame, aligned to whole vectors.
fn enter_frame(encoder: &mut Encoder, frame_bytes: usize, alignment: usize) {
    encoder.raw(&[0x55, 0x48, 0x89, 0xE5]);
    let mut rest = frame_bytes;
    while rest > PAGE_BYTES {
        // sub rsp, PAGE_BYTES; or qword ptr [rsp], 0
        subtract_from_stack(encoder, PAGE_BYTES);
        encoder.raw(&[0x48, 0x83, 0x0C, 0x24, 0x00]);
        rest -= PAGE_BYTES;
    }
    subtract_from_stack(encoder, rest);
    // and rsp, -alignment
    encoder.raw(&[0x48, 0x83, 0xE4, (alignment as u8).wrapping_neg()]);
}

/// `sub rsp, bytes`.
fn subtract_from_stack(encoder: &mut Encoder, bytes: usize) {
    encoder.raw(&[0x48, 0x81, 0xEC]);
    encoder.raw(&(bytes as u32).to_le_bytes());
}

/// `mov register, [rdi + 8 block]`.
fn load_address(encoder: &mut Encoder, register: u8, block: usize) {
    encoder.raw(&[0x48 | (register >> 3) << 2, 0x8B, 0x40 | (register & 7) << 3 | 7, 8 * block as u8]);
}

/// `add register, bytes`.
fn add_to_address(encoder: &mut Encoder, register: u8, bytes: usize) {
    encoder.raw(&[0x48 | register >> 3, 0x81, 0xC0 | register & 7]);
    encoder.raw(&(bytes as u32).to_le_bytes());
}
