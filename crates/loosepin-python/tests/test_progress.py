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


def test_a_notebook_changes_what_it_shows(monkeypatch):
    shown = []

    class Handle:
        def update(self, what):
            shown.append(what)

    display = types.ModuleType("IPython.display")
    display.Pretty = str
    display.display = lambda *what, **options: Handle()
    ipython = types.ModuleType("IPython")
    ipython.get_ipython = lambda: types.SimpleNamespace(kernel=object())
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    line = _progress.listener(True)
    line(30, 60)
    line.close()
    assert shown[0].startswith("[===============") and "30 of at most 60 runs" in shown[0]
    assert shown[1] == ""
