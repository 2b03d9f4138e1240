#!/usr/bin/env python3
"""Draws a body's drums, as one and pulled apart: reads what build/tools/drum_corners prints, writes an SVG.

    build/tools/drum_corners sphere 8 189 | docs/images/plot_drums.py > docs/images/drums.svg
"""
import math
import sys

WIDTH, HEIGHT, SCALE, TURN, TILT = 760, 620, 150, 0.5, 0.32  # pixels; pixels a unit; angles of the view
LOWER, UPPER, LATERAL = "#0072b2", "#d55e00", "#666666"  # of Okabe and Ito


def seen(point, left, low):
    x, y, z = point
    across = x * math.cos(TURN) - y * math.sin(TURN)
    away = x * math.sin(TURN) + y * math.cos(TURN)
    return left + SCALE * across, low - SCALE * (z * math.cos(TILT) + away * math.sin(TILT))


def is_in_front(p, q):
    """Of a side of a slice: does it face the viewer, who is where y is least, once turned?"""
    outwards = (q[1] - p[1], p[0] - q[0])
    return outwards[0] * math.sin(TURN) + outwards[1] * math.cos(TURN) < 0


def line(p, q, colour, width, is_hidden):
    dash = ' stroke-dasharray="3 4" opacity="0.6"' if is_hidden else ""
    return (f'<line x1="{p[0]:.1f}" y1="{p[1]:.1f}" x2="{q[0]:.1f}" y2="{q[1]:.1f}" stroke="{colour}" '
            f'stroke-width="{width}" stroke-linecap="round"{dash}/>')


def drum(edges, left, low, upper_colour=UPPER):
    """Slices below and above, and what is between: hidden parts first."""
    hidden, shown, front = [], [], []
    count = len(edges)
    for k in range(count):
        following = edges[(k + 1) % count]
        longest = max((0, 1), key=lambda s: math.dist(edges[k][s], following[s]))  # a side may have no length
        front.append(is_in_front(edges[k][longest], following[longest]))
    for k in range(count):
        low_corner, high_corner = (seen(p, left, low) for p in edges[k])
        next_low, next_high = (seen(p, left, low) for p in edges[(k + 1) % count])
        is_hidden = not front[k] and not front[k - 1]
        (hidden if is_hidden else shown).append(line(low_corner, high_corner, LATERAL, 1.2, is_hidden))
        (shown if front[k] else hidden).append(line(low_corner, next_low, LOWER, 2, not front[k]))
        is_covered = upper_colour == LOWER and not front[k]
        (hidden if is_covered else shown).append(line(high_corner, next_high, upper_colour, 2, is_covered))
        for x, y in (low_corner, high_corner):
            (hidden if is_hidden else shown).append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.2"/>')
    return hidden + shown


def main():
    drums = []
    for text in sys.stdin:
        numbers = [float(x) for x in text.split()[1:]]
        points = [tuple(numbers[k:k + 3]) for k in range(0, len(numbers), 3)]
        drums.append([(points[k], points[k + 1]) for k in range(0, len(points), 2)])
    if not drums:
        sys.exit("plot_drums.py: no drums on standard input")
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" '
           'font-family="sans-serif" font-size="13">', f"<title>A body of {len(drums)} drums</title>",
           '<rect width="100%" height="100%" fill="white"/>',
           '<text x="30" y="26" font-weight="bold">The body, cut at the heights of its vertices</text>',
           '<text x="420" y="26" font-weight="bold">Its drums, pulled apart</text>']
    low = HEIGHT / 2 + 15 + SCALE * (drums[0][0][0][2] + drums[-1][0][1][2]) / 2
    for edges in drums:
        out += drum(edges, 190, low, LOWER)
    gap = (HEIGHT - 160 - SCALE * (drums[-1][0][1][2] - drums[0][0][0][2])) / max(1, len(drums) - 1)
    for k, edges in enumerate(drums):
        out += drum(edges, 570, low - gap * (k - (len(drums) - 1) / 2))
    out.append(f'<text x="30" y="{HEIGHT - 18}"><tspan fill="{LOWER}">lower slices</tspan>, '
               f'<tspan fill="{UPPER}">upper slices</tspan>, lateral edges; a vertex with several edges upwards is as '
               'many corners in one place</text>')
    print("\n".join(out) + "\n</svg>")


main()
