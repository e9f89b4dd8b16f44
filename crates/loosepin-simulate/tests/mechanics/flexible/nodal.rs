//! Links in absolute nodal coordinates in mechanisms: against another program, against the floating frame, and against what must not matter.

use super::{POWER_OUTPUTS, apart, assert_power_of_the_drive, case_text, record_of, record_within, reordered, values};
use crate::elements::{build, file};
use loosepin_simulate::{Integrator, Observer, Plan, Settings, Step, Window, run, simulate};

/// A case of a flexible link in absolute nodal coordinates, over a short time.
fn nodal(name: &str, shapes: &str, elements: usize, [duration, short]: [&str; 2]) -> String {
    let text = case_text(name);
    let with = text.replace(shapes, &format!("formulation = \"absolute-nodal\"\nelements = {elements}"));
    assert_ne!(text, with);
    with.replace(&format!("duration = \"{duration}\""), &format!("duration = \"{short}\""))
}

fn slider_crank(elements: usize, short: &str) -> String {
    nodal("flexible_slider_crank", "lateral_shapes = 2\naxial_shapes = 2", elements, ["10 ms", short])
}

fn four_bar(elements: usize, short: &str) -> String {
    nodal("flexible_four_bar", "lateral_shapes = 3\naxial_shapes = 2", elements, ["20 ms", short])
}

