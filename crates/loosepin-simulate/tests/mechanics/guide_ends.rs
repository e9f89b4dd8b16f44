//! A slider that overhangs the ends of its guide (`docs/notation.md`): the edge of the guide on the face of the block.

use crate::case::{Case, case};
use crate::elements::file;
use loosepin_math::Vec2;
use loosepin_mechanics::dynamics::{ContactForce, Dynamics, PlayState};
use loosepin_simulate::{Observer, RunFailure, RunReport, Settings, Step, Window, run};

const HALF_LENGTH_M: f64 = 0.043;
const HALF_HEIGHT_M: f64 = 0.012;
const CLEARANCE_M: f64 = 1e-4;
const START_M: f64 = -0.12;
const END_M: f64 = 0.09;
const MASS_KG: f64 = 2.3;
const GRAVITY_M_S2: f64 = 9.81;
/// The rail on the ground, and the block's middle and centre of mass in its own frame, m.
const RAIL_M: [f64; 2] = [0.04, 0.01];
const MIDDLE_M: [f64; 2] = [0.5e-3, 0.7e-3];
const CENTRE_M: [f64; 2] = [3e-3, 2e-3];

fn text() -> String {
    file("block_over_the_end.toml")
}

/// Coordinates of the block whose middle is at `[x_m, y_m]` in the guide, turned by `tilt_rad`.
fn block_at([x_m, y_m]: [f64; 2], tilt_rad: f64) -> [f64; 3] {
    let middle = Vec2::new(MIDDLE_M[0], MIDDLE_M[1]).rotated(tilt_rad.sin(), tilt_rad.cos());
    [RAIL_M[0] + x_m - middle.x, RAIL_M[1] + y_m - middle.y, tilt_rad]
}

/// Of a corner: where it is along the guide, m, and δ, m, by the sentences of the notation. Beyond an end the block's face there
/// counts.
fn along_and_penetration_m([x_m, y_m]: [f64; 2], tilt_rad: f64, contact: usize) -> [f64; 2] {
    let (front, upper) = ([-1.0, 1.0][contact % 2], [1.0, -1.0][contact / 2]);
    let (sine, cosine) = tilt_rad.sin_cos();
    let along_m = x_m + front * HALF_LENGTH_M * cosine - upper * HALF_HEIGHT_M * sine;
    let wide_m = HALF_HEIGHT_M + CLEARANCE_M;
    let edge_m = along_m.clamp(START_M, END_M);
    if edge_m == along_m {
        let corner_m = y_m + front * HALF_LENGTH_M * sine + upper * HALF_HEIGHT_M * cosine;
        return [along_m, upper * corner_m - wide_m];
    }
    [along_m, upper * (y_m + (edge_m - x_m) * tilt_rad.tan()) + HALF_HEIGHT_M / cosine - wide_m]
}

fn evaluated(case: &Case, place_m: [f64; 2], tilt_rad: f64, rates: [f64; 3]) -> (Vec<ContactForce<f64>>, Vec<f64>) {
    let mut dynamics = Dynamics::new(&case.mechanism, &case.sample);
    let state = PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.3, effective_mass_kg: f64::NAN };
    dynamics.evaluate(0.0, &block_at(place_m, tilt_rad), &rates, &[state; 4]);
    let gaps_m = (0..4).map(|contact| dynamics.gap(contact).gap[0]).collect();
    (dynamics.contacts().to_vec(), gaps_m)
}

