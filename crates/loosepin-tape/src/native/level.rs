//! Sets of vector instructions.

/// A set of vector instructions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// AVX2 and FMA: four lanes to a register, 16 registers.
    Avx2,
    /// AVX-512 F and DQ: eight lanes to a register, 32 registers and seven for masks.
    Avx512,
}

impl std::fmt::Display for Level {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Avx2 => "AVX2",
            Self::Avx512 => "AVX-512",
        })
    }
}

impl Level {
    /// All levels, the widest last.
    pub const ALL: [Self; 2] = [Self::Avx2, Self::Avx512];

    /// The widest level that this processor can run, if any.
    pub fn best() -> Option<Self> {
        Self::ALL.into_iter().rev().find(|level| level.is_supported())
    }

    /// This processor can run the level, and the operating system keeps its registers.
    pub fn is_supported(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        let is_supported = match self {
            Self::Avx2 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            Self::Avx512 => is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq"),
        };
        #[cfg(not(target_arch = "x86_64"))]
        let is_supported = false;
        is_supported
    }

    /// Lanes of one vector register; the lanes of a kernel are a multiple of it.
    pub fn vector_lanes(self) -> usize {
        match self {
            Self::Avx2 => 4,
            Self::Avx512 => 8,
        }
    }

    pub(super) fn vector_bytes(self) -> usize {
        self.vector_lanes() * size_of::<f64>()
    }

    pub(super) fn vector_registers(self) -> usize {
        match self {
            Self::Avx2 => 16,
            Self::Avx512 => 32,
        }
    }
}
