#!/usr/bin/env python3
"""Draws the pictures of docs/theory beside this file; needs Python's standard library only.

    python3 docs/images/theory/draw.py
"""

import os
from statistics import NormalDist

NORMAL = NormalDist()
BLUE, ORANGE, GREY, DARK, PALE = "#1f6fb2", "#c2570c", "#8a929b", "#1e252c", "#dce9f5"
HERE = os.path.dirname(os.path.abspath(__file__))


class Picture:
    """A drawing on white, so that it reads on pages of any colour."""

    def __init__(self, width, height, title):
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
            f'font-family="system-ui, sans-serif" font-size="15" role="img"><title>{title}</title>',
            f'<rect width="{width}" height="{height}" rx="6" fill="#ffffff"/>',
        ]

    def line(self, points, colour, width=1.5, dashes="", fill="none", opacity=1.0):
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.parts.append(
            f'<polyline points="{text}" fill="{fill}" fill-opacity="{opacity}" stroke="{colour}" stroke-width="{width}"'
            f' stroke-linejoin="round"{dashed}/>'
        )

    def rectangle(self, x, y, width, height, colour):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{colour}"/>')

    def circle(self, x, y, radius, colour, fill="none", width=2.0):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}" fill="{fill}" stroke="{colour}" stroke-width="{width}"/>')

    def arrow(self, start, end, colour, width=2.0):
        (x0, y0), (x1, y1) = start, end
        length = ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5
        ux, uy = (x1 - x0) / length, (y1 - y0) / length
        self.line([start, (x1 - 7 * ux, y1 - 7 * uy)], colour, width)
        tip = [(x1, y1), (x1 - 9 * ux - 4 * uy, y1 - 9 * uy + 4 * ux), (x1 - 9 * ux + 4 * uy, y1 - 9 * uy - 4 * ux), (x1, y1)]
        self.line(tip, colour, 0.5, fill=colour)

    def text(self, x, y, words, colour=DARK, anchor="start", size=15, weight="normal"):
        self.parts.append(
            f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}" text-anchor="{anchor}" font-size="{size}" font-weight="{weight}">{words}</text>'
        )

    def save(self, name):
        with open(os.path.join(HERE, name), "w", encoding="utf-8") as file:
            file.write("\n".join(self.parts) + "\n</svg>\n")


def box():
    """Y = X + u, X normal, u in [-1, 1]: ten distribution functions, their envelope, and both ends of a quantile."""
    picture = Picture(700, 380, "Distribution functions for ten values of the play, and the box around them")
    left, top, width, height = 70, 24, 600, 290
    span = 4.2
    place = lambda y, p: (left + width * (y + span) / (2 * span), top + height * (1 - p))
    steps = [span * (k / 100 - 1) for k in range(201)]
    curve = lambda u: [place(y, NORMAL.cdf(y - u)) for y in steps]
    picture.line(curve(-1) + curve(1)[::-1], "none", 0, fill=PALE)
    for k in range(10):
        picture.line(curve(-1 + 2 * k / 9), GREY, 0.9)
    for u in (-1, 1):
        picture.line(curve(u), BLUE, 3)
    picture.line([place(-span, 0), place(span, 0)], DARK)
    picture.line([place(-span, 0), place(-span, 1)], DARK)
    picture.line([place(-span, 0.975), place(span, 0.975)], ORANGE, 1.5, "6 4")
    for u, words in ((-1, "least"), (1, "greatest")):
        at = NORMAL.inv_cdf(0.975) + u
        picture.line([place(at, 0.975), place(at, 0)], ORANGE, 1.5, "6 4")
        picture.circle(*place(at, 0.975), 4.5, ORANGE, ORANGE)
        picture.text(place(at, 0)[0], top + height + 20, words, ORANGE, "middle")
    for p, words in ((0, "0 %"), (0.5, "50 %"), (0.975, "97.5 %")):
        picture.text(left - 8, place(0, p)[1] + 5, words, DARK, "end")
    picture.text(left + width / 2, top + height + 50, "response, for example the largest deviation of the turn", DARK, "middle")
    picture.text(place(-3.9, 0)[0], place(0, 0.62)[1], "share of mechanisms", DARK)
    picture.text(place(-3.9, 0)[0], place(0, 0.55)[1], "that stay below", DARK)
    picture.text(*place(-3.9, 0.36), "a thin curve: the series", GREY, "start", 14)
    picture.text(*place(-3.9, 0.29), "at one value of the play", GREY, "start", 14)
    picture.save("box.svg")


