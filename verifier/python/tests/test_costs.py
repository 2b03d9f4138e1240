#!/usr/bin/env python3
"""Tests that checking stays linear: the calls that the Python checker makes, counted, of files of two sizes."""
import json
import sys
import unittest

from files import PROGRAM, file_of, told_by_twin

import sunder_verify  # noqa: E402
from sunder_verify import questions, tables  # noqa: E402

ORIGIN = ["0x0p0", "0x0p0"]
FLAT = {"linear": ["0x0p0"] * 4, "translation": ORIGIN}


def statement(question, verdict, *claims, **said):
    return {"question": question, **said, "verdict": verdict, "claims": list(claims)}


def apart():
    return statement("pair", "apart", {"claim": "parted", "direction": ["0", "0"]}, a=0, b=0)


def images_of_a_body(n):
    """Each image must not look at all points of the body again."""
    images = [{"name": "a", "of": 0, **FLAT}] * n
    return file_of({"bodies": [{"name": "a", "points": [ORIGIN] * n}, *images]}, apart())


def images_of_a_polytope(n):
    images = [{"name": "a", "of": 0, **FLAT}] * n
    body = {"name": "a", "dimension": 2, "points": [ORIGIN] * n}
    return file_of({"polytopes": [body, *images]}, statement(
        "polytopes", "apart", {"claim": "parted_by", "direction": ["0", "0"], "of_a": [], "of_b": []}, a=0, b=0))


def homes_in_facets(n):
    """Each point must not count the simplices of all facets again."""
    return file_of({"bodies": [{"name": "a", "points": [ORIGIN] * n}]}, statement(
        "polytope_hull", "facets", {"claim": "boundary", "simplices": [0] * n}, body=0, facets=[[[0, 1]]] * n))


def star(n, verdict, allowed="nothing", groups=None, line=0, **said):
    """Segments from one point, and others on one line through it."""
    rows = [["-0x1p0", "0x0p0", "0x1p0", "0x0p0"]] * line + [["0x0p0", "0x0p0", "0x1p0", "0x%xp0" % k] for k in range(1, n)]
    size = len(rows)
    first = [[0, -1, *range(line)]] if line else []
    events = first + [[2 * line, -1, *range(size)]] + [[2 * k + 1, -1] for k in range(line, size)]
    if line:  # the horizontal ones end below the others, at the same abscissa
        events = first + [[2 * line, -1, *range(size)], [1, -1]] + [[2 * k + 1, -1] for k in range(line, size)]
    claim = {"none": "none_counts", "these": "these_count", "count": "number_counts"}[verdict]
    more = {} if groups is None else {"groups": [groups(k) for k in range(size)]}
    return file_of({"segments": rows}, statement("segments", verdict, {"claim": claim, "events": events},
                                                 allowed=allowed, **more, **said))


def vertex(x, y):
    return [("-" if c < 0 else "") + "0x%xp0" % abs(c) for c in (x, y)]


def of_rings(rings, *verdicts):
    """Statements `valid` about one polygon: of each its verdict, ring and point."""
    return file_of({"polygons": [[[vertex(*p) for p in ring] for ring in rings]]}, *[
        statement("valid", verdict, {"claim": verdict}, parts=[0], rule="valid", ring=ring, point=list(map(str, point)))
        for verdict, ring, point in verdicts])


def nested_holes(n):
    """Each hole is in all those before it: two of them are enough."""
    squares = [[(-k, -k), (-k, k), (k, k), (k, -k)] for k in range(n + 1, 0, -1)]
    return of_rings(squares, *[("misplaced", k, (0, k - n - 1)) for k in range(2, n + 1)])


def spikes(n):
    """A ring that comes to many points twice: each statement looks at what is near, and at blocks of the ring."""
    ring = [p for k in range(n) for p in ((3 * k, 0), (3 * k + 1, 0), (3 * k + 1, 1), (3 * k + 1, 0), (3 * k + 2, 0))]
    return of_rings([ring + [(3 * n, -1), (0, -1)]], *[("comes_twice", 0, (3 * k + 1, 0)) for k in range(n)])


def names(n):
    body = {"name": "\U0001f600" * 4000, "points": [ORIGIN]}
    meet = statement("pair", "meet", *[{"claim": "holds", "weights": [[0, "1"]]}] * 2, a=0, b=0, point=["0", "0"])
    return file_of({"bodies": [body]}, *[meet] * n)


