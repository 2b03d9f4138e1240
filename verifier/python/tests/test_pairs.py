#!/usr/bin/env python3
"""Tests of statements about pairs against an exact simplex method: python3 verifier/python/tests/test_pairs.py."""
import unittest
from fractions import Fraction

from files import Twins, dice_of, file_of, fraction, hexadecimal, some, spoilt, spoilt_in_statements


def solution_or_proof(columns, wanted):
    """x >= 0 with the sum of x[k] columns[k] wanted, and None; or None, and y whose product with wanted is positive and
    with no column. By phase one of the simplex method, with Bland's rule."""
    rows, size = len(wanted), len(columns)
    signs = [1 if w >= 0 else -1 for w in wanted]
    table = [[signs[r] * Fraction(c[r]) for c in columns] + [Fraction(r == k) for k in range(rows)] + [signs[r] * Fraction(wanted[r])]
             for r in range(rows)]
    basis = [size + r for r in range(rows)]
    cost = [-sum(row[k] for row in table) for k in range(size)] + [Fraction(0)] * rows + [-sum(row[-1] for row in table)]
    while True:
        enter = next((k for k in range(size + rows) if cost[k] < 0), None)
        if enter is None:
            break
        ratios = [(row[-1] / row[enter], basis[r], r) for r, row in enumerate(table) if row[enter] > 0]
        _, _, r = min(ratios)
        pivot = table[r][enter]
        table[r] = [x / pivot for x in table[r]]
        for other in (*range(rows), None):
            row = cost if other is None else table[other]
            if other != r and row[enter]:
                factor = row[enter]
                row[:] = [x - factor * y for x, y in zip(row, table[r])]
        basis[r] = enter
    if cost[-1] == 0:
        x = [Fraction(0)] * (size + rows)
        for r, k in enumerate(basis):
            x[k] = table[r][-1]
        return x[:size], None
    return None, [signs[r] * (1 - cost[size + r]) for r in range(rows)]


class Body:
    def __init__(self, dice, dimension):
        def row(most):
            return [dice.randint(-most, most) for _ in range(dimension)]
        self.points = [row(3) for _ in range(dice.randint(1, 4))]
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


def some_file(dice):
    dimension = dice.choice([2, 3])
    bodies = [Body(dice, dimension) for _ in range(2)]
    bodies.append(Image(dice, bodies[1], 1))
    i, j = dice.choice([(0, 1), (0, 2), (2, 0), (1, 2)])
    return file_of({"bodies": [body.entry("body %d" % k) for k, body in enumerate(bodies)]}, honest(bodies, i, j))


class PairsTest(unittest.TestCase):
    def test_each_pair_is_proved(self):
        dice, twins = dice_of(11), Twins(self)
        verdicts = []
        for _ in range(some(1000)):
            top = some_file(dice)
            verdicts.append(top["statements"][0]["verdict"])
            self.assertEqual(twins.look(top), "accepted", top)
        twins.compare()
        self.assertGreater(min(verdicts.count("apart"), verdicts.count("meet")), len(verdicts) / 5)

    def test_no_forced_claim_proves_what_is_not_so(self):
        dice, twins, accepted = dice_of(12), Twins(self), 0
        while len(twins.tops) < some(4000):
            top = some_file(dice)
            verdict = top["statements"][0]["verdict"]
            other = {"apart": "meet", "meet": "apart"}[verdict]
            for _ in range(8):
                forced = spoilt_in_statements(top, dice)
                said = twins.look(forced)
                one = forced["statements"][0] if forced["statements"] else None
                is_same = isinstance(one, dict) and all(one.get(k) == top["statements"][0][k] for k in "ab")
                if said == "accepted" and is_same:
                    accepted += 1
                    self.assertEqual(one["verdict"], verdict, forced)
            # What the other verdict would need, of random numbers.
            statement = {key: top["statements"][0][key] for key in ("question", "a", "b")}
            vector = [str(dice.randint(-3, 3)) for _ in top["tables"]["bodies"][0]["points"][0]]
            if other == "apart":
                statement["claims"] = [{"claim": "parted", "direction": vector}]
            else:
                half = [[k, dice.choice(["1/2", "1", "0", "1/4"])] for k in range(dice.randint(1, 2))]
                statement.update(point=vector, claims=[{"claim": "holds", "weights": half}] * 2)
            said = twins.look({**top, "statements": [{**statement, "verdict": other}]})
            self.assertNotEqual(said, "accepted", twins.tops[-1])
        twins.compare()
        self.assertGreater(accepted, 0)

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(13), Twins(self)
        while len(twins.tops) < some(2000):
            twins.look(spoilt(some_file(dice), dice))
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


if __name__ == "__main__":
    unittest.main()
