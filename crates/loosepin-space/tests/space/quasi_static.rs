//! Worst cases and standard deviations against independent programs, 12 digits.

use crate::build::{turning, v};
use crate::known;
use loosepin_space::{
    DriveValue, Gains, JointCoordinate, JointOutput, MarkerScatter, MarkerSide, PlayDistribution, PoseAccuracy,
    RevolutePlay, RotationSineOutput, SearchOptions, SpatialMechanism, SpatialOutput, SpatialPlay, SphericalPlay,
    UprightPlay, Vec3, assemble, cycle,
};

/// First order, exact plus and minus, standard deviation inside.
type Row = [f64; 4];

/// Relative departure of twelve digits.
const TWELVE_DIGITS: f64 = 2e-11;

fn at_input(mechanism: &SpatialMechanism, degrees: f64) -> loosepin_space::Position {
    let input = degrees.to_radians();
    let steps = 12.0;
    let inputs: Vec<f64> = (0..=12).map(|k| input * f64::from(k) / steps).collect();
    let found = cycle(mechanism, &inputs, &turning);
    assert_eq!(found.stopped, None);
    found.positions.last().unwrap().clone()
}

fn close_to(found: f64, expected: f64, tolerance: f64) -> bool {
    (found - expected).abs() <= tolerance * expected.abs()
}

/// `first_digits` and `digits`: relative departure of the first order and of the exact values.
fn check(
    mechanism: &SpatialMechanism,
    degrees: f64,
    output: SpatialOutput,
    row: Row,
    [first_digits, digits]: [f64; 2],
) {
    let position = at_input(mechanism, degrees);
    let accuracy = PoseAccuracy::new(mechanism, &position).unwrap();
    let gains = accuracy.gains(&output).unwrap();
    let first = accuracy.first_order(&gains).unwrap();
    let exact = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
    let [worst, plus, minus, sigma] = row;
    assert!(close_to(first.worst, worst, first_digits), "{} {worst}", first.worst);
    assert!(close_to(first.reached, worst, first_digits), "{} {worst}", first.reached);
    assert!(close_to(exact.largest.deviation, plus, digits), "{} {plus}", exact.largest.deviation);
    assert!(close_to(exact.smallest.deviation, -minus, digits), "{} {minus}", exact.smallest.deviation);
    match accuracy.standard_deviation(&gains, PlayDistribution::Inside) {
        Some(found) => assert!(close_to(found, sigma, 1e-9), "{found} {sigma}"),
        None => assert!(accuracy.conditions() > 0),
    }
    for extreme in [&exact.largest, &exact.smallest] {
        let again = accuracy.displaced(&extreme.variables_m).unwrap();
        assert!(again.apart < 1e-12, "{}", again.apart);
        let deviation = accuracy.deviation(&output, &again.poses).unwrap();
        assert!(close_to(deviation, extreme.deviation, 1e-9), "{deviation}");
    }
}

fn slider_x(body: usize) -> SpatialOutput {
    SpatialOutput::displacement(body, Vec3::ZERO)[0]
}

#[test]
fn peer_ball_of_the_spatial_slider_crank() {
    let mechanism = known::rssp(None, Some(SphericalPlay { radial_clearance_m: 3e-4 }.into()));
    for (degrees, row) in [
        (0.0, [0.00045, 0.000449719381195, 0.000450281884439, 0.000201246118]),
        (60.0, [0.000357276764085, 0.000357202146092, 0.00035735159404, 0.0001597790263]),
        (120.0, [0.00031304318198, 0.000313029290973, 0.000313057103271, 0.000139997167]),
        (180.0, [0.000321428571429, 0.000321404819539, 0.000321452377913, 0.0001437472271]),
        (240.0, [0.000383958228353, 0.0003838359376, 0.000384080920399, 0.0001717113398]),
        (300.0, [0.000476039952307, 0.000475679560854, 0.000476402163229, 0.0002128915387]),
    ] {
        check(&mechanism, degrees, slider_x(3), row, [TWELVE_DIGITS; 2]);
        // s± = √((L ± c)² - B_y² - B_z²) - s
        let angle = f64::to_radians(degrees);
        let position = known::rssp_slider(angle, 0.3);
        for (length, expected) in [(0.3003, row[1]), (0.2997, -row[2])] {
            assert!(close_to(known::rssp_slider(angle, length) - position, expected, TWELVE_DIGITS));
        }
    }
}

