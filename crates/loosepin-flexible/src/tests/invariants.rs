//! A second coding of mass matrix and bias forces: integrals over the shapes once, polynomials in the coordinates then.

use crate::{Beam, Shapes};

/// Constants of a beam, H taken times f; matrices row by row.
pub(super) struct Invariants {
    pub(super) counts: [usize; 2],
    mass_kg: f64,
    first_x: f64,
    second_x: f64,
    s_a: Vec<f64>,
    s_b: Vec<f64>,
    x_a: Vec<f64>,
    x_b: Vec<f64>,
    m_aa: Vec<f64>,
    m_bb: Vec<f64>,
    n: Vec<f64>,
    g: Vec<f64>,
    g_x: Vec<f64>,
    /// G^k for each axial shape.
    g_k: Vec<Vec<f64>>,
    /// P^i for each lateral shape.
    p_i: Vec<Vec<f64>>,
    /// Q_ijkl.
    q: Vec<f64>,
}

impl Invariants {
    pub(super) fn new(beam: &Beam<f64>, shapes: &Shapes) -> Self {
        let (na, nb, length) = (shapes.axial(), shapes.lateral(), beam.length_m);
        let f = if beam.foreshortening { length } else { 0.0 };
        let sum = |value: &dyn Fn(&crate::Station) -> f64| -> f64 {
            shapes.points.iter().map(|point| beam.mass_kg * point.weight * value(&point.station)).sum()
        };
        let phi = |s: &crate::Station, i: usize| length * s.lateral[i];
        let h = |s: &crate::Station, i: usize, j: usize| f * s.shortening[i * nb + j];
        let matrix = |rows: usize, columns: usize, value: &dyn Fn(&crate::Station, usize, usize) -> f64| -> Vec<f64> {
            (0..rows * columns).map(|k| sum(&|s| value(s, k / columns, k % columns))).collect()
        };
        Self {
            counts: [na, nb],
            mass_kg: beam.mass_kg,
            first_x: sum(&|s| length * s.share),
            second_x: sum(&|s| (length * s.share).powi(2)),
            s_a: (0..na).map(|k| sum(&|s| s.axial[k])).collect(),
            s_b: (0..nb).map(|i| sum(&|s| phi(s, i))).collect(),
            x_a: (0..na).map(|k| sum(&|s| length * s.share * s.axial[k])).collect(),
            x_b: (0..nb).map(|i| sum(&|s| length * s.share * phi(s, i))).collect(),
            m_aa: matrix(na, na, &|s, k, l| s.axial[k] * s.axial[l]),
            m_bb: matrix(nb, nb, &|s, i, j| phi(s, i) * phi(s, j)),
            n: matrix(na, nb, &|s, k, i| s.axial[k] * phi(s, i)),
            g: matrix(nb, nb, &|s, i, j| h(s, i, j)),
            g_x: matrix(nb, nb, &|s, i, j| length * s.share * h(s, i, j)),
            g_k: (0..na).map(|k| matrix(nb, nb, &|s, i, j| s.axial[k] * h(s, i, j))).collect(),
            p_i: (0..nb).map(|i| matrix(nb, nb, &|s, j, l| phi(s, i) * h(s, j, l))).collect(),
            q: matrix(nb * nb, nb * nb, &|s, ij, kl| h(s, ij / nb, ij % nb) * h(s, kl / nb, kl % nb)),
        }
    }

