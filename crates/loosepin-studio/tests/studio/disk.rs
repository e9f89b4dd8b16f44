//! Entries of the served folder that are not what they seem, and several studios on one folder.

use std::fs;
use std::path::Path;
use std::sync::Barrier;

use crate::client::Server;
use serde_json::{Value, json};

const MODEL: &str = "name = \"press\"\n[body.crank]\n";

fn save(server: &Server, path: &str, text: &str, tag: &Value) -> (u16, Value) {
    server.ask("PUT", "/api/file", &json!({"path": path, "text": text, "tag": tag}).to_string())
}

fn tag_of(server: &Server, path: &str) -> Value {
    let (status, opened) = server.ask("GET", &format!("/api/open?path={path}"), "");
    assert_eq!(status, 200, "{opened}");
    opened["model"]["tag"].clone()
}

/// A finished result whose page and record are `text`.
fn write_result(folder: &Path, name: &str, text: &str) {
    fs::create_dir_all(folder).unwrap();
    let marker = json!({
        "kind": "study", "name": name, "inputs_blake3": "ab", "version": "0.1.0", "is_finished": true, "files": {}
    });
    fs::write(folder.join("loosepin.json"), marker.to_string()).unwrap();
    fs::write(folder.join("report.html"), text).unwrap();
    fs::write(folder.join("summary.json"), text).unwrap();
}

#[test]
fn of_many_saves_with_one_tag_by_two_studios_one_counts() {
    const ROUNDS: usize = 20;
    const CLIENTS: usize = 8;
    let desk = tempfile::tempdir().unwrap();
    fs::write(desk.path().join("model.toml"), MODEL).unwrap();
    let servers = [Server::of(desk.path()), Server::of(desk.path())];
    for round in 0..ROUNDS {
        let tag = tag_of(&servers[0], "model.toml");
        let start = Barrier::new(CLIENTS);
        let saved: Vec<(u16, String)> = std::thread::scope(|scope| {
            let clients: Vec<_> = (0..CLIENTS)
                .map(|client| {
                    let (server, tag, start) = (&servers[client % 2], &tag, &start);
                    scope.spawn(move || {
                        let text = format!("{MODEL}# round {round}, client {client}\n");
                        start.wait();
                        (save(server, "model.toml", &text, tag).0, text)
                    })
                })
                .collect();
            clients.into_iter().map(|client| client.join().unwrap()).collect()
        });
        let held = fs::read_to_string(desk.path().join("model.toml")).unwrap();
        let won: Vec<&String> = saved.iter().filter(|(status, _)| *status == 200).map(|(_, text)| text).collect();
        assert_eq!(won, [&held], "round {round}: one is told that it was saved, and it was");
        assert!(saved.iter().all(|(status, _)| matches!(status, 200 | 409)), "{saved:?}");
    }
    let left: Vec<_> = fs::read_dir(desk.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["model.toml"]);
}

#[cfg(unix)]
#[test]
fn a_save_follows_no_link_and_destroys_no_file_of_the_user() {
    use std::os::unix::fs::symlink;
    let desk = tempfile::tempdir().unwrap();
    let served = desk.path().join("served");
    fs::create_dir(&served).unwrap();
    fs::write(desk.path().join("victim"), "of somebody").unwrap();
    let server = Server::of(&served);
    for name in ["model.toml", "link.toml"] {
        symlink("../victim", served.join(format!("{name}.partial"))).unwrap();
    }
    symlink("../victim", served.join("link.toml")).unwrap();
    assert_eq!(save(&server, "model.toml", MODEL, &Value::Null).0, 200);
    let (status, refused) = save(&server, "link.toml", MODEL, &Value::Null);
    let words = "cannot write 'link.toml': it is a symbolic link, and links are not followed here";
    assert_eq!((status, &refused["message"]), (403, &json!(words)));
    assert_eq!(fs::read_to_string(desk.path().join("victim")).unwrap(), "of somebody");
    // A file of that name which is the user's stays as it is.
    fs::remove_file(served.join("model.toml.partial")).unwrap();
    fs::write(served.join("model.toml.partial"), "of the user").unwrap();
    let tag = tag_of(&server, "model.toml");
    assert_eq!(save(&server, "model.toml", "name = \"other\"\n[body.crank]\n", &tag).0, 200);
    assert_eq!(fs::read_to_string(served.join("model.toml.partial")).unwrap(), "of the user");
}

