//! Studies in the background.

use std::path::Path;

use crate::client::{Live, Server};
use loosepin::templates::find_template;
use serde_json::{Value, json};

/// A study that takes a second or two.
fn written(folder: &Path) -> String {
    let template = find_template("slider-crank").unwrap();
    std::fs::create_dir(folder.join("mine")).unwrap();
    std::fs::write(folder.join("mine/model.toml"), template.model).unwrap();
    std::fs::write(folder.join("mine/study.toml"), template.study).unwrap();
    "mine/study.toml".to_owned()
}

/// The job when it has come to its end; every message on it is given to `hears`.
fn ended(live: &mut Live, mut hears: impl FnMut(&Value)) -> Value {
    loop {
        let job = live.next_of("job")["job"].clone();
        hears(&job);
        if job["state"] != "waiting" && job["state"] != "running" {
            return job;
        }
    }
}

#[test]
fn the_texts_that_are_shown_are_run_whatever_is_on_the_disk() {
    let desk = tempfile::tempdir().unwrap();
    let study = written(desk.path());
    let model = study.replace("study.toml", "model.toml");
    let text = |path: &str| std::fs::read_to_string(desk.path().join(path)).unwrap();
    let named = |name: &str| text(&study).replacen("name = \"", &format!("name = \"{name} "), 1);
    let run = |study_text: String| {
        let shown =
            json!({"model": {"path": model, "text": text(&model)}, "study": {"path": study, "text": study_text}});
        json!({"kind": "run", "study": study, "shown": shown})
    };
    let server = Server::of(desk.path());
    let mut live = server.live();
    live.send(&run(named("shown")));
    let job = ended(&mut live, |_| {});
    assert_eq!(job["state"], "done", "{job}");
    assert!(job["title"].as_str().unwrap().starts_with("shown "), "{job}");
    assert!(!text(&study).contains("shown "), "nothing is saved by running");
    // The command would run the other model.
    live.send(&run(text(&study).replace("model.toml", "other.toml")));
    let job = ended(&mut live, |_| {});
    assert_eq!(job["state"], "failed", "{job}");
    let said = job["diagnostics"][0].as_str().unwrap();
    assert!(said.contains("names the model '") && said.contains("other.toml'; the page shows '"), "{said}");
}

#[test]
fn a_study_runs_in_the_background_and_its_report_is_seen() {
    let desk = tempfile::tempdir().unwrap();
    let study = written(desk.path());
    let server = Server::of(desk.path());
    let mut live = server.live();
    live.send(&json!({"kind": "run", "study": study}));
    let mut drafts = 0;
    let job = ended(&mut live, |job| {
        if let Some(draft) = job["draft"].as_object() {
            drafts += 1;
            let band = &draft["bands"][0];
            assert!(band["figure"].as_str().is_some_and(|figure| figure.contains("runs so far")), "{band}");
        }
    });
    assert_eq!(job["state"], "done", "{job}");
    assert!(drafts > 0, "something is known before the end");
    assert!(!job["words"].as_array().unwrap().is_empty() && job["verdict"].is_string(), "{job}");
    // It is listed, and its page can be seen once.
    let (_, listing) = server.ask("GET", "/api/folder", "");
    let listed = listing["results"].as_array().unwrap().iter().find(|found| found["path"] == job["result"]);
    assert_eq!(listed.unwrap()["verdict"], job["verdict"]);
    let (status, address) = server.ask("POST", "/api/view", &json!({"path": job["result"]}).to_string());
    assert_eq!(status, 200, "{address}");
    let address = address["address"].as_str().unwrap();
    let request = format!("GET {address} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", server.host);
    let page = server.whole(&request);
    assert!(
        page.contains("content-security-policy: sandbox allow-scripts") && page.contains("</html>"),
        "{:.600}",
        page
    );
    assert_eq!(server.ask("GET", address, "").0, 404, "a ticket is good once");
    // Asked for again it is found, not run.
    live.send(&json!({"kind": "run", "study": study}));
    let again = ended(&mut live, |_| {});
    assert_eq!((&again["state"], &again["result"]), (&json!("done"), &job["result"]));
}

#[test]
fn a_stopped_study_goes_on_where_it_was() {
    let desk = tempfile::tempdir().unwrap();
    let study = written(desk.path());
    let server = Server::of(desk.path());
    let mut live = server.live();
    live.send(&json!({"kind": "run", "study": study}));
    let running = loop {
        let job = live.next_of("job")["job"].clone();
        if job["finished"].as_u64().unwrap() > 0 || job["state"] == "done" {
            break job;
        }
    };
    live.send(&json!({"kind": "stop", "id": running["id"]}));
    let stopped = ended(&mut live, |_| {});
    // A machine may be so fast that nothing was left to stop.
    assert!(stopped["state"] == "stopped" || stopped["state"] == "done", "{stopped}");
    live.send(&json!({"kind": "run", "study": study}));
    let job = ended(&mut live, |_| {});
    assert_eq!(job["state"], "done", "{job}");
}

#[test]
fn what_cannot_be_run_says_why() {
    let desk = tempfile::tempdir().unwrap();
    let study = written(desk.path());
    let path = desk.path().join(&study);
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, text.replacen("[random]", "[randum]", 1)).unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    live.send(&json!({"kind": "run", "study": study}));
    let job = ended(&mut live, |_| {});
    assert_eq!(job["state"], "failed", "{job}");
    assert!(job["diagnostics"][0].as_str().unwrap().contains("randum"), "{job}");
    live.send(&json!({"kind": "run", "study": "../elsewhere/study.toml"}));
    assert_eq!(ended(&mut live, |_| {})["state"], "failed");
}

#[cfg(unix)]
#[test]
fn results_are_not_written_through_a_link_that_leads_out() {
    let desk = tempfile::tempdir().unwrap();
    let served = desk.path().join("served");
    std::fs::create_dir(&served).unwrap();
    std::fs::create_dir(desk.path().join("elsewhere")).unwrap();
    std::os::unix::fs::symlink("../elsewhere", served.join("results")).unwrap();
    let study = written(&served);
    let server = Server::of(&served);
    let mut live = server.live();
    live.send(&json!({"kind": "run", "study": study}));
    assert_eq!(ended(&mut live, |_| {})["state"], "failed");
    assert_eq!(std::fs::read_dir(desk.path().join("elsewhere")).unwrap().count(), 0);
}
