//! Geometry of pictures against closed forms and the positions of the kernel.

use loosepin_result::motion::MotionRecord;
use loosepin_result::spatial_picture::{PictureElement, PictureRole, PictureShape};
use loosepin_space::{Pose, Quaternion, SpatialModel, Vec3};

const SLIDER_CRANK: &str = include_str!("../../../../docs/examples/spatial-slider-crank.toml");
const FOUR_BAR: &str = include_str!("../../../../docs/examples/rssr-four-bar.toml");

fn record(text: &str) -> MotionRecord {
    let model = SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    model.motion_record(&model.quantities.nominal()).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (Vec3::from(a) - Vec3::from(b)).length()
}

fn elements<'r>(record: &'r MotionRecord, role: PictureRole, of: &'r str) -> impl Iterator<Item = &'r PictureElement> {
    record.picture.elements.iter().filter(move |element| element.role == role && element.of == of)
}

/// The ends of a bar in the ground, in a position.
fn bar(record: &MotionRecord, of: &str, sample: usize) -> [[f64; 3]; 2] {
    let element = elements(record, PictureRole::Bar, of).next().unwrap();
    let PictureShape::Line { points_m } = &element.shape else { panic!("{element:?}") };
    let pose = &record.picture.poses[sample][element.body];
    [pose.point_m(points_m[0]), pose.point_m(points_m[1])]
}

#[test]
fn identity_a_pose_of_a_picture_moves_points_as_the_kernel_does() {
    let turn = Quaternion::from_rotation_vector(Vec3::new(0.7, -1.3, 0.4));
    let pose = Pose::new(Vec3::new(0.3, -0.2, 1.1), turn);
    let drawn = loosepin_result::spatial_picture::PicturePose {
        at_m: pose.position_m.to_array(),
        turn: [turn.w, turn.vector.x, turn.vector.y, turn.vector.z],
    };
    let point = Vec3::new(-0.4, 0.9, 0.25);
    assert!(distance(drawn.point_m(point.to_array()), pose.point_m(point).to_array()) < 1e-15);
}

#[test]
fn analytic_bars_stand_where_the_slider_crank_is() {
    let record = record(SLIDER_CRANK);
    assert_eq!(record.picture.poses.len(), record.drive_angle_rad.len());
    for (sample, angle) in record.drive_angle_rad.iter().enumerate() {
        // The crank turns about x at (0, 100, 120) mm, straight up at 0.
        let pin = [0.0, 0.1 - 0.08 * angle.sin(), 0.12 + 0.08 * angle.cos()];
        let slider = [(0.09 - pin[1] * pin[1] - pin[2] * pin[2]).sqrt(), 0.0, 0.0];
        let [from, to] = bar(&record, "crank", sample);
        assert!(distance(from, [0.0, 0.1, 0.12]) < 1e-12 && distance(to, pin) < 1e-12, "{angle} {to:?}");
        let [from, to] = bar(&record, "rod", sample);
        assert!(distance(from, pin) < 1e-12 && distance(to, slider) < 1e-12, "{angle} {to:?}");
        let trace = &record.picture.traces[0];
        assert_eq!((trace.point.as_str(), trace.output.as_deref()), ("slider.pin", Some("slider")));
        assert!(distance(trace.at_m[sample], slider) < 1e-12);
    }
    let joint = &record.picture.joints[0];
    assert_eq!((joint.name.as_str(), joint.kind.as_str(), joint.has_play), ("main", "revolute", true));
    assert!(distance(joint.axis, [1.0, 0.0, 0.0]) < 1e-15 && distance(joint.at_m, [0.0, 0.1, 0.12]) < 1e-15);
}

