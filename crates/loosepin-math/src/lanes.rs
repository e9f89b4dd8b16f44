//! Several runs side by side: one lane of a vector register is one run.
//!
//! A [`LaneGroup`] is two vectors of eight numbers. What instructions it becomes (AVX-512, AVX2, NEON, ...) is
//! chosen when the program runs; the results have the same bits on all of them, since every multiply-add is a fused one
//! and no operation mixes lanes.

#![allow(
    unsafe_code,
    reason = "a token of an instruction set is made from nothing, and lanes are seen as numbers in a row"
)]

use super::Real;
use core::fmt;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use fearless_simd::{Level, Simd, SimdBase, SimdFloat, f64x8, mask64x8, prelude::*};
use std::sync::OnceLock;

/// Numbers in one vector.
const WIDTH: usize = 8;
/// Vectors in a group.
const VECTORS: usize = 2;

/// A number that holds one value for each of several runs; `f64` is the case of one run.
pub trait Lanes: Real {
    /// How many.
    const COUNT: usize;

    /// The value in one lane.
    fn lane(&self, lane: usize) -> f64;
    /// Replaces the value in one lane.
    fn set_lane(&mut self, lane: usize, value: f64);
    /// All lanes of several numbers in a row: lane l of number i is at `i * COUNT + l`.
    fn in_a_row(numbers: &mut [Self]) -> &mut [f64];
    /// Bit k tells whether the mask holds in lane k.
    fn flags(mask: Self::Mask) -> u32;
    /// The mask whose lane k holds where bit k is set.
    fn mask(flags: u32) -> Self::Mask;
}

impl Lanes for f64 {
    const COUNT: usize = 1;

    #[inline(always)]
    fn lane(&self, _lane: usize) -> f64 {
        *self
    }
    #[inline(always)]
    fn set_lane(&mut self, _lane: usize, value: f64) {
        *self = value;
    }
    #[inline(always)]
    fn in_a_row(numbers: &mut [Self]) -> &mut [f64] {
        numbers
    }
    #[inline(always)]
    fn flags(mask: bool) -> u32 {
        u32::from(mask)
    }
    #[inline(always)]
    fn mask(flags: u32) -> bool {
        flags & 1 != 0
    }
}

/// Vectors that runs may be worked on with: an instruction set that this processor is known to have.
#[derive(Debug, Clone, Copy)]
pub enum Vectors {
    /// None: one run at a time.
    None,
    /// 512 bits.
    #[cfg(target_arch = "x86_64")]
    Avx512(fearless_simd::x86::Avx512),
    /// 256 bits.
    #[cfg(target_arch = "x86_64")]
    Avx2(fearless_simd::x86::Avx2),
    /// 128 bits.
    #[cfg(target_arch = "aarch64")]
    Neon(fearless_simd::aarch64::Neon),
}

impl Vectors {
    /// The widest of this processor.
    pub fn best() -> Self {
        Self::available()[0]
    }

    /// All of this processor, the widest first; the last one is none.
    pub fn available() -> Vec<Self> {
        let level = level();
        let mut available = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            available.extend(level.as_avx512().map(Self::Avx512));
            available.extend(level.as_avx2().map(Self::Avx2));
        }
        #[cfg(target_arch = "aarch64")]
        available.extend(level.as_neon().map(Self::Neon));
        let _ = level;
        available.push(Self::None);
        available
    }

    /// Its name.
    pub fn name(&self) -> &'static str {
        match self {
            Self::None => "scalar",
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(_) => "AVX-512",
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(_) => "AVX2",
            #[cfg(target_arch = "aarch64")]
            Self::Neon(_) => "NEON",
        }
    }
}

/// The instruction set of this processor, found out once.
fn level() -> Level {
    static LEVEL: OnceLock<Level> = OnceLock::new();
    *LEVEL.get_or_init(Level::new)
}

/// Runs `kernel` with the best instructions of this processor, so that a fused multiply-add of plain numbers is one
/// instruction where there is one, and a (slow) function with the same result elsewhere.
#[inline(always)]
pub(super) fn with_fused_multiply_add<R>(kernel: impl FnOnce() -> R) -> R {
    match level() {
        #[cfg(target_arch = "x86_64")]
        Level::Avx512(token) => token.vectorize(kernel),
        #[cfg(target_arch = "x86_64")]
        Level::Avx2(token) => token.vectorize(kernel),
        _ => kernel(),
    }
}

/// An instruction set whose vectors a [`LaneGroup`] is made of.
pub trait InstructionSet: Simd {
    /// The proof that this processor has it. To be called only where a token was shown before: nothing but
    /// [`loosepin_simulate`]'s choice of instruction set, which holds one, may name a [`LaneGroup`] of this set.
    fn proof() -> Self;
}

