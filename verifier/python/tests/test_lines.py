#!/usr/bin/env python3
"""Tests of statements about lines, rays, segments and half-planes and what they have in common with hulls of points, and
which of these is nearest, against fractions: python3 verifier/python/tests/test_lines.py."""
import itertools
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some
from test_pairs import solution_or_proof

ENDS = {"line": (None, None), "ray": (0, None), "segment": (0, 1)}


def minus(p, q):
    return tuple(x - y for x, y in zip(p, q))


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def left(u):
    return -u[1], u[0]


def common_part(points, kind, a, b):
    """From where to where, as multiples of the way from a to b beyond a; None: nowhere."""
    way, found = minus(b, a), []
    for p, q in itertools.product(points, repeat=2):
        u, v = dot(left(way), minus(p, a)), dot(left(way), minus(q, a))
        if u * v <= 0:
            at = p if u == 0 else tuple(x + Fraction(u, u - v) * (y - x) for x, y in zip(p, q)) if u != v else q
            found.append(Fraction(dot(way, minus(at, a))) / dot(way, way))
    low, high = ENDS[kind]
    if not found or (low is not None and max(found) < low) or (high is not None and min(found) > high):
        return None
    return max([low, min(found)] if low is not None else [min(found)]), min([high, max(found)] if high is not None else [max(found)])


def body_of(kind, a, b):
    arrow = [hexadecimal(x) for x in (*a, *b)]
    body = {"name": kind, "points": [arrow[:2]] + [arrow[2:]] * (kind == "segment")}
    ways = [arrow, arrow[2:] + arrow[:2], [hexadecimal(x) for x in (*left(a), *left(b))]]
    return {**body, "ways": ways[:{"segment": 0, "ray": 1, "line": 2, "half-plane": 3}[kind]]}


def weights_of(points, point, dice):
    """Of points, if it is in their hull; else any."""
    found, _ = solution_or_proof([(*p, 1) for p in points], (*point, 1))
    found = found or [Fraction(dice.randint(0, 2), 2) for _ in points]
    return [[k, fraction(w)] for k, w in enumerate(found) if w] or [[0, "1"]]


def weights_on_line(kind, t):
    if kind == "segment":
        return [[0, fraction(1 - t)], [1, fraction(t)]]
    return [[0, "1"]] + ([[1, fraction(t)]] if t > 0 else [[2, fraction(-t)]] if t and kind == "line" else [])


def statement_of(points, kind, a, b, ends, directions, dice):
    places, claims = [tuple(x + t * y for x, y in zip(a, minus(b, a))) for t in ends], []
    for place, t in zip(places, ends):
        claims += [{"claim": "holds", "weights": weights_of(points, place, dice)},
                   {"claim": "holds", "weights": weights_on_line(kind, t)}]
    first, last = ([fraction(x) for x in place] for place in places)
    before, after = ([fraction(x) for x in direction] for direction in directions)
    return {"question": "common_part", "a": 0, "b": 1, "verdict": "between", "first": first, "last": last,
            "claims": [*claims, {"claim": "no_further", "before": before, "after": after}]}


def candidates(points, a, b):
    ways = [minus(q, p) for p, q in itertools.permutations(points, 2)] + [minus(b, a), minus(a, b)]
    return [w for way in ways for w in (way, left(way)) if any(w)]


def some_case(dice):
    """Points and a line, in units of their own."""
    unit = dice.choice([1, 1, Fraction(1, 4), 2])
    points = [(dice.randint(-2, 2) * unit, dice.randint(-2, 2) * unit) for _ in range(dice.randint(1, 5))]
    a = b = (0, 0)
    while a == b:
        a, b = (tuple(dice.randint(-2, 2) for _ in range(2)) for _ in range(2))
    return points, dice.choice([*ENDS]), a, b


def honest(points, kind, a, b, dice):
    """The statement about the common part; None where there is none."""
    ends, way, directions = common_part(points, kind, a, b), minus(b, a), []
    if not ends:
        return None
    for t, own, sign in zip(ends, ENDS[kind], (-1, 1)):
        place = tuple(x + t * y for x, y in zip(a, way))
        fit = [d for d in candidates(points, a, b) if sign * dot(d, way) > 0 and (
            t == own or all(dot(d, p) <= dot(d, place) for p in points))]
        directions.append(dice.choice(fit) if t != own else tuple(sign * x for x in way))
    return statement_of(points, kind, a, b, ends, directions, dice)


