//! Connections that take their time: slow readers, slow writers, and those that say nothing. They do not keep the owner out.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::thread::sleep;
use std::time::{Duration, Instant};

use loosepin_studio::Timeouts;
use serde_json::json;

use crate::client::{Live, Server};

/// Connections at once.
const CONNECTIONS: usize = 64;
/// Live connections at once.
const PAGES: usize = 8;
/// Requests of which the bodies are read at once.
const BODIES: usize = 8;
const SHORT: Duration = Duration::from_millis(300);
const LONG: Duration = Duration::from_secs(600);

/// Nothing ends by itself.
const PATIENT: Timeouts =
    Timeouts { head: LONG, request: LONG, write: LONG, connection: LONG, last_request: LONG, hello: LONG, stay: SHORT };

fn desk() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

/// Requests without the token whose answers fill all buffers on the way.
fn greedy(server: &Server) -> Vec<u8> {
    let index = server.whole(&format!("GET / HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", server.host));
    let (_, script) = index.split_once("src=\"/").or_else(|| index.split_once("src=\"./")).expect("a script");
    let (script, _) = script.split_once('"').unwrap();
    format!("GET /{script} HTTP/1.1\r\nHost: {}\r\n\r\n", server.host).repeat(500).into_bytes()
}

fn upgrade(server: &Server) -> Vec<u8> {
    format!(
        "GET /live HTTP/1.1\r\nHost: {0}\r\nOrigin: http://{0}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n\
         Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
        server.host
    )
    .into_bytes()
}

/// Whether the server has ended a connection, seen from what it sends, or does not take any more.
fn is_ended(stream: &mut TcpStream) -> bool {
    stream.set_nonblocking(true).unwrap();
    let outcome = stream.write(b"\r\n");
    stream.set_nonblocking(false).unwrap();
    outcome.is_err_and(|error| error.kind() != std::io::ErrorKind::WouldBlock)
}

/// Waits for something that comes soon.
fn comes(mut what: impl FnMut() -> bool) -> bool {
    let end = Instant::now() + Duration::from_secs(10);
    while Instant::now() < end {
        if what() {
            return true;
        }
        sleep(Duration::from_millis(20));
    }
    false
}

/// The head of an answer on a connection that stays open.
fn status(stream: &mut TcpStream) -> u16 {
    let mut bytes = [0; 12];
    let found = stream.read_exact(&mut bytes).ok().and_then(|()| std::str::from_utf8(&bytes[9..]).ok()?.parse().ok());
    found.unwrap_or(0)
}

#[test]
fn strangers_in_all_places_make_room_for_the_owner() {
    let desk = desk();
    // No time comes to the help of the owner.
    let server = Server::within(desk.path(), PATIENT);
    let (greedy, upgrade) = (greedy(&server), upgrade(&server));
    let half_head = format!("GET / HTTP/1.1\r\nHost: {}\r\nX-Slow: ", server.host).into_bytes();
    let half_hello = [upgrade.as_slice(), &[0x81, 0xff, 0, 0, 0, 0, 0, 0x3f, 0xff, 0xff, 1, 2, 3, 4, b'{']].concat();
    let kinds: [&[u8]; 5] = [&greedy, &[], &half_head, &upgrade, &half_hello];
    let strangers: Vec<TcpStream> =
        (0..2 * CONNECTIONS).map(|number| server.sent(kinds[number % kinds.len()])).collect();
    assert_eq!(server.ask("GET", "/api/hello", "").0, 200);
    let mut live = server.live();
    let more: Vec<TcpStream> = (0..2 * CONNECTIONS).map(|number| server.sent(kinds[number % kinds.len()])).collect();
    live.send(&json!({"kind": "nothing"}));
    live.next_of("refused");
    assert_eq!(server.ask("GET", "/api/hello", "").0, 200);
    drop((strangers, more));
}

#[test]
fn connections_with_the_token_make_room_for_nobody() {
    let desk = desk();
    let server = Server::within(desk.path(), Timeouts { stay: Duration::ZERO, ..PATIENT });
    let head = format!("GET /api/hello HTTP/1.1\r\nHost: {}\r\n", server.host);
    let request = format!("{head}Authorization: Bearer {}\r\n\r\n", server.token);
    let mut own = server.sent(request.as_bytes());
    assert_eq!(status(&mut own), 200);
    let strangers: Vec<TcpStream> = (0..2 * CONNECTIONS).map(|_| server.sent(&[])).collect();
    assert_eq!(server.ask("GET", "/api/hello", "").0, 200);
    own.write_all(request.as_bytes()).unwrap();
    let mut rest = [0; 4096];
    let mut answers = String::new();
    assert!(comes(|| {
        let count = own.read(&mut rest).unwrap_or(0);
        answers.push_str(&String::from_utf8_lossy(&rest[..count]));
        answers.contains("HTTP/1.1 200")
    }));
    drop(strangers);
}

#[test]
fn pages_without_the_token_take_no_seat() {
    let desk = desk();
    let server = Server::within(desk.path(), PATIENT);
    let strangers: Vec<Live> = (0..2 * PAGES).map(|_| server.connection()).collect();
    let mut own: Vec<Live> = (0..PAGES).map(|_| server.live()).collect();
    let mut further = server.connection();
    further.send(&json!({"kind": "hello", "token": server.token}));
    let refused = further.next_of("refused");
    assert_eq!(refused["message"], "too many pages of the studio are open: close some of them");
    own.pop();
    assert!(comes(|| {
        let mut further = server.connection();
        further.send(&json!({"kind": "hello", "token": server.token}));
        further.next().is_some_and(|message| message["kind"] == "hello")
    }));
    drop(strangers);
}