macro_rules! instruction_sets {
    ($($set:ty),*) => {$(
        impl InstructionSet for $set {
            #[inline(always)]
            fn proof() -> Self {
                // SAFETY: lane groups of this set are used in `simulate::batch` alone, inside of the branch that matched
                // on the token which the detection gave.
                unsafe { <$set>::assume_supported() }
            }
        }
    )*};
}
#[cfg(target_arch = "x86_64")]
instruction_sets!(fearless_simd::x86::Avx512, fearless_simd::x86::Avx2);
#[cfg(target_arch = "aarch64")]
instruction_sets!(fearless_simd::aarch64::Neon);

/// Two vectors of eight lanes on the instruction set `S`, which keep the units of a processor busier than one.
///
/// Every operation is written out for both: the compiler would have to unroll a loop over them, thousands of times in the
/// equations of motion.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct LaneGroup<S: InstructionSet>([f64x8<S>; VECTORS]);

impl<S: InstructionSet> LaneGroup<S> {
    #[inline(always)]
    fn map(self, f: impl Fn(f64x8<S>) -> f64x8<S>) -> Self {
        Self([f(self.0[0]), f(self.0[1])])
    }
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64x8<S>, f64x8<S>) -> f64x8<S>) -> Self {
        Self([f(self.0[0], other.0[0]), f(self.0[1], other.0[1])])
    }
}

impl<S: InstructionSet> fmt::Debug for LaneGroup<S> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.0.iter().flat_map(|vector| vector.as_slice())).finish()
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $assign:ident $assign_method:ident),*) => {$(
        impl<S: InstructionSet> $operator for LaneGroup<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, #[inline(always)] |a, b| a.$method(b))
            }
        }
        impl<S: InstructionSet> $assign for LaneGroup<S> {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                *self = $operator::$method(*self, other);
            }
        }
    )*};
}
operators!(Add add AddAssign add_assign, Sub sub SubAssign sub_assign, Mul mul MulAssign mul_assign);

impl<S: InstructionSet> Div for LaneGroup<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.zip(
            other,
            #[inline(always)]
            |a, b| a / b,
        )
    }
}
impl<S: InstructionSet> Neg for LaneGroup<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(
            #[inline(always)]
            |a| -a,
        )
    }
}

impl<S: InstructionSet> Real for LaneGroup<S> {
    type Mask = [mask64x8<S>; VECTORS];

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        let vector = f64x8::splat(S::proof(), value);
        Self([vector, vector])
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self([self.0[0].mul_add_precise(factor.0[0], addend.0[0]), self.0[1].mul_add_precise(factor.0[1], addend.0[1])])
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(
            #[inline(always)]
            |a| a.sqrt(),
        )
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        super::sin_cos(self)
    }
    #[inline(always)]
    fn powf(self, exponent: f64) -> Self {
        if exponent == 1.5 {
            self * self.sqrt()
        } else if exponent == 1.0 {
            self
        } else {
            // Lane by lane: no vector instruction raises to a power.
            let mut result = self;
            for lane in 0..Self::COUNT {
                result.set_lane(lane, Real::powf(self.lane(lane), exponent));
            }
            result
        }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::select(self.less_than(other), self, other)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::select(other.less_than(self), self, other)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.map(
            #[inline(always)]
            |a| a.abs(),
        )
    }
    #[inline(always)]
    fn less_than(self, other: Self) -> Self::Mask {
        [self.0[0].simd_lt(other.0[0]), self.0[1].simd_lt(other.0[1])]
    }
    #[inline(always)]
    fn select(mask: Self::Mask, chosen: Self, otherwise: Self) -> Self {
        Self([mask[0].select(chosen.0[0], otherwise.0[0]), mask[1].select(chosen.0[1], otherwise.0[1])])
    }
    #[inline(always)]
    fn vectorize<R>(kernel: impl FnOnce() -> R) -> R {
        S::proof().vectorize(kernel)
    }
}

impl<S: InstructionSet> Lanes for LaneGroup<S> {
    const COUNT: usize = WIDTH * VECTORS;

    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        self.0[lane / WIDTH].as_slice()[lane % WIDTH]
    }
    #[inline(always)]
    fn set_lane(&mut self, lane: usize, value: f64) {
        self.0[lane / WIDTH].as_mut_slice()[lane % WIDTH] = value;
    }
    #[inline(always)]
    fn in_a_row(numbers: &mut [Self]) -> &mut [f64] {
        let length = numbers.len() * Self::COUNT;
        // SAFETY: a group is nothing but an array of vectors, whose layout is documented as that of an array of eight numbers;
        // there is no padding, a vector is aligned more strictly than a number, and every pattern of bits is a number.
        unsafe { core::slice::from_raw_parts_mut(numbers.as_mut_ptr().cast::<f64>(), length) }
    }
    #[inline(always)]
    fn flags(mask: Self::Mask) -> u32 {
        mask[0].to_bitmask() as u32 | (mask[1].to_bitmask() as u32) << WIDTH
    }
    #[inline(always)]
    fn mask(flags: u32) -> Self::Mask {
        let low = mask64x8::from_bitmask(S::proof(), u64::from(flags) & 0xff);
        [low, mask64x8::from_bitmask(S::proof(), u64::from(flags >> WIDTH) & 0xff)]
    }
}
