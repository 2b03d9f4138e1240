#!/usr/bin/env python3
"""Tests of statements about bodies that move, against an exact simplex method: python3 verifier/python/tests/test_motions.py."""
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some, spoilt_in_statements
from test_pairs import Body, solution_or_proof


class Moving:
    """A body, or an image of one, and where it is moved to: with its entries of the table, from index `first` on."""

    def __init__(self, dice, dimension, first):
        body, unit = Body(dice, dimension), [[int(r == c) for c in range(dimension)] for r in range(dimension)]
        self.is_image = dice.random() < .7
        self.linear = [[dice.randint(-1, 1) for _ in range(dimension)] for _ in range(dimension)] if dice.random() < .3 else unit
        if not self.is_image:
            self.linear = unit

        def place():
            return [dice.randint(-4, 4) for _ in range(dimension)]
        self.begin = place() if self.is_image else [0] * dimension
        self.end = self.begin if dice.random() < .2 else place()
        self.base, self.index = first, first + self.is_image
        self.to = self.index if self.end == self.begin else self.index + 1
        self.entries = [body.entry("body")]
        for at in ([self.begin] if self.is_image else []) + ([self.end] if self.to != self.index else []):
            self.entries.append({"name": "placed", "of": first, "linear": [hexadecimal(x) for row in self.linear for x in row],
                                 "translation": [hexadecimal(x) for x in at]})

        def turned(v):
            return [sum(a * b for a, b in zip(row, v)) for row in self.linear]
        self.points, self.ways = [turned(p) for p in body.points], [turned(w) for w in body.ways]


def first_contact(a, b):
    """The least time, weights of A's rows and B's, and a direction; or a direction that parts them all along."""
    size = len(a.begin)
    columns = [p + [1, 0, 0] for p in a.points] + [w + [0, 0, 0] for w in a.ways]
    columns += [[-x for x in p] + [0, 1, 0] for p in b.points] + [[-x for x in w] + [0, 0, 0] for w in b.ways]
    for here, there in ((a.begin, b.begin), (a.end, b.end)):
        columns.append([x - y for x, y in zip(here, there)] + [0, 0, 1])
    sides = [0] * size + [1, 1, 1]
    weights, proof = solution_or_proof(columns, sides)
    if weights is None:
        return None, None, None, proof[:size]
    # The least time, and the multipliers that prove it: both programs in one, which end at one value.
    rows, count = len(sides), len(columns)
    costs = [0] * (count - 1) + [1]
    both = []
    for k in range(count):          # a weight
        both.append(columns[k] + [0] * count + [costs[k]])
    for r in range(rows):           # a multiplier, in two parts
        for sign in (1, -1):
            both.append([0] * rows + [sign * column[r] for column in columns] + [-sign * sides[r]])
    for k in range(count):          # what a price is short of its cost
        both.append([0] * rows + [int(k == j) for j in range(count)] + [0])
    both.append([0] * rows + [0] * count + [1])
    best, _ = solution_or_proof(both, sides + costs + [0])
    multipliers = [best[count + 2 * r] - best[count + 2 * r + 1] for r in range(rows)]
    of_a, of_b = best[:len(a.points) + len(a.ways)], best[len(a.points) + len(a.ways):count - 2]
    return best[count - 1], of_a, of_b, multipliers[:size]


def holds_at(weights):
    return {"claim": "holds_at", "weights": [[k, fraction(w)] for k, w in enumerate(weights) if w]}


def some_file(dice):
    """A true file, and the least time; None: they are apart all along."""
    dimension = dice.choice([2, 3])
    a = Moving(dice, dimension, 0)
    b = Moving(dice, dimension, len(a.entries))
    start = {"question": "motion", "a": a.index, "b": b.index, "to_a": a.to, "to_b": b.to}
    time, of_a, of_b, direction = first_contact(a, b)
    direction = [fraction(x) for x in direction]
    if time is None:
        start.update(verdict="apart", claims=[{"claim": "parted_all_along", "direction": direction}])
    else:
        rows, at = a.points + a.ways, [x + time * (y - x) for x, y in zip(a.begin, a.end)]
        point = [sum(w * row[k] for w, row in zip(of_a, rows)) + at[k] for k in range(dimension)]
        start.update(verdict="first" if time else "meet", time=fraction(time), point=[fraction(x) for x in point],
                     claims=[holds_at(of_a), holds_at(of_b)])
        if time:
            start["claims"].append({"claim": "not_before", "direction": direction})
    return file_of({"bodies": a.entries + b.entries}, start), time