FAMILIES = {
    "images of a body": (images_of_a_body, 120),
    "images of a polytope": (images_of_a_polytope, 120),
    "homes in facets": (homes_in_facets, 120),
    "a star": (lambda n: star(n, "count", number=(n - 1) * (n - 2) // 2), 120),
    "a star that shares endpoints": (lambda n: star(n, "none", "shared-endpoint"), 120),
    "a star that touches": (lambda n: star(n, "none", "touch"), 120),
    "a star of two groups": (lambda n: star(n, "count", groups=lambda k: int(k == 0), number=n - 2), 120),
    "a star of two groups, listed": (
        lambda n: star(n, "these", groups=lambda k: int(k == 0), contacts=[[0, k, "shared-endpoint"] for k in range(1, n - 1)]), 120),
    "nested holes": (nested_holes, 120),
    "a ring with spikes": (spikes, 120),
    "a bundle that is crossed": (
        lambda n: star(3, "count", groups=lambda k: int(k >= n), line=n, number=2 * n), 120),
}


def count_of(make, n):
    """The outcome, and how many calls the checker makes, of Python's functions and of len."""
    text, calls = json.dumps(make(n)).encode(), [0]

    def count(frame, event, argument):
        calls[0] += event in ("call", "c_call")

    def counted_len(items):
        calls[0] += 1
        return len(items)

    for module in (questions, tables):
        module.len = counted_len
    sys.setprofile(count)
    try:
        report = sunder_verify.verify(text, True)
    finally:
        sys.setprofile(None)
        for module in (questions, tables):
            del module.len
    return [refusal and refusal[0] for _, refusal in report.statements], calls[0]


class Costs(unittest.TestCase):
    def test_twice_the_file_is_twice_the_work(self):
        accepted = 0
        for what, (make, n) in FAMILIES.items():
            (told, calls), (told_twice, calls_twice) = count_of(make, n), count_of(make, 2 * n)
            with self.subTest(what=what):
                self.assertEqual(set(told), set(told_twice))
                self.assertLess(calls_twice, 2.2 * calls, (calls, calls_twice))
            accepted += set(told) == {None}
        self.assertGreaterEqual(accepted, 7)

    def test_contacts_are_counted_as_they_are_listed(self):
        """Of stars in classes and groups: the number is that of the list, found by brute force."""
        for allowed in ("nothing", "shared-endpoint", "touch"):
            for line, n, groups in ((0, 9, 3), (3, 6, 2), (4, 2, 5), (5, 4, 100)):
                size = line + n - 1
                contacts = []
                for i in range(size):
                    for j in range(i + 1, size):
                        kind = "overlap" if j < line else "touch" if i < line else "shared-endpoint"
                        counts = kind == "overlap" or allowed == "nothing" or (kind == "touch" and allowed != "touch")
                        if i % groups != j % groups and counts:
                            contacts.append([i, j, kind])
                told = [star(n, "these", allowed, lambda k: k % groups, line, contacts=contacts),
                        star(n, "count", allowed, lambda k: k % groups, line, number=len(contacts)),
                        star(n, "count", allowed, lambda k: k % groups, line, number=len(contacts) + 1)]
                wanted = [None, None, "number_counts"]
                if contacts:
                    told.append(star(n, "these", allowed, lambda k: k % groups, line, contacts=contacts[1:]))
                    wanted.append("these_count")
                for top, rule in zip(told, wanted):
                    with self.subTest(allowed=allowed, line=line, n=n):
                        report = sunder_verify.verify(json.dumps(top).encode(), True)
                        self.assertEqual([refusal and refusal[0] for _, refusal in report.statements], [rule])
                if PROGRAM:
                    self.assertEqual([rule for rule, _ in told_by_twin([json.dumps(top) for top in told])],
                                     [rule or "accepted" for rule in wanted])

    def test_names_are_cut_and_quoted(self):
        text = json.dumps(names(3))
        report = sunder_verify.verify(text.encode(), True)
        said = '"' + "\\ud83d\\ude00" * 100 + '"...'
        said = "the convex hull of the 1 point of " + said
        self.assertEqual([sentence for sentence, _ in report.statements], ["%s and %s meet at (0, 0)" % (said, said)] * 3)
        sneaky = json.dumps(names(1)).replace("\\ud83d\\ude00" * 4000, "a\\u202eb\\u001b\\u0085\\\"\\u007f")
        (sentence, _), = sunder_verify.verify(sneaky.encode()).statements
        self.assertIn('"a\\u202eb\\u001b\\u0085\\"\\u007f"', sentence)
        if PROGRAM:
            (_, proved), (_, others) = told_by_twin([text, sneaky])
            self.assertEqual((proved, others), ([said_ for said_, _ in report.statements], [sentence]))

    def test_reasons_quote_names(self):
        top = file_of({"bodies": [{"name": "a\u202e" + "n" * 200, "points": [ORIGIN]}]}, apart())
        (_, (rule, reason)), = sunder_verify.verify(json.dumps(top).encode()).statements
        self.assertEqual(rule, "parted")
        self.assertIn('"a\\u202e' + "n" * 98 + '"... is not strictly less far', reason)


if __name__ == "__main__":
    unittest.main()
