#!/usr/bin/env python3
"""Tests of statements about half-spaces of any dimension, their common part and linear programs over them, against an
exact simplex method, and of both checkers against each other: python3 verifier/python/tests/test_half_spaces.py."""
import unittest
from fractions import Fraction

from files import (FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some,
                   spoilt_in_statements)
from test_pairs import product, solution_or_proof


class Given:
    """Half-spaces a1, .., ad, b of small integers, and what is true of them."""

    def __init__(self, dice, d):
        self.d, size = d, dice.choice([1, 2])
        self.rows = [[dice.randint(-size, size) for _ in range(d)] + [dice.randint(-1, 3)]
                     for _ in range(dice.randint(1, d + 3))]
        if dice.random() < .3:  # in a flat
            self.rows += [[-x for x in row] for row in self.rows[:dice.randint(1, 2)]]
        if dice.random() < .4:  # in a box
            self.rows += [[s * (k == c) for k in range(d)] + [1] for c in range(d) for s in (1, -1)]
        self.objective = dice.choice([[dice.randint(-2, 2) for _ in range(d)], [0] * d, [int(k == 0) for k in range(d)]])
        self.normals = [row[:d] for row in self.rows]

    def entry(self):
        return {"name": "given", "dimension": self.d, "half_spaces": [[hexadecimal(x) for x in row] for row in self.rows]}

    def step(self, point, way):
        """A point along a way that is right for the half-spaces that hold the point with equality."""
        ratios = [(row[-1] - product(row, point)) / product(row, way) for row in self.rows if product(row, way) > 0]
        by = min(ratios + [1])
        assert by > 0
        return [p + by * w for p, w in zip(point, way)]

    def point(self):
        """A common point, or None; and else multipliers that contradict."""
        weights, proof = solution_or_proof(self.rows, [0] * self.d + [-1])
        return (None, weights) if weights is not None else ([-y / proof[-1] for y in proof[:-1]], None)

    def best(self):
        """The verdict, the point, another one or a way, and the multipliers."""
        d, up = self.d, self.objective
        point, weights = self.point()
        if point is None:
            return "infeasible", None, None, weights
        if not any(up):
            return "all", point, None, None
        weights, way = solution_or_proof(self.normals, up)
        if weights is None:
            return "unbounded", point, way, None
        # x+, x-, slacks, multipliers, and by how much these bound more than x: zero
        n = len(self.rows)
        columns = [[s * row[c] for row in self.rows] + [0] * d + [-s * up[c]] for s in (1, -1) for c in range(d)]
        columns += [[int(i == k) for i in range(n)] + [0] * (d + 1) for k in range(n)]
        columns += [[0] * n + row[:d] + [row[d]] for row in self.rows]
        found, _ = solution_or_proof(columns, [row[d] for row in self.rows] + up + [0])
        point, weights = [found[c] - found[d + c] for c in range(d)], found[2 * d + n:]
        tight = [k for k, row in enumerate(self.rows) if product(row, point) == row[d]]
        total, share = [Fraction(0)] * n, Fraction(0)
        for c in range(d):
            for s in (1, -1):  # a way r, as good, with r_c = s: r+, r-, slacks
                columns = [[sign * self.rows[k][j] for k in tight] + [sign * up[j], sign * int(j == c)] for sign in (1, -1) for j in range(d)]
                columns += [[int(i == k) for i in range(len(tight))] + [0, 0] for k in range(len(tight))]
                found, proof = solution_or_proof(columns, [0] * len(tight) + [0, s])
                if found:
                    return "many", point, self.step(point, [found[j] - found[d + j] for j in range(d)]), weights
                scale = -1 / (s * proof[-1])  # so that the row of r_c has one, and its opposite
                for k, y in zip(tight, proof):
                    total[k] += y * scale
                share -= proof[-2] * scale
        by = 1 + abs(share)
        return "one", point, None, [(t + by * w) / (by + share) for t, w in zip(total, weights)]

    def region(self):
        """The verdict, the dimension, points, multipliers that hold all in a flat, and those that enclose, or a way."""
        d = self.d
        inside, weights = self.point()
        if inside is None:
            return "empty", None, None, weights, None
        flat, equal = [Fraction(0)] * len(self.rows), []
        for k, row in enumerate(self.rows):
            weights, proof = solution_or_proof(self.rows, [-x for x in row])
            if weights is not None:
                equal.append(k)
                flat = [f + w + (i == k) for i, (f, w) in enumerate(zip(flat, weights))]
            else:  # all rows, and this one strictly, are kept by the proof as (x, -w), and so with some of the point added
                some_of_it = 1 + max(proof[-1], 0)
                inside = [(y + some_of_it * p) / (some_of_it - proof[-1]) for y, p in zip(proof, inside)]
        points, known = [inside], [self.normals[k] for k in equal]
        for c in range(d):
            way = [Fraction(int(k == c)) for k in range(d)]
            way = across(known, way)
            if any(way):
                known.append(way)
                points.append(self.step(inside, way))
        around = [Fraction(0)] * len(self.rows)
        for c in range(d):
            for s in (1, -1):
                weights, way = solution_or_proof(self.normals, [s * int(k == c) for k in range(d)])
                if weights is None:
                    return "unbounded", len(points) - 1, points, flat, way
                around = [w + v for w, v in zip(around, weights)]
        return "bounded", len(points) - 1, points, flat, around