def is_true(one, time):
    said = Fraction(one["time"]) if "time" in one and "x" not in one["time"] else None
    return {"apart": time is None, "meet": time is not None and said is not None and said >= time,
            "first": time is not None and said == time != 0}[one["verdict"]]


def forced_statement(one, verdict, dice):
    """What the verdict would need, of what there is and of random numbers."""
    result = {key: one[key] for key in ("question", "a", "b", "to_a", "to_b")}
    size = len(one["point"]) if "point" in one else len(one["claims"][0]["direction"])
    directions = [claim["direction"] for claim in one["claims"] if "direction" in claim]
    direction = dice.choice(directions + [[str(dice.randint(-2, 2)) for _ in range(size)]])
    if verdict == "apart":
        return {**result, "verdict": verdict, "claims": [{"claim": "parted_all_along", "direction": direction}]}
    known = [claim["weights"] for claim in one["claims"] if "weights" in claim] or [[[0, "1"]]] * 2
    claims = [{"claim": "holds_at", "weights": weights} for weights in known]
    claims += [{"claim": "not_before", "direction": direction}] * (verdict == "first")
    times = [one["time"], one["time"], "0", "1", "1/2"] if "time" in one else ["0", "1", "1/2"]
    point = one.get("point", ["0"] * size)
    return {**result, "verdict": verdict, "time": dice.choice(times), "point": point, "claims": claims}


def ball(name, *point, radius="0x1p+0", kind="radius"):
    return {"name": name, "points": [[hexadecimal(x) for x in point]], kind: radius}


def moved(of, *by, linear=(1, 0, 0, 0, 1, 0, 0, 0, 1)):
    return {"name": "moved", "of": of, "linear": [hexadecimal(x) for x in linear],
            "translation": [hexadecimal(x) for x in by]}


