//! The kernel in space: known answers, exact derivatives, and the bits of planar mechanisms that lie in space.

mod derivatives;
mod known_answers;
mod plane_in_space;

use loosepin_math::{Real, Rotation, Space, SpaceInertia, SpaceMount, Vec3};
use loosepin_mechanics::dynamics::BodyEquations;
use loosepin_mechanics::mechanism::{
    Cut, CutNumbers, FormOfAttachment, KindOfAttachment, Kinematics, Link, LinkNumbers, SpaceAttachment, Tree,
    TreeNumbers, cut_biases, cut_jacobian,
};
use loosepin_mechanics::model::{BodyId, DriveId, JointId, SpaceRow};

/// A body of a tree in space: the slot of its parent, how it hangs there, whether a drive moves it, and its numbers.
struct Body {
    parent_slot: usize,
    attachment: SpaceAttachment,
    is_driven: bool,
    numbers: LinkNumbers<f64, Space>,
}

/// A joint that closes a loop: the slots of its bodies, its conditions and its numbers.
struct Loop {
    slots: [usize; 2],
    rows: &'static [SpaceRow],
    numbers: CutNumbers<f64, Space>,
}

/// The tree of these bodies, parents first: free coordinates and speeds, then driven ones. The loops close it.
fn tree_of(bodies: &[Body], loops: &[Loop], gravity_m_s2: Vec3) -> (Tree<Space>, TreeNumbers<f64, Space>) {
    let mut tree = Tree::<Space>::empty();
    let counts = |body: &Body| body.attachment.counts();
    let of_free = |k: usize| bodies.iter().filter(|body| !body.is_driven).map(|body| counts(body)[k]).sum();
    (tree.free, tree.free_speeds) = (of_free(0), of_free(1));
    let (mut next, mut next_driven) = ([0; 2], [tree.free, tree.free_speeds]);
    for (index, body) in bodies.iter().enumerate() {
        let at = if body.is_driven { &mut next_driven } else { &mut next };
        let [coordinates, speeds] = [0, 1].map(|k| at[k]..at[k] + counts(body)[k]);
        *at = [coordinates.end, speeds.end];
        let inherited = tree.dependences(body.parent_slot).to_vec();
        tree.links.push(Link {
            body: BodyId(index + 1),
            parent_slot: body.parent_slot,
            attachment: body.attachment,
            speeds: speeds.clone(),
            coordinates,
            is_driven: body.is_driven,
            dependences: inherited.iter().copied().chain(speeds).collect(),
            inherited: inherited.len(),
            beam: None,
            nodal_beam: None,
            has_own_mass: true,
        });
        if body.is_driven {
            tree.drives.push(DriveId(tree.drives.len()));
        }
    }
    for (index, own) in loops.iter().enumerate() {
        tree.cuts.push(Cut { joint: JointId(bodies.len() + index), slots: own.slots, rows: own.rows });
    }
    let numbers = TreeNumbers {
        links: bodies.iter().map(|body| body.numbers).collect(),
        cuts: loops.iter().map(|own| own.numbers).collect(),
        couplings: Vec::new(),
        beams: Vec::new(),
        nodal_beams: Vec::new(),
        gravity_m_s2,
    };
    (tree, numbers)
}

fn vector([x, y, z]: [f64; 3]) -> Vec3 {
    Vec3::new(x, y, z)
}

fn unturned() -> Rotation {
    Rotation { x: vector([1.0, 0.0, 0.0]), y: vector([0.0, 1.0, 0.0]), z: vector([0.0, 0.0, 1.0]) }
}

/// Axes of a marker by its x and z axes.
fn axes(x: [f64; 3], z: [f64; 3]) -> Rotation {
    let (x, z) = (vector(x), vector(z));
    Rotation { x, y: z.cross(x), z }
}

/// A link with these joint points, its marker on the parent, mass and principal moments of inertia.
fn link(
    [parent_arm_m, own_arm_m]: [[f64; 3]; 2],
    marker: Rotation,
    mass_kg: f64,
    moments_kg_m2: [f64; 3],
) -> LinkNumbers<f64, Space> {
    LinkNumbers {
        parent_arm_m: vector(parent_arm_m),
        own_arm_m: vector(own_arm_m),
        mount: SpaceMount::new(marker, unturned()),
        eccentricity_m: vector([0.0; 3]),
        centre_of_mass_m: vector([0.0; 3]),
        mass_kg,
        inertia_kg_m2: SpaceInertia { diagonal_kg_m2: moments_kg_m2, beside_kg_m2: [0.0; 3] },
    }
}

/// Position, velocity and acceleration of the driven coordinate at a time.
type Drive = fn(f64) -> [f64; 3];

