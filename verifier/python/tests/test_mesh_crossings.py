#!/usr/bin/env python3
"""Statements that no two triangles of a mesh cross: of small ones, of which clipping tells what two have in common."""
import itertools
import unittest
from fractions import Fraction

import files
from files import FORCED, MUTANT, Twins, dice_of, hexadecimal, lacking, main
from test_hulls import cross, dot, minus

QUESTION = "mesh_crossing"


def normal(t):
    return cross(minus(t[1], t[0]), minus(t[2], t[0]))


def clipped(polygon, n, at):
    """What of a polygon, a segment or a point is where n (x - at) >= 0."""
    result = []
    for k, p in enumerate(polygon):
        q = polygon[(k + 1) % len(polygon)]
        h, g = dot(n, minus(p, at)), dot(n, minus(q, at))
        if h >= 0:
            result.append(p)
        if h * g < 0:
            result.append([x + Fraction(h, h - g) * (y - x) for x, y in zip(p, q)])
    return result


def common_part(t, u):
    """The corners of what two triangles have in common, some of them twice."""
    n = normal(u)
    part = clipped(clipped(t, n, u[0]), [-x for x in n], u[0])
    for k in range(3):
        part = part and clipped(part, cross(n, minus(u[(k + 1) % 3], u[k])), u[k])
    return part


def is_on(p, ends):
    """Is a point one of these, or between two?"""
    if len(ends) == 1:
        return p == ends[0]
    way, to = minus(ends[1], ends[0]), minus(p, ends[0])
    return not any(cross(way, to)) and 0 <= dot(way, to) <= dot(way, way)


def do_cross(points, t, u):
    shared, part = [points[k] for k in t if k in u], common_part([points[k] for k in t], [points[k] for k in u])
    return len(shared) == 3 or any(not shared or not is_on(p, shared) for p in part)


def ways_between(t, u):
    """Directions of which one parts two triangles that are apart."""
    edges = [[minus(s[(k + 1) % 3], s[k]) for k in range(3)] for s in (t, u)]
    yield from (normal(t), normal(u))
    yield from (cross(normal(s), e) for s, those in ((t, edges[0]), (u, edges[1])) for e in those)
    yield from (cross(e, f) for e, f in itertools.product(*edges))


def parts_them(way, those, others):
    return max(dot(way, p) for p in those) < min(dot(way, p) for p in others)


def walk(points, triangles, dice):
    """Cuts and directions; of two that nothing parts, any direction."""
    cuts, directions = [], []

    def corners(part):
        return [points[k] for t in triangles[part[0]:part[1]] for k in t]

    def go(one, other):
        is_single = one[1] - one[0] == other[1] - other[0] == 1
        if is_single and (one == other or {*triangles[one[0]]} & {*triangles[other[0]]}):
            return
        if one == other:
            k = dice.randint(one[0] + 1, one[1] - 1)
            cuts.append(k)
            before, behind = (one[0], k), (k, one[1])
            go(before, before)
            go(before, behind)
            go(behind, behind)
            return
        ways = ways_between(*([points[k] for k in triangles[part[0]]] for part in (one, other))) if is_single else (
            [dice.randint(-3, 3) for _ in range(3)] for _ in range(4))
        for way in itertools.chain.from_iterable((w, [-x for x in w]) for w in ways):
            if parts_them(way, corners(one), corners(other)):
                break
        else:
            if not is_single:
                which = one[1] - one[0] > 1 and (other[1] - other[0] == 1 or dice.random() < .5)
                part = one if which else other
                k = dice.randint(part[0] + 1, part[1] - 1)
                cuts.append(k if which else -k)
                for half in (part[0], k), (k, part[1]):
                    go(*((half, other) if which else (one, half)))
                return
        cuts.append(0)
        directions.append([str(x) for x in way])
    go((0, len(triangles)), (0, len(triangles)))
    return cuts, directions