#[test]
fn peer_ball_of_the_four_bar_with_two_balls() {
    let mechanism = known::rssr(Some(SphericalPlay { radial_clearance_m: 2e-4 }.into()));
    let output = JointOutput { joint: 3, coordinate: JointCoordinate::Angle }.into();
    for (degrees, row) in [
        (0.0, [0.00369133289675, 0.00368635335811, 0.00369634826833, 0.001650814257]),
        (60.0, [0.00249754140399, 0.00249604206441, 0.00249904714827, 0.001116934471]),
        (120.0, [0.00212061179229, 0.00212050584353, 0.00212072076969, 0.0009483664243]),
        (180.0, [0.00264375803443, 0.00264547898987, 0.00264205042766, 0.001182324536]),
        (240.0, [0.00327763286554, 0.00328028904509, 0.00327500118438, 0.001465801979]),
        (300.0, [0.00342078184468, 0.00341951301497, 0.00342206387897, 0.001529820148]),
    ] {
        check(&mechanism, degrees, output, row, [TWELVE_DIGITS; 2]);
    }
}

#[test]
fn peer_crank_bearing_that_lets_the_crank_lean() {
    let play = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 1e-4, axial_clearance_m: 2e-4 };
    let mechanism = known::rssp(Some(play.into()), None);
    for (degrees, row) in [
        (0.0, [0.00100158563062, 0.00100750216977, 0.000995623347743, 0.0003080516732]),
        (60.0, [0.00100233175353, 0.00100356828715, 0.00100106211134, 0.0003063595991]),
        (120.0, [0.00100022001727, 0.000998794208364, 0.00100157031546, 0.0003056867504]),
        (180.0, [0.0010007970506, 0.000999912194918, 0.00100161805895, 0.0003058075903]),
        (240.0, [0.001002699197, 0.00100536901271, 0.00100000415992, 0.0003068075745]),
        (300.0, [0.00100051991956, 0.00100765280444, 0.000993318702076, 0.0003085947999]),
    ] {
        check(&mechanism, degrees, slider_x(3), row, [TWELVE_DIGITS; 2]);
    }
}

#[test]
fn peer_gains_of_the_crank_bearing() {
    // Angle, gain of a ball at the wrist, planar gain, gain with lean; axial play apart. Independent program, 6 digits behind the point.
    for (degrees, ball, planar, leaning) in [
        (0.0, 1.5, 1.118034, 8.015856),
        (60.0, 1.190923, 0.646758, 8.023318),
        (120.0, 1.043477, 0.298068, 8.002200),
        (180.0, 1.071429, 0.384655, 8.007971),
        (300.0, 1.586800, 1.232045, 8.005199),
    ] {
        let clearance = 1e-4;
        let wrist = SphericalPlay { radial_clearance_m: clearance }.into();
        let leaning_play =
            RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: clearance, axial_clearance_m: 0.0 }.into();
        let upright = UprightPlay { radial_clearance_m: clearance, axial_clearance_m: 0.0 }.into();
        let plays: [(Option<SpatialPlay>, Option<SpatialPlay>, f64); 3] =
            [(None, Some(wrist), ball), (Some(upright), None, planar), (Some(leaning_play), None, leaning)];
        for (bearing, wrist, expected) in plays {
            let mechanism = known::rssp(bearing, wrist);
            let position = at_input(&mechanism, degrees);
            let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
            let gains = accuracy.gains(&slider_x(3)).unwrap();
            let found = accuracy.first_order(&gains).unwrap().worst / clearance;
            assert!((found - expected).abs() < 6e-7, "{degrees}: {found} {expected}");
            if expected == leaning {
                let journal = gains.journal(0, 0.02).unwrap();
                let displacement = journal.displacement[0].hypot(journal.displacement[1]);
                assert!((displacement - planar).abs() < 6e-7);
            }
        }
    }
}

