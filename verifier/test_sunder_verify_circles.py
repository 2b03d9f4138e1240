#!/usr/bin/env python3
"""Tests of sunder_verify_circles.py: python3 verifier/test_sunder_verify_circles.py."""
import itertools
import json
import math
import os
import random
import sys
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import sunder_verify_circles as circles  # noqa: E402
from set_files import RULES, as_file, hexadecimal, outcome, refused_by  # noqa: E402


# ---- Circles.

def disc_kind(c, d):
    """How discs meet, another way: by comparing the distance of the centres, a root, with sums of radii."""
    distance2 = (c[0] - d[0]) ** 2 + (c[1] - d[1]) ** 2

    def compare(r):  # the distance with r
        return 1 if r < 0 else (distance2 > r * r) - (distance2 < r * r)

    if compare(c[2] + d[2]) >= 0:
        return "touching" if compare(c[2] + d[2]) == 0 else None
    return "overlapping" if compare(c[2] - d[2]) > 0 and compare(d[2] - c[2]) > 0 else "inside"


def some_discs(rng):
    side, most = rng.choice((4, 8, 16)), rng.choice((0, 1, 2, 4))
    return [(rng.randint(0, side), rng.randint(0, side), rng.randint(0, most)) for _ in range(rng.randint(1, 7))]


