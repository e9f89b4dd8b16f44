#!/usr/bin/env python3
"""Makes the documentation site: `python3 tools/site/site.py` writes target/site/book/index.html.

docs/SUMMARY.md lists the pages. They keep their places in the repository, so that a link between two of them is the same in a checkout and
on the site; what a page links to beside other pages (pictures, notebooks, licences) comes along. A link to a page of the repository outside docs
(measurements, cases, changes) becomes its path in code font. The page of the Python API is made here, from the sources of the package. mdBook is taken from .tools/bin, where ./test installs it, or from the path.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from python_api import api_page  # noqa: E402

REPOSITORY = Path(__file__).resolve().parents[2]
SITE = REPOSITORY / "target/site"
SUMMARY = REPOSITORY / "docs/SUMMARY.md"
API_PAGE = "docs/python-api.md"
REDIRECTION = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>loosepin</title><meta http-equiv="refresh" content="0; url={first}"></head>
<body><a href="{first}">loosepin</a></body></html>
"""
LINK = re.compile(r"\]\(([^)#\s]+)")
LINK_TO_PAGE = re.compile(r"\[([^\[\]]+)\]\(([^)#:\s]+\.md)(?:#[^)\s]*)?\)")


def within(folder: str, link: str) -> str:
    """The path of a link in the repository."""
    return os.path.normpath(os.path.join(folder, link))


def with_paths(page: str, text: str, pages: list[str]) -> str:
    """The page with the paths of pages that are in the repository alone, in place of links to them."""

    def named(found: re.Match[str]) -> str:
        label, linked = found[1], within(os.path.dirname(page), found[2])
        if linked in pages:
            return found[0]
        if linked.startswith("docs/"):
            sys.exit(f"error: {page} links to {linked}, which is not in docs/SUMMARY.md")
        if not (REPOSITORY / linked).is_file():
            sys.exit(f"error: {page} links to {linked}, which is no file")
        return f"`{linked}`" if label.strip("`") == linked else f"{label} (`{linked}`)"

    return LINK_TO_PAGE.sub(named, text)


def stage(source: Path) -> list[str]:
    """Puts the pages into `source`; gives their paths."""
    summary = SUMMARY.read_text(encoding="utf-8")
    pages = [within("docs", link) for link in LINK.findall(summary)]
    shutil.rmtree(source, ignore_errors=True)
    for page in pages:
        text = api_page() if page == API_PAGE else (REPOSITORY / page).read_text(encoding="utf-8")
        text = with_paths(page, text, pages)
        target = source / page
        target.parent.mkdir(parents=True, exist_ok=True)
        for link in LINK.findall(text):
            linked = within(os.path.dirname(page), link)
            if "://" in link or linked in pages:
                continue
            if linked.endswith(".md"):
                sys.exit(f"error: {page}: the words of the link to {linked} have brackets in them")
            (source / linked).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(REPOSITORY / linked, source / linked)
        target.write_text(text, encoding="utf-8")
    (source / "SUMMARY.md").write_text(LINK.sub(lambda found: f"]({within('docs', found[1])}", summary), encoding="utf-8")
    return pages


def find_mdbook() -> str:
    own = REPOSITORY / ".tools/bin/mdbook"
    found = str(own) if own.exists() else shutil.which("mdbook")
    if found is None:
        print("error: mdbook is not installed\nhint: ./test --install-only", file=sys.stderr)
        sys.exit(2)
    return found


def main() -> int:
    argparse.ArgumentParser(description=__doc__.split("\n", 1)[0]).parse_args()
    pages = stage(SITE / "source")
    for name in ("book.toml", "site.css"):
        shutil.copyfile(Path(__file__).parent / name, SITE / name)
    shutil.rmtree(SITE / "book", ignore_errors=True)
    done = subprocess.run([find_mdbook(), "build", str(SITE)], capture_output=True, text=True)
    if done.returncode != 0 or "WARN" in done.stderr or "ERROR" in done.stderr:
        sys.exit(f"error: mdbook\n{done.stdout}{done.stderr}")
    # mdBook copies the first page here, where its links lead nowhere.
    first = pages[0].removesuffix(".md") + ".html"
    (SITE / "book/index.html").write_text(REDIRECTION.format(first=first), encoding="utf-8")
    print(f"{SITE / 'book/index.html'}: {len(pages)} pages")
    return 0


if __name__ == "__main__":
    sys.exit(main())
