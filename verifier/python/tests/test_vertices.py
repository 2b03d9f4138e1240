#!/usr/bin/env python3
"""Tests of statements about the vertices of half-spaces in R^d against brute force, and of both checkers against each
other: python3 verifier/python/tests/test_vertices.py."""
import copy
import itertools
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some
from test_boundaries import determinant, pulled, true_hull

QUESTION = "half_spaces_vertices"


def product(u, v):
    return sum(x * y for x, y in zip(u, v))


def common_point(rows):
    """Of d rows, the point where all of them end; None where there is not one."""
    d = len(rows)
    whole = determinant([row[:d] for row in rows])
    return whole and tuple(Fraction(determinant([row[:c] + [row[d]] + row[c + 1:d] for row in rows]), whole) for c in range(d))


def true_vertices(rows, d):
    """Of a bounded common part: points in all half-spaces that d of these have alone."""
    points = {common_point(some_rows) for some_rows in itertools.combinations(rows, d)} - {None, 0}
    return {p for p in points if all(product(row[:d], p) <= row[d] for row in rows)}


class Given:
    """Bounded half-spaces of small integers, and of each vertex the cones of some half-spaces that end there."""

    def __init__(self, dice):
        d, size = dice.choice([2, 2, 2, 3, 3, 3, 4]), dice.choice([1, 2])
        if dice.random() < .4 and d < 4:
            rows = [[s * (k == c) for k in range(d)] + [1] for c in range(d) for s in (1, -1)]
        else:
            rows = [[-int(k == c) for k in range(d)] + [1] for c in range(d)] + [[1] * d + [dice.choice([1, 2])]]
        more = ([dice.randint(-size, size) for _ in range(d)] + [dice.choice([1, 1, 2])] for _ in range(dice.randint(0, 5 - d // 2)))
        rows += [row for row in more if any(row[:d])]
        dice.shuffle(rows)
        polar = [tuple(x * 2 // row[d] for x in row[:d]) for row in rows]
        _, facets = true_hull(polar)
        self.fans = {}
        for facet in facets:
            cones = pulled(facet, facets, polar)
            self.fans[common_point([rows[k] for k in cones[0]])] = cones
        move = [dice.randint(-2, 2) for _ in range(d)]
        self.rows = [row[:d] + [row[d] + product(row, move)] for row in rows]
        self.fans = {tuple(x + y for x, y in zip(p, move)): cones for p, cones in self.fans.items()}
        if dice.random() < .2 and d < 4:  # in a hyperplane
            self.rows = [row[:d] + [0, row[d]] for row in self.rows] + [[-1] * d + [1, 2], [1] * d + [-1, -2]]
            n = len(self.rows)
            self.fans = {(*p, 2 + sum(p)): [[*cone, k] for cone in cones for k in (n - 2, n - 1)] for p, cones in self.fans.items()}
            d += 1
        self.d = d

    def file(self, points, fans):
        entry = {"name": "given", "dimension": self.d, "half_spaces": [[hexadecimal(x) for x in row] for row in self.rows]}
        return file_of({"polytopes": [entry]}, {
            "question": QUESTION, "half_spaces": 0, "verdict": "vertices",
            "vertices": [{"point": [fraction(Fraction(x)) for x in p]} for p in points],
            "claims": [{"claim": "normal_fan", "fans": fans}]})

    def honest(self):
        return self.file([*self.fans], [*self.fans.values()])


def changed(given, dice):
    """The statement with a few changes."""
    points, fans = [list(p) for p in given.fans], copy.deepcopy([*given.fans.values()])
    for _ in range(dice.randint(1, 2)):
        change, v = dice.randint(0, 8), dice.randrange(len(points))
        w = dice.randrange(len(points))
        cone = dice.choice(fans[v])
        if change == 0 and len(points) > 1:  # a vertex is left out
            points.pop(v), fans.pop(v)
        elif change == 1 and len(fans[v]) > 1:
            fans[v].remove(cone)
        elif change == 2:
            other = dice.randrange(len(given.rows))
            if other not in cone:
                cone[dice.randrange(given.d)] = other
        elif change == 3:
            points[v] = [dice.randint(-2, 2) for _ in points[v]]
        elif change == 4:  # a point between
            points.append([(x + y) / Fraction(2) for x, y in zip(points[v], points[w])])
            fans.append([list(cone)])
        elif change == 5:  # once more
            points.append(list(points[v])), fans.append(copy.deepcopy(fans[v]))
        elif change == 6 and len(points) > 1:  # its cones at another one
            points.pop(v)
            moved = fans.pop(v)
            fans[w % len(fans)] += moved
        elif change == 7:  # a harmless one
            dice.shuffle(cone), dice.shuffle(fans[v])
        else:
            fans[v].append(list(dice.choice(fans[w])))
    return given.file(points, fans)


class VerticesTest(unittest.TestCase):
    def test_each_list_is_proved(self):
        dice, twins, simple, degenerate, flat = dice_of(1), Twins(self), 0, 0, 0
        for _ in range(some(60)):
            given = Given(dice)
            self.assertEqual({*given.fans}, true_vertices(given.rows, given.d))
            self.assertEqual(twins.look(given.honest()), "accepted", given.honest())
            counts = {len(cones) for cones in given.fans.values()}
            is_flat = given.rows[-1][:-1] == [-x for x in given.rows[-2][:-1]] and given.rows[-1][-1] == -2
            simple, degenerate, flat = simple + (counts == {1}), degenerate + (counts > {1}), flat + is_flat
        twins.compare()
        self.assertTrue(some(100) < 100 or min(simple, degenerate, flat) > some(4), (simple, degenerate, flat))

    def test_each_vertex_is_missed(self):
        """Each one is left out in turn, also with its cones at another one, which is then refused by another check."""
        dice, twins = dice_of(4), Twins(self)
        for _ in range(some(12)):
            given = Given(dice)
            points, fans = [*given.fans], [*given.fans.values()]
            for v in range(len(points)) if len(points) > 1 else []:
                rest = points[:v] + points[v + 1:], fans[:v] + fans[v + 1:]
                self.assertEqual(twins.look(given.file(*rest)), "normal_fan")
                rest[1][0] = rest[1][0] + fans[v]
                self.assertEqual(twins.look(given.file(*rest)), "normal_fan")
            v = dice.randrange(len(points))  # and a half-space more cuts it off
            given.rows.append([sum(given.rows[k][c] for k in fans[v][0]) for c in range(given.d + 1)])
            self.assertEqual(twins.look(given.file(points, fans)), "accepted")
            given.rows[-1][-1] -= 1
            self.assertEqual(twins.look(given.file(points, fans)), "normal_fan")
        twins.compare()

    def test_no_forced_claim_proves_what_is_not_so(self):
        dice, twins, accepted = dice_of(2), Twins(self), 0
        while lacking(FORCED, QUESTION):
            given = Given(dice)
            truth = true_vertices(given.rows, given.d)
            for _ in range(12):
                forced = changed(given, dice)
                said = twins.force(forced)
                accepted += said == "accepted"
                named = [tuple(map(Fraction, one["point"])) for one in forced["statements"][0]["vertices"]]
                self.assertTrue(said != "accepted" or (len(named) == len(truth) and {*named} == truth), forced)
        twins.compare()
        self.assertTrue(some(100) < 100 or accepted > 0)

    def test_what_is_not_bounded_has_no_fan(self):
        """All vertices of a wedge, or none of them: there are no cones beyond."""
        twins = Twins(self)
        given = Given(dice_of(5))
        given.d, given.rows = 2, [[-1, 0, 0], [0, -1, 0], [-1, -1, -1]]
        fans = {(0, 1): [[0, 2]], (1, 0): [[2, 1]]}
        self.assertEqual(twins.look(given.file([*fans], [*fans.values()])), "normal_fan")
        self.assertEqual(twins.look(given.file([(0, 1)], [[[0, 2], [2, 0]]])), "normal_fan")
        self.assertEqual(twins.look(given.file([], [])), "F")
        given.rows.append([1, 1, 3])
        fans = {(0, 1): [[0, 2]], (1, 0): [[2, 1]], (3, 0): [[1, 3]], (0, 3): [[3, 0]]}
        self.assertEqual(twins.look(given.file([*fans], [*fans.values()])), "accepted")
        twins.compare()

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(3), Twins(self)
        while lacking(MUTANT, QUESTION):
            twins.spoil(Given(dice).honest(), dice)
        twins.compare()


if __name__ == "__main__":
    main()
