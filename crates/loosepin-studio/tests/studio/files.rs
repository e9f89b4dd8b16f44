//! Files of the served folder.

use crate::client::Server;
use serde_json::json;

#[test]
fn a_template_is_written_opened_changed_and_saved() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let new = json!({"template": "slider-crank", "folder": "mine"}).to_string();
    let (status, written) = server.ask("POST", "/api/new", &new);
    assert_eq!((status, &written["study"]), (200, &json!("mine/study.toml")));
    assert_eq!(server.ask("POST", "/api/new", &new).0, 409, "nothing is overwritten");
    let (status, opened) = server.ask("GET", "/api/open?path=mine%2Fstudy.toml", "");
    assert_eq!((status, &opened["model"]["path"]), (200, &json!("mine/model.toml")));
    let text = format!("{}# changed\n", opened["model"]["text"].as_str().unwrap());
    let saved = json!({"path": "mine/model.toml", "text": text, "tag": opened["model"]["tag"]}).to_string();
    let (status, tag) = server.ask("PUT", "/api/file", &saved);
    assert_eq!(status, 200, "{tag}");
    assert_eq!(std::fs::read_to_string(desk.path().join("mine/model.toml")).unwrap(), text);
    // The old tag is used up: somebody has changed the file since.
    let (status, refused) = server.ask("PUT", "/api/file", &saved);
    assert_eq!(status, 409, "{refused}");
    let (_, listing) = server.ask("GET", "/api/folder", "");
    let kinds: Vec<&str> =
        listing["files"].as_array().unwrap().iter().map(|file| file["kind"].as_str().unwrap()).collect();
    assert!(kinds.contains(&"model") && kinds.contains(&"study"), "{listing}");
}

#[test]
fn all_templates_are_there_and_move() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let (status, cards) = server.ask("GET", "/api/templates", "");
    assert_eq!((status, cards.as_array().unwrap().len()), (200, 25));
    let moving = |key: &str| cards.as_array().unwrap().iter().filter(|card| card[key]["svg"].is_string()).count();
    assert_eq!([moving("drawing"), moving("space")], [17, 8]);
}

#[test]
fn a_code_is_explained() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let (status, explained) = server.ask("GET", "/api/explain/E0302", "");
    assert!(status == 200 && explained["text"].as_str().unwrap().len() > 60, "{explained}");
    assert_eq!(server.ask("GET", "/api/explain/E9999", "").0, 404);
}

/// A crank of 30 mm on the ground, with its pin; the unit of lengths is left out.
const DRAWING: &str = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n1.5\n20\n2.5\n11\n31.5\n21\n2.5\n0\nCIRCLE\n8\nground\n10\n1.5\n20\n2.5\n\
    40\n4.5\n0\nCIRCLE\n8\n0\n10\n31.5\n20\n2.5\n40\n2.25\n0\nENDSEC\n0\nEOF\n";

#[test]
fn an_imported_drawing_becomes_a_model_in_a_new_folder() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let (status, refused) = server.ask("POST", "/api/import?folder=press&title=press", DRAWING);
    assert_eq!((status, refused["hint"].as_str()), (400, Some("choose the unit beside the button")));
    assert!(!desk.path().join("press").exists(), "nothing is left of what is refused");
    let (status, made) = server.ask("POST", "/api/import?folder=press&title=press&unit=mm", DRAWING);
    assert_eq!((status, &made["model"]), (200, &json!("press/model.toml")));
    let model = std::fs::read_to_string(desk.path().join("press/model.toml")).unwrap();
    assert!(model.contains("name = \"press\"") && model.contains("\"30 mm\""), "{model}");
    assert_eq!(server.ask("POST", "/api/import?folder=press&title=press&unit=mm", DRAWING).0, 409);
    for folder in ["..", "a%2Fb", "", "%00"] {
        let (status, _) = server.ask("POST", &format!("/api/import?folder={folder}&title=x&unit=mm"), DRAWING);
        assert_eq!(status, 400, "{folder}");
    }
}

#[test]
fn an_empty_sheet_is_written_once() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let (status, blank) = server.ask("GET", "/api/blank", "");
    assert_eq!(status, 200, "{blank}");
    let new = |folder: &str| json!({"folder": folder, "model": blank["model"], "study": blank["study"]}).to_string();
    let (status, said) = server.ask("POST", "/api/new", &new("drawn"));
    assert_eq!((status, &said["study"]), (200, &json!("drawn/study.toml")));
    let written = std::fs::read_to_string(desk.path().join("drawn/model.toml")).unwrap();
    assert_eq!(json!(written), blank["model"]);
    assert_eq!(server.ask("POST", "/api/new", &new("drawn")).0, 409, "nothing is overwritten");
    assert_eq!(server.ask("POST", "/api/new", &new("../drawn")).0, 400);
}