class MeshCrossings(unittest.TestCase):
    def test_statements(self):
        """What is so is accepted; what is not is refused, whatever the walk."""
        dice, twins, true = dice_of(4401), Twins(self), 0
        while "none" in lacking(FORCED, QUESTION) or "none" in lacking(MUTANT, QUESTION):
            size, count = dice.choice((1, 2, 2, 4)), dice.randint(3, 8)
            points = [list(p) for p in {tuple(dice.randint(0, size) for _ in range(3)) for _ in range(count)}]
            if dice.random() < .2:
                points = [list(p) for p in {(x, y, x + y) for x, y, _ in points}]
            triples = [t for t in itertools.permutations(range(len(points)), 3) if any(normal([points[k] for k in t]))]
            if not triples:
                continue
            triangles = [list(dice.choice(triples)) for _ in range(dice.randint(1, 4))]
            is_true = not any(do_cross(points, t, u) for t, u in itertools.combinations(triangles, 2))
            cuts, directions = walk(points, triangles, dice)
            scale = Fraction(2) ** dice.choice((0, 0, -1074, 970))
            tables = {"meshes": [{"name": "a", "points": [[hexadecimal(scale * x) for x in p] for p in points],
                                  "triangles": triangles}]}

            def said(cuts, directions):
                return files.file_of(tables, {"question": QUESTION, "a": 0, "verdict": "none", "claims": [
                    {"claim": "no_crossings", "cuts": cuts, "directions": directions}]})
            self.assertEqual(twins.force(said(cuts, directions)), "accepted" if is_true else "no_crossings", twins.last)
            true += is_true
            k = dice.randrange(len(cuts)) if cuts else 0
            for those in ((cuts[:k] + cuts[k + 1:], directions), (cuts + [0], directions), (cuts, directions + [["1", "0", "0"]]),
                          (cuts[:k] + [dice.choice((-1, 0, 1, 9, -10 ** 15 + 1))] + cuts[k + 1:], directions))[0 if cuts else 1:]:
                if those != (cuts, directions) and dice.random() < .3:
                    found = twins.force(said(*those))
                    self.assertTrue(is_true or found != "accepted", twins.last)
            twins.spoil(said(cuts, directions), dice)
        twins.compare()
        self.assertGreater(true, 20 * min(files.SCALE, 1))

    def test_what_is_not_looked_at(self):
        """A triangle without area, an image, and a mesh with an edge that ends inside another one are refused."""
        twins = Twins(self)
        points = [["0x0p0"] * 3, ["0x1p0", "0x0p0", "0x0p0"], ["0x1p1", "0x0p0", "0x0p0"], ["0x1p0", "0x1p0", "0x0p0"], ["0x1p0", "-0x1p0", "0x0p0"]]
        image = {"name": "b", "of": 0, "linear": ["0x1p0", "0x0p0", "0x0p0", "0x0p0", "0x1p0", "0x0p0", "0x0p0", "0x0p0", "0x1p0"], "translation": ["0x0p0"] * 3}

        def look(triangles, a, cuts, directions):
            return twins.look(files.file_of({"meshes": [{"name": "a", "points": points, "triangles": triangles}, image]}, {
                "question": QUESTION, "a": a, "verdict": "none",
                "claims": [{"claim": "no_crossings", "cuts": cuts, "directions": directions}]}))
        self.assertEqual(look([[0, 1, 3]], 0, [], []), "accepted")
        self.assertEqual(look([[0, 1, 3]], 1, [], []), "no_crossings")
        self.assertEqual(look([[0, 1, 2]], 0, [], []), "no_crossings")
        self.assertEqual(look([[0, 1, 3], [1, 2, 3]], 0, [1], []), "accepted")
        self.assertEqual(look([[0, 2, 3], [0, 1, 4]], 0, [1], []), "no_crossings")  # edges of both on one line
        for way in itertools.product(("-1", "0", "1"), repeat=3):
            self.assertEqual(look([[0, 2, 3], [1, 4, 4]], 0, [1, 0], [list(way)]), "no_crossings")
        twins.compare()

    def test_touching_and_nested(self):
        """A corner on a triangle of others, along a direction that shows no gap; one triangle in the angle of another one."""
        twins = Twins(self)

        def look(points, triangles, cuts, directions):
            return twins.look(files.file_of({"meshes": [{
                "name": "a", "points": [[hexadecimal(x) for x in p] for p in points], "triangles": triangles}]}, {
                    "question": QUESTION, "a": 0, "verdict": "none",
                    "claims": [{"claim": "no_crossings", "cuts": cuts, "directions": directions}]}))
        large = [(0, 0, 0), (4, 0, 0), (0, 4, 0)]
        for lift, found in (0, "no_crossings"), (1, "accepted"):
            above = [(1, 1, lift), (1, 1, 2), (2, 1, 2)]
            self.assertEqual(look(large + above, [[0, 1, 2], [3, 4, 5]], [1, 0], [["0", "0", "1"]]), found)
        for z, found in (0, "no_crossings"), (1, "accepted"):
            points = large + [(2, 1, z), (1, 2, z)]
            for triangles in itertools.permutations(([0, 1, 2], [0, 3, 4])):
                self.assertEqual(look(points, [*triangles], [1], []), found)
        twins.compare()


if __name__ == "__main__":
    main()