def treatments():
    """The exact bands of 95 % of Y = X + u."""
    picture = Picture(700, 232, "Bands by three treatments")
    middle, scale = 380, 62
    rows = (
        ("probability only", 2.2541, "holds 89.5 % to 97.6 %", GREY),
        ("mixed", 2.9600, "holds at least 97.5 %", BLUE),
        ("interval only", 4.0, "the widest", ORANGE),
    )
    for k, (name, half, words, colour) in enumerate(rows):
        y = 26 + 56 * k
        picture.rectangle(middle - half * scale, y, 2 * half * scale, 30, colour)
        picture.text(middle, y + 20, words, "#ffffff", "middle", 14, "600")
        picture.text(12, y + 20, name)
    axis = 198
    picture.line([(middle - 4.3 * scale, axis), (middle + 4.3 * scale, axis)], DARK)
    for tick in (-4, -2, 0, 2, 4):
        picture.line([(middle + tick * scale, axis), (middle + tick * scale, axis + 6)], DARK)
        picture.text(middle + tick * scale, axis + 23, f"{tick}".replace("-", "−"), DARK, "middle", 14)
    picture.save("treatments.svg")


def play():
    """A journal that touches its bearing."""
    picture = Picture(700, 320, "A pin with play in its hole")
    hole, pin = (200, 142), (226, 122)
    big, small = 106, 77
    picture.parts.append('<rect x="60" y="20" width="280" height="280" rx="18" fill="#e9ecef"/>')
    picture.circle(*hole, big, DARK, "#ffffff")
    picture.circle(*pin, small, BLUE, PALE)
    picture.circle(*hole, 3, DARK, DARK)
    picture.circle(*pin, 3, BLUE, BLUE)
    picture.arrow(hole, pin, ORANGE, 2.5)
    picture.text(204, 122, "e", ORANGE, "end", 17, "600")
    length = ((pin[0] - hole[0]) ** 2 + (pin[1] - hole[1]) ** 2) ** 0.5
    n = ((pin[0] - hole[0]) / length, (pin[1] - hole[1]) / length)
    rim = (hole[0] + n[0] * big, hole[1] + n[1] * big)
    picture.arrow(rim, (rim[0] + 46 * n[0], rim[1] + 46 * n[1]), DARK)
    picture.text(rim[0] + 50 * n[0] + 4, rim[1] + 50 * n[1] + 2, "n", DARK, "start", 17, "600")
    picture.text(200, 284, "hole, radius R_i", DARK, "middle", 14)
    picture.text(222, 176, "pin, radius R_j", BLUE, "middle", 14)
    lines = (
        ("c = R_i − R_j", "radial clearance: the play", DARK),
        ("e", "from the centre of the hole to that of the pin", ORANGE),
        ("|e| &lt; c", "the pin flies free, no force", DARK),
        ("δ = |e| − c &gt; 0", "contact: a force K δⁿ (1 + χ v_N/v0)", DARK),
        ("", "along −n on the pin, and friction across", DARK),
    )
    for k, (symbol, words, colour) in enumerate(lines):
        picture.text(372, 74 + 42 * k, symbol, colour, "start", 15, "600")
        picture.text(372, 93 + 42 * k, words, DARK, "start", 14) if symbol else picture.text(372, 93 + 42 * k - 22, words, DARK, "start", 14)
    picture.save("play.svg")


def error():
    """From the attained value to the widened one."""
    picture = Picture(700, 190, "A bound and its error in three parts")
    y, start = 100, 230
    picture.line([(30, y), (670, y)], DARK)
    picture.rectangle(60, y - 14, start - 60, 28, PALE)
    picture.text((60 + start) / 2, y + 5, "attained by runs", BLUE, "middle", 14)
    at = start
    for width, words, colour in ((170, "sampling", BLUE), (120, "optimisation", ORANGE), (80, "surrogate", GREY)):
        picture.rectangle(at, y - 14, width, 28, colour)
        picture.text(at + width / 2, y + 5, words, "#ffffff", "middle", 14)
        at += width
    for x, words, colour in ((start, "value", DARK), (at, "widened", ORANGE)):
        picture.line([(x, y - 34), (x, y + 34)], colour, 2.5)
        picture.text(x, y - 42, words, colour, "middle", 16, "600")
    picture.text(start, y + 54, "at the witness: can be run again", DARK, "middle", 14)
    picture.text(at, y + 54, "the bound to rely on", DARK, "middle", 14)
    picture.save("error.svg")


if __name__ == "__main__":
    box()
    treatments()
    play()
    error()
