//! A planar mechanism that lies in space has the bits of the plane: its poses, velocities, biases, forces, masses and loops.

use super::{Body, Loop, tree_of, unturned, vector};
use crate::accuracy::{build_case, case_names, spread};
use loosepin_math::{Plane, Rotation, Space, SpaceInertia, SpaceMount, Vec2, Vec3};
use loosepin_mechanics::dynamics::BodyEquations;
use loosepin_mechanics::mechanism::{
    CutNumbers, KindOfAttachment, Kinematics, LinkNumbers, PlaneAttachment, RowGeometry, SpaceAttachment, Tree,
    TreeGeometry, TreeNumbers, cut_biases, cut_jacobian, cut_residuals,
};
use loosepin_mechanics::model::{PlaneRow, Row, SpaceRow};

fn in_space(v: Vec2<f64>) -> Vec3 {
    vector([v.x, v.y, 0.0])
}

/// A turn about z with this cosine and sine.
fn about_z(direction: Vec2<f64>) -> Rotation {
    let Vec2 { x: cosine, y: sine } = direction;
    Rotation { x: vector([cosine, sine, 0.0]), y: vector([-sine, cosine, 0.0]), z: vector([0.0, 0.0, 1.0]) }
}

/// The same attachment in space with its markers. `None` of one that is of the plane alone, and of one whose angle is counted from a parent
/// that turns: the plane adds the angles, space composes the turns, so that bits differ.
fn attachment(tree: &Tree, slot: usize, numbers: &LinkNumbers<f64>) -> Option<(SpaceAttachment, SpaceMount<f64>)> {
    let link = &tree.links[slot - 1];
    Some(match link.attachment {
        PlaneAttachment::Revolute(kind) if kind.turns_alone || link.parent_slot == 0 => {
            (kind.into(), SpaceMount::new(unturned(), unturned()))
        }
        PlaneAttachment::Prismatic(kind) => {
            let line = in_space(numbers.mount.parent_direction);
            let across = vector([0.0, 0.0, 1.0]);
            let marker = Rotation { x: across, y: line.cross(across), z: line };
            (
                kind.into(),
                SpaceMount { parent: marker, own: marker, turn_from_parent: about_z(numbers.mount.turn_from_parent) },
            )
        }
        PlaneAttachment::Rigid(kind) => {
            let turn_from_parent = about_z(numbers.mount.turn_from_parent);
            (kind.into(), SpaceMount { parent: unturned(), own: unturned(), turn_from_parent })
        }
        _ => return None,
    })
}

fn laid_in_space(tree: &Tree, numbers: &TreeNumbers<f64>) -> Option<(Tree<Space>, TreeNumbers<f64, Space>)> {
    let body = |(index, own): (usize, &LinkNumbers<f64>)| {
        let link = &tree.links[index];
        let (attachment, mount) = attachment(tree, index + 1, own)?;
        let numbers = LinkNumbers {
            parent_arm_m: in_space(own.parent_arm_m),
            own_arm_m: in_space(own.own_arm_m),
            mount,
            eccentricity_m: in_space(own.eccentricity_m),
            centre_of_mass_m: in_space(own.centre_of_mass_m),
            mass_kg: own.mass_kg,
            inertia_kg_m2: SpaceInertia { diagonal_kg_m2: [0.0, 0.0, own.inertia_kg_m2], beside_kg_m2: [0.0; 3] },
        };
        Some(Body { parent_slot: link.parent_slot, attachment, is_driven: link.is_driven, numbers })
    };
    let bodies: Vec<Body> = numbers.links.iter().enumerate().map(body).collect::<Option<_>>()?;
    let of_points = tree.cuts.iter().zip(&numbers.cuts).filter(|(cut, _)| cut.rows == [PlaneRow::Coincident]);
    let loops: Vec<Loop> = of_points
        .map(|(cut, own)| Loop {
            slots: cut.slots,
            rows: &[SpaceRow::Coincident],
            numbers: CutNumbers {
                arms_m: own.arms_m.map(in_space),
                markers: [unturned(); 2],
                eccentricity_m: in_space(own.eccentricity_m),
                radius_m: 0.0,
            },
        })
        .collect();
    Some(tree_of(&bodies, &loops, in_space(numbers.gravity_m_s2)))
}