#[test]
fn peer_gudgeon_that_leans_in_an_overconstrained_loop() {
    let play = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 2e-4, axial_clearance_m: 1e-4 };
    let mechanism = known::leaning_slider_crank(Some(play.into()));
    let drawn = v(0.05 + 0.06, 0.0, 0.05);
    let rod_z = SpatialOutput::displacement(2, drawn)[2];
    let across = f64::NAN;
    for (degrees, row) in [
        (0.0, [0.0002, 0.000200000000003, 0.0002, across]),
        (60.0, [0.000214448184772, 0.000214421483415, 0.000214474988654, across]),
        (120.0, [0.000214448184772, 0.000214421483415, 0.000214474988654, across]),
        (240.0, [0.000214448184772, 0.000214421483415, 0.000214474988653, across]),
    ] {
        check(&mechanism, degrees, slider_x(3), row, [TWELVE_DIGITS, 1e-10]);
    }
    for (degrees, row) in [
        (0.0, [5.00000000063e-05, 5.00834027655e-05, 6.00069999999e-05, across]),
        (60.0, [5.00000000063e-05, 5.00834027306e-05, 6.00069999999e-05, across]),
        (120.0, [5.00000000063e-05, 5.00834027668e-05, 6.00070000006e-05, across]),
        (240.0, [5.00000000063e-05, 5.00834027646e-05, 6.00069999999e-05, across]),
    ] {
        // The other program minimises numerically: its digits are good to 1e-9 here, as its values for equal poses show.
        check(&mechanism, degrees, rod_z, row, [1e-9, 1e-9]);
        let position = at_input(&mechanism, degrees);
        let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
        assert_eq!((position.rank, position.redundant_rows(), accuracy.conditions()), (18, 1, 1));
        let gains = accuracy.gains(&rod_z).unwrap();
        // Any multipliers bound the worst case from above.
        let first = accuracy.first_order(&gains).unwrap();
        assert!(first.worst < 0.99 * accuracy.unconditioned_worst(&gains));
        assert_eq!(first.multipliers.len(), 1);
    }
}

fn rotation_sine(body: usize) -> [SpatialOutput; 3] {
    Vec3::AXES.map(|axis| RotationSineOutput { body, axis }.into())
}

#[test]
fn peer_spherical_platform_of_three_legs() {
    let mechanism = known::platform();
    let position = assemble(&mechanism, &[DriveValue::default(); 3]).unwrap();
    assert_eq!((position.rank, position.redundant_rows(), position.free_motions()), (42, 0, 0));
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let rows: [Row; 6] = [
        [0.00154480471314, 0.00154467592577, 0.001545575671, 0.0002186202663],
        [0.00148429780065, 0.00148466485988, 0.00148405041789, 0.0001946175394],
        [0.0011640177082, 0.00116257605667, 0.00116548259219, 0.000142604361],
        [0.0087616245097, 0.0088085556165, 0.0087156532712, 0.001291594124],
        [0.00843637093659, 0.00845650583574, 0.00841649237986, 0.001155276154],
        [0.00661063519065, 0.00662108037524, 0.00660024386618, 0.0008449524682],
    ];
    let outputs: Vec<SpatialOutput> =
        SpatialOutput::displacement(7, Vec3::ZERO).into_iter().chain(rotation_sine(7)).collect();
    for (output, [worst, plus, minus, sigma]) in outputs.iter().zip(rows) {
        let gains = accuracy.gains(output).unwrap();
        let first = accuracy.first_order(&gains).unwrap();
        assert!(close_to(first.worst, worst, TWELVE_DIGITS), "{} {worst}", first.worst);
        let found = accuracy.standard_deviation(&gains, PlayDistribution::Inside).unwrap();
        assert!(close_to(found, sigma, 1e-9), "{found} {sigma}");
        let exact = accuracy.worst_case(output, &SearchOptions::default()).unwrap();
        assert!(close_to(exact.largest.deviation, plus, TWELVE_DIGITS), "{} {plus}", exact.largest.deviation);
        assert!(close_to(exact.smallest.deviation, -minus, TWELVE_DIGITS), "{} {minus}", exact.smallest.deviation);
    }
    // Gains of the centre's height by each leg's base bearing, |g_e|, |g_w|, g_α.
    let height = accuracy.gains(&outputs[2]).unwrap();
    let base = [0.10021247057200382_f64, 0.1561211821449844, -0.020042494114401326, -0.03122423642899694];
    let journal = height.journal(0, 0.02).unwrap();
    let size = |pair: [f64; 2]| pair[0].hypot(pair[1]);
    assert!(close_to(size(journal.displacement), size([base[0], base[1]]), 1e-12));
    assert!(close_to(size(journal.slope), size([base[2], base[3]]), 1e-12));
    assert!(close_to(journal.axial.abs(), 0.37399803172671947, 1e-12));
    // The centre and the rotation as vectors.
    let all: Vec<Gains> = outputs.iter().map(|output| accuracy.gains(output).unwrap()).collect();
    for (components, largest, sigma) in
        [(&all[..3], 0.00186153346251, 0.000325586872), (&all[3..], 0.0105707381902, 0.001927906389)]
    {
        let found = accuracy.largest_norm(components).unwrap();
        assert!(close_to(found.largest, largest, TWELVE_DIGITS), "{} {largest}", found.largest);
        let deviations = components.iter().map(|gains| accuracy.standard_deviation(gains, PlayDistribution::Inside));
        let trace: f64 = deviations.map(|deviation| deviation.unwrap().powi(2)).sum();
        assert!(close_to(trace.sqrt(), sigma, 1e-9));
    }
    // Two angles of each of nine axes, 0.01 degrees.
    let sigma = 0.01_f64.to_radians();
    let turning_rad = v(sigma, sigma, 0.0);
    let scatter: Vec<MarkerScatter> = (0..9)
        .map(|joint| MarkerScatter { joint, side: MarkerSide::Bearing, turning_rad, displacement_m: Vec3::ZERO })
        .collect();
    let expected = [5.36419326e-05, 4.773188842e-05, 3.498102612e-05, 0.000318800083, 0.0002851531506, 0.0002085569391];
    for (gains, expected) in all.iter().zip(expected) {
        let found = accuracy.scatter(gains, &scatter);
        assert!(close_to(found, expected, 1e-9), "{found} {expected}");
    }
}

