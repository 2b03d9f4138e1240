#!/usr/bin/env python3
"""Tests of sunder_verify_segments.py: python3 verifier/test_sunder_verify_segments.py."""
import json
import os
import random
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import sunder_verify  # noqa: E402
import sunder_verify_segments as checker  # noqa: E402

RULES = ("nothing", "shared-endpoint", "touch")


def kind_by_fractions(s, t):
    """The kind of contact another way: by the parameters of the common point, or of the common part."""
    (ax, ay), (bx, by) = s
    (cx, cy), (dx, dy) = t
    ux, uy, vx, vy, wx, wy = bx - ax, by - ay, dx - cx, dy - cy, cx - ax, cy - ay
    across = ux * vy - uy * vx
    if across:
        p, q = Fraction(wx * vy - wy * vx, across), Fraction(wx * uy - wy * ux, across)
        if not (0 <= p <= 1 and 0 <= q <= 1):
            return None
        ends = (p in (0, 1)) + (q in (0, 1))
        return ("crossing", "touch", "shared-endpoint")[ends]
    if (ux, uy) == (0, 0):
        s, t = t, s
        (ax, ay), (bx, by) = s
        (cx, cy), (dx, dy) = t
        ux, uy = bx - ax, by - ay
    if (ux, uy) == (0, 0):
        return "shared-endpoint" if s == t else None
    if ux * (cy - ay) != uy * (cx - ax):
        return None
    length2 = ux * ux + uy * uy
    p, q = sorted(Fraction(ux * (x - ax) + uy * (y - ay), length2) for x, y in t)
    if q < 0 or p > 1:
        return None
    if p == q:
        return "shared-endpoint" if p in (0, 1) else "touch"
    return "shared-endpoint" if q == 0 or p == 1 else "overlap"


def some_set(rng):
    """Small sets on small grids: every degeneracy is common, and none meet often enough."""
    side, short = rng.choice((3, 5, 9)), rng.choice((1, 2, 9))
    segments = []
    for _ in range(rng.randint(1, 6)):
        x, y = rng.randint(0, side), rng.randint(0, side)
        ends = [(x, y), (x + rng.randint(-short, short), y + rng.randint(-short, short))]
        segments.append(tuple(sorted(ends)))
    return segments


