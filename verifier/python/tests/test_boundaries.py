#!/usr/bin/env python3
"""Tests of statements about facets of convex hulls in R^d against brute force, and of both checkers against each other:
python3 verifier/python/tests/test_boundaries.py."""
import itertools
import json
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, hexadecimal, lacking, main, some, sunder_verify

QUESTION = "polytope_hull"


def eliminated(rows):
    """Of rows of whole numbers: the columns that tell the others, and the determinant of these columns, if they are as
    many as the rows. All divisions are exact (E. Bareiss)."""
    rows, columns, sign, over = list(rows), [], 1, 1
    for c in range(len(rows[0]) if rows else 0):
        at = next((k for k, row in enumerate(rows) if row[c]), None)
        if at is not None:
            sign, by = -sign if at % 2 else sign, rows.pop(at)
            rows = [[(x * by[c] - y * row[c]) // over for x, y in zip(row, by)] for row in rows]
            over = by[c]
            columns.append(c)
    return columns, sign * over


def determinant(m):
    columns, result = eliminated(m)
    return result if len(columns) == len(m) else 0


def basis(rows):
    """The columns that tell the others of these rows."""
    return eliminated(rows)[0]


def ways(points):
    return [[x - y for x, y in zip(p, points[0])] for p in points[1:]]


def true_hull(points):
    """Columns that tell the others; and of each facet the points that are vertices and lie on it, of equal ones the first."""
    columns = basis(ways(points))
    at, k = [[p[c] for c in columns] for p in points], len(columns)
    if k == 0:
        return columns, []
    facets = set()
    for those in itertools.combinations(range(len(points)), k):
        edges = ways([at[q] for q in those])
        normal = [(-1) ** c * determinant([row[:c] + row[c + 1:] for row in edges]) for c in range(k)]
        heights = [sum(n * (x - y) for n, x, y in zip(normal, p, at[those[0]])) for p in at]
        if any(normal) and (max(heights) == 0 or min(heights) == 0):
            facets.add(frozenset(q for q, height in enumerate(heights) if height == 0))
    first = {p: points.index(p) for p in points}
    vertices = {v for v in first.values()
                if {points[q] for q in frozenset.intersection(*[f for f in facets if v in f] or [frozenset()])} == {points[v]}}
    return columns, sorted(sorted(f & vertices) for f in facets)


def pulled(face, facets, points):
    """Simplices of a face: from its least corner to those of its own faces that do not have that."""
    size = len(basis(ways([points[v] for v in face]))) + 1
    if len(face) == size:
        return [face]
    inner = {tuple(sorted({*face} & {*other})) for other in facets} - {tuple(face)}
    inner = [list(f) for f in inner if f and len(basis(ways([points[v] for v in f]))) + 1 == size - 1]
    return [[face[0], *simplex] for f in inner if face[0] not in f for simplex in pulled(f, facets, points)]


def seen(points, columns, facets):
    """Points from the mean of all corners."""
    corners = {v for facet in facets for v in facet}
    return [[len(corners) * p[c] - sum(points[v][c] for v in corners) for c in columns] for p in points]


def cut(points):
    columns, facets = true_hull(points)
    at = seen(points, columns, facets)
    result = [pulled(facet, facets, points) for facet in facets]
    for facet in result:
        for simplex in facet:
            if determinant([at[v] for v in simplex]) < 0:
                simplex[:2] = simplex[1::-1]
    return at, result


def in_cone(corners, p):
    whole = determinant(corners)
    return all(determinant(corners[:i] + [p] + corners[i + 1:]) * whole >= 0 for i in range(len(corners)))


def homes_of(at, facets):
    simplices = [simplex for facet in facets for simplex in facet]
    corners = {v for simplex in simplices for v in simplex}
    return [None if q in corners else next(s for s, simplex in enumerate(simplices) if in_cone([at[v] for v in simplex], p))
            for q, p in enumerate(at)]


def statement_of(points, verdict, *found):
    says, claim = {}, {"claim": {"facets": "boundary", "segment": "between", "point": "one_point"}[verdict]}
    if verdict == "facets":
        says, claim["simplices"] = {"facets": found[0]}, found[1]
    elif verdict == "segment":
        says = {"i": found[0], "j": found[1]}
    table = {"bodies": [{"name": "points", "points": [[hexadecimal(x) for x in p] for p in points]}]}
    return file_of(table, {"question": QUESTION, "body": 0, "verdict": verdict, **says, "claims": [claim]})


def honest(points):
    columns, facets = true_hull(points)
    if len(columns) == 0:
        return statement_of(points, "point")
    if len(columns) == 1:
        return statement_of(points, "segment", facets[0][0], facets[1][0])
    at, cut_facets = cut(points)
    return statement_of(points, "facets", cut_facets, homes_of(at, cut_facets))


def some_points(dice):
    """Few places, so that facets are no simplices, points lie on them, and come twice."""
    d, size, throw = dice.choice([2, 3, 3, 4, 4, 5]), dice.choice([1, 1, 2]), dice.random()
    count = dice.randint(1, 4) if dice.random() < .2 else dice.randint(d + 1, 9)
    points = [tuple(dice.randint(-size, size) for _ in range(d)) for _ in range(count)]
    if throw < .2:
        rank = dice.randint(1, d - 1)
        points = [p[:rank] + tuple(sum(p[:c - rank + 1]) + c for c in range(rank, d)) for p in points]
    elif throw < .25:
        points = points[:1] * count
    return points


def is_so(points, statement):
    """Is this the hull? Points that are equal stand for each other."""
    columns, facets = true_hull(points)
    first = {p: points.index(p) for p in points}
    if statement["verdict"] != ("point", "segment", "facets")[min(len(columns), 2)]:
        return False
    if statement["verdict"] == "point":
        return True
    if statement["verdict"] == "segment":
        return sorted(first[points[statement[key]]] for key in "ij") == sorted(f[0] for f in facets)
    named = [sorted({first[points[v]] for simplex in facet for v in simplex}) for facet in statement["facets"]]
    return sorted(named) == facets


def changed(top, points, dice):
    """The statement, or one of another verdict, with a few changes."""
    one, n = top["statements"][0], len(points)
    verdict = dice.choice([one["verdict"]] * 3 + ["segment", "point"])
    if verdict != "facets":
        return statement_of(points, verdict, *(dice.choices(range(n), k=2) if verdict == "segment" else ()))
    facets, homes = [[list(s) for s in f] for f in one["facets"]], list(one["claims"][0]["simplices"])
    for _ in range(dice.randint(1, 2)):
        change, f = dice.randint(0, 7), dice.randrange(len(facets))
        simplex = dice.choice(facets[f])
        if change == 0:
            simplex[:2] = simplex[1::-1]
        elif change == 1 and len(facets) > 1:
            facets.pop(f)
        elif change == 2:
            simplex[dice.randrange(len(simplex))] = dice.randrange(n)
        elif change == 3 and len(facets[f]) > 1:  # a simplex as a facet of its own
            facets.append([facets[f].pop()])
        elif change == 4:  # another point for a corner, everywhere
            a, b = dice.randrange(n), dice.randrange(n)
            facets = [[[b if v == a else v for v in s] for s in facet] for facet in facets]
        elif change == 5 and len(facets) > 1:  # two facets as one
            facets[f - 1] += facets.pop(f)
        elif change == 6:  # around a point
            new, least = dice.randrange(n), facets[f].pop(dice.randrange(len(facets[f])))
            facets[f] += [least[:i] + [new] + least[i + 1:] for i in range(len(least))]
        else:
            k = dice.randrange(n)
            homes[k] = None if homes[k] is not None else dice.randrange(len(facets))
    corners = {v for facet in facets for s in facet for v in s}
    count = sum(map(len, facets))
    homes = [None if k in corners and dice.random() < .9 else dice.randrange(count) if home is None or home >= count else home
             for k, home in enumerate(homes)]
    return statement_of(points, verdict, facets, homes)


class BoundariesTest(unittest.TestCase):
    def test_each_hull_is_proved(self):
        dice, twins, seen_of = dice_of(1), Twins(self), set()
        for _ in range(some(500)):
            points = some_points(dice)
            top = honest(points)
            facets = top["statements"][0].get("facets", [])
            seen_of.add((len(points[0]), len(facets[0][0]) if facets else 0, sum(map(len, facets)) > len(facets)))
            self.assertEqual(twins.look(top), "accepted", top)
        twins.compare()
        for d, k in ((2, 2), (3, 2), (3, 3), (4, 3), (4, 4), (5, 4)):
            self.assertTrue(some(100) < 100 or any(of[:2] == (d, k) for of in seen_of), (d, k))
        self.assertTrue(some(100) < 100 or (4, 4, True) in seen_of)

    def test_no_forced_claim_proves_what_is_not_so(self):
        dice, twins, accepted = dice_of(2), Twins(self), 0
        while lacking(FORCED, QUESTION):
            points = some_points(dice)
            top = honest(points)
            for _ in range(6):
                forced = changed(top, points, dice)
                said = twins.force(forced)
                accepted += said == "accepted"
                self.assertTrue(said != "accepted" or is_so(points, forced["statements"][0]), forced)
        twins.compare()
        self.assertTrue(some(100) < 100 or accepted > 0)

    def test_boundaries_that_go_around_twice(self):
        """Closed, convex at each ridge, all seen from the mean alike, and not the hull of anything."""
        twins, rim = Twins(self), [(4, 0), (1, 4), (-3, 2), (-3, -2), (1, -4)]
        for step, wanted in ((1, "accepted"), (2, "boundary")):
            order = [k * step % 5 for k in range(5)]
            edges = list(zip(order, order[1:] + order[:1]))
            self.assertEqual(twins.look(statement_of(rim, "facets", [[[a, b]] for a, b in edges], [None] * 5)), wanted)
            ends = [(x, y, 0, 0) for x, y in rim] + [(0, 0, 3, 0), (0, 0, -3, 0), (0, 0, 0, 3), (0, 0, 0, -3)]
            facets = [[[*((a, b) if (c == 5) == (e == 7) else (b, a)), c, e]] for a, b in edges for c in (5, 6) for e in (7, 8)]
            top = statement_of(ends, "facets", facets, [None] * 9)
            self.assertEqual(twins.look(top), wanted)
        ((_, refusal),) = sunder_verify.verify(json.dumps(top).encode()).statements
        self.assertIn("is in the way of the first", refusal[1])
        twins.compare()

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(3), Twins(self)
        while lacking(MUTANT, QUESTION):
            top = honest(some_points(dice))
            if top["statements"][0]["verdict"] in lacking(MUTANT, QUESTION):
                twins.spoil(top, dice)
        twins.compare()



class Form(unittest.TestCase):
    def test_a_first_simplex_without_corners(self):
        """All simplices have as many corners, two at least: the first one, too."""
        body = {"name": "b", "points": [["0x0p0", "0x0p0"], ["0x1p0", "0x0p0"]]}
        twins = Twins(self)
        for facets in ([[[], [0, 1]]], [[[]], [[0, 1]]], [[[0], [0, 1]]], [[[0, 1], []]], [[[]]]):
            top = file_of({"bodies": [body]}, {
                "question": "polytope_hull", "body": 0, "verdict": "facets", "facets": facets,
                "claims": [{"claim": "boundary", "simplices": [None, None]}]})
            self.assertEqual(twins.look(top), "F")
        twins.compare()


if __name__ == "__main__":
    main()
