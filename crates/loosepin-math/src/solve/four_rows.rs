//! Matrices for products with vectors, in interleaved blocks of four rows.
//!
//! The scalar product of a short row waits for each of its additions, and longest for the sum of its eight partial sums. Here the same
//! entry of four rows lies in one vector: four products are formed at once, each by the additions of [`crate::solve::dense::dot`] in their order.
//!
//! Of several vectors the same entry lies side by side as well. Their products with a matrix take a third of the time of single ones,
//! and have the same bits.

use core::array::from_fn;

use crate::fused::with_vector_instructions;

/// The same entry of four rows.
type Four = [f64; 4];

/// Partial sums of a scalar product.
const PARTS: usize = 8;

/// A rectangular matrix.
#[derive(Debug, Clone)]
pub struct FourRows {
    rows: usize,
    columns: usize,
    /// Four rows behind four rows, of the last ones those that are missing are zero.
    entries: Vec<Four>,
}

/// A lower triangular matrix.
#[derive(Debug, Clone)]
pub(crate) struct FourTriangleRows {
    order: usize,
    /// Three rows, then four rows behind four rows, to the end of the longest of them: rows of 8k to 8k + 3 entries, and of 8k + 4 to
    /// 8k + 7, have as many entries in all partial sums.
    entries: Vec<Four>,
}

impl FourRows {
    /// The `matrix` (row by row) with `columns` columns.
    pub fn new(matrix: &[f64], columns: usize) -> Self {
        let rows = matrix.len().checked_div(columns).unwrap_or(0);
        let mut entries = Vec::with_capacity(rows.div_ceil(4) * columns);
        for first in (0..rows).step_by(4) {
            let entry = |row: usize, column: usize| if row < rows { matrix[row * columns + column] } else { 0.0 };
            entries.extend((0..columns).map(|column| from_fn(|row| entry(first + row, column))));
        }
        Self { rows, columns, entries }
    }

    /// A x
    pub fn multiply(&self, vector: &[f64]) -> Vec<f64> {
        let mut product = Vec::with_capacity(self.rows.next_multiple_of(4));
        with_vector_instructions(
            #[inline(always)]
            || {
                for entries in self.entries.chunks_exact(self.columns.max(1)) {
                    product.extend_from_slice(&scalar_products(entries, &vector[..self.columns]));
                }
            },
        );
        // Without columns all are zero.
        product.resize(self.rows, 0.0);
        product
    }

    /// The matrix from rows that are already interleaved by fours: of each four rows an entry for each of the `columns`, of the last ones
    /// those beyond `rows` are zero.
    pub fn from_interleaved_rows(rows: usize, columns: usize, entries: Vec<[f64; 4]>) -> Self {
        debug_assert_eq!(entries.len(), rows.div_ceil(4) * columns, "an entry for each column");
        Self { rows, columns, entries }
    }

    /// A x of N vectors.
    pub fn multiply_each<const N: usize>(&self, vectors: &[[f64; N]]) -> Vec<[f64; N]> {
        let mut products = Vec::with_capacity(self.rows.next_multiple_of(4));
        with_vector_instructions(
            #[inline(always)]
            || {
                let vectors = &vectors[..self.columns];
                for entries in self.entries.chunks_exact(self.columns.max(1)) {
                    products.extend_from_slice(&products_of_rows(entries, vectors));
                }
            },
        );
        // Without columns all are zero.
        products.resize(self.rows, [0.0; N]);
        products
    }

    /// Takes A x of N vectors out of `from`, column by column.
    pub fn subtract_products<const N: usize>(&self, from: &mut [[f64; N]], vectors: &[[f64; N]]) {
        debug_assert!(self.columns == 0 || from.len() == self.rows, "one entry for each row");
        with_vector_instructions(
            #[inline(always)]
            || {
                let vectors = &vectors[..self.columns];
                for (entries, own) in self.entries.chunks_exact(self.columns.max(1)).zip(from.chunks_mut(4)) {
                    for (row, rest) in own.iter_mut().enumerate() {
                        for (four, values) in entries.iter().zip(vectors) {
                            for vector in 0..N {
                                rest[vector] -= values[vector] * four[row];
                            }
                        }
                    }
                }
            },
        );
    }

