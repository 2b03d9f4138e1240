#!/usr/bin/env python3
"""Tests of sunder_verify_convex.py: python3 verifier/test_sunder_verify_convex.py."""
import itertools
import json
import os
import random
import sys
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import sunder_verify  # noqa: E402
import sunder_verify_convex as convex  # noqa: E402
from set_files import hexadecimal, outcome, refused_by  # noqa: E402


def some_hulls(rng):
    """Tables of vertices, in any order and not all on the hull; points and segments too."""
    side, size = rng.choice((4, 8, 12)), rng.choice((0, 1, 2, 3))
    hulls = []
    for _ in range(rng.randint(1, 6)):
        x, y = rng.randint(0, side), rng.randint(0, side)
        hulls.append([(x + rng.randint(-size, size), y + rng.randint(-size, size)) for _ in range(rng.randint(1, 4))])
    return hulls


def parting(a, b, is_strict=True):
    """A direction along which a ends before b begins; or not after, and they are not both on a line across it."""
    points = a + b
    for p, q in itertools.permutations(points, 2):
        u, v = q[0] - p[0], q[1] - p[1]
        for d in ((u, v), (-v, u)):
            along_a, along_b = ([d[0] * x + d[1] * y for x, y in hull] for hull in (a, b))
            last, first = max(along_a), min(along_b)
            if last < first or (not is_strict and last == first and (min(along_a) < last or max(along_b) > first)):
                return d
    return None


def contact_of(a, b):
    if parting(a, b):
        return None
    return "touching" if parting(a, b, False) else "overlapping"


