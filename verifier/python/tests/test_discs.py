#!/usr/bin/env python3
"""Tests of statements about discs that meet against brute force: python3 verifier/python/tests/test_discs.py."""
import itertools
import unittest
from decimal import Decimal
from fractions import Fraction

from files import (FORCED, MUTANT, Twins, dice_of, file_of, fraction, hexadecimal, lacking, main, some,
                   spoilt_in_statements)
from sunder_verify import reader, rules, tables

ALLOWED = ("nothing", "shared-endpoint", "touch")
KINDS = ("touching", "overlapping", "inside")


def kind_of(c, d):
    """By the distance itself: a square root, which is exact where it is a whole number."""
    apart = Decimal((c[0] - d[0]) ** 2 + (c[1] - d[1]) ** 2).sqrt()
    if apart > c[2] + d[2]:
        return None
    if apart == c[2] + d[2]:
        return "touching"
    return "inside" if apart <= abs(c[2] - d[2]) else "overlapping"


def contacts_of(discs, allowed, groups):
    return [[i, j, kind_of(discs[i], discs[j])] for i, j in itertools.combinations(range(len(discs)), 2)
            if kind_of(discs[i], discs[j]) and (allowed == "nothing" or kind_of(discs[i], discs[j]) != "touching")
            and (groups is None or groups[i] != groups[j])]


def some_discs(dice):
    size = dice.choice([2, 4, 8, 20])
    return [(dice.randint(0, size), dice.randint(0, size), dice.choice([0, 1, 1, 2, 3])) for _ in range(dice.randint(0, 7))]


def some_groups(discs, dice):
    return dice.choice([None, None, [dice.randint(-1, 1) for _ in discs], [7] * len(discs)])


def certificate(discs, allowed, groups, said):
    statement = {"question": "circles", "allowed": allowed, **said}
    if groups is not None:
        statement["groups"] = groups
    return file_of({"circles": [[hexadecimal(x) for x in disc] for disc in discs]}, statement)


def covers(discs, allowed, groups, dice):
    """What is true of them, as said by covers of any order."""
    order, contacts = list(range(len(discs))), contacts_of(discs, allowed, groups)
    dice.shuffle(order)
    claims = [{"claim": "cover", "order": order}]
    result = [{"verdict": "these", "contacts": contacts, "claims": claims},
              {"verdict": "count", "number": len(contacts), "claims": claims}]
    return result + ([] if contacts else [{"verdict": "none", "claims": claims}])


def some_of(discs, dice):
    """That two of them meet, which may be so; and whether it is."""
    groups, allowed = some_groups(discs, dice), dice.choice(ALLOWED)
    i, j = dice.randrange(len(discs)), dice.randrange(len(discs))
    (a, b, r), (c, d, s) = discs[i], discs[j]
    kind = kind_of(discs[i], discs[j]) if dice.random() < .8 else dice.choice(KINDS)
    along = Fraction(r, r + s) if r + s else 0
    point = dice.choice([(a + along * (c - a), b + along * (d - b))] * 5 + [(Fraction(a), Fraction(d)), (c + s, d)])
    holds = all((point[0] - x) ** 2 + (point[1] - y) ** 2 <= q * q for x, y, q in (discs[i], discs[j]))
    truth = holds and [*sorted((i, j)), kind] in contacts_of(discs, allowed, groups)
    said = {"verdict": "some", "i": i, "j": j, "kind": kind or "touching", "point": [fraction(x) for x in point]}
    return certificate(discs, allowed, groups, {**said, "claims": [{"claim": "contact"}]}), truth


def is_true(top):
    """Of a file that a checker accepted, its table as it was made."""
    (statement,), discs = top["statements"], [tuple(int(x.split("p")[0], 16) for x in row) for row in top["tables"]["circles"]]
    contacts = contacts_of(discs, statement["allowed"], statement.get("groups"))
    if statement["verdict"] == "some":
        return [*sorted((statement["i"], statement["j"])), statement["kind"]] in contacts
    return contacts == statement["contacts"] if "contacts" in statement else len(contacts) == statement.get("number", 0)


