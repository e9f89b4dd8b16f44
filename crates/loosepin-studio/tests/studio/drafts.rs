//! Texts that are not saved yet.

use crate::client::{Live, Server};
use serde_json::{Value, json};

const TABS: [&str; 2] = ["0123456789abcdef0123456789abcde0", "0123456789abcdef0123456789abcde1"];
const PATH: &str = "mine/study.toml";

fn keep(server: &Server, tab: &str, model: Option<&str>) -> u16 {
    let model = model.map(|text| json!({"text": text, "tag": "t"}));
    let body = json!({"tab": tab, "path": PATH, "model": model, "study": null});
    server.ask("PUT", "/api/draft", &body.to_string()).0
}

/// The text of the model that a tab is given, and whether another one has some.
fn take(server: &Server, tab: &str) -> (Value, Value) {
    let (status, answer) = server.ask("POST", "/api/draft/take", &json!({"tab": tab, "path": PATH}).to_string());
    assert_eq!(status, 200, "{answer}");
    (answer["draft"]["model"]["text"].clone(), answer["is_elsewhere"].clone())
}

fn live(server: &Server, tab: &str) -> Live {
    let mut live = server.connection();
    live.send(&json!({"kind": "hello", "token": server.token, "tab": tab}));
    assert_eq!(live.next().expect("a greeting")["kind"], "hello");
    live
}

#[test]
fn unsaved_texts_are_their_tabs_and_survive_a_new_start() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let first = live(&server, TABS[0]);
    assert_eq!(keep(&server, TABS[0], Some("a = 1")), 200);
    // The second tab does not take it, as long as the first one is there.
    assert_eq!(take(&server, TABS[1]), (Value::Null, json!(true)));
    assert_eq!(take(&server, TABS[0]), (json!("a = 1"), json!(false)));
    drop(first);
    drop(server);
    // Another server, at another port: nobody is there any more.
    let server = Server::of(desk.path());
    let second = live(&server, TABS[1]);
    assert_eq!(take(&server, TABS[1]), (json!("a = 1"), json!(false)));
    assert_eq!(take(&server, TABS[0]), (Value::Null, json!(true)));
    assert_eq!(keep(&server, TABS[1], None), 200);
    drop(second);
    assert_eq!(take(&server, TABS[0]), (Value::Null, json!(false)));
    assert!(!desk.path().join(".drafts").exists(), "nothing is left of it");
}

#[test]
fn unsaved_texts_are_kept_for_those_with_the_key_and_by_digits_alone() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let body = json!({"tab": TABS[0], "path": PATH, "model": {"text": "a", "tag": ""}}).to_string();
    assert_eq!(server.ask_with("PUT", "/api/draft", "", &body).0, 401);
    assert_eq!(server.ask_with("POST", "/api/draft/take", "", &body).0, 401);
    for tab in ["", "../../../../../evil", "0123456789ABCDEF0123456789ABCDEF"] {
        assert_eq!(keep(&server, tab, Some("a")), 400, "{tab}");
    }
    assert!(!desk.path().join(".drafts").exists());
}