/// Residuals, Jacobian and accelerations of the cut joints whose points coincide, x and y of each.
fn rows_of_points<G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<f64, G>,
    kinematics: &Kinematics<f64, G>,
) -> Vec<Vec<f64>> {
    let (count, columns) = (tree.cut_rows(), tree.speeds());
    let [mut residuals, mut biases] = [(); 2].map(|()| vec![0.0; count]);
    let mut jacobian = vec![0.0; count * columns];
    cut_residuals(tree, numbers, kinematics, &mut residuals);
    cut_jacobian(tree, numbers, kinematics, &mut jacobian);
    cut_biases(tree, numbers, kinematics, &mut biases);
    let mut rows = Vec::new();
    let mut first = 0;
    for cut in &tree.cuts {
        if let [row] = cut.rows
            && row.count() == G::POSITION
        {
            rows.extend((first..first + 2).map(|row| {
                let slopes = &jacobian[row * columns..(row + 1) * columns];
                [&[residuals[row], biases[row]], slopes].concat()
            }));
        }
        first += cut.count();
    }
    rows
}

/// An evaluation of a tree: its kinematics, and mass matrix and forces of its bodies.
fn evaluated<G: TreeGeometry<Attachment: KindOfAttachment<G>>>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<f64, G>,
    [coordinates, speeds, driven]: [&[f64]; 3],
) -> (Kinematics<f64, G>, BodyEquations<f64, G>) {
    let mut kinematics = Kinematics::new(tree);
    kinematics.set_positions(tree, numbers, coordinates);
    kinematics.set_velocities(tree, speeds);
    kinematics.set_biases(tree, numbers, speeds, driven);
    let mut equations = BodyEquations::new(tree, Vec::new());
    equations.begin(tree, numbers, &kinematics);
    (kinematics, equations)
}

#[test]
fn identity_a_planar_mechanism_in_space_has_the_bits_of_the_plane() {
    let (mut compared, mut loops) = (0, 0);
    for case in case_names() {
        let built = build_case(&case);
        for tree in [&built.mechanism.ideal, &built.mechanism.real] {
            let numbers = TreeNumbers::<f64, Plane>::new(&built.mechanism.model, tree, &built.values);
            let Some((laid, numbers_in_space)) = laid_in_space(tree, &numbers) else { continue };
            assert_eq!([laid.free, laid.free_speeds], [tree.free, tree.free_speeds], "{case}");
            let count = tree.coordinates();
            for salt in [0.013, 0.029, 0.071] {
                let coordinates: Vec<f64> = (0..count).map(|k| 1.7 * spread(k, salt)).collect();
                let speeds: Vec<f64> = (0..count).map(|k| 9.0 * spread(k, 0.5 + salt)).collect();
                let driven: Vec<f64> = (0..tree.drives.len()).map(|k| 40.0 * spread(k, 0.3 + salt)).collect();
                let motion: [&[f64]; 3] = [&coordinates, &speeds, &driven];
                let (plane, of_plane) = evaluated(tree, &numbers, motion);
                let (space, of_space) = evaluated(&laid, &numbers_in_space, motion);
                for slot in 1..=tree.links.len() {
                    let (flat, deep) = (&plane.poses[slot], &space.poses[slot]);
                    assert_eq!(deep.position_m, in_space(flat.position_m), "{case}");
                    assert_eq!(deep.rotation, about_z(Vec2::new(flat.rotation.cosine, flat.rotation.sine)), "{case}");
                    for (flat, deep) in
                        [(&plane.twists[slot], &space.twists[slot]), (&plane.biases[slot], &space.biases[slot])]
                    {
                        assert_eq!(deep.linear, vector([flat.linear.x, flat.linear.y, 0.0]), "{case}");
                        assert_eq!(deep.angular, vector([0.0, 0.0, flat.angular]), "{case}");
                    }
                }
                let rows = rows_of_points(tree, &numbers, &plane);
                assert_eq!(rows, rows_of_points(&laid, &numbers_in_space, &space), "{case}");
                loops += rows.len() / 2;
                assert_eq!(of_plane.forces, of_space.forces, "{case}");
                assert_eq!(of_plane.mass, of_space.mass, "{case}");
                assert_eq!(of_plane.driven_mass, of_space.driven_mass, "{case}");
            }
            compared += 1;
        }
    }
    assert!(compared >= 30 && loops >= 30, "only {compared} trees and {loops} loops were compared");
}
