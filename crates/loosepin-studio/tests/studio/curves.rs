//! Curves over the angle of the drive, and paths of traced points.

use crate::client::Server;
use loosepin::templates::find_template;
use serde_json::{Value, json};

/// Values of a curve have six digits: half a unit of the last one is at most so much of the value.
const SHARE_OF_LARGEST: f64 = 5.1e-6;

fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().expect("a list").iter().map(|value| value.as_f64().expect("a number")).collect()
}

fn key(quantity: &str, of: &str) -> Value {
    json!({ "curve": { "quantity": quantity, "of": of } })
}

fn line<'v>(view: &'v Value, words: &str) -> &'v Value {
    let lines = view["curve"]["lines"].as_array().expect("lines");
    &lines.iter().find(|line| line["words"] == words).unwrap_or_else(|| panic!("{words} in {lines:?}"))["values"]
}

#[test]
fn analytic_the_curves_of_a_slider_are_those_of_its_closed_form() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    let model = ("model.toml", find_template("slider-crank").unwrap().model);
    let (crank_m, rod_m, speed_rad_s) = (0.05_f64, 0.12_f64, 5000.0 * std::f64::consts::TAU / 60.0);
    let [position, velocity, advantage] = [
        ("position", "ideal position"),
        ("velocity", "ideal velocity"),
        ("mechanical_advantage", "mechanical advantage"),
    ]
    .map(|(quantity, words)| {
        let seen = live.look_for(1, model, None, key(quantity, "slider"));
        let view = &seen["view"];
        assert_eq!(view["curve"]["key"], key(quantity, "slider")["curve"]);
        assert!(view["curve"]["figure"].as_str().is_some_and(|figure| figure.starts_with("<svg xmlns=")));
        let angles = numbers(&view["drawing"]["motion"]["angle_deg"]);
        let values: Vec<f64> =
            line(view, words).as_array().unwrap().iter().map(|v| v.as_f64().unwrap_or(f64::INFINITY)).collect();
        assert_eq!(angles.len(), values.len());
        (angles, values, view["curve"]["unit"].as_str().unwrap().to_owned())
    });
    assert_eq!([&position.2, &velocity.2, &advantage.2], ["mm", "m/s", "1/m"]);
    let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    for (at, angle_deg) in position.0.iter().enumerate() {
        let (sine, cosine) = angle_deg.to_radians().sin_cos();
        let reach_m = (rod_m.powi(2) - (crank_m * sine).powi(2)).sqrt();
        let due_mm = 1e3 * (crank_m * cosine + reach_m);
        assert!((position.1[at] - due_mm).abs() < SHARE_OF_LARGEST * largest(&position.1), "{angle_deg}°");
        let per_speed_m = -crank_m * sine - crank_m.powi(2) * sine * cosine / reach_m;
        let due_m_s = speed_rad_s * per_speed_m;
        assert!((velocity.1[at] - due_m_s).abs() < SHARE_OF_LARGEST * largest(&velocity.1), "{angle_deg}°");
        // At a dead centre the force is beyond all limits, or as large as round-off lets it be.
        let due_per_m = 1.0 / per_speed_m.abs();
        let found = advantage.1[at];
        assert!(
            if due_per_m < 1e4 { (found - due_per_m).abs() < SHARE_OF_LARGEST * due_per_m } else { found > 1e4 },
            "{angle_deg}°: {found} {due_per_m}"
        );
    }
}

