#!/usr/bin/env python3
"""Tests of statements about segments against fractions and brute force: python3 verifier/python/tests/test_segments.py."""
import itertools
import math
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some

COUNTS = {"nothing": ("shared-endpoint", "touch", "crossing", "overlap"), "shared-endpoint": ("touch", "crossing", "overlap"),
          "touch": ("crossing", "overlap")}


def kind_of(s, t):
    """How two segments meet, by the parameters of what they share."""
    (ax, ay), (bx, by) = s
    (cx, cy), (dx, dy) = t
    ux, uy, vx, vy, wx, wy = bx - ax, by - ay, dx - cx, dy - cy, cx - ax, cy - ay
    across = ux * vy - uy * vx
    if across:
        p, q = Fraction(wx * vy - wy * vx, across), Fraction(wx * uy - wy * ux, across)
        if not (0 <= p <= 1 and 0 <= q <= 1):
            return None
        return ("crossing", "touch", "shared-endpoint")[(p in (0, 1)) + (q in (0, 1))]
    if (ux, uy) == (0, 0):
        s, t = t, s
        (ax, ay), (ux, uy) = s[0], (s[1][0] - s[0][0], s[1][1] - s[0][1])
    if (ux, uy) == (0, 0):
        return "shared-endpoint" if s == t else None
    if any(ux * (y - ay) != uy * (x - ax) for x, y in t):
        return None
    p, q = sorted(Fraction(ux * (x - ax) + uy * (y - ay), ux * ux + uy * uy) for x, y in t)
    p, q = max(p, 0), min(q, 1)
    if p > q:
        return None
    if p < q:
        return "overlap"
    return "shared-endpoint" if p in (0, 1) and (ax + p * ux, ay + p * uy) in t else "touch"


def is_on(s, p):
    (ax, ay), (bx, by) = s
    return ax <= p[0] <= bx and (bx - ax) * (p[1] - ay) == (by - ay) * (p[0] - ax) and (ax, ay) <= p <= (bx, by)


def above(s, p):
    (ax, ay), (bx, by) = s
    return (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)


def crossings(edges):
    """Of each two edges, not parallel, that have a common point: the first one, and as which part of it the point comes."""
    for ((ax, ay), (bx, by)), ((cx, cy), (dx, dy)) in itertools.combinations(edges, 2):
        across = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
        p, q = (cx - ax) * (dy - cy) - (cy - ay) * (dx - cx), (cx - ax) * (by - ay) - (cy - ay) * (bx - ax)
        if across and 0 <= p * across <= across * across and 0 <= q * across <= across * across:
            yield (ax, ay), (bx - ax, by - ay), p, across