class DiscsTest(unittest.TestCase):
    def test_what_is_true_is_accepted_and_nothing_else(self):
        dice, twins = dice_of(31), Twins(self)
        while twins.count < some(2000):
            discs = some_discs(dice)
            groups = some_groups(discs, dice)
            for allowed in ALLOWED:
                for said in covers(discs, allowed, groups, dice):
                    self.assertEqual(twins.look(certificate(discs, allowed, groups, said)), "accepted", twins.last)
                    for forced in (dice.choice(ALLOWED), groups), (allowed, some_groups(discs, dice)):
                        top = certificate(discs, *forced, said)
                        self.assertEqual(twins.look(top), "accepted" if is_true(top) else "cover", top)
        twins.compare()
        self.assertTrue(some(100) < 100 or min(twins.tally().values()) > twins.count / 20)

    def test_a_contact_is_accepted_where_it_counts_and_is_as_stated(self):
        dice, twins = dice_of(32), Twins(self)
        while "some" in lacking(FORCED, "circles"):
            discs = some_discs(dice)
            if len(discs) > 1:
                top, truth = some_of(discs, dice)
                self.assertEqual(twins.force(top), "accepted" if truth else "contact", top)
        twins.compare()
        self.assertTrue(some(100) < 100 or min(twins.tally().values()) > twins.count / 20)

    def test_no_forced_certificate_proves_what_is_not_so(self):
        """What is true with changes; and covers, of which there is one for each order, of what is not so."""
        dice, twins, accepted = dice_of(33), Twins(self), 0
        while set(lacking(FORCED, "circles")) - {"some"}:
            discs = some_discs(dice)
            groups, allowed = some_groups(discs, dice), dice.choice(ALLOWED)
            said = covers(discs, allowed, groups, dice)
            forced = [spoilt_in_statements(certificate(discs, allowed, groups, one), dice) for one in said * 2]
            contacts = [c for c in said[0]["contacts"] if dice.random() < .8]
            for more in ({"verdict": "none"}, {"verdict": "count", "number": len(contacts)},
                         {"verdict": "these", "contacts": contacts}):
                forced.append(certificate(discs, allowed, groups, {**more, "claims": said[0]["claims"]}))
            for top in forced:
                if twins.force(top) == "accepted":
                    self.assertTrue(is_true(top), top)
                    accepted += 1
        twins.compare()
        self.assertTrue(some(100) < 100 or accepted > twins.count / 50)  # another order, another rule

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(34), Twins(self)
        while lacking(MUTANT, "circles"):
            discs = some_discs(dice)
            groups, allowed = some_groups(discs, dice), dice.choice(ALLOWED)
            for said in covers(discs, allowed, groups, dice):
                twins.spoil(certificate(discs, allowed, groups, said), dice)
            if len(discs) > 1:
                twins.spoil(some_of(discs, dice)[0], dice)
        twins.compare()

    def test_how_much_is_looked_at(self):
        """Nodes that are apart, and nodes of one group, are not gone into."""
        def looks(discs, order, groups=range(1024)):
            steps = reader.Steps(0)
            table = tables.TABLES["circles"]([[hexadecimal(x) for x in disc] for disc in discs], "circles")
            most = steps.left
            for _ in rules.contacts_by_cover(steps, order, table, groups, ()):
                pass
            return (most - steps.left) // 17  # one look is 16 and 1 steps
        row, one_place, order = [(3 * k, 0, 1) for k in range(1024)], [(0, 0, 1)] * 1024, list(range(1024))
        self.assertLess(looks(row, order), 5 * 1024)
        self.assertGreater(looks(row, [k * 509 % 1024 for k in order]), 100 * 1024)
        self.assertEqual(looks(one_place, order, [0] * 1024), 1)
        self.assertEqual(looks(one_place, order, [k // 512 for k in order]), 3 + 2 * 512 ** 2 - 1)
        self.assertEqual(looks([], []), 0)


if __name__ == "__main__":
    main()
