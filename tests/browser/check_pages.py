#!/usr/bin/env python3
"""Loads report pages in headless Chromium and fails on anything that a reader would stumble over.

    cargo run --example report_pages -- target/report_pages
    python3 tests/browser/check_pages.py target/report_pages/*.html [--pictures FOLDER]

For each page, wide and narrow, light and dark: no error or warning on the console, nothing asked for from outside, every
chart and mechanism drawn, read-out, legend, zoom, keyboard and animation at work, one cursor for all, no sideways scrolling, no
diagnostic of axe-core; on paper, no torn row of a table and no head alone at the foot of a sheet.
Needs Python's standard library, Chromium, and axe-core where `just page-scripts` puts it. Exit status: 0 all well, 1 diagnostics,
2 no browser, no page or no axe-core.
"""

import argparse
import os
import pathlib
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from chromium import BrowserError, Chromium, find_browser  # noqa: E402
from paper import Paper  # noqa: E402

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
AXE = REPOSITORY / "crates/loosepin-report/scripts/node_modules/axe-core/axe.min.js"

WIDTHS_PX = (1280, 768, 400, 320)
# Where axe-core looks at a page.
AXE_WIDTHS_PX = (1280, 400)
# A finger needs this much; links within sentences are as high as their line.
LEAST_TARGET_PX = 24
# The angle with which a page is opened.
OPENED_AT_DEG = 93

# Sections of a folded page are closed at first; charts fit their room when they are opened.
OPEN_ALL = """new Promise((done) => {
    document.querySelectorAll('details.fold').forEach((fold) => { fold.open = true; });
    requestAnimationFrame(() => requestAnimationFrame(() => done(true)));
})"""

CHARTS = """[...document.querySelectorAll('[data-chart]')].map((holder) => {
    const svg = holder.querySelector('svg.chart');
    const seen = svg ? svg.getBoundingClientRect() : { width: 0, height: 0 };
    const curves = svg ? [...svg.querySelectorAll('.curves path')] : [];
    return {
        id: holder.dataset.chart, drawn: holder.dataset.drawn === 'true', isSeen: seen.width > 100 && seen.height > 100,
        curves: curves.filter((curve) => curve.getBBox().width > 0).length,
        cut: svg ? [...svg.querySelectorAll('text')].filter((text) => {
            const box = text.getBoundingClientRect();
            // The key of a saved picture is not shown.
            if (box.width === 0) return false;
            return box.left < seen.left - 1 || box.right > seen.right + 1 || box.top < seen.top - 1 || box.bottom > seen.bottom + 1;
        }).map((text) => text.textContent) : [],
        ticks: svg ? Math.min(...['g.across text', 'g.up text'].map((texts) => svg.querySelectorAll(texts).length)) : 0,
    };
})"""

# Of several charts one is shown at a time; hidden ones get their size when they are shown.
SHOW_ALL = """(() => {
    document.querySelectorAll('[data-choice]').forEach((choice) => { choice.hidden = false; });
    return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))));
})()"""

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
        if (holder.querySelector('.cursor').getAttribute('visibility') !== 'visible') problems.push(id + ': no cursor after an arrow key');
        const axis = () => [...holder.querySelectorAll('g.across text')].map((text) => text.textContent).join(' ');
        const whole = axis();
        key('+');
        await frames();
        const reset = figure.querySelector('.reset');
        if (reset.hidden || axis() === whole) problems.push(id + ': not enlarged by +');
        reset.click();
        await frames();
        if (!reset.hidden || axis() !== whole) problems.push(id + ': not reset');
        const button = figure.querySelector('[data-entry]');
        const isShown = () => [...holder.querySelectorAll('[data-of="' + button.dataset.entry + '"]')]
            .every((curve) => getComputedStyle(curve).display !== 'none');
        button.click();
        if (button.getAttribute('aria-pressed') !== 'false' || isShown()) problems.push(id + ': a curve cannot be hidden');
        button.click();
        if (button.getAttribute('aria-pressed') !== 'true' || !isShown()) problems.push(id + ': a curve cannot be shown again');
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

