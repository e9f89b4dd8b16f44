"""Curves stand out from what is behind them, in light and in dark: 3 to 1, as WCAG asks of graphics."""

import pathlib
import re

import pytest

COLOURS = pathlib.Path(__file__).resolve().parents[2] / "crates/loosepin-report/assets/colours.css"
LEAST = 3.0
# What is drawn over the fillings of bands, and over the page alone.
OVER_BANDS = ("random", "mixed", "nominal", "mean", "probability", "limit")
OVER_PAGE = (*OVER_BANDS, "worst", "first", "second", "third", "fourth", "fifth", "quiet")


def schemes():
    light, dark = COLOURS.read_text(encoding="utf-8").split("@media")
    found = {name: dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6});", text)) for name, text in (("light", light), ("dark", dark))}
    assert set(found["light"]) == set(found["dark"])
    return found


def luminance(colour):
    shares = [int(colour[at:at + 2], 16) / 255 for at in (1, 3, 5)]
    red, green, blue = (share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4 for share in shares)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(first, second):
    low, high = sorted((luminance(first), luminance(second)))
    return (high + 0.05) / (low + 0.05)


def test_contrast_of_black_and_white():
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_curves_stand_out(scheme):
    colours = schemes()[scheme]
    pairs = [(line, fill) for line in OVER_BANDS for fill in ("random-fill", "mixed-fill")]
    pairs += [(line, page) for line in OVER_PAGE for page in ("page", "raised")]
    weak = {pair: round(contrast(*map(colours.get, pair)), 2) for pair in pairs if contrast(*map(colours.get, pair)) < LEAST}
    assert weak == {}