/// The longest displacement is the farthest one over all directions: none of a fine grid goes farther, and its own goes as far.
#[test]
fn identity_no_direction_goes_farther_than_the_longest_displacement() {
    const DIRECTIONS: usize = 4000;
    let pin = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 2e-4, axial_clearance_m: 4e-4 };
    let ball = SphericalPlay { radial_clearance_m: 3e-4 };
    let free = known::rssp(Some(pin.into()), Some(ball.into()));
    let under_condition = known::leaning_slider_crank(Some(pin.into()));
    let platform = known::platform();
    let held = assemble(&platform, &[DriveValue::default(); 3]).unwrap();
    for (mechanism, body) in [(&free, 1), (&under_condition, 2), (&platform, 7)] {
        for degrees in [20.0, 60.0] {
            let position = if body == 7 { held.clone() } else { at_input(mechanism, degrees) };
            let accuracy = PoseAccuracy::new(mechanism, &position).unwrap();
            for point in [v(0.11, 0.0, 0.05), v(-0.02, 0.13, 0.01)] {
                let components = SpatialOutput::displacement(body, point);
                let gains: Vec<Gains> = components.iter().map(|output| accuracy.gains(output).unwrap()).collect();
                let longest = accuracy.largest_norm(&gains).unwrap();
                let directions: Vec<Vec3> = (0..DIRECTIONS)
                    .map(|k| {
                        let z = (k as f64 + 0.5) / DIRECTIONS as f64;
                        let (sine, cosine) = (2.399_963_229_728_653 * k as f64).sin_cos();
                        let across = (1.0 - z * z).sqrt();
                        v(across * cosine, across * sine, z)
                    })
                    .collect();
                let farthest = accuracy.farthest(&gains, &directions).unwrap();
                let most = farthest.iter().map(|own| own.length()).fold(0.0, f64::max);
                assert!(most <= longest.largest * (1.0 + 1e-12), "{most} {}", longest.largest);
                let own = Vec3::from(<[f64; 3]>::try_from(longest.direction.as_slice()).unwrap());
                let reached = accuracy.farthest(&gains, &[own]).unwrap()[0];
                assert!(close_to(reached.dot(own), longest.largest, 1e-12), "{reached:?} {longest:?}");
            }
        }
    }
}

#[test]
fn peer_standard_deviation_of_the_gudgeon_under_its_condition() {
    // Quadrature of an independent program: 95.44616 and 28.82626 µm.
    let play = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 2e-4, axial_clearance_m: 1e-4 };
    let mechanism = known::leaning_slider_crank(Some(play.into()));
    let position = at_input(&mechanism, 60.0);
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let rod_z = SpatialOutput::displacement(2, v(0.11, 0.0, 0.05))[2];
    for (output, expected) in [(slider_x(3), 95.44616e-6), (rod_z, 28.82626e-6)] {
        let found = accuracy.sampled_deviation(&accuracy.gains(&output).unwrap(), 200_000, 3);
        assert!(found.standard_error < 0.01 * expected, "{}", found.standard_error);
        let off = (found.standard_deviation - expected).abs() / found.standard_error;
        assert!(off < 4.0, "{} is {off} standard errors off", found.standard_deviation);
    }
    // Without conditions it is the closed form.
    let mechanism = known::rssp(Some(play.into()), Some(SphericalPlay { radial_clearance_m: 3e-4 }.into()));
    let position = at_input(&mechanism, 60.0);
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let gains = accuracy.gains(&slider_x(3)).unwrap();
    let expected = accuracy.standard_deviation(&gains, PlayDistribution::Inside).unwrap();
    let found = accuracy.sampled_deviation(&gains, 200_000, 3);
    assert!((found.standard_deviation - expected).abs() < 4.0 * found.standard_error);
    assert!(found.standard_error < 0.01 * expected);
}
