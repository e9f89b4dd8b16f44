"""What keeps a mechanism from running although it is drawn: said while the texts rest, and beside a run that failed."""

import pytest  # noqa: F401
from test_studio import PROBLEMS, browser, studio  # noqa: F401

RUNS = "document.querySelector('.runs').innerText"
OUTLINE = "document.querySelector('.outline').innerText"
ENDS = "[...document.querySelectorAll('.play-bar .end')].map((one) => one.innerText)"


def test_a_drive_that_cannot_turn_fully_is_a_problem_with_its_range(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    studio.wait(f"({PROBLEMS}).includes('No problems.')")
    assert studio.browser.evaluate(ENDS) == []
    assert "ground, crank, coupler, rocker: crank-rocker, shortest link crank" in studio.browser.evaluate(OUTLINE)
    # 80 + 300 < 260 + 180 becomes 150 + 300 > 260 + 180: the crank comes to cos a = (150² + 300² - 440²) / (2·150·300).
    studio.type_number("crank_length", "150 mm")
    studio.wait(f"({PROBLEMS}).includes('the links cannot close at')")
    assert "1 error" in studio.browser.evaluate(PROBLEMS)
    assert studio.browser.evaluate(ENDS) == ["−154.3°", "154.3°"]
    assert "triple rocker (not Grashof)" in studio.browser.evaluate(OUTLINE)
    # It can be saved, and its run says what stands in its way.
    studio.click("button", "Save and run")
    studio.wait(f"({RUNS}).includes('failed')")
    said = studio.browser.evaluate(RUNS)
    assert "the links cannot close at" in said and "joint 'rocker_pivot' stays 0.056" in said, said
    assert "radial_clearance" not in said
    studio.click(".runs button", "Show all of it")
    studio.wait("document.querySelector('#runs-list:not([hidden])')?.innerText.includes('the lengths do not permit a whole turn')")
    studio.click(".runs > button", "Runs")
    studio.type_number("crank_length", "100 mm")
    studio.wait(f"({PROBLEMS}).includes('No problems.')")
    studio.wait(f"({ENDS}).length === 0")
    assert studio.browser.diagnostics() == []