#[test]
fn curves_are_listed_and_one_is_drawn_where_one_is_wanted() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    let template = find_template("four-bar").unwrap().model;
    let text = format!("{template}\n[output.effort]\ntorque_of = \"drive.crank\"\n");
    let model = ("model.toml", text.as_str());
    let seen = live.look(1, model, None);
    assert_eq!(seen["diagnostics"], json!([]));
    assert!(seen["view"]["curve"].is_null(), "none is drawn that nobody wants");
    let choices: Vec<(String, String)> = seen["view"]["curves"]
        .as_array()
        .unwrap()
        .iter()
        .map(|choice| ["quantity", "of"].map(|part| choice["key"][part].as_str().unwrap().to_owned()).into())
        .collect();
    let due = [
        ("position", "rocker"),
        ("position", "tracer"),
        ("velocity", "rocker"),
        ("velocity", "tracer"),
        ("acceleration", "rocker"),
        ("acceleration", "tracer"),
        ("effort", "effort"),
        ("transmission_angle", "coupler and rocker"),
        ("mechanical_advantage", "rocker"),
        ("mechanical_advantage", "tracer"),
    ];
    assert_eq!(choices, due.map(|(quantity, of)| (quantity.to_owned(), of.to_owned())));
    for (quantity, of) in due {
        let seen = live.look_for(2, model, None, key(quantity, of));
        assert_eq!(seen["view"]["curve"]["key"], json!({ "quantity": quantity, "of": of }));
        // Another mechanism has other names.
        let seen = live.look_for(3, model, None, key(quantity, "nobody"));
        let first = due.iter().find(|choice| choice.0 == quantity).unwrap().1;
        assert_eq!(seen["view"]["curve"]["key"], json!({ "quantity": quantity, "of": first }));
    }
    // Without masses nothing is known of efforts.
    let seen = live.look_for(4, ("model.toml", template), None, key("effort", "effort"));
    assert!(seen["view"]["curve"].is_null() && seen["view"]["drawing"].is_object());
    // What does not move yet has no curves.
    let open = template.replace("[drive.crank]", "[drive.crank]\n#");
    let open = open.lines().filter(|line| !line.starts_with("joint = ")).collect::<Vec<_>>().join("\n");
    let seen = live.look_for(5, ("model.toml", &open), None, key("velocity", "rocker"));
    assert!(seen["view"].is_null() || seen["view"]["curves"] == json!([]));
}

#[test]
fn a_traced_point_has_its_path_its_zone_and_its_curves() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    let model = ("model.toml", find_template("four-bar").unwrap().model);
    let mut wanted = key("velocity", "rocker.pin");
    let points = ["rocker.pin", "nobody.tip", "no point", "coupler.crank_end"];
    wanted["traced"] = json!(points);
    let seen = live.look_for(1, model, None, wanted);
    assert_eq!(seen["diagnostics"], json!([]), "what is not there is left out");
    let view = &seen["view"];
    let paths = view["paths"].as_array().unwrap();
    let named: Vec<&str> = paths.iter().map(|path| path["point"].as_str().unwrap()).collect();
    assert_eq!(named, ["coupler.tracer", "rocker.pin", "coupler.crank_end"]);
    assert!(paths[0]["output"] == "tracer" && paths[1]["output"].is_null());
    // 16 directions at each of 73 poses. The play between coupler and rocker takes the rocker's pin along, and leaves the crank's where it is.
    let reach_mm = numbers(&paths[1]["play_reach_mm"]);
    assert_eq!(reach_mm.len(), 16 * 73);
    assert!(reach_mm.iter().any(|reach| *reach > 0.0));
    assert_eq!(paths[2]["play_reach_mm"], json!([]));
    // The pin turns about the pivot of the rocker: its speed is the rocker's angular velocity times the length, rpm times 120 mm.
    let [x, y, magnitude] = ["x", "y", "magnitude"].map(|part| numbers(line(view, part)));
    let seen = live.look_for(2, model, None, key("velocity", "rocker"));
    assert_eq!(seen["view"]["curve"]["unit"], "rpm");
    let rpm = numbers(line(&seen["view"], "ideal velocity"));
    let length_m = find_template("four-bar")
        .unwrap()
        .model
        .lines()
        .find_map(|line| line.strip_prefix("rocker_length = \"")?.split(' ').next()?.parse::<f64>().ok())
        .unwrap()
        / 1e3;
    let most = magnitude.iter().fold(0.0, |most: f64, value| most.max(*value));
    for at in 0..rpm.len() {
        let due_m_s = rpm[at].abs() * std::f64::consts::TAU / 60.0 * length_m;
        assert!((magnitude[at] - due_m_s).abs() < 2.0 * SHARE_OF_LARGEST * most, "{at}: {} {due_m_s}", magnitude[at]);
        assert!((x[at].hypot(y[at]) - magnitude[at]).abs() < SHARE_OF_LARGEST * most);
    }
}
