//! A cantilever in absolute nodal coordinates against the elastica.

use crate::nodal::{ClampedRoot, Mesh, NoStableEquilibrium, NodalBeam, Rule, TipLoad};
use loosepin_math::Vec2;

const LENGTH_M: f64 = 0.8;
/// EI, N m².
const BENDING: f64 = 3.7;
const ROOT: ClampedRoot = ClampedRoot { root_m: Vec2 { x: 0.2, y: -0.1 }, axis: Vec2 { x: 0.8, y: 0.6 } };

/// A beam with EA L²/EI = `slenderness`.
fn beam(slenderness: f64) -> NodalBeam<f64> {
    NodalBeam {
        length_m: LENGTH_M,
        mass_kg: f64::NAN,
        axial_stiffness_n_m: slenderness * BENDING / LENGTH_M.powi(3),
        bending_stiffness_n_m: BENDING / LENGTH_M,
        retardation_s: f64::NAN,
    }
}

/// Tip along and across the axis of the root over L, and the angle of its section, rad.
fn tip(beam: &NodalBeam<f64>, mesh: &Mesh, load: &TipLoad) -> Result<[f64; 3], NoStableEquilibrium> {
    // Without weight the mass is not asked for: it is no number.
    let massless = NodalBeam { mass_kg: 0.0, ..*beam };
    let nodes = massless.at_rest(mesh, &ROOT, Vec2::zero(), load, 10)?;
    let end = nodes[mesh.elements()];
    let back = |vector: Vec2<f64>| vector.rotated(-ROOT.axis.y, ROOT.axis.x);
    let (place, slope) = (back(end.position - ROOT.root_m) * (1.0 / LENGTH_M), back(end.slope));
    Ok([place.x, place.y, slope.y.atan2(slope.x)])
}

/// A force across the axis with P L²/EI = `alpha`.
fn across(alpha: f64) -> TipLoad {
    TipLoad { force_n: ROOT.axis.turned() * (alpha * BENDING / LENGTH_M.powi(2)), couple_n_m: 0.0 }
}

/// Tip angle, deflection over L and place along the axis over L of a beam that does not stretch.
const ELASTICA: [(f64, [f64; 3]); 7] = [
    (0.1, [0.049954255755, 0.033295319268, 0.999334600037]),
    (0.5, [0.244533647133, 0.162143575658, 0.984081037529]),
    (1.0, [0.461351949712, 0.301720773800, 0.943566763717]),
    (2.0, [0.781749831557, 0.493457480397, 0.839358279175]),
    (3.0, [0.986016946711, 0.603253441130, 0.745579815436]),
    (5.0, [1.215368117612, 0.713791523612, 0.612371639276]),
    (10.0, [1.430285538804, 0.810609024880, 0.445004402246]),
];

/// 1e-4 with 16 elements; the stretch takes a part of it: at α = 10 7e-5 of a beam of this slenderness.
#[test]
fn analytic_a_cantilever_with_a_force_across_is_the_elastica() {
    for (alpha, [angle_rad, across_share, along_share]) in ELASTICA {
        for (slenderness, elements, tolerance) in [(1.2e5, 16, 1.5e-4), (1.2e7, 64, 5e-7)] {
            let mesh = Mesh::new(elements, Rule::Full);
            let found = tip(&beam(slenderness), &mesh, &across(alpha)).unwrap_or_else(|failure| panic!("{failure}"));
            for (found, due) in found.iter().zip([along_share, across_share, angle_rad]) {
                assert!((found - due).abs() < tolerance * alpha.max(1.0), "{alpha}, {elements}: {found} for {due}");
            }
        }
    }
}

/// Distance of the tip from the elastica that stretches, over L, for some meshes.
fn errors(alpha: f64, axial: usize, bending: usize, elements: &[usize]) -> Vec<f64> {
    let [x, y] = if alpha < 5.0 { [0.839362878780, 0.493464907594] } else { [0.445014107456, 0.810675624870] };
    let error = |&elements: &usize| {
        let mesh = Mesh::with_points(elements, axial, bending);
        let found = tip(&beam(1.2e5), &mesh, &across(alpha)).unwrap_or_else(|failure| panic!("{failure}"));
        (found[0] - x).hypot(found[1] - y)
    };
    elements.iter().map(error).collect()
}

#[test]
fn peer_a_cantilever_converges_as_another_program_does() {
    const ELEMENTS: [usize; 5] = [2, 4, 8, 16, 32];
    let known = [
        (2.0, 5, 3, [2.4e-2, 4.2e-3, 2.3e-4, 4.9e-6, 8.5e-8]),
        (2.0, 3, 2, [2.0e-2, 3.3e-3, 1.7e-4, 4.3e-6, 1.3e-7]),
        (10.0, 5, 3, [7.4e-2, 1.2e-2, 1.6e-3, 6.1e-5, 1.3e-6]),
    ];
    for (alpha, axial, bending, known) in known {
        let found = errors(alpha, axial, bending, &ELEMENTS);
        for (found, known) in found.iter().zip(known) {
            // Two digits are known.
            let [found, known] = [*found, known].map(|error| format!("{error:.1e}"));
            assert_eq!(found, known, "{alpha}, {axial} + {bending}");
        }
        let order = (found[3] / found[4]).log2();
        assert!(order > 5.0, "{alpha}, {axial} + {bending}: order {order}");
    }
    // Four points for the stretch are as good as five.
    let [four, five] = [4, 5].map(|axial| errors(2.0, axial, 3, &[8])[0]);
    assert!((four / five - 1.0).abs() < 0.02, "{four:e} and {five:e}");
}

/// A couple bends a beam into a circle and stretches it not at all.
#[test]
fn analytic_a_couple_at_the_tip_bends_a_circle() {
    for turn_rad in [1.0_f64, 3.0, -6.0] {
        let load = TipLoad { force_n: Vec2::zero(), couple_n_m: turn_rad * BENDING / LENGTH_M };
        let found = tip(&beam(1.2e5), &Mesh::new(32, Rule::Full), &load).unwrap_or_else(|failure| panic!("{failure}"));
        let (sine, cosine) = turn_rad.sin_cos();
        let due = [sine / turn_rad, (1.0 - cosine) / turn_rad, sine.atan2(cosine)];
        for (found, due) in found.iter().zip(due) {
            assert!((found - due).abs() < 2e-7 * turn_rad.powi(4).max(1.0), "{turn_rad}: {found} for {due}");
        }
    }
}

/// A column between clamped root and free tip buckles at π²EI/(4L²), which its compression lowers by a part in 10⁵.
#[test]
fn analytic_a_column_has_no_stable_balance_beyond_its_euler_load() {
    let euler_n = std::f64::consts::PI.powi(2) * BENDING / (4.0 * LENGTH_M * LENGTH_M);
    let pressed = |share: f64| {
        let load = TipLoad { force_n: ROOT.axis * (-share * euler_n), couple_n_m: 0.0 };
        tip(&beam(1.2e5), &Mesh::new(8, Rule::Full), &load)
    };
    let [along, across, _] = pressed(0.999).unwrap_or_else(|failure| panic!("{failure}"));
    let shorter = 0.999 * std::f64::consts::PI.powi(2) / 4.0 / 1.2e5;
    assert!((1.0 - along - shorter).abs() < 1e-9 && across.abs() < 1e-9, "{along} {across}");
    let NoStableEquilibrium { share } = pressed(1.001).expect_err("it buckles");
    assert!((share * 1.001 - 1.0).abs() < 2e-4, "{share}");
}
