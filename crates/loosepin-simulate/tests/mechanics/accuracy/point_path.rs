//! Paths of points with the zones about them.

use super::motion::plan;
use super::{Built, build_case, build_text};
use crate::elements::file;
use loosepin_math::Vec2;
use loosepin_mechanics::model::{Axis, PointId, Position, Relative};
use loosepin_result::motion::MotionRecord;
use loosepin_result::point_path::{PointPath, REACH_DIRECTIONS, direction_rad};
use loosepin_simulate::accuracy::{DisplacedLoops, MotionPlan, PlayReach, Scatter, ScatterCorrelation, motion};

/// Round-off of sums of a few gradients, relative.
const ROUND_OFF: f64 = 1e-12;

fn point(built: &Built, name: &str) -> PointId {
    let (body, point) = name.split_once('.').expect("body.point");
    let body = built.mechanism.model.bodies.iter().position(|each| each.name == body).expect("a body");
    let point = built.mechanism.model.bodies[body].points.iter().position(|each| each.name == point).expect("a point");
    PointId { body: loosepin_mechanics::model::BodyId(body), point }
}

fn scatter(built: &Built, path: &str, standard_deviation_si: f64) -> Scatter {
    Scatter { quantity: built.mechanism.model.find(path).expect("a parameter"), standard_deviation_si }
}

fn output<'r>(record: &'r MotionRecord, name: &str) -> &'r loosepin_result::motion::OutputMotion {
    record.outputs.iter().find(|output| output.name == name).expect("an output")
}

fn extent(corners: &[[f64; 2]], direction: Vec2<f64>) -> f64 {
    corners.iter().map(|[x, y]| x * direction.x + y * direction.y).fold(f64::NEG_INFINITY, f64::max)
}

/// The bands of x, y, along and across, which come from the outputs, are the extents of the zone, which comes from its path.
#[test]
fn identity_the_bands_of_a_path_are_the_extents_of_its_zone() {
    // Two sides whose normals differ by δ touch the zone in places at most 2 R apart, R the largest reach: their corner is at most
    // R tan(δ/2) beyond the line between these places.
    let beyond = (0.5 * direction_rad(1)).tan();
    let built = build_case("four_bar_coupler_path");
    let scatter = vec![scatter(&built, "parameter.coupler_length", 2e-5)];
    let record =
        motion(&built.mechanism, &built.values, &MotionPlan { scatter, ..plan(&built, 72) }).expect("it turns");
    let [path] = &record.paths[..] else { panic!("one path, that of the output") };
    assert_eq!(
        (path.name.as_str(), path.point.as_str(), path.output.as_deref()),
        ("tool", "coupler.tool", Some("tool"))
    );
    assert!(path.is_complete() && path.has_zone() && path.positions() == record.drive_angle_rad.len());
    let of = |name: &str| &output(&record, name).clearance.first_order_si;
    let same = |a: f64, b: f64| (a - b).abs() <= ROUND_OFF * b;
    for k in 0..path.positions() {
        let zone = path.play_zone_m(k);
        assert!(same(extent(&zone, Vec2::new(1.0, 0.0)), of("tool x")[k]));
        assert!(same(extent(&zone, Vec2::new(0.0, 1.0)), of("tool y")[k]));
        assert!(same(path.play_along_m[k], of("tool along")[k]) && same(path.play_across_m[k], of("tool normal")[k]));
        let normal = Vec2::new(-path.tangent_y[k], path.tangent_x[k]);
        let across = extent(&zone, normal);
        let due = of("tool normal")[k];
        let reaches = &path.play_reach_m[k * REACH_DIRECTIONS..][..REACH_DIRECTIONS];
        let largest_m = zone.iter().fold(0.0, |most: f64, [x, y]| most.max(x.hypot(*y)));
        assert!(reaches.iter().all(|reach| *reach <= largest_m));
        assert!(across >= due * (1.0 - ROUND_OFF) && across <= due + beyond * largest_m, "{across} {due}");
        // One dimension alone: its ellipse is a segment, √(-2 ln 0.05) standard deviations long.
        let deviations = (-2.0 * 0.05_f64.ln()).sqrt();
        for (name, angle_rad) in [("tool x", 0.0), ("tool y", std::f64::consts::FRAC_PI_2)] {
            let due = deviations * output(&record, name).dimensional_standard_deviation_si[k];
            // Minor axis: the root of the round-off of its square.
            assert!((path.scatter_reach_m(k, angle_rad) - due).abs() < 1e-6 * path.scatter_major_m[k], "{name} {k}");
        }
        assert!(path.scatter_minor_m[k] < 1e-6 * path.scatter_major_m[k]);
    }
}