/// A motion whose state is the free coordinates, then the free speeds.
struct Run<'a> {
    tree: &'a Tree<Space>,
    numbers: &'a TreeNumbers<f64, Space>,
    drive: Drive,
    kinematics: Kinematics<f64, Space>,
    equations: BodyEquations<f64, Space>,
}

impl<'a> Run<'a> {
    fn new(tree: &'a Tree<Space>, numbers: &'a TreeNumbers<f64, Space>, drive: Drive) -> Self {
        let equations = BodyEquations::new(tree, tree.constraint_scales());
        Self { tree, numbers, drive, kinematics: Kinematics::new(tree), equations }
    }

    fn slope(&mut self, time_s: f64, state: &[f64]) -> Vec<f64> {
        let [at, rate, acceleration] = (self.drive)(time_s);
        let driven = self.tree.drives.len();
        let (free, speeds) = state.split_at(self.tree.free);
        let coordinates: Vec<f64> = free.iter().copied().chain(core::iter::repeat_n(at, driven)).collect();
        let rates: Vec<f64> = speeds.iter().copied().chain(core::iter::repeat_n(rate, driven)).collect();
        let (tree, numbers) = (self.tree, self.numbers);
        self.kinematics.set_positions(tree, numbers, &coordinates);
        self.kinematics.set_velocities(tree, &rates);
        self.kinematics.set_biases(tree, numbers, &rates, &vec![acceleration; driven]);
        self.equations.begin(tree, numbers, &self.kinematics);
        let kinematics = &self.kinematics;
        self.equations.solve(|jacobian, biases| {
            jacobian.fill(0.0);
            cut_jacobian(tree, numbers, kinematics, jacobian);
            cut_biases(tree, numbers, kinematics, biases);
        });
        let mut slope = vec![0.0; tree.free];
        for link in tree.links.iter().filter(|link| !link.is_driven) {
            let own = &coordinates[link.coordinates.clone()];
            link.attachment.coordinate_rates(own, &rates[link.speeds.clone()], &mut slope[link.coordinates.clone()]);
        }
        slope.extend(&self.equations.accelerations);
        slope
    }

    /// A step of the classical method of fourth order.
    fn step(&mut self, time_s: f64, state: &[f64], length_s: f64) -> Vec<f64> {
        let plus = |slope: &[f64], share: f64| -> Vec<f64> {
            state.iter().zip(slope).map(|(at, slope)| at + share * length_s * slope).collect()
        };
        let first = self.slope(time_s, state);
        let second = self.slope(time_s + 0.5 * length_s, &plus(&first, 0.5));
        let third = self.slope(time_s + 0.5 * length_s, &plus(&second, 0.5));
        let last = self.slope(time_s + length_s, &plus(&third, 1.0));
        let mean = |k: usize| (first[k] + 2.0 * (second[k] + third[k]) + last[k]) / 6.0;
        (0..state.len()).map(|k| state[k] + length_s * mean(k)).collect()
    }
}

/// The same numbers as numbers of another kind.
fn broadcast<T: Real>(plain: &TreeNumbers<f64, Space>) -> TreeNumbers<T, Space> {
    let vector = |v: Vec3| Vec3::new(T::from_f64(v.x), T::from_f64(v.y), T::from_f64(v.z));
    let rotation = |r: Rotation| Rotation { x: vector(r.x), y: vector(r.y), z: vector(r.z) };
    let links = plain.links.iter().map(|link| LinkNumbers {
        parent_arm_m: vector(link.parent_arm_m),
        own_arm_m: vector(link.own_arm_m),
        mount: SpaceMount {
            parent: rotation(link.mount.parent),
            own: rotation(link.mount.own),
            turn_from_parent: rotation(link.mount.turn_from_parent),
        },
        eccentricity_m: vector(link.eccentricity_m),
        centre_of_mass_m: vector(link.centre_of_mass_m),
        mass_kg: T::from_f64(link.mass_kg),
        inertia_kg_m2: SpaceInertia {
            diagonal_kg_m2: link.inertia_kg_m2.diagonal_kg_m2.map(T::from_f64),
            beside_kg_m2: link.inertia_kg_m2.beside_kg_m2.map(T::from_f64),
        },
    });
    let cuts = plain.cuts.iter().map(|cut| CutNumbers {
        arms_m: cut.arms_m.map(vector),
        markers: cut.markers.map(rotation),
        eccentricity_m: vector(cut.eccentricity_m),
        radius_m: T::from_f64(cut.radius_m),
    });
    TreeNumbers {
        links: links.collect(),
        cuts: cuts.collect(),
        couplings: Vec::new(),
        beams: Vec::new(),
        nodal_beams: Vec::new(),
        gravity_m_s2: vector(plain.gravity_m_s2),
    }
}
