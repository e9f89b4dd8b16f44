"""Makes the pictures of docs/studio.md: the gallery, the drawing and the editor as a reader really gets them, light and dark.

    python3 tools/studio/pictures.py docs/images

Needs Chromium and target/debug/loosepin.
"""

import pathlib
import sys
import tempfile
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tests/browser"))
from chromium import Chromium  # noqa: E402
from test_studio import CANVAS, Studio, click_in_canvas  # noqa: E402

# The angle of the drive in the pictures: no dead centre.
PRESSES = 20


def draw_four_bar(studio):
    """As a person would: two clicks a link, Shift for the ground, then the motor."""
    studio.wait(CANVAS)
    shift = 8
    click_in_canvas(studio, 0, 0, shift)
    for place in [(30, 70), (30, 70), (240, 150), (240, 150)]:
        click_in_canvas(studio, *place)
    click_in_canvas(studio, 300, 0, shift)
    studio.browser.evaluate("(document.querySelector('input[value=motor]').click(), true)")
    click_in_canvas(studio, 0, 0)
    studio.wait("document.querySelector('.said').innerText.includes('1 degree of freedom')")


def main(folder):
    # The name of the folder stands in the picture.
    with tempfile.TemporaryDirectory() as desk, Chromium() as browser:
        work = pathlib.Path(desk) / "mechanisms"
        work.mkdir()
        studio = Studio(work, browser)
        try:
            for dark in (False, True):
                scheme = "dark" if dark else "light"
                browser.view(1280, 800, dark=dark, reduced_motion=True)
                studio.open()
                time.sleep(0.5)
                browser.screenshot(folder / f"studio_gallery_{scheme}.png", whole=False)
                studio.click("button", "Draw from nothing")
                draw_four_bar(studio)
                browser.screenshot(folder / f"studio_draw_{scheme}.png", whole=False)
                studio.open()
                studio.click("button.card", "rank, coupler and rocker")
                studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
                studio.click(".outline button", "rocker_pin")
                for _ in range(PRESSES):
                    studio.click("button", "+1°")
                time.sleep(0.5)
                browser.screenshot(folder / f"studio_editor_{scheme}.png", whole=False)
        finally:
            studio.close()


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
