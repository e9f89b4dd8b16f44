"""A small client of headless Chromium over its DevTools pipe: standard library only."""

import base64
import contextlib
import json
import os
import shutil
import subprocess
import tempfile
import time

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


class BrowserError(Exception):
    """The browser is not there, ended, did not answer in time, or answered with an error."""


def find_browser():
    """Path of the browser, or None."""
    chosen = os.environ.get("CHROMIUM")
    if chosen:
        return shutil.which(chosen)
    return next((path for path in map(shutil.which, NAMES) if path), None)


class Chromium:
    """One browser with one tab; use as a context manager."""

    def __init__(self, timeout_s=60.0):
        path = find_browser()
        if path is None:
            raise BrowserError("no Chromium found\nhint: apt-get install chromium, or set CHROMIUM to its path")
        self.timeout_s = timeout_s
        self.profile = tempfile.mkdtemp(prefix="loosepin-browser-")
        command_read, self.command_write = os.pipe()
        self.answer_read, answer_write = os.pipe()
        # Chromium reads commands from descriptor 3 and answers on 4.
        flags = [
            "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
            "--no-first-run", "--disable-background-networking", "--remote-debugging-pipe",
            f"--user-data-dir={self.profile}", "about:blank",
        ]
        script = f'exec "$0" "$@" 3<&{command_read} 4>&{answer_write}'
        self.process = subprocess.Popen(
            ["/bin/bash", "-c", script, path, *flags],
            pass_fds=(command_read, answer_write), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        os.close(command_read)
        os.close(answer_write)
        self.buffer = b""
        self.next_id = 1
        self.events = []
        self.are_scripts_run = True
        target = next(t for t in self._until(self._page_targets))
        self._attach(target)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.process.terminate()
        try:
            self.process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.command_write)
        os.close(self.answer_read)
        shutil.rmtree(self.profile, ignore_errors=True)

    def _page_targets(self):
        infos = self.call("Target.getTargets")["targetInfos"]
        return [info["targetId"] for info in infos if info["type"] == "page"]

    def _attach(self, target):
        """Commands go to this tab from now on."""
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        self.call("Page.setLifecycleEventsEnabled", enabled=True)

    @contextlib.contextmanager
    def another_tab(self, url):
        """A second tab with a page that is there; commands go to it until the end of the block."""
        first = self.session
        # An empty page first: a page that is on its way has no place yet where an expression could be evaluated.
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        try:
            self._attach(target)
            self._navigate(url)
            yield
        finally:
            self.session = first
            self.call("Target.closeTarget", targetId=target)

    def _until(self, condition):
        """What `condition` returns as soon as it is true."""
        deadline = time.monotonic() + self.timeout_s
        while time.monotonic() < deadline:
            value = condition()
            if value:
                return value
            time.sleep(0.05)
        raise BrowserError(f"no answer within {self.timeout_s} s")

    def call(self, method, **parameters):
        """Sends one command and returns its answer; events that come meanwhile are kept in `events`."""
        number = self._send(method, parameters)
        answer = self._next(lambda message: message.get("id") == number)
        if "error" in answer:
            raise BrowserError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def _next(self, is_wanted):
        """The next message that is wanted; events that come before it are kept in `events`."""
        while True:
            message = self._message()
            if is_wanted(message):
                return message
            if message.get("method") == "Page.javascriptDialogOpening":
                # Nobody is there to say whether unsaved texts may go: without an answer the page would wait for ever.
                self._send("Page.handleJavaScriptDialog", {"accept": True})
            if "method" in message:
                self.events.append(message)

    def _send(self, method, parameters):
        message = {"id": self.next_id, "method": method, "params": parameters}
        if getattr(self, "session", None) and not method.startswith("Target."):
            message["sessionId"] = self.session
        self.next_id += 1
        os.write(self.command_write, json.dumps(message).encode() + b"\0")
        return message["id"]

    def _message(self):
        while b"\0" not in self.buffer:
            chunk = os.read(self.answer_read, 1 << 16)
            if not chunk:
                raise BrowserError("the browser has ended")
            self.buffer += chunk
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def evaluate(self, expression):
        """The value of a JavaScript expression in the page; promises are awaited."""
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise BrowserError(f"{expression}: {answer['exceptionDetails']['text']}")
        return answer["result"].get("value")

    def view(self, width, height=900, dark=False, media="screen", reduced_motion=False):
        """Sets the size of the window, its colour scheme and medium."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                  mobile=False)
        self.call("Emulation.setEmulatedMedia", media=media, features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
            {"name": "prefers-reduced-motion", "value": "reduce" if reduced_motion else "no-preference"},
        ])

    def open(self, path, fragment=""):
        """Loads a page from a file, anew if it is there already, and waits until it has drawn itself."""
        self.load("file://" + os.path.abspath(path) + fragment)
        if self.are_scripts_run:
            self.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))")

    def load(self, url):
        """Loads a page anew if it is there already, and waits until it is there."""
        # With another fragment alone the page would stay as it is.
        self.leave()
        self.events.clear()
        self._navigate(url)

    def leave(self):
        """Ends the page; what it asks before it goes is answered with yes."""
        self._navigate("about:blank")

    def reload(self):
        """Loads the page anew and waits until it is there: an expression that the old page gets is lost with it."""
        self._send("Page.reload", {})
        self._next(lambda message: message.get("method") == "Page.loadEventFired")

    def _navigate(self, url):
        """Goes to an address and waits until that page is there: a navigation before that would end this one."""
        number = self._send("Page.navigate", {"url": url})
        loader, loaded = None, set()
        while loader is None or loader not in loaded:
            message = self._next(lambda one: one.get("id") == number or one.get("method") == "Page.lifecycleEvent")
            if "id" not in message:
                if message["params"]["name"] == "load":
                    loaded.add(message["params"]["loaderId"])
                continue
            reason = message["error"]["message"] if "error" in message else message["result"].get("errorText")
            if reason:
                raise BrowserError(f"{url}: {reason}")
            loader = message["result"]["loaderId"]

    def run_scripts(self, are_run):
        """Whether pages that are opened from now on run their scripts; `evaluate` always does, but for promises."""
        self.are_scripts_run = are_run
        self.call("Emulation.setScriptExecutionDisabled", value=not are_run)

    def diagnostics(self):
        """Errors and warnings that the page or the browser reported since it was opened."""
        self.evaluate("true")
        found = []
        for event in self.events:
            parameters = event["params"]
            if event["method"] == "Runtime.exceptionThrown":
                details = parameters["exceptionDetails"]
                found.append(details.get("exception", {}).get("description", details["text"]))
            elif event["method"] == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
                found.append(" ".join(str(a.get("value", a.get("description"))) for a in parameters["args"]))
            elif event["method"] == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
                found.append(parameters["entry"]["text"])
        return found

    def requests(self):
        """Addresses that were asked for since the page was opened, but for the page itself and data in it."""
        sent = (e["params"]["request"]["url"] for e in self.events if e["method"] == "Network.requestWillBeSent")
        return [url for url in sent if not url.startswith(("file:", "data:"))]

    def screenshot(self, path, whole=True):
        """Saves a picture of the page (PNG)."""
        parameters = {"format": "png"}
        if whole:
            size = self.call("Page.getLayoutMetrics")["cssContentSize"]
            parameters["captureBeyondViewport"] = True
            parameters["clip"] = {"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1}
        data = self.call("Page.captureScreenshot", **parameters)["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(data))

    def pdf(self, path):
        """Prints the page to a file (A4, margins of the page's own style)."""
        self.call("Emulation.setEmulatedMedia", media="print", features=[])
        data = self.call("Page.printToPDF", preferCSSPageSize=False, printBackground=False, paperWidth=8.27,
                         paperHeight=11.69, generateTaggedPDF=True)["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(data))
