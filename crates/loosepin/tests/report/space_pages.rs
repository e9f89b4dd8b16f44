//! The page and the picture of a motion in space: points of the picture are those of the mechanism, and the page has all numbers.

use loosepin::report::{Figure, figures, motion_page, motion_picture, motion_sentences, motion_text};
use loosepin::result::motion::MotionRecord;
use loosepin::space::SpatialModel;

const SLIDER_CRANK: &str = include_str!("../../../../docs/examples/spatial-slider-crank.toml");
const FOUR_BAR: &str = include_str!("../../../../docs/examples/rssr-four-bar.toml");

/// Coordinates of a picture of some 500 mm have three places.
const WRITTEN_MM: f64 = 0.002;

fn record(text: &str) -> MotionRecord {
    let model = SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    model.motion_record(&model.quantities.nominal()).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// Where the crank pin and the slider are, mm, by the closed form of the example.
fn pin_and_slider(angle: f64) -> [[f64; 3]; 2] {
    let pin = [0.0, 100.0 - 80.0 * angle.sin(), 120.0 + 80.0 * angle.cos()];
    [pin, [(300.0 * 300.0 - pin[1] * pin[1] - pin[2] * pin[2]).sqrt(), 0.0, 0.0]]
}

/// Ends of the lines of a class in a part of a picture.
fn line_ends(svg: &str, class: &str) -> Vec<[f64; 2]> {
    let mut ends = Vec::new();
    for path in svg.split("<path ").skip(1) {
        if !path.starts_with(&format!("class=\"{class} ")) {
            continue;
        }
        let d = path.split(" d=\"").nth(1).and_then(|rest| rest.split('"').next()).unwrap();
        for point in d.trim_start_matches('M').split('L') {
            let (x, y) = point.split_once(' ').unwrap();
            ends.push([x.parse().unwrap(), y.parse().unwrap()]);
        }
    }
    ends
}

fn has(ends: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    ends.iter().any(|own| (own[0] - x).abs() < WRITTEN_MM && (own[1] - y).abs() < WRITTEN_MM)
}

#[test]
fn analytic_ends_of_bars_are_the_projected_positions() {
    let record = record(SLIDER_CRANK);
    let angle = record.drive_angle_rad[record.outputs[0].clearance.searched[0].position];
    let [pin, slider] = pin_and_slider(angle);
    let bearing = [0.0, 100.0, 120.0];
    // Isometric, written out: x goes right and down, y right and up, z up; a sheet has y down.
    let isometric = |[x, y, z]: [f64; 3]| [(x + y) / 2.0_f64.sqrt(), -(y - x + 2.0 * z) / 6.0_f64.sqrt()];
    let ends = line_ends(&motion_picture(&record), "bar");
    assert!(ends.len() > 8, "{ends:?}");
    for point in [bearing, pin, slider] {
        assert!(has(&ends, isometric(point)), "{point:?} {ends:?}");
    }
    // Front, side and top have their places on the sheet: the views differ from coordinates by a shift.
    let page = motion_page(&record);
    let views = figures(&page).into_iter().find(|figure| figure.name == "views").unwrap().to_svg(None);
    let groups: Vec<&str> = views.split("<g transform=\"translate(").skip(1).take(3).collect();
    let kept: [fn([f64; 3]) -> [f64; 2]; 3] = [|[x, y, _]| [x, -y], |[x, _, z]| [x, -z], |[_, y, z]| [y, -z]];
    for (group, flat) in groups.iter().zip(kept) {
        let ends = line_ends(group, "bar");
        assert!([bearing, pin, slider].into_iter().all(|point| has(&ends, flat(point))), "{ends:?}");
    }
    assert_eq!(groups.len(), 3);
}

#[test]
fn identity_a_body_that_turns_about_one_axis_has_that_turn_as_its_rotation_and_its_words() {
    let turn = record(FOUR_BAR);
    let rotation = record(&FOUR_BAR.replace("turn_of = \"rocker\"\nabout = \"skew\"", "orientation_of = \"rocker\""));
    let [of_turn, of_rotation] = [&turn.outputs[0], &rotation.outputs[0]];
    assert!(of_rotation.is_size() && !of_turn.is_size());
    for (turn, rotation) in of_turn.clearance.first_order_si.iter().zip(&of_rotation.clearance.first_order_si) {
        assert!((turn - rotation).abs() < 1e-12, "{turn} {rotation}");
    }
    // About the same axis, or against it.
    let [ends, same] = [of_rotation, of_turn].map(|output| output.clearance.searched[0].found_si);
    let is_same = |[up, down]: [f64; 2]| (ends[0] - up).abs() < 1e-10 && (ends[1] - down).abs() < 1e-10;
    assert!(is_same(same) || is_same([-same[1], -same[0]]), "{ends:?} {same:?}");
    let said = motion_sentences(&rotation).concat();
    assert!(
        said.contains("moves the rocker by up to") && said.contains("about the axis of the largest rotation"),
        "{said}"
    );
    let text = motion_text(&rotation);
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        text.contains("Of a rotation, the worst case is the largest angle that a search over axes found"),
        "{text}"
    );
    assert!(!text.contains("displacement"), "{text}");
}

#[test]
fn analytic_what_is_farther_is_drawn_earlier() {
    let record = record(FOUR_BAR);
    // Seen towards (1, -1, 1) the crank about the origin is behind the rocker's ball at (320, 0, ...) mm: its sign comes first.
    let svg = motion_picture(&record);
    let ball = svg.find("class=\"ball with-play").unwrap();
    assert!(svg.find("class=\"bearing").unwrap() < ball && svg.find("class=\"foot").unwrap() < ball);
}