#[test]
fn analytic_edge_of_the_guide_on_the_face_of_the_block() {
    /// Round-off of ordinates, m, and relative one of forces.
    const ROUND_OFF_M: f64 = 1e-16;
    const ROUND_OFF: f64 = 1e-9;
    /// K of the file, N/m^1.5.
    const STIFFNESS: f64 = 5e7;
    let case = case(&text());
    let mut edges = 0;
    // Tilts beyond the play, so that something touches; the last is steep, to tell tan from sin.
    for (place_m, tilt_rad) in [
        ([0.07, 4e-4], -0.012),
        ([0.07, -4e-4], -0.012),
        ([0.081, -3e-4], 0.017),
        ([0.103, -6e-4], -0.021),
        ([-0.1, 5e-4], 0.019),
        ([-0.13, 1e-4], -0.015),
        ([-0.11, -7e-4], 0.018),
        ([0.085, 6e-4], 0.02),
        ([0.1, -0.02], -0.83),
    ] {
        let (forces, gaps_m) = evaluated(&case, place_m, tilt_rad, [0.0; 3]);
        for (contact, (force, gap_m)) in forces.iter().zip(gaps_m).enumerate() {
            let [along_m, penetration_m] = along_and_penetration_m(place_m, tilt_rad, contact);
            assert!((gap_m - penetration_m).abs() < ROUND_OFF_M, "{place_m:?} {contact}: {gap_m} {penetration_m}");
            assert!((force.along_m - along_m).abs() < ROUND_OFF_M, "{} {along_m}", force.along_m);
            let (along, elastic_n) = (along_m.clamp(START_M, END_M), STIFFNESS * penetration_m.max(0.0).powf(1.5));
            if elastic_n == 0.0 {
                assert_eq!(force.normal_n, 0.0);
                continue;
            }
            let upper = [1.0, -1.0][contact / 2];
            // Across the guide at a corner, across the block at an edge: there N/cos θ, which is N across the guide.
            let (sine, cosine, tangent) = (tilt_rad.sin(), tilt_rad.cos(), tilt_rad.tan());
            let (lean_n, normal_n) =
                if along == along_m { (0.0, elastic_n) } else { (elastic_n * tangent, elastic_n / cosine) };
            edges += usize::from(along != along_m);
            let expected_n = Vec2::new(upper * lean_n, -upper * elastic_n);
            let slack_n = ROUND_OFF * elastic_n;
            assert!((force.normal_n - normal_n).abs() < slack_n, "{} {normal_n}", force.normal_n);
            assert!((force.on_journal_n - expected_n).length() < slack_n, "{:?} {expected_n:?}", force.on_journal_n);
            // -N ∂δ/∂θ about the block's middle.
            let x_m = along - place_m[0];
            let gradient_m = if along == along_m {
                let front = [-1.0, 1.0][contact % 2];
                upper * front * HALF_LENGTH_M * cosine - HALF_HEIGHT_M * sine
            } else {
                (upper * x_m + HALF_HEIGHT_M * sine) / (cosine * cosine)
            };
            let moment_n_m = -elastic_n * gradient_m;
            assert!((force.moment_on_journal_n_m - moment_n_m).abs() < slack_n * HALF_LENGTH_M, "{moment_n_m}");
        }
    }
    assert!(edges > 7, "{edges} edges touched");
}

#[test]
fn identity_penetration_does_not_jump_where_a_corner_passes_the_end() {
    /// Way from one side of the end to the other, m.
    const WAY_M: f64 = 1e-9;
    let case = case(&text());
    for tilt_rad in [-0.021_f64, 0.013, -0.4] {
        let (sine, cosine) = tilt_rad.sin_cos();
        for contact in 0..4 {
            let (front, upper) = ([-1.0, 1.0][contact % 2], [1.0, -1.0][contact / 2]);
            let end_m = if front > 0.0 { END_M } else { START_M };
            let x_m = end_m - front * HALF_LENGTH_M * cosine + upper * HALF_HEIGHT_M * sine;
            let [before_m, after_m] =
                [-0.5, 0.5].map(|share| evaluated(&case, [x_m + share * WAY_M, 1e-4], tilt_rad, [0.0; 3]).1[contact]);
            // At the corner's side x does not count; at the edge's it does, with tan θ.
            let largest_m = WAY_M * tilt_rad.tan().abs();
            assert!((after_m - before_m).abs() < largest_m, "{contact} at {tilt_rad}: {before_m} {after_m}");
        }
    }
}

