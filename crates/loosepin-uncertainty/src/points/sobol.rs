//! Scrambled Sobol' points with access by index.

use thiserror::Error;

use crate::points::counter::hash;
use crate::points::direction_numbers::DIRECTION_NUMBERS;

/// The largest number of dimensions of a [`ScrambledSobol`].
pub const MAXIMUM_DIMENSIONS: usize = DIRECTION_NUMBERS.len() + 1;

/// Bits of the digital net; an index must stay below 2^32.
const NET_BITS: u32 = 32;

/// Random bits appended below those of the net, so that a point has the resolution of an `f64`.
const FILL_BITS: u32 = 20;

/// Errors of Sobol' points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum SobolError {
    #[error(
        "{dimensions} dimensions; Sobol' points have at most {MAXIMUM_DIMENSIONS}\n\
         hint: fix the inputs that matter least"
    )]
    TooManyDimensions { dimensions: usize },
}

/// Sobol' points under Owen's nested uniform scrambling: every point is uniform in (0, 1)^d, and the first 2^m points of
/// each replicate form a digital net.
///
/// Binary digit k of coordinate j of point i is x_k ^ h(seed, replicate, j, x_1 ... x_(k-1)), x the digits of the
/// Sobol' point and h one random bit for each node of the binary tree (A. B. Owen, "Randomly permuted (t,m,s)-nets and
/// (t,s)-sequences", 1995), taken here from a hash of the node instead of a stored tree, so that a point depends on
/// (seed, replicate, index, dimension) alone. Points come in the natural order of the index, not in that of the Gray code.
#[derive(Debug, Clone)]
pub struct ScrambledSobol {
    seed: u64,
    directions: Vec<[u32; NET_BITS as usize]>,
}

impl ScrambledSobol {
    /// Points with this number of `dimensions`; `seed` belongs to the study.
    ///
    /// # Errors
    ///
    /// [`SobolError::TooManyDimensions`] beyond [`MAXIMUM_DIMENSIONS`].
    pub fn try_new(seed: u64, dimensions: usize) -> Result<Self, SobolError> {
        if dimensions > MAXIMUM_DIMENSIONS {
            return Err(SobolError::TooManyDimensions { dimensions });
        }
        Ok(Self { seed, directions: (0..dimensions).map(directions_of).collect() })
    }

    /// The number of dimensions.
    pub fn dimensions(&self) -> usize {
        self.directions.len()
    }

    /// Coordinate `dimension` (counted from 0) of point `index` in `replicate`, strictly between 0 and 1.
    pub fn point(&self, replicate: u32, index: u32, dimension: usize) -> f64 {
        let digits = self.digits(index, dimension);
        let key = hash(hash(self.seed, u64::from(replicate)), dimension as u64);
        let mut scrambled = 0_u32;
        for level in 0..NET_BITS {
            // The node of the tree is the digits above this one, with a leading 1 so that 01 and 001 differ.
            let node = (1_u64 << level) | (u64::from(digits) >> (NET_BITS - level));
            let flip = (hash(key, node) >> 63) as u32;
            let digit = (digits >> (NET_BITS - 1 - level)) & 1;
            scrambled = (scrambled << 1) | (digit ^ flip);
        }
        let leaf = (1_u64 << NET_BITS) | u64::from(digits);
        let bits = (u64::from(scrambled) << FILL_BITS) | (hash(key, leaf) >> (64 - FILL_BITS));
        (bits as f64 + 0.5) / (1_u64 << (NET_BITS + FILL_BITS)) as f64
    }

    /// Writes all coordinates of point `index` in `replicate` to `coordinates` (as many as it has room for).
    pub fn write_point(&self, replicate: u32, index: u32, coordinates: &mut [f64]) {
        for (dimension, coordinate) in coordinates.iter_mut().enumerate().take(self.dimensions()) {
            *coordinate = self.point(replicate, index, dimension);
        }
    }

    fn digits(&self, index: u32, dimension: usize) -> u32 {
        let directions = &self.directions[dimension];
        let mut rest = index;
        let mut digits = 0;
        while rest != 0 {
            digits ^= directions[rest.trailing_zeros() as usize];
            rest &= rest - 1;
        }
        digits
    }
}

/// Direction numbers v_k = m_k 2^(32-k) of one dimension, m_k by the recurrence of Bratley and Fox (1988).
fn directions_of(dimension: usize) -> [u32; NET_BITS as usize] {
    let mut directions = [0_u32; NET_BITS as usize];
    let Some(row) = dimension.checked_sub(1).map(|row| &DIRECTION_NUMBERS[row]) else {
        for (k, direction) in directions.iter_mut().enumerate() {
            *direction = 1 << (NET_BITS as usize - 1 - k);
        }
        return directions;
    };
    let degree = row.degree as usize;
    for k in 0..NET_BITS as usize {
        directions[k] = if k < degree {
            row.initial[k] << (NET_BITS as usize - 1 - k)
        } else {
            let mut direction = directions[k - degree] ^ (directions[k - degree] >> degree);
            for term in 1..degree {
                if (row.coefficients >> (degree - 1 - term)) & 1 == 1 {
                    direction ^= directions[k - term];
                }
            }
            direction
        };
    }
    directions
}

#[cfg(test)]
mod tests;