    /// Takes A x out of `from`, column by column.
    pub fn subtract_product(&self, from: &mut [f64], vector: &[f64]) {
        debug_assert!(self.columns == 0 || from.len() == self.rows, "one entry for each row");
        with_vector_instructions(
            #[inline(always)]
            || {
                for (entries, own) in self.entries.chunks_exact(self.columns.max(1)).zip(from.chunks_mut(4)) {
                    let mut rest = [0.0; 4];
                    rest[..own.len()].copy_from_slice(own);
                    for (four, value) in entries.iter().zip(&vector[..self.columns]) {
                        for row in 0..4 {
                            rest[row] -= value * four[row];
                        }
                    }
                    own.copy_from_slice(&rest[..own.len()]);
                }
            },
        );
    }
}

impl FourTriangleRows {
    /// The triangle of a square `matrix` (row by row), whose other entries are zero.
    pub fn new(matrix: &[f64], order: usize) -> Self {
        let mut entries = Vec::with_capacity(order * (order + 4) / 8);
        for last in (2..order + 3).step_by(4) {
            // The row before the first one has no entries.
            let entry = |row: usize, column: usize| if row < order { matrix[row * order + column] } else { 0.0 };
            let of = |column: usize| from_fn(|row| (last + row).checked_sub(3).map_or(0.0, |row| entry(row, column)));
            entries.extend((0..order.min(last + 1)).map(of));
        }
        Self { order, entries }
    }

    /// T x
    pub fn multiply(&self, vector: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; self.order];
        with_vector_instructions(
            #[inline(always)]
            || {
                let mut entries = &self.entries[..];
                for last in (2..self.order + 3).step_by(4) {
                    let (own, behind) = entries.split_at(self.order.min(last + 1));
                    entries = behind;
                    let found = scalar_products(own, &vector[..own.len()]);
                    let first = (last + 1).saturating_sub(4);
                    let rows = &mut product[first..self.order.min(last + 1)];
                    rows.iter_mut().zip(&found[first + 3 - last..]).for_each(|(own, found)| *own = *found);
                }
            },
        );
        product
    }
}

impl FourTriangleRows {
    /// Number of rows.
    pub fn order(&self) -> usize {
        self.order
    }

    /// The entries of row `row` up to the diagonal.
    pub fn row(&self, row: usize) -> impl Iterator<Item = f64> {
        let (group, place) = ((row + 1) / 4, (row + 1) % 4);
        let begin: usize = (0..group).map(|group| self.length(group)).sum();
        self.entries[begin..=begin + row].iter().map(move |four| four[place])
    }

    /// Tᵀ x, row by row.
    pub fn multiply_transposed(&self, vector: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; self.order];
        with_vector_instructions(
            #[inline(always)]
            || {
                for (rows, own) in self.groups() {
                    // A row that is missing has no entries.
                    let factors: Four = from_fn(|row| rows[row].map_or(0.0, |row| vector[row]));
                    for (sum, four) in product.iter_mut().zip(own) {
                        let mut own = *sum;
                        for row in 0..4 {
                            own += factors[row] * four[row];
                        }
                        *sum = own;
                    }
                }
            },
        );
        product
    }

    /// T x of N vectors.
    pub fn multiply_each<const N: usize>(&self, vectors: &[[f64; N]]) -> Vec<[f64; N]> {
        // The first row of the first group and the last ones of the last are missing.
        let mut products = Vec::with_capacity((self.order + 4).next_multiple_of(4));
        with_vector_instructions(
            #[inline(always)]
            || {
                for (rows, own) in self.groups() {
                    let found = products_of_rows(own, &vectors[..own.len()]);
                    if rows[0].is_some() {
                        products.extend_from_slice(&found);
                    } else {
                        products.extend_from_slice(&found[1..]);
                    }
                }
            },
        );
        products.truncate(self.order);
        products
    }

    /// Tᵀ x of N vectors, row by row.
    pub fn multiply_transposed_each<const N: usize>(&self, vectors: &[[f64; N]]) -> Vec<[f64; N]> {
        let mut products = vec![[0.0; N]; self.order];
        with_vector_instructions(
            #[inline(always)]
            || {
                for (rows, own) in self.groups() {
                    // A row that is missing has no entries.
                    let factors: [[f64; N]; 4] = from_fn(|place| rows[place].map_or([0.0; N], |row| vectors[row]));
                    for (sum, four) in products.iter_mut().zip(own) {
                        for place in 0..4 {
                            for vector in 0..N {
                                sum[vector] += factors[place][vector] * four[place];
                            }
                        }
                    }
                }
            },
        );
        products
    }

    /// Sum of squares of each column.
    pub fn column_squares(&self) -> Vec<f64> {
        let mut squares = vec![0.0; self.order];
        for (_, own) in self.groups() {
            for (sum, four) in squares.iter_mut().zip(own) {
                *sum = four.iter().fold(*sum, |sum, entry| sum + entry * entry);
            }
        }
        squares
    }

    /// Four rows behind four rows: which they are, nothing in the place of one that is missing, and their entries.
    fn groups(&self) -> impl Iterator<Item = ([Option<usize>; 4], &[Four])> {
        let mut begin = 0;
        (0..(self.order + 4) / 4).map(move |group| {
            let own = &self.entries[begin..begin + self.length(group)];
            begin += own.len();
            let row = |place: usize| (4 * group + place).checked_sub(1).filter(|row| *row < self.order);
            (from_fn(row), own)
        })
    }

    /// Entries of each row of a group.
    fn length(&self, group: usize) -> usize {
        self.order.min(4 * group + 3)
    }
}