/// What a run shows of its contacts at the ends of its steps.
#[derive(Default)]
struct Seen {
    last: Vec<ContactForce<f64>>,
    middle_m: [f64; 2],
    tilt_rad: f64,
    furthest_m: f64,
    /// Largest normal force at the ends of steps, N, and the tilt there.
    largest_n: f64,
    tilt_at_largest_rad: f64,
    /// Contacts at the ends of steps: of corners past an end, and of corners before it.
    edges: usize,
    corners: usize,
}

impl Observer for Seen {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let dynamics = step.evaluate(step.end_s);
        self.last = dynamics.contacts().to_vec();
        let pose = &dynamics.kinematics.poses[1];
        let middle_m = pose.point_m(Vec2::new(MIDDLE_M[0], MIDDLE_M[1])) - Vec2::new(RAIL_M[0], RAIL_M[1]);
        self.middle_m = [middle_m.x, middle_m.y];
        self.tilt_rad = pose.angle_rad();
        self.furthest_m = self.furthest_m.max(middle_m.x);
        for force in self.last.iter().filter(|force| force.normal_n > 0.0) {
            if force.normal_n > self.largest_n {
                (self.largest_n, self.tilt_at_largest_rad) = (force.normal_n, pose.angle_rad());
            }
            if (START_M..END_M).contains(&force.along_m) { self.corners += 1 } else { self.edges += 1 }
        }
    }
}

fn observed(text: &str, end_s: f64) -> (Result<RunReport, RunFailure>, Seen) {
    let Case { mechanism, sample, .. } = case(text);
    let mut seen = Seen::default();
    let window = Window { start_s: 0.0, end_s };
    let report = run(&mechanism, &sample, &window, &Settings::for_simulation(), &mut seen);
    (report, seen)
}

#[test]
fn identity_energy_over_the_end_and_back() {
    /// Largest residual over largest exchange, as of corners.
    const ENERGY_RESIDUAL: f64 = 1e-7;
    let rough = text().replace("restitution = 1.0", "restitution = 0.7\nfriction = { coefficient = 0.13 }");
    let far = |text: &str| text.replace("end = \"90 mm\"", "end = \"900 mm\"");
    for text in [text(), rough] {
        for text in [far(&text), text.clone()] {
            let (report, seen) = observed(&text, 0.6);
            let report = report.expect("the run is sound");
            let energy = report.energy.expect("it was integrated");
            println!(
                "residual {:.1e}, {} contacts, {} edges, {} corners, to {}, {:?}",
                energy.relative_residual(),
                report.plays[0].contacts,
                seen.edges,
                seen.corners,
                seen.furthest_m,
                report.counters
            );
            assert!(energy.relative_residual() < ENERGY_RESIDUAL, "{energy:?}");
            assert!(seen.furthest_m > 0.08, "it goes over the end: {}", seen.furthest_m);
            assert!(seen.middle_m[0] < 0.06, "it comes back: {}", seen.middle_m[0]);
            assert!(seen.edges > 100 && seen.corners > 100, "{} {}", seen.edges, seen.corners);
        }
    }
}