def nearest_of(points, kind, a, b, direction, i):
    return file_about(points, kind, a, b, {
        "question": "nearest", "a": 0, "b": 1, "verdict": "point", "i": i,
        "claims": [{"claim": "first_along", "direction": [fraction(x) for x in direction]}]})


def is_nearest(points, kind, a, b, i):
    """By distances: to the line; or how far beyond the half-plane, which is on the left."""
    heights = [dot(left(minus(b, a)), minus(p, a)) for p in points]
    if kind == "line":
        return (min(heights) >= 0 or max(heights) <= 0) and abs(heights[i]) == min(map(abs, heights))
    return kind == "half-plane" and heights[i] == max(heights)


def file_about(points, kind, a, b, statement):
    table = [{"name": "points", "points": [[hexadecimal(x) for x in p] for p in points]}, body_of(kind, a, b)]
    return file_of({"bodies": table}, statement)


class LinesTest(unittest.TestCase):
    def test_each_common_part_is_proved(self):
        dice, twins = dice_of(1), Twins(self)
        while twins.count < some(300):
            points, kind, a, b = some_case(dice)
            statement = honest(points, kind, a, b, dice)
            if statement:
                self.assertEqual(twins.look(file_about(points, kind, a, b, statement)), "accepted", twins.last)
        twins.compare()

    def test_no_forced_claim_proves_another_part(self):
        dice, twins, accepted = dice_of(2), Twins(self), 0
        while lacking(FORCED, "common_part"):
            points, kind, a, b = some_case(dice)
            truth, near = common_part(points, kind, a, b), candidates(points, a, b)
            ends = [*(truth or ()), Fraction(dice.randint(-2, 4), 2), Fraction(dice.randint(-2, 4), 2)]
            for _ in range(4):
                said, directions = sorted(dice.choices(ends, k=2)), dice.choices(near, k=2)
                if truth and dice.random() < .7:
                    known = honest(points, kind, a, b, dice)["claims"][-1]
                    said = list(truth) if dice.random() < .6 else said
                    directions = [[Fraction(x) for x in known[key]] if dice.random() < .8 else d
                                  for key, d in zip(("before", "after"), directions)]
                if kind == "segment" and not all(0 <= t <= 1 for t in said):
                    continue
                top = file_about(points, kind, a, b, statement_of(points, kind, a, b, said, directions, dice))
                if twins.force(top) == "accepted":
                    accepted += 1
                    self.assertEqual(tuple(said), truth, top)
        twins.compare()
        self.assertTrue(some(100) < 100 or accepted > 0)

    def test_nearest_points_are_nearest(self):
        dice, twins, accepted = dice_of(3), Twins(self), 0
        while lacking(FORCED, "nearest") or twins.count < some(400):
            points, _, a, b = some_case(dice)
            kind = dice.choice(["line", "line", "half-plane", "half-plane", "ray", "segment"])
            i, out = dice.randrange(len(points)), left(minus(b, a))
            heights = [dot(out, minus(p, a)) for p in points]
            honest_way = tuple(-x for x in out) if kind == "half-plane" or max(heights) <= 0 else out
            direction = dice.choice([honest_way, honest_way, out, minus(b, a), (0, 0)])
            said, truth = twins.force(nearest_of(points, kind, a, b, direction, i)), is_nearest(points, kind, a, b, i)
            self.assertTrue(truth or said != "accepted", twins.last)
            self.assertTrue(not truth or direction != honest_way or said == "accepted", twins.last)
            accepted += said == "accepted"
        twins.compare()
        self.assertTrue(some(100) < 100 or accepted > twins.count / 20)

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(4), Twins(self)
        while lacking(MUTANT, "common_part") or lacking(MUTANT, "nearest"):
            points, kind, a, b = some_case(dice)
            statement = honest(points, kind, a, b, dice)
            if statement:
                twins.spoil(file_about(points, kind, a, b, statement), dice)
            twins.spoil(nearest_of(points, "line", a, b, left(minus(b, a)), 0), dice)
        twins.compare()


if __name__ == "__main__":
    main()
