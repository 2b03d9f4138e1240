#!/usr/bin/env python3
"""Tests of statements about planes of support through lines, against integers: python3 verifier/python/tests/test_supports.py."""
import itertools
import math
import unittest

from files import FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some
from test_hulls import cross, dot, minus


def shortest(d):
    return tuple(x // (math.gcd(*d) or 1) for x in d)


def planes(points, a, b):
    """All directions across the line, that no point is beyond, and a point beside the line is as far along as it: each
    with the points that are, and on which sides these are."""
    way, found = minus(b, a), {}
    for p, sign in itertools.product(points, (1, -1)):
        d = shortest([sign * x for x in cross(way, minus(p, a))])
        heights = [dot(d, minus(q, a)) for q in points]
        if any(d) and max(heights) <= 0:
            on = [k for k, h in enumerate(heights) if h == 0]
            found[d] = on, {(s > 0) - (s < 0) for s in (dot(cross(d, way), minus(points[k], a)) for k in on)}
    return found


def is_solid(points):
    return any(dot(cross(minus(q, p), minus(r, p)), minus(s, p)) for p, q, r, s in itertools.combinations(points, 4))


def is_true(points, a, b, statement, directions):
    """Of `none`, when both hold the point: its relative interior is another rule's."""
    found, verdict = planes(points, a, b), statement["verdict"]
    if verdict == "none":
        return is_solid(points) and not found
    if verdict == "one":
        return any(on == statement["on_plane"] and sides >= {-1, 1} for on, sides in found.values())
    return len(found) == 2 and any(cross(*found)) and [found.get(shortest(d), [None])[0] for d in directions] == [
        statement["on_first"], statement["on_last"]]


def body(name, points, ways=()):
    rows = {"points": [[hexadecimal(x) for x in p] for p in points]}
    return {"name": name, **rows, **({"ways": [[hexadecimal(x) for x in way] for way in ways]} if ways else {})}


def file_about(points, a, b, statement, is_segment=False):
    line = body("segment", [a, b]) if is_segment else body("line", [a], [(*a, *b), (*b, *a)])
    return file_of({"bodies": [body("points", points), line]}, {"question": "support", "a": 0, "b": 1, **statement})


def texts(d):
    return [fraction(x) for x in d]


def two(on_first, on_last, before, after):
    return {"on_first": on_first, "on_last": on_last, "verdict": "two",
            "claims": [{"claim": "wedge", "before": texts(before), "after": texts(after)}]}


def one(on_plane, direction):
    return {"on_plane": on_plane, "verdict": "one", "claims": [{"claim": "rests", "direction": texts(direction)}]}


def none(points, a, spanning):
    """The line goes through the middle of the points, which is a."""
    weights = [[k, "1/%d" % len(points)] for k in range(len(points))]
    return {"point": texts(a), "verdict": "none", "claims": [
        {"claim": "inside", "weights": weights}, {"claim": "holds", "weights": [[0, "1"]]},
        {"claim": "full", **dict(zip("ijkl", spanning))}]}


def some_case(dice):
    points = [tuple(dice.randint(-2, 2) for _ in range(3)) for _ in range(dice.randint(4, 7))]
    if dice.random() < .1:
        points = [(x, y, x - y) for x, y, _ in points]
    points = [tuple(len(points) * x for x in p) for p in sorted(set(points))]
    at = tuple(sum(p[axis] for p in points) // len(points) for axis in range(3))
    a = b = dice.choice([at, *points, *points, tuple(dice.randint(-9, 9) for _ in range(3))])
    while a == b:
        b = dice.choice([*points, tuple(dice.randint(-9, 9) for _ in range(3)), tuple(x + y for x, y in zip(a, dice.choice(points)))])
    return points, a, b, at


def honest(points, a, b, at, dice):
    """The statement about them; None where the body is flat, or the point inside is not a."""
    found = planes(points, a, b)
    if not is_solid(points):
        return None
    if not found:
        middle = all(len(points) * x == sum(p[axis] for p in points) for axis, x in enumerate(a))
        four = [k for k in itertools.permutations(range(len(points)), 4) if is_solid([points[i] for i in k])]
        return none(points, a, dice.choice(four)) if middle else None
    if len(found) == 1:
        return one(next(iter(found.values()))[0], next(iter(found)))
    (d, (on, _)), (e, (also_on, _)) = dice.sample([*found.items()], 2)
    return two(on, also_on, d, e)


class SupportsTest(unittest.TestCase):
    def test_each_line_has_its_planes(self):
        dice, twins = dice_of(1), Twins(self)
        while twins.count < some(300):
            points, a, b, at = some_case(dice)
            statement = honest(points, a, b, at, dice)
            if statement:
                is_segment = statement["verdict"] != "none" and dice.random() < .2
                self.assertEqual(twins.look(file_about(points, a, b, statement, is_segment)), "accepted", twins.last)
        twins.compare()

    def test_no_forced_claim_proves_another_plane(self):
        dice, twins, accepted = dice_of(2), Twins(self), 0
        while lacking(FORCED, "support"):
            points, a, b, at = some_case(dice)
            known, way = planes(points, a, b), minus(b, a)
            near = [*known, *(tuple(s * x for x in cross(way, minus(p, a))) for p in points for s in (1, -1)), way, (0, 0, 0)]
            for _ in range(4):
                d, e = (dice.choice([*known, *known, *near]) for _ in range(2))
                if len(known) == 2 and dice.random() < .5:
                    d, e = known
                sets = [known[x][0] if x in known and dice.random() < .9 else
                        sorted(dice.sample(range(len(points)), dice.randint(0, 3))) for x in (d, e)]
                spanning = [dice.randrange(len(points)) for _ in range(4)]
                options = [two(*sets, d, e), one(sets[0], d), none(points, a, spanning)]
                statement = options[min(len(known) + 1, 3) % 3] if dice.random() < .5 else dice.choice(options)
                said = twins.force(file_about(points, a, b, statement))
                if said == "accepted":
                    accepted += 1
                    self.assertTrue(is_true(points, a, b, statement, (d, e)), twins.last)
        twins.compare()
        self.assertTrue(some(100) < 100 or accepted > 0)

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(3), Twins(self)
        while lacking(MUTANT, "support"):
            points, a, b, at = some_case(dice)
            statement = honest(points, a, b, at, dice)
            if statement:
                twins.spoil(file_about(points, a, b, statement), dice)
        twins.compare()


if __name__ == "__main__":
    main()