    /// M, row by row, and h.
    pub(super) fn inertia(&self, q: &[f64], rates: &[f64], spin: f64) -> (Vec<f64>, Vec<f64>) {
        let [na, nb] = self.counts;
        let (a, b) = q.split_at(na);
        let (ad, bd) = rates.split_at(na);
        let size = 3 + na + nb;
        let row = |matrix: &[f64], columns: usize, i: usize, y: &[f64]| dot(&matrix[i * columns..(i + 1) * columns], y);
        let form = |matrix: &[f64], x: &[f64], y: &[f64]| -> f64 {
            x.iter().enumerate().map(|(i, x)| x * row(matrix, y.len(), i, y)).sum()
        };
        let quartic = |i: usize, j: usize, k: usize, l: usize| self.q[(i * nb + j) * nb * nb + k * nb + l];
        let mut mass = vec![0.0; size * size];
        let mut set = |i: usize, j: usize, value: f64| {
            mass[i * size + j] = value;
            mass[j * size + i] = value;
        };
        let c1 = self.first_x + dot(&self.s_a, a) - 0.5 * form(&self.g, b, b);
        let c2 = dot(&self.s_b, b);
        set(0, 0, self.mass_kg);
        set(1, 1, self.mass_kg);
        set(2, 0, -c2);
        set(2, 1, c1);
        let fourth: f64 =
            all(nb, 4).map(|p| quartic(p[0], p[1], p[2], p[3]) * b[p[0]] * b[p[1]] * b[p[2]] * b[p[3]]).sum();
        let by_axial: f64 = (0..na).map(|k| a[k] * form(&self.g_k[k], b, b)).sum();
        set(
            2,
            2,
            self.second_x + 2.0 * dot(&self.x_a, a) - form(&self.g_x, b, b) + form(&self.m_aa, a, a) - by_axial
                + 0.25 * fourth
                + form(&self.m_bb, b, b),
        );
        for k in 0..na {
            set(3 + k, 0, self.s_a[k]);
            set(3 + k, 2, -row(&self.n, nb, k, b));
            (0..na).for_each(|l| set(3 + k, 3 + l, self.m_aa[k * na + l]));
            (0..nb).for_each(|i| set(3 + k, 3 + na + i, -row(&self.g_k[k], nb, i, b)));
        }
        let a_n = |i: usize, a: &[f64]| -> f64 { (0..na).map(|k| a[k] * self.n[k * nb + i]).sum() };
        let crossed = |i: usize, x: &[f64], y: &[f64]| -> f64 {
            all(nb, 2).map(|p| self.p_i[p[0]][p[1] * nb + i] * x[p[0]] * y[p[1]]).sum()
        };
        for i in 0..nb {
            set(3 + na + i, 0, -row(&self.g, nb, i, b));
            set(3 + na + i, 1, self.s_b[i]);
            set(3 + na + i, 2, self.x_b[i] + a_n(i, a) - 0.5 * form(&self.p_i[i], b, b) + crossed(i, b, b));
            for j in 0..nb {
                let second: f64 = all(nb, 2).map(|p| quartic(i, p[0], j, p[1]) * b[p[0]] * b[p[1]]).sum();
                set(3 + na + i, 3 + na + j, self.m_bb[i * nb + j] + second);
            }
        }

        let mut bias = vec![0.0; size];
        bias[0] = -spin * spin * c1 - 2.0 * spin * dot(&self.s_b, bd) - form(&self.g, bd, bd);
        bias[1] = -spin * spin * c2 + 2.0 * spin * (dot(&self.s_a, ad) - form(&self.g, b, bd));
        // Gradient of M_ωω by a and b.
        let by_a = |k: usize| 2.0 * self.x_a[k] + 2.0 * row(&self.m_aa, na, k, a) - form(&self.g_k[k], b, b);
        let by_b = |i: usize| {
            let third: f64 = all(nb, 3).map(|p| quartic(i, p[0], p[1], p[2]) * b[p[0]] * b[p[1]] * b[p[2]]).sum();
            let axial: f64 = (0..na).map(|k| 2.0 * a[k] * row(&self.g_k[k], nb, i, b)).sum();
            -2.0 * row(&self.g_x, nb, i, b) - axial + third + 2.0 * row(&self.m_bb, nb, i, b)
        };
        let change: f64 = (0..na).map(|k| by_a(k) * ad[k]).sum::<f64>() + (0..nb).map(|i| by_b(i) * bd[i]).sum::<f64>();
        bias[2] = spin * change + (0..nb).map(|j| b[j] * form(&self.p_i[j], bd, bd)).sum::<f64>();
        // The lateral part of d x a0 in full: the shortening of the rates acts at the lateral displacement alone.
        for k in 0..na {
            bias[3 + k] =
                -0.5 * spin * spin * by_a(k) - 2.0 * spin * row(&self.n, nb, k, bd) - form(&self.g_k[k], bd, bd);
        }
        for i in 0..nb {
            let coriolis = a_n(i, ad) + crossed(i, bd, b) - form(&self.p_i[i], b, bd);
            let quick: f64 = all(nb, 3).map(|p| quartic(i, p[0], p[1], p[2]) * b[p[0]] * bd[p[1]] * bd[p[2]]).sum();
            bias[3 + na + i] = -0.5 * spin * spin * by_b(i) + 2.0 * spin * coriolis + quick;
        }
        (mass, bias)
    }
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

/// All rows of `count` indices below `below`.
fn all(below: usize, count: u32) -> impl Iterator<Item = Vec<usize>> {
    (0..below.pow(count)).map(move |number| (0..count).map(|place| number / below.pow(place) % below).collect())
}