#[test]
fn analytic_a_bearing_is_as_long_as_in_the_file_and_rails_reach_as_far_as_the_slider() {
    let record = record(SLIDER_CRANK);
    let bearing = elements(&record, PictureRole::Bearing, "main").next().unwrap();
    let PictureShape::Cylinder { ends_m: [from, to], .. } = &bearing.shape else { panic!("{bearing:?}") };
    assert!(distance(*from, [-0.01, 0.1, 0.12]) < 1e-15 && distance(*to, [0.01, 0.1, 0.12]) < 1e-15);
    assert!(bearing.has_play && bearing.body == 0);
    // The slider is farthest where the pin is nearest to the guide, and the other way round.
    let away = (0.1_f64 * 0.1 + 0.12 * 0.12).sqrt();
    let places = [away + 0.08, away - 0.08].map(|off| (0.09 - off * off).sqrt());
    let rails: Vec<&PictureElement> = elements(&record, PictureRole::Guide, "guide").collect();
    assert_eq!(rails.len(), 2);
    for rail in rails {
        let PictureShape::Line { points_m } = &rail.shape else { panic!("{rail:?}") };
        let beyond = 0.2 * record.picture.extent_m;
        assert!(points_m[0][0] < places[0] && points_m[0][0] > places[0] - beyond, "{points_m:?}");
        assert!(points_m[1][0] > places[1] && points_m[1][0] < places[1] + beyond, "{points_m:?}");
    }
    assert!(elements(&record, PictureRole::Ball, "crankpin").next().is_some_and(|ball| !ball.has_play));
    // A foot for the bearing, one at either end of the guide.
    let feet = record
        .picture
        .elements
        .iter()
        .filter(|element| element.role == PictureRole::Foot && matches!(element.shape, PictureShape::Face { .. }));
    assert_eq!(feet.count(), 3);
}

#[test]
fn analytic_an_arrow_goes_the_way_of_its_drive() {
    let turned = |text: &str| {
        let record = record(text);
        let arrow = elements(&record, PictureRole::Drive, "main").next().unwrap();
        let PictureShape::Line { points_m } = &arrow.shape else { panic!("{arrow:?}") };
        let centre = Vec3::from(record.picture.joints[0].at_m);
        let [a, b] = [0, 1].map(|k| Vec3::from(points_m[k]) - centre);
        a.cross(b).dot(Vec3::from(record.picture.joints[0].axis))
    };
    assert!(turned(SLIDER_CRANK) > 0.0);
    assert!(turned(&SLIDER_CRANK.replace("\"60 rpm\"", "\"-60 rpm\"")) < 0.0);
}

/// The slider moves along x alone, so that its zone is the worst case of first order to either side.
#[test]
fn identity_a_zone_reaches_as_far_as_the_worst_case_of_first_order() {
    let record = record(SLIDER_CRANK);
    let trace = &record.picture.traces[0];
    for zone in &trace.zones {
        let worst = record.outputs[0].clearance.first_order_si[zone.sample];
        let reach = zone.boundary_m.iter().map(|own| own[0]).fold(0.0, f64::max);
        let across = zone.boundary_m.iter().map(|own| own[1].hypot(own[2])).fold(0.0, f64::max);
        assert!((reach - worst).abs() < 1e-12 * worst && across < 1e-12, "{reach} {worst} {across}");
    }
    let worst = &trace.zones[trace.worst_zone.unwrap()];
    assert_eq!(worst.sample, record.outputs[0].clearance.searched[0].position);
    // The rocker turns about its axis: no point is an output, so the paths are those of the joints between moving bodies, without zones.
    let four_bar = self::record(FOUR_BAR);
    let points: Vec<&str> = four_bar.picture.traces.iter().map(|trace| trace.point.as_str()).collect();
    assert_eq!(points, ["crankpin", "ball"]);
    assert!(four_bar.picture.traces.iter().all(|trace| trace.zones.is_empty() && trace.output.is_none()));
}

/// The pivot has no play, so that the ball of the rocker stays on its circle about the skew axis.
#[test]
fn analytic_a_point_on_a_circle_has_one_direction_to_go() {
    let text =
        FOUR_BAR.replace("turn_of = \"rocker\"\nabout = \"skew\"", "position_of = \"rocker.ball\"\nalong = \"z\"");
    let record = record(&text);
    let trace = &record.picture.traces[0];
    assert!(!trace.zones.is_empty());
    for zone in &trace.zones {
        let [axis, arm] = [Vec3::new(0.6, 0.8, 0.0), Vec3::from(trace.at_m[zone.sample]) - Vec3::new(0.22, 0.04, 0.06)];
        let along = axis.cross(arm).normalised().unwrap();
        for own in &zone.boundary_m {
            let own = Vec3::from(*own);
            assert!((own - along * along.dot(own)).length() < 1e-12, "{own:?}");
        }
    }
}
