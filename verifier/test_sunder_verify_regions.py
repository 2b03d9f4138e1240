#!/usr/bin/env python3
"""Tests of sunder_verify_regions.py: python3 verifier/test_sunder_verify_regions.py."""
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
import sunder_verify_regions as regions  # noqa: E402
from set_files import as_file, hexadecimal, outcome, refused_by  # noqa: E402


# ---- Half-planes.

def some_half_planes(rng):
    """Small numbers: parallel, repeated and concurrent ones are common. Some tangent to one point, or to a polygon."""
    size, most, offset = rng.randint(1, 7), rng.choice((1, 2, 3)), rng.choice((0, 1, 3, 8))
    given = []
    while len(given) < size:
        if given and rng.randrange(6) == 0:
            a, b, c = rng.choice(given)
            given.append(rng.choice(((-a, -b, -c), (a, b, c), (-2 * a, -2 * b, -2 * c + 1))))
            continue
        a, b = rng.randint(-most, most), rng.randint(-most, most)
        if a or b:
            given.append((a, b, rng.randint(-offset // 2, offset)))
    return given


def corners_of(given):
    found = set()
    for h, k in itertools.combinations(given, 2):
        w = h[0] * k[1] - h[1] * k[0]
        if w:
            p = Fraction(h[2] * k[1] - k[2] * h[1], w), Fraction(h[0] * k[2] - k[0] * h[2], w)
            if all(a * p[0] + b * p[1] <= c for a, b, c in given):
                found.add(p)
    return found


def rays_of(given):
    """Directions of the common part's infinity, from those along lines and normals."""
    directions = {(s * x, s * y) for a, b, _ in given for x, y in ((-b, a), (a, b)) for s in (1, -1)}
    return [d for d in directions if all(a * d[0] + b * d[1] <= 0 for a, b, _ in given)]


def kind_of_region(given):
    """By corners, ends at infinity, and points on lines."""
    if not given:
        return "plane"
    corners, rays = corners_of(given), rays_of(given)
    if corners:
        p = next(iter(corners))
        ways = [(q[0] - p[0], q[1] - p[1]) for q in corners] + rays
        rank = max([1] * any(w != (0, 0) for w in ways) +
                   [2 for u, v in itertools.combinations(ways, 2) if u[0] * v[1] != u[1] * v[0]], default=0)
        if rank == 2:
            return "unbounded" if rays else "bounded"
        return ("ray" if rays else "segment") if rank else "point"
    # All lines are parallel, or it is empty.
    a, b, _ = given[0]
    if any(a * h[1] != b * h[0] for h in given):
        return "empty"
    high = [Fraction(h[2], a * h[0] + b * h[1]) for h in given if a * h[0] + b * h[1] > 0]
    low = [Fraction(h[2], a * h[0] + b * h[1]) for h in given if a * h[0] + b * h[1] < 0]
    if not high or not low:
        return "half-plane"
    return ("empty", "line", "strip")[(min(high) >= max(low)) + (min(high) > max(low))]


def find_region(given, verdict):
    """Evidence by trying all: sides in every order of few, then for each half-plane every cone. None: there is none."""
    least, most, _ = regions.SIDES[verdict]
    n = len(given)
    for m in range(least, n + 1 if most is None else min(most, n) + 1):
        for names in itertools.combinations(range(n), m):
            is_round = regions.SIDES[verdict][2]  # then the start does not matter
            orders = ((names[:1] + rest for rest in itertools.permutations(names[1:])) if is_round else
                      itertools.permutations(names))
            for sides in orders:
                chosen = [given[k] for k in sides]
                if refused_by(lambda: (regions.check_normals(verdict, chosen), regions.check_lines(verdict, chosen))):
                    continue
                cones, count = [], max(m - (verdict in ("ray", "unbounded")), 0)
                for h in given if verdict != "empty" else ():
                    cone = next((p for p in range(count) if not refused_by(
                        lambda: regions.check_others(verdict, chosen, [p], [h]))), None)
                    if cone is None:
                        break
                    cones.append(cone)
                else:
                    return list(sides), cones
    return None


class Regions(unittest.TestCase):
    def test_each_kind_has_evidence_and_no_other(self):
        rng, count = random.Random(5), {}
        for _ in range(200):
            given = some_half_planes(rng)[:5]
            kind = kind_of_region(given)
            for verdict in regions.SIDES:
                found = find_region(given, verdict)
                self.assertEqual(found is not None, verdict == kind, (given, kind, verdict, found))
            count[kind] = count.get(kind, 0) + 1
        for kind in regions.SIDES:
            self.assertGreaterEqual(count.get(kind, 0), 0 if kind == "plane" else 1, count)

    def test_mutations(self):
        """What is accepted is true of the half-planes, whatever the evidence."""
        rng, count = random.Random(6), {}
        while sum(count.values()) < 6000:
            given = some_half_planes(rng)[:5]
            kind = kind_of_region(given)
            sides, cones = find_region(given, kind)
            for _ in range(12):
                g, verdict, s, c = list(given), kind, list(sides), list(cones)
                for _ in range(rng.choice((1, 1, 2))):
                    what = rng.randrange(6)
                    i = rng.randrange(len(g))
                    if what == 0:
                        row = list(g[i])
                        row[rng.randrange(3)] += rng.choice((-1, 1))
                        g[i] = tuple(row) if row[0] or row[1] else g[i]
                    elif what == 1 and s:
                        s[rng.randrange(len(s))] = i
                    elif what == 2 and s:
                        s.pop(rng.randrange(len(s)))
                    elif what == 3:
                        s.insert(rng.randint(0, len(s)), i)
                    elif what == 4:
                        verdict = rng.choice(sorted(regions.SIDES))
                    elif c:
                        c[rng.randrange(len(c))] = rng.randrange(5)
                table = regions.Table({"half_planes": [[hexadecimal(n) for n in h] for h in g]})
                item = {"verdict": verdict, "sides": s, "cones": c}
                check = refused_by(lambda: table.read_region(item, "x")[3]())
                if check is None:
                    self.assertEqual(verdict, kind_of_region(g), (g, item))
                count[check] = count.get(check, 0) + 1
        for check in (None, "F", "S1", "S2", "S3", "S4"):
            self.assertGreater(count[check], 40, count)

    def test_arrows_are_half_planes(self):
        rng = random.Random(7)
        for _ in range(2000):
            px, py, qx, qy = (rng.randint(-9, 9) for _ in range(4))
            scale = rng.randint(-40, 40)
            row = ["%s0x%xp%d" % ("-" if n < 0 else "", abs(n), scale) for n in (px, py, qx, qy)]
            if (px, py) == (qx, qy):
                self.assertEqual(refused_by(lambda: regions.half_plane(row, "x")), "F")
                continue
            a, b, c = regions.half_plane(row, "x")
            for _ in range(5):
                x, y = rng.randint(-9, 9), rng.randint(-9, 9)
                left = (qx - px) * (y - py) - (qy - py) * (x - px)
                unit = Fraction(2) ** scale
                value = a * x * unit + b * y * unit - c
                self.assertEqual((value > 0) - (value < 0), (left < 0) - (left > 0))

    def test_files_and_the_check_that_each_fails(self):
        square = [(1, 0, 1), (0, 1, 1), (-1, 0, 1), (0, -1, 1), (1, 1, 2), (1, 0, 5)]
        bounded = {"question": "half_planes", "verdict": "bounded", "sides": [0, 1, 2, 3], "cones": [0, 1, 2, 3, 0, 0]}

        def found(change, given=square):
            return outcome(as_file("half_planes", given, {**bounded, **change}))

        self.assertEqual(found({}), "-")
        self.assertEqual(found({"sides": [1, 2, 3, 0], "cones": [3, 0, 1, 2, 3, 3]}), "-")
        self.assertEqual(found({"cones": [3, 0, 1, 2, 0, 3]}), "-")
        self.assertEqual(found({"sides": [0, 2, 1, 3]}), "S1")
        self.assertEqual(found({"sides": [0, 1, 2, 3, 0, 1, 2, 3]}), "S1")
        self.assertEqual(found({"sides": [0, 1, 2]}), "F")
        self.assertEqual(found({"sides": [0, 1, 2], "cones": [0] * 6}), "S1")
        self.assertEqual(found({"sides": [0, 4, 1, 2, 3], "cones": [0, 2, 3, 4, 1, 0]}), "S2")
        self.assertEqual(found({"cones": [0, 1, 2, 3, 1, 0]}), "S3")
        self.assertEqual(found({"cones": [0, 1, 2, 3, 0, 1]}), "S3")
        self.assertEqual(found({}, square[:4] + [(1, 1, 1), square[5]]), "S4")
        self.assertEqual(found({"verdict": "unbounded", "sides": [0, 1, 2], "cones": [0, 0, 1, 1, 0, 0]}), "S3")
        self.assertEqual(found({"verdict": "unbounded", "sides": [0, 1, 2], "cones": [0, 0, 1, 2, 0, 0]}), "F")
        self.assertEqual(found({"verdict": "unbounded"}), "F")
        self.assertEqual(found({"verdict": "unbounded", "cones": [0] * 6}), "S1")
        self.assertEqual(found({"verdict": "plane", "sides": [], "cones": []}), "F")
        self.assertEqual(found({"verdict": "plane", "sides": [], "cones": []}, []), "-")
        self.assertEqual(found({"verdict": "empty", "sides": [0, 1, 2]}), "S1")
        self.assertEqual(found({"verdict": "empty", "sides": [0, 2]}), "S2")
        self.assertEqual(found({"verdict": "empty", "sides": [0, 2]}, [(1, 0, 1), (0, 1, 1), (-2, 0, -3)]), "-")
        self.assertEqual(found({"verdict": "empty", "sides": [0, 1]}, [(1, 0, 1), (1, 0, -3)]), "S1")
        triple = [(1, 0, 0), (0, 1, 0), (-1, -1, -1)]
        self.assertEqual(found({"verdict": "empty", "sides": [0, 1, 2]}, triple), "-")
        self.assertEqual(found({"verdict": "empty", "sides": [1, 0, 2]}, triple), "S1")
        self.assertEqual(found({"verdict": "empty", "sides": [0, 1, 2]}, triple[:2] + [(-1, -1, 0)]), "S2")
        self.assertEqual(found({"verdict": "point", "sides": [0, 1, 2], "cones": [0, 1, 2]},
                               triple[:2] + [(-1, -1, 0)]), "-")
        self.assertEqual(found({"verdict": "point", "sides": [0, 1, 2], "cones": [0, 1, 2]},
                               triple[:2] + [(-1, -1, 1)]), "S2")
        for change in ({"sides": [0, 1, 2, 6]}, {"cones": [0] * 5}, {"cones": [4] + [0] * 5}, {"verdict": "full"},
                       {"cones": [-1] + [0] * 5}, {"sides": 3}, {"sides": [True, 1, 2, 3]}):
            self.assertEqual(found(change), "F", change)
        self.assertEqual(found({}, [(0, 0, 1)] + square[1:]), "F")
        self.assertEqual(found({}, [(1, 1, 1, 1)] + square[1:]), "F")
        self.assertEqual(found({}, [(1, 1)] + square[1:]), "F")
        self.assertEqual(found({}, [(1, -9, 1, 9)] + square[1:]), "-")  # the arrow that has x <= 1 on its left


# ---- Linear programs.

def outcome_of_program(given, p, q):
    """The outcome, and which corners are optimal, where some are."""
    if kind_of_region(given) == "empty":
        return "infeasible", set()
    if p == q == 0:
        return "all", set()
    rays = rays_of(given) + ([(p, q)] if all(a * p + b * q <= 0 for a, b, _ in given) else [])
    if any(p * x + q * y > 0 for x, y in rays):
        return "unbounded", set()
    corners = corners_of(given)
    best = max((p * x + q * y for x, y in corners), default=None)
    optimal = {(x, y) for x, y in corners if p * x + q * y == best}
    is_one = len(optimal) == 1 and not any(p * x + q * y == 0 for x, y in rays)
    return "one" if is_one else "many", optimal


def foot(h):
    """The point of a line that is nearest to the origin."""
    return Fraction(h[0] * h[2], h[0] ** 2 + h[1] ** 2), Fraction(h[1] * h[2], h[0] ** 2 + h[1] ** 2)


def find_program(given, p, q, verdict):
    """Evidence by trying all, or None."""
    n = range(len(given))
    item = {"question": "linear_program", "verdict": verdict, "objective": [hexadecimal(p), hexadecimal(q)]}

    def tries():
        if verdict == "infeasible":
            for m in (2, 3):
                for sides in itertools.permutations(n, m):
                    yield {**item, "sides": list(sides)}
            return
        for x, y in sorted(corners_of(given)) + [foot(h) for h in given]:
            if any(a * x + b * y > c for a, b, c in given):
                continue
            at = {**item, "point": [str(x), str(y)]}
            near = [k for k in n if given[k][0] * x + given[k][1] * y == given[k][2]]
            if verdict == "one":
                for m in (2, 3):
                    for tight in itertools.permutations(near, m):
                        yield {**at, "tight": list(tight)}
            elif verdict == "unbounded":
                for u, v in sorted(set(rays_of(given)) | {(p, q)}):
                    yield {**at, "direction": [str(u), str(v)]}
            elif verdict == "all":
                yield at
            else:
                for side in near:
                    for before, after in itertools.product((-1, *n), repeat=2):
                        yield {**at, "side": side, "before": before, "after": after}

    table = table_of(given)
    return next((t for t in tries() if not refused_by(lambda: table.read_linear_program(t, "x")[3]())), None)


def table_of(given):
    return regions.Table({"half_planes": [[hexadecimal(n) for n in h] for h in given]})


class LinearPrograms(unittest.TestCase):
    def test_each_outcome_has_evidence_and_no_other(self):
        rng, count = random.Random(8), {}
        for _ in range(400):
            given = some_half_planes(rng)[:5]
            p, q = rng.randint(-2, 2), rng.randint(-2, 2)
            truth, _ = outcome_of_program(given, p, q)
            for verdict in ("one", "many", "all", "unbounded", "infeasible"):
                found = find_program(given, p, q, verdict)
                self.assertEqual(found is not None, verdict == truth, (given, p, q, truth, found))
            count[truth] = count.get(truth, 0) + 1
        self.assertGreater(min(count.values()), 15, count)
        self.assertEqual(len(count), 5)

    def test_mutations(self):
        """What is accepted is true, whatever the evidence."""
        rng, count = random.Random(9), {}
        while sum(count.values()) < 6000:
            given = some_half_planes(rng)[:5]
            p, q = rng.randint(-2, 2), rng.randint(-2, 2)
            item = find_program(given, p, q, outcome_of_program(given, p, q)[0])
            for _ in range(8):
                self.look(rng, list(given), json.loads(json.dumps(item)), p, q, count)
        for check in (None, "F", "L1", "L2", "L3", "L4", "S1", "S2"):
            self.assertGreater(count[check], 8, count)

    def look(self, rng, g, item, p, q, count):
        i = rng.randrange(len(g))
        key = rng.choice(sorted(set(item) - {"question"}))
        if rng.randrange(4) == 0:
            row = list(g[i])
            row[rng.randrange(3)] += rng.choice((-1, 1))
            g[i] = tuple(row) if row[0] or row[1] else g[i]
        elif key == "verdict":
            item[key] = rng.choice(("one", "many", "all", "unbounded", "infeasible"))
        elif key == "objective":
            p, q = rng.randint(-2, 2), rng.randint(-2, 2)
            item[key] = [hexadecimal(p), hexadecimal(q)]
        elif key in ("point", "direction"):
            item[key][rng.randrange(2)] = str(rng.randint(-3, 3))
        elif key in ("tight", "sides"):
            item[key][rng.randrange(len(item[key]))] = i
        else:
            item[key] = rng.choice((-1, i))
        check = refused_by(lambda: table_of(g).read_linear_program(item, "x")[3]())
        count[check] = count.get(check, 0) + 1
        if check is not None:
            return
        truth, optimal = outcome_of_program(g, p, q)
        self.assertEqual(item["verdict"], truth, (g, item))
        if truth == "one":
            self.assertEqual({tuple(Fraction(x) for x in item["point"])}, optimal, (g, item))
        if truth == "many":  # its ends, and no corner more
            ends = [g[item[e]] for e in ("before", "after") if item[e] >= 0]
            for x, y in optimal:
                self.assertTrue(any(a * x + b * y == c for a, b, c in ends), (g, item))
            self.assertEqual(len(optimal), len(ends), (g, item))

    def test_files_and_the_check_that_each_fails(self):
        square = [(1, 0, 1), (0, 1, 1), (-1, 0, 1), (0, -1, 1)]
        one = {"question": "linear_program", "objective": ["0x1p+0", "0x1p+0"], "verdict": "one", "point": ["1", "1"],
               "tight": [0, 1]}
        many = {"question": "linear_program", "objective": ["0x1p+0", "0x0p+0"], "verdict": "many",
                "point": ["1", "1/3"], "side": 0, "before": 3, "after": 1}
        far = {"question": "linear_program", "objective": ["0x1p+0", "0x0p+0"], "verdict": "unbounded",
               "point": ["-1", "1"], "direction": ["3", "0"]}

        def found(statement, change, given=square):
            return outcome(as_file("half_planes", given, {**statement, **change}))

        self.assertEqual(found(one, {}), "-")
        self.assertEqual(found(one, {"point": ["1", "1/2"]}), "L2")
        self.assertEqual(found(one, {"point": ["1", "2"]}), "L1")
        self.assertEqual(found(one, {"tight": [1, 0]}), "L3")
        self.assertEqual(found(one, {"objective": ["0x1p+0", "0x0p+0"]}), "L3")
        self.assertEqual(found(one, {"objective": ["0x0p+0", "0x0p+0"]}), "L3")
        self.assertEqual(found(one, {"tight": [0]}), "F")
        self.assertEqual(found(one, {"objective": ["1", "1"]}), "F")
        wedge, ahead = [(1, 0, 1), (1, -1, 1), (1, 1, 1)], {"objective": ["0x1p+0", "0x0p+0"], "point": ["1", "0"]}
        self.assertEqual(found(one, {**ahead, "tight": [1, 0, 2]}, wedge), "-")
        self.assertEqual(found(one, {**ahead, "tight": [2, 0, 1]}, wedge), "L3")
        self.assertEqual(found(many, {}), "-")
        self.assertEqual(found(many, {"point": ["0", "0"]}), "L2")
        self.assertEqual(found(many, {"point": ["2", "0"]}), "L1")
        self.assertEqual(found(many, {"objective": ["0x0p+0", "0x0p+0"]}), "L3")
        # That there is more than one point of a zero objective is not said without a proof.
        at_origin = {"point": ["0", "0"], "objective": ["0x0p+0", "0x0p+0"]}
        self.assertEqual(found(many, {**at_origin, "side": -1}), "F")
        self.assertEqual(found(many, {**at_origin, "verdict": "all"}), "-")
        self.assertEqual(found(many, {"verdict": "all"}), "L3")
        self.assertEqual(found(many, {**at_origin, "verdict": "all", "point": ["2", "0"]}), "L1")
        self.assertEqual(found(many, {"objective": ["0x1p+0", "0x1p+0"]}), "L3")
        self.assertEqual(found(many, {"before": 1, "after": 3}), "L4")
        self.assertEqual(found(many, {"before": -1}), "L4")
        self.assertEqual(found(many, {"before": -1}, square[:3] + [(-1, -1, 9)]), "L4")
        self.assertEqual(found(many, {"before": -1}, square[:3] + [(-1, 0, 9)]), "-")
        self.assertEqual(found(many, {}, square + [(0, -2, 1)]), "L4")
        self.assertEqual(found(many, {"point": ["1", "1"]}, square[:3] + [(0, -1, -1)]), "L4")
        self.assertEqual(found(far, {}, square[1:]), "-")
        self.assertEqual(found(far, {"point": ["-1", "1/9"]}), "L4")
        self.assertEqual(found(far, {"direction": ["0", "0"]}, square[1:]), "L3")
        self.assertEqual(found(far, {"direction": ["3", "1"]}, square[1:]), "L4")
        self.assertEqual(found(far, {"point": ["-2", "1"]}, square[1:]), "L1")
        empty = {"question": "linear_program", "objective": ["0x1p+0", "0x0p+0"], "verdict": "infeasible",
                 "sides": [0, 1]}
        self.assertEqual(found(empty, {}, [(1, 0, 0), (-1, 0, -1)]), "-")
        self.assertEqual(found(empty, {}, [(1, 0, 0), (-1, 0, 0)]), "S2")
        self.assertEqual(found(empty, {}), "S1")
        self.assertEqual(found(empty, {"verdict": "none"}), "F")


class Kernels(unittest.TestCase):
    def test_files_and_the_check_that_each_fails(self):
        def found(ring, change):
            item = {"question": "kernel", "ring": 0, "verdict": "bounded", "sides": [1, 2, 0], "cones": [2, 0, 1]}
            table = [[[hexadecimal(n) for n in p] for p in ring]]
            return outcome(json.dumps({"sunder_set_certificate": 1, "rings": table,
                                       "statements": [{**item, **change}]}).encode())

        triangle = [(0, 0), (4, 0), (0, 4)]
        self.assertEqual(found(triangle, {}), "-")
        self.assertEqual(found(triangle, {"cones": [1, 2, 0]}), "-")
        self.assertEqual(found(triangle, {"cones": [0, 0, 1]}), "S3")
        self.assertEqual(found(triangle[::-1], {}), "S1")  # the edges in another order
        self.assertEqual(found(triangle[::-1], {"sides": [0, 2, 1], "cones": [0, 2, 1]}), "-")
        spiral = [(0, 0), (9, 0), (9, 9), (0, 9), (0, 3), (6, 3), (6, 6), (3, 6), (3, 7), (7, 7), (7, 2), (0, 2)]
        # Left of the edge from (6, 6) to (3, 6) is below it, and of that from (3, 7) to (7, 7) above.
        self.assertEqual(found(spiral, {"verdict": "empty", "sides": [6, 8]}), "-")
        self.assertEqual(found(spiral, {"verdict": "empty", "sides": [0, 2]}), "S2")
        for change in ({"ring": 1}, {"ring": None}, {"sides": [3]}, {"cones": [0]}):
            self.assertEqual(found(triangle, change), "F", change)
        for ring in (triangle[:2], [(0, 0), (1, 1), (2, 2)], [(0, 0), (0, 0), (1, 0), (0, 1)], [(0, 0, 0)] * 3):
            self.assertEqual(found(ring, {}), "F", ring)


class ConvexPolygons(unittest.TestCase):
    def test_files_and_the_check_that_each_fails(self):
        def found(polygons, change):
            item = {"question": "convex_polygons", "verdict": "bounded", "sides": [1, 2, 0], "cones": [2, 0, 1]}
            table = [[[hexadecimal(n) for n in p] for p in polygon] for polygon in polygons]
            return outcome(json.dumps({"sunder_set_certificate": 1, "convex_polygons": table,
                                       "statements": [{**item, **change}]}).encode())

        triangle = [(0, 0), (4, 0), (0, 4)]
        self.assertEqual(found([triangle], {}), "-")
        self.assertEqual(found([triangle], {"cones": [0, 0, 1]}), "S3")
        self.assertEqual(found([triangle], {"verdict": "point"}), "S2")
        # Not counter-clockwise, not strictly convex, twice round; no vertex; no number.
        twice = [(0, 0), (5, 0), (5, 5), (1, 6), (-1, -1), (6, -1), (6, 6), (0, 5)]
        for bad in (triangle[::-1], [(0, 0), (2, 0), (4, 0), (0, 4)], [(0, 0), (0, 0), (4, 0)], twice, [],
                    [(0, 0), (0, 0)], [(0,)]):
            self.assertEqual(found([bad], {}), "F", bad)
        # A point: its half-planes are x <= 1, y <= 1, x >= 1, y >= 1.
        at = {"verdict": "point", "sides": [0, 1, 2, 3], "cones": [0, 1, 2, 3]}
        self.assertEqual(found([[(1, 1)]], at), "-")
        self.assertEqual(found([[(1, 1)], triangle], {**at, "cones": [0, 1, 2, 3, 3, 0, 1]}), "-")
        self.assertEqual(found([[(1, 1)], [(4, 4)]], {**at, "cones": [0, 1, 2, 3, 0, 1, 2, 3]}), "S4")
        self.assertEqual(found([[(1, 1)], [(4, 4)]], {"verdict": "empty", "sides": [0, 6]}), "-")
        self.assertEqual(found([[(1, 1)], [(1, 4)]], {"verdict": "empty", "sides": [0, 6]}), "S2")
        # Segments: both edges, then the caps; a vertical one has them above and below.
        rising, upright = [(0, 0), (4, 2)], [(1, 5), (1, 1)]
        self.assertEqual(found([rising], {"verdict": "segment", "sides": [2, 1, 3, 0], "cones": [3, 1, 0, 2]}), "-")
        self.assertEqual(found([upright], {"verdict": "segment", "sides": [1, 2, 0, 3], "cones": [2, 0, 1, 3]}), "-")
        self.assertEqual(found([upright], {"verdict": "segment", "sides": [1, 2, 0, 3], "cones": [2, 0, 3, 1]}), "S3")
        self.assertEqual(found([rising, upright], {"verdict": "empty", "sides": [1, 7]}), "S1")
        self.assertEqual(found([[(0, 0), (1, 2)], [(2, 0), (2, 5)]], {"verdict": "empty", "sides": [2, 5]}), "-")


if __name__ == "__main__":
    unittest.main()