class MotionsTest(unittest.TestCase):
    def test_each_motion_is_proved(self):
        dice, twins, times = dice_of(91), Twins(self), []
        for _ in range(some(400)):
            top, time = some_file(dice)
            times.append(time)
            self.assertEqual(twins.look(top), "accepted", top)
        twins.compare()
        if some(100) == 100:
            self.assertGreater(times.count(None), len(times) / 20)
            self.assertGreater(sum(time is not None and 0 < time < 1 for time in times), len(times) / 20)
            self.assertGreater(times.count(0), len(times) / 20)

    def test_no_forced_claim_proves_what_is_not_so(self):
        dice, twins = dice_of(92), Twins(self)
        while lacking(FORCED, "motion"):
            top, time = some_file(dice)
            honest = top["statements"][0]
            for verdict in lacking(FORCED, "motion"):
                one = forced_statement(honest, verdict, dice)
                if twins.force({**top, "statements": [one]}) == "accepted":
                    self.assertTrue(is_true(one, time), twins.last)
            forced = spoilt_in_statements(top, dice)
            one = forced["statements"][0] if forced["statements"] else None
            if isinstance(one, dict) and all(one.get(k) == honest[k] for k in ("a", "b", "to_a", "to_b")):
                if twins.force(forced) == "accepted" and "x" not in one.get("time", ""):
                    self.assertTrue(is_true(one, time), forced)
        twins.compare()

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(93), Twins(self)
        while lacking(MUTANT, "motion"):
            top, time = some_file(dice)
            one = top["statements"][0]
            if one["verdict"] in lacking(MUTANT, "motion"):
                twins.spoil(top, dice)
            if one["verdict"] == "first" and "meet" in lacking(MUTANT, "motion"):
                twins.spoil({**top, "statements": [{**one, "verdict": "meet", "claims": one["claims"][:2]}]}, dice)
        twins.compare()

    def test_balls(self):
        """Two balls of radius 1 pass by each other: they first meet where their centres are 2 apart."""
        twins = Twins(self)
        one = [[0, "1"]]

        def said(high, verdict, time, point, direction, entries=None, frm=None):
            bodies = entries or [ball("a", 0, 0, 0), ball("b", -4, high, 0), moved(1, 8, 0, 0)]
            holds = [{"claim": "holds_at", "weights": one, **({"from": start} if start else {})} for start in frm or (None, None)]
            start = {"question": "motion", "a": 0, "b": 1, "to_a": 0, "to_b": 2, "verdict": verdict}
            if verdict == "apart":
                claims = [{"claim": "parted_all_along", "direction": direction}]
            else:
                start.update(time=time, point=point)
                claims = holds + [{"claim": "not_before", "direction": direction}] * (verdict == "first")
            return twins.look(file_of({"bodies": bodies}, {**start, "claims": claims}))
        west, up = ["-1", "0", "0"], ["0", "1", "0"]
        self.assertEqual(said(0, "first", "1/4", west, west), "accepted")
        self.assertEqual(said(0, "meet", "1/4", west, None), "accepted")
        self.assertEqual(said(0, "first", "1/4", west, ["-1", "1/1000", "0"]), "not_before")
        self.assertEqual(said(0, "first", "1/4", west, ["0", "0", "0"]), "not_before")
        self.assertEqual(said(0, "first", "1/2", west, west), "not_before")
        self.assertEqual(said(0, "first", "3/4", ["1", "0", "0"], ["1", "0", "0"]), "not_before")  # the last time
        self.assertEqual(said(0, "meet", "1/5", west, None), "holds")
        self.assertEqual(said(0, "meet", "-1/4", west, None), "F")
        self.assertEqual(said(0, "meet", "5/4", west, None), "F")
        self.assertEqual(said(2, "meet", "1/2", up, None), "accepted")  # they touch in passing
        self.assertEqual(said(2, "first", "1/2", up, up), "not_before")  # along it they do not come nearer
        self.assertEqual(said(3, "apart", None, None, up), "accepted")
        self.assertEqual(said(2, "apart", None, None, up), "parted")
        self.assertEqual(said(3, "apart", None, None, ["1", "1", "0"]), "parted")  # at the begin
        self.assertEqual(said(3, "apart", None, None, ["-1", "1", "0"]), "parted")  # at the end
        # An ellipsoid, mapped at both ends: half as high as it is long.
        flat = [ball("a", 0, 0, 0, kind="ellipsoid"), ball("b", 0, 0, 0, kind="ellipsoid"),
                moved(1, -5, 0, 0, linear=(2, 0, 0, 0, 1, 0, 0, 0, 1)), moved(1, 5, 0, 0, linear=(2, 0, 0, 0, 1, 0, 0, 0, 1))]
        claims = [{"claim": "holds_at", "weights": one, "from": west}, {"claim": "holds_at", "weights": one, "from": ["1", "0", "0"]},
                  {"claim": "not_before", "direction": west}]
        start = {"question": "motion", "a": 0, "b": 2, "to_a": 0, "to_b": 3, "verdict": "first", "time": "1/5", "point": west}
        self.assertEqual(twins.look(file_of({"bodies": flat}, {**start, "claims": claims})), "accepted")
        self.assertEqual(twins.look(file_of({"bodies": flat}, {**start, "time": "1/4", "claims": claims})), "holds")
        self.assertEqual(twins.look(file_of({"bodies": flat}, {**start, "claims": [
            *claims[:2], {"claim": "not_before", "direction": up}]})), "not_before")
        # What turns, or is another body, is no motion.
        for to_b in (0, 1):
            self.assertEqual(twins.look(file_of({"bodies": flat}, {**start, "to_b": to_b, "claims": claims})), "F")
        twins.compare()


if __name__ == "__main__":
    main()