CURSOR = """
    const wait = (ms) => new Promise((done) => setTimeout(done, ms));
    const mechanism = document.querySelector('[data-mechanism]');
    const charts = mechanism ? [...document.querySelectorAll('[data-chart][data-angle]')] : [];
    const apart = (a, b) => Math.abs(((a - b) % 360 + 540) % 360 - 180);
    const pose = () => [...mechanism.querySelectorAll('[data-body]')].map((body) => body.getAttribute('transform')).join();
    const shown = () => parseFloat(mechanism.querySelector('.angle').textContent);
    const at = (holder) => parseFloat(/: (−?[\\d.]+)°/.exec(holder.closest('figure').querySelector('.position').textContent)?.[1]);
    // A chart shows its nearest point, and the mechanism whole degrees.
    const slack = (holder) => {
        const rows = holder.closest('figure').querySelector('script[type="text/csv"]').textContent.trim().split('\\n').slice(1);
        const xs = rows.map((row) => parseFloat(row));
        return 0.51 + Math.max(...xs.slice(1).map((x, k) => x - xs[k])) / 2;
    };
    const unlike = (angle, when) => charts.flatMap((holder) => {
        const isThere = holder.querySelector('.cursor').getAttribute('visibility') === 'visible'
            && [...holder.closest('figure').querySelectorAll('[data-value]')].some((value) => /\\d/.test(value.textContent));
        return isThere && apart(at(holder), angle) <= slack(holder) ? [] : [holder.dataset.chart + ': shows ' + at(holder) + '° ' + when + ' ' + angle + '°'];
    });
"""

CURSOR_USE = "(async () => {" + CURSOR + """
    const problems = [];
    if (!mechanism) return problems;
    const slider = mechanism.querySelector('.pose');
    for (const share of [0.25, 0.7]) {
        slider.value = String(Math.round(Number(slider.max) * share));
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        problems.push(...unlike(shown(), 'while the mechanism shows'));
    }
    // While it plays, charts out of sight may wait until they are seen.
    const before = shown();
    mechanism.scrollIntoView({ behavior: 'instant' });
    await wait(100);
    mechanism.querySelector('.play').click();
    await wait(300);
    mechanism.querySelector('.play').click();
    if (shown() === before) problems.push('the mechanism has not played');
    for (const holder of charts) {
        holder.scrollIntoView({ behavior: 'instant' });
        await wait(100);
        if (apart(at(holder), shown()) > slack(holder)) problems.push(holder.dataset.chart + ': shows ' + at(holder) + '° after play to ' + shown() + '°');
    }
    for (const holder of charts) {
        const before = pose();
        holder.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true, cancelable: true }));
        if (pose() === before) problems.push(holder.dataset.chart + ': an arrow key does not move the mechanism');
        problems.push(...unlike(at(holder), 'while ' + holder.dataset.chart + ' shows'));
        await wait(250);
        const address = /^#a=(-?[\\d.]+)$/.exec(location.hash);
        if (!address || apart(Number(address[1]), at(holder)) > 0.06) problems.push(holder.dataset.chart + ': the address has ' + location.hash + ' at ' + at(holder) + '°');
    }
    return problems;
})()"""

CURSOR_OPENED = "(() => {" + CURSOR + f"""
    if (!mechanism) return [];
    const problems = unlike({OPENED_AT_DEG}, 'opened at');
    if (shown() !== {OPENED_AT_DEG}) problems.push('the mechanism shows ' + shown() + '°, opened at {OPENED_AT_DEG}°');
    return problems;
}})()"""

SMALL_TARGETS = f"""[...document.querySelectorAll('button, select, input, summary, nav a')].filter((element) => {{
    const box = element.getBoundingClientRect();
    return box.width > 0 && (box.width < {LEAST_TARGET_PX} || box.height < {LEAST_TARGET_PX});
}}).map((element) => element.outerHTML.slice(0, 120))"""

# What can be reached or seen and needs a script.
DEAD = """[...document.querySelectorAll('button:enabled, select, input, .controls, .readout, .help, [tabindex]:not(.scroll)')]
    .filter((element) => element.getClientRects().length > 0).map((element) => element.outerHTML.slice(0, 120))"""

# Nothing looked at would be nothing found: the number of rules that held is counted as well.
AXE_RUN = """axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] })
    .then((found) => [found.passes.length, found.violations.map((rule) => rule.id + ': ' + rule.help + ': '
        + rule.nodes.slice(0, 3).map((node) => node.html.slice(0, 120) + ' ' + (node.any[0]?.message ?? '')).join(' | '))])"""
# Rules that hold on the poorest of our pages, at least.
AXE_RULES = 20

UNLABELLED = """[...document.querySelectorAll('button, input, select, summary, [tabindex]')]
    .filter((element) => !(element.textContent.trim() || element.getAttribute('aria-label')))
    .map((element) => element.outerHTML.slice(0, 120))"""


