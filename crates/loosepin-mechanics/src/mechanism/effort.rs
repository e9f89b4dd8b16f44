//! How much arithmetic the equations of motion of a mechanism are.

use super::compile::Mechanism;

impl Mechanism {
    /// Multiplications of one evaluation of the equations of motion, about: the mass matrix from the partial velocities of all
    /// bodies, its factors, and the Gram matrix of the loops.
    pub fn multiplications(&self) -> f64 {
        let tree = &self.real;
        let (n, rows) = (tree.free as f64, tree.constraint_rows() as f64);
        let partials = tree.links.iter().map(|link| link.dependences.len() as f64);
        let assembled: f64 = partials.map(|partials| 2.0 * partials * (1.0 + partials)).sum();
        let gram = rows * n * (n + rows) + rows * rows * rows / 6.0;
        assembled + tree.mass_envelope().multiplications() + n * n + gram
    }
}