/// At most N `vectors` of the same length side by side; those that are missing are zero.
pub fn interleaved<const N: usize>(vectors: &[&[f64]]) -> Vec<[f64; N]> {
    let mut entries = vec![[0.0; N]; vectors.first().map_or(0, |vector| vector.len())];
    debug_assert!(vectors.len() <= N && vectors.iter().all(|vector| vector.len() == entries.len()), "of one length");
    for (place, vector) in vectors.iter().enumerate() {
        for (own, entry) in entries.iter_mut().zip(*vector) {
            own[place] = *entry;
        }
    }
    entries
}

/// The scalar product of each of N vectors with its own of N others.
pub fn pairwise_dots<const N: usize>(vectors: &[[f64; N]], others: &[[f64; N]]) -> [f64; N] {
    with_vector_instructions(
        #[inline(always)]
        || {
            let mut sums = [[0.0; N]; PARTS];
            let (blocks, last) = vectors.as_chunks::<PARTS>();
            let (other_blocks, other_last) = others.as_chunks::<PARTS>();
            let mut rest = [-0.0; N];
            for (values, others) in last.iter().zip(other_last) {
                for vector in 0..N {
                    rest[vector] += values[vector] * others[vector];
                }
            }
            for (values, others) in blocks.iter().zip(other_blocks) {
                for part in 0..PARTS {
                    for vector in 0..N {
                        sums[part][vector] += values[part][vector] * others[part][vector];
                    }
                }
            }
            together(&sums, &rest)
        },
    )
}

/// The scalar product of each of four rows with each of N vectors. Few partial sums at a time, so that all that is added to stays in
/// registers, and each entry of a vector is read once for four rows.
#[inline(always)]
fn products_of_rows<const N: usize>(rows: &[Four], vectors: &[[f64; N]]) -> [[f64; N]; 4] {
    let (row_blocks, last_rows) = rows.as_chunks::<PARTS>();
    let (blocks, last) = vectors.as_chunks::<PARTS>();
    // What an empty sum is.
    let mut rest = [[-0.0; N]; 4];
    for (four, values) in last_rows.iter().zip(last) {
        add_products(&mut rest, four, values);
    }
    let mut parts = [[[0.0; N]; PARTS]; 4];
    // A closure would be compiled without the vectors that this is inlined for.
    for pair in 0..PARTS / 2 {
        if N <= 4 {
            add_parts::<N, 2>(&mut parts, row_blocks, blocks, 2 * pair);
        } else {
            add_parts::<N, 1>(&mut parts, row_blocks, blocks, 2 * pair);
            add_parts::<N, 1>(&mut parts, row_blocks, blocks, 2 * pair + 1);
        }
    }
    for (parts, rest) in parts.iter().zip(&mut rest) {
        *rest = together(parts, rest);
    }
    rest
}

/// P partial sums from `first` on.
#[inline(always)]
fn add_parts<const N: usize, const P: usize>(
    parts: &mut [[[f64; N]; PARTS]; 4],
    row_blocks: &[[Four; PARTS]],
    blocks: &[[[f64; N]; PARTS]],
    first: usize,
) {
    let mut sums = [[[0.0; N]; 4]; P];
    for (rows, values) in row_blocks.iter().zip(blocks) {
        for part in 0..P {
            add_products(&mut sums[part], &rows[first + part], &values[first + part]);
        }
    }
    for part in 0..P {
        for row in 0..4 {
            parts[row][first + part] = sums[part][row];
        }
    }
}