def across(known, way):
    """What is left of a way across the span of vectors."""
    basis = []
    for vector in [*known, way]:
        for other in basis:
            by = product(vector, other) / Fraction(product(other, other))
            vector = [x - by * y for x, y in zip(vector, other)]
        if any(vector):
            basis.append(vector)
    return vector


def listed(weights):
    return [[k, fraction(Fraction(w))] for k, w in enumerate(weights) if w]


def told(numbers):
    return [fraction(Fraction(x)) for x in numbers]


def keeps(point):
    return {"claim": "keeps", "weights": [], "at": told(point)}


def program(given):
    verdict, point, more, weights = given.best()
    one = {"question": "half_spaces_program", "half_spaces": 0, "objective": [hexadecimal(x) for x in given.objective],
           "verdict": verdict}
    if verdict == "infeasible":
        return {**one, "claims": [{"claim": "contradicted", "multipliers": listed(weights)}]}
    one["point"] = told(point)
    if verdict == "many":
        one["as_good"] = told(more)
    return {**one, "claims": [keeps(point)] + {
        "one": lambda: [{"claim": "tops_only", "multipliers": listed(weights)}],
        "many": lambda: [{"claim": "tops", "multipliers": listed(weights)}, keeps(more), {"claim": "another"}],
        "all": lambda: [{"claim": "no_objective"}],
        "unbounded": lambda: [{"claim": "rises", "direction": told(more)}]}[verdict]()}


def region(given):
    verdict, dimension, points, flat, more = given.region()
    one = {"question": "half_spaces", "half_spaces": 0, "verdict": verdict}
    if verdict == "empty":
        return {**one, "claims": [{"claim": "contradicted", "multipliers": listed(flat)}]}
    return {**one, "dimension": dimension, "spanned_by": [{"point": told(p)} for p in points], "claims": [
        {"claim": "spans", "multipliers": listed(flat)},
        {"claim": "enclosed", "multipliers": listed(more)} if verdict == "bounded" else
        {"claim": "recedes", "direction": told(more)}]}


QUESTIONS = {"half_spaces": region, "half_spaces_program": program}


def some_given(dice):
    return Given(dice, dice.choice([2, 2, 3, 3, 4, 5]))


