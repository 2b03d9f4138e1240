#!/usr/bin/env python3
"""Tests of statements about common parts and kernels against brute force: python3 verifier/python/tests/test_regions.py."""
import itertools
import math
import unittest
from fractions import Fraction

from files import (FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking,
                   main, outcome, some, spoilt_in_statements)
from sunder_verify import arcs, reader, tables
from test_pairs import solution_or_proof

KINDS = ("point", "segment", "ray", "line", "strip", "half-plane", "unbounded", "bounded")


def turn(u, v):
    return u[0] * v[1] - u[1] * v[0]


# ---- What is true.

def corners_of(given):
    found = set()
    for h, k in itertools.combinations(given, 2):
        w = turn(h, k)
        if w:
            p = Fraction(h[2] * k[1] - k[2] * h[1], w), Fraction(h[0] * k[2] - k[0] * h[2], w)
            if all(a * p[0] + b * p[1] <= c for a, b, c in given):
                found.add(p)
    return found


def kind_of_region(given):
    """By corners, ends at infinity, and points on lines."""
    corners = corners_of(given)
    ways = {(s * x, s * y) for a, b, _ in given for x, y in ((-b, a), (a, b)) for s in (1, -1)}
    rays = [d for d in ways if all(a * d[0] + b * d[1] <= 0 for a, b, _ in given)]
    if corners:
        p = next(iter(corners))
        ways = [(q[0] - p[0], q[1] - p[1]) for q in corners] + rays
        rank = max([1] * any(w != (0, 0) for w in ways) + [2 for u, v in itertools.combinations(ways, 2) if turn(u, v)], default=0)
        if rank == 2:
            return "unbounded" if rays else "bounded"
        return ("ray" if rays else "segment") if rank else "point"
    a, b, _ = given[0]  # all lines are parallel, or it is empty
    if any(turn((a, b), h) for h in given):
        return "empty"
    high = [Fraction(h[2], a * h[0] + b * h[1]) for h in given if a * h[0] + b * h[1] > 0]
    low = [Fraction(h[2], a * h[0] + b * h[1]) for h in given if a * h[0] + b * h[1] < 0]
    if not high or not low:
        return "half-plane"
    return ("empty", "line", "strip")[(min(high) >= max(low)) + (min(high) > max(low))]


def half_planes_around(vertices):
    """Of a convex hull: what is beside each two of them, and beside all."""
    result = [(s * (axis == 0), s * (axis == 1), max(s * v[axis] for v in vertices)) for axis in (0, 1) for s in (1, -1)]
    for p, q in itertools.permutations(vertices, 2):
        if p != q and all(turn((q[0] - p[0], q[1] - p[1]), (v[0] - p[0], v[1] - p[1])) >= 0 for v in vertices):
            result.append((q[1] - p[1], p[0] - q[0], p[0] * q[1] - q[0] * p[1]))
    return result


# ---- Evidence, by trying all.

def bearing(h):
    return math.atan2(h[1], h[0]) % (2 * math.pi)


def statements_of(given, kind, top_of):
    """Of half-planes, as the checker numbers them: one that is accepted, or None."""
    if kind == "empty":
        weights, _ = solution_or_proof(given, (0, 0, -1))
        named = weights and [[k, fraction(w)] for k, w in enumerate(weights) if w]
        return named and {"verdict": "empty", "claims": [{"claim": "contradict", "weights": named}]}
    for size in range(len(given) + 1):
        for names in itertools.combinations(range(len(given)), size):
            turned = sorted(names, key=lambda k: bearing(given[k]))
            for begin in range(max(size, 1)):
                sides = turned[begin:] + turned[:begin]
                statement = {"verdict": kind, "sides": sides, "claims": [{"claim": "cones", "cones": [0] * len(given)}]}
                if size == 0 and given or outcome(top_of(statement)) in ("sides", "F"):
                    continue
                cones = statement["claims"][0]["cones"]
                for k, h in enumerate(given):
                    is_open = kind in ("ray", "unbounded")
                    cones[k] = next((p for p in range(size - is_open) if is_held(given, sides, p, h, kind)), None)
                if None not in cones:
                    return statement
    return None


