//! The linear algebra of Gaussian processes with a trend F, whatever their correlation and however its parameters are chosen.
//!
//! Everything is whitened with W = L⁻¹, V = L Lᵀ the covariance of the values: B = W F. V itself is never inverted: its condition number is
//! up to 1e13, that of L the square root of it.

use loosepin_math::{FourRows, interleaved};
use std::sync::Arc;

use loosepin_math::dense::{Cholesky, LowerTriangle};

/// Matérn's correlation with ν = 5/2 (two derivatives) by s = √5 r: (1 + s + s²/3) exp(-s), and its factor exp(-s).
pub fn matern_five_halves(s: f64) -> (f64, f64) {
    let decay = libm::exp(-s);
    (matern_five_halves_of(s, decay), decay)
}

/// The same where the factor exp(-s) is known.
#[inline(always)]
pub fn matern_five_halves_of(s: f64, decay: f64) -> f64 {
    (1.0 + s + s * s / 3.0) * decay
}

/// V factorised as L Lᵀ, and W = L⁻¹.
#[derive(Debug, Clone)]
pub struct Factor {
    /// L, for as long as values may be appended.
    open: Option<Cholesky>,
    whitening: LowerTriangle,
    ln_determinant: f64,
}

impl Factor {
    /// Factorises V (row by row, its lower triangle); `None` if it is singular to round-off.
    pub fn try_new(covariance: Vec<f64>, order: usize) -> Option<Self> {
        let cholesky = Cholesky::new(covariance, order)?;
        Some(Self::of(cholesky.inverse_factor(), cholesky))
    }

    fn of(whitening: LowerTriangle, cholesky: Cholesky) -> Self {
        Self { ln_determinant: cholesky.ln_determinant(), whitening, open: Some(cholesky) }
    }

    /// Without L, which takes twice the memory of W: nothing can be appended.
    #[must_use]
    pub fn closed(self) -> Self {
        Self { open: None, ..self }
    }

    /// How many of its values need no covariances where others are appended: all, or none where nothing can be appended.
    pub fn known(&self) -> usize {
        self.open.as_ref().map_or(0, Cholesky::order)
    }

    /// Factorises V, to whose first values, those of this one, others have been appended: the same bits as [`Self::try_new`] in less time. Of the [`Self::known`] values
    /// no covariances with each other are looked at.
    pub fn appended(&self, covariance: Vec<f64>, order: usize) -> Option<Self> {
        let Some(open) = &self.open else { return Self::try_new(covariance, order) };
        let cholesky = open.appended(covariance, order)?;
        Some(Self::of(cholesky.inverse_factor_after(Some(&self.whitening)), cholesky))
    }
}

/// Columns of a trend that are computed side by side: as many as there are numbers in two vectors.
const COLUMNS_AT_ONCE: usize = 8;

/// What `product` makes of each of `columns`, [`COLUMNS_AT_ONCE`] side by side.
fn of_each<'c>(
    columns: impl IntoIterator<Item = &'c Vec<f64>>,
    product: impl Fn(&[[f64; COLUMNS_AT_ONCE]]) -> Vec<[f64; COLUMNS_AT_ONCE]>,
) -> Vec<Vec<f64>> {
    let columns: Vec<&[f64]> = columns.into_iter().map(Vec::as_slice).collect();
    let mut products = Vec::with_capacity(columns.len());
    for own in columns.chunks(COLUMNS_AT_ONCE) {
        let found = product(&interleaved(own));
        products.extend((0..own.len()).map(|column| found.iter().map(|entry| entry[column]).collect()));
    }
    products
}

/// V factorised, with the trend whitened.
#[derive(Debug, Clone)]
pub struct Whitened {
    factor: Arc<Factor>,
    /// B, column by column.
    pub trend: Vec<Vec<f64>>,
    /// B and Bᵀ for products with vectors.
    by_point: FourRows,
    by_column: FourRows,
    /// ln det V
    pub ln_determinant: f64,
}

impl Whitened {
    /// Factorises V (row by row, its lower triangle) for the columns of F; `None` if V is singular to round-off.
    pub fn try_new<'c>(
        covariance: Vec<f64>,
        trend: impl IntoIterator<Item = &'c Vec<f64>>,
        order: usize,
    ) -> Option<Self> {
        Some(Self::of_factor(Arc::new(Factor::try_new(covariance, order)?.closed()), order, trend))
    }

    /// [`Self::try_new`] from a factorised V.
    pub fn of_factor<'c>(factor: Arc<Factor>, order: usize, trend: impl IntoIterator<Item = &'c Vec<f64>>) -> Self {
        let trend = of_each(trend, |columns| factor.whitening.multiply_each::<COLUMNS_AT_ONCE>(columns));
        let by_point: Vec<f64> = (0..order).flat_map(|point| trend.iter().map(move |column| column[point])).collect();
        Self {
            by_point: FourRows::new(&by_point, trend.len()),
            by_column: FourRows::new(&trend.concat(), order),
            ln_determinant: factor.ln_determinant,
            factor,
            trend,
        }
    }

    /// W
    pub fn whitening(&self) -> &LowerTriangle {
        &self.factor.whitening
    }

    /// L and W.
    pub fn factor(&self) -> &Arc<Factor> {
        &self.factor
    }

    /// Bᵀ w of a whitened vector.
    pub fn products(&self, white: &[f64]) -> Vec<f64> {
        self.by_column.multiply(white)
    }

    /// Bᵀ w of N whitened vectors side by side.
    pub fn products_of_each<const N: usize>(&self, white: &[[f64; N]]) -> Vec<[f64; N]> {
        self.by_column.multiply_each(white)
    }

    /// Takes B b out of N whitened vectors side by side.
    pub fn subtract_trends<const N: usize>(&self, white: &mut [[f64; N]], coefficients: &[[f64; N]]) {
        self.by_point.subtract_products(white, coefficients);
    }

    /// Takes B b out of a whitened vector.
    pub fn subtract_trend(&self, white: &mut [f64], coefficients: &[f64]) {
        self.by_point.subtract_product(white, coefficients);
    }

    /// Columns of Wᵀ B.
    pub fn projected_trend(&self) -> Vec<Vec<f64>> {
        of_each(&self.trend, |columns| self.whitening().multiply_transposed_each::<COLUMNS_AT_ONCE>(columns))
    }

    /// c = W k and r = f - Bᵀc at a place with the covariances k and the terms f of the trend.
    pub fn at_place(&self, covariances: &[f64], terms: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let white = self.whitening().multiply(covariances);
        let rest = terms.iter().zip(self.products(&white)).map(|(term, known)| term - known).collect();
        (white, rest)
    }

    /// c = W k and r = f - Bᵀc at N places side by side with the covariances k and the terms f of the trend.
    pub fn at_places<const N: usize>(
        &self,
        covariances: &[[f64; N]],
        terms: &[[f64; N]],
    ) -> (Vec<[f64; N]>, Vec<[f64; N]>) {
        let white = self.whitening().multiply_each(covariances);
        let mut rest = self.products_of_each(&white);
        for (known, terms) in rest.iter_mut().zip(terms) {
            for (known, term) in known.iter_mut().zip(terms) {
                *known = term - *known;
            }
        }
        (white, rest)
    }
}