def check(browser, path, axe, pictures):
    """Diagnostics about one page."""
    name = os.path.splitext(os.path.basename(path))[0]
    found = []
    for width in WIDTHS_PX:
        for dark in (False, True):
            where = f"{name}, {width} px, {'dark' if dark else 'light'}"
            browser.view(width, dark=dark, reduced_motion=True)
            browser.open(path)
            found += [f"{where}: scrolls sideways while closed: {text}" for text in browser.evaluate(SIDEWAYS)]
            if width in AXE_WIDTHS_PX and browser.evaluate("document.querySelector('details.fold') !== null"):
                found += [f"{where}: axe, closed: {text}" for text in seen_by_axe(browser, axe)]
            browser.evaluate(OPEN_ALL)
            found += [f"{where}: {text}" for text in browser.diagnostics()]
            found += [f"{where}: asks for {url}" for url in browser.requests()]
            browser.evaluate(SHOW_ALL)
            found += [f"{where}: scrolls sideways: {text}" for text in browser.evaluate(SIDEWAYS)]
            charts = browser.evaluate(CHARTS)
            found += [f"{where}: chart {chart['id']} is empty" for chart in charts
                      if not (chart["drawn"] and chart["isSeen"] and chart["curves"] and chart["ticks"] > 1)]
            found += [f"{where}: chart {chart['id']} cuts off: {text}" for chart in charts for text in chart["cut"]]
            found += [f"{where}: less than {LEAST_TARGET_PX} px: {text}" for text in browser.evaluate(SMALL_TARGETS)]
            if width in AXE_WIDTHS_PX:
                found += [f"{where}: axe: {text}" for text in seen_by_axe(browser, axe)]
            if pictures:
                scheme = "dark" if dark else "light"
                browser.screenshot(os.path.join(pictures, f"{name}-{width}-{scheme}.png"))
    browser.view(WIDTHS_PX[0], reduced_motion=True)
    browser.open(path)
    browser.evaluate(OPEN_ALL)
    browser.evaluate(SHOW_ALL)
    # The figures of an identification are drawn whole.
    is_whole = browser.evaluate("document.documentElement.dataset.origin.startsWith('identification')")
    charts = "[data-figure]" if is_whole else "[data-chart]"
    if browser.evaluate(f"document.querySelectorAll('{charts}').length") == 0:
        found.append(f"{name}: has no chart")
    for script in (CHART_USE, MECHANISM_USE, CURSOR_USE):
        found += [f"{name}: {text}" for text in browser.evaluate(script)]
    found += [f"{name}: without a name: {text}" for text in browser.evaluate(UNLABELLED)]
    found += [f"{name}: in use: {text}" for text in browser.diagnostics()]
    browser.open(path, f"#a={OPENED_AT_DEG}")
    browser.evaluate(OPEN_ALL)
    found += [f"{name}: {text}" for text in browser.evaluate(CURSOR_OPENED)]
    found += [f"{name}: without scripts: {text}" for text in without_scripts(browser, path)]
    found += [f"{name}: {text}" for text in printed(browser, path, os.path.join(pictures or browser.profile, f"{name}.pdf"))]
    return found


def seen_by_axe(browser, axe):
    """What axe-core finds in the page as it is shown."""
    browser.evaluate(axe + "; true")
    held, broken = browser.evaluate(AXE_RUN)
    return broken if held >= AXE_RULES else [*broken, f"only {held} rules hold"]


def without_scripts(browser, path):
    """What a reader meets whose viewer runs no scripts: every figure, and nothing that does nothing."""
    browser.run_scripts(False)
    try:
        browser.open(path)
        dead = browser.evaluate(DEAD)
        empty = [chart["id"] for chart in browser.evaluate(CHARTS) if not (chart["isSeen"] and chart["curves"])]
    finally:
        browser.run_scripts(True)
    return [f"of no use: {text}" for text in dead] + [f"chart {name} is empty" for name in empty]


def printed(browser, path, pdf):
    """Diagnostics about a page on paper; the number of its sheets is told."""
    browser.open(path)
    browser.pdf(pdf)
    paper = Paper(pathlib.Path(pdf).read_bytes())
    print(f"{os.path.basename(path)}: {len(paper.sheets)} sheets")
    found = [] if paper.of_kind(b"Figure") else ["prints no figure"]
    found += [f"a row of a table is torn between sheets {sheets}" for sheets in paper.torn_rows()]
    return found + [f"a head stands alone at the foot of sheet {sheet}" for sheet in paper.lonely_heads()]


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
    if not AXE.is_file():
        print(f"check_pages: no {AXE}\nhint: just page-scripts", file=sys.stderr)
        return 2
    if options.pictures:
        os.makedirs(options.pictures, exist_ok=True)
    found = []
    try:
        with Chromium() as browser:
            for path in options.pages:
                found += check(browser, path, AXE.read_text(encoding="utf-8"), options.pictures)
    except BrowserError as error:
        print(f"check_pages: {error}", file=sys.stderr)
        return 2
    for text in found:
        print(text)
    print(f"{len(options.pages)} pages, {len(found)} diagnostics")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
