#!/usr/bin/env python3
"""Tests of sunder_verify_polygons.py: python3 verifier/test_sunder_verify_polygons.py."""
import itertools
import json
import os
import random
import sys
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import sunder_verify_polygons as polygons  # noqa: E402
from segment_sweeps import kind_by_fractions  # noqa: E402
from set_files import RULES, hexadecimal, outcome, refused_by  # noqa: E402

ALLOWED = {"nothing": (None,), "shared-endpoint": (None, "shared-endpoint")}


def edges_of(rings):
    return [tuple(sorted(edge)) for ring in rings for edge in zip(ring, ring[1:] + ring[:1])]


def sides_of(edges, x, y):
    """Is the inside just below the point, and just above it? Of a point that is no end of an edge; on a line that is
    upright, but for a turn to the left, by less than any other direction has."""
    below = here = False
    for (ax, ay), (bx, by) in edges:
        if (ax, ay) < (x, y) < (bx, by):
            side = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
            below ^= side > 0
            here ^= side == 0
    return below, below ^ here


def parts_of(edges):
    """Points in the middle of all parts into which the edges part each other."""
    for s in edges:
        (ax, ay), (bx, by) = s
        if s[0] == s[1]:
            continue
        at = {Fraction(0), Fraction(1)}
        for t in edges:
            ux, uy, vx, vy = bx - ax, by - ay, t[1][0] - t[0][0], t[1][1] - t[0][1]
            across = ux * vy - uy * vx
            if across:
                wx, wy = t[0][0] - ax, t[0][1] - ay
                part = Fraction(wx * vy - wy * vx, across)
                at |= {part} if 0 < part < 1 and 0 <= Fraction(wx * uy - wy * ux, across) <= 1 else set()
            elif kind_by_fractions(s, t):
                at |= {Fraction((x - ax) * ux + (y - ay) * uy, ux * ux + uy * uy) for x, y in t
                       if s[0] < (x, y) < s[1]}
        at = sorted(at)
        for p, q in zip(at, at[1:]):
            yield ax + (p + q) / 2 * (bx - ax), ay + (p + q) / 2 * (by - ay)


def meet(a, b, allowed):
    """Do two polygons meet in a way that counts? An edge that is inside of the other polygon counts always."""
    if allowed != "touch" and any(kind_by_fractions(s, t) not in ALLOWED[allowed] for s in a for t in b):
        return True
    for x, y in parts_of(a + b):
        (a_below, a_above), (b_below, b_above) = sides_of(a, x, y), sides_of(b, x, y)
        if (a_below and b_below) or (a_above and b_above):
            return True
        if allowed != "touch":
            on_a, on_b = (any(kind_by_fractions(s, ((x, y), (x, y))) for s in edges) for edges in (a, b))
            if (on_a and not on_b and b_below) or (on_b and not on_a and a_below):
                return True
    return False


