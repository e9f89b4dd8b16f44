"""The documentation site, built as `just site` builds it: every page in headless Chromium, every link and anchor in what was built."""

import os
import pathlib
import subprocess
import sys
from html.parser import HTMLParser

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chromium import Chromium  # noqa: E402

WIDTHS_PX = (1280, 400)
# Pages with a picture, a wide table, equations, and the one that is made from sources.
LOOKED_AT = ("docs/first-minute", "docs/theory/words", "docs/files", "docs/theory/contact", "docs/python-api")
LEAST_PAGES = 35
SIDEWAYS = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
BROKEN_PICTURES = "[...document.images].filter((image) => !image.complete || image.naturalWidth === 0).map((image) => image.src)"
MENU = "[...document.querySelectorAll('#mdbook-sidebar a, #sidebar a')].length"


class Page(HTMLParser):
    """Anchors and links of a page."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id":
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


def test_the_site(tmp_path):
    built = subprocess.run(
        [sys.executable, str(REPOSITORY / "tools/site/site.py")], cwd=REPOSITORY, capture_output=True, text=True
    )
    assert built.returncode == 0, built.stdout + built.stderr
    book = REPOSITORY / "target/site/book"
    pages = {path: Page(path) for path in book.rglob("*.html")}
    assert len(pages) >= LEAST_PAGES
    for path, page in pages.items():
        for link in page.links:
            target, _, anchor = link.partition("#")
            assert "://" not in target or not target.startswith("http:"), f"{path} links to {link}"
            if "://" in target or target.startswith(("data:", "mailto:")):
                continue
            leads = pathlib.Path(os.path.normpath(path.parent / target)) if target else path
            assert leads.exists(), f"{path.relative_to(book)} links to {link}"
            if anchor and leads in pages:
                assert anchor in pages[leads].anchors, f"{path.relative_to(book)} links to {link}"
    pictures = os.environ.get("PICTURES")
    with Chromium() as browser:
        for name in LOOKED_AT:
            for width in WIDTHS_PX:
                where = f"{name}, {width} px"
                browser.view(width, reduced_motion=True)
                browser.open(str(book / f"{name}.html"))
                assert browser.diagnostics() == [], where
                outside = [url for url in browser.requests() if not url.startswith(("file:", "data:"))]
                assert outside == [], where
                assert browser.evaluate(BROKEN_PICTURES) == [], where
                assert browser.evaluate(MENU) >= LEAST_PAGES, where
                assert browser.evaluate(SIDEWAYS) <= 0, where
                if pictures:
                    browser.screenshot(os.path.join(pictures, f"{name.replace('/', '-')}-{width}.png"), whole=False)
