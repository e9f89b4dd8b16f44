//! What somebody tries who is not the person at this machine.

use std::fs;
use std::path::Path;

use crate::client::Server;
use serde_json::{Value, json};

/// Bytes that look random and are the same in every run.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> u64 {
        // Knuth's multiplier of a linear congruential generator; the upper bits are used.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn below(&mut self, end: usize) -> usize {
        self.next() as usize % end
    }

    fn bytes(&mut self, count: usize) -> Vec<u8> {
        (0..count).map(|_| self.next() as u8).collect()
    }
}

/// A served folder beside a secret, with links that lead out.
fn desk() -> (tempfile::TempDir, std::path::PathBuf) {
    let desk = tempfile::tempdir().unwrap();
    let served = desk.path().join("served");
    fs::create_dir(&served).unwrap();
    fs::write(desk.path().join("secret.toml"), "name = \"TOP SECRET\"\n").unwrap();
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../secret.toml", served.join("link.toml")).unwrap();
        std::os::unix::fs::symlink("..", served.join("out")).unwrap();
        std::os::unix::fs::symlink("/", served.join("root")).unwrap();
    }
    (desk, served)
}

fn is_untouched(desk: &Path) -> bool {
    fs::read_to_string(desk.join("secret.toml")).is_ok_and(|text| text == "name = \"TOP SECRET\"\n")
}

#[test]
fn without_the_token_nothing_is_told() {
    let (_desk, served) = desk();
    let server = Server::of(&served);
    let almost = format!("Authorization: Bearer {}0\r\n", &server.token[1..]);
    for (method, path) in [
        ("GET", "/api/hello"),
        ("GET", "/api/folder"),
        ("GET", "/api/open?path=link.toml"),
        ("PUT", "/api/file"),
        ("POST", "/api/new"),
        ("POST", "/api/restructure"),
        ("POST", "/api/view"),
        ("POST", "/api/compare"),
        ("POST", "/api/result"),
        ("POST", "/api/adopt"),
        ("GET", "/api/"),
        ("GET", "/api/nothing"),
    ] {
        for headers in ["", "Authorization: Bearer \r\n", "Cookie: token=1\r\n", &almost] {
            let (status, body) = server.ask_with(method, path, headers, "{}");
            assert_eq!(status, 401, "{method} {path} {body}");
        }
    }
    for first in [
        json!({"kind": "hello", "token": ""}),
        json!({"kind": "hello", "token": server.token[1..]}),
        json!({"kind": "run", "study": "study.toml"}),
        json!([]),
    ] {
        let mut live = server.connection();
        live.send(&first);
        assert!(live.next().is_none_or(|message| message["kind"] == "refused"), "{first}");
        assert!(live.next().is_none(), "the connection ends");
    }
}

#[test]
fn other_hosts_and_origins_are_refused() {
    let (_desk, served) = desk();
    let server = Server::of(&served);
    let token = format!("Authorization: Bearer {}", server.token);
    let status = |host: &str, origin: &str| {
        let request =
            format!("GET /api/hello HTTP/1.1\r\nHost: {host}\r\n{origin}{token}\r\nConnection: close\r\n\r\n");
        let answer = server.whole(&request);
        answer.split(' ').nth(1).and_then(|status| status.parse::<u16>().ok()).unwrap_or(0)
    };
    assert_eq!(status(&server.host, ""), 200);
    assert_eq!(status(&server.host, &format!("Origin: http://{}\r\n", server.host)), 200);
    for host in ["evil.example", "127.0.0.1.evil.example:80", "10.0.0.1", "0.0.0.0", "127.0.0.2"] {
        assert_eq!(status(host, ""), 403, "{host}");
    }
    for origin in ["http://evil.example", "null", "https://127.0.0.1", "http://127.0.0.1:1", "file://"] {
        assert_eq!(status(&server.host, &format!("Origin: {origin}\r\n")), 403, "{origin}");
    }
    // A live connection must say where it is from, before it is opened.
    for origin in ["", "Origin: http://evil.example\r\n"] {
        let request = format!(
            "GET /live HTTP/1.1\r\nHost: {}\r\n{origin}Connection: Upgrade, close\r\nUpgrade: websocket\r\n\
             Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
            server.host
        );
        let answer = server.whole(&request);
        assert!(answer.starts_with("HTTP/1.1 403"), "{answer}");
    }
}

