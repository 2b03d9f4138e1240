#!/usr/bin/env python3
"""Which bodies can hide each other in a drawing? Shamos & Hoey 1976, section I: ask before the hidden lines are sought.

    examples/hidden_lines.py AXIS BODY.obj... > outlines.geojson
    sunder polygons outlines.geojson --allow touch --all

Looks along AXIS (x, y or z) and writes for each convex body the outline that is seen: the hull of its vertices without
that coordinate. Two bodies can hide a part of each other only where their outlines overlap: for all other pairs no
hidden line has to be looked for. Along an axis nothing is rounded, so the answer about the outlines is exact. Of a body
that is not convex the outline is that of its hull: it may be said to hide what it does not, never the other way round.
A body that is seen as a line or a point hides nothing, and is left out with a word.
"""
import json
import sys
from fractions import Fraction


def vertices(path):
    with open(path, encoding="utf-8") as lines:
        fields = [line.split() for line in lines]
    return [tuple(float(x) for x in f[1:4]) for f in fields if f and f[0] == "v"]


def left_turn(p, q, r):
    (px, py), (qx, qy), (rx, ry) = ((Fraction(x), Fraction(y)) for x, y in (p, q, r))
    return (qx - px) * (ry - py) > (qy - py) * (rx - px)


def hull(points):
    """Counter-clockwise and strictly convex, by Andrew's chains."""
    points = sorted(set(points))
    if len(points) < 3:
        return points
    chains = []
    for run in (points, points[::-1]):
        chain = []
        for p in run:
            while len(chain) > 1 and not left_turn(chain[-2], chain[-1], p):
                chain.pop()
            chain.append(p)
        chains.append(chain)
    return chains[0][:-1] + chains[1][:-1]


def main():
    if len(sys.argv) < 3 or sys.argv[1] not in ("x", "y", "z"):
        sys.exit("usage: hidden_lines.py x|y|z BODY.obj...")
    axis = "xyz".index(sys.argv[1])
    features = []
    for path in sys.argv[2:]:
        outline = hull([v[:axis] + v[axis + 1:] for v in vertices(path)])
        if len(outline) < 3:
            print("%s: seen as a line or a point, hides nothing" % path, file=sys.stderr)
            continue
        features.append({"type": "Feature", "properties": {"name": path},
                         "geometry": {"type": "Polygon", "coordinates": [outline + outline[:1]]}})
    json.dump({"type": "FeatureCollection", "features": features}, sys.stdout)
    print()


if __name__ == "__main__":
    main()