/// A value as tables behind charts have it.
fn written(value: f64) -> String {
    format!("{value:.5e}").parse::<f64>().unwrap().to_string()
}

/// A column of the table behind a figure.
fn column(figures: &[Figure], name: &str, column: usize) -> Vec<String> {
    let figure = figures.iter().find(|figure| figure.name == name).unwrap_or_else(|| panic!("no figure {name}"));
    let csv = figure.to_csv().unwrap();
    csv.lines().skip(2).map(|line| line.split(',').nth(column).unwrap().to_owned()).collect()
}

#[test]
fn the_page_has_every_number_of_the_record() {
    for (text, output, per_si) in [(SLIDER_CRANK, "slider", 1e3), (FOUR_BAR, "rocker", 180.0 / std::f64::consts::PI)] {
        let record = record(text);
        let page = motion_page(&record);
        let figures = figures(&page);
        let own = &record.outputs[0];
        let answer = &own.clearance;
        let all = |values: &[f64], factor: f64| values.iter().map(|own| written(own * factor)).collect::<Vec<_>>();
        assert_eq!(column(&figures, &format!("position.{output}"), 1), all(&own.value_si, per_si));
        let clearance = format!("clearance.{output}");
        assert_eq!(column(&figures, &clearance, 2), all(&answer.first_order_si, per_si));
        assert_eq!(column(&figures, &clearance, 1), all(&answer.first_order_si, -per_si));
        assert_eq!(column(&figures, &clearance, 4), all(&answer.disc_standard_deviation_si, per_si));
        assert_eq!(column(&figures, &clearance, 0).len(), record.drive_angle_rad.len());
        // Four digits in sentences and tables.
        let rounded = |value: f64| {
            let value: f64 = format!("{:.3e}", value * per_si).parse().unwrap();
            let places = 3 - value.abs().log10().floor() as i32;
            format!("{value:.*}", places.max(0) as usize).replace('-', "−")
        };
        let searched = &answer.searched[0];
        let mut numbers = searched.found_si.to_vec();
        for own in &answer.contributors {
            let effects = [&own.first_order_si, &own.offset_si, &own.lean_si, &own.axial_si];
            numbers.extend(effects.into_iter().filter_map(|effect_si| effect_si.get(searched.position)));
        }
        for number in numbers {
            assert!(page.contains(&rounded(number)), "{}", rounded(number));
        }
    }
}

#[test]
fn a_model_without_play_says_so_and_text_of_files_is_escaped() {
    let text = FOUR_BAR.replace("radial_clearance = \"0.2 mm\"\n", "").replace("four-bar with two balls", "a <b> & c");
    let page = motion_page(&record(&text));
    assert!(
        page.contains("No joint has play and no part scatters: the motion is ideal.")
            && page.contains("a &lt;b&gt; &amp; c")
            && !page.contains("a <b>")
    );
    assert!(!page.contains("id=\"contributors\"") && !page.contains("clearance."), "there is no worst case");
}

#[test]
fn play_at_a_dead_centre_is_a_caveat() {
    let near = include_str!("../../../../docs/examples/rssr-near-dead-centre.toml");
    let record = record(&near.replace("speed = \"20 deg/s\"", "speed = \"60.8 deg/s\""));
    let [span] = &record.unproven_spans[..] else { panic!("{:?}", record.unproven_spans) };
    assert!(span.reaches_dead_centre && span.span_rad == [record.drive_angle_rad[12]; 2], "{span:?}");
    let sentence = "Worst cases are the largest found, without a proven end, at 1.00";
    let sentences = motion_sentences(&record);
    assert!(sentences[0].contains("first order, where play reaches a dead centre, at"), "{sentences:?}");
    assert!(sentences.iter().any(|own| own.starts_with(sentence) && own.contains("to a dead centre")), "{sentences:?}");
    let page = motion_page(&record);
    assert!(page.contains("more than what was found may be possible"));
    let text = motion_text(&record).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains(sentence) && text.contains("more than what was found may be possible"), "{text}");
    assert!(self::record(near).unproven_spans.is_empty());
}

#[test]
fn analytic_the_worst_regular_position_stands_beside_one_at_a_dead_centre() {
    let text = include_str!("../../../loosepin-simulate/tests/files/mend/dead_centre_in_space.toml");
    let record = record(text);
    let output = &record.outputs[0];
    let regular = output.clearance.searched.get(1).expect("the worst position is at a dead centre");
    // At 85° the rod's end is 49.81 mm above the guide: a rod that is 0.6 mm shorter still reaches it.
    let (r, l, c): (f64, f64, f64) = (0.05, 0.0505, 0.6e-3);
    let height = r * 85_f64.to_radians().sin();
    assert!((record.drive_angle_rad[regular.position].sin().abs() * r - height).abs() < 1e-12, "{}", regular.position);
    let at = |l: f64| (l * l - height * height).sqrt();
    let first_order = c * l / at(l);
    assert!((output.clearance.first_order_si[regular.position] / first_order - 1.0).abs() < 1e-9);
    for (found, due) in [(regular.found_si[1], at(l + c) - at(l)), (regular.found_si[0], at(l - c) - at(l))] {
        assert!((found / due - 1.0).abs() < 1e-6, "{found} {due}");
    }
    let words = "Where play comes near no dead centre, it moves the slider by up to ±3.642 mm (first order, at 85.0°); a search";
    let text = motion_text(&record).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains(words), "{text}");
    assert!(motion_page(&record).contains("Where play comes near no dead centre"));
}