#[test]
fn pages_that_say_nothing_are_let_go() {
    let desk = desk();
    let server = Server::within(desk.path(), Timeouts { hello: SHORT, ..PATIENT });
    let mut page = server.connection();
    assert_eq!(page.next(), None);
}

#[test]
fn a_client_that_takes_nothing_is_let_go() {
    let desk = desk();
    let server = Server::within(desk.path(), Timeouts { write: SHORT, ..PATIENT });
    let mut slow = server.sent(&greedy(&server));
    assert!(comes(|| is_ended(&mut slow)), "the server waits for a client that reads nothing");
}

#[test]
fn pages_that_take_nothing_free_their_seats() {
    let desk = desk();
    let server = Server::within(desk.path(), Timeouts { write: SHORT, ..PATIENT });
    // The answer tells what was not understood: 1 MB each.
    let odd = json!({"kind": "x".repeat(1_000_000)}).to_string();
    let pages: Vec<Live> = (0..PAGES)
        .map(|_| {
            let mut page = server.live();
            page.send_within(SHORT);
            (0..12).for_each(|_| page.send_text(&odd));
            page
        })
        .collect();
    assert!(
        comes(|| {
            let mut further = server.connection();
            further.send(&json!({"kind": "hello", "token": server.token}));
            further.next().is_some_and(|message| message["kind"] == "hello")
        }),
        "the seats of pages that read nothing are never free again"
    );
    drop(pages);
}

#[test]
fn a_connection_ends_however_busy_it_is() {
    let desk = desk();
    let times = Timeouts { connection: SHORT, last_request: SHORT, ..PATIENT };
    let server = Server::within(desk.path(), times);
    // Takes a byte now and then.
    let mut slow = server.sent(&greedy(&server));
    assert!(comes(|| {
        let _ = slow.read(&mut [0; 1]);
        is_ended(&mut slow)
    }));
    // Asks again and again.
    let request =
        format!("GET /api/hello HTTP/1.1\r\nHost: {}\r\nAuthorization: Bearer {}\r\n\r\n", server.host, server.token);
    let mut busy = server.sent(&[]);
    assert!(comes(|| {
        let is_sent = busy.write_all(request.as_bytes()).is_ok();
        !is_sent || busy.read(&mut [0; 4096]).is_ok_and(|count| count == 0)
    }));
    // A live connection stays.
    let mut live = server.live();
    sleep(3 * SHORT);
    live.send(&json!({"kind": "nothing"}));
    live.next_of("refused");
}

#[test]
fn little_is_taken_from_strangers() {
    let desk = desk();
    let server = Server::within(desk.path(), PATIENT);
    // A first message of 1 MB ends the connection before it is there as a whole.
    let mut stranger = server.connection();
    stranger.send(&json!({"kind": "hello", "token": "x".repeat(1_000_000)}));
    assert_eq!(stranger.next(), None);
    let mut live = server.connection();
    live.send(&json!({"kind": "hello", "token": server.token}));
    assert_eq!(live.next().unwrap()["kind"], "hello");
    // The body of a request without the token is not waited for, however it is announced.
    for body in ["Content-Length: 4000000\r\n\r\n", "Transfer-Encoding: chunked\r\n\r\n10\r\nhalf"] {
        let head = format!("PUT /api/file HTTP/1.1\r\nHost: {}\r\n{body}", server.host);
        assert_eq!(status(&mut server.sent(head.as_bytes())), 401, "{body}");
    }
}

#[test]
fn few_bodies_are_read_at_once_and_none_for_long() {
    let desk = desk();
    let server = Server::within(desk.path(), Timeouts { request: Duration::from_secs(3), ..PATIENT });
    let token = &server.token;
    let head = format!("PUT /api/file HTTP/1.1\r\nHost: {}\r\nAuthorization: Bearer {token}\r\n", server.host);
    let half = format!("{head}Content-Length: 4000000\r\n\r\n{{");
    let trickle = format!("{head}Transfer-Encoding: chunked\r\n\r\n1\r\n{{\r\n");
    let mut stalled: Vec<TcpStream> =
        (0..BODIES).map(|number| server.sent([half.as_bytes(), trickle.as_bytes()][number % 2])).collect();
    // What has no body is not kept waiting.
    assert_eq!(server.ask("GET", "/api/hello", "").0, 200);
    let body = json!({"path": "model.toml", "text": "x = 1\n", "tag": null}).to_string();
    let mut further = server.sent(format!("{head}Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    further.set_read_timeout(Some(SHORT)).unwrap();
    assert_eq!(status(&mut further), 0, "more than {BODIES} bodies are read at once");
    for stream in &mut stalled {
        assert_eq!(status(stream), 408);
    }
    further.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    assert!([200, 408].contains(&status(&mut further)));
    assert_eq!(server.ask("PUT", "/api/file", &body.replace("model", "study")).0, 200);
}

#[test]
fn pings_count_among_the_messages_of_a_second() {
    let desk = desk();
    let server = Server::within(desk.path(), PATIENT);
    let mut live = server.live();
    for _ in 0..2000 {
        live.ping();
    }
    assert_eq!(live.next(), None, "2000 pings at once end the connection");
}