/// The foot of the rocker is a hole about a pin of the ground: it stands still, and play takes it 0.21 mm to any side.
#[test]
fn analytic_a_point_that_stands_still_has_no_direction_and_strays_by_its_play() {
    let built = build_case("four_bar_ground_journal");
    let paths = vec![point(&built, "rocker.foot")];
    let record = motion(&built.mechanism, &built.values, &MotionPlan { paths, ..plan(&built, 72) }).expect("it turns");
    let [path] = &record.paths[..] else { panic!("one path") };
    assert!(path.always_stands_still() && path.has_zone());
    // The directions that are tried are 0.35° apart.
    const BETWEEN_DIRECTIONS: f64 = 5e-6;
    for k in 0..path.positions() {
        for found in [path.play_along_m[k], path.play_across_m[k], path.along_and_across_m(k)[0]] {
            assert!((found / 0.21e-3 - 1.0).abs() < BETWEEN_DIRECTIONS, "{k}: {found}");
        }
    }
    assert!(record.kinematics.mechanical_advantages.iter().all(|each| each.name != "rocker.foot"));
    // A slider stands still at its dead centres alone; there it may be as far off as along its way.
    let built = build_case("slider_crank_worn_pin");
    let paths = vec![point(&built, "slider.pin")];
    let record = motion(&built.mechanism, &built.values, &MotionPlan { paths, ..plan(&built, 72) }).expect("it turns");
    let path = &record.paths[0];
    let still: Vec<usize> = (0..path.positions()).filter(|k| path.stands_still(*k)).collect();
    assert!(!still.is_empty() && still.len() < 4, "{still:?}");
    for k in 0..path.positions() {
        let due_m = if still.contains(&k) { path.play_along_m[k] } else { 0.0 };
        assert!((path.play_across_m[k] - due_m).abs() < 1e-12 && path.play_along_m[k] > 0.0, "{k}");
    }
}

/// Largest distance beyond the polygon, and the least share of a side that no displacement reaches, over displacements of all joints on the
/// borders of their play and within, the loops closed exactly.
fn brute_force(built: &Built, path: &PointPath, of: PointId, position: usize, angle_rad: f64) -> [f64; 2] {
    let sample = built.sample();
    let reaches = PlayReach::of_sample(&built.mechanism, &sample, sample.plays.iter().map(|_| 0.0)).expect("it holds");
    let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
    let input = built.input();
    let time_s = (angle_rad - input.angle_rad(0.0)) / input.speed_rad_s;
    loops.set_position(super::ideal_at(built, &sample, time_s).coordinates());
    let at = |loops: &DisplacedLoops<'_>| {
        let [x, y] = [Axis::X, Axis::Y].map(|axis| loops.value(Position::Point(Relative::to_ground(of), axis)));
        Vec2::new(x, y)
    };
    let ideal = at(&loops);
    assert!((ideal.x - path.x_m[position]).abs() + (ideal.y - path.y_m[position]).abs() < 1e-12);
    let directions: Vec<Vec2<f64>> =
        (0..2 * REACH_DIRECTIONS).map(direction_rad).map(|a| Vec2::new(a.cos(), a.sin())).collect();
    let mut furthest = vec![0.0_f64; directions.len()];
    // A fixed sequence; turns of one joint against the others, on the border and between.
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for draw in 0..4000 {
        let displacements: Vec<Vec2<f64>> = reaches
            .iter()
            .map(|reach| {
                let turn_rad = std::f64::consts::TAU * random();
                let share = if draw % 2 == 0 { 1.0 } else { random() };
                let border = match *reach {
                    PlayReach::Disc { radius_m } => Vec2::new(turn_rad.cos(), turn_rad.sin()) * radius_m,
                    PlayReach::Slot { clearance_m } => Vec2::new(clearance_m.copysign(turn_rad.cos()), 0.0),
                    PlayReach::Guide { clearance_m, largest_tilt_rad, .. }
                        if turn_rad.cos().abs() > turn_rad.sin().abs() =>
                    {
                        Vec2::new(clearance_m.copysign(turn_rad.cos()), 0.0 * largest_tilt_rad)
                    }
                    PlayReach::Guide { largest_tilt_rad, .. } => {
                        Vec2::new(0.0, largest_tilt_rad.copysign(turn_rad.sin()))
                    }
                };
                border * share
            })
            .collect();
        loops.centre();
        loops.displace(&displacements).expect("a small play leaves the loops closed");
        let way = at(&loops) - ideal;
        for (furthest, direction) in furthest.iter_mut().zip(&directions) {
            *furthest = furthest.max(way.dot(*direction));
        }
    }
    let reach = |side: usize| path.play_reach_m[position * REACH_DIRECTIONS + side % REACH_DIRECTIONS];
    let largest_m = (0..REACH_DIRECTIONS).map(reach).fold(0.0, f64::max);
    let beyond = furthest.iter().enumerate().map(|(side, found)| (found - reach(side)) / largest_m);
    let share = furthest.iter().enumerate().filter(|(side, _)| reach(*side) > 1e-3 * largest_m);
    let share = share.map(|(side, found)| found / reach(side)).fold(f64::INFINITY, f64::min);
    [beyond.fold(f64::NEG_INFINITY, f64::max), share]
}

