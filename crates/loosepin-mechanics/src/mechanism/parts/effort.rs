//! How much arithmetic the equations of motion of a mechanism are.

use crate::mechanism::compile::Mechanism;
use crate::mechanism::tree::beam::TreeBeam;
use crate::mechanism::tree::nodal_beam::TreeNodalBeam;

impl Mechanism {
    /// Multiplications of one evaluation of the equations of motion, about: the mass matrix from the partial velocities of all
    /// bodies, its factors, and the Gram matrix of the loops.
    pub fn multiplications(&self) -> f64 {
        let tree = &self.real;
        let (n, rows) = (tree.free as f64, tree.constraint_rows() as f64);
        let partials = tree.links.iter().map(|link| link.dependences.len() as f64);
        let assembled: f64 = partials.map(|partials| 2.0 * partials * (1.0 + partials)).sum();
        // Of each point of a beam its partial velocities, and their products.
        let of_beam = |beam: &TreeBeam| {
            let (shapes, lateral) = (beam.shapes.count() as f64, beam.shapes.lateral() as f64);
            beam.shapes.points.len() as f64 * ((3.0 + shapes).powi(2) + 2.0 * shapes + 4.0 * lateral * lateral)
        };
        let beams: f64 = tree.beams.iter().map(of_beam).sum();
        let gram = rows * n * (n + rows) + rows * rows * rows / 6.0;
        // Of each point of an element r', r'', their lengths and the forces on the nodes; the mass matrix is constant.
        let of_nodal = |beam: &TreeNodalBeam| beam.mesh.elements() as f64 * 300.0;
        let nodal: f64 = tree.nodal_beams.iter().map(of_nodal).sum();
        assembled + beams + nodal + tree.mass_envelope().multiplications() + n * n + gram
    }
}
