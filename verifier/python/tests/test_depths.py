#!/usr/bin/env python3
"""Tests of statements about how deep bodies are in each other: python3 verifier/python/tests/test_depths.py."""
import functools
import itertools
import math
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some

QUESTION, AXES = "depth", (0, 1, 2)
# Of a box, corner k is at the upper end of axis j where bit j is set; two triangles a face, from outside.
BOX = [t for a, b, c, d in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
       for t in ([a, b, c], [a, c, d])]
# Corners 0 to 3 around, 4 above and 5 below.
OCTAHEDRON = [t for k in range(4) for t in ([k, (k + 1) % 4, 4], [(k + 1) % 4, k, 5])]


def box(low, high, radius):
    points = [[hexadecimal((low, high)[k >> j & 1][j]) for j in AXES] for k in range(8)]
    return {"name": "box", "points": points, **({"radius": hexadecimal(radius)} if radius else {})}


def some_boxes(dice):
    """Two boxes, rounded or not, and how far A reaches beyond where B begins, along each axis and back."""
    while True:
        ends, radii = [], [dice.choice((0, 0, 1, 2)) for _ in "ab"]
        for _ in "ab":
            low = [dice.randint(-4, 2) for _ in AXES]
            ends.append((low, [x + dice.randint(1, 6) for x in low]))
        (low_a, high_a), (low_b, high_b) = ends
        beyond = [high_a[j] - low_b[j] for j in AXES] + [high_b[j] - low_a[j] for j in AXES]
        if sum(x < 0 for x in beyond) < 2 and min(beyond) + sum(radii) > 0:
            return ends, radii, beyond


def point_of(low, high, at):
    """Weights of a box's corners that make a point."""
    weights = []
    for k in range(8):
        share = 1
        for j in AXES:
            share *= Fraction(at[j] - low[j] if k >> j & 1 else high[j] - at[j], high[j] - low[j])
        if share or k == 0:
            weights.append([k, fraction(Fraction(share))])
    return {"weights": weights}


def surrounded(ends, beyond):
    """Of cores that overlap a surface; of others the one difference that is nearest to the origin."""
    if min(beyond) > 0:
        return {"differences": [[k, 7 - k] for k in range(8)], "triangles": BOX}
    at = [[], []]
    for j in AXES:
        (low_a, high_a), (low_b, high_b) = ((low[j], high[j]) for low, high in ends)
        if high_a < low_b or high_b < low_a:
            nearest = (high_a, low_b) if high_a < low_b else (low_a, high_b)
        else:
            nearest = 2 * (max(low_a, low_b),)
        at[0].append(nearest[0])
        at[1].append(nearest[1])
    return {"differences": [[point_of(*ends[k], at[k]) for k in (0, 1)]], "triangles": []}


def at_most(most, direction):
    return {"question": QUESTION, "a": 0, "b": 1, "verdict": "at_most", "most": hexadecimal(most),
            "claims": [{"claim": "leaves", "direction": list(map(str, direction))}]}


def at_least(least, brings):
    return {"question": QUESTION, "a": 0, "b": 1, "verdict": "at_least", "least": hexadecimal(least),
            "claims": [{"claim": "surrounds", **brings}]}


def changed(one, **brings):
    return {**one, "claims": [{**one["claims"][0], **brings}]}


