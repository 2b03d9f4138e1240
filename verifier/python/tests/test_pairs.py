#!/usr/bin/env python3
"""Tests of statements about pairs against an exact simplex method: python3 verifier/python/tests/test_pairs.py."""
import itertools
import json
import math
import unittest
from fractions import Fraction

from files import (FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some,
                   spoilt_in_statements)


def solution_or_proof(columns, wanted):
    """x >= 0 with the sum of x[k] columns[k] wanted, and None; or None, and y whose product with wanted is positive and
    with no column. By phase one of the simplex method, with Bland's rule, in whole numbers: all entries of the table are
    over one denominator, the last pivot, which divides them exactly (J. Edmonds)."""
    rows, size = len(wanted), len(columns)
    scale = math.lcm(*(x.denominator for column in (*columns, wanted) for x in column))
    signs = [scale if w >= 0 else -scale for w in wanted]
    table = [[int(signs[r] * c[r]) for c in columns] + [int(r == k) for k in range(rows)] + [int(signs[r] * wanted[r])]
             for r in range(rows)]
    basis, over = [size + r for r in range(rows)], 1
    cost = [-sum(row[k] for row in table) for k in range(size)] + [0] * rows + [-sum(row[-1] for row in table)]
    while True:
        enter = next((k for k in range(size + rows) if cost[k] < 0), None)
        if enter is None:
            break
        _, _, r = min((Fraction(row[-1], row[enter]), basis[r], r) for r, row in enumerate(table) if row[enter] > 0)
        by, pivot = table[r], table[r][enter]
        for row in (*table, cost):
            if row is not by:
                factor = row[enter]
                row[:] = [(pivot * x - factor * y) // over for x, y in zip(row, by)]
        basis[r], over = enter, pivot
    if cost[-1] == 0:
        x = [Fraction(0)] * (size + rows)
        for r, k in enumerate(basis):
            x[k] = Fraction(table[r][-1], over)
        return x[:size], None
    return None, [(1 - Fraction(cost[size + r], over)) * (1 if signs[r] > 0 else -1) for r in range(rows)]


def value_of(text):
    return Fraction(float.fromhex(text))


def hexadecimal_of(x):
    """As a double, if it is one."""
    return float(x).hex() if Fraction(float(x)) == x else None


class Body:
    def __init__(self, dice, dimension):
        def row(most):
            return [dice.randint(-most, most) for _ in range(dimension)]
        size = dice.choice([1, 3])  # of small ones more touch
        self.points = [row(size) for _ in range(dice.randint(1, 4))]
        self.ways = [row(2) for _ in range(dice.choice([0, 0, 1, 2]))]
        self.shift = None

    def entry(self, name):
        entry = {"name": name, "points": [[hexadecimal(x) for x in row] for row in self.points]}
        if self.ways:
            entry["ways"] = [[hexadecimal(x) for x in row] for row in self.ways]
        return entry


class Image:
    def __init__(self, dice, body, of):
        d = len(body.points[0])
        self.of, self.linear = of, [[dice.randint(-2, 2) for _ in range(d)] for _ in range(d)]
        self.translation = [dice.randint(-6, 6) for _ in range(d)]

        def turned(v):
            return [sum(a * b for a, b in zip(row, v)) for row in self.linear]
        self.points = [[x + t for x, t in zip(turned(p), self.translation)] for p in body.points]
        self.ways = [turned(w) for w in body.ways]

    def entry(self, name):
        return {"name": name, "of": self.of, "linear": [hexadecimal(x) for row in self.linear for x in row],
                "translation": [hexadecimal(x) for x in self.translation]}


def honest(bodies, i, j):
    """The statement about two bodies, proved."""
    a, b = bodies[i], bodies[j]
    columns = [p + [1, 0] for p in a.points] + [w + [0, 0] for w in a.ways]
    columns += [[-x for x in p] + [0, 1] for p in b.points] + [[-x for x in w] + [0, 0] for w in b.ways]
    dimension = len(a.points[0])
    weights, proof = solution_or_proof(columns, [0] * dimension + [1, 1])
    statement = {"question": "pair", "a": i, "b": j}
    if weights is None:
        direction = [fraction(x) for x in proof[:dimension]]
        return {**statement, "verdict": "apart", "claims": [{"claim": "parted", "direction": direction}]}
    count = len(a.points) + len(a.ways)
    point = [sum(w * p[k] for w, p in zip(weights, a.points + a.ways)) for k in range(dimension)]
    claims = [{"claim": "holds", "weights": [[k, fraction(w)] for k, w in enumerate(part) if w]}
              for part in (weights[:count], weights[count:])]
    return {**statement, "verdict": "meet", "point": [fraction(x) for x in point], "claims": claims}


def contact(bodies, i, j, meet):
    """Of two that meet: do their relative interiors? By combinations of all rows with weights of 1 at least."""
    a, b = bodies[i], bodies[j]
    columns = [p + [1] for p in a.points] + [w + [0] for w in a.ways]
    columns += [[-x for x in p] + [-1] for p in b.points] + [[-x for x in w] + [0] for w in b.ways]
    weights, proof = solution_or_proof(columns, [-sum(row) for row in zip(*columns)])
    if weights is None:
        direction = [fraction(x) for x in proof[:-1]]
        return {**meet, "verdict": "touching", "claims": meet["claims"] + [{"claim": "parted_weakly", "direction": direction}]}
    count = len(a.points) + len(a.ways)
    total = sum(w + 1 for w in weights[:len(a.points)])
    weights = [(w + 1) / total for w in weights]
    point = [sum(w * p[k] for w, p in zip(weights, a.points + a.ways)) for k in range(len(a.points[0]))]
    claims = [{"claim": "inside", "weights": [[k, fraction(w)] for k, w in enumerate(part)]}
              for part in (weights[:count], weights[count:])]
    return {**meet, "verdict": "overlapping", "point": [fraction(x) for x in point], "claims": claims}


def some_file(dice, with_contact=False):
    dimension = dice.choice([2, 3])
    bodies = [Body(dice, dimension) for _ in range(2)]
    bodies.append(Image(dice, bodies[1], 1))
    i, j = dice.choice([(0, 1), (0, 2), (2, 0), (1, 2)])
    statement = honest(bodies, i, j)
    if with_contact and statement["verdict"] == "meet":
        statement = contact(bodies, i, j, statement)
    return file_of({"bodies": [body.entry("body %d" % k) for k, body in enumerate(bodies)]}, statement)


VERDICTS = ("apart", "meet", "touching", "overlapping")


def could_be(verdict, truth):
    return verdict == truth or (verdict == "meet" and truth != "apart")


def place(points, weights):
    return [sum(w * points[k][axis] for k, w in weights) for axis in range(len(points[0]))]


def square_between(p, q):
    return sum((x - y) ** 2 for x, y in zip(p, q))


def product(p, q):
    return sum(x * y for x, y in zip(p, q))


def along(edges, way):
    """How often each edge goes into the part of the way that they span; None where they span less than they are."""
    gram = [[product(e, f) for f in edges] for e in edges]
    wanted = [product(e, way) for e in edges]
    if len(edges) < 2:
        return None if gram == [[0]] else [Fraction(w, gram[0][0]) for w in wanted]
    (a, b), (_, c) = gram
    whole = a * c - b * b
    return None if whole == 0 else [Fraction(c * wanted[0] - b * wanted[1], whole), Fraction(a * wanted[1] - b * wanted[0], whole)]


def facing(points, others):
    """Of few points and few others, four in all, as weights, the two points in which their flats are nearest to each
    other, if the hulls hold these: so those of all points and all others are among them, if these do not meet."""
    def minus(p, q):
        return [x - y for x, y in zip(p, q)]
    for n, m in ((n, m) for n in (1, 2, 3) for m in range(1, 5 - n)):
        for p, q in itertools.product(itertools.combinations(range(len(points)), n), itertools.combinations(range(len(others)), m)):
            first, last = points[p[0]], others[q[0]]
            parts = along([minus(points[k], first) for k in p[1:]] + [minus(last, others[k]) for k in q[1:]], minus(last, first))
            if parts is None or any(part < 0 for part in parts) or sum(parts[:n - 1]) > 1 or sum(parts[n - 1:]) > 1:
                continue
            yield tuple(list(zip(named, [1 - sum(some, Fraction(0)), *some])) for named, some in ((p, parts[:n - 1]), (q, parts[n - 1:])))


def distance_file(bodies, p, q):
    a, b = bodies
    claims = [{"claim": "holds", "weights": [[k, fraction(w)] for k, w in weights]} for weights in (p, q)]
    return file_of({"bodies": [body.entry("body") for body in bodies]},
                   {"question": "distance", "a": 0, "b": 1, "verdict": "closest",
                    "from_a": [fraction(x) for x in place(a.points, p)], "to_b": [fraction(x) for x in place(b.points, q)],
                    "claims": claims + [{"claim": "slab"}]})


def rows_of(top, k):
    """The points and ways of a body, in coordinates."""
    entry = top["tables"]["bodies"][k]
    if "of" not in entry:
        return [[list(map(value_of, row)) for row in entry.get(key, [])] for key in ("points", "ways")]
    points, ways = rows_of(top, entry["of"])
    d = len(points[0])
    linear, moved = [value_of(x) for x in entry["linear"]], [value_of(x) for x in entry["translation"]]

    def turned(v):
        return [sum(linear[r * d + c] * v[c] for c in range(d)) for r in range(d)]
    return [[x + t for x, t in zip(turned(p), moved)] for p in points], [turned(w) for w in ways]


def extrapolated(top, dice):
    """A point of B as a combination of what A is of, with weights of any sign; or None."""
    one = top["statements"][0]
    (points, ways), (others, _) = (rows_of(top, one[key]) for key in "ab")
    k = dice.randrange(len(others))
    columns = [p + [1] for p in points] + [w + [0] for w in ways]
    weights, _ = solution_or_proof(columns + [[-x for x in c] for c in columns], others[k] + [1])
    if weights is None:
        return None
    of_a = [[m, fraction(p - n)] for m, (p, n) in enumerate(zip(weights, weights[len(columns):])) if p != n]
    return [fraction(x) for x in others[k]], [of_a, [[k, "1"]]]


def forced_statement(top, verdict, dice):
    one = top["statements"][0]
    statement = {**{key: one[key] for key in ("question", "a", "b")}, "verdict": verdict}
    axes = len(top["tables"]["bodies"][0]["points"][0])
    vector = [str(dice.randint(-3, 3)) for _ in range(axes)]
    of = [claim.get("direction") for claim in one["claims"] if "direction" in claim]
    direction = dice.choice(of + [vector, ["0"] * axes])
    known = [claim["weights"] for claim in one["claims"] if "weights" in claim]
    if verdict == "apart":
        return {**statement, "claims": [{"claim": "parted", "direction": direction}]}
    if len(known) < 2 or dice.random() < .3:
        known = [[[k, dice.choice(["1/2", "1", "0", "1/4"])] for k in range(dice.randint(1, 2))]] * 2
    point, known = dice.random() < .3 and extrapolated(top, dice) or (one.get("point", vector), known)
    kind = "inside" if verdict == "overlapping" else "holds"
    claims = [{"claim": kind, "weights": weights} for weights in known]
    claims += [{"claim": "parted_weakly", "direction": direction}] * (verdict == "touching")
    return {**statement, "point": point, "claims": claims}


class PairsTest(unittest.TestCase):
    def test_each_pair_is_proved(self):
        dice, twins = dice_of(11), Twins(self)
        verdicts = []
        for k in range(some(800)):
            top = some_file(dice, k % 3 > 0)
            verdicts.append(top["statements"][0]["verdict"])
            self.assertEqual(twins.look(top), "accepted", top)
        twins.compare()
        for verdict in VERDICTS:
            self.assertTrue(some(100) < 100 or verdicts.count(verdict) > len(verdicts) / 50, verdict)

    def test_no_forced_claim_proves_what_is_not_so(self):
        dice, twins, accepted = dice_of(12), Twins(self), 0
        while lacking(FORCED, "pair"):
            top = some_file(dice, True)
            honest_one = top["statements"][0]
            truth = honest_one["verdict"]
            for _ in range(2):
                forced = spoilt_in_statements(top, dice)
                one = forced["statements"][0] if forced["statements"] else None
                is_same = isinstance(one, dict) and all(one.get(k) == honest_one[k] for k in "ab")
                said = (twins.force if is_same else twins.look)(forced)
                if said == "accepted" and is_same:
                    accepted += 1
                    self.assertTrue(could_be(one["verdict"], truth), forced)
            # What each other verdict would need, of the honest claims and of random numbers.
            for verdict in lacking(FORCED, "pair"):
                said = twins.force({**top, "statements": [forced_statement(top, verdict, dice)]})
                self.assertTrue(said != "accepted" or could_be(verdict, truth), twins.last)
        twins.compare()
        self.assertTrue(some(100) < 100 or accepted > 0)

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(13), Twins(self)
        while lacking(MUTANT, "pair"):
            top = some_file(dice, dice.random() < .8)
            if top["statements"][0]["verdict"] in lacking(MUTANT, "pair"):
                twins.spoil(top, dice)
        twins.compare()

    def test_lines_and_half_planes(self):
        """What goes on for ever is one body, and apart of it one claim."""
        def body(name, points, ways):
            return {"name": name, "points": [[hexadecimal(x) for x in p] for p in points],
                    "ways": [[hexadecimal(x) for x in w] for w in ways]}
        square = {"name": "square", "points": [[hexadecimal(x) for x in p] for p in ((0, 0), (1, 0), (1, 1), (0, 1))]}
        line = body("line", [(0, 2)], [(1, 0), (-1, 0)])
        half = body("half-plane", [(0, 2)], [(1, 0), (-1, 0), (0, 1)])
        twins = Twins(self)
        for other, direction, wanted in ((line, ["0", "1"], "accepted"), (line, ["1", "5"], "parted"),
                                         (half, ["0", "1/3"], "accepted"), (half, ["0", "-1"], "parted")):
            top = file_of({"bodies": [square, other]}, {"question": "pair", "a": 0, "b": 1, "verdict": "apart",
                                                        "claims": [{"claim": "parted", "direction": direction}]})
            self.assertEqual(twins.look(top), wanted, (other, direction))
        twins.compare()

    def test_distances(self):
        """Accepted where the two points are as near to each other as any of the two bodies, and only there."""
        dice, twins, nearest, count = dice_of(15), Twins(self), 0, 0
        while lacking(FORCED, "distance") or lacking(MUTANT, "distance"):
            dimension = dice.choice([2, 3])
            bodies = [Body(dice, dimension) for _ in range(2)]
            shift = [dice.randint(-4, 4) for _ in range(dimension)]
            for body, sign in zip(bodies, (0, 1)):
                body.ways = []
                body.points = [[x + sign * y for x, y in zip(point, shift)] for point in body.points]
            a, b = bodies
            if honest(bodies, 0, 1)["verdict"] == "meet":
                continue
            count += 1
            pairs = list(facing(a.points, b.points))
            best = min(square_between(place(a.points, p), place(b.points, q)) for p, q in pairs)
            for p, q in pairs:
                top = distance_file(bodies, p, q)
                is_nearest = square_between(place(a.points, p), place(b.points, q)) == best
                nearest += is_nearest
                self.assertEqual(twins.force(top), "accepted" if is_nearest else "slab", top)
                if dice.random() < .1:
                    twins.spoil(top, dice)
        twins.compare()
        self.assertGreaterEqual(nearest, count)
        one = [Body(dice, 2) for _ in range(2)]
        one[0].points = one[1].points = [[1, 1]]
        one[0].ways = one[1].ways = []
        self.assertEqual(twins.look(distance_file(one, [(0, Fraction(1))], [(0, Fraction(1))])), "slab")  # no way between
        one[1].points, one[1].ways = [[4, 1]], [[1, 1]]
        self.assertEqual(twins.look(distance_file(one, [(0, Fraction(1))], [(0, Fraction(1))])), "accepted")
        one[1].ways = [[-1, 1]]
        self.assertEqual(twins.look(distance_file(one, [(0, Fraction(1))], [(0, Fraction(1))])), "slab")
        twins.compare()

    def test_clearance(self):
        """Bodies are so far apart, or they are not: what is accepted is true, and one of both can be proved."""
        dice, twins, exactly_so = dice_of(16), Twins(self), 0
        while lacking(FORCED, "clearance") or lacking(MUTANT, "clearance"):
            dimension = dice.choice([2, 3])
            bodies = [Body(dice, dimension) for _ in range(2)]
            shift = [dice.randint(-5, 5) for _ in range(dimension)]
            bodies[0].ways, bodies[1].ways = [], []
            bodies[1].points = [[x + y for x, y in zip(point, shift)] for point in bodies[1].points]
            a, b = bodies
            known = honest(bodies, 0, 1)
            pairs = list(facing(a.points, b.points))
            pairs.sort(key=lambda pair: square_between(place(a.points, pair[0]), place(b.points, pair[1])))
            best = square_between(place(a.points, pairs[0][0]), place(b.points, pairs[0][1]))
            best = Fraction(0) if known["verdict"] == "meet" else best
            least = dice.choice([1, 2, 3, 5, Fraction(1, 2), Fraction(5, 4)])
            root = Fraction(math.isqrt(best.numerator), math.isqrt(best.denominator))
            if root and root * root == best and root.denominator in (1, 2, 4, 8):
                least = root
            table = {"bodies": [body.entry("body") for body in bodies]}
            start = {"question": "clearance", "a": 0, "b": 1, "least": float(least).hex()}
            proved = set()
            exactly_so += best == least ** 2
            tries = pairs[:1] + dice.sample(pairs, min(3, len(pairs)))
            tops = []
            for p, q in tries:
                points = place(a.points, p), place(b.points, q)
                direction = [fraction(y - x) for x, y in zip(*points)]
                tops.append(file_of(table, {**start, "verdict": "kept", "claims": [{"claim": "clear", "direction": direction}]}))
                claims = [{"claim": "holds", "weights": [[k, fraction(w)] for k, w in weights]} for weights in (p, q)]
                tops.append(file_of(table, {**start, "verdict": "broken", "from_a": [fraction(x) for x in points[0]],
                                            "to_b": [fraction(x) for x in points[1]], "claims": claims + [{"claim": "nearer"}]}))
            if known["verdict"] == "meet":
                tops.append(file_of(table, {**start, "verdict": "broken", "from_a": known["point"], "to_b": known["point"],
                                            "claims": known["claims"] + [{"claim": "nearer"}]}))
            for top in tops:
                verdict = top["statements"][0]["verdict"]
                if twins.force(top) == "accepted":
                    proved.add(verdict)
                if dice.random() < .1:
                    twins.spoil(top, dice)
            self.assertEqual(proved, {"kept" if best >= least ** 2 else "broken"}, (tops, best))
        twins.compare()
        self.assertTrue(some(100) < 100 or exactly_so > 0)

    def test_clearance_with_ways(self):
        """What leads on from one body towards the other is seen."""
        twins = Twins(self)
        for way, said in (("-0x1p+0", "accepted"), ("0x1p+0", "clear")):
            point, other = ["0x0p+0", "0x0p+0"], ["0x1p+2", "0x0p+0"]
            for which in (0, 1):
                bodies = [{"name": "a", "points": [point]}, {"name": "b", "points": [other]}]
                bodies[which]["ways"] = [[way if which == 0 else ("-" + way).replace("--", ""), "0x1p+0"]]
                for direction, least, wanted in ((["1", "0"], "0x1p+2", said), (["0", "0"], "0x1p+2", "clear"),
                                                 (["1/7", "0"], "0x1.0000000000001p+2", "clear"), (["1", "0"], "0x0p+0", "F")):
                    top = file_of({"bodies": bodies}, {"question": "clearance", "a": 0, "b": 1, "least": least, "verdict": "kept",
                                                       "claims": [{"claim": "clear", "direction": direction}]})
                    self.assertEqual(twins.look(top), wanted, top)
        twins.compare()

    def test_ways_as_arrows(self):
        """An arrow from one point to another is the way between them, in one unit with the points."""
        dice, twins = dice_of(14), Twins(self)
        for _ in range(some(200)):
            top = some_file(dice)
            arrows = json.loads(json.dumps(top))
            for body in arrows["tables"]["bodies"]:
                for k, way in enumerate(body.get("ways", [])):
                    start = [dice.choice(["0x0p+0", "0x1p+3", "-0x3p-70", "0x1p+80"]) for _ in way]
                    stop = [hexadecimal_of(value_of(p) + value_of(w)) for p, w in zip(start, way)]
                    if None not in stop:
                        body["ways"][k] = start + stop
            self.assertEqual(twins.look(arrows), "accepted", arrows)
        twins.compare()
        for ways in ([["0x0p+0"] * 3], [["0x0p+0"] * 5], [["0x0p+0"] * 4 + ["1"]], ["0x0p+0"], [{}], [[]], {}):
            body = {"name": "body", "points": [["0x0p+0", "0x0p+0"]], "ways": ways}
            self.assertEqual(twins.look(file_of({"bodies": [body]}, {"question": "pair"})), "F", ways)
        twins.compare()

    def test_contacts_by_hand(self):
        """Of flat bodies the relative interiors count."""
        def body(*points):
            return {"name": "body", "points": [[hexadecimal(x) for x in p] for p in points]}

        def half(*entries):
            return [[k, "1/%d" % len(entries)] for k in entries]
        square, diagonal = body((0, 0), (2, 0), (2, 2), (0, 2)), body((0, 0), (2, 2))
        corner, beyond, middle = body((2, 2)), body((2, 2), (4, 4)), body((1, 1))
        twins = Twins(self)
        for a, b, point, of_a, of_b, wanted in (
                (square, diagonal, "1", half(0, 1, 2, 3), half(0, 1), "accepted"),
                (square, diagonal, "1", half(0, 2), half(0, 1), "inside"),      # in the middle, of a diagonal only
                (square, diagonal, "1", half(0, 2) + [[1, "0"]], half(0, 1), "inside"),
                (square, diagonal, "2", half(2), half(1), "inside"),
                (square, middle, "1", half(0, 1, 2, 3), half(0), "accepted"),
                (diagonal, diagonal, "1", half(0, 1), half(0, 1), "accepted"),
                (middle, middle, "1", half(0), half(0), "accepted"),
                (square, middle, "1", half(0, 1, 2, 3), [[0, "2"]], "holds")):
            claims = [{"claim": "inside", "weights": of_a}, {"claim": "inside", "weights": of_b}]
            statement = {"question": "pair", "a": 0, "b": 1, "verdict": "overlapping", "point": [point] * 2, "claims": claims}
            self.assertEqual(twins.look(file_of({"bodies": [a, b]}, statement)), wanted, (a, b, of_a, of_b))
        for a, b, of_a, direction, wanted in (
                (square, corner, half(2), ["1", "1"], "accepted"),
                (square, corner, half(2), ["1", "0"], "accepted"),
                (square, corner, half(2), ["1", "-1"], "parted"),
                (square, corner, half(2), ["0", "0"], "parted"),
                (diagonal, beyond, half(1), ["1", "1"], "accepted"),
                (diagonal, beyond, half(1), ["1", "-1"], "parted"),              # both lie across it
                (diagonal, body((2, 2), (0, 0)), half(1), ["1", "-1"], "parted"),
                (diagonal, corner, half(1), ["1", "-1"], "parted"),
                (diagonal, corner, half(1), ["2", "1"], "accepted"),
                (corner, corner, half(0), ["1", "1"], "parted")):
            claims = [{"claim": "holds", "weights": of_a}, {"claim": "holds", "weights": half(0)},
                      {"claim": "parted_weakly", "direction": direction}]
            statement = {"question": "pair", "a": 0, "b": 1, "verdict": "touching", "point": ["2", "2"], "claims": claims}
            self.assertEqual(twins.look(file_of({"bodies": [a, b]}, statement)), wanted, (a, b, direction))
        twins.compare()


if __name__ == "__main__":
    main()