def factor_of(edges):
    """By so much must edges be stretched that crossings, and middles between these, are whole numbers."""
    return 2 * math.lcm(*(across // math.gcd(p, across) for _, _, p, across in crossings(edges)))


def stretched(edges, factor):
    return [((ax * factor, ay * factor), (bx * factor, by * factor)) for (ax, ay), (bx, by) in edges]


def sweep(segments):
    """The events of the sweep, from the definition: at each point what goes on, sorted by slope."""
    segments = stretched(segments, factor_of(segments))
    points = {end for s in segments for end in s}
    points |= {(x + p * ux // across, y + p * uy // across) for (x, y), (ux, uy), p, across in crossings(segments)}

    def slope(i):
        (ax, ay), (bx, by) = segments[i]
        return Fraction(by - ay, bx - ax) if bx != ax else Fraction(10 ** 9)

    events, line = [], []
    for p in sorted(points):
        lower = [i for i in line if above(segments[i], p) > 0]
        upper = [i for i in line if above(segments[i], p) < 0]
        on = [i for i in line if above(segments[i], p) == 0]
        row = [i for i in on if segments[i][1] != p] + [i for i, s in enumerate(segments) if s[0] == p]
        row.sort(key=slope)
        ends = [2 * i + k for i, s in enumerate(segments) for k in (0, 1) if s[k] == p]
        events.append([ends[-1] if ends else -1, lower[-1] if lower else -1, *row])
        line = lower + [i for i in row if segments[i][0] != segments[i][1]] + upper
    return events


def certificate(segments, allowed, groups, events, verdict="none", **more):
    claim = {"none": "none_counts", "these": "these_count", "count": "number_counts"}[verdict]
    statement = {"question": "segments", "allowed": allowed, "verdict": verdict, **more,
                 "claims": [{"claim": claim, "events": events}]}
    if groups is not None:
        statement["groups"] = groups
    rows = [[hexadecimal(x) for point in s for x in point] for s in segments]
    return file_of({"segments": rows}, statement)


def contacts(segments, allowed, groups):
    """Those that count, by i, then j."""
    kinds = [[i, j, kind_of(segments[i], segments[j])] for i, j in itertools.combinations(range(len(segments)), 2)
             if groups is None or groups[i] != groups[j]]
    return [c for c in kinds if c[2] in COUNTS[allowed]]


def is_none(segments, allowed, groups):
    return not contacts(segments, allowed, groups)


def some_segments(dice):
    size = dice.choice([2, 3, 4, 6])

    def point():
        return dice.randint(0, size), dice.randint(0, size)
    return [tuple(sorted((point(), point()))) for _ in range(dice.randint(1, 6))]


def some_groups(segments, dice):
    return dice.choice([None, None, [dice.randint(0, 1) for _ in segments], [0] * len(segments)])


def some_of(segments, dice):
    """That two of them have a contact, which may be so; and whether it is."""
    groups, allowed = some_groups(segments, dice), dice.choice(list(COUNTS))
    i, j = dice.randrange(len(segments)), dice.randrange(len(segments))
    kind = kind_of(segments[i], segments[j]) if dice.random() < .8 else dice.choice(COUNTS["nothing"])
    point = tuple(Fraction(dice.randint(0, 12), dice.choice([1, 2, 3])) for _ in range(2))
    (ax, ay), (bx, by) = segments[i]
    (cx, cy), (dx, dy) = segments[j]
    across = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
    if across:
        k = Fraction((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx), across)
        point = ax + k * (bx - ax), ay + k * (by - ay)
    elif dice.random() < .9:
        point = tuple(map(Fraction, dice.choice([max(segments[i][0], segments[j][0]), segments[j][0]])))
    truth = (i != j and (groups is None or groups[i] != groups[j]) and kind in COUNTS[allowed] and
             kind == kind_of(segments[i], segments[j]) and is_on(segments[i], point) and is_on(segments[j], point))
    statement = {"question": "segments", "allowed": allowed, "verdict": "some", "i": i, "j": j,
                 "kind": kind or "touch", "point": [fraction(x) for x in point], "claims": [{"claim": "contact"}]}
    if groups is not None:
        statement["groups"] = groups
    return file_of({"segments": [[hexadecimal(x) for p in s for x in p] for s in segments]}, statement), truth


def forced(events, segments, dice):
    """The events with a few changes."""
    events = [list(event) for event in events]
    for _ in range(dice.randint(1, 3)):
        event, change = dice.choice(events), dice.randint(0, 5)
        if change == 0:
            event[dice.randrange(len(event))] = dice.randint(-1, 2 * len(segments) - 1)
        elif change == 1 and len(event) > 2:
            event.pop(dice.randrange(2, len(event)))
        elif change == 2:
            event.insert(dice.randint(2, len(event)), dice.randrange(len(segments)))
        elif change == 3 and len(event) > 3:
            i, j = dice.sample(range(2, len(event)), 2)
            event[i], event[j] = event[j], event[i]
        elif change == 4 and len(events) > 1:
            events.remove(event)
        elif change == 5:
            event[1] = dice.randint(-1, len(segments) - 1)
    return events


class SegmentsTest(unittest.TestCase):
    def test_the_sweep_is_accepted_where_none_counts_and_only_there(self):
        dice, twins = dice_of(1), Twins(self)
        for _ in range(some(600)):
            segments = some_segments(dice)
            groups, events = some_groups(segments, dice), sweep(segments)
            for allowed in COUNTS:
                wanted = "accepted" if is_none(segments, allowed, groups) else "none_counts"
                self.assertEqual(twins.look(certificate(segments, allowed, groups, events)), wanted, (segments, groups, allowed))
        twins.compare()
        self.assertTrue(some(100) < 100 or min(twins.tally().values()) > twins.count / 5)

    def test_lists_and_numbers_are_accepted_where_they_are_so(self):
        dice, twins = dice_of(5), Twins(self)
        for _ in range(some(600)):
            segments = some_segments(dice)
            groups, events = some_groups(segments, dice), sweep(segments)
            for allowed in COUNTS:
                listed = contacts(segments, allowed, groups)
                said = twins.look(certificate(segments, allowed, groups, events, "these", contacts=listed))
                self.assertEqual(said, "accepted", twins.last)
                false = [list(c) for c in listed]
                change = dice.randint(0, 2)
                if false and change == 0:
                    false.remove(dice.choice(false))
                elif false and change == 1:
                    c = dice.choice(false)
                    c[2] = dice.choice([k for k in COUNTS["nothing"] if k != c[2]])
                elif len(segments) > 1:
                    i, j = sorted(dice.sample(range(len(segments)), 2))
                    if [i, j] not in [c[:2] for c in listed]:
                        false = sorted(false + [[i, j, dice.choice(COUNTS["nothing"])]])
                if false != listed:
                    said = twins.look(certificate(segments, allowed, groups, events, "these", contacts=false))
                    self.assertEqual(said, "these_count", twins.last)
                number = max(0, len(listed) + dice.randint(-1, 1))
                said = twins.look(certificate(segments, allowed, groups, events, "count", number=number))
                self.assertEqual(said, "accepted" if number == len(listed) else "number_counts", twins.last)
        twins.compare()

    def test_no_forced_sweep_lists_what_is_not_so(self):
        dice, twins, accepted = dice_of(6), Twins(self), 0
        while {"these", "count"} & set(lacking(FORCED, "segments")):
            segments = some_segments(dice)
            groups, allowed = some_groups(segments, dice), dice.choice(list(COUNTS))
            events, truth = sweep(segments), contacts(segments, allowed, groups)
            for _ in range(4):
                listed = [c for c in truth if dice.random() < .8]
                false = forced(events, segments, dice)
                said = twins.force(certificate(segments, allowed, groups, false, "these", contacts=listed))
                self.assertTrue(truth == listed or said != "accepted", twins.last)
                accepted += said == "accepted"
                said = twins.force(certificate(segments, allowed, groups, false, "count", number=len(listed)))
                self.assertTrue(len(truth) == len(listed) or said != "accepted", twins.last)
        twins.compare()
        self.assertTrue(some(100) < 100 or accepted > 0)

    def test_a_contact_is_accepted_where_it_counts_and_is_as_stated(self):
        dice, twins = dice_of(4), Twins(self)
        while "some" in lacking(FORCED, "segments"):
            segments = some_segments(dice)
            if len(segments) > 1:
                top, truth = some_of(segments, dice)
                self.assertEqual(twins.force(top), "accepted" if truth else "contact", top)
        twins.compare()
        self.assertTrue(some(100) < 100 or min(twins.tally().values()) > twins.count / 20)

    def test_no_forced_sweep_proves_what_is_not_so(self):
        dice, twins, accepted = dice_of(2), Twins(self), 0
        while "none" in lacking(FORCED, "segments"):
            segments = some_segments(dice)
            groups, allowed = some_groups(segments, dice), dice.choice(list(COUNTS))
            events, truth = sweep(segments), is_none(segments, allowed, groups)
            for _ in range(8):
                said = twins.force(certificate(segments, allowed, groups, forced(events, segments, dice)))
                self.assertTrue(truth or said != "accepted", (segments, groups, allowed, twins.last))
                accepted += said == "accepted"
        twins.compare()
        self.assertTrue(some(100) < 100 or 0 < accepted < twins.count / 2)  # another order of two that overlap, another `at`

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(3), Twins(self)
        while lacking(MUTANT, "segments"):
            segments = some_segments(dice)
            top = certificate(segments, dice.choice(list(COUNTS)), some_groups(segments, dice), sweep(segments))
            listed = contacts(segments, "nothing", None)
            for top in (top, certificate(segments, "nothing", None, sweep(segments), "these", contacts=listed),
                        certificate(segments, "nothing", None, sweep(segments), "count", number=len(listed))):
                twins.spoil(top, dice)
            if len(segments) > 1:
                twins.spoil(some_of(segments, dice)[0], dice)
        twins.compare()

    def test_sweeps_by_hand(self):
        cross = [((0, 0), (4, 4)), ((0, 4), (4, 0))]
        events = [[0, -1, 0], [2, 0, 1], [-1, -1, 1, 0], [3, -1], [1, -1]]
        twins = Twins(self)
        for groups, changed, wanted in (
                ([5, 5], events, "accepted"),
                ([5, 6], events, "none_counts"),
                (None, events, "none_counts"),
                ([5, 5], [[1, -1, 1, 0] if e[0] == -1 else e for e in events], "sweep"),  # not at their crossing
                ([5, 5], [e for e in events if e[0] != -1], "sweep"),                     # not exchanged
                ([5, 5], [[-1, -1, 0, 1] if e[0] == -1 else e for e in events], "sweep"),
                ([5, 5], events[:-1], "sweep"),
                ([5, 5], events[1:], "sweep"),
                ([5, 5], [[0, -1, 0, 0]] + events[1:], "sweep"),
                ([5, 5], [], "sweep")):
            self.assertEqual(twins.look(certificate(cross, "nothing", groups, changed)), wanted, (groups, changed))
        # One is lost where it meets another one of its group, and later crosses one of another group.
        lost = [((0, 0), (4, 0)), ((1, 0), (1, 1)), ((3, -1), (3, 1))]
        events = [[0, -1, 0], [2, -1, 1], [3, -1], [4, -1, 2], [5, -1], [1, -1]]
        self.assertEqual(twins.look(certificate(lost, "nothing", [1, 1, 2], events)), "sweep")
        # Two of one group overlap, then part; a point of another group where they do.
        fork = [((0, 0), (4, 0)), ((1, 0), (3, 0)), ((2, 0), (2, 0))]
        events = [[0, -1, 0], [2, -1, 1, 0], [4, -1, 1, 0, 2], [3, -1, 0], [1, -1]]
        for groups, wanted in (([1, 1, 1], "accepted"), ([1, 1, 2], "none_counts"), ([1, 2, 1], "none_counts")):
            self.assertEqual(twins.look(certificate(fork, "nothing", groups, events)), wanted, groups)
        self.assertEqual(twins.look(certificate(fork, "touch", [1, 1, 2], events)), "accepted")
        self.assertEqual(twins.look(certificate(fork, "shared-endpoint", [1, 1, 2], events)), "none_counts")
        twins.compare()


if __name__ == "__main__":
    main()
