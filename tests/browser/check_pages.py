#!/usr/bin/env python3
"""Loads report pages in headless Chromium and fails on anything that a reader would stumble over.

    cargo run --example report_pages -- target/report_pages
    python3 tests/browser/check_pages.py target/report_pages/*.html [--pictures FOLDER]

For each page, wide and narrow, light and dark: no error or warning on the console, nothing asked for from outside, every
chart and mechanism drawn, read-out, legend, zoom, keyboard and animation at work, no sideways scrolling; on paper, a PDF.
Needs Python's standard library and Chromium only. Exit status: 0 all well, 1 complaints, 2 no browser or no page.
"""

import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from chromium import BrowserError, Chromium, find_browser  # noqa: E402

WIDTHS_PX = (1280, 768, 400)
# Less than this and a printed page is empty.
SMALLEST_PDF_BYTES = 20_000

CHARTS = """[...document.querySelectorAll('[data-chart]')].map((holder) => {
    const canvas = holder.querySelector('canvas');
    const pixels = canvas ? canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data : [];
    let painted = 0;
    for (let i = 3; i < pixels.length; i += 4) painted += pixels[i] > 0;
    return { id: holder.dataset.chart, drawn: holder.dataset.drawn === 'true', painted: painted };
})"""

SIDEWAYS = """(() => {
    const width = document.documentElement.clientWidth;
    if (document.documentElement.scrollWidth <= width) return [];
    return [...document.querySelectorAll('body *')]
        .filter((element) => element.getBoundingClientRect().right > width + 1 && !element.closest('.scroll'))
        .slice(0, 3).map((element) => element.outerHTML.slice(0, 120));
})()"""

CHART_USE = """(async () => {
    const problems = [];
    const frames = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    for (const holder of document.querySelectorAll('[data-chart]')) {
        const figure = holder.closest('figure');
        const id = holder.dataset.chart;
        const key = (name) => holder.dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true, cancelable: true }));
        holder.focus();
        if (document.activeElement !== holder) problems.push(id + ': cannot be reached with the keyboard');
        key('ArrowRight');
        await frames();
        if (!/\\d/.test(figure.querySelector('.position').textContent)) problems.push(id + ': no read-out after an arrow key');
        if (![...figure.querySelectorAll('[data-value]')].some((value) => /\\d/.test(value.textContent))) problems.push(id + ': read-out without values');
        key('+');
        await frames();
        const reset = figure.querySelector('.reset');
        if (reset.hidden) problems.push(id + ': not enlarged by +');
        reset.click();
        await frames();
        if (!reset.hidden) problems.push(id + ': not reset');
        const button = figure.querySelector('[data-entry]');
        button.click();
        if (button.getAttribute('aria-pressed') !== 'false') problems.push(id + ': a curve cannot be hidden');
        button.click();
        if (button.getAttribute('aria-pressed') !== 'true') problems.push(id + ': a curve cannot be shown again');
    }
    return problems;
})()"""

MECHANISM_USE = """(async () => {
    const problems = [];
    const wait = (ms) => new Promise((done) => setTimeout(done, ms));
    for (const figure of document.querySelectorAll('[data-mechanism]')) {
        const id = figure.dataset.mechanism;
        if (figure.dataset.drawn !== 'true') { problems.push(id + ': not drawn'); continue; }
        const pose = () => [...figure.querySelectorAll('[data-body]')].map((body) => body.getAttribute('transform')).join();
        const play = figure.querySelector('.play');
        if (play.getAttribute('aria-pressed') !== 'false') problems.push(id + ': moves although less motion is asked for');
        const before = pose();
        play.click();
        await wait(300);
        if (pose() === before) problems.push(id + ': does not move when played');
        play.click();
        const paused = pose();
        await wait(150);
        if (pose() !== paused) problems.push(id + ': does not stop when paused');
        const slider = figure.querySelector('.pose');
        slider.value = String(Math.floor(Number(slider.max) / 3));
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        if (pose() === paused) problems.push(id + ': does not follow the slider');
        const choice = figure.querySelector('.magnification');
        if (choice) {
            const shown = pose();
            choice.selectedIndex = choice.selectedIndex === 0 ? 1 : 0;
            choice.dispatchEvent(new Event('change', { bubbles: true }));
            if (pose() === shown) problems.push(id + ': the deviation is not magnified');
        }
    }
    return problems;
})()"""

UNLABELLED = """[...document.querySelectorAll('button, input, select, summary, [tabindex]')]
    .filter((element) => !(element.textContent.trim() || element.getAttribute('aria-label')))
    .map((element) => element.outerHTML.slice(0, 120))"""


def check(browser, path, pictures):
    """Complaints about one page."""
    name = os.path.splitext(os.path.basename(path))[0]
    found = []
    for width in WIDTHS_PX:
        for dark in (False, True):
            where = f"{name}, {width} px, {'dark' if dark else 'light'}"
            browser.view(width, dark=dark, reduced_motion=True)
            browser.open(path)
            found += [f"{where}: {text}" for text in browser.complaints()]
            found += [f"{where}: asks for {url}" for url in browser.requests()]
            found += [f"{where}: scrolls sideways: {text}" for text in browser.evaluate(SIDEWAYS)]
            found += [f"{where}: chart {chart['id']} is empty" for chart in browser.evaluate(CHARTS)
                      if not chart["drawn"] or chart["painted"] == 0]
            if pictures:
                scheme = "dark" if dark else "light"
                browser.screenshot(os.path.join(pictures, f"{name}-{width}-{scheme}.png"))
    browser.view(WIDTHS_PX[0], reduced_motion=True)
    browser.open(path)
    if browser.evaluate("document.querySelectorAll('[data-chart]').length") == 0:
        found.append(f"{name}: has no chart")
    for script in (CHART_USE, MECHANISM_USE):
        found += [f"{name}: {text}" for text in browser.evaluate(script)]
    found += [f"{name}: without a name: {text}" for text in browser.evaluate(UNLABELLED)]
    found += [f"{name}: in use: {text}" for text in browser.complaints()]
    browser.open(path)
    pdf = os.path.join(pictures or browser.profile, f"{name}.pdf")
    browser.pdf(pdf)
    if os.path.getsize(pdf) < SMALLEST_PDF_BYTES:
        found.append(f"{name}: prints to {os.path.getsize(pdf)} bytes only")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("pages", nargs="+", metavar="PAGE.html")
    parser.add_argument("--pictures", metavar="FOLDER", help="keep screenshots and PDFs here")
    options = parser.parse_args()
    missing = [path for path in options.pages if not os.path.isfile(path)]
    if missing:
        print(f"check_pages: no such page: {missing[0]}", file=sys.stderr)
        return 2
    if find_browser() is None:
        print("check_pages: no Chromium found\nhint: apt-get install chromium, or set CHROMIUM to its path", file=sys.stderr)
        return 2
    if options.pictures:
        os.makedirs(options.pictures, exist_ok=True)
    found = []
    try:
        with Chromium() as browser:
            for path in options.pages:
                found += check(browser, path, options.pictures)
    except BrowserError as error:
        print(f"check_pages: {error}", file=sys.stderr)
        return 2
    for text in found:
        print(text)
    print(f"{len(options.pages)} pages, {len(found)} complaints")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