#[test]
fn analytic_lever_of_a_block_whose_centre_is_beyond_the_end() {
    /// What is left of the motion after half a second, and how far the spring pulls out of level, over the weight.
    const SETTLED: f64 = 1e-7;
    let text = text()
        .replace("restitution = 1.0", "law = \"kelvin-voigt\"\ndamping_coefficient = \"2500 N s/m\"")
        .replace("stiffness = \"5e7 N/m^1.5\"\nexponent = 1.5", "stiffness = \"2e7 N/m\"")
        .replace("stiffness = \"0.2 N/mm\"", "stiffness = \"20 N/mm\"\ndamping = \"430 N s/m\"")
        .replace("-3960 mm", "-399960 mm")
        .replace("free_length = \"4033 mm\"", "free_length = \"400105 mm\"")
        .replace("position = \"30 mm\"", "position = \"101 mm\"")
        .replace("velocity = \"0.6 m/s\"", "velocity = \"0 m/s\"");
    let (report, seen) = observed(&text, 0.5);
    report.expect("the run is sound");
    let weight_n = MASS_KG * GRAVITY_M_S2;
    let (sine, cosine) = seen.tilt_rad.sin_cos();
    let arm = Vec2::new(CENTRE_M[0] - MIDDLE_M[0], CENTRE_M[1] - MIDDLE_M[1]);
    let centre_m = Vec2::new(seen.middle_m[0], seen.middle_m[1]) + arm.rotated(sine, cosine);
    let beyond_m = centre_m.x - END_M;
    assert!(beyond_m > 0.01 && seen.tilt_rad < -1e-3, "{beyond_m} {}", seen.tilt_rad);
    // The rear of the upper face holds it down at a lever of a - d, the end's edge carries it; both act across the guide but for the
    // lean of the edge, N tan θ, against which the spring pulls at the centre.
    let rear_m = END_M - (seen.middle_m[0] - HALF_LENGTH_M * cosine - HALF_HEIGHT_M * sine);
    let edge_m = seen.middle_m[1] + (END_M - seen.middle_m[0]) * seen.tilt_rad.tan() - HALF_HEIGHT_M / cosine;
    // R rear = W d + (R + W) |tan θ| (height of the centre over the edge), with N = R + W.
    let lean_m = -seen.tilt_rad.tan() * (centre_m.y - edge_m);
    let rear_n = weight_n * (beyond_m - lean_m) / (rear_m + lean_m);
    let edge_n = weight_n + rear_n;
    let expected_n = [rear_n, 0.0, 0.0, edge_n / cosine];
    let found_n: Vec<f64> = seen.last.iter().map(|force| force.normal_n).collect();
    println!("{found_n:?} {expected_n:?} W d/(a - d) {}", weight_n * beyond_m / (HALF_LENGTH_M - beyond_m));
    for (found_n, expected_n) in found_n.iter().zip(expected_n) {
        assert!((found_n - expected_n).abs() < SETTLED * weight_n, "{found_n} {expected_n}");
    }
}

#[test]
fn identity_the_largest_force_is_none_of_the_law_but_of_the_tilted_face() {
    // A guide so wide that the block tilts far over its end.
    let wide = text()
        .replace("clearance = \"0.1 mm\"", "clearance = \"9 mm\"")
        .replace("velocity = \"0.6 m/s\"", "velocity = \"1.05 m/s\"");
    let (report, seen) = observed(&wide, 0.11);
    let report = report.expect("the run is sound");
    println!("{} N at {} rad, told {} N", seen.largest_n, seen.tilt_at_largest_rad, report.plays[0].peak_force_n);
    assert!(seen.tilt_at_largest_rad.abs() > 5e-3 && seen.edges > 0, "{}", seen.tilt_at_largest_rad);
    // The ends of steps are among what is looked at.
    const ROUND_OFF: f64 = 1e-9;
    assert!(report.plays[0].peak_force_n >= seen.largest_n * (1.0 - ROUND_OFF));
}

#[test]
fn text_of_a_block_that_leaves_its_guide() {
    let (failure, _) = observed(&text().replace("velocity = \"0.6 m/s\"", "velocity = \"1.9 m/s\""), 0.6);
    let Err(RunFailure::BeyondGuide { contact, joint, along_m, ends_m, .. }) = failure else { panic!("{failure:?}") };
    assert_eq!((joint.as_str(), ends_m), ("guide", [START_M, END_M]));
    assert!(contact.ends_with(" rear)") && along_m > END_M && along_m < END_M + 1e-3, "{contact} {along_m}");
    // Back over the start, with its front.
    let (failure, _) = observed(&text().replace("velocity = \"0.6 m/s\"", "velocity = \"-2.2 m/s\""), 0.6);
    let Err(RunFailure::BeyondGuide { contact, along_m, .. }) = failure else { panic!("{failure:?}") };
    assert!(contact.ends_with(" front)") && along_m < START_M && along_m > START_M - 1e-3, "{contact} {along_m}");
}