/// The history of another program, which has x and y of all nodes; here the root has an angle and a stretch.
#[test]
fn peer_the_soft_pendulum_in_a_model_file() {
    let built = build(&file("nodal_pendulum.toml"));
    // The angle of the root, and 4 · 12 + 1 of the beam.
    assert_eq!(built.mechanism.real.free, 50);
    let record = record_of(&built, 1e-11);
    let rows: Vec<Vec<f64>> = include_str!("../../../../loosepin-flexible/src/tests/soft_pendulum.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|number| number.parse().expect("a number")).collect())
        .collect();
    assert_eq!((rows.len(), record.time_s.len()), (101, 101));
    for (row, ((time_s, x), y)) in
        rows.iter().zip(record.time_s.iter().zip(values(&record, "tip_x")).zip(values(&record, "tip_y")))
    {
        assert!((row[0] - time_s).abs() < 1e-12);
        assert!((x - row[1]).abs() < 2e-9 && (y - row[2]).abs() < 2e-9, "at {time_s} s: {x}, {y} for {row:?}");
    }
    // It is drawn in a frame through both ends: the axis ends at the tip, which lies on the x axis of that frame.
    let (drawn, poses) = (&record.drawing.beams[0], &record.drawing.poses);
    let last = drawn.axis_x_m.len() - 1;
    assert_eq!(drawn.axis_x_m[last].len(), 101);
    for (pose, (x, y)) in values(&record, "tip_x").iter().zip(values(&record, "tip_y")).enumerate() {
        let (sine, cosine) = poses.angle_rad[1][pose].sin_cos();
        let (along, across) = (drawn.axis_x_m[last][pose], drawn.axis_y_m[last][pose]);
        assert!(across.abs() < 1e-12 && along > 0.3, "{along} m, {across} m");
        assert!((poses.x_m[1][pose] + cosine * along - x).abs() < 1e-12);
        assert!((poses.y_m[1][pose] + sine * along - y).abs() < 1e-12);
    }
    assert!(record.energy.relative_residual < 1e-10, "{:e}", record.energy.relative_residual);
    assert!(record.bending[0].is_nodal && record.bending[0].largest_angle_rad > 1.0, "{:?}", record.bending);
}

/// Tips of the blade of `flexible_spin_up.toml` with so many elements at 5, 6.5 and 7.5 s, or at the first of them.
fn blade_tips_m(elements: usize, times: usize) -> Vec<f64> {
    let (duration, rows) = [("5 s", &[120][..]), ("6.5 s", &[92, 120]), ("7.5 s", &[80, 104, 120])][times - 1];
    let keys = format!("formulation = \"absolute-nodal\"\nelements = {elements}");
    let text = file("flexible_spin_up.toml")
        .replace("duration = \"15 s\"", &format!("duration = \"{duration}\""))
        .replace("frame = \"tangent\"\nlateral_shapes = 3\naxial_shapes = 0", &keys);
    let built = build(&text);
    // The hub is driven, the root is clamped to it: its slope has a length alone.
    assert_eq!((built.mechanism.real.free, built.mechanism.real.cuts.len()), (4 * elements + 1, 0));
    let plan = Plan {
        settings: Settings { tolerance_m: 1e-4, integrator: Integrator::Implicit, ..Settings::for_simulation() },
        ..Plan::of_model(&built.mechanism.model)
    };
    let record = simulate(&built.mechanism, &built.values, &plan).unwrap_or_else(|failure| panic!("{failure}")).record;
    // Explicit steps, which follow axial waves, have the same places to 5e-8 m, with twelve times the evaluations.
    assert!(record.energy.relative_residual < 1e-6, "{:e}", record.energy.relative_residual);
    rows.iter().map(|row| values(&record, "across")[*row]).collect()
}

/// The exact kinematics of a beam that does not stretch, six shapes, by another program.
const BLADE_TIPS_M: [f64; 3] = [-0.62314398, -0.75038786, -0.70697221];

/// A blade on a hub that is brought to speed: at 5 s two elements leave 4.4e-2 m, four 3.6e-3 m, eight 8.5e-5 m.
#[test]
fn peer_a_blade_of_two_and_four_elements_whose_hub_is_brought_to_speed() {
    let [two, four] = [2, 4].map(|elements| (blade_tips_m(elements, 1)[0] - BLADE_TIPS_M[0]).abs());
    assert!(four < 4e-3 && two > 8.0 * four, "{two:e} m and {four:e} m");
}

#[test]
fn peer_a_blade_of_eight_elements_whose_hub_is_brought_to_speed() {
    for (found, exact) in blade_tips_m(8, 3).iter().zip(BLADE_TIPS_M) {
        assert!((found - exact).abs() < 1e-3, "{found} m for {exact} m");
    }
}

/// Another program with 16 elements, onsets of first contacts and their peaks.
#[test]
fn peer_first_contacts_of_two_mechanisms() {
    let known = [(slider_crank(16, "0.7 ms"), 2.84637e-4, 4085.4), (four_bar(16, "1.3 ms"), 9.942158e-4, 1399.6)];
    for (text, onset_s, peak_n) in known {
        let record = record_within(&text, 1e-9);
        let first = &record.impacts[0];
        assert!((first.time_s - onset_s).abs() < 1e-9, "{:e} s for {onset_s:e}", first.time_s);
        assert!((first.peak_force_n / peak_n - 1.0).abs() < 1e-3, "{} N for {peak_n}", first.peak_force_n);
        assert!(record.energy.relative_residual < 1e-8, "{:e}", record.energy.relative_residual);
    }
}

/// The same rod with its elements numbered from the other end.
#[test]
fn identity_a_link_may_hang_by_either_end() {
    let text = slider_crank(3, "0.6 ms");
    let exchanged = text.replace("from = \"big_end\"\nto = \"small_end\"", "from = \"small_end\"\nto = \"big_end\"");
    assert_ne!(text, exchanged);
    assert!(build(&exchanged).mechanism.real.nodal_beams[0].is_reversed);
    let [one, other] = [&text, &exchanged].map(|text| record_within(text, 1e-11));
    assert_eq!(one.impacts.len(), 1);
    assert!((one.impacts[0].time_s - other.impacts[0].time_s).abs() < 1e-11);
    for output in ["slider", "small_end_x", "small_end_y"] {
        assert!(apart(&one, &other, output) < 1e-10, "{output}: {:e}", apart(&one, &other, output));
    }
}

/// A closed loop without play; the angle of the rod is that of its section at `from`, by whichever end it hangs. The slider hangs on the tip of the rod and its guide is cut, or the gudgeon is cut, or the crank pin.
#[test]
fn identity_whichever_joint_of_a_loop_is_cut() {
    let text = slider_crank(3, "1 ms").replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"");
    let by_gudgeon = reordered(&text, "guide", "gudgeon");
    let by_crank_pin = reordered(&reordered(&text, "gudgeon", "crank_pin"), "guide", "gudgeon");
    let [guide, gudgeon, crank_pin] = [&text, &by_gudgeon, &by_crank_pin].map(|text| {
        let built = build(text);
        let cut = &built.mechanism.real.cuts[0];
        (built.mechanism.model.joints[cut.joint.0].name.clone(), record_of(&built, 1e-11))
    });
    assert_eq!([&guide.0, &gudgeon.0, &crank_pin.0], ["guide", "gudgeon", "crank_pin"]);
    for other in [&gudgeon.1, &crank_pin.1] {
        for output in ["slider", "rod"] {
            let apart = apart(&guide.1, other, output);
            assert!(apart < 1e-10, "{output}: {apart:e}");
        }
        let force_n = apart(&guide.1, other, "gudgeon_force");
        assert!(force_n < 1e-3, "{force_n:e} N");
        assert!(other.energy.relative_residual < 1e-9, "{:e}", other.energy.relative_residual);
    }
    // Twice as many shapes of the floating frame and more elements come to the same motion: micrometres off the ideal one.
    let floating = case_text("flexible_slider_crank")
        .replace("duration = \"10 ms\"", "duration = \"1 ms\"")
        .replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"")
        .replace("lateral_shapes = 2\naxial_shapes = 2", "lateral_shapes = 4\naxial_shapes = 4");
    let floating = record_within(&floating, 1e-11);
    let slider = floating.outputs.iter().find(|history| history.name == "slider").expect("an output");
    let largest = slider.deviation_si.iter().fold(0.0_f64, |largest, deviation| largest.max(deviation.abs()));
    let off = apart(&guide.1, &floating, "slider");
    assert!(largest > 2e-6 && off < 0.2 * largest, "{off:e} m of {largest:e} m");
}