def transcript(segments):
    """The sweep, without looking for contacts: wrong where segments meet in a way that it does not expect."""
    def place(event):
        a, b = segments[event // 2]
        return (a, 1, event) if a == b else (b, 0, event) if event % 2 else (a, 2, event)

    events = sorted(range(2 * len(segments)), key=place)
    line, below = [], []
    for event in events:
        s = event // 2
        if event % 2:
            line.remove(s)
        else:
            at = 0
            while at < len(line) and checker.is_above(segments[s], segments[line[at]]):
                at += 1
            below.append(line[at - 1] if at else -1)
            line.insert(at, s)
    return events, below


def accepted(segments, allowed, events, below):
    try:
        checker.check_none(segments, allowed, events, below)
    except sunder_verify.Refused:
        return False
    return True


def as_file(segments, statement):
    text = [["%s0x%xp+0" % ("-" if x < 0 else "", abs(x)) for point in segment for x in point] for segment in segments]
    return json.dumps({"sunder_set_certificate": 1, "segments": text, "statements": [statement]}).encode()


def outcome(data):
    try:
        refusals = [result[4] for result in sunder_verify.verify(data)]
    except sunder_verify.Refused as error:
        return error.args[0]
    return next((refusal[0] for refusal in refusals if refusal), "-")


class Segments(unittest.TestCase):
    def test_kinds_against_fractions(self):
        rng = random.Random(1)
        seen = {}
        for _ in range(20000):
            s, t = (tuple(sorted((rng.randint(0, 4), rng.randint(0, 4)) for _ in range(2))) for _ in range(2))
            kind = checker.kind_of(s, t)
            self.assertEqual(kind, kind_by_fractions(s, t), (s, t))
            self.assertEqual(kind, checker.kind_of(t, s))
            seen[kind] = seen.get(kind, 0) + 1
        for kind in (None,) + checker.KINDS:
            self.assertGreater(seen[kind], 200)

    def test_a_transcript_is_accepted_if_and_only_if_nothing_counts(self):
        rng = random.Random(2)
        count = {}
        for _ in range(12000):
            segments, allowed = some_set(rng), rng.choice(RULES)
            truth = not any(kind_by_fractions(s, t) not in (None,) + checker.ALLOWED[allowed]
                            for i, s in enumerate(segments) for t in segments[:i])
            self.assertEqual(accepted(segments, allowed, *transcript(segments)), truth, (segments, allowed))
            count[allowed, truth] = count.get((allowed, truth), 0) + 1
        for allowed in RULES:
            for truth in (True, False):
                self.assertGreater(count[allowed, truth], 400, (allowed, truth))

    def test_no_transcript_at_all_proves_what_is_not_true(self):
        rng = random.Random(3)
        tried = 0
        for _ in range(20000):
            segments, allowed = some_set(rng), rng.choice(RULES)
            if not any(kind_by_fractions(s, t) not in (None,) + checker.ALLOWED[allowed]
                       for i, s in enumerate(segments) for t in segments[:i]):
                continue
            events, below = transcript(segments)
            for _ in range(rng.randint(1, 3)):
                what = rng.randrange(3)
                if what == 0:
                    below[rng.randrange(len(below))] = rng.randint(-1, len(segments) - 1)
                elif what == 1:
                    i, j = rng.randrange(len(events)), rng.randrange(len(events))
                    events[i], events[j] = events[j], events[i]
                else:
                    i = rng.randrange(len(events) - 1)
                    events[i], events[i + 1] = events[i + 1], events[i]
            tried += 1
            self.assertFalse(accepted(segments, allowed, events, below), (segments, allowed, events, below))
        self.assertGreater(tried, 5000)

    def test_files_and_the_check_that_each_fails(self):
        segments = [((0, 0), (4, 4)), ((0, 4), (4, 0)), ((5, 0), (6, 0))]
        some = {"question": "segments_any", "allowed": "nothing", "verdict": "some", "i": 0, "j": 1, "kind": "crossing",
                "point": ["2", "4/2"]}
        self.assertEqual(outcome(as_file(segments, some)), "-")
        self.assertEqual(outcome(as_file(segments, {**some, "point": ["2", "3"]})), "C2")
        self.assertEqual(outcome(as_file(segments, {**some, "point": ["-1", "-1"]})), "C2")
        self.assertEqual(outcome(as_file(segments, {**some, "kind": "touch"})), "C3")
        self.assertEqual(outcome(as_file(segments, {**some, "kind": "touch", "allowed": "touch"})), "C1")
        self.assertEqual(outcome(as_file(segments, {**some, "j": 0})), "F")
        self.assertEqual(outcome(as_file(segments, {**some, "allowed": "all"})), "F")
        self.assertEqual(outcome(as_file([((4, 4), (0, 0))] + segments[1:], some)), "F")
        # Thirds of large numbers: the common point is no double.
        large = [((0, 0), (3 << 60, 1)), ((0, 1), (3 << 60, -1))]
        point = [str(3 << 59), "1/2"]
        self.assertEqual(outcome(as_file(large, {**some, "point": point})), "C2")
        point = [str(1 << 60), "1/3"]
        self.assertEqual(outcome(as_file(large, {**some, "point": point})), "-")

        flat = [((0, 0), (9, 0)), ((1, 1), (3, 1)), ((2, 3), (8, 2))]
        none = {"question": "segments_any", "allowed": "nothing", "verdict": "none", "events": [0, 2, 4, 3, 5, 1],
                "below": [-1, 0, 1]}
        self.assertEqual(outcome(as_file(flat, none)), "-")
        self.assertEqual(outcome(as_file(flat, {**none, "events": [0, 2, 4, 5, 3, 1]})), "T1")
        self.assertEqual(outcome(as_file(flat, {**none, "events": [0, 2, 4, 3, 5, 5]})), "T1")
        self.assertEqual(outcome(as_file(flat, {**none, "below": [-1, 2, 1]})), "T2")
        self.assertEqual(outcome(as_file(flat, {**none, "below": [-1, -1, 1]})), "T3")
        self.assertEqual(outcome(as_file(flat, {**none, "below": [-1, 0, 0]})), "T3")
        self.assertEqual(outcome(as_file(flat, {**none, "below": [-1, 0]})), "F")
        crossed = [((0, 0), (9, 4)), flat[1], ((2, 3), (8, 2))]
        self.assertEqual(outcome(as_file(crossed, {**none, "below": [-1, 0, 1]})), "T4")


class Twins(unittest.TestCase):
    @unittest.skipUnless("SUNDER_PROGRAM" in os.environ, "SUNDER_PROGRAM does not name the program")
    def test_the_twins_agree(self):
        rng = random.Random(4)
        count = {}
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for k in range(250):
                segments, statements = some_set(rng), []
                events, below = transcript(segments)
                for _ in range(6):
                    allowed, mutated = rng.choice(RULES), rng.randrange(3)
                    if rng.randrange(3) and len(segments) > 1:
                        i, j = rng.sample(range(len(segments)), 2)
                        kind = checker.kind_of(segments[i], segments[j]) or "crossing"
                        point = list(max(segments[i][0], segments[j][0]))
                        if mutated == 0:
                            kind = rng.choice(checker.KINDS)
                        if mutated == 1:
                            point = ["%d/%d" % (rng.randint(0, 20), rng.randint(1, 4)) for _ in range(2)]
                        statements.append({"question": "segments_any", "allowed": allowed, "verdict": "some", "i": i,
                                           "j": j, "kind": kind, "point": [str(x) for x in point]})
                    else:
                        order, lower = events[:], below[:]
                        if mutated == 0:
                            lower[rng.randrange(len(lower))] = rng.randint(-1, len(segments) - 1)
                        if mutated == 1:
                            i, j = rng.randrange(len(order)), rng.randrange(len(order))
                            order[i], order[j] = order[j], order[i]
                        if mutated == 2 and not rng.randrange(8):
                            order[0] = order[-1]
                        statements.append({"question": "segments_any", "allowed": allowed, "verdict": "none",
                                           "events": order, "below": lower})
                data = json.loads(as_file(segments, None))
                data["statements"] = statements
                if not rng.randrange(12):
                    del data["statements"][0][rng.choice(sorted(statements[0]))]
                files.append(os.path.join(folder, "%d.json" % k))
                with open(files[-1], "w") as stream:
                    json.dump(data, stream)
            done = subprocess.run([os.environ["SUNDER_PROGRAM"], "verify", "--json"] + files, capture_output=True)
            self.assertEqual(done.returncode, 1, done.stderr)
            reports = json.loads(done.stdout)["objects"]
            self.assertEqual(len(reports), len(files))
            for file, report in zip(files, reports):
                found = [(r.get("pair"), r["check"]) for r in report["refused"]]
                try:
                    with open(file, "rb") as stream:
                        results = sunder_verify.verify(stream.read())
                    expected = [(r[0], r[4][0]) for r in results if r[4]]
                except sunder_verify.Refused as error:
                    expected = [(None, error.args[0])]
                self.assertEqual(found, expected, file)
                for _, check in expected:
                    count[check] = count.get(check, 0) + 1
                count["-"] = count.get("-", 0) + report.get("none", 0) + report.get("some", 0)
        for check in ("-", "F", "C1", "C2", "C3", "T1", "T2", "T3", "T4"):
            self.assertGreaterEqual(count.get(check, 0), 5, (check, count))


if __name__ == "__main__":
    unittest.main()
