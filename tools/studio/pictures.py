"""Makes the pictures of docs/studio.md and docs/design-with-play.md: the gallery, the drawing, a path with its zone, the editor and two results compared, as a reader really gets them, light and dark.

    python3 tools/studio/pictures.py docs/images

Needs Chromium and target/debug/loosepin.
"""

import pathlib
import subprocess
import sys
import tempfile
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tests/browser"))
from chromium import Chromium  # noqa: E402
from test_studio import PROGRAM, Studio  # noqa: E402
from test_studio_draw import wait_for_sheet  # noqa: E402
from test_studio_edit import HINT, PLACE_MM, SHIFT, press_mm, undo  # noqa: E402

# The angle of the drive in the pictures: no dead centre.
PRESSES = 20


def draw_four_bar(studio):
    """As a person would: the crank from the ground, the coupler, and the rocker on its way to the ground."""
    wait_for_sheet(studio)
    for place in [(0, 0), (20, 40), (120, 80)]:
        press_mm(studio, *place)
    studio.wait("document.querySelector('.outline').innerText.includes('link_2')")
    studio.settle()
    x, y = studio.browser.evaluate(PLACE_MM % (140, 0))
    studio.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
    studio.wait("document.querySelector('.drawing text.rubber')")


def finish_with_a_zone(studio):
    """The rocker on the ground, a recorded point beside the coupler, and play between crank and coupler: the path has its zone."""
    press_mm(studio, 140, 0, SHIFT)
    studio.wait("document.querySelector('.outline').innerText.includes('link_3')")
    studio.click(".tools.build label", "Record")
    press_mm(studio, 70, 60)
    studio.wait(f"{HINT}.includes('link_2')")
    press_mm(studio, 60, 100)
    studio.wait("document.querySelector('.drawing .trace')")
    studio.key("Escape")
    press_mm(studio, 20, 40)
    studio.wait("document.querySelector('.known input')")
    studio.browser.evaluate("(document.querySelector('.known input').focus(), true)")
    studio.browser.call("Input.insertText", text="0.05..0.2 mm")
    studio.key("Enter")
    studio.wait("document.querySelector('.drawing .zone-of-path')")
    studio.settle()
    time.sleep(0.5)


def conducted(work):
    """Two studies of the slider-crank, of a worn and of a measured pin; gives their folders as the address of the page has them."""
    places = []
    for name, play in (("worn", "0.5 mm"), ("measured", "0.15 mm")):
        subprocess.run([PROGRAM, "new", "slider-crank", work / name], check=True, capture_output=True)
        study = work / name / "study.toml"
        text = study.read_text().replace('["0.1 mm", "0.5 mm"]', f'["0.1 mm", "{play}"]')
        study.write_text(text.replace('a worn pin"', f'a {name} pin"', 1))
        # 1 is the status of a requirement that is not met.
        done = subprocess.run([PROGRAM, "study", f"{name}/study.toml"], cwd=work, capture_output=True, text=True)
        assert done.returncode in (0, 1), done.stderr
        found = next((work / "results").glob(f"*-{name}-*/*/summary.json")).parent
        places.append(str(found.relative_to(work)).replace("/", "%2F"))
    return "/".join(places)


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
                # The steps of a first visit are closed.
                browser.evaluate("(localStorage.setItem('loosepin-first-visit', 'seen'), true)")
                time.sleep(0.5)
                browser.screenshot(folder / f"studio_gallery_{scheme}.png", whole=False)
                studio.click("button", "Draw from nothing")
                draw_four_bar(studio)
                browser.screenshot(folder / f"studio_draw_{scheme}.png", whole=False)
                finish_with_a_zone(studio)
                if not dark:
                    browser.screenshot(folder / "studio_path_light.png", whole=False)
                # What was drawn is taken back, so that nothing is unsaved.
                undo(studio, 6)
                studio.wait("!document.querySelector('.outline').innerText.includes('link_1')")
                studio.open()
                studio.click("button.card", "rank, coupler and rocker")
                studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
                studio.click(".outline button", "rocker_pin")
                for _ in range(PRESSES):
                    studio.click("button", "+1°")
                # What was clicked was scrolled to; the tools stand above.
                browser.evaluate("(document.querySelector('.stage').scrollTop = 0, true)")
                time.sleep(0.5)
                browser.screenshot(folder / f"studio_editor_{scheme}.png", whole=False)
            # Last, so that the gallery is that of a new folder.
            pair = conducted(work)
            for dark in (False, True):
                browser.view(1280, 1000, dark=dark, reduced_motion=True)
                studio.open()
                browser.evaluate(f"(location.hash = '#/compare/{pair}', true)")
                studio.wait("document.querySelector('.compare svg.chart')")
                time.sleep(0.5)
                browser.screenshot(folder / f"studio_compare_{'dark' if dark else 'light'}.png", whole=False)
        finally:
            studio.close()


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