def convex_transcript(hulls):
    """The sweep, without looking for contacts. Where two meet, any order and direction will do."""
    ends = [(min(hull), max(hull)) for hull in hulls]
    events = sorted(range(2 * len(hulls)), key=lambda e: (ends[e // 2][e % 2], e))
    line, below, directions = [], [], []

    def become_neighbours(at):
        if 0 < at < len(line):
            directions.append(list(parting(hulls[line[at - 1]], hulls[line[at]]) or (0, 1)))

    for event in events:
        s = event // 2
        if event % 2:
            at = line.index(s)
            del line[at]
            become_neighbours(at)
            continue
        at = sum((parting(hulls[t], hulls[s]) or (0, 1))[1] > 0 for t in line)
        below.append(line[at - 1] if at else -1)
        line.insert(at, s)
        become_neighbours(at)
        become_neighbours(at + 1)
    return events, below, directions


class ConvexPolygons(unittest.TestCase):
    def test_contacts(self):
        rng, count = random.Random(12), {}
        for _ in range(2500):
            a, b = ([(rng.randint(0, 4), rng.randint(0, 4)) for _ in range(rng.randint(1, 4))] for _ in range(2))
            contact = contact_of(a, b)
            if contact:
                for p, _, _ in self.common_points(a, b):
                    place = convex.scaled_point([sunder_verify.number(str(x), "x") for x in p], 0)
                    self.assertEqual(convex.contact_at(a, b, place), contact, (a, b, p))
            count[contact] = count.get(contact, 0) + 1
        self.assertGreater(min(count.values()), 200, count)

    @staticmethod
    def common_points(a, b):
        """Points with their weights in both: vertices of one that are in a triangle of the other, and crossings."""
        def weights(names, hull, p):
            m = [hull[k] for k in names]
            if len(m) == 1:
                return [Fraction(1)] if m[0] == p else None
            u, v = (m[1][0] - m[0][0], m[1][1] - m[0][1]), (p[0] - m[0][0], p[1] - m[0][1])
            if len(m) == 2:
                if u == (0, 0) or u[0] * v[1] != u[1] * v[0]:
                    return None
                t = Fraction(v[0], u[0]) if u[0] else Fraction(v[1], u[1])
                return [1 - t, t] if 0 <= t <= 1 else None
            t = m[2][0] - m[0][0], m[2][1] - m[0][1]
            area = u[0] * t[1] - u[1] * t[0]
            if not area:
                return None
            r, s = Fraction(v[0] * t[1] - v[1] * t[0], area), Fraction(u[0] * v[1] - u[1] * v[0], area)
            return [1 - r - s, r, s] if min(r, s, 1 - r - s) >= 0 else None

        def inside(hull, p):
            for m in (1, 2, 3):
                for names in itertools.combinations(range(len(hull)), m):
                    w = weights(names, hull, p)
                    if w:
                        return [[k, str(x)] for k, x in zip(names, w)]
            return None

        candidates = set(a) | set(b)
        for p, q in itertools.combinations(a, 2):
            for r, s in itertools.combinations(b, 2):
                u, v = (q[0] - p[0], q[1] - p[1]), (s[0] - r[0], s[1] - r[1])
                area = u[0] * v[1] - u[1] * v[0]
                if area:
                    t = Fraction((r[0] - p[0]) * v[1] - (r[1] - p[1]) * v[0], area)
                    candidates.add((p[0] + t * u[0], p[1] + t * u[1]))
        found = []
        for p in sorted(candidates):
            in_a, in_b = inside(a, p), inside(b, p)
            if in_a and in_b:
                found.append((p, in_a, in_b))
        return found

    def test_a_transcript_is_accepted_if_and_only_if_none_meet(self):
        rng, count = random.Random(13), {}
        for _ in range(2500):
            hulls = some_hulls(rng)
            free = all(parting(a, b) for a, b in itertools.combinations(hulls, 2))
            check = refused_by(lambda: convex.check_none(hulls, *convex_transcript(hulls)))
            self.assertEqual(check is None, free, (hulls, check))
            count[check] = count.get(check, 0) + 1
        for check in (None, "T1", "T4"):
            self.assertGreater(count[check], 200, count)

    def test_no_transcript_at_all_proves_what_is_not_true(self):
        rng, count = random.Random(14), {}
        for _ in range(6000):
            hulls = some_hulls(rng)
            if len(hulls) < 2:
                continue
            free = all(parting(a, b) for a, b in itertools.combinations(hulls, 2))
            events, below, directions = convex_transcript(hulls)
            for _ in range(rng.randint(1, 3)):
                what, i, j = rng.randrange(5), rng.randrange(len(events)), rng.randrange(len(events))
                if what == 0:
                    below[rng.randrange(len(below))] = rng.randint(-1, len(hulls) - 1)
                elif what == 1:
                    events.insert(j, events.pop(i))
                elif what == 2 and directions:
                    directions[rng.randrange(len(directions))] = [rng.randint(-2, 2), rng.randint(-2, 2)]
                elif what == 3 and directions:
                    directions.pop(rng.randrange(len(directions)))
                else:
                    hull = rng.choice(hulls)
                    hull[rng.randrange(len(hull))] = rng.randint(0, 8), rng.randint(0, 8)
                    free = all(parting(a, b) for a, b in itertools.combinations(hulls, 2))
            check = refused_by(lambda: convex.check_none(hulls, events, below, directions))
            self.assertTrue(free or check, (hulls, events, below, directions))
            count[check, free] = count.get((check, free), 0) + 1
        for check in (None, "T1", "T2", "T3", "T4"):
            self.assertGreater(count.get((check, True), 0), 30, count)

    def test_files_and_the_check_that_each_fails(self):
        square, top, lone = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 2), (3, 4), (0, 4)], [(1, 1)]
        touch = {"question": "convex_polygons_any", "allowed": "nothing", "verdict": "some", "i": 0, "j": 1,
                 "contact": "touching", "point": ["1", "2"], "weights_i": [[2, "1/2"], [3, "1/2"]],
                 "weights_j": [[0, "1"]]}
        inside = {**touch, "j": 2, "contact": "overlapping", "point": ["1", "1"], "weights_i": [[0, "1/2"], [2, "1/2"]]}

        def found(statement, change, hulls=(square, top, lone)):
            table = [[[hexadecimal(n) for n in p] for p in hull] for hull in hulls]
            return outcome(json.dumps({"sunder_set_certificate": 1, "convex_polygons": table,
                                       "statements": [{**statement, **change}]}).encode())

        self.assertEqual(found(touch, {}), "-")
        self.assertEqual(found(touch, {"allowed": "shared-endpoint"}), "-")
        self.assertEqual(found(touch, {"allowed": "touch"}), "C1")
        self.assertEqual(found(touch, {"groups": [5, 5, 6]}), "C1")
        self.assertEqual(found(touch, {"groups": [5, 4, 5]}), "-")
        self.assertEqual(found(touch, {"point": ["1", "1"]}), "C2")
        self.assertEqual(found(touch, {"weights_j": [[1, "1"]]}), "C2")
        self.assertEqual(found(touch, {"weights_j": []}), "C2")
        self.assertEqual(found(touch, {"weights_i": [[2, "3/2"], [3, "1/2"], [1, "-1"]]}), "C2")
        self.assertEqual(found(touch, {"weights_i": [[2, "1"], [3, "1"]], "point": ["2", "4"]}), "C2")
        self.assertEqual(found(touch, {"contact": "overlapping"}), "C3")
        self.assertEqual(found(inside, {"allowed": "touch"}), "-")
        self.assertEqual(found(inside, {"contact": "touching"}), "C3")
        for change in ({"i": 1}, {"j": 3}, {"contact": "none"}, {"point": ["1"]}, {"weights_i": [[4, "1"]]},
                       {"weights_i": [[0, "1/2"], [0, "1/2"]]}, {"weights_i": [0]}, {"groups": [1, 2]}):
            self.assertEqual(found(touch, change), "F", change)
        self.assertEqual(found(touch, {}, (square, [], lone)), "F")
        self.assertEqual(found(touch, {}, (square, top, [(1, 1, 1)])), "F")
        none = {"question": "convex_polygons_any", "allowed": "nothing", "verdict": "none",
                "events": [0, 2, 4, 5, 3, 1], "below": [-1, 0, 1], "directions": [["0", "1"], ["0", "1"]]}
        apart = [[(0, 0), (9, 0), (5, 1)], [(1, 3), (7, 4)], [(2, 6)]]
        self.assertEqual(found(none, {}, apart), "-")
        self.assertEqual(found(none, {"events": [0, 2, 4, 3, 5, 1]}, apart), "T1")
        self.assertEqual(found(none, {"events": [0, 2, 4, 5, 3, 3]}, apart), "T1")
        self.assertEqual(found(none, {}, apart[:2] + [[(1, 3)]]), "T1")
        self.assertEqual(found(none, {"below": [-1, 2, 1]}, apart), "T2")
        self.assertEqual(found(none, {"directions": [["0", "1"], ["1", "0"]]}, apart), "T3")
        self.assertEqual(found(none, {"below": [-1, -1, 1], "directions": [["0", "-1"], ["0", "1"]]}, apart), "T3")
        self.assertEqual(found(none, {"directions": [["0", "1"], ["9", "1"]]}, apart), "T4")
        self.assertEqual(found(none, {"directions": [["0", "1"]]}, apart), "T4")
        self.assertEqual(found(none, {"directions": [["0", "1"]] * 3}, apart), "T4")
        self.assertEqual(found(none, {}, [[(0, 0), (9, 0), (5, 5)]] + apart[1:]), "T4")
        self.assertEqual(found(none, {"allowed": "touch"}, apart), "F")
        self.assertEqual(found(none, {"groups": [1, 2, 3]}, apart), "F")


if __name__ == "__main__":
    unittest.main()