/// Adds the products of an entry of four rows with that of N vectors.
#[inline(always)]
fn add_products<const N: usize>(sums: &mut [[f64; N]; 4], four: &Four, values: &[f64; N]) {
    for row in 0..4 {
        for vector in 0..N {
            sums[row][vector] += four[row] * values[vector];
        }
    }
}

/// The sums of all parts and of the rest.
#[inline(always)]
fn together<const N: usize>([a, b, c, d, e, f, g, h]: &[[f64; N]; PARTS], rest: &[f64; N]) -> [f64; N] {
    let mut sums = [0.0; N];
    for k in 0..N {
        let (first, last) = ((a[k] + b[k]) + (c[k] + d[k]), (e[k] + f[k]) + (g[k] + h[k]));
        sums[k] = first + last + rest[k];
    }
    sums
}

/// The scalar products of four rows with a vector.
#[inline(always)]
fn scalar_products(rows: &[Four], vector: &[f64]) -> Four {
    let mut sums = [[0.0; 4]; PARTS];
    let (row_blocks, blocks) = (rows.chunks_exact(PARTS), vector.chunks_exact(PARTS));
    // What an empty sum is.
    let mut rest = [-0.0; 4];
    for (four, value) in row_blocks.remainder().iter().zip(blocks.remainder()) {
        for row in 0..4 {
            rest[row] += four[row] * value;
        }
    }
    for (rows, values) in row_blocks.zip(blocks) {
        for part in 0..PARTS {
            for row in 0..4 {
                sums[part][row] += rows[part][row] * values[part];
            }
        }
    }
    together(&sums, &rest)
}

#[cfg(test)]
mod tests {
    use super::{FourRows, FourTriangleRows, interleaved, pairwise_dots};
    use crate::solve::dense::dot;

    /// Numbers of both signs that are no short binary fractions.
    fn number(i: usize) -> f64 {
        libm::sin(1.7 * i as f64 + 0.3) * libm::exp(0.1 * (i % 90) as f64)
    }

    fn bits(values: impl IntoIterator<Item = f64>) -> Vec<u64> {
        values.into_iter().map(f64::to_bits).collect()
    }

    #[test]
    fn identity_every_product_has_the_bits_of_its_own_scalar_product() {
        for columns in 1..27 {
            for rows in 0..10 {
                let matrix: Vec<f64> = (0..rows * columns).map(number).collect();
                let vector: Vec<f64> = (0..columns).map(|i| number(1000 + i)).collect();
                let expected = bits(matrix.chunks(columns).map(|row| dot(row, &vector)));
                assert_eq!(bits(FourRows::new(&matrix, columns).multiply(&vector)), expected, "{rows} x {columns}");
            }
        }
        assert_eq!(FourRows::new(&[], 0).multiply(&[]), [] as [f64; 0]);
    }

    #[test]
    fn identity_every_product_of_a_triangle_has_the_bits_of_its_own_scalar_product() {
        for order in 0..40 {
            let entry = |k: usize| if k % order <= k / order { number(k) } else { 0.0 };
            let matrix: Vec<f64> = (0..order * order).map(entry).collect();
            let vector: Vec<f64> = (0..order).map(|i| number(1000 + i)).collect();
            let rows = matrix.chunks(order.max(1)).enumerate();
            let expected = bits(rows.map(|(i, row)| dot(&row[..=i], &vector[..=i])));
            assert_eq!(bits(FourTriangleRows::new(&matrix, order).multiply(&vector)), expected, "{order}");
        }
    }

    #[test]
    fn identity_a_triangle_is_what_it_was_made_of() {
        for order in 0..40 {
            let entry = |k: usize| if k % order <= k / order { number(k) } else { 0.0 };
            let matrix: Vec<f64> = (0..order * order).map(entry).collect();
            let triangle = FourTriangleRows::new(&matrix, order);
            let vector: Vec<f64> = (0..order).map(|i| number(1000 + i)).collect();
            let (mut products, mut squares) = (vec![0.0; order], vec![0.0; order]);
            for (i, row) in matrix.chunks(order.max(1)).enumerate() {
                assert_eq!(bits(triangle.row(i)), bits(row[..=i].iter().copied()), "row {i} of {order}");
                for (j, entry) in row.iter().enumerate() {
                    products[j] += vector[i] * entry;
                    squares[j] += entry * entry;
                }
            }
            assert_eq!(bits(triangle.multiply_transposed(&vector)), bits(products), "{order}");
            assert_eq!(bits(triangle.column_squares()), bits(squares), "{order}");
        }
    }

