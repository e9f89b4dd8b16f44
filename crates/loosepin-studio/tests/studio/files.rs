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
fn all_templates_are_there_and_those_with_a_turning_drive_move() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let (status, cards) = server.ask("GET", "/api/templates", "");
    assert_eq!((status, cards.as_array().unwrap().len()), (200, 14));
    let moving = cards.as_array().unwrap().iter().filter(|card| card["drawing"]["svg"].is_string()).count();
    assert!(moving >= 11, "{moving}");
}

#[test]
fn a_code_is_explained() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let (status, explained) = server.ask("GET", "/api/explain/E0302", "");
    assert!(status == 200 && explained["text"].as_str().unwrap().len() > 60, "{explained}");
    assert_eq!(server.ask("GET", "/api/explain/E9999", "").0, 404);
}