#[cfg(unix)]
#[test]
fn a_save_keeps_the_mode_of_a_file_and_leaves_a_read_only_one() {
    use std::os::unix::fs::PermissionsExt;
    let desk = tempfile::tempdir().unwrap();
    let path = desk.path().join("model.toml");
    fs::write(&path, MODEL).unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o600)).unwrap();
    let server = Server::of(desk.path());
    let changed = format!("{MODEL}# changed\n");
    assert_eq!(save(&server, "model.toml", &changed, &tag_of(&server, "model.toml")).0, 200);
    assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o600);
    fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
    let (status, refused) = save(&server, "model.toml", MODEL, &tag_of(&server, "model.toml"));
    assert_eq!((status, &refused["message"]), (403, &json!("cannot write 'model.toml': it is read-only")));
    assert_eq!(fs::read_to_string(&path).unwrap(), changed);
}

#[cfg(unix)]
#[test]
fn pipes_and_enormous_files_make_nobody_wait() {
    let desk = tempfile::tempdir().unwrap();
    let pipe = |path: &Path| assert!(std::process::Command::new("mkfifo").arg(path).status().unwrap().success());
    fs::create_dir(desk.path().join("results")).unwrap();
    for name in ["model.toml", "model.toml.partial"] {
        pipe(&desk.path().join(name));
    }
    for (name, file) in [("piped", "summary.json"), ("shown", "report.html"), ("marked", "loosepin.json")] {
        let folder = desk.path().join("results").join(name);
        write_result(&folder, name, "{}");
        fs::remove_file(folder.join(file)).unwrap();
        pipe(&folder.join(file));
    }
    for (name, file) in [("long", "summary.json"), ("wide", "report.html"), ("high", "loosepin.json")] {
        let folder = desk.path().join("results").join(name);
        write_result(&folder, name, "{}");
        // 3 GiB that take no room on the disk.
        fs::File::create(folder.join(file)).unwrap().set_len(3 << 30).unwrap();
    }
    let server = Server::of(desk.path());
    let status = |method: &str, path: &str, body: Value| server.ask(method, path, &body.to_string()).0;
    assert_eq!(status("GET", "/api/open?path=model.toml", Value::Null), 400);
    assert_eq!(save(&server, "model.toml", MODEL, &Value::Null).0, 400);
    for (name, expected) in [("piped", 400), ("marked", 400), ("long", 413), ("high", 413)] {
        let path = format!("results/{name}");
        assert_eq!(status("POST", "/api/result", json!({"path": path})), expected, "{name}");
        assert_eq!(
            status("POST", "/api/compare", json!({"before": path, "after": "results/shown"})),
            expected,
            "{name}"
        );
    }
    for (name, expected) in [("shown", "400"), ("wide", "413")] {
        let (_, address) = server.ask("POST", "/api/view", &json!({"path": format!("results/{name}")}).to_string());
        let request = format!(
            "GET {} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n",
            address["address"].as_str().unwrap(),
            server.host
        );
        assert_eq!(server.whole(&request).split(' ').nth(1), Some(expected), "{name}");
    }
    let (_, listing) = server.ask("GET", "/api/folder", "");
    let mut listed: Vec<&str> =
        listing["results"].as_array().unwrap().iter().map(|found| found["title"].as_str().unwrap()).collect();
    listed.sort_unstable();
    assert_eq!(listed, ["long", "piped", "wide"], "those with a marker and a page");
}

