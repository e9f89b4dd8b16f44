"""What the campaigns `faults`, `system-calls`, `saves` and `studio-siege` share: the program, folders as they are, and a client of the studio."""

import base64
import http.client
import json
import os
import shutil
import signal
import socket
import stat
import struct
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MODEL = ROOT / "cases/slider_crank_worn_pin/model.toml"
STUDY = """
name = "faults"
model = "model.toml"
seed = {seed}
[cycle]
transient_turns = 0
recorded_turns = {turns}
samples_per_turn = 60
[sampling]
outer = {outer}
inner = {inner}
[random]
"parameter.crank_length" = {{ normal = {{ mean = "50 mm", standard_deviation = "0.02 mm" }} }}
[epistemic]
"joint.gudgeon.radial_clearance" = {{ interval = ["0.1 mm", "0.5 mm"] }}
[[ask]]
output = "slider"
of = "total"
at = "cycle"
statistics = ["mean", "standard_deviation", {{ quantile = 0.9 }}]
"""
LEARNED = """
[surrogate]
kind = "network"
"""
MARKER = "loosepin.json"
# They differ from run to run, and have no hash.
TIMES = "timing.json"
# Names that stand in a folder while it is written, or after a kill. The store of a study that was killed is dropped by the next.
PASSING_STARTS = (".loosepin-", ".loosepin.lock", "loosepin.lock", "runs.sqlite")
PASSING_ENDS = (".partial", ".replaced")
LONGEST_S = 120
# s; for the end of a studio after Ctrl-C.
LONGEST_END_S = 20


def program():
    if "LOOSEPIN" in os.environ:
        return os.environ["LOOSEPIN"]
    subprocess.run(["cargo", "build", "--release", "--locked", "--package", "loosepin-cli"], cwd=ROOT, check=True)
    return str(ROOT / "target/release/loosepin")


def is_passing(name):
    return name.startswith(PASSING_STARTS) or name.endswith(PASSING_ENDS)


def tree(path, hidden=lambda relative: False):
    """All below `path`, by its name: kind, mode, and bytes or target. What is `hidden` is left out, with all below it."""
    found = {}
    for folder, names, files in os.walk(path):
        for name in [*names, *files]:
            whole = Path(folder) / name
            relative = str(whole.relative_to(path))
            if hidden(relative):
                if name in names:
                    names.remove(name)
                continue
            status = whole.lstat()
            kind, mode = stat.S_IFMT(status.st_mode), stat.S_IMODE(status.st_mode)
            if stat.S_ISREG(kind):
                found[relative] = (kind, mode, whole.read_bytes())
            else:
                found[relative] = (kind, mode, os.readlink(whole) if stat.S_ISLNK(kind) else None)
    return found


def differing(found, expected):
    return sorted(name for name in found.keys() | expected.keys() if found.get(name) != expected.get(name))


def result(path, theirs=()):
    """The bytes of every file of a result; none where there is no folder. Times, files that stand there in passing, and those of `theirs`,
    the user, are no part of it."""
    if not path.is_dir():
        return {}
    files = {file.name: file.read_bytes() for file in path.iterdir() if file.is_file() and not file.is_symlink()}
    if b'"replaced"' in files.get(MARKER, b""):
        # What was replaced and is still to be removed is no part of the result.
        marker = json.loads(files[MARKER])
        del marker["replaced"]
        files[MARKER] = (json.dumps(marker, indent=2, ensure_ascii=False) + "\n").encode()
    return {name: data for name, data in files.items() if name != TIMES and name not in theirs and not is_passing(name)}


def is_finished(path):
    try:
        return b'"is_finished": true' in (path / MARKER).read_bytes()
    except OSError:
        return False


@dataclass
class Answer:
    """Of the studio: its status, 0 where the connection ended without one, and what it says."""

    status: int
    body: dict


