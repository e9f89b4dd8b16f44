"""A page that shows widgets as a notebook does: the models of JavaScript are here, those of Python in the test.

It stands for the two ends of a notebook's front end: the protocol of models that anywidget hands to a module (get, set, save_changes, on,
off), and the messages of Jupyter widgets between a page and a kernel.
"""

import json

import comm
from comm.base_comm import BaseComm

PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Notebook</title>
<style>body { font: 14px sans-serif; margin: 1rem; } body.light { background: #fff; color: #222; } body.dark { background: #111; color: #ddd; }
/* What a notebook may say about everything in it. */
svg, path, button { outline: 3px solid red !important; } .plot, .opening { display: none !important; }</style></head>
<body class="light"><h1>A notebook</h1><main id="cells"></main>
<script>
const models = {}, sent = [];
function model(name, state) {
  const listeners = [];
  let changed = {};
  return models[name] = {
    get: (key) => state[key],
    set(key, value) {
      if (state[key] === value) return;
      state[key] = changed[key] = value;
      listeners.filter(([event]) => event === 'change:' + key).forEach(([, hear]) => hear());
    },
    save_changes() { sent.push([name, changed]); changed = {}; },
    on: (event, hear) => listeners.push([event, hear]),
    off: (event, hear) => listeners.splice(listeners.findIndex((each) => each[0] === event && each[1] === hear), 1),
    receive(update) { Object.entries(update).forEach(([key, value]) => this.set(key, value)); changed = {}; },
    listeners,
  };
}
async function show(name, state) {
  const { default: widget } = await import('data:text/javascript;charset=utf-8,' + encodeURIComponent(state._esm));
  const cell = document.createElement('div');
  cell.id = name;
  document.getElementById('cells').append(cell);
  models[name].close = widget.render({ model: models[name], el: cell });
}
</script></body></html>
"""


class Wire(BaseComm):
    """The end of a widget in Python: what it sends is kept."""

    def __init__(self, *arguments, **options):
        self.sent = []
        super().__init__(*arguments, **options)

    def publish_msg(self, kind, data=None, metadata=None, buffers=None, **_):
        self.sent.append((kind, data or {}))

    def updates(self):
        """The changes of traits since the last call."""
        found = [data["state"] for kind, data in self.sent if kind == "comm_msg" and data.get("method") == "update"]
        self.sent.clear()
        return found


class Notebook:
    """A page in the browser with widgets of this process."""

    def __init__(self, browser, folder, monkeypatch):
        monkeypatch.setattr(comm, "create_comm", Wire)
        self.browser = browser
        self.widgets = {}
        path = folder / "notebook.html"
        path.write_text(PAGE, encoding="utf-8")
        browser.open(path)

    def show(self, name, widget):
        """Shows a widget in a cell of its own, and waits until its figure has answered."""
        self.widgets[name] = widget
        state = json.dumps(widget.get_state())
        self.browser.evaluate(f"(model({name!r}, {state}), show({name!r}, {state}))")
        self.wait(lambda: self.browser.evaluate(f"document.querySelector('#{name} iframe').style.visibility") == "visible")

    def exchange(self):
        """What a kernel and a page send each other, until both are silent."""
        for name, changed in self.browser.evaluate("sent.splice(0)"):
            message = {"content": {"data": {"method": "update", "state": changed, "buffer_paths": []}}, "buffers": []}
            self.widgets[name]._handle_msg(message)
        for name, widget in self.widgets.items():
            for update in widget.comm.updates():
                self.browser.evaluate(f"models[{name!r}].receive({json.dumps(update)})")

    def wait(self, condition):
        def answered():
            self.exchange()
            return condition()

        return self.browser._until(answered)

    def inside(self, name, expression):
        """The value of an expression in the figure of a cell, whose frame has an origin of its own."""
        call = self.browser.call
        root = call("DOM.getDocument")["root"]["nodeId"]
        node = call("DOM.querySelector", nodeId=root, selector=f"#{name} iframe")["nodeId"]
        frame = call("DOM.describeNode", nodeId=node)["node"]["frameId"]
        if any(target["targetId"] == frame for target in call("Target.getTargets")["targetInfos"]):
            return self._in_process_of(frame, expression)
        world = call("Page.createIsolatedWorld", frameId=frame)["executionContextId"]
        answer = call("Runtime.evaluate", expression=expression, contextId=world, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in answer, answer
        return answer["result"].get("value")

    def _in_process_of(self, frame, expression):
        session = self.browser.session
        self.browser.session = self.browser.call("Target.attachToTarget", targetId=frame, flatten=True)["sessionId"]
        try:
            return self.browser.evaluate(expression)
        finally:
            self.browser.session = session