#[test]
fn ten_thousand_malformed_requests_read_nothing_outside_and_meet_words() {
    let (desk, served) = desk();
    let server = Server::of(&served);
    let mut noise = Noise(2016);
    let methods = ["GET", "PUT", "POST", "DELETE", "HEAD", "OPTIONS", "BREW"];
    let pieces = [
        "..",
        "%2e%2e",
        "secret.toml",
        "link.toml",
        "out",
        "root",
        "etc",
        "passwd",
        "api",
        "open",
        "file",
        "view",
        "live",
        "\\",
        "%00",
        "%5c",
        "C:",
        "a",
        "~",
        "?path=",
        "=",
        "&",
        "%",
        "é",
        "<script>",
    ];
    let values =
        ["../secret.toml", "link.toml", "out/secret.toml", "root/etc/passwd", "/etc/passwd", "", "a\u{0}b", "C:\\x"];
    for _ in 0..10_000 {
        let method = methods[noise.below(methods.len())];
        let bytes = match noise.below(4) {
            0 => {
                let length = 1 + noise.below(300);
                noise.bytes(length)
            }
            1 => {
                let path: Vec<&str> = (0..1 + noise.below(6)).map(|_| pieces[noise.below(pieces.len())]).collect();
                let head = format!("{method} /{} HTTP/1.1\r\nHost: {}\r\n", path.join("/"), server.host);
                format!("{head}Authorization: Bearer {}\r\nConnection: close\r\n\r\n", server.token).into_bytes()
            }
            2 => {
                let value = values[noise.below(values.len())];
                let target =
                    ["file", "new", "view", "open", "know", "compare", "result", "adopt", "restructure", "draw"]
                        [noise.below(10)];
                let edit = [
                    json!({"kind": "rename", "what": {"table": value, "name": value}, "to": value}),
                    json!({"kind": "remove", "what": {"table": "body", "name": value}}),
                    json!({"kind": "drive", "joint": value}),
                    json!({"kind": value}),
                ][noise.below(4)]
                .clone();
                let mut body =
                    json!({"path": value, "text": "x = 1\n", "tag": null, "template": value, "folder": value,
                        "before": value, "after": values[noise.below(values.len())], "place": noise.next(),
                        "model": {"path": value, "text": value}, "study": null, "edit": edit})
                    .to_string()
                    .into_bytes();
                if noise.below(2) == 0 {
                    let at = noise.below(body.len());
                    body[at] = noise.next() as u8;
                }
                let head = format!(
                    "{method} /api/{target} HTTP/1.1\r\nHost: {}\r\nAuthorization: Bearer {}\r\nContent-Length: {}\r\n\
                     Connection: close\r\n\r\n",
                    server.host,
                    server.token,
                    body.len()
                );
                [head.into_bytes(), body].concat()
            }
            _ => {
                let value = values[noise.below(values.len())].replace(['\u{0}', '\\'], "%00");
                let head = format!("GET /api/open?path={value} HTTP/1.1\r\nHost: {}\r\n", server.host);
                format!("{head}Authorization: Bearer {}\r\nConnection: close\r\n\r\n", server.token).into_bytes()
            }
        };
        let answer = String::from_utf8_lossy(&server.raw(&bytes)).into_owned();
        let asked = || String::from_utf8_lossy(&bytes).into_owned();
        assert!(!answer.contains("TOP SECRET") && !answer.contains("root:"), "{}\n{answer}", asked());
        let status = answer.split(' ').nth(1).and_then(|status| status.parse::<u16>().ok());
        assert!(status.is_none_or(|status| status < 500), "{}\n{answer}", asked());
        if status.is_some_and(|status| status >= 400) && method != "HEAD" && answer.contains("application/json") {
            let (_, body) = answer.split_once("\r\n\r\n").unwrap();
            let body: Value = serde_json::from_str(body).unwrap_or_else(|_| panic!("{answer}"));
            assert!(body["message"].as_str().is_some_and(|message| message.len() > 10), "{answer}");
        }
    }
    assert!(is_untouched(desk.path()));
    assert_eq!(server.ask("GET", "/api/hello", "").0, 200, "the server lives");
}

