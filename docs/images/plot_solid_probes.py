#!/usr/bin/env python3
"""Draws the growth of probes of two polyhedra: reads the table that tests/solid_hierarchy_complexity_test prints,
writes an SVG.

    SUNDER_TEST_SCALE=40 build/tests/solid_hierarchy_complexity_test |
        docs/images/plot_solid_probes.py > docs/images/solid-probes.svg

At this scale there are as many pairs of each size: of fewer the greatest is less.
"""
import math
import sys

# Column, title, what probes are divided by, the bound that the test asserts, step of the grid.
PANELS = [(0, "_by_hierarchy", "log2^2 of the larger", 32, 10), (1, "_by_polar", "log2 n + log2 m", 80, 25),
          (2, "front door", "log2 n + log2 m", 250, 50)]
COLOURS = ["#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]  # of Okabe and Ito
WIDTH, HEIGHT, LEFT, SIDE, GAP, TOP, LOW = 960, 430, 50, 260, 50, 50, 310


def main():
    greatest = {}  # of a family, by log2 n
    for line in sys.stdin:
        fields = [f.strip() for f in line.split("|")]
        if len(fields) == 8 and fields[2].isdigit():
            greatest.setdefault(fields[1], {})[math.log2(int(fields[2]))] = [float(f) for f in fields[3:7]]
    powers = sorted({p for of in greatest.values() for p in of})
    if len(powers) < 2:
        sys.exit("plot_solid_probes.py: no table on standard input")
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" '
           'font-family="sans-serif" font-size="13">', "<title>Probes of two polyhedra, near contact</title>",
           '<rect width="100%" height="100%" fill="white"/>']
    for k, (column, title, unit, bound, step) in enumerate(PANELS):
        left = LEFT + k * (SIDE + GAP)
        most = 1.05 * max(bound, max(ratios[column] for of in greatest.values() for ratios in of.values()))

        def x(power):
            return left + (power - powers[0]) / (powers[-1] - powers[0]) * SIDE

        def y(ratio):
            return LOW - ratio / most * (LOW - TOP)

        out.append(f'<text x="{left}" y="{TOP - 26}" font-weight="bold">{title}</text>')
        out.append(f'<text x="{left}" y="{TOP - 8}">probes / ({unit})</text>')
        for ratio in range(0, int(most), step):
            if abs(ratio - bound) < step / 2:
                continue  # the bound has its own
            out.append(f'<path d="M{left} {y(ratio):.1f}h{SIDE}" stroke="#dddddd"/>')
            out.append(f'<text x="{left - 8}" y="{y(ratio) + 4:.1f}" text-anchor="end">{ratio}</text>')
        out.append(f'<path d="M{left} {y(bound):.1f}h{SIDE}" stroke="#999999" stroke-width="3"/>')
        out.append(f'<text x="{left - 8}" y="{y(bound) + 4:.1f}" text-anchor="end">{bound}</text>')
        for power in powers[::2]:
            out.append(f'<text x="{x(power):.1f}" y="{LOW + 20}" text-anchor="middle">2^{power:.0f}</text>')
        for f, of in enumerate(greatest.values()):
            points = " ".join(f"{x(p):.1f},{y(ratios[column]):.1f}" for p, ratios in sorted(of.items()))
            out.append(f'<polyline points="{points}" fill="none" {stroke(f)}/>')
    out.append(f'<text x="{LEFT}" y="{LOW + 42}">across: points n of a body, against itself or a sphere of m; '
               'upwards: the greatest ratio seen; grey: the bound that the test asserts</text>')
    for f, family in enumerate(greatest):
        left, at = LEFT + f % 7 * 128, LOW + 72 + f // 7 * 26
        out.append(f'<line x1="{left}" y1="{at - 4}" x2="{left + 26}" y2="{at - 4}" {stroke(f)}/>')
        out.append(f'<text x="{left + 32}" y="{at}">{family}</text>')
    print("\n".join(out) + "\n</svg>")


def stroke(f):
    dashes = ' stroke-dasharray="5 3"' if f >= len(COLOURS) else ""
    return f'stroke="{COLOURS[f % len(COLOURS)]}" stroke-width="2"{dashes}'


main()