def transcript(table):
    """The sweep, without looking for contacts. Of two edges on one line that with the inside above it is above."""
    edges = [edge for polygon in table for edge in polygon]
    of = [i for i, polygon in enumerate(table) for _ in polygon]

    def turn(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    def inside_is_above(s):
        middles = (Fraction(p + q, 2) for p, q in zip(*edges[s]))
        return sides_of(table[of[s]], *middles)[1]

    def is_above(s, t):
        side = turn(*edges[t], edges[s][0]) or turn(*edges[t], edges[s][1])
        return side > 0 or (side == 0 and inside_is_above(s))

    def rank(event):
        a, b = edges[event // 2]
        return (a, b)[event % 2], (1 if a == b else 0 if event % 2 else 2), event

    events, line, below = sorted(range(2 * len(edges)), key=rank), [], []
    for event in events:
        s = event // 2
        if event % 2:
            line.remove(s)
            continue
        at = sum(is_above(s, t) for t in line)
        below.append(line[at - 1] if at else -1)
        line.insert(at, s)
    return events, below


def is_simple(ring):
    """No two edges meet but in the vertex between them."""
    edges = edges_of([ring])
    for i, j in itertools.combinations(range(len(edges)), 2):
        are_next = j - i in (1, len(edges) - 1)
        if kind_by_fractions(edges[i], edges[j]) != ("shared-endpoint" if are_next else None):
            return False
    return len(set(ring)) == len(ring)


def some_ring(rng, x, y, reach):
    while True:
        ring = [(x + rng.randint(-reach, reach), y + rng.randint(-reach, reach)) for _ in range(rng.randint(3, 5))]
        if is_simple(ring):
            return ring


def some_polygons(rng):
    """Valid polygons: simple ones, cells of a grid among them, some with a hole, and what lies in holes; holes that touch
    the shell or one another, a shell that touches itself; some vertices are repeated."""
    table, side, reach = [], rng.choice((3, 6, 9)), rng.choice((1, 2))
    for _ in range(rng.randint(1, 5)):
        x, y = rng.randint(0, side), rng.randint(0, side)
        what = rng.randrange(6)
        if what == 4:
            table.append([[(x - 4, y - 4), (x + 4, y - 4), (x + 4, y + 4), (x - 4, y + 4)],
                          [(x + 4, y + rng.randint(-3, 3)), (x + 1, y + 1), (x + 1, y - 1)],
                          [(x + 1, y + 1), (x - 1, y + rng.randint(1, 3)), (x - rng.randint(1, 3), y)]])
        elif what == 5:
            table.append([[(x - 4, y - 4), (x + 4, y - 4), (x + 4, y + 4), (x - 4, y + 4), (x - 4, y),
                           (x + 1, y + rng.randint(1, 3)), (x + 1, y - rng.randint(1, 3)), (x - 4, y)]])
        elif what == 0:
            x, y = 2 * (x // 2), 2 * (y // 2)
            table.append([[(x, y), (x + 2, y), (x + 2, y + 2), (x, y + 2)]])
        elif what == 1:
            table.append([[(x - 5, y - 4), (x + 5, y - 4), (x + 4, y + 5), (x - 4, y + 5)],
                          some_ring(rng, x, y, reach)])
        else:
            table.append([some_ring(rng, x, y, reach)])
        while rng.randrange(3) == 0:
            ring = rng.choice(table[-1])
            ring.insert(at := rng.randrange(len(ring)), ring[at])
    return [edges_of(rings) for rings in table]


def any_meet(table, allowed):
    return any(meet(a, b, allowed) for a, b in itertools.combinations(table, 2))


class Polygons(unittest.TestCase):
    def test_places(self):
        rng, count = random.Random(21), {}
        for _ in range(3000):
            ring = [(rng.randint(0, 4), rng.randint(0, 4)) for _ in range(rng.randint(3, 7))]
            edges, x, y, w = edges_of([ring]), rng.randint(0, 8), rng.randint(0, 8), 2
            p = Fraction(x, w), Fraction(y, w)
            kinds = {kind_by_fractions(edge, (p, p)) for edge in edges} - {None}
            place = ("edge" if kinds - {"shared-endpoint"} else "vertex" if kinds else
                     "inside" if sides_of(edges, *p)[0] else "outside")
            self.assertEqual(polygons.place_in(edges, (x, y, w)), place, (ring, p))
            count[place] = count.get(place, 0) + 1
        self.assertEqual(len(count), 4)
        self.assertGreater(min(count.values()), 100, count)

    def test_a_transcript_is_accepted_if_and_only_if_none_meet(self):
        rng, count = random.Random(22), {}
        for _ in range(1500):
            table, allowed = some_polygons(rng), rng.choice(RULES)
            check = refused_by(lambda: polygons.check_none(table, allowed, *transcript(table)))
            self.assertEqual(check is None, not any_meet(table, allowed), (table, allowed, check))
            count[check] = count.get(check, 0) + 1
            count[allowed, check is None] = count.get((allowed, check is None), 0) + 1
        self.assertGreater(min(count[check] for check in (None, "T4", "T5")), 100, count)
        self.assertGreater(min(count[rule, is_none] for rule in RULES for is_none in (True, False)), 50, count)

    def test_no_transcript_at_all_proves_what_is_not_true(self):
        rng, count = random.Random(23), {}
        for _ in range(5000):
            table, allowed = some_polygons(rng), rng.choice(RULES)
            if len(table) < 2:
                continue
            events, below = transcript(table)
            change = rng.randrange(4)
            if change == 0:
                below[rng.randrange(len(below))] = rng.randint(-1, len(below) - 1)
            elif change == 1:
                events.insert(rng.randrange(len(events)), events.pop(rng.randrange(len(events))))
            elif change == 2:  # any two rings, that may cross themselves and one another
                size, reach = len(rng.choice(table)), rng.choice((2, 6))
                i = rng.randrange(len(table))
                table[i] = edges_of([[(rng.randint(0, reach), rng.randint(0, reach)) for _ in range(size)]])
                if rng.randrange(2):
                    events, below = transcript(table)
            else:
                events, below = transcript(table)
                i = rng.randrange(len(table))  # over all others
                table[i] = [tuple(sorted(((ax + 1, ay), (bx + 1, by)))) for (ax, ay), (bx, by) in table[i]]
            check = refused_by(lambda: polygons.check_none(table, allowed, events, below))
            free = check is not None or not any_meet(table, allowed)
            self.assertTrue(free, (table, allowed, events, below))
            count[check] = count.get(check, 0) + 1
        for check in (None, "T1", "T2", "T3", "T4", "T5"):
            self.assertGreater(count.get(check, 0), 30, count)

    def test_files_and_the_check_that_each_fails(self):
        frame = [[(0, 0), (8, 0), (8, 8), (0, 8)], [(2, 2), (2, 6), (6, 6), (6, 2)]]
        tile, kite, low = [[(8, 0), (9, 4), (8, 8)]], [[(6, 6), (7, 5), (7, 7)]], [[(4, 3), (5, 4), (3, 5)]]

        def found(statement, change, table=(frame, tile, kite, low)):
            rows = [[[[hexadecimal(n) for n in p] for p in ring] for ring in rings] for rings in table]
            return outcome(json.dumps({"sunder_set_certificate": 1, "polygons": rows,
                                       "statements": [{**statement, **change}]}).encode())

        some = {"question": "polygons_any", "allowed": "nothing", "verdict": "some", "i": 0, "j": 2,
                "point": ["27/4", "6"]}
        for rule in RULES:
            self.assertEqual(found(some, {"allowed": rule}), "-")
            self.assertEqual(found(some, {"allowed": rule, "point": ["6", "6"]}),
                             {"nothing": "-", "shared-endpoint": "C3", "touch": "C3"}[rule])
            self.assertEqual(found(some, {"allowed": rule, "j": 1, "point": ["8", "3/2"]}),
                             {"nothing": "-", "shared-endpoint": "-", "touch": "C3"}[rule])
        self.assertEqual(found(some, {"groups": [5, 4, 5, 4]}), "C1")
        self.assertEqual(found(some, {"groups": [5, 5, 4, 4]}), "-")
        self.assertEqual(found(some, {"point": ["4", "4"]}), "C2")
        self.assertEqual(found(some, {"point": ["1", "1"]}), "C2")
        self.assertEqual(found(some, {"j": 3, "point": ["4", "4"]}), "C2")  # in the hole
        for change in ({"i": 2}, {"j": 4}, {"point": ["1"]}, {"groups": [1, 2]}, {"verdict": "many"},
                       {"allowed": "all"}):
            self.assertEqual(found(some, change), "F", change)
        for ring in ([(0, 0), (1, 0)], [(1, 1)] * 3, [(0, 0, 0), (1, 0, 0), (0, 1, 0)]):
            self.assertEqual(found(some, {}, (frame, tile, kite, [ring])), "F")
        self.assertEqual(found(some, {}, (frame, tile, kite, [])), "F")

        def swept(*rings):
            events, below = transcript([edges_of(of_one) for of_one in rings])
            return {"question": "polygons_any", "allowed": "nothing", "verdict": "none", "events": events,
                    "below": below}

        apart = frame, [[(9, 0), (9, 4), (10, 8)]], low
        none = swept(*apart)
        self.assertEqual(found(none, {}, apart), "-")
        self.assertEqual(found(none, {"groups": [1, 2, 3]}, apart), "F")
        self.assertEqual(found(none, {"below": none["below"][1:]}, apart), "F")
        self.assertEqual(found(none, {"events": none["events"][::-1]}, apart), "T1")
        self.assertEqual(found(none, {"below": [13] + none["below"][1:]}, apart), "T2")
        self.assertEqual(found(none, {"below": [-1] * len(none["below"])}, apart), "T3")
        for table, checks in (((frame, tile), ("T1", "T4", "-")),       # a border in common
                              ((frame, kite), ("T1", "T5", "T5")),      # from corner to inside
                              ((frame, [[(2, 2), (4, 3), (3, 4)]]), ("T1", "-", "-")),  # at corners only
                              ((frame, [[(6, 4), (4, 3), (3, 4)]]), ("T4", "T4", "-")),  # a corner on a side
                              ((frame, [[(-1, 1), (1, 3), (-1, 3)]]), ("T4", "T4", "T4")),  # across
                              ((frame, [[(1, 3), (1, 5), (0.5, 4)]]), ("T5", "T5", "T5")),  # inside, without contact
                              ((low, frame[:1]), ("T5", "T5", "T5"))):
            table = [[[(int(2 * x), int(2 * y)) for x, y in ring] for ring in rings] for rings in table]
            statement = swept(*table)
            for rule, check in zip(RULES, checks):
                self.assertEqual(found(statement, {"allowed": rule}, table), check, (table, rule))

    def test_a_ring_through_another_one_of_its_polygon(self):
        # The second ring crosses a side of the first at a vertex: then no edge keeps its side.
        table = [edges_of([[(0, 0), (8, 0), (8, 8), (0, 8)], [(4, 0), (6, 3), (2, -3)]])]
        self.assertEqual(refused_by(lambda: polygons.check_none(table, "nothing", *transcript(table))), "T4")
        # Edges that lie on one another end to be a pair where a ring around them ends at one of their points.
        table = [edges_of([[(-4, -3), (4, 0), (-4, 3)], [(0, 0), (8, 0), (9, 0)]])]
        self.assertEqual(refused_by(lambda: polygons.check_none(table, "touch", *transcript(table))), "T5")
        # Between edges that have crossed, by a list that has them as they were before, another polygon is outside.
        table = [edges_of([[(0, 0), (8, 8), (8, 0), (0, 8)]]), edges_of([[(6, 4), (7, 4), (7, 5)]])]
        self.assertTrue(any_meet(table, "touch"))
        events = [0, 6, 7, 4, 8, 12, 9, 10, 11, 13, 5, 2, 1, 3]
        self.assertEqual(refused_by(lambda: polygons.check_none(table, "touch", events, [-1, 0, 0, -1, 4, -1, -1])),
                         "T4")
        # A corner of another polygon is on a side where a hole has a corner too, and in the hole.
        table = [edges_of([[(0, 0), (8, 0), (8, 8), (0, 8)], [(4, 0), (6, 3), (2, 3)]]),
                 edges_of([[(4, 0), (5, 2), (4, 2)]])]
        self.assertEqual([refused_by(lambda: polygons.check_none(table, rule, *transcript(table))) for rule in RULES],
                         ["T1", "T6", None])
        self.assertTrue(any_meet(table, "shared-endpoint") and not any_meet(table, "touch"))


if __name__ == "__main__":
    unittest.main()