/// With a millionth of the play the second order is a millionth of the first: no displacement then leaves the polygon by more, and the
/// displacements come near each of its sides.
#[test]
fn identity_no_displacement_leaves_the_zone_and_some_come_near_each_side() {
    /// Second order over first order, of lengths over play: 1e-9 m of play in 0.1 m, with lever arms of a few times.
    const SECOND_ORDER: f64 = 1e-6;
    /// Random displacements of up to three joints come so near each side.
    const SHARE_REACHED: f64 = 0.9;
    let guide = file("slider_with_play_in_its_guide.toml");
    let mechanisms = [
        (build_case("four_bar_coupler_path"), "coupler.tool"),
        (build_case("four_bar_three_clearances"), ""),
        (build_text(&guide), ""),
    ];
    for (built, name) in mechanisms {
        let model = &built.mechanism.model;
        let tiny: Vec<_> = built
            .mechanism
            .plays
            .iter()
            .flat_map(|play| {
                built.mechanism.model.quantities.iter().filter(|(_, q)| q.path.contains(model.play_name(*play)))
            })
            .filter(|(_, quantity)| quantity.is_settable() && quantity.path.ends_with("clearance"))
            .map(|(id, _)| (id, 1e-9))
            .collect();
        assert!(!tiny.is_empty(), "{}", model.name);
        let values = model.quantities.evaluate(&tiny).expect("small play is sound");
        let built =
            Built { mechanism: loosepin_mechanics::mechanism::Mechanism::new(model, &values).expect("sound"), values };
        let of = match name {
            "" => {
                let body =
                    built.mechanism.model.bodies.iter().position(|body| body.name == "coupler" || body.name == "rod");
                let body = body.expect("a coupler");
                PointId {
                    body: loosepin_mechanics::model::BodyId(body),
                    point: built.mechanism.model.bodies[body].points.len() - 1,
                }
            }
            name => point(&built, name),
        };
        let record = motion(&built.mechanism, &built.values, &MotionPlan { paths: vec![of], ..plan(&built, 24) })
            .expect("it turns");
        let path = record.paths.last().expect("a path");
        for position in [0, 5, 11, 18] {
            let [beyond, share] = brute_force(&built, path, of, position, record.drive_angle_rad[position]);
            assert!(beyond < SECOND_ORDER, "{} {position}: {beyond}", record.model);
            assert!(share > SHARE_REACHED, "{} {position}: {share}", record.model);
        }
    }
}

/// A point that no output names has a path; asked for twice, or as that of an output, it has one.
#[test]
fn any_point_has_a_path_once() {
    let built = build_case("four_bar_coupler_path");
    let [tool, other] = ["coupler.tool", "crank.pin"].map(|name| {
        let model = &built.mechanism.model;
        let (body, _) = name.split_once('.').expect("body.point");
        let body = model.bodies.iter().position(|each| each.name == body).expect("a body");
        let point =
            if name == "coupler.tool" { point(&built, name).point } else { model.bodies[body].points.len() - 1 };
        PointId { body: loosepin_mechanics::model::BodyId(body), point }
    });
    let plain = motion(&built.mechanism, &built.values, &plan(&built, 36)).expect("it turns");
    let asked = MotionPlan { paths: vec![other, tool, other], ..plan(&built, 36) };
    let record = motion(&built.mechanism, &built.values, &asked).expect("it turns");
    assert_eq!(record.paths.len(), 2);
    assert_eq!(record.paths[1].output, None);
    assert!(record.paths[1].name.starts_with("crank."), "{}", record.paths[1].name);
    // Further paths change nothing else.
    assert_eq!(record.outputs, plain.outputs);
    assert_eq!(record.paths[0], plain.paths[0]);
}

/// Two lengths that scatter as one, along the same line: with correlation -1 and equal deviations nothing is left.
#[test]
fn analytic_the_ellipse_is_that_of_the_covariance() {
    let output = "[parameter]\na = \"50 mm\"\nb = \"0 mm\"\n[output]\npin = { path_of = \"crank.pin\" }\n";
    let text =
        crate::elements::crank_text("speed = \"10 rad/s\"\nstart_angle = \"0 deg\"", "drive = \"crank\"", output)
            .replace("[\"50 mm\"", "[\"a + b\"");
    let built = build_text(&text);
    let [a, b] = ["parameter.a", "parameter.b"].map(|path| scatter(&built, path, 1e-5));
    for (linear, deviation_m) in [(-1.0, 0.0), (0.0, 2.0_f64.sqrt() * 1e-5), (1.0, 2e-5)] {
        let correlations = vec![ScatterCorrelation { first: a.quantity, second: b.quantity, linear }];
        let plan = MotionPlan { scatter: vec![a, b], correlations, ..plan(&built, 24) };
        let record = motion(&built.mechanism, &built.values, &plan).expect("it turns");
        let path = &record.paths[0];
        for k in 0..path.positions() {
            let due = (-2.0 * 0.05_f64.ln()).sqrt() * deviation_m;
            // The length is radial: all of it across a circle, along the crank.
            assert!((path.scatter_major_m[k] - due).abs() < 1e-12, "{linear} {k}: {}", path.scatter_major_m[k]);
            if deviation_m > 0.0 {
                let [x, y] = [path.x_m[k], path.y_m[k]];
                let (sine, cosine) = path.scatter_angle_rad[k].sin_cos();
                assert!((x * sine - y * cosine).abs() < 1e-9, "the axis points along the crank");
            }
        }
    }
}