def curved(dice):
    """An ellipsoid, cylinder or cone that is no image, and points of it, as of OCTAHEDRON; how wide and high it is."""
    kind, r, h = dice.choice(("ellipsoid", "cylinder", "cone")), dice.randint(2, 6), 2 * dice.randint(1, 5)
    if kind == "ellipsoid":
        body = {"points": [["0x0p+0"] * 3]}
        places = [(r, 0, 0), (0, r, 0), (-r, 0, 0), (0, -r, 0), (0, 0, r), (0, 0, -r)]
        weights = [[[0, "1"]]] * 6
    else:
        wide = Fraction(r, 1 if kind == "cylinder" else 2)
        body = {"points": [["0x0p+0"] * 3, ["0x0p+0", "0x0p+0", hexadecimal(h)]]}
        places = [(wide, 0, h // 2), (0, wide, h // 2), (-wide, 0, h // 2), (0, -wide, h // 2), (0, 0, h), (0, 0, 0)]
        weights = [[[0, "1/2"], [1, "1/2"]]] * 4 + [[[1, "1"]], [[0, "1"]]]
    ends = [{"point": [fraction(Fraction(x)) for x in p], "weights": w} for p, w in zip(places, weights)]
    if kind == "ellipsoid":
        ends = [{**end, "from": end["point"]} for end in ends]
    return {"name": kind, **body, kind: hexadecimal(r)}, places, ends


def height(p, q, r):
    """Of the origin below a plane, squared; negative where it is not below."""
    u, v = ([Fraction(y - x) for x, y in zip(p, other)] for other in (q, r))
    n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    along = sum(x * y for x, y in zip(n, p))
    return along * abs(along) / sum(x * x for x in n)


def polygon(dice):
    """A convex polygon around its middle, counter-clockwise, as an image of a whole polygon by a unit of its own."""
    corners = [(4, 0), (3, 3), (0, 4), (-3, 3), (-4, 0), (-3, -3), (0, -4), (3, -3)]
    chosen = sorted(dice.sample(range(8), dice.randint(3, 8)))
    unit, at = dice.choice((Fraction(1, 4), 1, 8)), [dice.randint(-6, 6) for _ in "xy"]
    points = [[x + dx for x, dx in zip(corners[k], at)] for k in chosen]
    return unit, points


def edges_of_difference(a, b):
    """Pairs of corners of two polygons, counter-clockwise around A - B, by the directions of edges."""
    def edges(points, sign):
        return [((sign * (q[0] - p[0]), sign * (q[1] - p[1])), k)
                for k, (p, q) in enumerate(zip(points, points[1:] + points[:1]))]

    def before(d, e):  # by angle from (1, 0)
        upper = lambda v: (v[1], v[0]) > (0, 0)
        return upper(d) > upper(e) or (upper(d) == upper(e) and d[0] * e[1] > d[1] * e[0])

    every = [(d, True, k) for d, k in edges(a, 1)] + [(d, False, k) for d, k in edges(b, -1)]
    every.sort(key=functools.cmp_to_key(lambda x, y: before(y[0], x[0]) - before(x[0], y[0])))
    low = lambda points, sign: min(range(len(points)), key=lambda k: (sign * points[k][1], sign * points[k][0]))
    i, j, result = low(a, 1), low(b, -1), []
    for _, of_a, k in every:
        result.append([i, j])
        i, j = ((k + 1) % len(a), j) if of_a else (i, (k + 1) % len(b))
    return result


class DepthsTest(unittest.TestCase):
    def look(self, twins, bodies, statement):
        return twins.force(file_of({"bodies": bodies}, statement))

    def test_boxes_with_a_radius(self):
        dice, twins, tried = dice_of(1), Twins(self), 0
        while tried < some(300) or lacking(FORCED, QUESTION):
            tried += 1
            ends, radii, beyond = some_boxes(dice)
            while (min(beyond) > 0) == (tried % 3 == 0):  # in one of three cases the cores do not overlap
                ends, radii, beyond = some_boxes(dice)
            bodies = [box(*e, r) for e, r in zip(ends, radii)]
            depth, first = min(beyond) + sum(radii), beyond.index(min(beyond))
            way = [0, 0, 0]
            way[first % 3] = (1 if first < 3 else -1) * dice.randint(1, 9)
            most, least = at_most(depth, way), at_least(depth, surrounded(ends, beyond))
            self.assertEqual(self.look(twins, bodies, most), "accepted", twins.last)
            self.assertEqual(self.look(twins, bodies, least), "accepted", twins.last)
            # The library's own surface of cores that touch would be one point, too.
            claim = least["claims"][0]
            for bad, rule in (({**most, "most": hexadecimal(depth - 1)}, "leaves"),
                              (changed(most, direction=["0", "0", "0"]), "leaves"),
                              (changed(most, direction=[str(-x) for x in way]),
                               "accepted" if beyond[(first + 3) % 6] == min(beyond) else "leaves"),
                              ({**least, "least": hexadecimal(depth + 1)}, "surrounds"),
                              (changed(least, triangles=claim["triangles"][1:] or [[0, 0, 0]]), "surrounds"),
                              (changed(least, triangles=[t[::-1] for t in claim["triangles"]] or [[0, 0, 0]]),
                               "surrounds"),
                              (changed(least, triangles=2 * claim["triangles"] or [[0, 0, 0]]), "surrounds"),
                              (changed(least, differences=claim["differences"] * 2,
                                       triangles=claim["triangles"][1:]), "surrounds")):
                self.assertEqual(self.look(twins, bodies, bad), rule, twins.last)
            if not claim["triangles"]:
                # The weights sum to 0; one of A's is negative, and they make the point of B.
                none, of_b = {"weights": [[0, "0"]]}, claim["differences"][0][1]
                low, high = ends[1]
                at = [sum(Fraction(w) * (low, high)[k >> j & 1][j] for k, w in of_b["weights"]) for j in AXES]
                for bad in ([none, none], [point_of(*ends[0], at), of_b]):
                    said = self.look(twins, bodies, changed(least, differences=[bad]))
                    self.assertEqual(said, "surrounds" if min(beyond) < 0 or bad[0] == none else "accepted", twins.last)
        twins.compare()

    def test_in_the_plane(self):
        dice, twins, met = dice_of(4), Twins(self), 0
        while met < some(200):
            (unit, a), (other, b) = polygon(dice), polygon(dice)
            b = [[other / Fraction(unit) * x for x in p] for p in b]
            corners = edges_of_difference(a, b)
            at = [[x - y for x, y in zip(a[i], b[j])] for i, j in corners]
            sides = list(zip(at, at[1:] + at[:1]))
            turns = [p[0] * q[1] - p[1] * q[0] for p, q in sides]
            if min(turns) <= 0:
                continue
            met += 1
            squares = [Fraction(t) ** 2 / sum((y - x) ** 2 for x, y in zip(p, q)) for t, (p, q) in zip(turns, sides)]
            k = squares.index(min(squares))
            root = Fraction(math.isqrt(int(min(squares) * 4 ** 20)), 2 ** 20)  # at most 2^-20 below it
            (px, py), (qx, qy) = sides[k]
            bodies = [{"name": name, "points": [[hexadecimal(unit * x) for x in p] for p in points]}
                      for name, points in zip("ab", (a, b))]
            edges = [[k, (k + 1) % len(at)] for k in range(len(at))]
            way = [str(Fraction(qy - py)), str(Fraction(px - qx))]
            step = Fraction(1, 2 ** 20)
            most, least = at_most(unit * (root + step), way), at_least(
                unit * root, {"differences": corners, "triangles": edges})
            for one, rule in ((most, "accepted"), (least, "accepted"),
                              ({**most, "most": hexadecimal(unit * (root - step))}, "leaves"),
                              ({**least, "least": hexadecimal(unit * (root + step))}, "surrounds"),
                              (changed(least, triangles=edges[1:]), "surrounds"),
                              (changed(least, triangles=[e[::-1] for e in edges]), "surrounds"),
                              (changed(least, triangles=2 * edges), "surrounds"),
                              (changed(least, triangles=[e + e[:1] for e in edges]), "F"),
                              (changed(least, triangles=[[k] for k in range(len(corners))]), "F")):
                self.assertEqual(self.look(twins, bodies, one), rule, twins.last)
            solid = box([0, 0, 0], [1, 1, 1], 0)
            self.assertEqual(self.look(twins, [bodies[0], solid], least), "F", twins.last)
        twins.compare()

    def test_curved_ones(self):
        dice, twins = dice_of(2), Twins(self)
        for _ in range(some(600)):
            body, places, ends = curved(dice)
            at, radius, least = [dice.randint(-2, 4) for _ in AXES], dice.choice((0, 1)), dice.randint(1, 4)
            point = {"name": "point", "points": [list(map(hexadecimal, at))], **({"radius": hexadecimal(1)} if radius else {})}
            heights = [height(*([x - y for x, y in zip(places[k], at)] for k in t)) for t in OCTAHEDRON]
            rest = max(least - radius, 0)
            is_true = all(h > 0 and h >= rest ** 2 for h in heights)
            one = at_least(least, {"differences": [[end, 0] for end in ends], "triangles": OCTAHEDRON})
            self.assertEqual(self.look(twins, [body, point], one), "accepted" if is_true else "surrounds", twins.last)
            flipped = at_least(least, {"differences": [[0, end] for end in ends], "triangles": [t[::-1] for t in OCTAHEDRON]})
            self.assertEqual(self.look(twins, [point, body], flipped), "accepted" if is_true else "surrounds", twins.last)
            outside = [dict(end, point=[fraction(2 * Fraction(x)) for x in end["point"]]) for end in ends[:1]] + ends[1:]
            if "from" in ends[0]:
                outside[0]["from"] = outside[0]["point"]
            said = self.look(twins, [body, point], changed(one, differences=[[end, 0] for end in outside]))
            self.assertEqual(said, "holds", twins.last)
        twins.compare()
        if some(100) >= 100:
            self.assertGreater(min(twins.tally().get(word, 0) for word in ("accepted", "surrounds", "holds")), 30)

    def test_roots_at_the_last_bit(self):
        """A ball and a capsule, along a direction of length 5 times 2 to the 52."""
        dice, twins = dice_of(3), Twins(self)
        for kind, places in (("radius", [[0, 0, 0]]), ("cylinder", [[0, 0, -9], [0, 0, 9]])):
            for r, s, gap in itertools.product((0, 3, 5), (0, 2, 7), (-4, 0, 1, 5)):
                bodies = [{"name": "a", "points": [list(map(hexadecimal, p)) for p in places], kind: hexadecimal(r)},
                          {"name": "b", "points": [list(map(hexadecimal, (3 * gap, 4 * gap, 0)))], "radius": hexadecimal(s)}]
                depth, scale = r + s - 5 * gap, 1 << dice.randint(0, 80)
                if depth < 0:
                    continue
                one = at_most(depth, (3 * scale, 4 * scale, 0))
                self.assertEqual(self.look(twins, bodies, one), "accepted", twins.last)
                said = self.look(twins, bodies, {**one, "most": "0x%xp-44" % ((depth << 44) + 1)})
                self.assertEqual(said, "accepted", twins.last)
                if depth:
                    said = self.look(twins, bodies, {**one, "most": "0x%xp-44" % ((depth << 44) - 1)})
                    self.assertEqual(said, "leaves", twins.last)
        twins.compare()

    def test_bodies_that_are_not_bounded_or_of_more_than_three_dimensions(self):
        """Seen without their last coordinates, or without ways, some of these would be proved by false claims."""
        twins, corners = Twins(self), [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
        around = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]
        for d, ways in ((3, []), (3, [[1, 0, 0]]), (4, []), (5, []), (6, []), (2, [[1, 0]])):
            bodies = [{"name": "a", "points": [list(map(hexadecimal, (*c, 0, 0, 0)[:d])) for c in corners]},
                      {"name": "b", "points": [[hexadecimal(0)] * d]}]
            said = set()
            for k in (0, 1):
                some_ways = [list(map(hexadecimal, way)) for way in ways]
                those = [{**body, "ways": some_ways} if j == k and ways else body for j, body in enumerate(bodies)]
                for triangles in (around, [t[::-1] for t in around]):
                    one = at_least(2 ** 1000, {"differences": [[j, 0] for j in range(4)], "triangles": triangles})
                    said.add(self.look(twins, those, one))
                said.add(self.look(twins, those, at_most(9, [0, 1, 0, 0, 0, 0][:d])))
            self.assertEqual(said, {"surrounds", "accepted"} if d == 3 and not ways else {"F"}, twins.last)
        twins.compare()

    def test_the_twins_count_alike(self):
        """Weights of long numbers, in more and more statements: from the same one on it takes too many steps."""
        twins, said = Twins(self), []
        bodies = [{"name": name, "points": [list(map(hexadecimal, p)) for p in points], "radius": hexadecimal(3)}
                  for name, points in (("ball", [(8, 0, 0)]), ("capsule", [(4, -4, 0), (4, 8, 0)]))]
        third, rest = ("%d/%d" % (k * 10 ** 3000, 3 * 10 ** 3000) for k in (1, 2))
        one = at_least(2, {"differences": [[{"weights": [[0, "1"]]}, {"weights": [[0, rest], [1, third]]}]], "triangles": []})
        for count in range(1, 12):
            said.append(twins.look(file_of({"bodies": bodies}, *count * [one])))
        self.assertEqual({*said}, {"accepted", "not checked"})
        twins.compare()

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(4), Twins(self)
        while lacking(MUTANT, QUESTION):
            ends, radii, beyond = some_boxes(dice)
            bodies = [box(*e, r) for e, r in zip(ends, radii)]
            depth = min(beyond) + sum(radii)
            for one in (at_most(depth, (1, 0, 0)), at_least(depth, surrounded(ends, beyond))):
                twins.spoil(file_of({"bodies": bodies}, one), dice)
            body, _, curved_ends = curved(dice)
            other = {"name": "point", "points": [["0x0p+0"] * 3]}
            twins.spoil(file_of({"bodies": [body, other]}, at_least(
                1, {"differences": [[end, 0] for end in curved_ends], "triangles": OCTAHEDRON})), dice)
        twins.compare()


if __name__ == "__main__":
    main()
