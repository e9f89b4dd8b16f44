"""Unsaved texts: they outlive the server and its port, belong to one tab, and stay in a page whose key is old."""

import time

import pytest  # noqa: F401
from test_studio import FIELD, Studio, browser, studio  # noqa: F401

NOTICES = "([...document.querySelectorAll('.notice')].map((one) => one.innerText).join(' '))"
EDIT = "(location.hash = '#/edit/four-bar/study.toml', true)"


def has_number(name, text):
    return f"({FIELD % repr(name)})?.querySelector('input').value === {text!r}"


def kept(folder):
    return [path.read_text() for path in (folder / ".drafts").glob("*.json")]


def wait_until_kept(folder, words):
    deadline = time.monotonic() + 30
    while not any(words in text for text in kept(folder)):
        if time.monotonic() > deadline:
            pytest.fail(str(kept(folder)))
        time.sleep(0.05)


def open_text(studio):  # noqa: F811
    """The editor of the four-bar, in a page that is loaded anew."""
    studio.open()
    studio.browser.evaluate(EDIT)
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    studio.settle()


def test_unsaved_texts_are_there_at_another_port(tmp_path, browser):  # noqa: F811
    browser.view(1280, reduced_motion=True)
    first = Studio(tmp_path, browser)
    first.take("rank, coupler and rocker")
    first.type_number("crank_length", "83 mm")
    wait_until_kept(tmp_path, "83 mm")
    first.process.kill()
    first.process.communicate(timeout=60)
    # The page goes on, and can keep nothing: what it shows is what was typed.
    first.type_number("rocker_length", "181 mm")
    assert first.number("crank_length") == "83 mm"
    # The page that has no server is left; the next one, at another port, finds what was kept.
    second = Studio(tmp_path, browser)
    assert second.address.split("/#")[0] != first.address.split("/#")[0], "another port"
    open_text(second)
    second.wait(f"{NOTICES}.includes('that were not saved are here again')")
    assert second.number("crank_length") == "83 mm"
    assert 'crank_length = "80 mm"' in (tmp_path / "four-bar/model.toml").read_text()
    assert 'crank_length = "83 mm"' in second.saved("four-bar")[0]
    # Nothing is left of what is saved.
    deadline = time.monotonic() + 30
    while (tmp_path / ".drafts").exists():
        if time.monotonic() > deadline:
            pytest.fail(str(kept(tmp_path)))
        time.sleep(0.05)
    second.close()


def test_a_second_tab_does_not_take_what_the_first_one_has_not_saved(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    studio.type_number("crank_length", "83 mm")
    wait_until_kept(studio.folder, "83 mm")
    with studio.browser.another_tab(studio.address):
        studio.wait("document.querySelectorAll('button.card').length === 25")
        studio.browser.evaluate(EDIT)
        studio.wait(f"{NOTICES}.includes('Another tab has changes of these texts')")
        studio.wait(has_number("crank_length", "80 mm"))
        # It has changes of its own, which replace none.
        studio.type_number("crank_length", "77 mm")
        wait_until_kept(studio.folder, "77 mm")
        assert len(kept(studio.folder)) == 2
    assert studio.number("crank_length") == "83 mm"
    # A reload is the same tab.
    studio.browser.reload()
    studio.wait(has_number("crank_length", "83 mm"))


def test_a_page_whose_key_is_old_keeps_its_text_and_goes_on_with_the_new_one(tmp_path, browser):  # noqa: F811
    browser.view(1280, reduced_motion=True)
    first = Studio(tmp_path, browser)
    first.take("rank, coupler and rocker")
    first.type_number("crank_length", "83 mm")
    wait_until_kept(tmp_path, "83 mm")
    port = first.address.split(":")[2].split("/")[0]
    first.process.kill()
    first.process.communicate(timeout=60)
    second = Studio(tmp_path, browser, "--port", port)
    # The page connects again, and is refused.
    second.wait(f"{NOTICES}.includes('this page has the old access key')")
    assert second.number("crank_length") == "83 mm"
    second.type_number("rocker_length", "181 mm")
    # The printed address, in this tab: no letter is lost.
    browser.evaluate(f"(location.hash = {('#' + second.address.split('#')[1])!r}, true)")
    second.wait(f"!{NOTICES}.includes('old access key')")
    second.settle()
    model = second.saved("four-bar")[0]
    assert 'crank_length = "83 mm"' in model and 'rocker_length = "181 mm"' in model
    second.close()