/// Force and couple of a contact with friction act on position and slope of the node: nothing is gained or lost but by friction, impacts
/// and damping.
#[test]
fn identity_momenta_and_energy_of_two_floating_links_with_friction() {
    struct Watched(Vec<[f64; 3]>);
    impl Observer for Watched {
        fn step(&mut self, step: &mut Step<'_, '_>) {
            let dynamics = step.end();
            let of_all = (0..2).map(|index| dynamics.nodal_momentum(index));
            self.0.push(
                of_all.fold([0.0; 3], |[x, y, turn], (momentum, angular)| {
                    [x + momentum.x, y + momentum.y, turn + angular]
                }),
            );
        }
    }
    let built = build(&file("nodal_two_floating_links.toml"));
    assert_eq!(built.mechanism.real.nodal_beams.len(), 2);
    // Root frames, and 13 and 5 of the beams.
    assert_eq!(built.mechanism.real.free, 6 + 13 + 5);
    let window = Window { start_s: 0.0, end_s: 3e-3 };
    let settings = Settings { tolerance_m: 1e-10, ..Settings::for_simulation() };
    let mut watched = Watched(Vec::new());
    let report = run(&built.mechanism, &built.sample(), &window, &settings, &mut watched)
        .unwrap_or_else(|failure| panic!("{failure}"));
    let account = report.energy.expect("it is integrated");
    assert!(account.relative_residual() < 1e-8, "{:e}", account.relative_residual());
    assert!(
        account.friction_loss_j > 1e-4 && account.contact_loss_j > 1e-4 && account.damping_loss_j > 1e-5,
        "{account:?}"
    );
    assert!(report.plays[0].contacts > 1, "{:?}", report.plays);
    let start = watched.0[0];
    assert!(start[0].abs() > 0.01 && start[1].abs() > 0.01 && start[2].abs() > 1e-3, "{start:?}");
    for (index, found) in watched.0.iter().enumerate() {
        for k in 0..3 {
            assert!((found[k] - start[k]).abs() < 1e-8 * start[k].abs(), "step {index}: {found:?} and {start:?}");
        }
    }
}

/// The crank turns evenly about its centre of mass: the power of its drive is that of the force in the crank pin, which is what the rod beyond
/// it needs.
#[test]
fn identity_the_force_that_a_rod_needs_has_the_power_of_the_drive() {
    let record = record_within(&(slider_crank(2, "1 ms") + POWER_OUTPUTS), 1e-9);
    assert_power_of_the_drive(&record);
}