def disc_transcript(discs):
    events = sorted(range(2 * len(discs)),
                    key=lambda e: (discs[e // 2][0] + (1 if e % 2 else -1) * discs[e // 2][2], e % 2))
    line, below = [], []
    for event in events:
        s = event // 2
        if event % 2:
            line.remove(s)
        else:
            at = sum(discs[t][1] <= discs[s][1] for t in line)
            below.append(line[at - 1] if at else -1)
            line.insert(at, s)
    return events, below


def is_free(discs, allowed):
    return all(circles.may_meet(disc_kind(c, d), allowed) for c, d in itertools.combinations(discs, 2))


class Circles(unittest.TestCase):
    def test_kinds(self):
        rng, seen = random.Random(1), {}
        for _ in range(5000):
            c, d = ((rng.randint(0, 5), rng.randint(0, 5), rng.randint(0, 4)) for _ in range(2))
            kind = disc_kind(c, d)
            self.assertEqual(circles.kind_of(c, d), kind, (c, d))
            seen[kind] = seen.get(kind, 0) + 1
        self.assertGreater(min(seen[k] for k in circles.KINDS + (None,)), 200, seen)

    def test_a_transcript_is_accepted_if_and_only_if_nothing_counts(self):
        rng, count = random.Random(2), {}
        for _ in range(10000):
            discs, allowed = some_discs(rng), rng.choice(RULES)
            free = is_free(discs, allowed)
            check = refused_by(lambda: circles.check_none(discs, allowed, *disc_transcript(discs)))
            self.assertEqual(check, None if free else "T4", (discs, allowed))
            key = allowed, free, any(disc_kind(c, d) for c, d in itertools.combinations(discs, 2))
            count[key] = count.get(key, 0) + 1
        for key in (("nothing", True, False), ("nothing", False, True), ("touch", True, True), ("touch", False, True)):
            self.assertGreater(count[key], 100, (key, count))

    def test_no_transcript_at_all_proves_what_is_not_true(self):
        rng, refused = random.Random(3), {}
        for _ in range(20000):
            discs, allowed = some_discs(rng), rng.choice(RULES)
            free, (events, below) = is_free(discs, allowed), disc_transcript(discs)
            for _ in range(rng.randint(1, 3)):
                what = rng.randrange(4)
                i, j = rng.randrange(len(events)), rng.randrange(len(events))
                if what == 0:
                    below[rng.randrange(len(below))] = rng.randint(-1, len(discs) - 1)
                elif what == 1:
                    events[i], events[j] = events[j], events[i]
                elif what == 2:
                    events[i] = events[j]
                else:
                    events.insert(j, events.pop(i))
            check = refused_by(lambda: circles.check_none(discs, allowed, events, below))
            self.assertTrue(free or check, (discs, allowed, events, below))
            refused[check, free] = refused.get((check, free), 0) + 1
        for check in ("T1", "T2", "T3"):
            self.assertGreater(refused[check, True], 100, refused)
            self.assertGreater(refused[check, False], 30, refused)

    def test_no_transcript_of_few_proves_what_is_not_true(self):
        """All orders and places of up to three discs."""
        rng, accepted = random.Random(4), 0
        for _ in range(40):
            n = rng.randint(1, 3) if rng.randrange(4) else 2
            discs = [(rng.randint(0, 3), rng.randint(0, 2), rng.randint(0, 1)) for _ in range(n)]
            for allowed in ("nothing", "touch"):
                free, found = is_free(discs, allowed), 0
                for events in itertools.permutations(range(2 * n)):
                    if refused_by(lambda: circles.check_order(discs, list(events))):
                        continue
                    for below in itertools.product(range(-1, n), repeat=n):
                        check = refused_by(lambda: circles.check_none(discs, allowed, list(events), list(below)))
                        self.assertTrue(free or check, (discs, allowed, events, below))
                        found += check is None
                self.assertEqual(found > 0, free, (discs, allowed))
                accepted += found
        self.assertGreater(accepted, 30)

    def test_files_and_the_check_that_each_fails(self):
        discs = [(0, 0, 3), (5, 0, 2), (9, 0, 3), (9, 1, 1), (0, 9, 0)]
        touch = {"question": "circles_any", "allowed": "nothing", "verdict": "some", "i": 0, "j": 1,
                 "kind": "touching", "point": ["3", "0"]}
        lens = {**touch, "i": 1, "j": 2, "kind": "overlapping", "point": ["13/2", "1/2"]}
        nested = {**touch, "i": 3, "j": 2, "kind": "inside", "point": ["9", "1"]}

        def found(statement, discs=discs):
            return outcome(as_file("circles", discs, statement))

        for statement in (touch, lens, nested, {**lens, "allowed": "touch"},
                          {**touch, "groups": [1, 2, 1, 1, 1]}, {**nested, "i": 2, "j": 3}):
            self.assertEqual(found(statement), "-", statement)
        self.assertEqual(found({**touch, "allowed": "touch"}), "C1")
        self.assertEqual(found({**touch, "allowed": "shared-endpoint"}), "C1")
        self.assertEqual(found({**touch, "groups": [1, 1, 2, 3, 4]}), "C1")
        for point in (["3", "1/1000000"], ["2", "0"], ["4", "0"], ["0x1.8000000000001p+1", "0"], ["-3", "0"]):
            self.assertEqual(found({**touch, "point": point}), "C2", point)
        for statement in (touch, lens, nested):
            for kind in circles.KINDS:
                if kind != statement["kind"]:
                    self.assertEqual(found({**statement, "kind": kind}), "C3", statement)
        for change in ({"j": 0}, {"j": 5}, {"kind": "crossing"}, {"kind": None}, {"allowed": "all"}, {"verdict": "one"},
                       {"point": ["3"]}, {"groups": [1]}, {"groups": [1, 2, 3, 4, 10 ** 15]}, {"i": True},
                       {"question": "segments_any"}, {"question": "circles_all"}):
            self.assertEqual(found({**touch, **change}), "F", change)
        self.assertEqual(found(touch, [(0, 0, -3)] + discs[1:]), "F")
        self.assertEqual(found(touch, [(0, 0)] + discs[1:]), "F")

        apart = [(0, 0, 3), (4, 5, 2), (9, 0, 3), (4, 5, 0)]
        none = {"question": "circles_any", "allowed": "nothing", "verdict": "none", "events": [0, 2, 1, 4, 3, 5],
                "below": [-1, 0, -1]}
        self.assertEqual(found(none, apart[:3]), "-")
        self.assertEqual(found({**none, "events": [0, 2, 1, 3, 4, 5]}, apart[:3]), "T1")  # 3 and 4 are at 6
        self.assertEqual(found({**none, "events": [2, 0, 1, 4, 3, 5]}, apart[:3]), "T1")
        self.assertEqual(found({**none, "events": [0, 2, 1, 4, 3, 3]}, apart[:3]), "T1")
        self.assertEqual(found({**none, "events": [0, 2, 1, 4, 3]}, apart[:3]), "T1")
        self.assertEqual(found({**none, "below": [-1, 2, -1]}, apart[:3]), "T2")
        self.assertEqual(found({**none, "below": [-1, -1, -1]}, apart[:3]), "T3")
        self.assertEqual(found({**none, "below": [-1, 0, 0]}, apart[:3]), "T2")
        self.assertEqual(found({**none, "events": [0, 2, 1, 6, 7, 4, 3, 5], "below": [-1, 0, 1, -1]}, apart), "T4")
        self.assertEqual(found({**none, "below": [-1, 0]}, apart[:3]), "F")
        self.assertEqual(found({**none, "events": [0, 2, 1, 4, 3, 6]}, apart[:3]), "F")
        self.assertEqual(found({**none, "groups": [1, 2, 3]}, apart[:3]), "F")


# ---- The common part of circles.

def deepest(discs):
    """The weights of the point of least power among those where up to three discs have one power, or None."""
    n = len(discs)
    power = [x * x + y * y - r * r for x, y, r in discs]
    if n == 1:
        return [Fraction(1)]
    dx, dy = discs[1][0] - discs[0][0], discs[1][1] - discs[0][1]
    if n == 2:
        if dx == dy == 0:
            return None
        # 2 p . d = power[1] - power[0], with p = first centre + w d.
        w = Fraction(power[1] - power[0] - 2 * (discs[0][0] * dx + discs[0][1] * dy), 2 * (dx * dx + dy * dy))
        return [1 - w, w]
    ex, ey = discs[2][0] - discs[0][0], discs[2][1] - discs[0][1]
    area = dx * ey - dy * ex
    if not area:
        return None
    s, t = Fraction(power[1] - power[0], 2), Fraction(power[2] - power[0], 2)
    px, py = (s * ey - t * dy) / area - discs[0][0], (t * dx - s * ex) / area - discs[0][1]
    v, w = (px * ey - py * ex) / area, (dx * py - dy * px) / area
    return [1 - v - w, v, w]


def common_statements(discs):
    """All evidence that up to three discs name."""
    n = range(len(discs))
    for m in (1, 2, 3):
        for names in itertools.combinations(n, m):
            weights = deepest([discs[k] for k in names])
            if weights is None:
                continue
            point = [sum(w * discs[k][axis] for w, k in zip(weights, names)) for axis in (0, 1)]
            yield {"question": "circles", "verdict": "region", "point": [str(x) for x in point]}
            for verdict in ("empty", "point"):
                yield {"question": "circles", "verdict": verdict, "discs": list(names),
                       "weights": [str(w) for w in weights]}


def refusal_of_common(discs, item):
    table = circles.Table({"circles": [[hexadecimal(n) for n in disc] for disc in discs]})
    return refused_by(lambda: table.read_common(item, "x")[3]())


def true_common(discs):
    """The statements that are accepted: all must be of one verdict."""
    return [item for item in common_statements(discs) if refusal_of_common(discs, item) is None]


class CommonParts(unittest.TestCase):
    @staticmethod
    def some(rng):
        side, most = rng.choice((2, 4, 6)), rng.choice((2, 3, 5))
        return [(rng.randint(0, side), rng.randint(0, side), rng.randint(0 if rng.randrange(4) == 0 else 1, most))
                for _ in range(rng.randint(1, 5))]

    def test_each_set_has_evidence_of_one_verdict(self):
        rng, count = random.Random(10), {}
        for _ in range(1200):
            discs = self.some(rng)
            verdicts = {item["verdict"] for item in true_common(discs)}
            self.assertEqual(len(verdicts), 1, discs)
            verdict = verdicts.pop()
            found = sum(all((Fraction(x, 4) - cx) ** 2 + (Fraction(y, 4) - cy) ** 2 <= r * r for cx, cy, r in discs)
                        for x in range(25) for y in range(25)) if _ % 10 == 0 else None
            if found is not None and verdict != "region":
                self.assertLessEqual(found, verdict == "point", discs)
            count[verdict] = count.get(verdict, 0) + 1
        self.assertGreater(min(count[v] for v in ("empty", "point", "region")), 60, count)

    def test_mutations(self):
        rng, count = random.Random(11), {}
        for _ in range(700):
            discs = self.some(rng)
            items = true_common(discs)
            for _ in range(5):
                item, d = json.loads(json.dumps(rng.choice(items))), list(discs)
                what, i = rng.randrange(4), rng.randrange(len(d))
                if what == 0:
                    d[i] = tuple(max(0, n + rng.randint(-1, 1)) for n in d[i])
                elif what == 1:
                    item["verdict"] = rng.choice(("empty", "point", "region", "plane"))
                elif "point" in item:
                    item["point"][rng.randrange(2)] = str(Fraction(rng.randint(-8, 32), 4))
                elif what == 2:
                    item["discs"][rng.randrange(len(item["discs"]))] = i
                else:
                    item["weights"][rng.randrange(len(item["weights"]))] = str(Fraction(rng.randint(-2, 6), 4))
                check = refusal_of_common(d, item)
                if check is None:
                    self.assertEqual(item["verdict"], true_common(d)[0]["verdict"], (d, item))
                count[check] = count.get(check, 0) + 1
        for check in (None, "F", "D1", "D2", "D3"):
            self.assertGreater(count.get(check, 0), 15, count)

    # Of all lists of up to four arcs one is accepted, but for equal discs and where it begins: the one of which the
    # circles are nearest in their directions from the point.
    def test_one_list_of_arcs_is_accepted(self):
        rng, count, sizes = random.Random(12), {}, {}
        for _ in range(250):
            discs = self.some(rng)[:3]
            items = [item for item in true_common(discs) if item["verdict"] == "region"]
            if not items:
                continue
            found = set()
            for size in (1, 2, 3, 4):
                for arcs in itertools.product(range(len(discs)), repeat=size):
                    check = refusal_of_common(discs, {**items[0], "arcs": list(arcs)})
                    count[check] = count.get(check, 0) + 1
                    if check is None:
                        found.add(min(tuple(discs[a] for a in arcs[k:] + arcs[:k]) for k in range(size)))
            self.assertEqual(len(found), 1, (discs, items[0], found))
            bounds = found.pop()
            sizes[len(bounds)] = sizes.get(len(bounds), 0) + 1
            x, y = (float(Fraction(n)) for n in items[0]["point"])
            for k in range(100):
                dx, dy = math.cos(k), math.sin(k)

                def far(disc):
                    along = (disc[0] - x) * dx + (disc[1] - y) * dy
                    return along + math.sqrt(along ** 2 + disc[2] ** 2 - (disc[0] - x) ** 2 - (disc[1] - y) ** 2)
                self.assertLess(min(map(far, bounds)), min(map(far, discs)) + 1e-9, (discs, bounds))
        for check in (None, "B1", "B2", "B3", "B4"):
            self.assertGreater(count.get(check, 0), 4, count)
        self.assertGreater(min(sizes.get(n, 0) for n in (1, 2, 3)), 3, sizes)

    def test_files_and_the_check_that_each_fails(self):
        discs = [(0, 0, 2), (4, 0, 2), (2, 2, 2), (9, 0, 1)]
        point = {"question": "circles", "verdict": "point", "discs": [0, 1], "weights": ["1/2", "1/2"]}
        empty = {"question": "circles", "verdict": "empty", "discs": [0, 3], "weights": ["1", "2"]}
        region = {"question": "circles", "verdict": "region", "point": ["1", "1"]}

        def found(statement, change, discs=discs):
            return outcome(as_file("circles", discs, {**statement, **change}))

        self.assertEqual(found(point, {}, discs[:3]), "-")
        self.assertEqual(found(point, {}), "D3")
        self.assertEqual(found(point, {"weights": ["7", "7"]}, discs[:3]), "-")
        self.assertEqual(found(point, {"weights": ["1", "2"]}, discs[:3]), "D2")
        self.assertEqual(found(point, {"weights": ["-1", "2"]}, discs[:3]), "D1")
        self.assertEqual(found(point, {"weights": ["0", "0"]}, discs[:3]), "D1")
        self.assertEqual(found(point, {"discs": [], "weights": []}, discs[:3]), "D1")
        self.assertEqual(found(point, {"verdict": "empty"}, discs[:3]), "D2")
        self.assertEqual(found(empty, {}), "-")
        self.assertEqual(found(empty, {"weights": ["1", "99"]}), "D2")
        self.assertEqual(found(empty, {"verdict": "point"}), "D2")
        self.assertEqual(found(region, {}, [discs[0], discs[2]]), "-")
        self.assertEqual(found(region, {"point": ["2", "0"]}, [discs[0], discs[2]]), "D3")
        self.assertEqual(found(region, {}, discs[:2]), "D3")
        self.assertEqual(found(region, {"arcs": [0, 1]}, [discs[0], discs[2]]), "-")
        self.assertEqual(found(region, {"arcs": [0]}, [discs[0], discs[2]]), "B1")
        for arcs in ([], [0, 2], [0, -1], 0, ["0"], [0, 1] * 3):
            self.assertEqual(found(region, {"arcs": arcs}, [discs[0], discs[2]]), "F", arcs)
        self.assertEqual(found({"question": "circles", "verdict": "plane"}, {}, []), "-")
        self.assertEqual(found(region, {}, []), "F")
        for change in ({"verdict": "plane"}, {"verdict": "none"}, {"discs": [0, 4]}, {"discs": [0]}, {"weights": ["1"]},
                       {"discs": [0] * 17, "weights": ["1"] * 17}, {"weights": [1, 1]}, {"verdict": "region"}):
            self.assertEqual(found(point, change), "F", change)


if __name__ == "__main__":
    unittest.main()
