"""Every page that the program writes, loaded in headless Chromium: made-up results for all kinds of page, and the report of a
real simulation, motion and sweep."""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chromium import Chromium  # noqa: E402

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
BUILT = REPOSITORY / "target" / "debug"
CHECK = REPOSITORY / "tests" / "browser" / "check_pages.py"
# Heights of a phone's screen down to the first table that is seen.
FIRST_TABLE = """[...document.querySelectorAll('table')].find((table) => table.getBoundingClientRect().height > 0 && !table.closest('details'))
    .getBoundingClientRect().top / innerHeight"""


# Crank and rod of the worn pin without its play: the stroke of the slider fixes the crank, its largest position the sum of both.
MEASURED = """
name = "crank and rod"
model = "model.toml"
[cycle]
transient_turns = 0
recorded_turns = 1
[epistemic]
"parameter.crank_length" = { interval = ["49 mm", "51 mm"] }
"parameter.rod_length" = { interval = ["118 mm", "122 mm"] }
[sampling]
outer = 8
inner = 8
[[ask]]
output = "slider"
of = "total"
reduce = "rms"
statistics = ["mean"]
[[measured]]
kind = "motion"
output = "slider"
feature = "range"
value = "100 mm"
error = "0.4 mm"
[[measured]]
kind = "motion"
output = "slider"
feature = "maximum"
value = "170 mm"
error = "0.2 mm"
instrument = "gauge"
"""


def run(program, *arguments):
    """Runs what `just browser-tests` has built."""
    subprocess.run([BUILT / program, *map(str, arguments)], cwd=REPOSITORY, check=True)


def check(pages):
    assert pages, "no page was written"
    finished = subprocess.run(
        [sys.executable, str(CHECK), *map(str, pages)], cwd=REPOSITORY, capture_output=True, text=True
    )
    assert finished.returncode == 0, finished.stdout + finished.stderr


def test_pages_of_made_up_results(tmp_path):
    run("examples/report_pages", tmp_path)
    check(sorted(tmp_path.glob("*.html")))


def test_pages_of_identifications(tmp_path):
    text = (REPOSITORY / "cases" / "slider_crank_worn_pin" / "model.toml").read_text(encoding="utf-8")
    of_play = ("bearing_radius", "radial_clearance", "contact =")
    lines = [line for line in text.splitlines() if not line.startswith(of_play)]
    (tmp_path / "model.toml").write_text("\n".join(lines), encoding="utf-8")
    (tmp_path / "measured.toml").write_text(MEASURED, encoding="utf-8")
    run("loosepin", "identify", tmp_path / "measured.toml", "--points", "300", "--compare", "--out", tmp_path / "motion")
    run("loosepin", "identify", REPOSITORY / "cases" / "backlash_test" / "study.toml", "--out", tmp_path / "readings")
    check([tmp_path / kind / "report.html" for kind in ("motion", "readings")])


def test_pages_of_a_real_run(tmp_path):
    model = REPOSITORY / "cases" / "slider_crank_5000" / "model.toml"
    run("loosepin", "simulate", model, "--turns", "1", "--transient", "0", "--out", tmp_path / "simulation")
    run("loosepin", "motion", model, "--out", tmp_path / "motion")
    swept = "joint.gudgeon.radial_clearance=0.1mm..0.5mm"
    run("loosepin", "sweep", model, "--over", swept, "--points", "6", "--transient", "0", "--turns", "4", "--out", tmp_path / "sweep")
    check([tmp_path / kind / "report.html" for kind in ("simulation", "motion", "sweep")])
    with Chromium() as browser:
        browser.view(400, 800, reduced_motion=True)
        browser.open(str(tmp_path / "simulation" / "report.html"))
        assert browser.evaluate(FIRST_TABLE) < 6
