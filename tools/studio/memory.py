"""How much memory the page of the studio takes while a study of 100,000 runs goes on, and with its report open.

    cargo build --release --locked --package loosepin-cli
    python3 tools/studio/memory.py target/release/loosepin

Prints the largest memory of the process that draws the page, and of its scripts. Needs Chromium; nothing is asserted.
"""

import pathlib
import subprocess
import sys
import tempfile
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tests/browser"))
import test_studio  # noqa: E402
from chromium import Chromium  # noqa: E402

LONGEST_S = 1200
DONE = "[...document.querySelectorAll('button, a')].some((one) => one.textContent.includes('Open the report'))"


def children(process):
    """All processes below one."""
    tasks = pathlib.Path(f"/proc/{process}/task").glob("*/children")
    below = [int(child) for task in tasks for child in task.read_text().split()]
    return below + [one for child in below for one in children(child)]


def page_mb(browser):
    """Memory of the largest process that draws a page: own pages, and shared ones by their share."""
    sizes = [0.0]
    for process in children(browser.process.pid):
        folder = pathlib.Path(f"/proc/{process}")
        try:
            if b"--type=renderer" in (folder / "cmdline").read_bytes():
                line = next(line for line in (folder / "smaps_rollup").read_text().splitlines() if line.startswith("Pss:"))
                sizes.append(int(line.split()[1]) / 1024)
        except (FileNotFoundError, ProcessLookupError):
            continue  # It has ended since.
    return max(sizes)


def main(program):
    test_studio.PROGRAM = program
    with tempfile.TemporaryDirectory() as desk, Chromium() as browser:
        served = pathlib.Path(desk) / "mechanisms"
        served.mkdir()
        subprocess.run([program, "new", "scotch-yoke", served / "scotch-yoke"], check=True, capture_output=True)
        study = served / "scotch-yoke/study.toml"
        study.write_text(study.read_text().replace("outer = 16 ", "outer = 64 ").replace("inner = 256 ", "inner = 1536 "))
        browser.view(1280, reduced_motion=True)
        browser.call("Performance.enable")
        studio = test_studio.Studio(served, browser)

        def seen():
            metrics = {one["name"]: one["value"] for one in browser.call("Performance.getMetrics")["metrics"]}
            return page_mb(browser), metrics["JSHeapUsedSize"] / 1e6

        try:
            studio.open()
            studio.click(".shelf .open", "scotch-yoke/study.toml")
            studio.wait("document.querySelector('.drawing .grip')")
            studio.settle()
            before = seen()
            studio.click("button", "Save and run")
            during, began = [], time.monotonic()
            while not browser.evaluate(DONE):
                during.append(seen())
                assert time.monotonic() - began < LONGEST_S, browser.evaluate("document.body.innerText")
                time.sleep(1)
            strip = browser.evaluate("document.querySelector('.runs, .jobs')?.innerText ?? ''").replace("\n", " ")
            studio.click("button, a", "Open the report")
            studio.wait("document.querySelector('iframe')?.getAttribute('src')?.includes('/view/')")
            time.sleep(3)
            after = seen()
        finally:
            studio.close()
    print(strip)
    for what, (page, scripts) in (("editor", before), ("while the study runs", tuple(map(max, zip(*during, strict=True)))), ("with its report", after)):
        print(f"{what:22} page {page:6.1f} MB, scripts {scripts:5.1f} MB")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()))
