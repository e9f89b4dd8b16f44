"""What if the unknown values were known: each value that was run gives the first chart its own band, and the outer band stays."""

import pathlib
import subprocess
import sys

import pytest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chromium import Chromium  # noqa: E402

STORED = "JSON.parse(document.querySelector('[data-what-if] script').textContent)"
# Chooses a value on the map, then reads the inner and the outer band where the cursor stands.
CHOSEN = """((place) => {
    const holder = document.querySelector('[data-what-if]');
    const dot = holder.querySelectorAll('.map circle')[place];
    dot.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true, cancelable: true }));
    const chart = document.getElementById(holder.dataset.whatIf);
    const read = (entry) => chart.querySelector(`[data-value="${entry}"]`).textContent;
    const path = (kind) => chart.querySelector(`.fill.${kind}`).getAttribute('d');
    return {
        isShown: !holder.hidden, words: holder.querySelector('.chosen').textContent, pressed: dot.getAttribute('aria-pressed'),
        inner: read(1), outer: read(0), innerPath: path('random'), outerPath: path('mixed'),
    };
})(%d)"""
MOVED = """(() => {
    const holder = document.getElementById('deviation.slider').querySelector('[data-chart]');
    const key = (name) => holder.dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true, cancelable: true }));
    key('ArrowRight');
    return [...document.querySelectorAll('[data-figure="deviation.slider"] .cursor')].length;
})()"""


def numbers(text):
    return [float(part.strip().split("\u202f")[0].replace("−", "-").split()[0]) for part in text.split("…")]


# What says which band is shown, and the curves.
SAID = """(() => {
    const holder = document.querySelector('[data-what-if]');
    const figure = document.getElementById(holder.dataset.whatIf);
    return {
        caption: figure.querySelector('figcaption').innerHTML, legend: [...figure.querySelectorAll('.label')].map((label) => label.innerHTML),
        paths: [...figure.querySelectorAll('[data-of]')].map((path) => path.outerHTML),
        read: [...figure.querySelectorAll('[data-value]')].map((value) => value.textContent),
        chosen: holder.querySelector('.chosen').textContent, isBackShown: !holder.querySelector('.reset').hidden,
        choice: [...holder.querySelectorAll('input, select')].map((one) => one.value),
        pressed: holder.querySelectorAll('[aria-pressed="true"]').length,
    };
})()"""
BACK = "document.querySelector('[data-what-if] .reset').click()"
# Chooses a member of the list, by its place, or a value on the slider that is shown.
LISTED = """((member, place) => {
    const holder = document.querySelector('[data-what-if]');
    const list = holder.querySelector('select');
    if (member !== null) {
        list.selectedIndex = member;
        list.dispatchEvent(new Event('change', { bubbles: true }));
    }
    const sliders = [...holder.querySelectorAll('input')].filter((slider) => slider.getBoundingClientRect().width > 0);
    if (place !== null) {
        sliders[0].value = String(place);
        sliders[0].dispatchEvent(new Event('input', { bubbles: true }));
    }
    return { shown: sliders.length, steps: Number(sliders[0].max) + 1, chosen: holder.querySelector('.chosen').textContent };
})(%s, %s)"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    folder = tmp_path_factory.mktemp("what-if")
    subprocess.run([REPOSITORY / "target/debug/examples/report_pages", folder], check=True)
    with Chromium() as browser:
        browser.view(1280, reduced_motion=True)
        browser.pages = folder
        browser.open(str(folder / "study.html"))
        yield browser


def test_every_value_that_was_run_gives_its_own_band(browser):
    stored = browser.evaluate(STORED)
    assert browser.evaluate(MOVED) == 1
    # The cursor begins in the middle of the curve, and the arrow has moved it by one.
    row = len(stored["points"][0]["lower"]) // 2 + 1
    low, high = stored["range"]
    before = browser.evaluate(CHOSEN % 0)
    for place, point in enumerate(stored["points"]):
        now = browser.evaluate(CHOSEN % place)
        assert now["isShown"] and now["pressed"] == "true"
        assert now["words"].startswith(point["words"][0].upper() + point["words"][1:]) and f"counted from {point['runs']} runs" in now["words"]
        due = [low + point[end][row] / 9999 * (high - low) for end in ("lower", "upper")]
        # Read off to a thousandth of the axis; stored in 9999 steps of all bands.
        for found, value in zip(numbers(now["inner"]), due, strict=True):
            assert abs(found - value) < 1e-3 + 1e-4 * (high - low), (point["words"], now["inner"], due)
        assert now["outer"] == before["outer"] and now["outerPath"] == before["outerPath"]
    bands = {browser.evaluate(CHOSEN % place)["innerPath"] for place in range(len(stored["points"]))}
    assert len(bands) == len(stored["points"]), "each value has a band of its own"
    assert not browser.diagnostics()


def test_caption_and_legend_say_what_is_shown_and_come_back(browser):
    browser.open(str(browser.pages / "study.html"))
    browser.evaluate(MOVED)
    before = browser.evaluate(SAID)
    assert not before["isBackShown"] and not before["chosen"]
    assert "mid-range values of the unknown inputs" in before["caption"] and before["legend"][1].endswith("random scatter only")
    point = browser.evaluate(STORED)["points"][4]
    browser.evaluate(CHOSEN % 4)
    now = browser.evaluate(SAID)
    assert now["isBackShown"] and now["pressed"] == 1
    words = point["words"].replace("\u00a0", "&nbsp;")
    assert f'inside the blue band for <span data-inner="">{words} (chosen below)</span>' in now["caption"]
    assert now["legend"][1] == f"95&nbsp;%, scatter at {words}"
    assert now["legend"][0] == before["legend"][0] and now["paths"] != before["paths"] and now["read"] != before["read"]
    browser.evaluate(BACK)
    assert browser.evaluate(SAID) == before
    assert not browser.diagnostics()


def test_members_of_a_list_have_values_of_their_own(browser):
    browser.open(str(browser.pages / "lists.html"))
    before = browser.evaluate(SAID)
    stored = browser.evaluate(STORED)
    for member, _ in enumerate(stored["groups"]):
        own = [point for point in stored["points"] if point["group"] == member]
        # A new member begins in the middle of its values.
        now = browser.evaluate(LISTED % (member, "null"))
        assert now["shown"] == 1 and now["steps"] == len(own) == 5
        middle = own[2]["words"]
        assert now["chosen"].startswith(middle[0].upper() + middle[1:])
        for place, point in enumerate(own):
            chosen = browser.evaluate(LISTED % ("null", place))["chosen"]
            assert chosen.startswith(point["words"][0].upper() + point["words"][1:]), (member, place, chosen)
    browser.evaluate(BACK)
    assert browser.evaluate(SAID) == before
    assert not browser.diagnostics()