#[cfg(unix)]
#[test]
fn results_that_are_links_are_neither_shown_nor_written_through() {
    use std::os::unix::fs::symlink;
    let desk = tempfile::tempdir().unwrap();
    let served = desk.path().join("served");
    let outside = desk.path().join("outside");
    write_result(&outside.join("secret"), "secret", "TOP SECRET");
    fs::create_dir(&served).unwrap();
    symlink("../outside", served.join("results")).unwrap();
    write_result(&served.join("own"), "own", "{}");
    fs::remove_file(served.join("own/report.html")).unwrap();
    symlink("../../outside/secret/report.html", served.join("own/report.html")).unwrap();
    let server = Server::of(&served);
    let new = json!({"template": "slider-crank", "folder": "mine"}).to_string();
    assert_eq!(server.ask("POST", "/api/new", &new).0, 200);
    let (_, listing) = server.ask("GET", "/api/folder", "");
    assert_eq!(listing["results"], json!([]));
    let view = |path: &str| server.ask("POST", "/api/view", &json!({"path": path}).to_string());
    assert_eq!(view("results/secret").0, 403);
    // The link itself is there; what it leads to is not told.
    let (_, address) = view("own");
    let request = format!(
        "GET {} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n",
        address["address"].as_str().unwrap_or("/view/none"),
        server.host
    );
    let answer = server.whole(&request);
    assert!(!answer.contains("TOP SECRET") && !answer.contains(" 200 "), "{answer}");
    let mut live = server.live();
    live.send(&json!({"kind": "run", "study": "mine/study.toml"}));
    let job = loop {
        let job = live.next_of("job")["job"].clone();
        if job["state"] != "waiting" && job["state"] != "running" {
            break job;
        }
    };
    assert_eq!(job["state"], "failed", "{job}");
    assert!(job["diagnostics"][0].as_str().unwrap().contains("it is a symbolic link"), "{job}");
    assert_eq!(fs::read_dir(&outside).unwrap().count(), 1, "nothing was written outside");
}

#[cfg(unix)]
#[test]
fn a_served_folder_that_was_removed_is_not_made_anew() {
    let desk = tempfile::tempdir().unwrap();
    let served = desk.path().join("served");
    fs::create_dir(&served).unwrap();
    let server = Server::of(&served);
    fs::remove_dir(&served).unwrap();
    let new = json!({"template": "slider-crank", "folder": "mine"}).to_string();
    let (status, refused) = server.ask("POST", "/api/new", &new);
    let words = "the served folder no longer exists; nothing is written";
    assert_eq!((status, &refused["message"]), (409, &json!(words)));
    assert!(save(&server, "model.toml", MODEL, &Value::Null).0 >= 400);
    assert!(!served.exists());
}

#[test]
fn of_many_results_the_newest_are_told() {
    const RESULTS: usize = 3000;
    let desk = tempfile::tempdir().unwrap();
    for number in 0..RESULTS {
        write_result(&desk.path().join(format!("results/study/{number:08}")), &format!("study {number}"), "{}");
    }
    let newest = fs::File::options().write(true).open(desk.path().join("results/study/00000007/report.html")).unwrap();
    newest.set_modified(std::time::SystemTime::now() + std::time::Duration::from_secs(60)).unwrap();
    let server = Server::of(desk.path());
    for _ in 0..2 {
        let (status, listing) = server.ask("GET", "/api/folder", "");
        assert_eq!((status, &listing["truncated"]), (200, &json!(true)));
        assert_eq!(listing["results"].as_array().unwrap().len(), 200);
        assert_eq!(listing["results"][0]["title"], "study 7");
    }
    // A result that is made again is read again.
    write_result(&desk.path().join("results/study/00000007"), "another study", "{}");
    newest.set_modified(std::time::SystemTime::now() + std::time::Duration::from_secs(60)).unwrap();
    let (_, listing) = server.ask("GET", "/api/folder", "");
    assert_eq!(listing["results"][0]["title"], "another study");
}
