#!/usr/bin/env python3
"""Tests of sunder_verify_segments.py: python3 verifier/test_sunder_verify_segments.py."""
import itertools
import json
import os
import random
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import sunder_verify  # noqa: E402
import sunder_verify_segments as checker  # noqa: E402
from segment_sweeps import (  # noqa: E402
    all_transcripts, crossing_by_fractions, is_free, kind_by_fractions, mutate, RULES, some_groups, some_set, sweep)


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
            while at < len(line) and checker.is_above(segments[s], segments[line[at]], False):
                at += 1
            below.append(line[at - 1] if at else -1)
            line.insert(at, s)
    return events, below


def refusal_of(segments, groups, allowed, events, below, exchanges):
    """The check that fails, or None. Without groups, where these are None."""
    own = range(len(segments))
    try:
        checker.check_none(segments, own if groups is None else groups, allowed, events, below, exchanges,
                           groups is not None)
    except sunder_verify.Refused as error:
        return error.args[0]
    return None


def accepted(segments, allowed, events, below):
    return refusal_of(segments, None, allowed, events, below, []) is None


def as_file(segments, statement, groups=None):
    text = [["%s0x%xp+0" % ("-" if x < 0 else "", abs(x)) for point in segment for x in point] for segment in segments]
    top = {"sunder_set_certificate": 1, "segments": text, "statements": [statement]}
    return json.dumps(top if groups is None else {**top, "groups": groups}).encode()


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