class Studio:
    """A server of a folder. `before` is a command that starts it, such as a tracer."""

    def __init__(self, loosepin, folder, before=(), port=0, **more):
        arguments = [*before, loosepin, "serve", ".", "--no-open", *(["--port", str(port)] if port else [])]
        pipes = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL, **more}
        self.process = subprocess.Popen(arguments, cwd=folder, start_new_session=True, text=True, **pipes)
        line = self.process.stdout.readline().strip()
        if not line.startswith("http://"):
            self.end()
            raise RuntimeError(f"the studio did not start: {line}")
        self.host, self.token = line.removeprefix("http://").split("/#token=")
        self.port = int(self.host.rpartition(":")[2])

    def ask(self, method, path, body=None, token=True, timeout=LONGEST_S):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        headers = {"Authorization": f"Bearer {self.token}"} if token else {}
        try:
            payload = None if body is None else json.dumps(body)
            connection.request(method, path, body=payload, headers={**headers, "Connection": "close"})
            response = connection.getresponse()
            said = response.read()
        except (OSError, http.client.HTTPException):
            return Answer(0, {})
        finally:
            connection.close()
        try:
            return Answer(response.status, json.loads(said))
        except ValueError:
            return Answer(response.status, {"text": said.decode(errors="replace")})

    def save(self, path, text, tag):
        return self.ask("PUT", "/api/file", {"path": path, "text": text, "tag": tag})

    def saver(self):
        """Saves over one connection, without a rest between them."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=LONGEST_S)

        def save(path, text, tag):
            body = json.dumps({"path": path, "text": text, "tag": tag})
            try:
                connection.request("PUT", "/api/file", body=body, headers={"Authorization": f"Bearer {self.token}"})
                response = connection.getresponse()
                return Answer(response.status, json.loads(response.read()))
            except (OSError, http.client.HTTPException):
                connection.close()
                return Answer(0, {})

        return save

    def tag(self, path):
        """Of a model as it stands; nothing where it cannot be read."""
        opened = self.ask("GET", f"/api/open?path={path}").body
        return next((one["tag"] for one in (opened.get("model"), opened.get("study")) if one and one["path"] == path), None)

    def kill(self):
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.end()

    def end(self):
        """Ends it as Ctrl-C does; gives its exit status."""
        if self.process.poll() is None:
            self.process.terminate()
        try:
            return self.process.wait(LONGEST_END_S)
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, signal.SIGKILL)
            return self.process.wait()
        finally:
            self.process.stdout.close()


class Live:
    """A live connection to the studio, as far as it is needed here; `token` shows it."""

    def __init__(self, host, token=None, timeout=LONGEST_S):
        name, port = host.split(":")
        self.socket = socket.create_connection((name, int(port)), timeout=timeout)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall(
            f"GET /live HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
            f"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n\r\n".encode())
        self.file = self.socket.makefile("rb")
        self.status = int((self.file.readline().split(b" ", 2) + [b"0", b"0"])[1] or 0)
        while self.file.readline().strip():
            pass
        if token:
            self.send({"kind": "hello", "token": token})
            self.receive()

    def send(self, message):
        payload = json.dumps(message).encode()
        size = len(payload)
        head = bytes([0x81]) + (bytes([0x80 | size]) if size < 126 else
                                bytes([0xFE]) + struct.pack(">H", size) if size < 65536 else bytes([0xFF]) + struct.pack(">Q", size))
        # A mask of zeros leaves the payload as it is.
        self.socket.sendall(head + bytes(4) + payload)

    def receive(self):
        while True:
            head = self.file.read(2)
            if len(head) < 2 or head[0] & 15 == 8:
                raise ConnectionError("the server ended the connection")
            size = head[1] & 127
            size = struct.unpack(">H", self.file.read(2))[0] if size == 126 else struct.unpack(">Q", self.file.read(8))[0] if size == 127 else size
            payload = self.file.read(size)
            if head[0] & 15 == 1:
                return json.loads(payload)

    def close(self):
        self.file.close()
        self.socket.close()


def compile_tool(source, folder):
    """A tool in C beside this file."""
    made = Path(folder) / source.removesuffix(".c")
    if shutil.which("cc") is None:
        sys.exit("error: no C compiler `cc`\nhint: apt-get install gcc")
    subprocess.run(["cc", "-O2", "-o", made, Path(__file__).parent / source], check=True)
    return str(made)