#[test]
fn malformed_messages_are_refused_with_words() {
    let (desk, served) = desk();
    let server = Server::of(&served);
    let mut noise = Noise(42);
    let model = loosepin::templates::find_template("four-bar").unwrap().model;
    let mut live = server.live();
    let mut sent_since = 0;
    for _ in 0..2_000 {
        // Under the limit on messages a second: after each, an answer.
        match noise.below(4) {
            3 => {
                // A drag of numbers that no drawing has.
                let held = [
                    json!({"take": "joint", "joint": "crank_pin"}),
                    json!({"take": "point", "body": "coupler", "point": "tracer"}),
                    json!({"take": "guide", "joint": "crank_pin"}),
                ][noise.below(3)]
                .clone();
                let mut number = || f64::from_bits(noise.next());
                let poses: Vec<[f64; 3]> = (0..4).map(|_| [number(), number(), number()]).collect();
                let grip = json!({"held": held, "to_mm": [number(), number()], "step_mm": number(), "is_free": false,
                    "poses": poses});
                let text = json!({"path": "model.toml", "text": model});
                live.send(
                    &json!({"kind": "look", "seq": 1, "model": text, "study": null, "positions": 12, "grip": grip}),
                );
                // What is no number in JSON is refused, what is one is answered.
                let answer = live.next().expect("an answer");
                assert!(answer["kind"] == "refused" || answer["reshaped"].is_object(), "{answer}");
            }
            0 => {
                let at = noise.below(model.len() - 1);
                let cut = (at..).find(|at| model.is_char_boundary(*at)).unwrap();
                let mut text = model[..cut].to_owned();
                text.push(char::from_u32(noise.next() as u32 % 0xd7ff).unwrap());
                text.push_str(&model[cut..]);
                let seen = live.look(1, ("model.toml", &text), None);
                assert!(seen["diagnostics"].is_array(), "{seen}");
            }
            1 => {
                live.send(&json!({"kind": "look", "seq": -1, "model": noise.next()}));
                let refused = live.next_of("refused");
                assert!(refused["message"].as_str().unwrap().contains("is not valid"), "{refused}");
            }
            _ => {
                live.send_text("{\"kind\": \"run\"");
                live.next_of("refused");
            }
        }
        sent_since += 1;
        if sent_since == 150 {
            sent_since = 0;
            live = server.live();
        }
    }
    // Bytes are no message: the connection ends, the server does not.
    live.send_bytes(&[0, 159, 146, 150]);
    assert!(live.next().is_none());
    // A flood ends the connection.
    let mut flood = server.live();
    for _ in 0..1_000 {
        flood.send(&json!({"kind": "stop", "id": 1}));
    }
    assert!(flood.next().is_none());
    // Texts beyond all limits, too.
    let mut large = server.live();
    large.send(
        &json!({"kind": "look", "seq": 1, "model": {"path": "m.toml", "text": "a".repeat(5 << 20)}, "positions": 72}),
    );
    assert!(large.next().is_none());
    // Runs of what is no result come to nothing, and read nothing outside.
    let mut runs = server.live();
    for _ in 0..100 {
        let path = ["../secret.toml", "out", "root/etc", "link.toml", "", "results\u{0}"][noise.below(6)];
        runs.send(&json!({"kind": "simulate", "result": path, "witness": noise.next()}));
        let answer = loop {
            let answer = runs.next().expect("an answer");
            assert!(!answer.to_string().contains("TOP SECRET"), "{answer}");
            if answer["kind"] == "refused" || answer["job"]["state"] == "failed" {
                break answer;
            }
        };
        assert!(answer["kind"] == "refused" || answer["job"]["diagnostics"][0].is_string(), "{answer}");
    }
    assert!(is_untouched(desk.path()));
    assert_eq!(server.ask("GET", "/api/hello", "").0, 200, "the server lives");
}