    #[test]
    fn identity_what_is_taken_out_is_taken_out_column_by_column() {
        for rows in 0..10 {
            let columns = 6;
            let matrix: Vec<f64> = (0..rows * columns).map(number).collect();
            let vector: Vec<f64> = (0..columns).map(|i| number(1000 + i)).collect();
            let mut found: Vec<f64> = (0..rows).map(|i| number(2000 + i)).collect();
            let own = found.iter().zip(matrix.chunks(columns));
            let rest = own.map(|(value, row)| row.iter().zip(&vector).fold(*value, |rest, (a, x)| rest - x * a));
            let expected = bits(rest);
            FourRows::new(&matrix, columns).subtract_product(&mut found, &vector);
            assert_eq!(bits(found), expected, "{rows}");
        }
    }

    /// N vectors of `count` numbers, side by side.
    fn vectors<const N: usize>(count: usize) -> Vec<[f64; N]> {
        (0..count).map(|i| core::array::from_fn(|vector| number(1000 * (vector + 1) + i))).collect()
    }

    fn vector_of<const N: usize>(vectors: &[[f64; N]], vector: usize) -> Vec<f64> {
        vectors.iter().map(|own| own[vector]).collect()
    }

    /// Products with N vectors against those with each of them.
    fn hold_against_single_ones<const N: usize>() {
        for columns in [1, 2, 6, 7, 8, 9, 16, 23, 26] {
            for rows in 0..10 {
                let matrix: Vec<f64> = (0..rows * columns).map(number).collect();
                let (matrix, own) = (FourRows::new(&matrix, columns), vectors::<N>(columns));
                let (found, mut taken) = (matrix.multiply_each(&own), vectors::<N>(rows));
                matrix.subtract_products(&mut taken, &own);
                for vector in 0..N {
                    let own = vector_of(&own, vector);
                    assert_eq!(bits(vector_of(&found, vector)), bits(matrix.multiply(&own)), "{rows} x {columns}");
                    let mut expected = vector_of(&vectors::<N>(rows), vector);
                    matrix.subtract_product(&mut expected, &own);
                    assert_eq!(bits(vector_of(&taken, vector)), bits(expected), "{rows} x {columns}");
                }
            }
        }
        for order in 0..40 {
            let entry = |k: usize| if k % order <= k / order { number(k) } else { 0.0 };
            let matrix: Vec<f64> = (0..order * order).map(entry).collect();
            let (triangle, own) = (FourTriangleRows::new(&matrix, order), vectors::<N>(order));
            let (found, transposed) = (triangle.multiply_each(&own), triangle.multiply_transposed_each(&own));
            let squares = pairwise_dots(&own, &own);
            for vector in 0..N {
                let own = vector_of(&own, vector);
                assert_eq!(bits(vector_of(&found, vector)), bits(triangle.multiply(&own)), "{order}");
                assert_eq!(bits(vector_of(&transposed, vector)), bits(triangle.multiply_transposed(&own)), "{order}");
                assert_eq!(squares[vector].to_bits(), dot(&own, &own).to_bits(), "{order}");
            }
        }
    }

    #[test]
    fn identity_vectors_side_by_side_have_the_bits_of_each_by_itself() {
        hold_against_single_ones::<1>();
        hold_against_single_ones::<4>();
        hold_against_single_ones::<8>();
    }

    #[test]
    fn identity_vectors_beside_one_another_are_those_that_were_given() {
        let own = vectors::<8>(7);
        let [first, second] = [0, 1].map(|vector| vector_of(&own, vector));
        let found = interleaved::<8>(&[&first, &second]);
        assert_eq!([0, 1].map(|vector| vector_of(&found, vector)), [first, second]);
        assert!(found.iter().all(|own| own[2..] == [0.0; 6]) && interleaved::<8>(&[]).is_empty());
    }

    #[test]
    fn identity_a_matrix_of_fours_is_the_one_of_its_rows() {
        for rows in 0..10 {
            let columns = 5;
            let matrix: Vec<f64> = (0..rows * columns).map(number).collect();
            let vector: Vec<f64> = (0..columns).map(|i| number(1000 + i)).collect();
            let of_rows = FourRows::new(&matrix, columns);
            let from_interleaved_rows = FourRows::from_interleaved_rows(rows, columns, of_rows.entries.clone());
            assert_eq!(bits(from_interleaved_rows.multiply(&vector)), bits(of_rows.multiply(&vector)), "{rows}");
        }
    }
}
