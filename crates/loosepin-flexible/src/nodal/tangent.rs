//! Tangent stiffness of an element: the second derivatives of its strain energy.

use super::beam::NodalBeam;
use super::element::{Bend, Ends, Stretch};
use super::mesh::{Mesh, Nodal, Point};
use loosepin_math::Vec2;

/// Coordinates of an element: x and y of r0, of r0', of r1, of r1'.
pub(super) const COORDINATES: usize = 8;

/// A symmetric matrix over the coordinates of an element, row by row.
pub type ElementMatrix = [[f64; COORDINATES]; COORDINATES];

/// Coefficients of (r0, r0', r1, r1') in a vector of the element.
type Coefficients = [f64; 4];

/// r' of the four vectors of the nodes.
fn slope_of_nodes(at: &Point, length_m: f64) -> Coefficients {
    [-at.chord / length_m, at.first, at.chord / length_m, at.last]
}

/// l r'' of the four vectors of the nodes.
fn bend_of_nodes(at: &Point, length_m: f64) -> Coefficients {
    [-at.bend_chord / length_m, at.bend_first, at.bend_chord / length_m, at.bend_last]
}

/// Adds left ⊗ right ⊗ block to `matrix`, for the second derivatives `block` by the vectors that have these coefficients.
fn add(matrix: &mut ElementMatrix, left: &Coefficients, right: &Coefficients, block: [[f64; 2]; 2]) {
    for (i, of_left) in left.iter().enumerate() {
        for (j, of_right) in right.iter().enumerate() {
            for row in 0..2 {
                for column in 0..2 {
                    matrix[2 * i + row][2 * j + column] += of_left * of_right * block[row][column];
                }
            }
        }
    }
}

fn product(left: Vec2<f64>, right: Vec2<f64>) -> [[f64; 2]; 2] {
    [[left.x * right.x, left.x * right.y], [left.y * right.x, left.y * right.y]]
}

/// Σ factor · block.
fn sum<const N: usize>(terms: [(f64, [[f64; 2]; 2]); N]) -> [[f64; 2]; 2] {
    let entry = |row: usize, column: usize| terms.iter().map(|(factor, block)| factor * block[row][column]).sum();
    [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
}

fn transposed([[a, b], [c, d]]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    [[a, c], [b, d]]
}

/// The unit matrix of the plane.
const UNIT: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 1.0]];
/// ∂²(a × b)/∂a∂b.
const CROSS: [[f64; 2]; 2] = [[0.0, 1.0], [-1.0, 0.0]];

impl NodalBeam<f64> {
    /// ∂²U/∂e∂e of an element, for its two nodes.
    ///
    /// ```text
    /// ∂²(½ε²)/∂r'∂r' = u uᵀ + ε/|r'| (1 - u uᵀ),   u = r'/|r'|
    /// ∂²(½κ²) = ∇κ ∇κᵀ + κ ∇²κ,   κ = c/g,  c = r' × r'',  g = r'·r'
    /// ∂²κ/∂r'∂r'  = -(c_a g_aᵀ + g_a c_aᵀ)/g² + c (2 g_a g_aᵀ/g³ - 2/g²),   c_a = -k × r'',  g_a = 2 r'
    /// ∂²κ/∂r'∂r'' = c_ab/g - g_a (k × r')ᵀ/g²
    /// ```
    pub fn tangent(&self, mesh: &Mesh, ends: &[Nodal<f64>; 2]) -> ElementMatrix {
        let section = self.section(mesh);
        let length_m = section.length_m;
        let [axial_n_m, bending_n_m] = section.stiffnesses_n_m();
        let ends = Ends::new(length_m, ends);
        let mut matrix = [[0.0; COORDINATES]; COORDINATES];
        for at in &mesh.axial {
            let stretch = Stretch::of(ends.slope(at));
            let across = stretch.strain() / stretch.length;
            let along = product(stretch.direction, stretch.direction);
            let factor = axial_n_m * at.weight;
            let block = sum([(factor * (1.0 - across), along), (factor * across, UNIT)]);
            let slope = slope_of_nodes(at, length_m);
            add(&mut matrix, &slope, &slope, block);
        }
        for at in &mesh.bending {
            let (slope, bend) = (ends.slope(at), ends.bend(at));
            let Bend { turn, by_slope, by_bend } = Bend::of(slope, bend);
            let g = slope.length_squared();
            let (c_a, g_a) = (-bend.turned(), slope * 2.0);
            let mixed = product(c_a, g_a);
            let by_slopes = sum([
                (-1.0 / (g * g), mixed),
                (-1.0 / (g * g), transposed(mixed)),
                (2.0 * turn / (g * g), product(g_a, g_a)),
                (-2.0 * turn / g, UNIT),
            ]);
            let by_both = sum([(1.0 / g, CROSS), (-1.0 / (g * g), product(g_a, slope.turned()))]);
            let factor = bending_n_m * at.weight;
            let (of_slope, of_bend) = (slope_of_nodes(at, length_m), bend_of_nodes(at, length_m));
            let both = sum([(factor, product(by_slope, by_bend)), (factor * turn, by_both)]);
            add(
                &mut matrix,
                &of_slope,
                &of_slope,
                sum([(factor, product(by_slope, by_slope)), (factor * turn, by_slopes)]),
            );
            add(&mut matrix, &of_slope, &of_bend, both);
            add(&mut matrix, &of_bend, &of_slope, transposed(both));
            add(&mut matrix, &of_bend, &of_bend, sum([(factor, product(by_bend, by_bend))]));
        }
        matrix
    }
}
