#!/usr/bin/env python3
"""Draws the growth of probes: reads the table that tests/planar/planar_pair_complexity_test prints, writes an SVG.

    build/tests/planar_fast --file=planar_pair_complexity_test | docs/images/plot_probes.py > docs/images/planar-probes.svg
"""
import math
import sys

METHODS = ["front door", "difference", "halving", "triangles"]
COLOURS = ["#000000", "#0072b2", "#d55e00", "#009e73"]  # of Okabe and Ito
WIDTH, HEIGHT, LEFT, BOTTOM, TOP = 760, 420, 60, 50, 20


def main():
    rows, seen = [], set()
    for line in sys.stdin:
        fields = line.split()
        if len(fields) == 2 + 2 * len(METHODS) and fields[0].isdigit() and fields[0] == fields[1] and fields[0] not in seen:
            seen.add(fields[0])  # the first row of a size: two polygons of n vertices
            rows.append([float(f) for f in fields])
    if len(rows) < 2:
        sys.exit("plot_probes.py: no table on standard input")
    first, last = math.log2(rows[0][0]), math.log2(rows[-1][0])
    most = max(max(row[2:]) for row in rows)

    def x(n):
        return LEFT + (math.log2(n) - first) / (last - first) * (WIDTH - LEFT - 170)

    def y(probes):
        return HEIGHT - BOTTOM - probes / most * (HEIGHT - BOTTOM - TOP)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" '
           'font-family="sans-serif" font-size="13">', "<title>Probes of two polygons of n vertices each</title>",
           '<rect width="100%" height="100%" fill="white"/>']
    for row in rows:
        out.append(f'<text x="{x(row[0]):.1f}" y="{HEIGHT - 30}" text-anchor="middle">2^{math.log2(row[0]):.0f}</text>')
    for probes in range(0, int(most) + 1, 50):
        out.append(f'<line x1="{LEFT}" y1="{y(probes):.1f}" x2="{WIDTH - 170}" y2="{y(probes):.1f}" stroke="#dddddd"/>')
        out.append(f'<text x="{LEFT - 8}" y="{y(probes) + 4:.1f}" text-anchor="end">{probes}</text>')
    for m, name in enumerate(METHODS):
        for column, dashes in ((2 + 2 * m, ""), (3 + 2 * m, ' stroke-dasharray="5 4"')):
            points = " ".join(f"{x(row[0]):.1f},{y(row[column]):.1f}" for row in rows)
            out.append(f'<polyline points="{points}" fill="none" stroke="{COLOURS[m]}" stroke-width="2"{dashes}/>')
        out.append(f'<text x="{WIDTH - 155}" y="{TOP + 20 + 20 * m}" fill="{COLOURS[m]}">{name}</text>')
    out.append(f'<text x="{WIDTH - 155}" y="{TOP + 110}">solid: mean</text>')
    out.append(f'<text x="{WIDTH - 155}" y="{TOP + 130}">dashed: the most seen</text>')
    out.append(f'<text x="{LEFT}" y="{HEIGHT - 8}">vertices n of each polygon; probes upwards</text>')
    print("\n".join(out) + "\n</svg>")


main()
