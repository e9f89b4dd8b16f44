//! Numbers of 8 · `G` runs side by side: `G` vectors of AVX-512.
//!
//! Everything here may be called only where the processor has AVX-512; [`crate::batch::run_batch`] asks once.

#![allow(unsafe_code, reason = "vectors and arrays of the same eight numbers are read as each other")]

use std::arch::x86_64::*;

/// Runs in a vector.
pub const WIDTH: usize = 8;

/// A number of each run.
#[derive(Clone, Copy)]
pub struct Lanes<const G: usize>([__m512d; G]);

/// Yes or no for each run: bit `l` of group `g` is run 8 g + l.
#[derive(Clone, Copy)]
pub struct Mask<const G: usize>([__mmask8; G]);

/// Defines operations that are one instruction for each group.
macro_rules! operations {
    ($($(#[$doc:meta])* fn $name:ident($self:ident $(, $other:ident)*) = $one:expr;)*) => {$(
        $(#[$doc])*
        #[target_feature(enable = "avx512f")]
        #[inline]
        pub fn $name($self $(, $other: Self)*) -> Self {
            let mut result = $self;
            for g in 0..G {
                result.0[g] = $one($self.0[g] $(, $other.0[g])*);
            }
            result
        }
    )*};
}

/// -a b.
#[target_feature(enable = "avx512f")]
#[inline]
fn negated_product(a: __m512d, b: __m512d) -> __m512d {
    _mm512_fnmadd_pd(a, b, _mm512_setzero_pd())
}

/// c - a b.
#[target_feature(enable = "avx512f")]
#[inline]
fn less_product(c: __m512d, a: __m512d, b: __m512d) -> __m512d {
    _mm512_fnmadd_pd(a, b, c)
}

impl<const G: usize> Lanes<G> {
    /// The same number in all lanes.
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub fn all(number: f64) -> Self {
        Self([_mm512_set1_pd(number); G])
    }

    operations! {
        /// self + other.
        fn plus(self, other) = _mm512_add_pd;
        /// self - other.
        fn minus(self, other) = _mm512_sub_pd;
        /// self · other.
        fn times(self, other) = _mm512_mul_pd;
        /// self · factor + term, rounded once.
        fn times_plus(self, factor, term) = _mm512_fmadd_pd;
        /// term - self · factor, rounded once.
        fn times_from(self, factor, term) = _mm512_fnmadd_pd;
        /// self - first · second, rounded once.
        fn minus_product(self, first, second) = less_product;
        /// -self · other.
        fn negated_times(self, other) = negated_product;
        /// The smaller one; `other` where one is not a number.
        fn min(self, other) = _mm512_min_pd;
        /// The larger one; `other` where one is not a number.
        fn max(self, other) = _mm512_max_pd;
        /// |self|.
        fn abs(self) = _mm512_abs_pd;
        /// The largest whole number that is not above.
        fn floor(self) = _mm512_roundscale_pd::<0x09>;
        /// 1/√self to 14 bits.
        fn about_one_over_root(self) = _mm512_rsqrt14_pd;
        /// 1/self to 14 bits.
        fn about_one_over(self) = _mm512_rcp14_pd;
    }

    /// 1/self, of a number that is not zero, to the last bit or two: a division costs as much as 28 multiply-adds.
    ///
    /// The estimate y of 14 bits has the error e = 1 - self·y, and 1/self = y/(1 - e) = y (1 + e)(1 + e²) + O(e⁴).
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub fn one_over(self) -> Self {
        let estimate = self.about_one_over();
        let error = self.times_from(estimate, Self::all(1.0));
        let better = estimate.times_plus(error, estimate);
        better.times_plus(error.times(error), better)
    }

    /// Where self < other; false where one is not a number.
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub fn is_below(self, other: Self) -> Mask<G> {
        let mut mask = Mask([0; G]);
        for g in 0..G {
            mask.0[g] = _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0[g], other.0[g]);
        }
        mask
    }

    /// `other` where the mask says so, else self.
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub fn replaced(self, mask: Mask<G>, other: Self) -> Self {
        let mut result = self;
        for g in 0..G {
            result.0[g] = _mm512_mask_mov_pd(self.0[g], mask.0[g], other.0[g]);
        }
        result
    }

    /// The number of a run.
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub fn get(&self, lane: usize) -> f64 {
        _mm512_cvtsd_f64(_mm512_maskz_compress_pd(1 << (lane % WIDTH), self.0[lane / WIDTH]))
    }

    /// Sets the number of a run.
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub fn set(&mut self, lane: usize, number: f64) {
        let group = &mut self.0[lane / WIDTH];
        *group = _mm512_mask_mov_pd(*group, 1 << (lane % WIDTH), _mm512_set1_pd(number));
    }

    /// The number of a run in eight lanes.
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub fn spread(&self, lane: usize) -> Lanes<1> {
        Lanes([_mm512_permutexvar_pd(_mm512_set1_epi64((lane % WIDTH) as i64), self.0[lane / WIDTH])])
    }
}

impl Lanes<1> {
    /// Eight numbers.
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub fn from_array(numbers: [f64; WIDTH]) -> Self {
        // SAFETY: both are eight numbers of 64 bits, in the same order, and any bits are numbers.
        Self([unsafe { std::mem::transmute::<[f64; WIDTH], __m512d>(numbers) }])
    }

    /// Eight numbers.
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub fn to_array(self) -> [f64; WIDTH] {
        // SAFETY: as above.
        unsafe { std::mem::transmute::<__m512d, [f64; WIDTH]>(self.0[0]) }
    }
}

impl<const G: usize> Mask<G> {
    /// No run.
    pub const NONE: Self = Self([0; G]);

    /// As bits: run `l` is bit `l`.
    pub fn bits(self) -> u64 {
        self.0.iter().rev().fold(0, |bits, group| bits << WIDTH | u64::from(*group))
    }

    /// Those that are not in `other`.
    pub fn unless(self, other: Self) -> Self {
        let mut mask = self;
        for (group, other) in mask.0.iter_mut().zip(other.0) {
            *group &= !other;
        }
        mask
    }

    /// From bits.
    pub fn from_bits(bits: u64) -> Self {
        let mut mask = Self::NONE;
        for (g, group) in mask.0.iter_mut().enumerate() {
            *group = (bits >> (WIDTH * g)) as u8;
        }
        mask
    }
}
