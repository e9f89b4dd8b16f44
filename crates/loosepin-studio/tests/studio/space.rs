//! Mechanisms in space: seen with their bands, their numbers and plays changed, their links left to the text.

use crate::client::{Live, Server};
use loosepin::templates::{SPATIAL_TEMPLATES, Template, find_template};
use serde_json::{Value, json};

const PATHS: [&str; 2] = ["m/model.toml", "m/study.toml"];

fn texts(model: &str, study: &str) -> Value {
    json!({ "model": { "path": PATHS[0], "text": model }, "study": { "path": PATHS[1], "text": study } })
}

/// Both texts after changes in units of UTF-16; these texts have letters of one unit alone.
fn changed(texts: [&str; 2], changes: &Value) -> [String; 2] {
    let mut new = texts.map(str::to_owned);
    for change in changes.as_array().unwrap().iter().rev() {
        let text = &mut new[usize::from(change["document"] == "study")];
        let [from, to] = ["from", "to"].map(|end| change[end].as_u64().unwrap() as usize);
        let units: Vec<u16> = text.encode_utf16().collect();
        let [before, after] = [&units[..from], &units[to..]].map(|part| String::from_utf16(part).unwrap());
        *text = format!("{before}{}{after}", change["insert"].as_str().unwrap());
    }
    new
}

fn known(server: &Server, texts_now: [&str; 2], path: &str, text: &str) -> Result<[String; 2], String> {
    let mut body = texts(texts_now[0], texts_now[1]);
    body["path"] = path.into();
    body["text"] = text.into();
    let (status, answer) = server.ask("POST", "/api/set-uncertainty", &body.to_string());
    assert_eq!(status, 200, "{answer}");
    match answer["refusal"]["message"].as_str() {
        Some(message) => Err(message.to_owned()),
        None => Ok(changed(texts_now, &answer["changes"])),
    }
}

fn largest(live: &mut Live, seq: u64, texts: &[String; 2]) -> f64 {
    let seen = live.look(seq, (PATHS[0], &texts[0]), Some((PATHS[1], &texts[1])));
    seen["view"]["bands"][0]["largest_value"].as_f64().unwrap_or_else(|| panic!("{}", seen["diagnostics"]))
}

fn owned(template: &Template) -> [String; 2] {
    [template.model.to_owned(), template.study.to_owned()]
}

#[test]
fn every_template_in_space_is_drawn_with_its_bands() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    for (seq, template) in (1..).zip(SPATIAL_TEMPLATES) {
        let seen = live.look(seq, (PATHS[0], template.model), Some((PATHS[1], template.study)));
        let errors = seen["diagnostics"].as_array().unwrap().iter().filter(|one| one["severity"] == "error");
        assert_eq!(errors.count(), 0, "{}: {}", template.name, seen["diagnostics"]);
        let view = &seen["view"];
        assert!(view["drawing"].is_null(), "{}", template.name);
        let scene: Value = serde_json::from_str(view["space"]["scene"].as_str().unwrap()).unwrap();
        let inputs = scene["inputs"].as_array().unwrap().len();
        assert!(inputs > 12 && scene["poses"].as_array().unwrap().len() == inputs, "{}", template.name);
        assert!(!view["bands"].as_array().unwrap().is_empty(), "{}", template.name);
        assert!(view["mobility"].as_str().unwrap().contains("degree"), "{}: {}", template.name, view["mobility"]);
        for band in view["bands"].as_array().unwrap() {
            let shares: f64 =
                band["parts"].as_array().unwrap().iter().map(|part| part["share"].as_f64().unwrap()).sum();
            assert!((shares - 1.0).abs() < 1e-9, "{}: {shares}", template.name);
        }
    }
}

#[test]
fn the_gallery_has_a_card_of_every_template_in_space() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let (_, cards) = server.ask("GET", "/api/templates", "");
    for template in SPATIAL_TEMPLATES {
        let card = cards.as_array().unwrap().iter().find(|card| card["name"] == template.name).unwrap();
        assert!(card["drawing"].is_null() && card["space"]["svg"].as_str().unwrap().contains("<svg"), "{card}");
    }
}

