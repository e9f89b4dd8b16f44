//! The fused multiply-add of one number, by the processor's own instruction where it has one.
//!
//! x86-64 has the instruction since 2013, and a program that is to start on every such processor may not count on it.
//! `f64::mul_add` is then a call of a library, six times as slow. Here the processor is asked once, and each multiply-add is a
//! test of one byte and the instruction. Loops over arrays are compiled twice instead. This is the only place where plain numbers
//! depend on the processor.

#![cfg_attr(
    target_arch = "x86_64",
    allow(unsafe_code, reason = "the instruction may be named only where the processor was found to have it")
)]

/// `first · second + addend` with one rounding.
#[cfg(not(all(target_arch = "x86_64", not(target_feature = "fma"))))]
#[inline(always)]
pub fn multiply_add(first: f64, second: f64, addend: f64) -> f64 {
    first.mul_add(second, addend)
}

#[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
pub use x86_64::multiply_add;

/// Runs `work` compiled for vectors with fused multiply-adds where this processor has them, so that its loops over arrays, with
/// `f64::mul_add`, become vector instructions. `work` and all that it calls must be `#[inline(always)]`.
#[inline(always)]
pub fn with_vector_instructions<R>(work: impl FnOnce() -> R) -> R {
    #[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
    if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma") {
        // SAFETY: the processor has both, and the operating system keeps their registers.
        return unsafe { x86_64::with_avx2(work) };
    }
    work()
}

#[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
mod x86_64 {
    use std::sync::atomic::{AtomicBool, Ordering};

    /// Whether this processor was found to have the instruction; false as well before it was asked.
    static HAS_INSTRUCTION: AtomicBool = AtomicBool::new(false);

    /// `first · second + addend` with one rounding.
    #[inline(always)]
    pub fn multiply_add(first: f64, second: f64, addend: f64) -> f64 {
        if !HAS_INSTRUCTION.load(Ordering::Relaxed) {
            return ask_and_multiply_add(first, second, addend);
        }
        let mut result = first;
        // SAFETY: the flag is set by `ask_and_multiply_add` alone, where the processor has FMA and the operating system keeps
        // its registers. The instruction touches nothing but its three registers.
        unsafe {
            std::arch::asm!(
                "vfmadd213sd {result}, {second}, {addend}",
                result = inout(xmm_reg) result,
                second = in(xmm_reg) second,
                addend = in(xmm_reg) addend,
                options(pure, nomem, nostack, preserves_flags),
            );
        }
        result
    }

    /// `work`, which is inlined here, with instructions of AVX2 and FMA.
    #[target_feature(enable = "avx2,fma")]
    pub fn with_avx2<R>(work: impl FnOnce() -> R) -> R {
        work()
    }

    /// For the first multiply-add of a program, and for all on a processor without the instruction.
    #[cold]
    #[inline(never)]
    fn ask_and_multiply_add(first: f64, second: f64, addend: f64) -> f64 {
        if std::arch::is_x86_feature_detected!("fma") {
            HAS_INSTRUCTION.store(true, Ordering::Relaxed);
        }
        first.mul_add(second, addend)
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        /// Numbers whose products and sums round, vanish, overflow and underflow.
        const NUMBERS: [f64; 12] = [
            0.1,
            -3.7,
            1.0 + f64::EPSILON,
            1.0 - f64::EPSILON,
            -1.0,
            0.0,
            -0.0,
            1e300,
            -1e-300,
            5e-324,
            f64::INFINITY,
            f64::NAN,
        ];

        #[test]
        fn identity_the_instruction_and_the_library_give_the_same_bits() {
            for first in NUMBERS {
                for second in NUMBERS {
                    for addend in NUMBERS {
                        let expected = first.mul_add(second, addend);
                        let asked = ask_and_multiply_add(first, second, addend);
                        let found = multiply_add(first, second, addend);
                        for result in [asked, found] {
                            let is_same = result.to_bits() == expected.to_bits();
                            assert!(is_same || result.is_nan() && expected.is_nan(), "{first} {second} {addend}");
                        }
                    }
                }
            }
        }

        #[test]
        fn analytic_the_product_is_not_rounded() {
            // (1 + ε)(1 - ε) - 1 = -ε².
            let epsilon = f64::EPSILON;
            assert_eq!(multiply_add(1.0 + epsilon, 1.0 - epsilon, -1.0), -epsilon * epsilon);
        }
    }
}
