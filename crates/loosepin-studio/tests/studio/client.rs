//! A server of the studio in this process, and a client that speaks as its page does, or worse.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::channel;
use std::thread::JoinHandle;
use std::time::Duration;

use loosepin_studio::Timeouts;
use serde_json::{Value, json};
use tungstenite::{Message, WebSocket};

/// Time for an answer on a busy machine; a test fails where it does not come by then.
const PATIENCE: Duration = Duration::from_secs(60);

/// A server that ends with this.
pub struct Server {
    pub host: String,
    pub token: String,
    stop: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Server {
    pub fn of(folder: &Path) -> Self {
        Self::within(folder, Timeouts::default())
    }

    /// A server that waits as long as `times` says.
    pub fn within(folder: &Path, times: Timeouts) -> Self {
        let stop = Arc::new(AtomicBool::new(false));
        let (sender, receiver) = channel();
        let (flag, folder) = (Arc::clone(&stop), folder.to_owned());
        let thread = std::thread::spawn(move || {
            let ready = |serving: &loosepin_studio::Serving<'_>| sender.send(serving.address.clone()).unwrap();
            loosepin_studio::serve_within(&times, &folder, (0, None), &flag, ready)
                .unwrap_or_else(|error| panic!("{error}"));
        });
        let address = receiver.recv_timeout(PATIENCE).expect("the address");
        let (host, token) = address.strip_prefix("http://").and_then(|rest| rest.split_once("/#token=")).unwrap();
        Self { host: host.to_owned(), token: token.to_owned(), stop, thread: Some(thread) }
    }

    /// A connection that has sent these bytes, and whose client reads when it likes.
    pub fn sent(&self, bytes: &[u8]) -> TcpStream {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        stream.set_write_timeout(Some(Duration::from_millis(500))).unwrap();
        // A server that waits for its answers to be read takes no more.
        let _ = stream.write_all(bytes);
        stream
    }

    /// Sends bytes after which nothing comes, and reads until the server ends the connection.
    pub fn raw(&self, bytes: &[u8]) -> Vec<u8> {
        self.exchange(bytes, true)
    }

    /// Sends a whole request that asks for the end of the connection, and reads until then.
    pub fn whole(&self, request: &str) -> String {
        String::from_utf8_lossy(&self.exchange(request.as_bytes(), false)).into_owned()
    }

    fn exchange(&self, bytes: &[u8], is_cut: bool) -> Vec<u8> {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        // A server that has refused already may have closed.
        let _ = stream.write_all(bytes);
        if is_cut {
            let _ = stream.shutdown(std::net::Shutdown::Write);
        }
        let mut answer = Vec::new();
        let read = stream.read_to_end(&mut answer);
        assert!(!read.is_err_and(|error| is_waiting(&error)), "the server does not end the connection: {answer:?}");
        answer
    }

    /// A request with the token: the status and the body.
    pub fn ask(&self, method: &str, path: &str, body: &str) -> (u16, Value) {
        let token = format!("Authorization: Bearer {}\r\n", self.token);
        self.ask_with(method, path, &token, body)
    }

    /// A request with these headers.
    pub fn ask_with(&self, method: &str, path: &str, headers: &str, body: &str) -> (u16, Value) {
        let request = format!(
            "{method} {path} HTTP/1.1\r\nHost: {}\r\n{headers}Content-Length: {}\r\nConnection: close\r\n\r\n{body}",
            self.host,
            body.len()
        );
        let answer = self.whole(&request);
        let (head, body) = answer.split_once("\r\n\r\n").unwrap_or((&answer, ""));
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
        (status, serde_json::from_str(body).unwrap_or(Value::Null))
    }

    /// A live connection that has said nothing yet.
    pub fn connection(&self) -> Live {
        let stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        let key = tungstenite::handshake::client::generate_key();
        let request = tungstenite::http::Request::builder()
            .uri(format!("ws://{}/live", self.host))
            .header("Host", &self.host)
            .header("Origin", format!("http://{}", self.host))
            .header("Connection", "Upgrade")
            .header("Upgrade", "websocket")
            .header("Sec-WebSocket-Version", "13")
            .header("Sec-WebSocket-Key", key)
            .body(())
            .unwrap();
        let (socket, _) = tungstenite::client(request, stream).unwrap_or_else(|error| panic!("{error}"));
        Live(socket)
    }

    /// A live connection that has shown its token, after the server's greeting.
    pub fn live(&self) -> Live {
        let mut live = self.connection();
        live.send(&json!({"kind": "hello", "token": self.token}));
        assert_eq!(live.next().expect("a greeting")["kind"], "hello");
        live
    }
}

/// Whether reading has ended since nothing came for as long as the client waits: a server that has closed the connection gives another error.
fn is_waiting(error: &std::io::Error) -> bool {
    matches!(error.kind(), std::io::ErrorKind::WouldBlock | std::io::ErrorKind::TimedOut)
}

impl Drop for Server {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        let ended = self.thread.take().map(JoinHandle::join);
        assert!(matches!(ended, Some(Ok(()))), "the server ended with a panic");
    }
}

/// A live connection.
pub struct Live(WebSocket<TcpStream>);

impl Live {
    /// Sending takes no longer than this: a server that waits for its answers to be read takes no more.
    pub fn send_within(&self, time: Duration) {
        self.0.get_ref().set_write_timeout(Some(time)).unwrap();
    }

    pub fn send(&mut self, message: &Value) {
        self.send_text(&message.to_string());
    }

    pub fn send_text(&mut self, text: &str) {
        // The server may have ended the connection, which the next answer says.
        let _ = self.0.send(Message::text(text));
    }

    pub fn ping(&mut self) {
        let _ = self.0.send(Message::Ping(b"ping".to_vec().into()));
    }

    pub fn send_bytes(&mut self, bytes: &[u8]) {
        let _ = self.0.send(Message::binary(bytes.to_vec()));
    }

    /// The next message; nothing after the end of the connection.
    pub fn next(&mut self) -> Option<Value> {
        loop {
            match self.0.read() {
                Ok(Message::Text(text)) => return serde_json::from_str(&text).ok(),
                Err(tungstenite::Error::Io(error)) if is_waiting(&error) => {
                    panic!("no message, and no end, in {PATIENCE:?}")
                }
                Ok(Message::Close(_)) | Err(_) => return None,
                Ok(_) => {}
            }
        }
    }

    /// The next message of a kind.
    pub fn next_of(&mut self, kind: &str) -> Value {
        loop {
            let message = self.next().unwrap_or_else(|| panic!("the connection ended before '{kind}'"));
            if message["kind"] == kind {
                return message;
            }
        }
    }

    /// What is seen of a model and a study.
    pub fn look(&mut self, seq: u64, model: (&str, &str), study: Option<(&str, &str)>) -> Value {
        self.look_for(seq, model, study, json!({}))
    }

    /// As [`Self::look`], with further entries of the message.
    pub fn look_for(&mut self, seq: u64, model: (&str, &str), study: Option<(&str, &str)>, further: Value) -> Value {
        let text = |(path, text): (&str, &str)| json!({"path": path, "text": text});
        let mut message = json!({
            "kind": "look", "seq": seq, "model": text(model), "study": study.map(text), "positions": 72
        });
        if let (Some(message), Value::Object(further)) = (message.as_object_mut(), further) {
            message.extend(further);
        }
        self.send(&message);
        self.next_of("look_answer")
    }
}