class Groups(unittest.TestCase):
    def test_a_transcript_is_accepted_if_and_only_if_nothing_counts(self):
        rng = random.Random(5)
        count, most, refused = {}, 0, {}
        for _ in range(12000):
            segments, groups, allowed = some_groups(rng)
            free = is_free(segments, groups, allowed)
            events, below, exchanges = sweep(rng, segments, groups)
            check = refusal_of(segments, groups, allowed, events, below, exchanges)
            self.assertEqual(check is None, free, (segments, groups, allowed, check))
            overlaps = any(groups[i] == groups[j] and checker.kind_of(segments[i], segments[j]) == "overlap"
                           for i, j in itertools.combinations(range(len(segments)), 2))
            key = allowed, len(set(groups)) > 1, free
            seen = count.setdefault(key, [0, 0, 0])
            for k, is_so in enumerate((True, len(exchanges) > 0, overlaps)):
                seen[k] += is_so
            most = max(most, len(exchanges) if free else 0)
            refused[check] = refused.get(check, 0) + 1
        for allowed in RULES:
            for several, free in ((False, True), (True, True), (True, False)):
                for k in range(3):
                    self.assertGreater(count[allowed, several, free][k], 40, (allowed, several, free, count))
        self.assertGreater(most, 8)
        for check, least in (("T1", 100), ("T4", 100), ("T6", 10)):
            self.assertGreater(refused.get(check, 0), least, refused)

    def test_without_groups_and_each_its_own_are_one(self):
        rng = random.Random(6)
        for _ in range(3000):
            segments, allowed = some_set(rng), rng.choice(RULES)
            events, below = transcript(segments)
            own = list(range(len(segments)))
            self.assertEqual(accepted(segments, allowed, events, below),
                             refusal_of(segments, own, allowed, events, below, []) is None, (segments, allowed))

    def test_no_mutated_transcript_proves_what_is_not_true(self):
        rng = random.Random(7)
        count = {}
        for _ in range(14000):
            segments, groups, allowed = some_groups(rng)
            evidence = sweep(rng, segments, groups)
            what = [mutate(rng, segments, groups, *evidence) for _ in range(rng.choice((1, 1, 2)))]
            free = is_free(segments, groups, allowed)
            check = refusal_of(segments, groups, allowed, *evidence)
            if not free:
                self.assertIsNotNone(check, (segments, groups, allowed, evidence))
            if len(what) == 1:
                key = what[0], free, check is None
                count[key] = count.get(key, 0) + 1
        for what in ("drop", "move", "turn", "repeat", "group", "event", "below", "other"):
            self.assertGreater(count[what, False, False], 15, count)
            self.assertGreater(count[what, True, False] + count.get((what, True, True), 0), 100, count)
        for what in ("drop", "turn", "other"):  # each pair is exchanged exactly once
            self.assertLess(count.get((what, True, True), 0), 0.2 * count[what, True, False], count)

    def test_no_transcript_at_all_proves_what_is_not_true(self):
        rng = random.Random(8)
        sets = tried = exchanged = 0
        while sets < 1200:
            segments, groups, allowed = some_groups(rng)
            if len(segments) > 5 or len(set(groups)) == len(groups):
                continue
            free = is_free(segments, groups, allowed)
            if free and rng.randrange(4):
                continue
            found = 0
            for evidence in all_transcripts(segments, groups, 400):
                is_accepted = refusal_of(segments, groups, allowed, *evidence) is None
                self.assertFalse(is_accepted and not free, (segments, groups, allowed, evidence))
                found += is_accepted
                tried += 1
                exchanged += len(evidence[2]) > 0
            sets += 1
        self.assertGreater(tried, 20000)
        self.assertGreater(exchanged, 4000)

    def test_files_and_the_check_that_each_fails(self):
        # A cross of one group, whose arms are met by a segment that ends on one, and one of another group above it.
        segments = [((0, 0), (4, 4)), ((0, 4), (4, 0)), ((0, 6), (9, 6)), ((3, 3), (5, 2))]
        groups = [7, 7, -3, 7]
        none = {"question": "segments_any", "allowed": "nothing", "verdict": "none",
                "events": [0, 2, 4, -1, 6, 3, 1, 7, 5], "below": [-1, 0, 1, 1], "exchanges": [[0, 1]]}

        def found(changes, groups=groups, segments=segments):
            return outcome(as_file(segments, {key: value for key, value in {**none, **changes}.items()
                                              if value is not None}, groups))

        self.assertEqual(found({}), "-")
        self.assertEqual(found({"allowed": "touch"}), "-")
        self.assertEqual(found({}, [7, 7, 0, 8]), "T4")
        self.assertEqual(found({"allowed": "touch"}, [7, 7, 0, 8]), "-")
        self.assertEqual(found({}, [7, 8, 0, 7]), "T5")
        # Places: too late, or too soon.
        self.assertEqual(found({"events": [0, 2, 4, 6, -1, 3, 1, 7, 5]}), "T1")
        self.assertEqual(found({"events": [0, -1, 2, 4, 6, 3, 1, 7, 5]}), "T1")
        # At one point: what ends, the exchange, points, what begins.
        star = segments[:2] + [((0, 2), (2, 2)), ((2, 2), (2, 2)), ((2, 2), (5, 2))]
        ray = {"events": [0, 4, 2, 5, -1, 6, 7, 8, 3, 1, 9], "below": [-1, 0, 2, 0, 1]}
        self.assertEqual(found(ray, [1] * 5, star), "-")
        for events in ([0, 4, 2, -1, 5, 6, 7, 8, 3, 1, 9], [0, 4, 2, 5, 6, 7, -1, 8, 3, 1, 9],
                       [0, 4, 2, 5, 6, -1, 7, 8, 3, 1, 9], [0, 4, 2, 5, -1, 8, 6, 7, 3, 1, 9]):
            self.assertEqual(found({**ray, "events": events}, [1] * 5, star), "T1", events)
        # Pairs that are not neighbours, not in this order, do not cross, are one segment, are not exchanged.
        self.assertEqual(found({"exchanges": [[1, 0]]}), "T5")
        self.assertEqual(found({"exchanges": [[0, 3]]}), "T5")
        self.assertEqual(found({"exchanges": [[0, 0]]}), "T5")
        self.assertEqual(found({"events": [0, 2, 4, 6, 3, 1, 7, 5], "exchanges": None}), "T5")
        # The form.
        for groups_of_wrong_form in ([7, 7, 0], [7, 7, 0, 7, 7], [7, 7, 0, "7"], [7, 7, 0, 7.0], [7, 7, 0, True], 7,
                                     [7, 7, 0, 10 ** 15], [7, 7, 0, -10 ** 15], [7, 7, 0, 10 ** 30], {}, [[7]] * 4):
            self.assertEqual(found({}, groups_of_wrong_form), "F", groups_of_wrong_form)
        self.assertEqual(found({}, [10 ** 15 - 1, 10 ** 15 - 1, 1 - 10 ** 15, 10 ** 15 - 1]), "-")
        for exchanges in (None, [], [[0, 1], [0, 1]], [[0]], [[0, 1, 2]], [0], [[0, 4]], [[-1, 1]], [[0, "1"]], "", {}):
            self.assertEqual(found({"exchanges": exchanges}), "F", exchanges)
        self.assertEqual(found({}, None), "F")
        self.assertEqual(found({"events": [0, 2, 4, 6, 3, 1, 7, 5]}, None), "F")
        self.assertEqual(found({"exchanges": None}, None), "F")
        self.assertEqual(found({"events": [0, 2, 4, -2, 6, 3, 1, 7, 5]}), "F")
        # An end of another group on the inside of one, behind one of its own group: neighbours alone do not tell.
        hub = [((0, 0), (4, 4)), ((0, 2), (2, 2)), ((0, 3), (2, 2))]
        behind = {"events": [0, 2, 4, 3, 5, 1], "below": [-1, 0, 1], "exchanges": None, "allowed": "shared-endpoint"}
        self.assertEqual(found(behind, [1, 1, 1], hub), "-")
        self.assertEqual(found(behind, [1, 1, 2], hub), "T4")
        self.assertEqual(found({**behind, "events": [0, 2, 4, 5, 3, 1]}, [1, 1, 2], hub), "T6")
        self.assertEqual(found({**behind, "allowed": "nothing"}, [1, 1, 2], hub), "T1")
        # Contacts within a group do not count.
        some = {"question": "segments_any", "allowed": "nothing", "verdict": "some", "i": 0, "j": 1, "kind": "crossing",
                "point": ["2", "2"]}
        self.assertEqual(outcome(as_file(segments, some, groups)), "C1")
        self.assertEqual(outcome(as_file(segments, some, [1, 2, 3, 4])), "-")