#[test]
fn edits_that_no_page_sends_are_refused_with_words_and_open_nothing() {
    let (desk, served) = desk();
    let server = Server::of(&served);
    let before = fs::read_dir(&served).unwrap().count();
    let template = loosepin::templates::find_template("four-bar").unwrap();
    let ask = |edit: &Value, poses: &Value, model: &str| {
        let model = json!({"path": "model.toml", "text": model});
        let study = json!({"path": "study.toml", "text": template.study});
        let body = json!({"model": model, "study": study, "edit": edit, "poses": poses});
        server.ask("POST", "/api/restructure", &body.to_string())
    };
    let none = json!({});
    let point = |body: &str, point: &str| json!({"at": "point", "body": body, "point": point});
    let free = |x: f64, y: f64| json!({"at": "free", "x": x, "y": y});
    let good = json!({"kind": "add_link", "from": point("coupler", "tracer"), "to": free(300.0, 300.0)});
    let (status, answer) = ask(&good, &none, template.model);
    assert_eq!((status, &answer["refusal"], &answer["name"]), (200, &Value::Null, &json!("link_1")), "{answer}");
    assert!(answer["changes"].as_array().is_some_and(|changes| !changes.is_empty()), "{answer}");
    // What the page says of places is looked at before it is used.
    let far = json!({"crank": [1e300, -1e300, 1e308], "<script>": [0, 0, 0], "coupler": [1e9, 0, 0]});
    assert_eq!(ask(&good, &far, template.model).0, 200);
    let names =
        ["<script>alert(1)</script>", "../secret", "a\"]\n[body.x", "\u{202e}", "", "ground", &"x".repeat(10_000)];
    for name in names {
        for edit in [
            json!({"kind": "add_link", "from": point(name, name), "to": free(1.0, 2.0)}),
            json!({"kind": "add_point", "body": name, "to": {"at": "on", "body": name, "x": 1e200, "y": 0}}),
            json!({"kind": "join", "first": point(name, "pin"), "second": point("crank", name), "by": {"as": "pin"}}),
            json!({"kind": "add_block", "on": point(name, name), "angle_deg": 1e308}),
            json!({"kind": "drive", "joint": name}),
            json!({"kind": "remove", "what": {"table": name, "name": name}}),
            json!({"kind": "remove", "what": {"table": "body", "name": name}}),
            json!({"kind": "rename", "what": {"table": "joint", "name": name}, "to": "a"}),
            json!({"kind": "rename", "what": {"table": "body", "name": "crank"}, "to": name}),
            json!({"kind": "lock", "path": name, "is_locked": true}),
        ] {
            let (status, answer) = ask(&edit, &none, template.model);
            assert_eq!(status, 200, "{edit} {answer}");
            let words = answer["refusal"]["message"].as_str().unwrap_or_else(|| {
                // The ground is a body: it can have a further point, but not one that is further away than anything.
                panic!("{edit} {answer}")
            });
            assert!(words.len() > 10 && answer["changes"].is_null(), "{edit} {answer}");
        }
    }
    for edit in [
        json!({"kind": "erase"}),
        json!(null),
        json!([]),
        json!({"kind": "lock", "path": 1}),
        json!({"kind": "add_link"}),
    ] {
        let (status, answer) = ask(&edit, &none, template.model);
        assert!(status == 400 && answer["message"].as_str().is_some_and(|words| words.len() > 10), "{edit} {answer}");
    }
    // Texts that are no model, or no end of one.
    let mut noise = Noise(7);
    for _ in 0..300 {
        let at = (noise.below(template.model.len())..).find(|at| template.model.is_char_boundary(*at)).unwrap();
        let mut text = template.model[..at].to_owned();
        text.push(char::from_u32(noise.next() as u32 % 0xd7ff).unwrap());
        text.push_str(&template.model[at..]);
        assert_eq!(ask(&good, &none, &text).0, 200);
    }
    let deep = format!("x = {}", "[".repeat(100_000));
    assert!(ask(&good, &none, &deep).1["refusal"].is_object());
    let huge = format!("{}\n# {}", template.model, "a".repeat(5 << 20));
    let model = json!({"path": "model.toml", "text": huge});
    let body = json!({"model": model, "study": null, "edit": good, "poses": {}}).to_string();
    assert_eq!(server.ask("POST", "/api/restructure", &body).0, 413);
    assert!(is_untouched(desk.path()));
    assert_eq!(fs::read_dir(&served).unwrap().count(), before, "nothing is written");
}

#[test]
fn who_does_not_go_on_is_not_waited_for() {
    let (_desk, served) = desk();
    let server = Server::of(&served);
    // A head without an end, and a body that does not come.
    assert!(!server.whole("GET / HTTP/1.1\r\nHost: ").starts_with("HTTP/1.1 200"));
    let head = format!("PUT /api/file HTTP/1.1\r\nHost: {}\r\nAuthorization: Bearer {}\r\n", server.host, server.token);
    let answer = server.whole(&format!("{head}Content-Length: 100\r\nConnection: close\r\n\r\n{{"));
    assert!(answer.starts_with("HTTP/1.1 408"), "{answer}");
    // A hundred that say nothing keep nobody out for longer than that.
    let silent: Vec<_> = (0..100).map(|_| std::net::TcpStream::connect(&server.host).unwrap()).collect();
    assert_eq!(server.ask("GET", "/api/hello", "").0, 200);
    drop(silent);
}