def is_held(given, sides, p, h, kind):
    """Does what side p and the next one have in common lie in h, the normal of which is between theirs?"""
    g, k = given[sides[p]], given[sides[(p + 1) % len(sides)]]
    if kind in ("line", "strip", "half-plane"):
        return turn(g, h) == 0 and g[0] * h[0] + g[1] * h[1] > 0 and g[2] * (h[0] ** 2 + h[1] ** 2) <= h[2] * (g[0] * h[0] + g[1] * h[1])
    corner = Fraction(g[2] * k[1] - k[2] * g[1], turn(g, k)), Fraction(g[0] * k[2] - k[0] * g[2], turn(g, k))
    return turn(g, h) >= 0 and turn(h, k) >= 0 and h[0] * corner[0] + h[1] * corner[1] <= h[2]


def some_half_planes(dice):
    """Small numbers: parallel, repeated and concurrent ones are common."""
    size, most, offset = dice.randint(1, 5), dice.choice((1, 2, 3)), dice.choice((0, 1, 3, 8))
    given = []
    while len(given) < size:
        if given and dice.randrange(5) == 0:
            a, b, c = dice.choice(given)
            given.append(dice.choice(((-a, -b, -c), (a, b, c), (-2 * a, -2 * b, -2 * c + 1))))
            continue
        a, b = dice.randint(-most, most), dice.randint(-most, most)
        if a or b:
            given.append((a, b, dice.randint(-offset // 2, offset)))
    return given


def about_half_planes(given):
    rows = [[hexadecimal(x) for x in h] for h in given]
    return lambda statement: file_of({"half_planes": rows}, {"question": "half_planes", **statement})


def vertex_rows(polygons):
    return [[[hexadecimal(x) for x in v] for v in polygon] for polygon in polygons]


def sides_of(vertices):
    return [(q[1] - p[1], p[0] - q[0], p[0] * q[1] - q[0] * p[1]) for p, q in zip(vertices, vertices[1:] + vertices[:1])]


def some_convex(dice):
    """In counter-clockwise order; or a segment, or a point."""
    place, points = (dice.randint(0, 3), dice.randint(0, 3)), set()
    for _ in range(dice.choice((1, 2, 3, 4, 5))):
        points.add((place[0] + dice.randint(0, 3), place[1] + dice.randint(0, 3)))
    points, chains = sorted(points), []
    for row in (points, points[::-1]):
        chain = []
        for p in row:
            while len(chain) > 1 and turn((chain[-1][0] - chain[-2][0], chain[-1][1] - chain[-2][1]),
                                          (p[0] - chain[-1][0], p[1] - chain[-1][1])) <= 0:
                chain.pop()
            chain.append(p)
        chains.append(chain)
    return points if len(points) < 3 else chains[0][:-1] + chains[1][:-1]


def numbered(polygon):
    """The half-planes of a convex polygon as the page numbers them."""
    if len(polygon) > 2:
        return sides_of(polygon)
    beside = [(1, 0, max(v[0] for v in polygon)), (0, 1, max(v[1] for v in polygon)),
              (-1, 0, -min(v[0] for v in polygon)), (0, -1, -min(v[1] for v in polygon))]
    if len(polygon) == 1:
        return beside
    return sides_of(polygon) + (beside[0::2] if polygon[0][0] != polygon[1][0] else beside[1::2])


def forced_statement(given, true_one, verdict, dice):
    """What another verdict would need, of the true one's, of random ones, and of those that fit best."""
    if verdict == "empty":
        (claim,), few = true_one["claims"], min(3, len(given))
        weights = [[k, dice.choice(["1", "2", "1/2"])] for k in dice.sample(range(len(given)), few)]
        return {"verdict": verdict, "claims": [{"claim": "contradict", "weights": claim.get("weights", weights)}]}
    sides = list(true_one.get("sides", []))
    if dice.random() < .5 or not sides:
        sides = dice.sample(range(len(given)), dice.randint(min(2, len(given)), len(given)))
        sides.sort(key=lambda k: bearing(given[k]))
    elif dice.random() < .5:
        sides.insert(dice.randint(0, len(sides)), dice.randrange(len(given)))
    elif len(sides) > 1 and dice.random() < .5:
        sides.pop(dice.randrange(len(sides)))
    count = len(sides) - (verdict in ("ray", "unbounded"))
    cones = [dice.randrange(count) if count > 0 else 0 for _ in given]
    kind = verdict
    if verdict == "half-plane" or len(sides) < 2:
        kind = "half-plane"
    for k, h in enumerate(given):
        held = (p for p in range(count) if kind in ("line", "strip", "half-plane") or
                turn(given[sides[p]], given[sides[(p + 1) % len(sides)]]))
        cones[k] = next((p for p in held if is_held(given, sides, p, h, kind)), cones[k])
    return {"verdict": verdict, "sides": sides, "claims": [{"claim": "cones", "cones": cones}]}


def forced_about_discs(discs, true_one, verdict, dice):
    claims = {claim["claim"]: claim for claim in true_one["claims"]}
    weights = [[k, dice.choice(["1", "1/2", "1/3"])] for k in dice.sample(range(len(discs)), min(len(discs), dice.randint(1, 3)))]
    powers = claims.get("powers", {"claim": "powers", "weights": weights})
    x, y, r = dice.choice(discs)
    point = dice.choice([true_one.get("point", ["0", "0"]), [str(x), str(y)], [str(x + r), str(y)], [str(x), str(y - r)]])
    if verdict == "empty":
        return {"verdict": verdict, "claims": [powers]}
    if verdict == "point":
        return {"verdict": verdict, "point": point, "claims": [{"claim": "in_discs"}, powers]}
    named = true_one.get("arcs", []) if dice.random() < .5 else []
    named = named or [dice.randrange(len(discs)) for _ in range(dice.randint(1, min(4, 2 * len(discs))))]
    return {"verdict": verdict, "point": point, "arcs": named, "claims": [{"claim": "in_discs"}, {"claim": "arcs", "parts": []}]}


class RegionsTest(unittest.TestCase):
    def check(self, given, kind, top_of, twins, dice):
        """Proved is what is true, and nothing else: of forced evidence what is accepted is true."""
        statement = statements_of(given, kind, top_of)
        self.assertIsNotNone(statement, (given, kind))
        top = top_of(statement)
        question = top["statements"][0]["question"]
        self.assertEqual(twins.look(top), "accepted", top)
        forced = [spoilt_in_statements(top, dice) for _ in range(2)]
        forced += [top_of(forced_statement(given, statement, verdict, dice)) for verdict in lacking(FORCED, question) for _ in range(3)]
        for false in forced:
            if twins.force(false) == "accepted":
                self.assertEqual({s["verdict"] for s in false["statements"]}, {kind}, false)
        for verdict in lacking(MUTANT, question):
            twins.spoil(top if verdict == kind else top_of(forced_statement(given, statement, verdict, dice)), dice)

    def test_common_parts_of_half_planes(self):
        dice, twins, kinds = dice_of(41), Twins(self), []
        while len(kinds) < some(300) or lacking(FORCED, "half_planes") or lacking(MUTANT, "half_planes"):
            given = some_half_planes(dice)
            kinds.append(kind_of_region(given))
            self.check(given, kinds[-1], about_half_planes(given), twins, dice)
        twins.compare()
        if some(100) < 100:
            return  # too few for the rates below
        for kind in (*KINDS, "empty"):
            self.assertGreater(kinds.count(kind), 0, kind)
        for refusal in ("F", "sides", "cones", "contradict"):
            self.assertGreater(twins.tally().get(refusal, 0), 0, refusal)

    def test_no_evidence_at_all_proves_another_kind(self):
        """All lists of sides, with the cones that fit."""
        dice, found = dice_of(42), set()
        for _ in range(some(60)):
            given = some_half_planes(dice)[:4]
            truth, top_of = kind_of_region(given), about_half_planes(given)
            for kind in KINDS:
                for size in range(len(given) + 1):
                    for sides in itertools.permutations(range(len(given)), size):
                        top = top_of({"verdict": kind, "sides": list(sides), "claims": [{"claim": "cones", "cones": [0] * len(given)}]})
                        said = outcome(top)
                        if said not in ("accepted", "cones"):
                            continue
                        count = size - (kind in ("ray", "unbounded"))
                        cones = [next((p for p in range(count) if is_held(given, sides, p, h, kind)), 0) for h in given]
                        top["statements"][0]["claims"][0]["cones"] = cones
                        if outcome(top) == "accepted":
                            found.add(kind)
                            self.assertEqual(kind, truth, top)
        self.assertTrue(some(100) < 100 or len(found) > 3, found)

    def test_sides_are_those_of_the_boundary(self):
        """Of what is bounded or not, each with a part in it, in their order."""
        square = [(1, 0, 1), (0, 1, 1), (-1, 0, 1), (0, -1, 1), (1, 1, 2), (1, 0, 5)]
        top_of, twins = about_half_planes(square), Twins(self)
        for sides, cones, wanted in (([0, 1, 2, 3], [0, 1, 2, 3, 0, 0], "accepted"),
                                     ([1, 2, 3, 0], [3, 0, 1, 2, 3, 3], "accepted"),
                                     ([0, 4, 1, 2, 3], [0, 2, 3, 4, 1, 0], "sides"),
                                     ([0, 2, 1, 3], [0] * 6, "sides"),
                                     ([0, 1, 2, 3] * 2, [0] * 6, "sides"),
                                     ([0, 1, 2], [0] * 6, "sides"),
                                     ([0, 1, 2, 3], [0, 1, 2, 3, 1, 0], "cones")):
            statement = {"verdict": "bounded", "sides": sides, "claims": [{"claim": "cones", "cones": cones}]}
            self.assertEqual(twins.look(top_of(statement)), wanted, statement)
        twins.compare()

    def test_kernels(self):
        dice, twins, kinds = dice_of(43), Twins(self), set()
        while twins.count < some(1000) or lacking(FORCED, "kernel") or lacking(MUTANT, "kernel"):
            ring = [(dice.randint(0, 4), dice.randint(0, 4)) for _ in range(dice.randint(3, 5))]
            area = sum(turn(p, q) for p, q in zip(ring, ring[1:] + ring[:1]))
            if not area or any(p == q for p, q in zip(ring, ring[1:] + ring[:1])):
                top = file_of({"rings": vertex_rows([ring])}, {"question": "kernel", "ring": 0, "verdict": "empty", "claims": []})
                self.assertEqual(twins.look(top), "F")
                continue
            given = [h if area > 0 else tuple(-x for x in h) for h in sides_of(ring)]
            kinds.add(kind_of_region(given))
            rings = vertex_rows([[(0, 0), (0, 7), (9, 9)], ring])
            self.check(given, kind_of_region(given), lambda statement: file_of(
                {"rings": rings}, {"question": "kernel", "ring": 1, **statement}), twins, dice)
        twins.compare()
        self.assertTrue(some(100) < 100 or kinds >= {"empty", "bounded", "point"}, kinds)

    def test_common_parts_of_convex_polygons(self):
        dice, twins, kinds, question = dice_of(44), Twins(self), [], "convex_polygons_common_part"
        while twins.count < some(1000) or lacking(FORCED, question) or lacking(MUTANT, question):
            polygons = [some_convex(dice) for _ in range(dice.randint(1, 2))]
            given = [h for polygon in polygons for h in numbered(polygon)]
            if len(given) > 8:
                continue
            kinds.append(kind_of_region([h for polygon in polygons for h in half_planes_around(polygon)]))
            self.assertEqual(kinds[-1], kind_of_region(given))
            rows = vertex_rows(polygons)
            self.check(given, kinds[-1], lambda statement: file_of(
                {"convex_polygons": rows}, {"question": question, **statement}), twins, dice)
            for polygon in polygons:
                if len(polygon) > 2:
                    top = file_of({"convex_polygons": vertex_rows([polygon[::-1]])},
                                  {"question": question, "verdict": "empty", "claims": []})
                    self.assertEqual(twins.look(top), "F")
        twins.compare()
        self.assertTrue(some(100) < 100 or set(kinds) >= {"empty", "bounded", "point", "segment"}, set(kinds))


# ---- Discs.

def mean_of(discs):
    """Weights of the point of least power among those where up to three discs have one power, or None."""
    power = [x * x + y * y - r * r for x, y, r in discs]
    if len(discs) == 1:
        return [Fraction(1)]
    (ax, ay, _), (bx, by, _) = discs[:2]
    dx, dy = bx - ax, by - ay
    if len(discs) == 2:
        w = (dx or dy) and Fraction(power[1] - power[0] - 2 * (ax * dx + ay * dy), 2 * (dx * dx + dy * dy))
        return [1 - w, w] if dx or dy else None
    ex, ey = discs[2][0] - ax, discs[2][1] - ay
    area = dx * ey - dy * ex
    if not area:
        return None
    s, t = Fraction(power[1] - power[0], 2), Fraction(power[2] - power[0], 2)
    px, py = (s * ey - t * dy) / area - ax, (t * dx - s * ex) / area - ay
    v, w = (px * ey - py * ex) / area, (dx * py - dy * px) / area
    return [1 - v - w, v, w]


def deepest(discs):
    """The verdict about the common part, the deepest point, and weights of discs of which it is the deepest one."""
    best = None
    for m in (1, 2, 3):
        for names in itertools.combinations(range(len(discs)), m):
            weights = mean_of([discs[k] for k in names])
            if weights is None or any(w < 0 for w in weights):
                continue
            x, y = (sum(w * discs[k][axis] for w, k in zip(weights, names)) for axis in (0, 1))
            least = sum(w * ((x - a) ** 2 + (y - b) ** 2 - r * r) for w, (a, b, r) in zip(weights, (discs[k] for k in names)))
            if best is None or least > best[0]:
                best = least, (x, y), [[k, fraction(w)] for k, w in zip(names, weights) if w]
    return "empty" if best[0] > 0 else "region" if best[0] < 0 else "point", best[1], best[2]


def some_discs(dice):
    side, (least, most) = dice.choice((2, 4, 6)), dice.choice(((0, 2), (1, 3), (1, 5), (3, 8), (3, 8)))
    return [(dice.randint(0, side), dice.randint(0, side), dice.randint(least, most))
            for _ in range(dice.randint(1, 4))]


def about_discs(discs, statement):
    return file_of({"circles": [[hexadecimal(x) for x in disc] for disc in discs]}, {"question": "circles_common_part", **statement})


def statement_of(discs):
    verdict, point, weights = deepest(discs)
    if verdict == "empty":
        return {"verdict": verdict, "claims": [{"claim": "powers", "weights": weights}]}
    statement = {"verdict": verdict, "point": [fraction(x) for x in point], "claims": [{"claim": "in_discs"}]}
    if verdict == "point":
        statement["claims"].append({"claim": "powers", "weights": weights})
        return statement
    statement["claims"].append({"claim": "arcs", "parts": []})
    for size in (1, 2, 3, 4, 5):
        for arcs in itertools.product(range(len(discs)), repeat=size):
            if size <= 2 * len(discs) and outcome(about_discs(discs, {**statement, "arcs": list(arcs)})) == "accepted":
                return {**statement, "arcs": list(arcs)}
    return None


def bound_of(discs, names):
    """The discs whose arcs bound the common part, seen from (0, 0), which is inside; by rounded numbers."""
    def far(k, angle):
        x, y, r = discs[k]
        along = x * math.cos(angle) + y * math.sin(angle)
        return along + math.sqrt(along ** 2 + r * r - x * x - y * y)
    crossings = {0.0}
    for a, b in itertools.combinations(names, 2):
        (ax, ay, r), (bx, by, s) = discs[a], discs[b]
        ux, uy = bx - ax, by - ay
        d = ux * ux + uy * uy
        along = d + r * r - s * s
        root = 4 * r * r * d - along * along
        if root > 0:
            for sign in (1, -1):
                x, y = (ax + (along * ux - sign * math.sqrt(root) * uy) / (2 * d),
                        ay + (along * uy + sign * math.sqrt(root) * ux) / (2 * d))
                crossings.add(math.atan2(y, x) % (2 * math.pi))
    angles = sorted(crossings)
    middles = [(a + b) / 2 for a, b in zip(angles, angles[1:] + [2 * math.pi])]
    nearest = [min(names, key=lambda k: far(k, angle)) for angle in middles]
    chain = [k for k, before in zip(nearest, nearest[-1:] + nearest) if k != before]
    return chain or nearest[:1]


def parts_of(discs, names, parts):
    """Appends what bounds the ranges of more than eight discs and their halves, and what bounds these."""
    half = len(names) // 2
    if len(names) > 8:
        parts_of(discs, names[:half], parts)
        parts_of(discs, names[half:], parts)
    parts.append(bound_of(discs, names))
    return parts[-1]


def forced_arcs(statement, size, dice):
    """With one change in the arcs, or in the parts."""
    inside, arcs = statement["claims"]
    parts, named = [list(part) for part in arcs["parts"]], list(statement["arcs"])
    chain, change = dice.choice([named, *parts]), dice.randrange(6)
    if change == 0:
        chain[dice.randrange(len(chain))] = dice.randrange(size)
    elif change == 1 and len(chain) > 1:
        chain.pop(dice.randrange(len(chain)))
    elif change == 2 and len(chain) < 2 * size:
        chain.insert(dice.randint(0, len(chain)), dice.randrange(size))
    elif change == 3:
        chain.append(chain.pop(0))
    elif change == 4:
        chain[:] = named  # the whole is within each part
    elif parts:
        parts.pop(dice.randrange(len(parts)))
    return {**statement, "arcs": named, "claims": [inside, {**arcs, "parts": parts}]}


class DiscsTest(unittest.TestCase):
    def test_each_common_part_is_proved_and_no_other(self):
        dice, twins, question = dice_of(45), Twins(self), "circles_common_part"
        while twins.count < some(1500) or lacking(FORCED, question) or lacking(MUTANT, question):
            discs = some_discs(dice)
            statement = statement_of(discs)
            self.assertIsNotNone(statement, discs)
            top = about_discs(discs, statement)
            self.assertEqual(twins.look(top), "accepted", top)
            forced = [spoilt_in_statements(top, dice) for _ in range(2)]
            forced += [about_discs(discs, forced_about_discs(discs, statement, verdict, dice))
                       for verdict in lacking(FORCED, question) for _ in range(4)]
            for false in forced:
                if twins.force(false) == "accepted":
                    self.assertEqual({s["verdict"] for s in false["statements"]}, {statement["verdict"]}, false)
            for verdict in lacking(MUTANT, question):
                twins.spoil(top if verdict == statement["verdict"] else
                            about_discs(discs, forced_about_discs(discs, statement, verdict, dice)), dice)
        none = {"verdict": "empty", "claims": [{"claim": "powers", "weights": [[0, "1"]]}]}
        self.assertEqual(twins.look(about_discs([], none)), "F")
        twins.compare()
        if some(100) < 100:
            return
        for refusal in ("F", "in_discs", "powers", "arcs", "weights"):
            self.assertGreater(twins.tally().get(refusal, 0), 0, refusal)

    def test_parts_of_many_discs(self):
        """Chains of halves prove the whole; whatever they are, the arcs that are accepted are those that bound it."""
        dice, twins, tally = dice_of(47), Twins(self), {}
        while twins.count < some(800):
            discs = []
            for _ in range(dice.choice((9, 10, 17, 20, 40))):
                x, y = dice.gauss(0, 1), dice.gauss(0, 1)
                size = math.hypot(x, y) + dice.choice((1.0, 1.0, 1 + dice.random()))
                discs.append((x, y, size * (1 + 2 ** -20 * dice.random())))
            claims = [{"claim": "in_discs"}, {"claim": "arcs", "parts": []}]
            chain = parts_of(discs, list(range(len(discs))), claims[1]["parts"])
            truth, statement = claims[1]["parts"].pop(), {"verdict": "region", "point": ["0", "0"], "arcs": chain, "claims": claims}
            self.assertEqual(truth, chain)
            rows = [[x.hex() for x in disc] for disc in discs]
            top = file_of({"circles": rows}, {"question": "circles_common_part", **statement})
            self.assertEqual(twins.look(top), "accepted", top)
            for _ in range(20):
                forced = forced_arcs(statement, len(discs), dice)
                said = twins.force(file_of({"circles": rows}, {"question": "circles_common_part", **forced}))
                tally[said] = tally.get(said, 0) + 1
                if said == "accepted":
                    named = forced["arcs"]
                    self.assertIn(chain, [named[k:] + named[:k] for k in range(len(named))])
        twins.compare()
        self.assertTrue(some(100) < 100 or min(tally["accepted"], tally["arcs"]) > 20, tally)

    def test_a_chain_goes_round_once(self):
        """Twice round, and where circles do not cross."""
        table = tables.TABLES["circles"]([[hexadecimal(x) for x in disc] for disc in ((0, 0, 2), (2, 2, 2), (0, 0, 9))], "circles")
        self.assertEqual(len(arcs.Chain(reader.Steps(), table, [0, 1], (1, 1, 1)).ends), 2)
        for named in ([0, 1, 0, 1], [0, 2], [0, 0]):
            with self.assertRaises(reader.Refused):
                arcs.Chain(reader.Steps(), table, named, (1, 1, 1))

    def test_one_list_of_arcs_is_accepted(self):
        """Of all lists of up to four, but for equal discs and where it begins: that of the discs which are nearest, seen
        from the point in each direction."""
        dice, twins, sizes = dice_of(46), Twins(self), {}
        for _ in range(some(150)):
            discs = some_discs(dice)[:3]
            verdict, point, _ = deepest(discs)
            if verdict != "region":
                continue
            found = set()
            for size in (1, 2, 3, 4):
                for arcs in itertools.product(range(len(discs)), repeat=size):
                    said = twins.look(about_discs(discs, {"verdict": verdict, "point": [fraction(x) for x in point],
                                                          "arcs": list(arcs), "claims": [{"claim": "in_discs"}, {"claim": "arcs", "parts": []}]}))
                    if said == "accepted":
                        found.add(min(tuple(discs[a] for a in arcs[k:] + arcs[:k]) for k in range(size)))
            self.assertEqual(len(found), 1, (discs, found))
            bounds, (x, y) = found.pop(), map(float, point)
            sizes[len(bounds)] = sizes.get(len(bounds), 0) + 1

            def far(disc):
                along = (disc[0] - x) * dx + (disc[1] - y) * dy
                return along + math.sqrt(along ** 2 + disc[2] ** 2 - (disc[0] - x) ** 2 - (disc[1] - y) ** 2)
            for k in range(100):
                dx, dy = math.cos(k), math.sin(k)
                self.assertLess(min(map(far, bounds)), min(map(far, discs)) + 1e-9, (discs, bounds))
        twins.compare()
        self.assertTrue(some(100) < 100 or min(sizes.get(n, 0) for n in (1, 2, 3)) > 0, sizes)


if __name__ == "__main__":
    main()
