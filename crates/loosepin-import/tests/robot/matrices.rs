//! Homogeneous matrices of four rows, which share nothing with the program.

pub type Matrix = [[f64; 4]; 4];

pub const IDENTITY: Matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

pub fn product(a: Matrix, b: Matrix) -> Matrix {
    let mut c = [[0.0; 4]; 4];
    for i in 0..4 {
        for j in 0..4 {
            c[i][j] = (0..4).map(|k| a[i][k] * b[k][j]).sum();
        }
    }
    c
}

pub fn chain(factors: &[Matrix]) -> Matrix {
    factors.iter().fold(IDENTITY, |all, factor| product(all, *factor))
}

pub fn moved(x: f64, y: f64, z: f64) -> Matrix {
    [[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, y], [0.0, 0.0, 1.0, z], [0.0, 0.0, 0.0, 1.0]]
}

pub fn about_x(angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    [[1.0, 0.0, 0.0, 0.0], [0.0, c, -s, 0.0], [0.0, s, c, 0.0], [0.0, 0.0, 0.0, 1.0]]
}

pub fn about_y(angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    [[c, 0.0, s, 0.0], [0.0, 1.0, 0.0, 0.0], [-s, 0.0, c, 0.0], [0.0, 0.0, 0.0, 1.0]]
}

pub fn about_z(angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    [[c, -s, 0.0, 0.0], [s, c, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
}

/// Rodrigues: 1 + sin θ K + (1 - cos θ) K², K the cross product with the unit axis.
pub fn about(axis: [f64; 3], angle: f64) -> Matrix {
    let length = axis.iter().map(|component| component * component).sum::<f64>().sqrt();
    let [x, y, z] = axis.map(|component| component / length);
    let k = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let mut turn = IDENTITY;
    for i in 0..3 {
        for j in 0..3 {
            let square: f64 = (0..3).map(|m| k[i][m] * k[m][j]).sum();
            turn[i][j] += angle.sin() * k[i][j] + (1.0 - angle.cos()) * square;
        }
    }
    turn
}

/// The largest difference of two matrices.
pub fn difference(a: Matrix, b: Matrix) -> f64 {
    (0..16).map(|k| (a[k / 4][k % 4] - b[k / 4][k % 4]).abs()).fold(0.0, f64::max)
}

/// R I Rᵀ.
pub fn turned(rotation: Matrix, inertia: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let mut turned = [[0.0; 3]; 3];
    for (i, row) in turned.iter_mut().enumerate() {
        for (j, element) in row.iter_mut().enumerate() {
            for k in 0..3 {
                for l in 0..3 {
                    *element += rotation[i][k] * inertia[k][l] * rotation[j][l];
                }
            }
        }
    }
    turned
}
