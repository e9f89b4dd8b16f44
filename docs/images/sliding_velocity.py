"""Draws docs/images/sliding_velocity.svg: what friction takes out of a mechanism under both readings of its sliding velocity.

    for k in material literal; do
      loosepin simulate cases/inverted_slider_crank_$k/model.toml --turns 1 --samples 4000 --out /tmp/$k
    done
    python3 docs/images/sliding_velocity.py /tmp/material/summary.json /tmp/literal/summary.json > docs/images/sliding_velocity.svg
"""

import json
import sys

WIDTH, HEIGHT, LEFT, BELOW, MARGIN = 760.0, 330.0, 76.0, 52.0, 24.0
POINTS = 240


def losses(path):
    with open(path, encoding="utf-8") as file:
        record = json.load(file)
    angle = record["drive_angle_rad"]
    turn = 2.0 * 3.141592653589793
    loss = record["energy"]["friction_loss_j"]
    step = max(1, (len(loss) - 1) // POINTS)
    return [((angle[k] - angle[0]) / turn, 1e3 * loss[k]) for k in range(0, len(loss), step)]


def main():
    curves = [("material points (default)", "#1f6fb2", losses(sys.argv[1])), ("eq. (7) literally", "#c2570c", losses(sys.argv[2]))]
    most = max(value for _, _, curve in curves for _, value in curve)
    top = 100.0 * (int(most / 100.0) + 1)

    def x(share):
        return LEFT + share * (WIDTH - LEFT - MARGIN)

    def y(value):
        return HEIGHT - BELOW - value / top * (HEIGHT - BELOW - MARGIN)

    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH:.0f}" height="{HEIGHT:.0f}" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" '
        'font-family="Helvetica, Arial, sans-serif" font-size="12" fill="#222" role="img">',
        "<title>Energy lost in friction over a turn of the inverted slider-crank, for both readings of the sliding velocity</title>",
        '<rect width="100%" height="100%" fill="#fff"/>',
    ]
    for tick in range(0, int(top) + 1, 100):
        out.append(f'<path d="M{LEFT} {y(tick):.1f}H{WIDTH - MARGIN}" stroke="#e4e4e4"/>')
        out.append(f'<text x="{LEFT - 8}" y="{y(tick) + 4:.1f}" text-anchor="end">{tick}</text>')
    for quarter in range(5):
        out.append(f'<text x="{x(quarter / 4):.1f}" y="{HEIGHT - BELOW + 18}" text-anchor="middle">{90 * quarter}°</text>')
    out.append(f'<text x="{x(0.5):.1f}" y="{HEIGHT - 10}" text-anchor="middle">crank</text>')
    out.append(f'<text transform="translate(18 {y(top / 2):.1f}) rotate(-90)" text-anchor="middle">lost in friction, mJ</text>')
    for index, (name, colour, curve) in enumerate(curves):
        path = "L".join(f"{x(share):.1f} {y(value):.1f}" for share, value in curve)
        out.append(f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        out.append(f'<text x="{LEFT + 14}" y="{MARGIN + 16 + 18 * index}" fill="{colour}">{name}</text>')
    out.append("</svg>")
    print("\n".join(out))


if __name__ == "__main__":
    main()