/// The worst case of balls is Σ c |g|, and ±2 standard deviations of the parts come on top.
#[test]
fn analytic_the_band_follows_plays_and_tolerances_that_are_typed() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    let first = owned(find_template("spatial-four-bar").unwrap());
    let now = |texts: &[String; 2]| -> [String; 2] { texts.clone() };
    let typed = |texts: &[String; 2], path: &str, text: &str| {
        known(&server, [&texts[0], &texts[1]], path, text).unwrap_or_else(|found| panic!("{path} {text}: {found}"))
    };
    // Ideal parts, and no play but that of one ball.
    let mut exact = now(&first);
    for (path, value) in [
        ("parameter.crank_length", "50 mm"),
        ("parameter.coupler_length", "250 mm"),
        ("parameter.rocker_length", "120 mm"),
        ("joint.rocker_ball.radial_clearance", "0 mm"),
    ] {
        exact = typed(&exact, path, value);
    }
    let single = largest(&mut live, 1, &exact);
    let unknown = typed(&exact, "joint.crank_ball.radial_clearance", "0.1..0.3 mm");
    assert!(unknown[1].contains("\"joint.crank_ball.radial_clearance\" = { interval = [\"0.1 mm\", \"0.3 mm\"] }"));
    // Taken where there is most play.
    let tripled = largest(&mut live, 2, &unknown);
    assert!((tripled / single - 3.0).abs() < 1e-6, "{single} {tripled}");
    let scattering = typed(&exact, "parameter.rocker_length", "sd 0.1 mm");
    let twice = typed(&exact, "parameter.rocker_length", "sd 0.2 mm");
    // With play P at each position and scatter S, the band is P + 2 S: it grows as S does where both are largest together.
    let [with, more] = [largest(&mut live, 3, &scattering), largest(&mut live, 4, &twice)];
    assert!(with > single && more > with, "{single} {with} {more}");
    let both = live.look(5, (PATHS[0], &twice[0]), Some((PATHS[1], &twice[1])));
    let parts = both["view"]["bands"][0]["parts"].as_array().unwrap();
    assert!(parts.iter().any(|part| part["name"] == "parameter.rocker_length" && part["kind"] == "part"), "{parts:?}");
}

#[test]
fn an_ideal_joint_gets_play_with_the_length_of_its_bearing() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    let first = owned(find_template("spatial-four-bar").unwrap());
    let before = largest(&mut live, 1, &first);
    let path = "joint.pivot.radial_clearance";
    let new = known(&server, [&first[0], &first[1]], path, "0.05 mm").unwrap();
    let table = new[0].split("[joint.pivot]").nth(1).unwrap().split('[').next().unwrap();
    assert!(
        table.contains("radial_clearance = \"0.05 mm\"") && table.contains("bearing_length = \"20 mm\""),
        "{table}"
    );
    let after = largest(&mut live, 2, &new);
    assert!(after > before, "{before} {after}");
    let refused = known(&server, [&first[0], &first[1]], "joint.nothing.radial_clearance", "0.05 mm").unwrap_err();
    assert!(refused.contains("joint.nothing"), "{refused}");
}

#[test]
fn links_of_a_mechanism_in_space_are_left_to_the_text() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let template = find_template("bricard").unwrap();
    let mut body = texts(template.model, template.study);
    body["edit"] = json!({ "kind": "remove", "what": { "table": "joint", "name": "none" } });
    let (status, answer) = server.ask("POST", "/api/restructure", &body.to_string());
    assert_eq!(status, 200);
    let message = answer["refusal"]["message"].as_str().unwrap();
    assert!(message.contains("in space"), "{message}");
}

#[test]
fn a_wrong_text_of_a_mechanism_in_space_is_shown_at_its_place() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let template = find_template("spatial-four-bar").unwrap();
    let model = template.model.replace("coupler_length = \"250 mm\"", "coupler_length = \"100 mm\"");
    let seen = server.live().look(1, (PATHS[0], &model), Some((PATHS[1], template.study)));
    assert!(seen["view"].is_null());
    let said = &seen["diagnostics"][0];
    assert!(said["message"].as_str().unwrap().contains("close"), "{said}");
    assert!(said["path"].as_str().unwrap().ends_with("model.toml"), "{said}");
}
