#!/usr/bin/env python3
"""Draws the growth of probes in space: reads the table that a test prints, writes an SVG.

    SUNDER_TEST_SCALE=40 build/tests/solid_fast --file=solid_hierarchy_complexity_test |
        docs/images/plot_solid_probes.py hierarchy > docs/images/solid-probes.svg
    for file in solid_drums_complexity_test solid_pair_by_drums_complexity_test; do
        build/tests/solid_fast --file=$file; done | docs/images/plot_solid_probes.py drums > docs/images/drum-probes.svg

At scale 40 there are as many pairs of each size: of fewer the greatest is less.
"""
import math
import re
import sys

# Title, what probes are divided by, the bound that the test asserts, step of the grid.
HIERARCHY = [("_by_hierarchy", "log2^2 of the larger", 68, 20), ("_by_polar", "log2 n + log2 m", 80, 25),
             ("front door", "log2 n + log2 m", 250, 50)]
DRUMS = [("a plane (IHP)", "log2^2 n", 2, 1), ("a line (IHL)", "log2^2 n", 45, 15),
         ("a polygon (IHG)", "log2 p log2 (p + q)", 75, 25), ("a polyhedron (IHH)", "log2 p log2 q log2 (p + q)", 140, 50)]
COLOURS = ["#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]  # of Okabe and Ito
WIDTH, HEIGHT, LEFT, GAP, TOP, LOW = 960, 430, 50, 50, 50, 310


def read_hierarchy(lines):
    """Of a family, by log2 n: the greatest ratios, by panel."""
    greatest = {}
    for line in lines:
        fields = [f.strip() for f in line.split("|")]
        if len(fields) == 9 and fields[2].isdigit():
            greatest.setdefault(fields[1], {})[math.log2(int(fields[2]))] = [float(f) for f in fields[3:7]]
    return greatest


def read_drums(lines):
    """The same, from three tables."""
    greatest, first = {}, None
    for line in lines:
        if line.startswith("family"):
            first = {"plane": 0, "polygon": 2, "bodies": 3}.get(line.split()[2])
        fields = re.fullmatch(r"(\S.*?) +(\d+)((?: +[\d.]+)+)", line.strip())
        if fields and first is not None and int(fields[2]) >= 8 and fields[1] != "grid":  # a grid has 8 vertices, always
            ratios = greatest.setdefault(fields[1], {}).setdefault(math.log2(int(fields[2])), [0.0] * 4)
            for k, ratio in enumerate(fields[3].split()):
                ratios[first + k] = float(ratio)
    return greatest


def main():
    if sys.argv[1:] not in (["hierarchy"], ["drums"]):
        sys.exit("usage: plot_solid_probes.py hierarchy|drums < TABLE > SVG")
    is_drums = sys.argv[1] == "drums"
    panels, greatest = (DRUMS, read_drums(sys.stdin)) if is_drums else (HIERARCHY, read_hierarchy(sys.stdin))
    side = (WIDTH - LEFT - 30) // len(panels) - GAP
    powers = sorted({p for of in greatest.values() for p in of})
    if len(powers) < 2:
        sys.exit("plot_solid_probes.py: no table on standard input")
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" '
           'font-family="sans-serif" font-size="13">', f"<title>{'Probes of questions by drums' if is_drums else 'Probes of two polyhedra, near contact'}</title>",
           '<rect width="100%" height="100%" fill="white"/>']
    for column, (title, unit, bound, step) in enumerate(panels):
        left = LEFT + column * (side + GAP)
        most = 1.05 * max(bound, max(ratios[column] for of in greatest.values() for ratios in of.values()))

        def x(power):
            return left + (power - powers[0]) / (powers[-1] - powers[0]) * side

        def y(ratio):
            return LOW - ratio / most * (LOW - TOP)

        out.append(f'<text x="{left}" y="{TOP - 26}" font-weight="bold">{title}</text>')
        out.append(f'<text x="{left}" y="{TOP - 8}">probes / ({unit})</text>')
        for ratio in range(0, int(most), step):
            if abs(ratio - bound) < step / 2:
                continue  # the bound has its own
            out.append(f'<path d="M{left} {y(ratio):.1f}h{side}" stroke="#dddddd"/>')
            out.append(f'<text x="{left - 8}" y="{y(ratio) + 4:.1f}" text-anchor="end">{ratio}</text>')
        out.append(f'<path d="M{left} {y(bound):.1f}h{side}" stroke="#999999" stroke-width="3"/>')
        out.append(f'<text x="{left - 8}" y="{y(bound) + 4:.1f}" text-anchor="end">{bound}</text>')
        for power in range(math.ceil(powers[0]), math.floor(powers[-1]) + 1, 4 if is_drums else 2):
            out.append(f'<text x="{x(power):.1f}" y="{LOW + 20}" text-anchor="middle">2^{power:.0f}</text>')
        for f, of in enumerate(greatest.values()):
            points = " ".join(f"{x(p):.1f},{y(ratios[column]):.1f}" for p, ratios in sorted(of.items()) if ratios[column])
            if points:  # else it was not asked
                out.append(f'<polyline points="{points}" fill="none" {stroke(f)}/>')
    of_what = ("vertices n of a body, the larger of two" if is_drums else "points n of a body, against itself or a sphere of m")
    grey = "the bound that the test asserts" + (", from 1,000 on" if is_drums else "")
    out.append(f'<text x="{LEFT}" y="{LOW + 42}">across: {of_what}; upwards: the greatest ratio seen; grey: {grey}</text>')
    for f, family in enumerate(greatest):
        left, at = LEFT + f % 7 * 128, LOW + 72 + f // 7 * 26
        out.append(f'<line x1="{left}" y1="{at - 4}" x2="{left + 26}" y2="{at - 4}" {stroke(f)}/>')
        out.append(f'<text x="{left + 32}" y="{at}">{family}</text>')
    print("\n".join(out) + "\n</svg>")


def stroke(f):
    dashes = ' stroke-dasharray="5 3"' if f >= len(COLOURS) else ""
    return f'stroke="{COLOURS[f % len(COLOURS)]}" stroke-width="2"{dashes}'


main()
