"""How far a study is, in a terminal and in a notebook."""

import io
import sys
import types

from loosepin import _progress


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_a_terminal_shows_one_line_that_goes(monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    line = _progress.listener(True)
    line(0, 200)
    line._next = 0
    line(50, 200)
    line.close()
    shown = terminal.getvalue().split("\r\x1b[K")
    assert shown[1] == "[" + " " * 30 + "] 0 of at most 200 runs, the first runs have started"
    assert shown[2].startswith("[=======" + " " * 23 + "] 50 of at most 200 runs, at most ")
    assert shown[3] == ""


def test_nothing_is_shown_where_nobody_looks(monkeypatch):
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    assert _progress.listener(True) is None
    assert _progress.listener(False) is None


def test_a_notebook_shows_a_bar_that_goes(monkeypatch):
    shown = []

    class Handle:
        def update(self, data, raw):
            assert raw
            shown.append(data)

    def display(data, raw, display_id):
        assert raw and display_id
        shown.append(data)
        return Handle()

    module = types.ModuleType("IPython.display")
    module.display = display
    ipython = types.ModuleType("IPython")
    ipython.get_ipython = lambda: types.SimpleNamespace(kernel=object())
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    monkeypatch.setitem(sys.modules, "IPython.display", module)
    _progress.listener(True).close()
    assert not shown, "work without progress leaves no output"
    bar = _progress.listener(True, "<values>")
    bar(30, 60)
    bar.close()
    assert shown[0]["text/plain"].startswith("[===============" + " " * 15 + "] 30 of at most 60 <values>, ")
    assert '<progress value="30" max="60"' in shown[0]["text/html"] and "30 of at most 60 &lt;values&gt;, " in shown[0]["text/html"]
    assert shown[1:] == [{"text/plain": "", "text/html": ""}]
