"""Draws the four-bar of this folder in files of several versions, as text and binary; DXF R12 has no unit.

    python3 -m venv /tmp/ezdxf && /tmp/ezdxf/bin/pip install ezdxf==1.4.5 && /tmp/ezdxf/bin/python draw.py

Beside the four-bar stand entities that are no part of a sketch: blocks within blocks with attributes, texts, arcs,
curves, a hatch, extended data of every type. Nothing of them may be taken for a line or a circle.
"""

from pathlib import Path

import ezdxf

A, B, C, D, E = (3.5, -2.25), (23.5, 32.391), (103.5, 92.75), (123.5, 7.75), (63.5, 107.75)
MIDDLE = (115.0, 50.0)
CIRCLES = ((A, 5.0, "Ground"), (B, 4.0, "0"), (C, 4.5, "0"), (D, 6.0, "ground"), (E, 1.5, "0"))


def draw(version):
    drawing = ezdxf.new(version, units=4)
    space = drawing.modelspace()
    space.add_line(A, B)
    polyline = space.add_polyline2d if version == "R12" else space.add_lwpolyline
    polyline([B, C, E], close=True)
    rocker = space.add_line(D, MIDDLE)
    space.add_line(MIDDLE, C)
    for centre, radius, layer in CIRCLES:
        space.add_circle(centre, radius, dxfattribs={"layer": layer})
    add_others(drawing, space, version)
    drawing.appids.add("LOOSEPIN")
    values = [(1000, "x"), (1010, (1.0, 2.0, 3.0)), (1040, 2.5), (1070, 3), (1071, 70000), (1004, bytes([1, 2, 3]))]
    rocker.set_xdata("LOOSEPIN", values)
    return drawing


def add_others(drawing, space, version):
    inner = drawing.blocks.new("INNER")
    inner.add_line((0, 0), (1, 1))
    inner.add_circle((0, 0), 1)
    inner.add_attdef("TAG", (0, 0))
    drawing.blocks.new("OUTER").add_blockref("INNER", (3, 3))
    space.add_blockref("INNER", (200, 3)).add_attrib("TAG", "10", (1, 1))
    space.add_blockref("OUTER", (5, 5))
    space.add_text("crank é")
    space.add_arc((1, 1), 3, 0, 90)
    space.add_point((2, 2))
    if version != "R12":
        space.add_mtext("two\nlines")
        space.add_spline([(0, 0), (1, 1), (2, 0)])
        space.add_ellipse((0, 0), (2, 0), 0.5)
        space.add_hatch().paths.add_polyline_path([(0, 0), (1, 0), (1, 1)])


folder = Path(__file__).parent
for version in ["R12", "R2000", "R2018"]:
    drawing = draw(version)
    drawing.saveas(folder / f"four_bar_{version}.dxf")
    drawing.saveas(folder / f"four_bar_{version}_binary.dxf", fmt="bin")