@unittest.skipUnless("SUNDER_PROGRAM" in os.environ, "SUNDER_PROGRAM does not name the program")
class Twins(unittest.TestCase):
    def count_agreed(self, tops):
        """How often each check refuses files, and "-" a statement is accepted. The twins must agree about all."""
        count = {}
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for k, top in enumerate(tops):
                files.append(os.path.join(folder, "%d.json" % k))
                with open(files[-1], "w") as stream:
                    json.dump(top, stream)
            done = subprocess.run([os.environ["SUNDER_PROGRAM"], "verify", "--json"] + files, capture_output=True)
            self.assertEqual(done.returncode, 1, done.stderr)
            reports = json.loads(done.stdout)["objects"]
            self.assertEqual(len(reports), len(files))
            for file, report in zip(files, reports):
                found = [(r.get("pair"), r["check"]) for r in report["refused"]]
                with open(file, "rb") as stream:
                    data = stream.read()
                try:
                    expected = [(r[0], r[4][0]) for r in sunder_verify.verify(data) if r[4]]
                except sunder_verify.Refused as error:
                    expected = [(None, error.args[0])]
                self.assertEqual(found, expected, data)
                for _, check in expected:
                    count[check] = count.get(check, 0) + 1
                count["-"] = count.get("-", 0) + report.get("none", 0) + report.get("some", 0)
        return count

    @staticmethod
    def some_contact(rng, segments, allowed):
        """A statement that two segments meet, often a wrong one."""
        i, j = rng.sample(range(len(segments)), 2)
        kind = checker.kind_of(segments[i], segments[j]) or "crossing"
        point = crossing_by_fractions(segments[i], segments[j]) or max(segments[i][0], segments[j][0])
        mutated = rng.randrange(3)
        if mutated == 0:
            kind = rng.choice(checker.KINDS)
        if mutated == 1:
            point = ["%d/%d" % (rng.randint(0, 20), rng.randint(1, 4)) for _ in range(2)]
        return {"question": "segments_any", "allowed": allowed, "verdict": "some", "i": i, "j": j, "kind": kind,
                "point": [str(x) for x in point]}

    def test_the_twins_agree(self):
        rng, tops = random.Random(4), []
        for _ in range(250):
            segments, statements = some_set(rng), []
            events, below = transcript(segments)
            for _ in range(6):
                allowed, mutated = rng.choice(RULES), rng.randrange(3)
                if rng.randrange(3) and len(segments) > 1:
                    statements.append(self.some_contact(rng, segments, allowed))
                    continue
                order, lower = events[:], below[:]
                if mutated == 0:
                    lower[rng.randrange(len(lower))] = rng.randint(-1, len(segments) - 1)
                if mutated == 1:
                    i, j = rng.randrange(len(order)), rng.randrange(len(order))
                    order[i], order[j] = order[j], order[i]
                if mutated == 2 and not rng.randrange(8):
                    order[0] = order[-1]
                statements.append({"question": "segments_any", "allowed": allowed, "verdict": "none", "events": order,
                                   "below": lower})
            tops.append({**json.loads(as_file(segments, None)), "statements": statements})
            if not rng.randrange(12):
                del statements[0][rng.choice(sorted(statements[0]))]
        count = self.count_agreed(tops)
        for check in ("-", "F", "C1", "C2", "C3", "T1", "T2", "T3", "T4"):
            self.assertGreaterEqual(count.get(check, 0), 5, (check, count))

    def test_the_twins_agree_about_groups(self):
        rng, tops = random.Random(9), []
        for _ in range(2000):
            segments, groups, allowed = some_groups(rng)
            statements = []
            for _ in range(4):
                if not rng.randrange(6) and len(segments) > 1:
                    statements.append(self.some_contact(rng, segments, rng.choice(RULES)))
                    continue
                events, below, exchanges = sweep(rng, segments, groups)
                for _ in range(rng.choice((0, 1, 1, 3))):
                    mutate(rng, segments, groups, events, below, exchanges)
                statements.append({"question": "segments_any", "allowed": rng.choice((allowed, rng.choice(RULES))),
                                   "verdict": "none", "events": events, "below": below})
                if exchanges or rng.randrange(2):
                    statements[-1]["exchanges"] = exchanges
            tops.append({**json.loads(as_file(segments, None, groups)), "statements": statements})
            if not rng.randrange(12):
                what = rng.randrange(6)
                if what == 0:
                    del tops[-1]["groups"]
                elif what == 1:
                    groups = groups + [1]
                elif what == 2:
                    groups = groups[1:] + [rng.choice((1.0, None, "1", True, 10 ** 15, -10 ** 15, 10 ** 18, 10 ** 19,
                                                       -10 ** 18, 10 ** 40, [1], 10 ** 15 - 1, 1 - 10 ** 15, -0.0))]
                elif what == 3:
                    statements[0]["exchanges"] = rng.choice(([], {}, [[0]], [[0, len(segments)]], [0], [[0, -1]], "01"))
                elif what == 4 and "events" in statements[0]:
                    statements[0]["events"].insert(1, rng.choice((-1, -2, -1.0, None, False)))
                else:
                    del statements[0][rng.choice(sorted(statements[0]))]
                if "groups" in tops[-1]:
                    tops[-1]["groups"] = groups
        count = self.count_agreed(tops)
        for check, least in (("-", 800), ("F", 40), ("C1", 40), ("C2", 40), ("C3", 10), ("T1", 200), ("T2", 40),
                             ("T3", 40), ("T4", 200), ("T5", 40), ("T6", 3)):
            self.assertGreaterEqual(count.get(check, 0), least, (check, count))


if __name__ == "__main__":
    unittest.main()