def forced(given, true_one, verdict, dice):
    """What another verdict would need, of the true one's and of random numbers."""
    d, n = given.d, len(given.rows)
    known = [claim["multipliers"] for claim in true_one["claims"] if "multipliers" in claim]
    any_weights = [[k, dice.choice(["1", "2", "1/3"])] for k in dice.sample(range(n), dice.randint(0, n))]
    multipliers = dice.choice([*known, *known, any_weights])
    points = [[fraction(Fraction(x)) for x in point] for point in (
        [0] * d, [dice.randint(-1, 1) for _ in range(d)])]
    points += [true_one[key] for key in ("point", "as_good") if key in true_one] * 2
    points += [p["point"] for p in true_one.get("spanned_by", [])]
    point, other = dice.choice(points), dice.choice(points)
    way = dice.choice([[str(dice.randint(-1, 1)) for _ in range(d)], [str(x) for x in given.objective]])
    def at(where):
        return {"claim": "keeps", "weights": [], "at": where}
    if true_one["question"] == "half_spaces":
        dimension = dice.randint(0, d)
        flats = [[], multipliers]
        said = {} if verdict == "empty" else {"dimension": dimension, "spanned_by": [
            {"point": p} for p in (true_one.get("spanned_by") and dice.random() < .5 and
                                   [q["point"] for q in true_one["spanned_by"]][:dimension + 1] or
                                   [dice.choice(points) for _ in range(dimension + 1)])]}
        spans = {"claim": "spans", "multipliers": dice.choice(flats)}
        needed = {"empty": [{"claim": "contradicted", "multipliers": multipliers}],
                  "bounded": [spans, {"claim": "enclosed", "multipliers": multipliers}],
                  "unbounded": [spans, {"claim": "recedes", "direction": way}]}[verdict]
        return {"question": "half_spaces", "half_spaces": 0, "verdict": verdict, **said, "claims": needed}
    said = {} if verdict == "infeasible" else {"point": point}
    said.update({"as_good": other} if verdict == "many" else {})
    needed = {
        "one": [at(point), {"claim": "tops_only", "multipliers": multipliers}],
        "many": [at(point), {"claim": "tops", "multipliers": multipliers}, at(other), {"claim": "another"}],
        "all": [at(point), {"claim": "no_objective"}],
        "unbounded": [at(point), {"claim": "rises", "direction": way}],
        "infeasible": [{"claim": "contradicted", "multipliers": multipliers}]}[verdict]
    return {"question": "half_spaces_program", "half_spaces": 0, "objective": true_one["objective"], "verdict": verdict,
            **said, "claims": needed}


class HalfSpaces(unittest.TestCase):
    def setUp(self):
        self.twins = Twins(self)

    def tearDown(self):
        self.twins.compare()

    def file(self, given, statement):
        return file_of({"polytopes": [given.entry()]}, statement)

    def test_honest_ones_are_accepted(self):
        dice, verdicts = dice_of(2101), {}
        for _ in range(some(150)):
            given = some_given(dice)
            for honest in QUESTIONS.values():
                statement = honest(given)
                verdicts[statement["verdict"]] = verdicts.get(statement["verdict"], 0) + 1
                self.assertEqual(self.twins.look(self.file(given, statement)), "accepted", self.twins.last)
        self.assertTrue(some(100) < 100 or len(verdicts) == 7)

    def test_no_forced_claim_proves_what_is_not_so(self):
        dice, accepted = dice_of(2102), 0
        while any(lacking(FORCED, question) for question in QUESTIONS):
            given = some_given(dice)
            for question, honest in QUESTIONS.items():
                true_one = honest(given)
                tries = [forced(given, true_one, verdict, dice) for verdict in lacking(FORCED, question) for _ in range(4)]
                tries = [self.file(given, one) for one in tries]
                tries.append(spoilt_in_statements(self.file(given, true_one), dice))
                for top in tries:
                    if self.twins.force(top) != "accepted":
                        continue
                    accepted += 1
                    for one in top["statements"]:
                        if one.get("objective") == true_one.get("objective"):
                            self.assertEqual(one["verdict"], true_one["verdict"], top)
                            self.assertEqual(one.get("dimension"), true_one.get("dimension"), top)
                            if one["verdict"] == "one":
                                self.assertEqual(list(map(Fraction, one["point"])),
                                                 list(map(Fraction, true_one["point"])), top)
        self.assertTrue(some(100) < 100 or accepted > self.twins.count / 50)

    def test_spoilt_ones(self):
        """Both checkers say the same of them."""
        dice = dice_of(2103)
        while any(lacking(MUTANT, question) for question in QUESTIONS):
            given = some_given(dice)
            for question, honest in QUESTIONS.items():
                statement = honest(given)
                if statement["verdict"] in lacking(MUTANT, question):
                    self.twins.spoil(self.file(given, statement), dice)

    def test_the_form(self):
        dice = dice_of(2104)
        for change in (lambda one: one.update(half_spaces=1), lambda one: one["objective"].pop(),
                       lambda one: one.update(half_spaces=-1), lambda one: one.pop("half_spaces"),
                       lambda one: one.update(objective=None), lambda one: one.update(more=1)):
            given = some_given(dice)
            statement = program(given)
            change(statement)
            self.assertEqual(self.twins.look(self.file(given, statement)), "F")
        given = some_given(dice)
        top = self.file(given, program(given))
        top["tables"]["polytopes"][0]["points"] = top["tables"]["polytopes"][0].pop("half_spaces")
        self.assertEqual(self.twins.look(top), "F")


if __name__ == "__main__":
    main()
